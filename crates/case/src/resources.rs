//! Warnings, before a run begins, that memory or disk space may not suffice.

use super::estimate::Cost;
use machine::{free_space, memory_left};
use std::path::Path;

/// Fraction of the free memory or disk space above which there is a warning.
const NEARLY_ALL: f64 = 0.8;

/// Warnings where this machine may not have enough memory for a case, or not enough disk space for its
/// results.
#[must_use]
pub fn warnings(cost: &Cost, folder: &Path) -> Vec<String> {
    let memory = memory_left().filter(|free| cost.memory_bytes > NEARLY_ALL * free.bytes).map(|free| {
        format!(
            "The run needs about {} of memory, and {} are free{}: use a larger grid.cell or a smaller fine zone.",
            format_bytes(cost.memory_bytes),
            format_bytes(free.bytes),
            free.of
        )
    });
    let written = cost.output.total_bytes;
    let space = free_space(folder).filter(|free| written > NEARLY_ALL * free).map(|free| {
        format!(
            "The results need about {}, and {} are free on the disk of {}: use a longer output.field_interval, or \
             another folder with -o DIR.",
            format_bytes(written),
            format_bytes(free),
            folder.display()
        )
    });
    memory.into_iter().chain(space).collect()
}

/// A number of bytes with two or three digits and a unit.
#[must_use]
pub fn format_bytes(bytes: f64) -> String {
    let (size, unit) = match bytes {
        b if b >= 1e9 => (1e9, "GB"),
        b if b >= 1e6 => (1e6, "MB"),
        _ => (1e3, "kB"),
    };
    let value = bytes / size;
    if value < 9.95 { format!("{value:.1} {unit}") } else { format!("{value:.0} {unit}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::cost;

    #[test]
    fn bytes_have_two_or_three_digits() {
        assert_eq!(
            [400.0, 12_340.0, 9.96e6, 3.21e9, 4.5e12].map(format_bytes),
            ["0.4 kB", "12 kB", "10 MB", "3.2 GB", "4500 GB"]
        );
    }

    #[test]
    fn a_run_that_writes_more_than_fits_is_warned_of() {
        let text = include_str!("../../../cases/light_disc.toml");
        let mut case = crate::parse(text, "case.toml", &[]).unwrap();
        assert!(warnings(&cost(&case), Path::new("results")).is_empty());
        case.output.field_interval = 1e-9;
        let text = warnings(&cost(&case), Path::new("results")).concat();
        assert!(text.contains("free on the disk") && text.contains("output.field_interval"), "{text}");
    }
}
