//! Heights as CSV: columns of x, y and z whose header names their units, or a grid of heights alone.

use super::placement::{MOST_HEIGHTS, Placement, Raster, TOO_MANY, require_size, turned};
use crate::case::data_file::{self, FileProblem, problem, unit};
use crate::case::quantity::{self, LENGTH};

const HEADER: &str = "name three columns with their units in its first line: x [m],y [m],z [mm]; or give a grid of heights alone, its first \
                      row that of the largest y";

/// Reads a table.
pub(super) fn read(text: &str, placement: &Placement) -> Result<Raster, FileProblem> {
    Placement::no_effect(placement.heights.is_some(), "heights", "a table says its heights")?;
    let first = text.lines().map(str::trim).find(|line| !line.is_empty() && !line.starts_with('#'));
    let Some(first) = first else { return problem("it is empty", HEADER) };
    if first.split([',', ';']).all(|field| field.trim().parse::<f64>().is_ok()) {
        grid(text, placement)
    } else {
        columns(text, placement)
    }
}

/// The numbers of a line.
fn numbers(record: Result<csv::StringRecord, csv::Error>) -> Result<(u64, Vec<f64>), FileProblem> {
    let record = record.map_err(|error| FileProblem {
        message: error.to_string(),
        cure: "give every line as many numbers as the first".to_owned(),
    })?;
    let line = record.position().map_or(0, csv::Position::line);
    let number = |field: &str| field.parse::<f64>().ok().filter(|number| number.is_finite());
    match record.iter().map(number).collect::<Option<Vec<_>>>() {
        Some(numbers) => Ok((line, numbers)),
        None => {
            let found = record.iter().find(|field| number(field).is_none()).unwrap_or_default();
            problem(
                format!("line {line}: \"{found}\" is not a finite number"),
                "give every point a height: fill in what was not measured, or cut it off",
            )
        }
    }
}

/// A grid of heights alone.
fn grid(text: &str, placement: &Placement) -> Result<Raster, FileProblem> {
    const WHY: &str = "its first line holds numbers, so that it is a grid of heights alone";
    let scale = Placement::needed(placement.unit, "unit", WHY)?;
    let (mut heights, mut columns, mut rows) = (Vec::new(), 0, 0);
    for record in data_file::lines(text, false).records() {
        let (_, row) = numbers(record)?;
        columns = row.len();
        heights.extend(row.iter().map(|z| scale * z - placement.datum));
        rows += 1;
        if heights.len() > MOST_HEIGHTS {
            return problem(format!("it has more than {MOST_HEIGHTS} points"), TOO_MANY);
        }
    }
    require_size([columns, rows])?;
    Ok(Raster { lines: placement.lines([columns, rows], WHY)?, heights: turned(&heights, columns) })
}

/// Columns of x, y and z, the points in any order.
fn columns(text: &str, placement: &Placement) -> Result<Raster, FileProblem> {
    placement.knows_places()?;
    Placement::no_effect(placement.unit.is_some(), "unit", "the header of the file names its units")?;
    let mut lines = data_file::lines(text, true);
    let names = lines
        .headers()
        .map_err(|error| FileProblem { message: error.to_string(), cure: HEADER.to_owned() })?;
    let named: Vec<String> = names.iter().map(str::to_owned).collect();
    let shifts = placement.origin.unwrap_or_default();
    let shifts = [shifts[0], shifts[1], placement.datum];
    let mut found = [(0, 0.0); 3];
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let of_axis = |header: &&String| header.split(['[', ' ']).next() == Some(name);
        let Some(column) = named.iter().position(|header| of_axis(&header)) else {
            return problem(
                format!("its first line, \"{}\", names no column {name}", named.join(",")),
                HEADER,
            );
        };
        let scale = unit(&named[column]).and_then(|unit| quantity::parse(&format!("1 {unit}"), &LENGTH).ok());
        let Some(scale) = scale else {
            return problem(format!("\"{}\" names no unit of length", named[column]), HEADER);
        };
        found[axis] = (column, scale);
    }
    let mut points = Vec::new();
    for record in lines.records() {
        let (line, row) = numbers(record)?;
        let along = |axis: usize| row[found[axis].0] * found[axis].1 - shifts[axis];
        points.push((line, [along(0), along(1), along(2)]));
        if points.len() > MOST_HEIGHTS {
            return problem(format!("it has more than {MOST_HEIGHTS} points"), TOO_MANY);
        }
    }
    crossings(&mut points)
}

/// The points on the crossings of lines.
fn crossings(points: &mut [(u64, [f64; 3])]) -> Result<Raster, FileProblem> {
    let positions = |axis: usize| {
        let mut all: Vec<f64> = points.iter().map(|(_, point)| point[axis]).collect();
        all.sort_by(f64::total_cmp);
        let extent = all.last().zip(all.first()).map_or(0.0, |(last, first)| last - first);
        // Positions that were rounded as they were written are one.
        all.dedup_by(|next, kept| *next - *kept <= 1e-9 * extent);
        all
    };
    let lines = [positions(0), positions(1)];
    let size = lines.each_ref().map(Vec::len);
    require_size(size)?;
    let number = |axis: usize, position: f64| {
        let after = lines[axis].partition_point(|line| *line <= position);
        after.saturating_sub(1)
    };
    let mut heights = vec![f64::NAN; size[0] * size[1]];
    for (line, [x, y, z]) in points.iter() {
        let place = &mut heights[number(1, *y) * size[0] + number(0, *x)];
        if !place.is_nan() {
            return problem(
                format!("line {line}: a second height at the same place"),
                "give each place one height",
            );
        }
        *place = *z;
    }
    if let Some(n) = heights.iter().position(|z| z.is_nan()) {
        let [x, y] = [lines[0][n % size[0]], lines[1][n / size[0]]];
        let message = format!(
            "its points do not fill a grid: of {} × {} places, x = {x:.6} m, y = {y:.6} m (in the case) has no height",
            size[0], size[1]
        );
        return problem(
            message,
            "give a height at every crossing of its lines; interpolate scattered points onto a grid first",
        );
    }
    Ok(Raster { lines, heights })
}
