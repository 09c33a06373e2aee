//! What a mesh study says. The names are part of `summary.json`, a contract.

use super::convergence::Convergence;
use crate::history::quantities::Figures;
use crate::trust::Verdict;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A case on several meshes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MeshStudy {
    /// The meshes from coarse to fine; the last is the case's own.
    pub meshes: Vec<MeshResult>,
    /// The bodies by name.
    pub bodies: BTreeMap<String, BodyStudy>,
}

/// One mesh and its results.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MeshResult {
    /// Its folder below the results folder; empty for the case's own mesh.
    pub folder: String,
    /// Cell size in the fine zone, `grid.cell` [m].
    pub cell_m: f64,
    /// Representative cell width h [m]: the geometric mean of the smallest widths along x, y and z, in plane
    /// strain along x and z.
    pub width_m: f64,
    /// Cells of the grid.
    pub cells: u64,
    /// Steps taken.
    pub steps: u64,
    /// Wall-clock time [s].
    pub wall_s: f64,
    /// Grade of its run.
    pub verdict: Verdict,
    /// The bodies by name.
    pub bodies: BTreeMap<String, BodyOnMesh>,
}

/// A body on one mesh, averaged over the steady window of the finest.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct BodyOnMesh {
    /// Means.
    #[serde(flatten)]
    pub means: Figures<Option<f64>>,
    /// Scatter of the drag, over its mean.
    pub drag_noise: Option<f64>,
}

/// What the meshes together say of a body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct BodyStudy {
    /// Why there is no interval; `null` where there are intervals.
    pub no_interval_because: Option<String>,
    /// The figures with their intervals; `null` without one.
    #[serde(flatten)]
    pub figures: Figures<Option<MeshInterval>>,
}

/// The interval of a figure, with what it consists of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MeshInterval {
    /// The value on the finest mesh ± the half-width, in the unit of the figure.
    pub interval: [f64; 2],
    /// Half-width of the interval, in the unit of the figure: the root of the sum of the squares of its two
    /// parts.
    pub half_width: f64,
    /// Its statistical part: how far the mean over the window may be from that of a long tow (90 %).
    pub statistical_half_width: f64,
    /// Its part due to the mesh, and what that follows from.
    #[serde(flatten)]
    pub convergence: Convergence,
    /// Grid-convergence index: the part due to the mesh over the value. Of a drag below a tenth of the
    /// vertical force it is over that tenth, of the turn ratio over 1. `null` where the value is 0 and the
    /// part is not.
    pub index: Option<f64>,
    /// Half-width of the interval over the same.
    pub relative_half_width: Option<f64>,
}
