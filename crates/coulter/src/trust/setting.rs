//! Facts about a case that the checks need in addition to the histories; stored in `run.json`.

use crate::case::resolved::{Body, Motion};
use crate::case::tow::Measures;
use crate::case::{self, Case, ClosedBox};
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
    /// Energies below this are rounding errors [J]: 10⁻¹² of the soil's weight times the box's height.
    pub energy_floor: f64,
    /// Depth of the floor below the undisturbed surface [m].
    pub floor_depth: f64,
    /// Drainage number per speed [s/m]; `None` for dry ground and for undrained soil.
    pub drainage_per_speed: Option<f64>,
    /// Whether the soil is taken for drained, whatever its drainage number.
    pub accepts_drained: bool,
    /// Rise of the pressure in a closed box over what the soil bears, per volume of a body that enters [1/m³]; `None` for open ground.
    pub pumped_per_volume: Option<f64>,
    /// What no soil, body or tow has, each a sentence.
    pub unusual: Vec<String>,
    /// The bodies, in the order of the case.
    pub bodies: Vec<BodySetting>,
}

/// Facts about a body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct BodySetting {
    /// Its name.
    pub name: String,
    /// Smallest cell widths along the axes of its extent [m]; in plane strain the width of the body across.
    pub cell: [f64; 3],
    /// Its extent along its own axes [m]: that next to its tow (of what rolls, that in which it does), across and upwards; `None`
    /// across the slab of plane strain.
    pub extent: [Option<f64>; 3],
    /// Its thickness across [m], less than the extent of a dished disc; `None` across the slab of plane strain.
    pub thickness: Option<f64>,
    /// Diameter of a body that is round in the plane of the tow [m].
    pub diameter: Option<f64>,
    /// Whether it moves vertically.
    pub heaves: bool,
    /// Whether it is free to move vertically.
    pub heaves_freely: bool,
    /// Whether it rotates freely.
    pub turns_freely: bool,
}

impl Setting {
    /// The facts about a case.
    #[must_use]
    pub fn of(case: &Case) -> Self {
        let size = case.domain.high - case.domain.low;
        let weight = case.soil.unit_weight * size.x * case.domain.width_of_body(size.y) * size.z;
        let changes = |n: usize| case.soils().any(|(_, soil)| soil.law.changes_volume()[n]);
        Self {
            gravity: if case.soil.unit_weight > 0.0 {
                case.soil.unit_weight / case.soil.density
            } else {
                0.0
            },
            density: case.soil.density,
            courant: case.numerics.courant,
            changes_volume: [changes(0), changes(1)],
            energy_floor: 1e-12 * weight * size.z,
            floor_depth: case.ground.surface() - case.domain.low.z,
            drainage_per_speed: case.drainage_per_speed().filter(|_| !case.computes_pore_pressure()),
            accepts_drained: case.water.is_some_and(|water| water.accept_drained),
            pumped_per_volume: ClosedBox::of(case).map(|closed| closed.stiffness / closed.bearable),
            unusual: case::unusual(case),
            bodies: case.bodies.iter().map(|body| BodySetting::of(case, body)).collect(),
        }
    }
}

impl BodySetting {
    fn of(case: &Case, body: &Body) -> Self {
        let finest = |faces: &Vec<f64>| faces.windows(2).map(|f| f[1] - f[0]).fold(f64::INFINITY, f64::min);
        let cells = DVec3::from_array(case.grid.faces.each_ref().map(finest));
        let Measures { extent, thickness, mut cell } = Measures::of(case, body, cells);
        let mut extent = extent.to_array().map(Some);
        if case.domain.plane_strain {
            extent[1] = None;
        }
        cell.y = case.domain.width_of_body(cell.y);
        let heave = &body.guided().translation[2];
        Self {
            name: body.name.clone(),
            cell: cell.to_array(),
            extent,
            thickness: extent[1].map(|_| thickness),
            diameter: body.wheel_diameter(),
            heaves: !matches!(heave, Motion::Fixed),
            heaves_freely: heave.is_free(),
            turns_freely: body.spin().is_free(),
        }
    }
}
