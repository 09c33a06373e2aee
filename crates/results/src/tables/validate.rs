//! Validation of a history that was read back from files.

use super::csv::forces_name;
use crate::history::History;
use crate::history::columns::{Column, ENERGY, FORCES};
use crate::history::reference::Reference;

/// Refuses a history that no run can have written: without lines, with times that are not finite or do not
/// increase, with forces, sinkages or energies that are not numbers.
///
/// Lines are numbered as in an editor: the header is line 1.
///
/// # Errors
/// States file, line and column, what is wrong there, and what to do.
pub fn validate_history(history: &History) -> Result<(), String> {
    if history.bodies.len() != history.names.len() {
        return Err(format!(
            "the history has {} bodies and {} names; run the case again",
            history.bodies.len(),
            history.names.len()
        ));
    }
    for (body, samples) in history.bodies.iter().enumerate() {
        let file = forces_name(&history.names, body);
        increasing(&file, samples, |s| s.time)?;
        finite(&file, samples, FORCES)?;
    }
    increasing("energy.csv", &history.energy, |s| s.time)?;
    finite("energy.csv", &history.energy, ENERGY)
}

/// Refuses a history without lines, and times that are not finite or not later than the previous one.
fn increasing<S>(file: &str, samples: &[S], time: impl Fn(&S) -> f64) -> Result<(), String> {
    if samples.is_empty() {
        return Err(format!("{file} has no line below its header; run the case, or resume it with --resume"));
    }
    let mut last = f64::NEG_INFINITY;
    for (n, now) in samples.iter().map(time).enumerate() {
        if !now.is_finite() {
            return Err(damaged(file, n, "time [s]", &format!("{now} instead of a finite number")));
        }
        if now <= last {
            let why = format!("{now} instead of a time later than {last} s on the line before");
            return Err(damaged(file, n, "time [s]", &why));
        }
        last = now;
    }
    Ok(())
}

/// Refuses a number that is not finite in a column that needs one.
fn finite<S: Copy>(file: &str, samples: &[S], columns: &[Column<S>]) -> Result<(), String> {
    let none = Reference::default();
    for (n, sample) in samples.iter().enumerate() {
        for column in columns.iter().filter(|column| column.is_required) {
            let value = column.value(sample, &none);
            if !value.is_finite() {
                return Err(damaged(
                    file,
                    n,
                    &column.header(),
                    &format!("{value} instead of a finite number"),
                ));
            }
        }
    }
    Ok(())
}

fn damaged(file: &str, sample: usize, column: &str, what: &str) -> String {
    format!(
        "{file}, line {}, column `{column}`: {what}; the file is damaged: restore it from a backup, or run the case again \
         with --force",
        sample + 2
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::history::{BodySample, EnergySample};

    fn history(lines: u32) -> History {
        let time = |n: u32| 0.1 * f64::from(n);
        let body = (1..=lines).map(|n| BodySample { time: time(n), ..BodySample::default() }).collect();
        let energy = (1..=lines).map(|n| EnergySample { time: time(n), ..EnergySample::default() }).collect();
        History { names: vec!["disc".into()], bodies: vec![body], energy, ..History::default() }
    }

    fn refusal(damage: impl Fn(&mut History)) -> String {
        let mut damaged = history(3);
        damage(&mut damaged);
        validate_history(&damaged).unwrap_err()
    }

    #[test]
    fn what_a_run_writes_is_taken() {
        assert_eq!(validate_history(&history(3)), Ok(()));
        let without_bodies = History { names: vec![], bodies: vec![], ..history(2) };
        assert_eq!(validate_history(&without_bodies), Ok(()), "a column has no body");
    }

    #[test]
    fn a_header_alone_is_refused() {
        assert!(refusal(|h| h.bodies[0].clear()).starts_with("forces.csv has no line"));
        assert!(refusal(|h| h.energy.clear()).starts_with("energy.csv has no line"));
    }

    #[test]
    fn what_is_not_a_number_is_named_with_line_and_column() {
        let message = refusal(|h| h.bodies[0][1].drag = f64::NAN);
        assert!(message.starts_with("forces.csv, line 3, column `drag F_H [N]`: NaN"), "{message}");
        let message = refusal(|h| h.bodies[0][2].sinkage = f64::INFINITY);
        assert!(message.contains("line 4, column `sinkage z [m]`: inf"), "{message}");
        let message = refusal(|h| h.energy[0].plastic = f64::NAN);
        assert!(message.starts_with("energy.csv, line 2, column `plastic [J]`"), "{message}");
    }

    #[test]
    fn time_that_stands_still_or_runs_backwards_is_refused() {
        for time in [0.2, 0.1] {
            let message = refusal(|h| h.bodies[0][2].time = time);
            assert!(
                message.contains("line 4, column `time [s]`") && message.contains("later than 0.2 s"),
                "{message}"
            );
        }
        assert!(
            refusal(|h| h.energy[1].time = f64::NAN).contains("energy.csv, line 3, column `time [s]`: NaN")
        );
    }

    #[test]
    fn files_of_several_bodies_are_named() {
        let mut two = history(2);
        two.names.push("block".into());
        two.bodies.push(two.bodies[0].clone());
        two.bodies[1][0].vertical = f64::NAN;
        assert!(validate_history(&two).unwrap_err().starts_with("forces_block.csv, line 2"));
    }
}
