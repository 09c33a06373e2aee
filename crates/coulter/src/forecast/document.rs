//! The forecast as one JSON document. Its names are a contract on which scripts rely.

use super::outlook::{Outlook, mechanism_word};
use super::predicted::PREDICTED;
use super::uncertainty::{InputDeviation, Interval, Intervals};
use analytic::Towing;
use analytic::disc::Drive;
use analytic::forecast::{Load, ModelForecast, Range, Strength};
use results::formats;
use results::history::quantities::key;
use serde_json::{Value, json};

/// The document of a forecast; `in_full` adds the full uncertainty analysis.
#[must_use]
pub fn document(outlook: &Outlook, intervals: &Intervals, in_full: bool) -> Value {
    let forecast = &outlook.forecast;
    let one = |m: &ModelForecast| {
        let mut entry = model(outlook, m);
        entry["interval"] = interval(intervals, m.name);
        entry
    };
    let other_strength: Vec<Value> =
        forecast.models_other_strength.iter().map(|m| model(outlook, m)).collect();
    let (full_friction, davis) = match forecast.strength {
        Strength::Full => (Vec::new(), other_strength),
        Strength::Davis => (other_strength, Vec::new()),
    };
    let spread = forecast.scatter.as_ref().map(|s| {
        json!({
            "count": s.count, "drag_N": range(&s.drag), "vertical_N": range(&s.vertical),
            "sinkage_m": s.sinkage.as_ref().map(range),
        })
    });
    let faces = forecast
        .side_faces
        .as_ref()
        .map(|f| json!({ "drag_N": f.drag, "vertical_N": f.vertical, "torque_Nm": f.torque }));
    let mut document = json!({
        "format": formats::DOCUMENT,
        "case": outlook.case,
        "kind": outlook.input.kind,
        "bodies": outlook.input.bodies,
        "groups": groups(outlook),
        "load": load(outlook),
        "drive": drive(&outlook.input.towing),
        "models": forecast.models.iter().map(one).collect::<Vec<_>>(),
        "strength": if forecast.strength == Strength::Full { "full" } else { "davis" },
        "models_full_friction": full_friction,
        "models_davis": davis,
        "operative_friction_angle_rad": forecast.operative_friction_angle,
        "spread": spread,
        "side_faces": faces,
        "recommended": outlook.recommended().map(|m| m.name),
        "recommendation": forecast.recommendation,
        "remarks": outlook.input.remarks,
        "interval_inputs": inputs(intervals),
    });
    if let Some(under_water) = &outlook.under_water {
        document["water"] = under_water.document(forecast);
    }
    if outlook.input.towing.body.disc().is_some() {
        document["discs"] = json!(outlook.input.bodies);
    }
    if in_full {
        document["uncertainty"] = json!({ "inputs": inputs(intervals), "quantities": intervals.list });
    }
    document
}

fn groups(outlook: &Outlook) -> Value {
    let g = &outlook.forecast.groups;
    json!({
        "Z": g.sinkage, "t_bar": g.thickness, "W_bar": g.weight, "E_bar": g.stiffness, "c_bar": g.cohesion,
        "F_H_bar": g.drag, "F_V_bar": g.vertical, "force_scale_N": outlook.force_scale(),
    })
}

fn load(outlook: &Outlook) -> Value {
    match outlook.input.towing.load {
        Load::Weight(weight) => json!({ "weight_N": weight }),
        Load::Sinkage(z) => json!({ "sinkage_m": z }),
    }
}

fn drive(towing: &Towing) -> Value {
    match towing.drive {
        _ if towing.pressed => json!({ "kind": "pressed" }),
        Drive::Free => json!({ "kind": "free" }),
        Drive::Locked => json!({ "kind": "locked" }),
        Drive::Braked(torque) => json!({ "kind": "braked", "torque_Nm": torque }),
        Drive::Driven(torque) => json!({ "kind": "driven", "torque_Nm": torque }),
        Drive::Slip(slip) => json!({ "kind": "slip", "slip": slip }),
    }
}

fn model(outlook: &Outlook, model: &ModelForecast) -> Value {
    let found = model.prediction;
    let mut entry = json!({
        "name": model.name,
        "applicable": model.applicable,
        "moment_Nm": outlook.moment(model),
        // ωr/v − 1 at any slip: an older name on which scripts rely.
        "skid": found.and_then(|p| p.slip).map(|slip| analytic::turn_ratio(slip) - 1.0),
        "mechanism": found.and_then(|p| p.mechanism).map(mechanism_word),
        "sideways_share": found.and_then(|p| p.sideways_fraction),
        "note": model.note,
    });
    // The torque is one of the moments.
    for quantity in PREDICTED.iter().filter(|quantity| quantity.name != "axle_torque") {
        entry[key(quantity.name, quantity.unit)] = json!((quantity.of)(outlook, model));
    }
    entry
}

fn range(range: &Range) -> Value {
    json!({ "low": range.low, "middle": range.middle, "high": range.high })
}

/// The interval of one model; `middle` is the median.
fn interval(intervals: &Intervals, model: &str) -> Value {
    let of = |quantity: &str| {
        let range = |i: &Interval| json!({ "low": i.low, "middle": i.middle, "high": i.high });
        intervals.of(model, quantity).map(range)
    };
    let [drag, vertical, sinkage] = ["drag_N", "vertical_N", "sinkage_m"].map(of);
    json!({ "drag_N": drag, "vertical_N": vertical, "sinkage_m": sinkage })
}

fn inputs(intervals: &Intervals) -> Vec<Value> {
    let one = |s: &InputDeviation| {
        json!({
            "key": s.key, "mean": s.mean, "deviation": s.deviation, "distribution": "normal",
            "assumed": intervals.assumed,
        })
    };
    intervals.inputs.iter().map(one).collect()
}
