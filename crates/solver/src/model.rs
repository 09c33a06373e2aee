//! What is fixed during a run: grid, boundaries, materials, bodies, parameters of the method.

use crate::boundary::{Boundaries, Boundary, Symmetry};
use crate::fields::Kinds;
use crate::grid::{Grid, longer_step};
use crate::material::Material;
use geometry::relief::Relief;
use geometry::{RimPoint, Shape};
use glam::{DMat3, DQuat, DVec3};
use mechanics::joint::Joint;
use mechanics::{Fluid, Inertia, Mechanism, Motion, Pair, Pose};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Everything that does not change during a run.
#[derive(Debug)]
pub struct Model {
    /// The Eulerian grid.
    pub grid: Grid,
    /// What the soil is made of; at least one.
    pub materials: Vec<Material>,
    /// Acceleration of gravity [m/s²]; on the bodies.
    pub gravity: f64,
    /// Unit vector along which gravity acts: −z, or tilted where z is normal to the surface of a slope.
    pub down: DVec3,
    /// Weight of the soil over its mass, γ/ρ [m/s²]; not that of gravity where the soil is taken to be
    /// weightless.
    pub soil_gravity: f64,
    /// Height of the undisturbed surface of the soil [m]; of uneven ground the level over which its relief
    /// rises and falls.
    pub surface: f64,
    /// The undisturbed ground, which enters through an inflow boundary.
    pub ground: Ground,
    /// Water in the pores of the soil, all of which is saturated; `None` for soil that is dry, drained or
    /// undrained by its law.
    pub pore_water: Option<PoreWater>,
    /// The faces of the grid.
    pub boundaries: Boundaries,
    /// What the grid follows; nothing where it stands still.
    pub follow: Option<Follow>,
    /// Rigid bodies.
    pub bodies: Vec<BodyModel>,
    /// Joints between bodies, or between bodies and the ground.
    pub joints: Vec<Arc<dyn Joint>>,
    /// Pairs of bodies that may touch.
    pub pairs: Vec<Arc<dyn Pair>>,
    /// Portion of the width of each body that is modelled: 1, of a slab of plane strain its thickness over
    /// the width that bodies, forces and energies refer to.
    pub modelled_width: f64,
    /// Parameters of the method.
    pub method: Method,
}

/// What is fixed about a body.
#[derive(Debug)]
pub struct BodyModel {
    /// Name of the body.
    pub name: String,
    /// Shape of the body.
    pub shape: Box<dyn Shape>,
    /// Pose at the start.
    pub start: Pose,
    /// Mass properties of the whole body.
    pub inertia: Inertia,
    /// Degrees of freedom of the body: along x, y, z; yaw, tilt, spin (see [`mechanics::Body`]).
    pub motion: [Motion; 6],
    /// Coefficient of friction against the soil.
    pub friction: f64,
    /// Adhesion factor α: the largest frictional traction over the undrained shear strength of the soil,
    /// whatever the pressure. Above 1 the soil itself is the limit.
    pub adhesion_factor: f64,
    /// Distance between the contact points of the body and its sharp edges along each of its axes, in cell
    /// widths.
    pub edge_inset: DVec3,
    /// The fluid that the whole body moves in; of no effect on a body without a free motion.
    pub fluid: Fluid,
}

impl BodyModel {
    /// The body without its surface. The mass of a body without a free motion plays no role.
    fn mechanical(&self, modelled_fraction: f64) -> mechanics::Body {
        let moves_freely = self.motion.iter().any(Motion::is_free);
        let (inertia, fluid) =
            if moves_freely { (self.inertia, self.fluid) } else { (Inertia::NONE, Fluid::NONE) };
        mechanics::Body { modelled_fraction, fluid, ..mechanics::Body::new(inertia, self.motion.clone()) }
    }

    /// A vector of the body frame in space, with the body at a pose; a body that is not rotated keeps its
    /// bits.
    #[must_use]
    pub fn rotated(&self, pose: &Pose, v: DVec3) -> DVec3 {
        let attitude = self.attitude(pose);
        if attitude == DQuat::IDENTITY { v } else { attitude * v }
    }

    /// Lower and upper corner of the box round the body at a pose [m].
    #[must_use]
    pub fn bounds(&self, pose: &Pose) -> (DVec3, DVec3) {
        let frame = self.attitude(pose).inverse();
        let extent = |axis: DVec3| self.shape.extent(frame * axis);
        let high = DVec3::from_array(DVec3::AXES.map(extent));
        let low = DVec3::from_array(DVec3::AXES.map(|axis| -extent(-axis)));
        (pose.position + low, pose.position + high)
    }

    /// Boxes that together enclose the body at a pose, with faces along the axes: low and high corners [m].
    #[must_use]
    pub fn boxes(&self, pose: &Pose) -> Vec<(DVec3, DVec3)> {
        let boxes = self.shape.boxes();
        if boxes.len() == 1 {
            return vec![self.bounds(pose)];
        }
        let axes = DMat3::from_quat(self.attitude(pose));
        let absolute = DMat3::from_cols(axes.x_axis.abs(), axes.y_axis.abs(), axes.z_axis.abs());
        let around = |(low, high): (DVec3, DVec3)| {
            let (middle, half) =
                (pose.position + axes * (0.5 * (low + high)), absolute * (0.5 * (high - low)));
            (middle - half, middle + half)
        };
        boxes.into_iter().map(around).collect()
    }

    /// Directions of the contact points and the geometry of the body in space: its rotation, for a shape of
    /// revolution without the spin about its axle, which changes nothing. Contact is then steady in steady
    /// rolling.
    #[must_use]
    pub fn attitude(&self, pose: &Pose) -> DQuat {
        attitude(self.shape.is_revolved(), pose)
    }
}

/// [`BodyModel::attitude`] of a body whose shape is one of revolution, or is not.
pub(crate) fn attitude(is_revolved: bool, pose: &Pose) -> DQuat {
    if is_revolved { of_axle((pose.rotation * DVec3::Y).normalize()) } else { pose.rotation }
}

/// The rotation that turns y to an axle (a unit vector) by a tilt, and then a yaw. Without a spin of its own,
/// unlike the shortest rotation, it turns with the axle about z.
fn of_axle(axle: DVec3) -> DQuat {
    if axle.y > 1.0 - 2.0 * f64::EPSILON {
        return DQuat::IDENTITY;
    }
    let level = DVec3::new(axle.y, -axle.x, 0.0).try_normalize().unwrap_or(DVec3::X);
    DQuat::from_mat3(&DMat3::from_cols(level, axle, level.cross(axle)))
}

/// A bin of a body's rim: what lies between two points of its outline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RimBin {
    /// Middle of the bin: the mean of its samples.
    pub middle: RimPoint,
    /// Area of the modelled portion of the bin's surface [m²]; 0 outside the grid.
    pub area: f64,
}

/// The contact method.
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
    /// Fraction of hourglass viscosity that acts in cells that yield.
    pub hourglass_yielding: f64,
    /// Bulk viscosity b₁, b₂.
    pub bulk_viscosity: [f64; 2],
    /// Contact method.
    pub contact: ContactMethod,
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
            hourglass_yielding: 0.1,
            bulk_viscosity: [0.02, 1.2],
            contact: ContactMethod::Impulse,
            point_spacing: 0.25,
        }
    }
}

/// Volume fraction below which soil is taken out of a cell after a remap (and counted).
pub const FRACTION_KEPT: f64 = 1e-6;

impl Model {
    /// Whether the density of a material is averaged over a length.
    #[must_use]
    pub fn has_characteristic_length(&self) -> bool {
        self.materials.iter().any(|material| material.characteristic_length.is_some())
    }

    /// Weightless soil between smooth walls, without bodies: what a test or a benchmark starts from.
    #[must_use]
    pub fn bare(grid: Grid, material: Material) -> Self {
        Self {
            grid,
            materials: vec![material],
            gravity: 0.0,
            down: DVec3::NEG_Z,
            soil_gravity: 0.0,
            surface: 0.0,
            ground: Ground::default(),
            pore_water: None,
            boundaries: Boundaries([[Boundary::SmoothWall; 2]; 3]),
            follow: None,
            bodies: Vec::new(),
            joints: Vec::new(),
            pairs: Vec::new(),
            modelled_width: 1.0,
            method: Method::default(),
        }
    }

    /// Height that no surface of the undisturbed ground exceeds [m].
    #[must_use]
    pub fn top_of_ground(&self) -> f64 {
        if self.ground.is_even() {
            return self.surface;
        }
        let tops = self.ground.bodies.iter().map(|body| body.bounds[1].z);
        tops.fold(self.surface + self.ground.relief.range()[1], f64::max)
    }

    /// The first material: the only one of most models.
    #[must_use]
    pub fn material(&self) -> &Material {
        &self.materials[0]
    }

    /// The mechanism of the bodies and joints of the model.
    #[must_use]
    pub fn mechanism(&self) -> Mechanism {
        let bodies = self.bodies.iter().map(|body| body.mechanical(self.modelled_fraction()));
        Mechanism::unchecked(bodies.collect(), self.joints.clone()).touching(self.pairs.clone())
    }

    /// Whether the soil is driven along y rather than x: by the first body that has a prescribed speed, or
    /// else a load, along either.
    ///
    /// The sweeps of the remap go by it, so that a set-up that is turned by 90° about z takes the same
    /// course.
    #[must_use]
    pub fn is_driven_along_y(&self) -> bool {
        let drives: [fn(&Motion) -> f64; 2] = [
            |motion| match motion {
                Motion::Prescribed { speed, .. } => speed.abs(),
                Motion::Course(course) => course.fastest(),
                Motion::Fixed | Motion::Free { .. } => 0.0,
            },
            |motion| if let Motion::Free { load, .. } = motion { load.abs() } else { 0.0 },
        ];
        let of = |body: &BodyModel| drives.map(|drive| [drive(&body.motion[0]), drive(&body.motion[1])]);
        let mut each = self.bodies.iter().flat_map(of);
        each.find(|[x, y]| x.max(*y) > 0.0).is_some_and(|[x, y]| y > x)
    }

    /// Planes of symmetry.
    #[must_use]
    pub fn symmetry(&self) -> Symmetry {
        self.boundaries.symmetry()
    }

    /// Portion of each body that is modelled: that of its width, halved by each plane of symmetry.
    #[must_use]
    pub fn modelled_fraction(&self) -> f64 {
        self.symmetry().modelled_fraction() * self.modelled_width
    }

    /// Speed of the fastest compression wave [m/s].
    #[must_use]
    pub fn wave_speed(&self) -> f64 {
        self.materials.iter().map(Material::wave_speed).fold(0.0, f64::max)
    }

    /// Kinds of the materials of the model.
    #[must_use]
    pub fn kinds(&self) -> Kinds {
        let water = Kinds { water: self.pore_water.is_some(), ..Kinds::default() };
        self.materials.iter().fold(water, |kinds, material| kinds.and(material.kinds()))
    }

    /// Density of the lightest material [kg/m³].
    #[must_use]
    pub fn least_density(&self) -> f64 {
        self.materials.iter().map(|m| m.density).fold(f64::INFINITY, f64::min)
    }

    /// Densities of the undeformed materials [kg/m³].
    #[must_use]
    pub fn densities(&self) -> Vec<f64> {
        self.materials.iter().map(|material| material.density).collect()
    }

    /// Time step [s]. It never changes: the grid does not deform, and force and mass of a cell scale alike
    /// with the soil in it.
    #[must_use]
    pub fn time_step(&self) -> f64 {
        self.method.courant * (self.grid.finest() * longer_step(self.grid.aspect())) / self.wave_speed()
    }

    /// Volume of the smallest cells [m³].
    #[must_use]
    pub fn least_volume(&self) -> f64 {
        self.grid.finest().powi(3) * self.grid.aspect().element_product()
    }

    /// Mass below which nodes do not move [kg].
    #[must_use]
    pub fn mass_moved(&self) -> f64 {
        1e-7 * self.least_density() * self.least_volume()
    }
}

/// Water in the pores of the soil. Pressures are those beyond the hydrostatic one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoreWater {
    /// Permeability of the soil k (hydraulic conductivity) [m/s].
    pub permeability: f64,
    /// Unit weight of the water γ_w [N/m³].
    pub unit_weight: f64,
    /// Height of the surface of the water [m].
    pub level: f64,
}

impl PoreWater {
    /// Tension below the atmospheric pressure at which water cavitates [Pa]: that of a vacuum, about the
    /// pressure of the atmosphere.
    pub const ATMOSPHERE: f64 = 1e5;

    /// Mobility of the water k/γ_w [m²/(Pa s)]: seepage velocity through unit area per pressure gradient.
    #[must_use]
    pub fn mobility(&self) -> f64 {
        self.permeability / self.unit_weight
    }

    /// Excess pore pressure at which the water cavitates at a height [Pa].
    #[must_use]
    pub fn cavitation_pressure(&self, z: f64) -> f64 {
        -(Self::ATMOSPHERE + self.unit_weight * (self.level - z).max(0.0))
    }
}

/// A body that the grid follows: along these axes the body keeps its position in the grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Follow {
    /// Number of the body.
    pub body: usize,
    /// Whether the grid follows along x, y, z. The boundaries across such an axis must be open.
    pub axes: [bool; 3],
}

/// The undisturbed ground: soil at rest under its own weight and a pressure on its surface.
#[derive(Clone, Debug, Default)]
pub struct Ground {
    /// Where soil is, each filling in what the ones before it have left free. Infinite along an axis along
    /// which the grid moves. In uneven ground the first one is the uppermost, and all are infinite along x
    /// and y.
    pub fillings: Vec<Filling>,
    /// Pressure on the surface [Pa].
    pub overburden: f64,
    /// How far the surface of the ground lies above the top of the first filling.
    pub relief: Relief,
    /// Bodies of other soil, which take the place of the fillings, each in what the ones before it have left
    /// free.
    pub bodies: Vec<SoilBody>,
}

impl Ground {
    /// Whether the ground is made of boxes alone: its surface is level, and there are no bodies of other soil
    /// in it.
    #[must_use]
    pub fn is_even(&self) -> bool {
        self.relief.is_level() && self.bodies.is_empty()
    }

    /// Whether the ground is the same everywhere along x (0) or y (1).
    #[must_use]
    pub fn is_uniform_along(&self, axis: usize) -> bool {
        let is_plain = self.bodies.is_empty() && self.relief.is_uniform_along(axis);
        is_plain
            && self.fillings.iter().all(|filling| {
                filling.radius.is_none()
                    && filling.low[axis] == f64::NEG_INFINITY
                    && filling.high[axis] == f64::INFINITY
            })
    }
}

/// A body of soil of another kind: a lens, a backfilled trench, a heap.
#[derive(Clone, Debug)]
pub struct SoilBody {
    shape: Arc<dyn Shape>,
    position: DVec3,
    /// Rotation from the axes of space to those of the shape.
    to_shape: DQuat,
    /// Corners of the box round the body [m].
    pub bounds: [DVec3; 2],
    /// Number of the material of the body.
    pub material: usize,
}

impl SoilBody {
    /// Soil of a material in a shape that has this pose.
    #[must_use]
    pub fn new(shape: Arc<dyn Shape>, pose: &Pose, material: usize) -> Self {
        let to_shape = pose.rotation.inverse();
        let extent = |axis: DVec3| shape.extent(to_shape * axis);
        let high = DVec3::from_array(DVec3::AXES.map(extent));
        let low = DVec3::from_array(DVec3::AXES.map(|axis| -extent(-axis)));
        let bounds = [pose.position + low, pose.position + high];
        Self { shape, position: pose.position, to_shape, bounds, material }
    }

    /// Distance from the surface of the body [m]; negative inside.
    #[must_use]
    pub fn distance(&self, x: DVec3) -> f64 {
        self.shape.signed_distance(self.to_shape * (x - self.position))
    }
}

/// Where soil is at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filling {
    /// Low corner of the box that is full of soil [m].
    pub low: DVec3,
    /// High corner [m].
    pub high: DVec3,
    /// Radius round the z axis within which the box is full: a round column [m].
    pub radius: Option<f64>,
    /// Number of the material of the filling.
    pub material: usize,
}

impl Filling {
    /// A filling of all of a box.
    #[must_use]
    pub fn between(low: DVec3, high: DVec3) -> Self {
        Self { low, high, radius: None, material: 0 }
    }
}
