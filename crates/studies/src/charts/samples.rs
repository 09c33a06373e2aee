//! A study for the tests.

use crate::table::{Column, Role, Table, Values};

/// A column of numbers, or of words.
pub(crate) fn column(name: &str, unit: &str, role: Role, values: Values) -> Column {
    Column { name: name.into(), unit: unit.into(), label: name.into(), role, values }
}

/// A grid of two models, five angles, two depths and two tips; one drag is missing.
pub(crate) fn grid() -> Table {
    let (mut model, mut angle, mut depth, mut tip, mut drag) = (vec![], vec![], vec![], vec![], vec![]);
    for (m, name) in ["solver", "plain_model"].into_iter().enumerate() {
        for a in 0..5 {
            for d in 1..=2 {
                for (t, word) in ["sharp", "blunt"].into_iter().enumerate() {
                    let (a, d) = (25.0 + 5.0 * f64::from(a), 0.1 * f64::from(d));
                    model.push(Some(name.to_owned()));
                    angle.push(Some(a));
                    depth.push(Some(d));
                    tip.push(Some(word.to_owned()));
                    drag.push(Some(1000.0 * d * d * a * (1.0 + 0.1 * m as f64) * (1.0 + 0.3 * t as f64)));
                }
            }
        }
    }
    drag[3] = None;
    let state = drag.iter().map(|x| Some(if x.is_some() { "done" } else { "failed" }.to_owned())).collect();
    Table {
        columns: vec![
            column("model", "", Role::Key, Values::Words(model)),
            column("angle", "deg", Role::Factor, Values::Numbers(angle)),
            column("depth", "m", Role::Factor, Values::Numbers(depth)),
            column("tip", "", Role::Factor, Values::Words(tip)),
            column("drag", "N", Role::Response, Values::Numbers(drag)),
            column("state", "", Role::Remark, Values::Words(state)),
        ],
    }
}
