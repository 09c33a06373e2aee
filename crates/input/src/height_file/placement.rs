//! Where the heights of a file lie in the case.

use crate::data_file::{FileProblem, problem};

/// Largest number of heights: 32 MB in memory.
pub(super) const MOST_HEIGHTS: usize = 4_000_000;
/// What to do about a file with too many heights.
pub(super) const TOO_MANY: &str =
    "cut out the part that the domain covers, or make its points fewer: a fifth of a cell apart is enough";

/// How a case places the heights of a file. Lengths in metres.
#[derive(Clone, Copy, Debug, Default)]
pub struct Placement {
    /// Unit of the heights of a file that does not name it.
    pub unit: Option<f64>,
    /// Positions of the first and the last column and row of a file that does not know them.
    pub ends: [Option<[f64; 2]>; 2],
    /// Heights of black and white.
    pub heights: Option<[f64; 2]>,
    /// Place of x = y = 0 of the case in the coordinates of the file.
    pub origin: Option<[f64; 2]>,
    /// Height in the file of the level surface.
    pub datum: f64,
}

/// Heights at the crossings of lines across x and y, x fastest, both increasing [m].
#[derive(Debug)]
pub(crate) struct Raster {
    pub(crate) lines: [Vec<f64>; 2],
    pub(crate) heights: Vec<f64>,
}

impl Placement {
    /// A key of the section that this kind of file needs.
    pub(super) fn needed<T>(value: Option<T>, key: &str, why: &str) -> Result<T, FileProblem> {
        value.map_or_else(
            || {
                problem(
                    format!("{why}, and height_map.{key} is not given"),
                    format!("add  {key} = {}  to [height_map]", example(key)),
                )
            },
            Ok,
        )
    }

    /// Refuses a key that has no effect on this kind of file.
    pub(super) fn no_effect(is_given: bool, key: &str, why: &str) -> Result<(), FileProblem> {
        if is_given {
            return problem(format!("height_map.{key} has no effect: {why}"), format!("remove `{key}`"));
        }
        Ok(())
    }

    /// The unit of a file that cannot name one [m]: metres unless the case says otherwise.
    pub(super) fn in_metres(&self, remarks: &mut Vec<String>) -> f64 {
        self.unit.unwrap_or_else(|| {
            remarks.push("it names no unit: taken as metres; height_map.unit says otherwise".to_owned());
            1.0
        })
    }

    /// Positions of the lines along both axes of a file that holds heights alone.
    pub(super) fn lines(&self, size: [usize; 2], why: &str) -> Result<[Vec<f64>; 2], FileProblem> {
        Self::no_effect(self.origin.is_some(), "origin", "the file has no coordinates")?;
        let along = |axis: usize| {
            let [first, last] = Self::needed(self.ends[axis], ["x", "y"][axis], why)?;
            Ok(evenly(first, last, size[axis]))
        };
        Ok([along(0)?, along(1)?])
    }

    /// Refuses ends of a file that knows its coordinates.
    pub(super) fn knows_places(&self) -> Result<(), FileProblem> {
        for (ends, key) in self.ends.iter().zip(["x", "y"]) {
            Self::no_effect(ends.is_some(), key, "the file says where its points lie")?;
        }
        Ok(())
    }
}

/// Positions of `count` lines, evenly spaced from the first to the last [m].
fn evenly(first: f64, last: f64, count: usize) -> Vec<f64> {
    let steps = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|n| first + (last - first) * n as f64 / steps).collect()
}

/// Refuses images and grids that have fewer than two points along an axis, or too many.
pub(super) fn require_size([columns, rows]: [usize; 2]) -> Result<(), FileProblem> {
    if columns < 2 || rows < 2 {
        let message = format!("it has {columns} × {rows} points");
        return problem(message, "a map needs two points or more along x and y");
    }
    match columns.checked_mul(rows) {
        Some(count) if count <= MOST_HEIGHTS => Ok(()),
        _ => problem(
            format!("it has {columns} × {rows} points, at most {MOST_HEIGHTS} are possible"),
            TOO_MANY,
        ),
    }
}

/// Heights whose first row is that of the largest y, as in an image, the other way round.
pub(super) fn turned(heights: &[f64], columns: usize) -> Vec<f64> {
    heights.chunks_exact(columns).rev().flatten().copied().collect()
}

fn example(key: &str) -> &'static str {
    match key {
        "unit" => "\"m\"",
        "heights" => "[\"-20 mm\", \"20 mm\"]",
        _ => "[\"-1 m\", \"1 m\"]",
    }
}
