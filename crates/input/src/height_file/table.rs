//! Heights as text: columns of x, y and z, a grid of heights alone, or an ESRI grid.

use super::esri;
use super::marks;
use super::placement::{MOST_HEIGHTS, Placement, Raster, TOO_MANY, require_size, turned};
use super::scattered;
use crate::data_file::{FileProblem, problem};
use crate::quantity::{LENGTH, unit_size};
use crate::table_file::{TableFile, TableText, plain_name};

const HEADER: &str = "name three columns with their units in its first line: x [m],y [m],z [mm]; or give a grid of heights alone, its first \
                      row that of the largest y";

/// The heights that were read, and remarks on how they were read.
pub(super) type Remarked = (Raster, Vec<String>);

/// Reads a table; of points, `.xyz`, also without a header.
pub(super) fn read(
    bytes: Vec<u8>,
    holds_points: bool,
    placement: &Placement,
) -> Result<Remarked, FileProblem> {
    Placement::no_effect(placement.heights.is_some(), "heights", "a table says its heights")?;
    let text = TableText::decode(bytes)?;
    let mut remarks: Vec<String> = text.remark.iter().cloned().collect();
    if esri::is_grid(&text.text) {
        return Ok((esri::read(&text.text, placement, &mut remarks)?, remarks));
    }
    let table = TableFile::new(text);
    let raster = if !table.columns().is_empty() || holds_points {
        points(&table, holds_points, placement, &mut remarks)?
    } else {
        grid(&table, placement, &mut remarks)?
    };
    Ok((raster, remarks))
}

/// A grid of heights alone.
fn grid(table: &TableFile, placement: &Placement, remarks: &mut Vec<String>) -> Result<Raster, FileProblem> {
    const WHY: &str = "its first line holds numbers, so that it is a grid of heights alone";
    if table.lines().next().is_none() {
        return problem("it is empty", HEADER);
    }
    let scale = Placement::needed(placement.unit, "unit", WHY)?;
    let (heights, size, remark) = table.grid(marks::FILL_IN).map_err(|wrong| table.in_words(wrong))?;
    require_size(size)?;
    remarks.extend(remark);
    if let Some(n) = heights.iter().position(|height| marks::is_mark(*height)) {
        let place = format!("column {}, row {} from the top", n % size[0] + 1, n / size[0] + 1);
        return marks::refuse(heights[n], &place);
    }
    let heights: Vec<f64> = heights.iter().map(|z| scale * z - placement.datum).collect();
    Ok(Raster { lines: placement.lines(size, WHY)?, heights: turned(&heights, size[0]) })
}

/// Columns of x, y and z, the points in any order.
fn points(
    table: &TableFile,
    holds_points: bool,
    placement: &Placement,
    remarks: &mut Vec<String>,
) -> Result<Raster, FileProblem> {
    placement.knows_places()?;
    let columns = match table.columns() {
        [] => [(0, None), (1, None), (2, None)],
        _ => axes(table)?,
    };
    let has_units = columns.iter().any(|(_, unit)| unit.is_some());
    if has_units {
        Placement::no_effect(placement.unit.is_some(), "unit", "the header of the file names its units")?;
    }
    let default = if holds_points { Some(placement.in_metres(remarks)) } else { placement.unit };
    let mut scales = [1.0; 3];
    for (scale, (n, unit)) in scales.iter_mut().zip(&columns) {
        let title = || table.columns().get(*n).map_or("", |column| column.title.as_str());
        *scale = match unit {
            Some(size) => *size,
            None if has_units => {
                return problem(format!("\"{}\" names no unit of length", title()), HEADER);
            }
            None => match default {
                Some(size) => size,
                None => return problem(format!("\"{}\" names no unit of length", title()), HEADER),
            },
        };
    }
    let mut body = table.numbers(&columns.map(|(n, _)| n), marks::FILL_IN);
    if !body.problems.is_empty() {
        return Err(table.in_words(body.problems.swap_remove(0)));
    }
    if body.lines.len() > MOST_HEIGHTS {
        return problem(
            format!("it has {} points, at most {MOST_HEIGHTS} are possible", body.lines.len()),
            TOO_MANY,
        );
    }
    remarks.extend(body.remark.take());
    let is_other = |n: &usize| !columns.iter().any(|(column, _)| column == n);
    let others = (0..table.columns().len()).filter(is_other).map(|n| table.columns()[n].title.as_str());
    let others: Vec<String> =
        others.filter(|title| !title.is_empty()).map(|title| format!("\"{title}\"")).collect();
    if !others.is_empty() {
        remarks.push(format!("left out: {}", others.join(", ")));
    }
    if let Some(n) = body.columns[2].iter().position(|height| marks::is_mark(*height)) {
        return marks::refuse(body.columns[2][n], &format!("line {}", table.line_of(body.lines[n])));
    }
    let shifts = placement.origin.unwrap_or_default();
    let shifts = [shifts[0], shifts[1], placement.datum];
    let along = |axis: usize, n: usize| body.columns[axis][n] * scales[axis] - shifts[axis];
    let found: Vec<[f64; 3]> = (0..body.lines.len()).map(|n| [0, 1, 2].map(|axis| along(axis, n))).collect();
    crossings(&found, |n| table.line_of(body.lines[n]), remarks)
}

/// The columns of x, y and z, and how many metres the unit of each is.
fn axes(table: &TableFile) -> Result<[(usize, Option<f64>); 3], FileProblem> {
    const NAMES: [(&str, &[&str]); 3] = [
        ("x", &["x", "easting", "east"]),
        ("y", &["y", "northing", "north"]),
        ("z", &["z", "height", "elevation"]),
    ];
    let mut found = [(0, None); 3];
    for ((axis, names), place) in NAMES.into_iter().zip(&mut found) {
        let named = |name: &str| names.contains(&plain_name(name).as_str()).then_some(());
        let is_length = |(): &(), unit: &str| unit_size(unit, &LENGTH).is_ok();
        let mut columns = table.columns().iter().enumerate();
        let known = columns.find_map(|(n, column)| Some((n, column.meaning(named, is_length)?.1)));
        let Some((n, unit)) = known else {
            let titles = table.titles();
            return problem(format!("its first line, {titles}, names no column {axis}"), HEADER);
        };
        let title = &table.columns()[n].title;
        let size = unit.map(|unit| unit_size(unit, &LENGTH)).transpose();
        let size =
            size.or_else(|why| problem(format!("\"{title}\" names no unit of length: {why}"), HEADER))?;
        *place = (n, size);
    }
    Ok(found)
}

/// Least part of the crossings of a grid that have a point; points that fill less lie on none (chosen).
const LEAST_FILLED: f64 = 0.5;

/// The points on the crossings of lines; those that lie on no grid are interpolated onto one.
fn crossings(
    points: &[[f64; 3]],
    line: impl Fn(usize) -> usize,
    remarks: &mut Vec<String>,
) -> Result<Raster, FileProblem> {
    let positions = |axis: usize| {
        let mut all: Vec<f64> = points.iter().map(|point| point[axis]).collect();
        all.sort_by(f64::total_cmp);
        let extent = all.last().zip(all.first()).map_or(0.0, |(last, first)| last - first);
        // Positions that were rounded as they were written are one.
        all.dedup_by(|next, kept| *next - *kept <= 1e-9 * extent);
        all
    };
    let lines = [positions(0), positions(1)];
    let size = lines.each_ref().map(Vec::len);
    let is_scattered = (points.len() as f64) < LEAST_FILLED * size[0] as f64 * size[1] as f64;
    if is_scattered {
        let (raster, remark) = scattered::gridded(points, line)?;
        remarks.push(remark);
        return Ok(raster);
    }
    require_size(size)?;
    let number = |axis: usize, position: f64| {
        let after = lines[axis].partition_point(|line| *line <= position);
        after.saturating_sub(1)
    };
    let mut heights = vec![f64::NAN; size[0] * size[1]];
    for (n, [x, y, z]) in points.iter().enumerate() {
        let place = &mut heights[number(1, *y) * size[0] + number(0, *x)];
        if !place.is_nan() {
            return problem(
                format!("line {}: a second height at the same place", line(n)),
                "give each place one height",
            );
        }
        *place = *z;
    }
    if let Some(n) = heights.iter().position(|z| z.is_nan()) {
        let [x, y] = [lines[0][n % size[0]], lines[1][n / size[0]]];
        let message = format!(
            "its {} points do not fill a grid of {} × {} places: x = {x:.6} m, y = {y:.6} m (in the case) has no height",
            points.len(),
            size[0],
            size[1]
        );
        return problem(
            message,
            "give a height at every crossing of its lines, or cut off what was not measured",
        );
    }
    Ok(Raster { lines, heights })
}
