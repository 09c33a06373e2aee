//! The forecast as one JSON document: a contract, scripts rely on its names.

use super::{Interval, Outlook, Stated, mechanism_word};
use analytic::disc::Drive;
use analytic::forecast::{Load, ModelForecast, Range};
use serde_json::{Value, json};

/// The document of a forecast, with the uncertainty where it was asked for.
#[must_use]
pub fn document(outlook: &Outlook, stated: &[Stated], intervals: &[Interval]) -> Value {
    let forecast = &outlook.forecast;
    let models = |list: &[ModelForecast]| list.iter().map(|m| model(outlook, m)).collect::<Vec<_>>();
    let spread = forecast.spread.as_ref().map(|s| {
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
        "case": outlook.case,
        "discs": outlook.setting.discs,
        "groups": groups(outlook),
        "load": load(outlook),
        "drive": drive(outlook.setting.towing.drive),
        "models": models(&forecast.models),
        "models_full_friction": models(&forecast.models_full_friction),
        "operative_friction_angle_rad": forecast.operative_friction_angle,
        "spread": spread,
        "side_faces": faces,
        "recommended": outlook.recommended().map(|m| m.name),
        "recommendation": forecast.recommendation,
        "remarks": outlook.setting.remarks,
    });
    if !stated.is_empty() {
        document["uncertainty"] = uncertainty(stated, intervals);
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
    match outlook.setting.towing.load {
        Load::Weight(weight) => json!({ "weight_N": weight }),
        Load::Sinkage(z) => json!({ "sinkage_m": z }),
    }
}

fn drive(drive: Drive) -> Value {
    match drive {
        Drive::Free => json!({ "kind": "free" }),
        Drive::Locked => json!({ "kind": "locked" }),
        Drive::Braked(torque) => json!({ "kind": "braked", "torque_Nm": torque }),
        Drive::Driven(torque) => json!({ "kind": "driven", "torque_Nm": torque }),
        Drive::Slip(slip) => json!({ "kind": "slip", "slip": slip }),
    }
}

fn model(outlook: &Outlook, model: &ModelForecast) -> Value {
    let found = model.prediction;
    let scale = outlook.force_scale();
    let diameter = outlook.setting.towing.disc.diameter;
    json!({
        "name": model.name,
        "applicable": model.applicable,
        "drag_N": found.map(|p| p.drag),
        "vertical_N": found.map(|p| p.vertical),
        "sinkage_m": found.and_then(|p| p.sinkage),
        "contact_angle_rad": found.and_then(|p| p.contact_angle),
        "force_inclination_rad": found.map(|p| p.force_inclination),
        "skid": found.and_then(|p| p.skid),
        "mechanism": found.and_then(|p| p.mechanism).map(mechanism_word),
        "F_H_bar": found.map(|p| p.drag / scale),
        "F_V_bar": found.map(|p| p.vertical / scale),
        "Z": found.and_then(|p| p.sinkage).map(|z| z / diameter),
        "note": model.note,
    })
}

fn range(range: &Range) -> Value {
    json!({ "low": range.low, "middle": range.middle, "high": range.high })
}

fn uncertainty(stated: &[Stated], intervals: &[Interval]) -> Value {
    let inputs: Vec<Value> = stated
        .iter()
        .map(|s| json!({ "key": s.key, "mean": s.mean, "deviation": s.deviation, "distribution": "normal" }))
        .collect();
    json!({ "inputs": inputs, "quantities": intervals })
}
