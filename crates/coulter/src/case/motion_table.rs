//! A motion from a CSV file: displacements or speeds over time.

use super::data_file::{self, FileProblem, problem, unit};
use super::quantity::{self, Measure, TIME};
use mechanics::Course;
use std::path::Path;

/// Largest file that is read [bytes].
const MAX_BYTES: u64 = 8 << 20;

/// Reads a table of times and displacements, or of times and speeds, in these measures.
///
/// # Errors
/// [`FileProblem`] says what is wrong with the file, and in which line.
pub(super) fn read(path: &Path, measures: [&Measure; 2]) -> Result<Course, FileProblem> {
    let [way, rate] = measures;
    let header = format!(
        "its first line must name two columns with their units: time [s],displacement [{}] or time [s],speed [{}]",
        unit_of(way),
        unit_of(rate)
    );
    let text = data_file::text(data_file::bytes(path, (MAX_BYTES, "give it fewer lines"))?)?;
    let mut lines = data_file::lines(&text, true);
    let names =
        lines.headers().map_err(|error| FileProblem { message: error.to_string(), cure: header.clone() })?;
    let units: Vec<Option<&str>> = names.iter().map(unit).collect();
    let [Some(time_unit), Some(value_unit)] = units[..] else {
        return problem(
            format!("its first line is \"{}\"", names.iter().collect::<Vec<_>>().join(",")),
            header,
        );
    };
    let factor = |unit: &str, measure: &Measure| quantity::parse(&format!("1 {unit}"), measure).ok();
    let Some(seconds) = factor(time_unit, &TIME) else {
        return problem(format!("[{time_unit}] is not a unit of time"), header);
    };
    let (scale, is_speed) = match (factor(value_unit, way), factor(value_unit, rate)) {
        (Some(scale), _) => (scale, false),
        (None, Some(scale)) => (scale, true),
        (None, None) => {
            return problem(format!("[{value_unit}] is not a unit of {} or {}", way.name, rate.name), header);
        }
    };
    let (times, values) = columns(&mut lines, [seconds, scale])?;
    let course = if is_speed { Course::with_speeds(times, values) } else { Course::through(times, values) };
    course.map_or_else(|| problem("it has fewer than two lines of numbers", "give it two or more"), Ok)
}

/// The lines of two numbers, in SI units: times, which rise, and values.
fn columns(
    lines: &mut csv::Reader<&[u8]>,
    [seconds, scale]: [f64; 2],
) -> Result<(Vec<f64>, Vec<f64>), FileProblem> {
    let (mut times, mut values) = (Vec::new(), Vec::new());
    for record in lines.records() {
        let record = record.map_err(|error| FileProblem {
            message: error.to_string(),
            cure: "give every line two numbers".to_owned(),
        })?;
        let line = record.position().map_or(0, csv::Position::line);
        let numbers = record.iter().filter_map(|field| field.parse().ok());
        let numbers: Vec<f64> = numbers.filter(|number: &f64| number.is_finite()).collect();
        let [time, value] = numbers[..] else {
            let found = record.iter().collect::<Vec<_>>().join(",");
            return problem(
                format!("line {line}: \"{found}\" is not two numbers"),
                "give every line a time and a value",
            );
        };
        if times.last().is_some_and(|last| seconds * time <= *last) {
            return problem(format!("line {line}: the time does not rise"), "sort the lines by time");
        }
        times.push(seconds * time);
        values.push(scale * value);
    }
    Ok((times, values))
}

fn unit_of(measure: &Measure) -> &str {
    measure.example.split_once(' ').map_or("", |(_, unit)| unit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::quantity::{ANGLE, LENGTH, SPEED, TURN_RATE};

    fn table(text: &str, measures: [&Measure; 2]) -> Result<Course, FileProblem> {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), text).unwrap();
        read(file.path(), measures)
    }

    #[test]
    fn units_are_those_of_the_header() {
        let course =
            table("# a press\ntime [ms],displacement [mm]\n0,0\n500,-20\n", [&LENGTH, &SPEED]).unwrap();
        assert!((course.displacement(0.5) + 0.02).abs() < 1e-15);
        let course = table("t [s]; rate [deg/s]\n0; 0\n2; 180\n", [&ANGLE, &TURN_RATE]).unwrap();
        assert!((course.speed(1.0) - 0.5 * std::f64::consts::PI).abs() < 1e-12);
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        for (text, message) in [
            ("", "its first line"),
            ("time,displacement\n0,0\n1,1\n", "its first line"),
            ("time [s],force [N]\n0,0\n1,1\n", "[N] is not a unit of a length or a speed"),
            ("time [mm],displacement [mm]\n0,0\n1,1\n", "[mm] is not a unit of time"),
            ("time [s],displacement [mm]\n0,0\n", "fewer than two"),
            ("time [s],displacement [mm]\n0,0\n1,a\n", "line 3"),
            ("time [s],displacement [mm]\n0,0\n1,nan\n", "line 3"),
            ("time [s],displacement [mm]\n1,0\n0.5,1\n", "line 3: the time does not rise"),
            ("time [s],displacement [mm]\n1,0\n2\n", "line"),
        ] {
            let refused = table(text, [&LENGTH, &SPEED]).unwrap_err();
            assert!(refused.message.contains(message), "{text}: {refused:?}");
        }
    }
}
