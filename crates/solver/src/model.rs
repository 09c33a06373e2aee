//! What is fixed during a run: grid, soil law, walls, bodies, parameters of the method.

use crate::grid::Grid;
use glam::DVec3;
use physics::elastic::Elastic;
use physics::rigid::Freedom;
use physics::shape::Shape;
use physics::strength::Law;
use physics::viscosity::BulkViscosity;

/// Everything that does not change during a run.
#[derive(Debug)]
pub struct Model {
    /// The Eulerian grid.
    pub grid: Grid,
    /// Elastic moduli.
    pub elastic: Elastic,
    /// Strength; `None` for linear elastic soil.
    pub strength: Option<Law>,
    /// Density below which the soil dilates no more [kg/m³].
    pub critical_density: Option<f64>,
    /// Density of the undeformed soil [kg/m³].
    pub density: f64,
    /// Acceleration of gravity [m/s²], downwards.
    pub gravity: f64,
    /// Height of the undisturbed surface of the soil [m].
    pub surface: f64,
    /// Ratio K₀ of horizontal to vertical stress at rest.
    pub rest_pressure_ratio: f64,
    /// Walls by axis: at the low end and at the high end.
    pub walls: [[Wall; 2]; 3],
    /// Rigid bodies.
    pub bodies: Vec<BodyModel>,
    /// Share of each body that is modelled: halved by each plane of symmetry, x = 0 and y = 0.
    pub share: f64,
    /// Parameters of the method.
    pub method: Method,
}

/// What a face of the box does to the soil that touches it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wall {
    /// No motion through it, no friction along it.
    Smooth,
    /// No motion at all.
    Fixed,
}

/// What is fixed about a body.
#[derive(Debug)]
pub struct BodyModel {
    /// Its name.
    pub name: String,
    /// Its shape.
    pub shape: Box<dyn Shape>,
    /// Reference point at the start [m].
    pub start: DVec3,
    /// Mass of the whole body [kg].
    pub mass: f64,
    /// Moment of inertia of the whole body about its axle [kg m²].
    pub axle_inertia: f64,
    /// Coefficient of friction against the soil.
    pub friction: f64,
    /// Largest frictional traction [Pa], whatever the pressure; infinite for no such limit.
    pub shear_limit: f64,
    /// Motion along x, y, z.
    pub translation: [Freedom; 3],
    /// Turning about the axle.
    pub spin: Freedom,
}

/// Which contact method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactMethod {
    /// Penalty with a history penetration that follows the geometric gap.
    Penalty,
    /// Velocity impulses with the body inside the iteration.
    Impulse,
}

/// Parameters of the method.
#[derive(Clone, Debug, PartialEq)]
pub struct Method {
    /// Courant number.
    pub courant: f64,
    /// Displacement in cell widths at which a remap is due.
    pub remap_displacement: f64,
    /// Coefficient ε of hourglass viscosity.
    pub hourglass: f64,
    /// Share of it that acts in cells that yield.
    pub hourglass_yielding: f64,
    /// Bulk viscosity b₁, b₂.
    pub bulk_viscosity: [f64; 2],
    /// Contact method.
    pub contact: ContactMethod,
    /// Distance between contact points and sharp edges, in cell widths.
    pub edge_inset: f64,
    /// Spacing of the contact points, in cell widths.
    pub point_spacing: f64,
}

impl Default for Method {
    /// The parameter card of the numerics study.
    fn default() -> Self {
        Self {
            courant: 0.5,
            remap_displacement: 0.1,
            hourglass: 0.01,
            hourglass_yielding: 1.0,
            bulk_viscosity: [0.02, 1.2],
            contact: ContactMethod::Impulse,
            edge_inset: 0.5,
            point_spacing: 0.25,
        }
    }
}

/// Cells with less soil than this bear no stress: their strain rate is the void's, not the soil's.
pub const FRACTION_STRESSED: f64 = 1e-3;
/// Less soil than this is taken out of a cell after a remap (and counted).
pub const FRACTION_KEPT: f64 = 1e-6;

impl Model {
    /// Weightless, elastic soil between smooth walls, without bodies: what a test or a benchmark starts from.
    #[must_use]
    pub fn bare(grid: Grid, elastic: Elastic, density: f64) -> Self {
        Self {
            grid,
            elastic,
            strength: None,
            critical_density: None,
            density,
            gravity: 0.0,
            surface: 0.0,
            rest_pressure_ratio: 1.0,
            walls: [[Wall::Smooth; 2]; 3],
            bodies: Vec::new(),
            share: 1.0,
            method: Method::default(),
        }
    }

    /// Speed of the compression wave [m/s].
    #[must_use]
    pub fn wave_speed(&self) -> f64 {
        self.elastic.wave_speed(self.density)
    }

    /// Time step [s]. It never changes: the grid does not deform, and force and mass of a cell scale alike with the
    /// soil in it.
    #[must_use]
    pub fn time_step(&self) -> f64 {
        self.method.courant * self.grid.finest() / self.wave_speed()
    }

    /// Nodes lighter than this do not move [kg].
    #[must_use]
    pub fn mass_moved(&self) -> f64 {
        1e-7 * self.density * self.grid.finest().powi(3)
    }

    /// Bulk viscosity of the soil.
    #[must_use]
    pub fn viscosity(&self) -> BulkViscosity {
        let [b1, b2] = self.method.bulk_viscosity;
        BulkViscosity::new(b1, b2, self.density, self.wave_speed())
    }
}

/// Where soil is at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filling {
    /// Low corner of the box that is full of soil [m].
    pub low: DVec3,
    /// High corner [m].
    pub high: DVec3,
    /// Only what is so near to the z axis is full: a round column [m].
    pub radius: Option<f64>,
}

impl Filling {
    /// All of a box.
    #[must_use]
    pub fn between(low: DVec3, high: DVec3) -> Self {
        Self { low, high, radius: None }
    }
}
