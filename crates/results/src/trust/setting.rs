//! Facts about a case that the checks need in addition to the histories; stored in `run.json`.

use crate::history::EnergySample;
use case::resolved::{Motion, Precision};
use case::tow::Measures;
use case::{Case, ClosedBox};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Facts about a case.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Setting {
    /// Acceleration of gravity on the soil [m/s²].
    pub gravity: f64,
    /// Density of the soil [kg/m³].
    pub density: f64,
    /// Courant number.
    pub courant: f64,
    /// Whether the soil compacts, and whether it dilates, so that a change of its volume is expected.
    pub changes_volume: [bool; 2],
    /// Strength of the soil without normal stress [Pa]: c or s_u at its top; 0 of soil that has none, or that
    /// does not fail.
    pub cohesion: f64,
    /// Mass of the box filled with soil [kg].
    pub mass: f64,
    /// Energies below this are none [J]: 10⁻¹² of the soil's weight times the box's height, or a thousandth
    /// of the work that lifts one cell of soil by its own height.
    pub energy_floor: f64,
    /// Relative rounding error of the elastic energy: 16 times that of a number in the precision of the run.
    pub rounding: f64,
    /// Elastic energy of the soil at rest [J], of whose rounding no balance can be free.
    pub elastic_at_rest: f64,
    /// Vertical pressure at the floor at the start [Pa].
    pub floor_pressure: f64,
    /// Whether soil stands on the ground as bodies of its own, so that bodies above the ground may meet soil.
    pub heaped: bool,
    /// Smallest cell widths along x, y, z [m].
    pub cell: [f64; 3],
    /// Depth of the floor below the undisturbed surface [m].
    pub floor_depth: f64,
    /// Drainage number per speed [s/m]; `None` for dry ground and for undrained soil.
    pub drainage_per_speed: Option<f64>,
    /// Whether the soil is taken for drained, whatever its drainage number.
    pub accepts_drained: bool,
    /// Rise of the pressure in a closed box over what the soil bears, per volume of a body that enters
    /// [1/m³]; `None` for open ground.
    pub pumped_per_volume: Option<f64>,
    /// Everything that is unusual about the case, each a sentence.
    pub unusual: Vec<String>,
    /// The bodies, in the order of the case.
    pub bodies: Vec<BodySetting>,
}

/// Facts about a body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct BodySetting {
    /// Name of the body.
    pub name: String,
    /// Smallest cell widths along the axes of the extent [m]; in plane strain the width of the body across.
    pub cell: [f64; 3],
    /// Extent of the body along its own axes [m]: along the axis nearest to its tow (of a body that rolls,
    /// along that in which it rolls), across and upwards; `None` across the slab of plane strain.
    pub extent: [Option<f64>; 3],
    /// Thickness of the body across [m], less than the extent of a dished disc; `None` across the slab of
    /// plane strain.
    pub thickness: Option<f64>,
    /// Diameter of a body that is round in the plane of the tow [m].
    pub diameter: Option<f64>,
    /// Whether the body moves vertically.
    pub heaves: bool,
    /// Whether the body is free to move vertically.
    pub heaves_freely: bool,
    /// Whether the body rotates freely.
    pub turns_freely: bool,
    /// The axis about which a prescribed motion turns the body: 0 for x (tilt), 1 for its axle (spin), 2 for
    /// z (yaw).
    pub turned_about: Option<usize>,
    /// Volume of the body [m³]; in plane strain that of a metre.
    pub volume: f64,
    /// The body at the root of the joints that carry this one, by number; its own where none does. Bodies
    /// with the same root are parts of one gear. `None` in results that do not say.
    pub gear: Option<usize>,
}

impl Setting {
    /// The facts about a case.
    #[must_use]
    pub fn of(case: &Case) -> Self {
        let size = case.domain.high - case.domain.low;
        let weight = case.soil.unit_weight * size.x * case.domain.width_of_body(size.y) * size.z;
        let changes = |n: usize| case.soils().any(|(_, soil)| soil.law.changes_volume()[n]);
        let mut cell = finest_cell(case);
        cell[1] = case.domain.width_of_body(cell[1]);
        let cohesion = case.soil.law.cohesion().unwrap_or(0.0);
        let depth = case.ground.surface() - case.domain.low.z;
        let floor_pressure = case.overburden + case.soil.unit_weight * depth;
        let one_cell = (case.soil.unit_weight * cell[2] + cohesion) * cell[0] * cell[1] * cell[2];
        Self {
            gravity: if case.soil.unit_weight > 0.0 {
                case.soil.unit_weight / case.soil.density
            } else {
                0.0
            },
            density: case.soil.density,
            cohesion,
            mass: case.soil.density * size.x * case.domain.width_of_body(size.y) * size.z,
            courant: case.numerics.courant,
            changes_volume: [changes(0), changes(1)],
            energy_floor: (1e-12 * weight * size.z).max(1e-3 * one_cell),
            rounding: ROUNDING * epsilon(case.numerics.precision),
            elastic_at_rest: elastic_at_rest(case, floor_pressure)
                * size.x
                * case.domain.width_of_body(size.y)
                * depth,
            floor_pressure,
            heaped: !case.soil_bodies.is_empty(),
            cell,
            floor_depth: depth,
            drainage_per_speed: case.drainage_per_speed().filter(|_| !case.computes_pore_pressure()),
            accepts_drained: case.water.is_some_and(|water| water.accept_drained),
            pumped_per_volume: ClosedBox::of(case)
                .map(|closed| closed.stiffness / closed.bearable)
                .filter(|rise| rise.is_finite()),
            unusual: case::unusual(case),
            bodies: (0..case.bodies.len()).map(|number| BodySetting::of(case, number)).collect(),
        }
    }

    /// The least force that means anything [N]: the weight of the soil in one cell, and its cohesion over the
    /// cell's face.
    #[must_use]
    pub fn least_force(&self) -> f64 {
        let [x, y, z] = self.cell;
        (self.gravity * self.density * z + self.cohesion) * x * y
    }

    /// Error of the energy balance at a sample: energy that neither an entry nor rounding explains, over the
    /// largest of external work, plastic dissipation and kinetic energy, or over the least energy that means
    /// anything.
    #[must_use]
    pub fn closure(&self, sample: &EnergySample) -> f64 {
        let (unexplained, scale) = (sample.unexplained(), self.energy_scale(sample));
        let rounding = self.rounding * (self.elastic_at_rest + sample.elastic.abs());
        if unexplained.abs() <= rounding || scale == 0.0 { 0.0 } else { unexplained / scale }
    }

    /// What energies at a sample are compared with [J]; what is not a number does not count as small.
    #[must_use]
    pub fn energy_scale(&self, sample: &EnergySample) -> f64 {
        let scale = sample.scale();
        if scale < self.energy_floor { self.energy_floor } else { scale }
    }
}

/// What rounding may leave of the elastic energy, in rounding errors of one number. The soil moves until
/// rounded stresses balance its rounded weight, by the error times its settlement under its own weight, which
/// is six times its energy at rest; it overshoots by twice that.
const ROUNDING: f64 = 16.0;

/// Relative error of a number in the precision of a run.
fn epsilon(precision: Precision) -> f64 {
    match precision {
        Precision::Double => f64::EPSILON,
        Precision::Single => f32::EPSILON.into(),
    }
}

/// Mean elastic energy density of the soil at rest [J/m³]: σ_v²/2E over the depth, without lateral support,
/// which makes it less.
fn elastic_at_rest(case: &Case, floor_pressure: f64) -> f64 {
    /// Pressure to which the modulus of sand refers [Pa]; at lower ones it is softer.
    const REFERENCE: f64 = 1e5;
    let top = case.overburden;
    if floor_pressure <= 0.0 {
        return 0.0;
    }
    let mean_square = (floor_pressure.powi(2) + floor_pressure * top + top.powi(2)) / 3.0;
    let softest = case.soils().map(|(_, soil)| soil.young_modulus).fold(f64::INFINITY, f64::min);
    0.5 * mean_square / (softest * (floor_pressure / REFERENCE).min(1.0).sqrt())
}

/// Smallest cell widths along x, y, z [m].
fn finest_cell(case: &Case) -> [f64; 3] {
    let finest = |faces: &Vec<f64>| faces.windows(2).map(|f| f[1] - f[0]).fold(f64::INFINITY, f64::min);
    case.grid.faces.each_ref().map(finest)
}

impl BodySetting {
    fn of(case: &Case, number: usize) -> Self {
        let body = &case.bodies[number];
        let cells = DVec3::from_array(finest_cell(case));
        let Measures { extent, thickness, mut cell } = Measures::of(case, body, cells);
        let mut extent = extent.to_array().map(Some);
        if case.domain.plane_strain {
            extent[1] = None;
        }
        cell.y = case.domain.width_of_body(cell.y);
        let guided = body.guided();
        let heave = &guided.translation[2];
        let [yaw, tilt] = &guided.rotation;
        let rotations = [tilt, body.spin(), yaw];
        let is_turned = |axis: &usize| !matches!(rotations[*axis], Motion::Fixed | Motion::Free { .. });
        let solid = body.solid();
        let (low, high) = solid.bounds();
        let part_in_slab = case.domain.width_of_body((high - low).y) / (high - low).y;
        Self {
            name: body.name.clone(),
            cell: cell.to_array(),
            extent,
            thickness: extent[1].map(|_| thickness),
            diameter: body.wheel_diameter(),
            heaves: *heave != Motion::Fixed,
            heaves_freely: heave.is_free(),
            turns_freely: body.spin().is_free(),
            // A wheel that is driven may be steered as well.
            turned_about: [1, 2, 0].into_iter().find(is_turned),
            volume: if body.has_surface() { solid.mass_properties().volume * part_in_slab } else { 0.0 },
            gear: Some(root(case, number)),
        }
    }
}

/// The body at the root of the joints that carry a body.
fn root(case: &Case, number: usize) -> usize {
    let carrier = |n: &usize| {
        let joint = case.joints.iter().find(|joint| joint.kind.carries() && joint.second == *n)?;
        joint.first
    };
    // Joints that carry make no circle; a case made by hand may.
    std::iter::successors(Some(number), carrier).take(case.bodies.len()).last().unwrap_or(number)
}
