//! Points of a measured curve that say nothing of a model, and why.

use crate::measured::{Quantity, Record};
use crate::sheet::short;

/// Points of a curve that were left out for one reason.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// The curve: the file and the quantity.
    pub curve: String,
    /// Lines of the file, where it is one.
    pub lines: Vec<usize>,
    /// The abscissae [SI].
    pub at: Vec<f64>,
    /// The quantity of the abscissae.
    pub abscissa: Quantity,
    /// Why the points were left out.
    pub why: String,
}

/// Why a row says nothing by construction, whatever the model: a body that does not reach into the soil, or
/// one that is pressed down and lifted just then. `None` of a row that says something.
#[must_use]
pub fn says_nothing(
    is_pressed: bool,
    (abscissa, at): (Quantity, f64),
    (quantity, value): (Quantity, f64),
) -> Option<&'static str> {
    if abscissa != Quantity::Sinkage {
        return None;
    }
    if at <= 0.0 {
        return Some("without sinkage there is no force");
    }
    let is_force = matches!(quantity, Quantity::Vertical | Quantity::Pressure);
    (is_pressed && is_force && value == 0.0).then_some("no force: the body was lifted there")
}

/// Which lines of a record these abscissae are, and where they lie.
#[must_use]
pub fn place(record: &Record, abscissa: Quantity, at: &[f64]) -> String {
    let values = record.values(abscissa).unwrap_or_default();
    let row = |x: &f64| values.iter().position(|value| value == x).unwrap_or(usize::MAX);
    let points: Vec<(usize, f64, String)> = at.iter().map(|x| (row(x), *x, String::new())).collect();
    let list = LeftOut::of(record, (abscissa, abscissa), &points);
    list.first().map_or_else(|| record.name.clone(), |all| format!("{}, {}", record.name, all.place()))
}

impl LeftOut {
    /// Points of a record with a reason, reason by reason; `rows` are those of the points.
    #[must_use]
    pub fn of(
        record: &Record,
        (abscissa, quantity): (Quantity, Quantity),
        points: &[(usize, f64, String)],
    ) -> Vec<Self> {
        let mut list: Vec<Self> = Vec::new();
        for (row, at, why) in points {
            let line = record.lines.get(*row).copied();
            let known = list.iter_mut().find(|known| known.why == *why);
            let entry = match known {
                Some(known) => known,
                None => {
                    list.push(Self {
                        curve: format!("{}: {}", record.name, quantity.name()),
                        lines: Vec::new(),
                        at: Vec::new(),
                        abscissa,
                        why: why.clone(),
                    });
                    let last = list.len() - 1;
                    &mut list[last]
                }
            };
            entry.lines.extend(line);
            entry.at.push(*at);
        }
        list
    }

    /// How many points, where, and why, in one line.
    #[must_use]
    pub fn text(&self) -> String {
        let count = self.at.len();
        let points = if count == 1 { "1 point is".to_owned() } else { format!("{count} points are") };
        format!("{}: {points} left out ({}): {}", self.curve, self.place(), self.why)
    }

    /// Lines and abscissae.
    fn place(&self) -> String {
        let ends = |low: String, high: String| if low == high { low } else { format!("{low} to {high}") };
        let (low, high) = self
            .at
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(*x), high.max(*x)));
        let unit = self.abscissa.unit();
        let (size, unit) = if unit == "m" { (1e3, "mm") } else { (1.0, unit) };
        let range = ends(short(size * low), short(size * high));
        let unit = if unit == "-" { String::new() } else { format!(" {unit}") };
        let along = format!("{} {range}{unit}", self.abscissa.name());
        match (self.lines.first(), self.lines.last()) {
            (Some(first), Some(last)) if first == last => format!("line {first}, {along}"),
            (Some(first), Some(last)) => format!("lines {first} to {last}, {along}"),
            _ => along,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_without_sinkage_or_without_force_say_nothing() {
        let says = |at, value| says_nothing(true, (Quantity::Sinkage, at), (Quantity::Vertical, value));
        assert!(says(0.0, 0.0).is_some() && says(-0.01, 3.0).is_some() && says(0.01, 0.0).is_some());
        assert!(says(0.01, 2.0).is_none());
        // A wheel may roll without slip, and a towed body without drag.
        assert!(says_nothing(false, (Quantity::Slip, 0.0), (Quantity::Drag, 0.0)).is_none());
    }

    #[test]
    fn points_are_counted_by_reason() {
        let record = Record { name: "a.csv".into(), lines: vec![2, 3, 4], ..Record::default() };
        let point = |row, at, why: &str| (row, at, why.to_owned());
        let points = [point(0, 0.0, "no"), point(2, 0.2, "deep"), point(1, 0.1, "deep")];
        let list = LeftOut::of(&record, (Quantity::Sinkage, Quantity::Vertical), &points);
        assert_eq!(list.len(), 2);
        assert_eq!(list[0].text(), "a.csv: vertical: 1 point is left out (line 2, sinkage 0 mm): no");
        assert!(list[1].text().contains("2 points are left out (lines 4 to 3, sinkage 100 to 200 mm): deep"));
    }
}
