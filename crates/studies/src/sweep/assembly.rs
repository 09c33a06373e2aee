//! Several bodies of a run as one: the row of all of them together.

use crate::responses::{Figures, GROUPS, responses};
use coulter::history::reference::Reference;

/// Name of the body in the row of all bodies together.
pub(super) const ALL_BODIES: &str = "all bodies";

/// All bodies together: sums of forces and of the ends of their intervals, over the sum of their reference
/// forces γ t d²; of everything else the mean. What a body lacks the whole lacks.
pub(super) fn together(rows: &[Figures], references: &[&Reference], weight: Option<f64>) -> Figures {
    let mut all = Figures {
        model: "solver".to_owned(),
        body: ALL_BODIES.to_owned(),
        grade: rows.first().and_then(|row| row.grade.clone()),
        ..Figures::default()
    };
    let scale: Option<f64> = references.iter().map(|reference| reference.force()).sum();
    let count = rows.len() as f64;
    for response in responses() {
        let is_force = response.unit == "N";
        let part = |sum: f64| if is_force { sum } else { sum / count };
        let sum: Option<f64> = rows.iter().map(|row| row.get(response.name)).sum();
        all.say(response.name, sum.map(part));
        let end = |n: usize| rows.iter().map(|row| Some(row.intervals.get(response.name)?[n])).sum();
        if let (Some(low), Some(high)) = (end(0), end(1)) {
            all.intervals.insert(response.name, [low, high].map(part));
        }
    }
    let over_all = |force: f64| scale.map(|scale| force / scale);
    for [group, of] in GROUPS.into_iter().filter(|[_, of]| *of != "sinkage") {
        all.responses.remove(group);
        all.say(group, all.get(of).and_then(over_all));
        all.intervals.remove(group);
        if let (Some(interval), Some(scale)) = (all.intervals.get(of).copied(), scale) {
            all.intervals.insert(group, interval.map(|end| end / scale));
        }
    }
    all.say("W_bar", weight.and_then(over_all));
    // A ratio of sums, not the mean of ratios.
    let ratio = all.get("pull").zip(all.get("vertical")).map(|(pull, vertical)| pull / vertical);
    all.say("pull_over_weight", ratio.filter(|_| all.get("pull_over_weight").is_some()));
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn forces_are_sums_and_sinkages_means() {
        let row = |drag: f64, sinkage: f64| Figures {
            responses: [("drag", drag), ("sinkage", sinkage), ("F_H_bar", drag / 10.0)].into(),
            intervals: BTreeMap::from([("drag", [drag - 1.0, drag + 2.0])]),
            ..Figures::default()
        };
        let reference = Reference { length: 1.0, width: 1.0, unit_weight: 10.0, ..Reference::default() };
        let all = together(&[row(10.0, 0.1), row(30.0, 0.3)], &[&reference, &reference], Some(50.0));
        let names = ["drag", "sinkage", "F_H_bar", "W_bar"];
        assert_eq!(names.map(|name| all.get(name)), [Some(40.0), Some(0.2), Some(2.0), Some(2.5)]);
        assert_eq!((all.intervals["drag"], all.intervals["F_H_bar"]), ([38.0, 44.0], [1.9, 2.2]));
        assert_eq!(all.get("vertical"), None);
    }
}
