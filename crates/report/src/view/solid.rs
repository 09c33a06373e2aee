//! A body: its surface once, and where it is at each time.

use super::rigid::Tripod;
use glam::{DMat3, DVec3};
use results::files::{Inside, OutputError};
use results::vtk::VtkFile;
use std::collections::HashMap;

/// A body of a recording. Lengths in metres.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RecordedBody {
    pub(crate) name: String,
    /// Points of the surface about the middle of the body, as it was at the start.
    pub(crate) points: Vec<DVec3>,
    pub(crate) triangles: Vec<[usize; 3]>,
    /// Poses of the body by time: the rotation row by row, and where the middle is.
    pub(crate) poses: Vec<[f64; 12]>,
    /// Extent of the body along x and y over all times [m], as low and high ends.
    pub(super) reach: [[f64; 2]; 2],
}

impl RecordedBody {
    /// Whether the body rotates.
    pub(crate) fn turns(&self) -> bool {
        self.poses.iter().any(|pose| (pose[0] - 1.0).abs() > 1e-6)
    }

    /// Lowest and highest coordinates of the points of the body.
    pub(super) fn bounds(&self) -> (DVec3, DVec3) {
        bounds(&self.points)
    }
}

/// Reads a body at all times, with at most so many triangles.
pub(super) fn read_body(
    name: &str,
    files: &[Inside],
    most: usize,
) -> Result<Option<RecordedBody>, OutputError> {
    let Some(first) = files.first() else { return Ok(None) };
    let file = VtkFile::read(first)?;
    let start = triples(&file.numbers("Points")?);
    let corners: Vec<usize> = file.numbers("connectivity")?.iter().map(|n| *n as usize).collect();
    let Some(tripod) = Tripod::of(&start).filter(|_| corners.iter().all(|n| *n < start.len())) else {
        return Err(OutputError::content(&first.path(), "its points are no surface"));
    };
    let (low, high) = bounds(&start);
    let middle = 0.5 * (low + high);
    let (mut poses, mut reach) = (Vec::new(), [[f64::INFINITY, f64::NEG_INFINITY]; 2]);
    for path in files {
        let now = triples(&VtkFile::read(path)?.numbers("Points")?);
        let rotation = tripod.rotation(&start, &now).filter(|_| now.len() == start.len());
        let rotation =
            rotation.ok_or_else(|| OutputError::content(&path.path(), "it shows another surface"))?;
        let (low, high) = bounds(&now);
        for axis in 0..2 {
            reach[axis] = [reach[axis][0].min(low[axis]), reach[axis][1].max(high[axis])];
        }
        poses.push(pose(rotation, now[0] - rotation * (start[0] - middle)));
    }
    let arms: Vec<DVec3> = start.iter().map(|p| *p - middle).collect();
    let triangles = corners.chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect();
    let (points, triangles) = thinned(arms, triangles, most);
    Ok(Some(RecordedBody { name: name.to_owned(), points, triangles, poses, reach }))
}

fn triples(numbers: &[f64]) -> Vec<DVec3> {
    numbers.chunks_exact(3).map(DVec3::from_slice).collect()
}

fn bounds(points: &[DVec3]) -> (DVec3, DVec3) {
    let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    points.iter().fold(ends, |(low, high), p| (low.min(*p), high.max(*p)))
}

/// Rounded: a millionth of a rotation and of a metre cannot be seen.
fn pose(rotation: DMat3, place: DVec3) -> [f64; 12] {
    let rows = rotation.transpose().to_cols_array();
    let number = |n: usize| if n < 9 { rows[n] } else { place[n - 9] };
    std::array::from_fn(|n| (1e6 * number(n)).round() / 1e6)
}

/// A surface of few enough points and triangles: points that are closer than a distance become one.
fn thinned(points: Vec<DVec3>, triangles: Vec<[usize; 3]>, most: usize) -> (Vec<DVec3>, Vec<[usize; 3]>) {
    let is_small = |p: &[DVec3], t: &[[usize; 3]]| t.len() <= most && p.len() <= usize::from(u16::MAX);
    let (low, high) = bounds(&points);
    let mut distance = low.distance(high) / 400.0;
    let (mut few, mut faces) = (points.clone(), triangles.clone());
    while !is_small(&few, &faces) {
        let mut known: HashMap<[i64; 3], usize> = HashMap::new();
        few = Vec::new();
        let numbers: Vec<usize> = points
            .iter()
            .map(|p| {
                let cell = ((*p - low) / distance).floor().to_array().map(|q| q as i64);
                *known.entry(cell).or_insert_with(|| {
                    few.push(*p);
                    few.len() - 1
                })
            })
            .collect();
        let merged = triangles.iter().map(|t| t.map(|n| numbers[n]));
        faces = merged.filter(|[a, b, c]| a != b && b != c && a != c).collect();
        distance *= 1.4;
    }
    (few, faces)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_surfaces_are_thinned_out() {
        let points: Vec<DVec3> =
            (0..40_000).map(|n| DVec3::new(f64::from(n % 200), f64::from(n / 200), 0.0)).collect();
        let quads = (0..39_800).filter(|n| n % 200 != 199);
        let triangles = quads.flat_map(|n| [[n, n + 1, n + 200], [n + 1, n + 201, n + 200]]).collect();
        let (few, faces) = thinned(points, triangles, 12_000);
        assert!(faces.len() <= 12_000 && faces.len() > 1000, "{}", faces.len());
        assert!(faces.iter().flatten().all(|n| *n < few.len()));
    }
}
