//! Whether memory and disc suffice for a run: doubts, told before it begins.

use super::estimate::Cost;
use super::machine::{memory_available, room_for};
use std::path::Path;

/// Share of the free memory or room above which there is a doubt.
const MUCH: f64 = 0.8;

/// Doubts whether this machine has the memory for what a case costs, and the disc of its results folder the room.
#[must_use]
pub fn doubts(cost: &Cost, folder: &Path) -> Vec<String> {
    let memory = memory_available().filter(|free| cost.memory_bytes > MUCH * free).map(|free| {
        format!(
            "The run needs about {} of memory, and {} are free here: a larger grid.cell or a smaller fine zone needs less.",
            words(cost.memory_bytes),
            words(free)
        )
    });
    let written = cost.output.total_bytes;
    let room = room_for(folder).filter(|free| written > MUCH * free).map(|free| {
        format!(
            "The results will take about {}, and {} are free on the disc of {}: a longer output.field_interval needs less, \
             -o DIR writes elsewhere.",
            words(written),
            words(free),
            folder.display()
        )
    });
    memory.into_iter().chain(room).collect()
}

/// A number of bytes for people.
#[must_use]
pub fn words(bytes: f64) -> String {
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
    use crate::case::estimate::cost;

    #[test]
    fn bytes_are_told_in_two_digits_or_three() {
        assert_eq!(
            [400.0, 12_340.0, 9.96e6, 3.21e9, 4.5e12].map(words),
            ["0.4 kB", "12 kB", "10 MB", "3.2 GB", "4500 GB"]
        );
    }

    #[test]
    fn a_run_that_writes_more_than_fits_is_doubted() {
        let text = include_str!("../../../../cases/towed_disc.toml");
        let mut case = crate::case::parse(text, "case.toml", &[]).unwrap();
        assert!(doubts(&cost(&case), Path::new("results")).is_empty());
        case.output.field_interval = 1e-9;
        let told = doubts(&cost(&case), Path::new("results")).concat();
        assert!(told.contains("free on the disc") && told.contains("output.field_interval"), "{told}");
    }
}
