//! Everything that changes during a run. A checkpoint is this.

use crate::grid::Grid;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Names of the stress components, in the order of [`Soil::stress`].
pub const STRESS_NAMES: [&str; 6] = ["xx", "yy", "zz", "xy", "yz", "xz"];

/// What the cells hold. Each array covers the grid (see [`Grid::index`]).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Soil {
    /// Eulerian volume fraction, 0 to 1.
    pub fraction: Vec<f64>,
    /// Mass of soil in the cell [kg].
    pub mass: Vec<f64>,
    /// Cauchy stress of the soil (not scaled by the fraction), tension positive: xx, yy, zz, xy, yz, xz [Pa].
    pub stress: [Vec<f64>; 6],
    /// Equivalent plastic strain.
    pub plastic_strain: Vec<f64>,
    /// Stress-free volumetric opening that has to close before pressure can build.
    pub gap_strain: Vec<f64>,
}

/// What the nodes hold.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Nodes {
    /// Velocity along x, y, z [m/s].
    pub velocity: [Vec<f64>; 3],
    /// Displacement since the last remap along x, y, z [m].
    pub displacement: [Vec<f64>; 3],
    /// Mass lumped from the eight cells round the node [kg].
    pub mass: Vec<f64>,
}

/// Where a body is and how it moves. The whole body, also when only half of it is modelled.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Reference point (of a disc: the middle of its axle) [m].
    pub position: DVec3,
    /// Angle turned about the axle [rad], positive when it rolls forward.
    pub angle: f64,
    /// Velocity of the reference point [m/s].
    pub velocity: DVec3,
    /// Rate of turning about the axle [rad/s], positive when it rolls forward.
    pub spin: f64,
}

/// Everything that changes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Time since the start [s].
    pub time: f64,
    /// Number of steps taken.
    pub step: u64,
    /// The cells.
    pub soil: Soil,
    /// The nodes.
    pub nodes: Nodes,
    /// The bodies, in the order of the model's.
    pub bodies: Vec<Body>,
}

impl Soil {
    /// No soil anywhere.
    #[must_use]
    pub fn empty(grid: &Grid) -> Self {
        let zeros = || vec![0.0; grid.entries];
        Self {
            fraction: zeros(),
            mass: zeros(),
            stress: std::array::from_fn(|_| zeros()),
            plastic_strain: zeros(),
            gap_strain: zeros(),
        }
    }
}

impl Nodes {
    /// Nodes at rest, without mass.
    #[must_use]
    pub fn at_rest(grid: &Grid) -> Self {
        let zeros = || vec![0.0; grid.entries];
        Self {
            velocity: std::array::from_fn(|_| zeros()),
            displacement: std::array::from_fn(|_| zeros()),
            mass: zeros(),
        }
    }
}
