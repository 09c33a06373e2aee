//! A motion from a table: displacements or speeds over time.

use super::data_file::{self, FileProblem, problem};
use super::names::nearest;
use super::quantity::{ANGLE, LENGTH, Measure, SPEED, TIME, TURN_RATE, unit_size};
use super::table_file::{TableColumn, TableFile, plain_name};
use mechanics::Course;
use std::path::Path;

/// Largest file that is read [bytes].
const MAX_BYTES: u64 = 8 << 20;

/// A motion that was read.
#[derive(Debug)]
pub struct TabledMotion {
    /// The motion over time.
    pub course: Course,
    /// Remarks on how the table was read.
    pub remarks: Vec<String>,
}

/// What a column can be; a sign is −1 where it counts against the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Meaning {
    Time,
    Way(f64),
    Rate(f64),
}

const TIMES: &[&str] = &["time", "t", "elapsed time", "time since start"];
/// Names of displacements and speeds by the number of a motion, and those that count downwards.
const NAMES: [[&[&str]; 2]; 6] = [
    [
        &["displacement", "displacement u", "u", "x", "travel", "distance", "position"],
        &["speed", "velocity", "v", "forward speed", "tow speed"],
    ],
    [
        &["displacement", "lateral displacement", "y", "travel", "distance", "position"],
        &["speed", "velocity", "v", "lateral speed"],
    ],
    [&["displacement", "z", "elevation", "height", "heave"], &["speed", "velocity", "v", "heave speed"]],
    [
        &["angle", "yaw", "yaw angle", "rotation", "displacement"],
        &["rate", "yaw rate", "turn rate", "speed", "omega", "ω", "angular velocity"],
    ],
    [
        &["angle", "tilt", "tilt angle", "rotation", "displacement"],
        &["rate", "tilt rate", "speed", "omega", "ω", "angular velocity"],
    ],
    [
        &["angle", "rotation", "spin angle", "displacement"],
        &["rate", "spin", "speed", "omega", "ω", "angular velocity"],
    ],
];
const HEAVE: usize = 2;
const DOWN: [&[&str]; 2] = [
    &["sinkage", "sinkage z", "depth", "penetration", "penetration depth", "indentation", "settlement"],
    &["penetration rate", "penetration speed", "sinkage rate", "settlement rate"],
];

/// The measures of displacement and speed of a motion, by its number.
fn measures(motion: usize) -> [Measure; 2] {
    if motion < 3 { [LENGTH, SPEED] } else { [ANGLE, TURN_RATE] }
}

fn meaning(name: &str, motion: usize) -> Option<Meaning> {
    let plain = plain_name(name);
    let is_in = |names: &[&str]| names.iter().any(|known| plain_name(known) == plain);
    let [ways, rates] = NAMES[motion];
    match () {
        () if is_in(TIMES) => Some(Meaning::Time),
        () if is_in(ways) => Some(Meaning::Way(1.0)),
        () if is_in(rates) => Some(Meaning::Rate(1.0)),
        () if motion == HEAVE && is_in(DOWN[0]) => Some(Meaning::Way(-1.0)),
        () if motion == HEAVE && is_in(DOWN[1]) => Some(Meaning::Rate(-1.0)),
        () => None,
    }
}

/// Every name that a column of a motion can have.
fn all_names(motion: usize) -> impl Iterator<Item = &'static str> {
    let down = if motion == HEAVE { DOWN } else { [&[][..]; 2] };
    [TIMES].into_iter().chain(NAMES[motion]).chain(down).flatten().copied()
}

fn size(meaning: Meaning, unit: &str, motion: usize) -> Result<f64, String> {
    let [way, rate] = measures(motion);
    match meaning {
        Meaning::Time => unit_size(unit, &TIME),
        Meaning::Way(sign) => unit_size(unit, &way).map(|size| sign * size),
        Meaning::Rate(sign) => unit_size(unit, &rate).map(|size| sign * size),
    }
}

/// What a header may look like.
fn expected(motion: usize) -> String {
    let [way, rate] = measures(motion).map(|m| m.example.split_once(' ').map_or("", |(_, unit)| unit));
    let [ways, rates] = NAMES[motion].map(|names| names.join(", "));
    let down = if motion == HEAVE { format!("; downwards {}", DOWN[0].join(", ")) } else { String::new() };
    format!(
        "name a time and a displacement or a speed, each with its unit: time [s],{} [{way}] or time [s],{} [{rate}]; known are {ways}{down}; {rates}",
        NAMES[motion][0][0], NAMES[motion][1][0]
    )
}

/// A column that was chosen: its number, and how many SI units its unit is.
type Chosen = (usize, f64, Meaning);

/// Reads a table for a motion, by its number in [`case::resolved::MOTIONS`]; its times count from its first
/// line if that is the start.
///
/// # Errors
/// [`FileProblem`] says what is wrong with the file, and in which line.
pub fn read(path: &Path, motion: usize, begins_with_first: bool) -> Result<TabledMotion, FileProblem> {
    let table = TableFile::read(data_file::bytes(path, MAX_BYTES, "give it fewer lines")?)?;
    let mut remarks: Vec<String> = table.remark().map(str::to_owned).into_iter().collect();
    let [time, value] = choose(&table, motion, &mut remarks)?;
    let mut body = table.numbers(&[time.0, value.0], "give every line a time and a value, or leave it out");
    if !body.problems.is_empty() {
        return Err(table.in_words(body.problems.swap_remove(0)));
    }
    remarks.extend(body.remark.take());
    let [mut times, mut values] = [0, 1].map(|n| std::mem::take(&mut body.columns[n]));
    times.iter_mut().for_each(|number| *number *= time.1);
    values.iter_mut().for_each(|number| *number *= value.1);
    if let Some(n) = times.windows(2).position(|pair| pair[1] <= pair[0]) {
        let line = table.line_of(body.lines[n + 1]);
        return problem(
            format!("line {line}: the time does not rise"),
            "sort the lines by time, each time once",
        );
    }
    if begins_with_first {
        let first = times.first().copied().unwrap_or_default();
        times.iter_mut().for_each(|time| *time -= first);
    }
    let course = match value.2 {
        Meaning::Rate(_) => Course::with_speeds(times, values),
        _ => Course::through(times, values),
    };
    match course {
        Some(course) => Ok(TabledMotion { course, remarks }),
        None => problem("it has fewer than two lines of numbers", "give it two or more"),
    }
}

/// The columns of time and motion.
fn choose(table: &TableFile, motion: usize, remarks: &mut Vec<String>) -> Result<[Chosen; 2], FileProblem> {
    let mut found: Vec<Chosen> = Vec::new();
    let (mut others, mut wrong) = (Vec::new(), None);
    for (n, column) in table.columns().iter().enumerate() {
        match of_column(column, motion) {
            Ok(Some((meaning, size))) => found.push((n, size, meaning)),
            Ok(None) => others.push(n),
            // A log may have a speed of something else.
            Err(problem) => {
                others.push(n);
                wrong.get_or_insert(problem);
            }
        }
    }
    let first_of = |wanted: fn(&Meaning) -> bool| {
        let mut all = found.iter().filter(|chosen| wanted(&chosen.2));
        match (all.next(), all.next()) {
            (Some(one), None) => Ok(Some(*one)),
            (Some(one), Some(other)) => {
                let [one, other] = [one.0, other.0].map(|n| &table.columns()[n].title);
                problem(format!("\"{one}\" and \"{other}\" are the same"), "leave one of the two out")
            }
            (None, _) => Ok(None),
        }
    };
    let time = first_of(|meaning| *meaning == Meaning::Time)?;
    let way = first_of(|meaning| matches!(meaning, Meaning::Way(_)))?;
    let rate = first_of(|meaning| matches!(meaning, Meaning::Rate(_)))?;
    // Of a log with both the displacement counts, which needs no sum.
    let (Some(time), Some(value)) = (time, way.or(rate)) else {
        return Err(wrong.unwrap_or_else(|| lacking(table, motion, time.is_some())));
    };
    others.extend(way.and(rate).map(|rate| rate.0));
    let titles: Vec<String> = others
        .iter()
        .filter(|n| !table.columns()[**n].title.is_empty())
        .map(|n| format!("\"{}\"", table.columns()[*n].title))
        .collect();
    if !titles.is_empty() {
        let title = &table.columns()[value.0].title;
        remarks.push(format!("follows \"{title}\"; left out: {}", titles.join(", ")));
    }
    if matches!(value.2, Meaning::Way(sign) | Meaning::Rate(sign) if sign < 0.0) {
        remarks.push(format!(
            "\"{}\" counts downwards, a heave upwards: its sign was turned",
            table.columns()[value.0].title
        ));
    }
    Ok([time, value])
}

/// What a column is, and how many SI units its unit is; `None` where its name says nothing of this motion.
fn of_column(column: &TableColumn, motion: usize) -> Result<Option<(Meaning, f64)>, FileProblem> {
    let known = |name: &str| meaning(name, motion);
    let fits = |meaning: &Meaning, unit: &str| size(*meaning, unit, motion).is_ok();
    let Some((meaning, unit)) = column.meaning(known, fits) else { return Ok(None) };
    let Some(unit) = unit else {
        return problem(format!("the column \"{}\" has no unit", column.title), expected(motion));
    };
    match size(meaning, unit, motion) {
        Ok(size) => Ok(Some((meaning, size))),
        Err(why) => problem(format!("the column \"{}\": {why}", column.title), expected(motion)),
    }
}

/// What is missing in a header, with the names that are near to those that are there.
fn lacking(table: &TableFile, motion: usize, has_time: bool) -> FileProblem {
    let what = if has_time { "a displacement or a speed of this motion" } else { "a time" };
    let message = match table.columns() {
        [] if table.text().trim().is_empty() => "it is empty".to_owned(),
        [] => "it has no header that names its columns".to_owned(),
        _ => format!("none of its columns, {}, is {what}", table.titles()),
    };
    let near = table.columns().iter().find_map(|column| {
        let has_unit = |name: &&str| {
            let unit = column.unit.as_deref().unwrap_or_default();
            meaning(name, motion).is_some_and(|meaning| size(meaning, unit, motion).is_ok())
        };
        // What is like a single letter is like nothing.
        let words = all_names(motion).filter(|name| name.len() > 2).filter(has_unit);
        let is_unknown = column.name.len() > 2 && meaning(&column.name, motion).is_none();
        nearest(&column.name, words).filter(|_| is_unknown)
    });
    let hint = near.map_or(String::new(), |near| format!("did you mean `{near}`? "));
    FileProblem { message, cure: format!("{hint}{}", expected(motion)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str, motion: usize) -> Result<TabledMotion, FileProblem> {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), text).unwrap();
        read(file.path(), motion, false)
    }

    fn displacement(text: &str, motion: usize, time: f64) -> f64 {
        table(text, motion).unwrap_or_else(|error| panic!("{text}: {error:?}")).course.displacement(time)
    }

    #[test]
    fn units_are_those_of_the_header() {
        let moved = displacement("# a press\ntime [ms],displacement [mm]\n0,0\n500,-20\n", 2, 0.5);
        assert!((moved + 0.02).abs() < 1e-15);
        let turned = displacement("t [s]; rate (deg/s)\n0; 0\n2; 180\n", 5, 2.0);
        assert!((turned - std::f64::consts::PI).abs() < 1e-12);
    }

    #[test]
    fn the_name_of_a_column_gives_the_sign() {
        for (name, motion, sign) in [
            ("displacement", 0, 1.0),
            ("displacement u", 0, 1.0),
            ("y", 1, 1.0),
            ("displacement", 2, 1.0),
            ("z", 2, 1.0),
            ("elevation", 2, 1.0),
            ("sinkage", 2, -1.0),
            ("Depth", 2, -1.0),
            ("penetration", 2, -1.0),
            ("settlement", 2, -1.0),
            ("sinkage z", 2, -1.0),
        ] {
            let text = format!("time [s],{name} [mm]\n0,0\n0.5,25\n");
            let read = displacement(&text, motion, 0.5);
            assert!((read - sign * 0.025).abs() < 1e-15, "{name}: {read}");
        }
        assert!(displacement("time [s],penetration rate [mm/s]\n0,0\n1,10\n", 2, 1.0) < 0.0);
    }

    #[test]
    fn the_history_of_a_run_is_a_motion() {
        let text = "time [s],displacement u [m],sinkage z [m],drag F_H [N],rotation [rad],speed [m/s]\n\
                    0,0,0.01,0,0,0\n1,0.2,0.03,5,-0.4,0.1\n";
        for (motion, moved) in [(0, 0.2), (2, -0.02), (5, -0.4)] {
            let read = table(text, motion).unwrap();
            assert!((read.course.displacement(1.0) - moved).abs() < 1e-15, "{motion}");
            assert!(
                read.remarks.iter().any(|remark| remark.contains("\"drag F_H [N]\"")),
                "{:?}",
                read.remarks
            );
        }
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        for (text, message, cure) in [
            ("", "empty", "time [s],displacement"),
            ("0,0\n1,1\n", "no header", "time [s],displacement"),
            ("time,displacement\n0,0\n1,1\n", "\"time\" has no unit", "time [s],displacement"),
            ("time [s],force [N]\n0,0\n1,1\n", "\"force [N]\", is a displacement or a speed", "sinkage"),
            ("time [s],foo [mm]\n0,0\n1,1\n", "\"foo [mm]\", is a displacement or a speed", "known are"),
            ("time [s],displacment [mm]\n0,0\n1,1\n", "is a displacement", "did you mean `displacement`?"),
            ("seconds [s],displacement [mm]\n0,0\n1,1\n", "is a time", "time [s]"),
            ("time [s],displacement [N]\n0,0\n1,1\n", "[N] is not a unit of a length", "time [s]"),
            ("time [mm],displacement [mm]\n0,0\n1,1\n", "[mm] is not a unit of a time", "time [s]"),
            ("time [s],z [mm],depth [mm]\n0,0,0\n1,1,1\n", "are the same", "leave one"),
            ("time [s],displacement [mm]\n0,0\n", "fewer than two", "two"),
            ("time [s],displacement [mm]\n0,0\n1,a\n", "line 3", "12.5"),
            ("time [s],displacement [mm]\r\n0,0\r\n1,nan\r\n", "line 3", "a time and a value"),
            ("time [s],displacement [mm]\r1,0\r0.5,1\r", "line 3: the time does not rise", "sort"),
            ("time [s],displacement [mm]\n1,0\n2\n", "line 3: 1 fields", "every line"),
        ] {
            let refused = table(text, 2).unwrap_err();
            assert!(refused.message.contains(message), "{text}: {refused:?}");
            assert!(refused.cure.contains(cure), "{text}: {refused:?}");
        }
    }

    #[test]
    fn times_may_count_from_the_first_line() {
        let file = tempfile::NamedTempFile::new().unwrap();
        std::fs::write(file.path(), "time [s];z [mm]\n1700000000,5;0\n1700000001,5;-10\n").unwrap();
        let read = read(file.path(), 2, true).unwrap();
        assert_eq!(read.course.span(), [0.0, 1.0]);
        assert!(read.remarks.iter().any(|remark| remark.contains("decimal commas")));
    }
}
