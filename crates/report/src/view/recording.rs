//! What the field files of a run show: the soil surface and the bodies at some times.

use super::lattice::lattice;
use super::solid::{RecordedBody, read_body};
use super::surface::SurfaceAtTime;
use results::files::{Inside, LISTS, OutputError};
use results::folder::RunRecord;
use results::history::History;
use results::vtk::{TimedFile, read_time_list};
use std::path::Path;

/// How much of a run is shown.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Detail {
    /// Most times.
    pub(crate) times: usize,
    /// Most places of the surface.
    pub(crate) places: usize,
    /// Most triangles of a body.
    pub(crate) triangles: usize,
}

impl Detail {
    /// What a page can hold (chosen: about a megabyte; some ten thousand quadrilaterals are drawn smoothly).
    pub(crate) const PAGE: Self = Self { times: 40, places: 12_000, triangles: 12_000 };
}

/// The soil surface and the bodies over time. Lengths in metres.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Recording {
    /// Times [s].
    pub(crate) times: Vec<f64>,
    /// Places along x and y, the same at all times.
    pub(crate) places: [Vec<f64>; 2],
    /// Heights at each time, x fastest; not-a-number where there is no ground.
    pub(crate) heights: Vec<Vec<f64>>,
    /// Height of the undisturbed surface; of a heap that of the floor.
    pub(crate) level: f64,
    /// Whether the soil is heaped on a floor, and its height that above the floor.
    pub(crate) heaped: bool,
    pub(crate) bodies: Vec<RecordedBody>,
    /// How many times there are in the field files.
    pub(crate) recorded: usize,
}

impl Recording {
    /// Reads the recording of a results folder; `None` where there are no field files.
    ///
    /// # Errors
    /// When a field file is missing or damaged.
    pub(crate) fn read(dir: &Path, record: &RunRecord, detail: Detail) -> Result<Option<Self>, OutputError> {
        let [_, surfaces, solids] = LISTS;
        let listed = read_time_list(&Inside::of(dir, surfaces))?;
        let files = spread(&listed, detail.times);
        // Of a slab in plane strain; any width will do for a run without a body.
        let width = record.bodies.first().map_or(record.finest_cell, |body| body.width);
        let read =
            |file: &&TimedFile| SurfaceAtTime::read(&Inside::of(dir, &file.file), width, record.symmetric_x);
        let surfaces = files.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        let Some(first) = surfaces.first() else { return Ok(None) };
        let bodies = read_bodies(dir, record, (&files, &read_time_list(&Inside::of(dir, solids))?), detail)?;
        let reach = bodies.iter().fold([[f64::INFINITY, f64::NEG_INFINITY]; 2], |all, body| {
            [0, 1].map(|n| [all[n][0].min(body.reach[n][0]), all[n][1].max(body.reach[n][1])])
        });
        let [x, y] = lattice(&surfaces, reach, detail.places);
        let heights = |surface: &SurfaceAtTime| {
            y.iter().flat_map(|y| x.iter().map(move |x| surface.at([*x, *y]))).collect::<Vec<f64>>()
        };
        Ok(Some(Self {
            times: files.iter().map(|file| file.time).collect(),
            heights: surfaces.iter().map(heights).collect(),
            level: first.level,
            heaped: record.heaped,
            recorded: listed.len(),
            places: [x, y],
            bodies,
        }))
    }
}

/// At most so many of a list, evenly spread, the first and the last among them.
fn spread(listed: &[TimedFile], most: usize) -> Vec<&TimedFile> {
    let count = listed.len().min(most);
    (0..count).filter_map(|n| listed.get(n * (listed.len() - 1) / (count - 1).max(1))).collect()
}

/// The bodies that have a surface at all of the chosen times, of those that are listed.
fn read_bodies(
    dir: &Path,
    record: &RunRecord,
    (times, listed): (&[&TimedFile], &[TimedFile]),
    detail: Detail,
) -> Result<Vec<RecordedBody>, OutputError> {
    let mut bodies = Vec::new();
    for (number, body) in record.bodies.iter().enumerate() {
        let at = |time: f64| listed.iter().find(|file| file.part == number && file.time == time);
        let files = times.iter().map(|time| at(time.time).map(|file| Inside::of(dir, &file.file)));
        if let Some(files) = files.collect::<Option<Vec<Inside>>>() {
            bodies.extend(read_body(&body.name, &files, detail.triangles)?);
        }
    }
    Ok(bodies)
}

/// The displacement of the first body that touches the soil at some times, between those of its samples [m];
/// none without such a body.
pub(crate) fn displacements(record: &RunRecord, history: &History, times: &[f64]) -> Vec<f64> {
    let mut bodies = record.bodies.iter().zip(&history.bodies);
    let Some((_, samples)) = bodies.find(|(reference, _)| reference.has_surface()) else { return Vec::new() };
    let at = |time: &f64| {
        let n = samples.partition_point(|sample| sample.time < time * (1.0 - 1e-9));
        samples.get(n).or(samples.last()).map_or(0.0, |sample| sample.displacement)
    };
    times.iter().map(at).map(|u| (1e6 * u).round() / 1e6).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_spread_evenly() {
        let file = |n: u32| TimedFile { time: f64::from(n), part: 0, file: String::new() };
        let times = |count: u32| {
            let listed: Vec<TimedFile> = (0..count).map(file).collect();
            spread(&listed, 40).iter().map(|file| file.time).collect::<Vec<f64>>()
        };
        let many = times(1000);
        assert_eq!((many.len(), many[0], many[39]), (40, 0.0, 999.0));
        assert_eq!((times(0).len(), times(1), times(2)), (0, vec![0.0], vec![0.0, 1.0]));
    }
}
