//! Measured points of a chart: tables whose columns are called as those of the chart.

use super::factor::Factor;
use super::keys::table;
use crate::files;
use crate::history_columns;
use crate::responses::responses;
use coulter::case::form::{Entry, Problems, join, section};
use coulter::case::quantity::{Dimension, parse_any};
use coulter::case::table_file::{TableFile, TableText, plain_name};
use std::path::{Path, PathBuf};

/// Largest file that is read [bytes].
const MOST_BYTES: u64 = 16 << 20;
const CURE: &str = "name its columns as the chart does, with units: Z [-],F_H_bar [-]";

/// Measured points of a chart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeasuredPoints {
    /// Name of the points in the legend.
    pub label: String,
    /// Bytes of the file, of which the folder of the study has a copy.
    pub bytes: Vec<u8>,
    /// Values along x and y, in the units of the chart.
    pub points: Vec<[f64; 2]>,
    /// Low and high ends of the intervals of x and of y, where the file has them.
    pub ends: [Option<Vec<[f64; 2]>>; 2],
}

/// Where the files are.
#[derive(Clone, Copy)]
pub(super) enum Whence<'a> {
    /// Files where the study file says, from this folder.
    Named(&'a Path),
    /// The copies in the folder of a study.
    Copies(&'a Path),
}

/// Name of the copy of a file in the folder of a study.
#[must_use]
pub fn copy_name(chart: &str, number: usize) -> String {
    format!("measured/{chart}_{}.csv", number + 1)
}

/// A column of a chart: its name and its unit.
struct Wanted {
    name: String,
    unit: String,
}

/// A chart and what its axes are.
pub(super) struct Axes<'a> {
    pub(super) chart: &'a str,
    pub(super) columns: [&'a str; 2],
    pub(super) is_history: bool,
}

/// The measured points of a chart; what is wrong with them is reported.
pub(super) fn read(
    axes: &Axes<'_>,
    entries: &[Entry],
    whence: Whence<'_>,
    factors: &[Factor],
    problems: &mut Problems,
) -> Vec<MeasuredPoints> {
    let path = join("chart", axes.chart);
    let read = section(entries, &table("chart"), &path, &[], &mut Problems::default());
    let names = read.words("measured").unwrap_or_default();
    let labels = read.words("measured_labels").unwrap_or_default();
    if read.has("measured_labels") && labels.len() != names.len() {
        let message = format!("{} labels of {} measured tables", labels.len(), names.len());
        problems.add(read.at("measured_labels"), message, "give every table a label");
    }
    let wanted = axes.columns.map(|name| unit_of(name, axes.is_history, factors));
    // What the chart lacks is reported there.
    let [Some(x), Some(y)] = wanted else { return Vec::new() };
    let mut found = Vec::new();
    for (n, name) in names.iter().enumerate() {
        let file = match whence {
            Whence::Named(folder) => folder.join(name),
            Whence::Copies(folder) => folder.join(copy_name(axes.chart, n)),
        };
        match bytes(&file).and_then(|bytes| points(bytes, [&x, &y])) {
            Ok(mut points) => {
                let stem = PathBuf::from(name).file_stem().map(|stem| stem.to_string_lossy().into_owned());
                points.label = labels.get(n).cloned().or(stem).unwrap_or_default();
                found.push(points);
            }
            Err([message, cure]) => {
                problems.add(format!("{path}.measured[{n}]"), format!("{name}: {message}"), cure);
            }
        }
    }
    found
}

/// A column of the chart with its unit; `None` where there is no such column of numbers.
fn unit_of(name: &str, is_history: bool, factors: &[Factor]) -> Option<Wanted> {
    let unit = if is_history {
        history_columns::find(name)?.unit.to_owned()
    } else if let Some(factor) = factors.iter().find(|factor| factor.name == name) {
        factor.unit.as_ref()?.symbol.clone()
    } else {
        responses().into_iter().find(|response| response.name == name)?.unit.to_owned()
    };
    Some(Wanted { name: name.to_owned(), unit })
}

/// The bytes of a file; message and cure where there are none.
fn bytes(path: &Path) -> Result<Vec<u8>, [String; 2]> {
    files::read(path, MOST_BYTES).map_err(|error| {
        [error.to_string(), "check the path, which is relative to the folder of the study".to_owned()]
    })
}

/// The points of a file; message and cure where it has none.
fn points(bytes: Vec<u8>, [x, y]: [&Wanted; 2]) -> Result<MeasuredPoints, [String; 2]> {
    let text = TableText::decode(bytes.clone()).map_err(|error| [error.message, error.cure])?;
    let file = TableFile::new(text);
    let mut found = MeasuredPoints { bytes, ..MeasuredPoints::default() };
    let [xs, ys] = [column(&file, x, "")?, column(&file, y, "")?];
    let lacking = || [format!("it has no column `{}` and `{}`", x.name, y.name), CURE.to_owned()];
    let (xs, ys) = xs.zip(ys).ok_or_else(|| {
        let [message, cure] = lacking();
        [format!("{message}; its columns are {}", file.titles()), cure]
    })?;
    found.points = xs.into_iter().zip(ys).map(|(x, y)| [x, y]).collect();
    for (ends, wanted) in found.ends.iter_mut().zip([x, y]) {
        let [low, high] = [column(&file, wanted, "_low")?, column(&file, wanted, "_high")?];
        *ends = low.zip(high).map(|(low, high)| low.into_iter().zip(high).map(|(l, h)| [l, h]).collect());
    }
    Ok(found)
}

/// The numbers of a column in the unit of the chart; `None` where the file has none of this name.
fn column(file: &TableFile, wanted: &Wanted, ending: &str) -> Result<Option<Vec<f64>>, [String; 2]> {
    let name = plain_name(&format!("{}{ending}", wanted.name));
    let is_wanted = |column: &coulter::case::table_file::TableColumn| plain_name(&column.name) == name;
    let Some(number) = file.columns().iter().position(is_wanted) else { return Ok(None) };
    let title = &file.columns()[number].title;
    let given = file.columns()[number].unit.as_deref().unwrap_or("-");
    let factor = factor(given, &wanted.unit).ok_or_else(|| {
        let message = format!("the column \"{title}\" should have the unit [{}]", wanted.unit);
        [message, format!("write its header as {} [{}]", wanted.name, wanted.unit)]
    })?;
    let mut numbers = file.numbers(&[number], "give a number, or leave the line out");
    if let Some(problem) = numbers.problems.into_iter().next() {
        let problem = file.in_words(problem);
        return Err([problem.message, problem.cure]);
    }
    Ok(numbers.columns.pop().map(|values| values.into_iter().map(|value| factor * value).collect()))
}

/// How many units of the chart a unit of the file is; `None` where they measure different things.
fn factor(given: &str, wanted: &str) -> Option<f64> {
    let size = |unit: &str| match unit {
        "" | "-" | "–" | "1" => Some((1.0, Dimension([0; 4]))),
        "%" => Some((0.01, Dimension([0; 4]))),
        unit => parse_any(&format!("1 {unit}")).ok(),
    };
    if given == wanted {
        return Some(1.0);
    }
    let ((of_given, one), (of_wanted, other)) = (size(given)?, size(wanted)?);
    (one == other).then(|| of_given / of_wanted)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<MeasuredPoints, [String; 2]> {
        let wanted = |name: &str, unit: &str| Wanted { name: name.into(), unit: unit.into() };
        points(text.as_bytes().to_vec(), [&wanted("Z", "-"), &wanted("drag", "N")])
    }

    #[test]
    fn columns_are_found_by_name_and_scaled_to_the_unit_of_the_chart() {
        let found = read("drag [kN],drag_low [kN],drag_high [kN],Z [%]\n0.1,0.05,0.2,20\n").unwrap();
        assert_eq!(found.points, [[0.2, 100.0]]);
        assert_eq!(found.ends, [None, Some(vec![[50.0, 200.0]])]);
    }

    #[test]
    fn what_is_wrong_is_said_with_its_line() {
        for (text, expected) in [
            ("Z [-],lift [N]\n1,2\n", "no column `Z` and `drag`"),
            ("Z [-],drag [m]\n1,2\n", "\"drag [m]\" should have the unit [N]"),
            ("Z [-],drag [N]\n1,2\n2,many\n", "line 3"),
        ] {
            let [message, cure] = read(text).unwrap_err();
            assert!(message.contains(expected) && !cure.is_empty(), "{message}");
        }
    }
}
