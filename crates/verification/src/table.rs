//! The rows as a table: for the terminal and as data.

use crate::row::{Expected, Judgement, Row, Tolerance};

const HEADS: [&str; 9] =
    ["id", "case", "quantity", "expected", "obtained", "error", "tolerance", "verdict", "s"];
/// Columns that are set flush right.
const RIGHT: [bool; 9] = [false, false, false, true, true, true, true, false, true];

/// A figure with four significant digits.
#[must_use]
pub fn figure(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if !(1e-3..1e5).contains(&size) {
        format!("{value:.2e}")
    } else {
        let digits = (3.0 - size.log10().floor()).clamp(0.0, 6.0) as usize;
        format!("{value:.digits$}")
    }
}

/// A fraction in per cent.
fn per_cent(fraction: f64) -> String {
    if fraction != 0.0 && fraction.abs() < 1e-4 {
        format!("{:.1e} %", 1e2 * fraction)
    } else {
        format!("{:.2} %", 1e2 * fraction)
    }
}

/// The expected value as the tables show it.
#[must_use]
pub fn expected(row: &Row) -> String {
    match row.expected {
        Expected::Value(value) => figure(value),
        Expected::AtLeast(value) => format!("≥ {}", figure(value)),
        Expected::Between(low, high) if low == high => figure(low),
        Expected::Between(low, high) => format!("{} to {}", figure(low), figure(high)),
        Expected::Nothing => String::new(),
    }
}

fn cells(row: &Row) -> [String; 9] {
    let (error, tolerance) = match (row.tolerance, row.error()) {
        (Tolerance::Relative(limit), Some(error)) => (per_cent(error), format!("{} %", figure(1e2 * limit))),
        (Tolerance::Absolute(limit), Some(error)) => (figure(error), figure(limit)),
        _ => (String::new(), String::new()),
    };
    let seconds = if row.seconds > 0.0 { format!("{:.1}", row.seconds) } else { String::new() };
    let case = row.case.clone();
    let quantity = row.quantity.clone();
    let obtained = figure(row.obtained);
    [
        row.id.to_owned(),
        case,
        quantity,
        expected(row),
        obtained,
        error,
        tolerance,
        row.judgement().word().to_owned(),
        seconds,
    ]
}

/// The table for a terminal.
#[must_use]
pub fn text(rows: &[Row]) -> String {
    let lines: Vec<[String; 9]> = rows.iter().map(cells).collect();
    let width =
        |n: usize| lines.iter().map(|l| l[n].chars().count()).fold(HEADS[n].chars().count(), usize::max);
    let widths: [usize; 9] = std::array::from_fn(width);
    let line = |cells: &[String; 9]| {
        let padded = (0..9).map(|n| {
            let space = " ".repeat(widths[n] - cells[n].chars().count());
            if RIGHT[n] { format!("{space}{}", cells[n]) } else { format!("{}{space}", cells[n]) }
        });
        format!("{}\n", padded.collect::<Vec<_>>().join("  ").trim_end())
    };
    let mut text = line(&HEADS.map(str::to_owned));
    let rule: [String; 9] = widths.map(|w| "─".repeat(w));
    text.push_str(&line(&rule));
    lines.iter().for_each(|cells| text.push_str(&line(cells)));
    text
}

/// What stands in a row of [`as_data`].
pub(crate) const DATA_HEADS: [&str; 10] = [
    "case",
    "quantity",
    "expected",
    "obtained",
    "error",
    "tolerance",
    "verdict",
    "seconds",
    "source",
    "reason",
];

/// The rows of a benchmark as lists of what stands in the table, with source and reason of a failure.
pub(crate) fn as_data<'a>(rows: &[Row], reason: impl Fn(&Row) -> &'a str) -> Vec<serde_json::Value> {
    let entries = rows.iter().map(|row| {
        let [_, shown @ ..] = cells(row);
        let more = [row.source.to_string(), reason(row).to_owned()];
        serde_json::json!(shown.into_iter().chain(more).collect::<Vec<_>>())
    });
    entries.collect()
}

/// The closing line: how many rows have which judgement.
#[must_use]
pub fn closing(rows: &[Row]) -> String {
    let count = |judgement| rows.iter().filter(|row| row.judgement() == judgement).count();
    format!(
        "{} passed, {} failed; of the rows compared with published ranges {} inside, {} outside",
        count(Judgement::Pass),
        count(Judgement::Fails),
        count(Judgement::Inside),
        count(Judgement::Outside)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_have_four_digits() {
        assert_eq!(figure(5.141_592), "5.142");
        assert_eq!(figure(23.456_7), "23.46");
        assert_eq!(figure(0.012_345_6), "0.01235");
        assert_eq!(figure(1.234e-7), "1.23e-7");
        assert_eq!(figure(12_345.6), "12346");
        assert_eq!(figure(f64::NAN), "NaN");
    }

    #[test]
    fn tables_line_up() {
        let rows = [
            Row::info("B1", "B/h = 16", "N_c", 5.2).within(5.1416, 0.02, "Prandtl"),
            Row::info("B1", "φ", "x", 1.0),
        ];
        let text = text(&rows);
        assert!(text.contains("1.14 %") && text.contains("pass"), "{text}");
        assert!(closing(&rows).starts_with("1 passed, 0 failed;"));
        let data = as_data(&rows, |_| "");
        assert_eq!(data[0].as_array().unwrap().len(), DATA_HEADS.len());
        assert_eq!((data[0][1].as_str(), data[0][8].as_str()), (Some("N_c"), Some("Prandtl")));
    }

    #[test]
    fn what_lies_outside_a_published_range_is_counted_and_stands_out() {
        let rows =
            [14.4, 16.0].map(|drag| Row::info("D3", "disc", "drag", drag).compared_with(15.0, 17.0, "trial"));
        assert!(closing(&rows).ends_with("1 inside, 1 outside"), "{}", closing(&rows));
        assert!(text(&rows).contains("outside"));
    }
}
