//! The recording of a run as a page holds it.

use super::pack::{packed, words};
use super::recording::{Detail, Recording};
use super::solid::RecordedBody;
use crate::plots::ColourMap;
use glam::DVec3;
use results::files::OutputError;
use results::folder::RunRecord;
use serde::Serialize;
use std::path::Path;

/// Colours of the scale of heights.
const COLOURS: u32 = 32;
/// Steps of sixteen bits.
const STEPS: f64 = 65_535.0;

/// The soil surface and the bodies over time. Lengths in metres.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct SurfaceView {
    /// Times [s].
    pub(crate) times: Vec<f64>,
    /// Displacement of the first body at the recorded times [m]; empty where there is none.
    pub(crate) displacements: Vec<f64>,
    /// Places along x and y.
    x: Vec<f64>,
    y: Vec<f64>,
    /// Height of the undisturbed surface; of a heap that of the floor.
    level: f64,
    /// Whether heights are shown above and below the level.
    levelled: bool,
    low: f64,
    step: f64,
    heights: String,
    /// Colours from the lowest to the highest, six digits each.
    colours: String,
    bodies: Vec<ViewedBody>,
    /// How many times there are in the field files.
    #[serde(skip)]
    pub(crate) recorded: usize,
}

/// A body as the page holds it.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct ViewedBody {
    name: String,
    /// Lowest coordinates, and length of a step [m], about the middle of the body as it was at the start.
    low: [f64; 3],
    step: f64,
    points: String,
    triangles: String,
    /// Poses of the body by time: the rotation row by row, and where the middle is [m].
    poses: Vec<[f64; 12]>,
    /// Whether the body rotates.
    turns: bool,
}

impl SurfaceView {
    /// Reads the view of a results folder; `None` where there are no field files.
    ///
    /// # Errors
    /// When a field file is missing or damaged.
    pub(crate) fn read(dir: &Path, record: &RunRecord) -> Result<Option<Self>, OutputError> {
        Ok(Recording::read(dir, record, Detail::PAGE)?.map(Self::of))
    }

    fn of(recording: Recording) -> Self {
        let packed = packed(&recording.heights);
        let [x, y] = recording.places.map(|places| places.iter().map(|x| (1e6 * x).round() / 1e6).collect());
        Self {
            times: recording.times,
            displacements: Vec::new(),
            level: recording.level,
            levelled: !recording.heaped,
            low: packed.low,
            step: packed.step,
            heights: packed.text,
            colours: colours(recording.heaped),
            recorded: recording.recorded,
            x,
            y,
            bodies: recording.bodies.into_iter().map(ViewedBody::of).collect(),
        }
    }

    /// The view as JSON that can stand in a page.
    pub(crate) fn json(&self) -> Result<String, serde_json::Error> {
        // A name of a body must not end the element of the page that holds it.
        Ok(serde_json::to_string(self)?.replace('<', "\\u003c"))
    }

    /// How many places are shown along x and y.
    pub(crate) fn places(&self) -> [usize; 2] {
        [self.x.len(), self.y.len()]
    }
}

impl ViewedBody {
    fn of(body: RecordedBody) -> Self {
        let (low, high) = body.bounds();
        let step = (high - low).max_element().max(1e-9) / STEPS;
        let steps = |p: &DVec3| ((*p - low) / step).round().to_array().map(|q| q as u16);
        Self {
            low: low.to_array(),
            step,
            points: words(body.points.iter().flat_map(steps)),
            triangles: words(body.triangles.iter().flatten().map(|n| *n as u16)),
            turns: body.turns(),
            poses: body.poses,
            name: body.name,
        }
    }
}

fn colours(heaped: bool) -> String {
    let map = if heaped { ColourMap::Sequential } else { ColourMap::Diverging };
    let colour = |n: u32| map.at(f64::from(n) / f64::from(COLOURS));
    (0..=COLOURS).map(|n| colour(n).map(|channel| format!("{channel:02x}")).concat()).collect()
}
