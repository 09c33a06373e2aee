//! The responses of a study: the columns of its table besides the factors.

use coulter::history::quantities::{Quantity, key};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;
use std::collections::BTreeMap;

/// What one model says of one body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Figures {
    /// The model: `solver`, or the name of a closed form.
    pub model: String,
    /// The body.
    pub body: String,
    /// Whether the model is the recommended closed form, or the body the first of a run.
    pub recommended: bool,
    /// Grade of a run: `good` or `doubtful`.
    pub grade: Option<String>,
    /// Intervals (5 to 95 %) of responses, in their units, by name.
    #[serde(skip_serializing_if = "BTreeMap::is_empty", deserialize_with = "of_known")]
    pub intervals: BTreeMap<&'static str, [f64; 2]>,
    /// The responses of the model, in their units, by name.
    #[serde(flatten, serialize_with = "with_units", deserialize_with = "without_units")]
    pub responses: BTreeMap<&'static str, f64>,
}

/// Every response by its key with the unit, such as `drag_N`; `null` for what is not said.
fn with_units<S: Serializer>(said: &BTreeMap<&'static str, f64>, serializer: S) -> Result<S::Ok, S::Error> {
    let entry = |response: &ResponseColumn| (key(response.name, response.unit), said.get(response.name));
    serializer.collect_map(responses().iter().map(entry))
}

fn without_units<'de, D: Deserializer<'de>>(from: D) -> Result<BTreeMap<&'static str, f64>, D::Error> {
    let mut found = BTreeMap::<String, Value>::deserialize(from)?;
    let value = |response: ResponseColumn| {
        let value = found.remove(&key(response.name, response.unit)).filter(|value| !value.is_null())?;
        Some(serde_json::from_value(value).map(|value| (response.name, value)).map_err(D::Error::custom))
    };
    responses().into_iter().filter_map(value).collect()
}

/// Intervals of responses that are known.
fn of_known<'de, D: Deserializer<'de>>(from: D) -> Result<BTreeMap<&'static str, [f64; 2]>, D::Error> {
    let mut found = BTreeMap::<String, [f64; 2]>::deserialize(from)?;
    let known = names().filter_map(|name| Some((name, found.remove(name)?)));
    Ok(known.collect())
}

/// Dimensionless groups, each of the response of which it is a multiple.
pub(crate) const GROUPS: [[&str; 2]; 3] = [["F_H_bar", "drag"], ["F_V_bar", "vertical"], ["Z", "sinkage"]];

impl Figures {
    /// Says the interval of a response by its key with the unit, such as `drag_N`, and that of the
    /// dimensionless group which is a multiple of it.
    pub(crate) fn say_interval(&mut self, with_unit: &str, interval: [f64; 2]) {
        let all = responses();
        let Some(of) = all.iter().find(|response| key(response.name, response.unit) == with_unit) else {
            return;
        };
        self.intervals.insert(of.name, interval);
        for [group, _] in GROUPS.iter().filter(|[_, multiple]| *multiple == of.name) {
            if let (Some(value), Some(part)) = (self.get(of.name), self.get(group))
                && value != 0.0
            {
                self.intervals.insert(group, interval.map(|end| end * part / value));
            }
        }
    }

    /// A response by its name, in its unit; `None` where the model does not say it.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<f64> {
        self.responses.get(name).copied()
    }

    /// Says a response; what is not a number is not said.
    pub(crate) fn say(&mut self, name: &'static str, value: Option<f64>) {
        self.responses.extend(value.filter(|value| value.is_finite()).map(|value| (name, value)));
    }

    /// Says what follows from drag, vertical force, slip and torque, where it is not said: pull, turn ratio,
    /// and, of a body that rolls on a radius [m], its efficiency P v/(T ω), where the soil resists with the
    /// torque T and P is positive.
    pub(crate) fn say_traction(&mut self, radius: Option<f64>) {
        let pull = self.get("pull").or(self.get("drag").map(|drag| 0.0 - drag));
        let turn_ratio = self.get("slip").map(analytic::turn_ratio);
        let weight = self.get("vertical").filter(|weight| *weight > 0.0);
        let torque = self.get("axle_torque").map(|torque| -torque).filter(|torque| *torque > 0.0);
        let efficiency = |radius: f64| {
            let turns = torque? * turn_ratio.filter(|ratio| *ratio > 0.0)?;
            Some(pull.filter(|pull| *pull > 0.0)? * radius / turns)
        };
        self.say("pull", pull);
        self.say("pull_over_weight", pull.zip(weight).map(|(pull, weight)| pull / weight));
        self.say("turn_ratio", turn_ratio);
        self.say("efficiency", radius.and_then(efficiency));
    }
}

/// A response.
#[derive(Clone, Debug)]
pub struct ResponseColumn {
    /// Name of the column of the response.
    pub name: &'static str,
    /// Unit of the response.
    pub unit: &'static str,
    /// Name of the response in charts.
    pub label: String,
}

/// The responses that are no quantities of a run, and of those that are, where they stand among them: name,
/// unit, label.
const LISTED: [[&str; 3]; 20] = [
    ["drag", "", ""],
    ["vertical", "", ""],
    ["lateral", "N", "lateral force F_y"],
    ["sinkage", "", ""],
    ["slip", "-", "slip s"],
    ["pull", "N", "drawbar pull P"],
    ["pull_over_weight", "-", "pull over weight P/F_V"],
    ["turn_ratio", "", ""],
    ["efficiency", "-", "tractive efficiency η"],
    ["axle_torque", "", ""],
    ["peak_drag", "N", "largest drag"],
    ["peak_vertical", "N", "largest vertical force"],
    ["drag_noise", "-", "scatter of the drag over its mean"],
    ["F_H_bar", "-", "dimensionless drag F̄_H"],
    ["F_V_bar", "-", "dimensionless vertical force F̄_V"],
    ["Z", "-", "dimensionless sinkage Z"],
    ["t_bar", "-", "dimensionless thickness t̄"],
    ["W_bar", "-", "dimensionless weight W̄"],
    ["E_bar", "-", "dimensionless stiffness Ē"],
    ["c_bar", "-", "dimensionless cohesion c̄"],
];

/// All responses, in the order of the table: what is listed, and every other quantity of a run.
#[must_use]
pub fn responses() -> Vec<ResponseColumn> {
    let of_run = |quantity: Quantity| ResponseColumn {
        name: quantity.figure.name,
        unit: quantity.column.unit,
        label: quantity.label(),
    };
    let listed = LISTED.iter().filter_map(|[name, unit, label]| match *label {
        "" => Quantity::named(name).map(of_run),
        label => Some(ResponseColumn { name, unit, label: label.to_owned() }),
    });
    let others = Quantity::all().into_iter().map(of_run);
    let others = others.filter(|response| LISTED.iter().all(|[name, ..]| *name != response.name));
    listed.chain(others).collect()
}

/// The names of the responses.
pub fn names<'a>() -> impl Iterator<Item = &'a str> {
    responses().into_iter().map(|response| response.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_wheel_pulls_follows_from_its_forces() {
        let wheel = |drag: f64, slip: f64| {
            let said = [("drag", drag), ("vertical", 100.0), ("slip", slip), ("axle_torque", -10.0)];
            let mut figures = Figures { responses: said.into(), ..Figures::default() };
            figures.say_traction(Some(0.125));
            figures
        };
        let driven = wheel(-50.0, 0.2);
        let names = ["pull", "pull_over_weight", "turn_ratio"];
        assert_eq!(names.map(|name| driven.get(name)), [Some(50.0), Some(0.5), Some(1.25)]);
        // 50 N × v over 10 N m × 1.25 v/0.125 m.
        assert_eq!(driven.get("efficiency"), Some(0.5));
        assert_eq!(wheel(-50.0, 1.0).get("efficiency"), Some(0.0));
        assert_eq!(wheel(20.0, -0.1).get("efficiency"), None);
        let mut none = Figures::default();
        none.say_traction(Some(0.1));
        assert_eq!(none, Figures::default());
    }

    #[test]
    fn figures_are_read_back() {
        let figures = Figures { responses: [("drag", 1.5), ("Z", 0.1)].into(), ..Figures::default() };
        let text = serde_json::to_string(&figures).unwrap();
        assert!(text.contains("\"drag_N\":1.5,\"vertical_N\":null,\"lateral_N\":null,"), "{text}");
        assert_eq!(serde_json::from_str::<Figures>(&text).unwrap(), figures);
    }
}
