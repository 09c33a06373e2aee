//! Bodies of soil of another kind.

use crate::body::{Attitude, check_shape, pitched};
use crate::context::Context;
use crate::key::allowed::TILT;
use crate::key::checked;
use crate::shapes::{self, FineCells, KEYS as SHAPE, Shape};
use crate::soil::{Conditions, KEYS as SOIL, Soil, soil};
use glam::DVec3;
use input::key::DefaultValue::Quantity;
use input::key::{Key, KeyOf, Kind, Place, count, declared, in_ranges, joined, numbers, read, required};
use input::problem::Problems;
use input::quantity::{ANGLE, LENGTH};
use input::typed::Section;
use mechanics::Pose;
use serde::Serialize;

/// A body of soil of another kind.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SoilBody {
    /// Name of the soil body.
    pub name: String,
    /// Shape of the soil body.
    pub shape: Shape,
    /// Reference point of the soil body [m].
    pub position: DVec3,
    /// Attitude of the soil body.
    pub attitude: Attitude,
    /// Soil of the soil body.
    pub soil: Soil,
}

type Field = KeyOf<SoilBody>;

/// Keys of the place and attitude of a soil body, and where their values lie.
const PLACED: &[Field] = &[
    Field::new("x", Kind::Quantity(LENGTH), Place::Derived(|body| Some(&mut body.position.x)))
        .default(Quantity("0 m"))
        .means("Position of its centre along x."),
    Field::new("y", Kind::Quantity(LENGTH), Place::Derived(|body| Some(&mut body.position.y)))
        .default(Quantity("0 m"))
        .means("Position of its centre along y."),
    Field::new("elevation", Kind::Quantity(LENGTH), Place::Derived(|body| Some(&mut body.position.z)))
        .means("Height of its centre over `ground.surface`; negative for one in the ground."),
    Field::new("yaw", Kind::Quantity(ANGLE), Place::Number(|body| &mut body.attitude.yaw))
        .default(Quantity("0 deg"))
        .means("Rotation about z, as of a body."),
    Field::new("tilt", Kind::Quantity(ANGLE), Place::Number(|body| &mut body.attitude.tilt))
        .default(Quantity("0 deg"))
        .within(TILT)
        .means("Rotation about x, as of a body."),
    Field::new("pitch", Kind::Quantity(ANGLE), Place::Number(|body| &mut body.attitude.pitch))
        .default(Quantity("0 deg"))
        .means("Rotation about y, as of a body."),
];

/// Number of keys of a soil body that are not those of a body's shape or of a soil.
pub const PLACE_KEYS: usize = PLACED.len();

const LISTS: &[&[Key]] = &[&declared::<_, PLACE_KEYS>(PLACED), SHAPE, SOIL];

impl SoilBody {
    /// Keys of a soil body: its place, the shape, and those of a soil.
    pub(crate) const KEYS: &[Key] = &joined::<{ count(LISTS) }>(LISTS);

    /// Path of the soil body's section.
    pub(crate) fn path(&self) -> String {
        format!("soil_body.{}", self.name)
    }

    /// The solver's soil body, of this material.
    pub(crate) fn solver_body(&self, material: usize) -> solver::model::SoilBody {
        let solid = pitched(&self.shape, self.attitude.pitch);
        let pose = Pose { position: self.position, rotation: self.attitude.of_axle() };
        solver::model::SoilBody::new(solid.into(), &pose, material)
    }

    /// Reports what is wrong with a soil body by itself, but for its soil.
    pub(crate) fn check(&self, plane_strain: bool, problems: &mut Problems) {
        let path = self.path();
        if !self.shape.has_surface() {
            let message = "a frame has no volume, and no soil in it";
            problems.add(format!("{path}.shape"), message, "choose another shape");
            return;
        }
        // It may be thinner than a cell: then cells hold a mixture.
        check_shape(&path, &self.shape, FineCells { widths: DVec3::ZERO, plane_strain }, problems);
        in_ranges(&path, &numbers(PLACED, self), problems);
    }
}

/// The soil body of a section; on soil weighs this per mass [m/s²].
pub(crate) fn soil_body(
    section: &Section,
    context: &Context,
    on_soil: f64,
    problems: &mut Problems,
) -> Option<SoilBody> {
    let shape = shapes::read(section, context.slab, problems);
    let elevation = required(PLACED, "elevation", section, problems);
    let soil = soil(section, Conditions { gravity: on_soil, slope: context.slope }, problems);
    let middle = context.slab.filter(|_| !section.has("y")).map(|slab| slab.middle);
    let y = middle.or_else(|| section.number("y"));
    let position = DVec3::new(section.number("x")?, y?, context.surface + elevation?);
    let name = section.path.trim_start_matches("soil_body.").to_owned();
    let start = SoilBody { name, shape: shape?, position, attitude: Attitude::default(), soil: soil? };
    let body = read(PLACED, start, section, problems)?;
    checked(body, problems, |body, problems| body.check(context.slab.is_some(), problems))
}
