//! Numbers that stand for no height.

use super::placement::Raster;
use crate::data_file::{FileProblem, problem};
use crate::quantity::plain;

/// What to do where there is no height.
pub(super) const FILL_IN: &str = "give every point a height: fill in what was not measured, or cut it off";
/// Marks of no height in use: those of GDAL and ESRI programs, and the least whole numbers of 16 bits.
const MARKS: [f64; 5] = [-9999.0, -99999.0, -32767.0, -32768.0, -999_999.0];
/// Size beyond which no unit makes a height of a number: marks such as −3.4e38 and 1e30 (chosen).
const HUGE: f64 = 1e20;
/// Units in which a mark may have been written [m].
const UNITS: [f64; 5] = [1.0, 1e-2, 1e-3, 0.0254, 0.3048];
/// Distance of a height from the others, over the width of the map, beyond which it is none (chosen: no slope
/// is a hundred times as high as wide).
const FAR: f64 = 100.0;
/// Distance of a mark from the others, over their range (chosen).
const APART: f64 = 10.0;

/// Whether a number, as it is written in a file, is a usual mark of no height.
pub(super) fn is_mark(number: f64) -> bool {
    number.abs() >= HUGE || MARKS.contains(&number)
}

/// Refuses a number that stands at a place.
pub(super) fn refuse<T>(number: f64, place: &str) -> Result<T, FileProblem> {
    problem(format!("{place}: is {number} a mark for no height?"), FILL_IN)
}

/// Refuses a map with a height that is a mark, in whatever format: far from all others, or the size of a mark
/// and apart from them. The heights lie over `datum` [m].
pub(super) fn none_in(raster: &Raster, datum: f64) -> Result<(), FileProblem> {
    let mut sorted = raster.heights.clone();
    sorted.sort_by(f64::total_cmp);
    let part = |part: f64| sorted[(part * (sorted.len() - 1) as f64) as usize];
    let (middle, range) = (part(0.5), part(0.95) - part(0.05));
    let width = |axis: usize| {
        let line = &raster.lines[axis];
        line.last().zip(line.first()).map_or(0.0, |(last, first)| last - first)
    };
    let far = FAR * width(0).max(width(1));
    let is_written = |height: f64| {
        let number = |unit: f64| (height + datum) / unit;
        UNITS.iter().any(|unit| MARKS.iter().any(|mark| (number(*unit) - mark).abs() <= 1e-9 * mark.abs()))
    };
    let is_none = |height: &f64| {
        let from_others = (height - middle).abs();
        from_others > far || (from_others > APART * range && is_written(*height))
    };
    // Most maps have none: their ends say so.
    if ![sorted[0], sorted[sorted.len() - 1]].iter().any(is_none) {
        return Ok(());
    }
    let Some(n) = raster.heights.iter().position(is_none) else { return Ok(()) };
    let columns = raster.lines[0].len();
    let [x, y] = [raster.lines[0][n % columns], raster.lines[1][n / columns]].map(plain);
    refuse(
        raster.heights[n] + datum,
        &format!("x = {x} m, y = {y} m (in the case), where the height in metres is far from all others"),
    )
}
