//! Heights as an ESRI grid, `.asc`: a header with the number of columns and rows, a corner and the size of a
//! cell, then the heights from the top row down.

use super::marks;
use super::placement::{Placement, Raster, require_size, turned};
use crate::data_file::{FileProblem, problem};
use crate::table_file::{Field, Words, line_of};

const HEADER: &str = "begin with ncols, nrows, xllcorner, yllcorner, cellsize and, if need be, NODATA_value, each with its number in a line";

/// Whether a text begins as such a grid does.
pub(super) fn is_grid(text: &str) -> bool {
    text.split_whitespace().next().is_some_and(|word| word.eq_ignore_ascii_case("ncols"))
}

/// What the header says.
#[derive(Debug, Default)]
struct Header {
    size: [Option<f64>; 2],
    /// The middle of the first column and of the lowest row, or the corner of their cells.
    low: [Option<(f64, bool)>; 2],
    cell: [Option<f64>; 2],
    none: Option<f64>,
}

impl Header {
    /// Takes a number; `false` of a name that is not known.
    fn take(&mut self, name: &str, number: f64) -> bool {
        match name.to_ascii_lowercase().as_str() {
            "ncols" => self.size[0] = Some(number),
            "nrows" => self.size[1] = Some(number),
            "xllcorner" => self.low[0] = Some((number, true)),
            "yllcorner" => self.low[1] = Some((number, true)),
            "xllcenter" => self.low[0] = Some((number, false)),
            "yllcenter" => self.low[1] = Some((number, false)),
            "cellsize" => self.cell = [Some(number); 2],
            "dx" => self.cell[0] = Some(number),
            "dy" => self.cell[1] = Some(number),
            "nodata_value" => self.none = Some(number),
            _ => return false,
        }
        true
    }
}

/// Reads a grid; heights, corners and cells are in `height_map.unit`, metres where that is not given.
pub(super) fn read(
    text: &str,
    placement: &Placement,
    remarks: &mut Vec<String>,
) -> Result<Raster, FileProblem> {
    placement.knows_places()?;
    let mut words = Words::new(text, marks::FILL_IN);
    let header = header(text, &mut words)?;
    let size = header.size.map(|size| size.filter(|n| *n >= 0.0 && n.fract() == 0.0 && *n < 1e9));
    let ([Some(columns), Some(rows)], [Some(x), Some(y)], [Some(dx), Some(dy)]) =
        (size, header.low, header.cell)
    else {
        return problem("its header is not that of an ESRI grid", HEADER);
    };
    let size = [columns as usize, rows as usize];
    require_size(size)?;
    if !(dx > 0.0 && dy > 0.0) {
        return problem("its cells have no size", HEADER);
    }
    let heights = heights(text, &mut words, size, header.none)?;
    remarks.extend(words.remark());
    let unit = placement.in_metres(remarks);
    let origin = placement.origin.unwrap_or_default();
    let line = |axis: usize, (low, is_corner): (f64, bool), cell: f64| {
        let first = low + if is_corner { 0.5 * cell } else { 0.0 };
        (0..size[axis]).map(|n| unit * (first + cell * n as f64) - origin[axis]).collect()
    };
    let heights: Vec<f64> = heights.iter().map(|height| unit * height - placement.datum).collect();
    Ok(Raster { lines: [line(0, x, dx), line(1, y, dy)], heights: turned(&heights, size[0]) })
}

/// The heights in the unit of the file, row by row from the top; `none` stands for no height.
fn heights(
    text: &str,
    words: &mut Words<'_>,
    size: [usize; 2],
    none: Option<f64>,
) -> Result<Vec<f64>, FileProblem> {
    let mut heights = Vec::with_capacity(size[0] * size[1]);
    while let Some(field) = words.next() {
        let n = heights.len();
        let place = || {
            format!(
                "line {}: column {}, row {} from the top",
                line_of(text, field.at.start),
                n % size[0] + 1,
                n / size[0] + 1
            )
        };
        let height = words.number(&field)?;
        if none == Some(height) {
            return problem(format!("{}: no height (NODATA_value {height})", place()), marks::FILL_IN);
        }
        if marks::is_mark(height) {
            return marks::refuse(height, &place());
        }
        heights.push(height);
        if heights.len() > size[0] * size[1] {
            break;
        }
    }
    if heights.len() != size[0] * size[1] {
        let many = if heights.len() > size[0] * size[1] { "more than" } else { "not" };
        return problem(
            format!(
                "it has {many} the {} × {} heights of its header ({} were read)",
                size[0],
                size[1],
                heights.len()
            ),
            "save the grid again",
        );
    }
    Ok(heights)
}

/// The lines of a name and a number.
fn header<'a>(text: &'a str, words: &mut Words<'a>) -> Result<Header, FileProblem> {
    let mut header = Header::default();
    loop {
        let before = words.clone();
        let Some(name) = words.next() else { return Ok(header) };
        if !name.text.starts_with(char::is_alphabetic) || words.is_number(&name) {
            *words = before;
            return Ok(header);
        }
        let number =
            words.next().unwrap_or_else(|| Field { text: "", at: name.at.clone(), is_quoted: false });
        let number = words.number(&number)?;
        if !header.take(name.text, number) {
            let line = line_of(text, name.at.start);
            return problem(
                format!("line {line}: \"{}\" is not known in the header of an ESRI grid", name.text),
                HEADER,
            );
        }
    }
}
