//! The models of a forecast as comma-separated values.

use super::outlook::{Outlook, mechanism_word};
use super::uncertainty::Intervals;
use input::printed::text_cell;
use std::fmt::Write;

/// Header of `models.csv`.
const HEADER: &str = "model,applicable,drag F_H [N],vertical F_V [N],sinkage z [m],contact angle [deg],\
force inclination [deg],slip [-],mechanism,sideways share [-],F_H_bar [-],F_V_bar [-],Z [-],\
drag 5 % [N],drag 95 % [N],vertical 5 % [N],vertical 95 % [N],sinkage 5 % [m],sinkage 95 % [m],\
lateral [N],moment x [N m],moment y [N m],moment z [N m],note";

/// The text of `models.csv`: one line per model.
#[must_use]
pub fn models_csv(outlook: &Outlook, intervals: &Intervals) -> String {
    let mut text = format!("{HEADER}\n");
    for model in &outlook.forecast.models {
        let found = model.prediction;
        let of = |name: &str| outlook.predicted(model, name);
        let degrees = |name: &str| of(name).map(f64::to_degrees);
        let numbers = [
            of("drag"),
            of("vertical"),
            of("sinkage"),
            degrees("contact_angle"),
            degrees("force_inclination"),
            of("slip"),
        ];
        let groups = [found.and_then(|p| p.sideways_fraction), of("F_H_bar"), of("F_V_bar"), of("Z")];
        let ends = |quantity: &str| {
            let found = intervals.of(model.name, quantity);
            [found.map(|i| i.low), found.map(|i| i.high)]
        };
        let spread = ["drag_N", "vertical_N", "sinkage_m"].map(ends).concat();
        let fields = |list: &[Option<f64>]| {
            list.iter().map(|x| x.map_or(String::new(), |x| format!("{x:.6e}"))).collect::<Vec<_>>().join(",")
        };
        let moment = outlook.moment(model);
        let sideways = [of("lateral")].into_iter();
        let sideways: Vec<_> = sideways.chain([0, 1, 2].map(|axis| moment.map(|m| m[axis]))).collect();
        let word = found.and_then(|p| p.mechanism).map_or("", mechanism_word);
        let note = text_cell(&model.note);
        let (name, applicable) = (model.name, model.applicable);
        let _ = writeln!(
            text,
            "{name},{applicable},{},{word},{},{},{},{note}",
            fields(&numbers),
            fields(&groups),
            fields(&spread),
            fields(&sideways)
        );
    }
    text
}
