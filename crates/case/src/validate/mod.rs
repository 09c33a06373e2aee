//! Whether a case can be simulated, however it was made. It sees values only; problems name the path of the
//! key at fault.

mod cost;
pub(super) mod fit;
mod follow;
mod motions;
mod relief;
mod soil;
mod stages;
mod water;

use super::path::Paths;
use super::resolved::{Case, SOIL, Soil};
use super::{body, domain, grid, ground, joint, names, run, stage, top};
use input::problem::{Problem, Problems};

/// Everything that is wrong with a case; empty for one that can be simulated.
///
/// What [`super::parse`] returns has passed this check already; a case that was made or changed by hand has
/// not. Whether there is enough memory depends on the machine and on the moment.
#[must_use]
pub fn validate(case: &Case) -> Vec<Problem> {
    let mut problems = Problems::default();
    whole(case, &mut problems);
    problems.into_list()
}

/// Everything that is wrong with a soil by itself.
#[must_use]
pub fn validate_soil(soil: &Soil) -> Vec<Problem> {
    let mut problems = Problems::default();
    soil.check(SOIL, &mut problems);
    problems.into_list()
}

/// Reports everything that is wrong with a case.
pub(super) fn whole(case: &Case, problems: &mut Problems) {
    let before = problems.len();
    parts(case, problems);
    // Nothing else can be computed from numbers that make no sense.
    if problems.len() == before {
        fits_together(case, problems);
        if !problems.ignores_resolution() {
            cost::cost(case, problems);
        }
    }
}

/// Checks every part of the case by itself.
fn parts(case: &Case, problems: &mut Problems) {
    names::case_name(&case.name, problems);
    top::check_gravity(case.gravity, problems);
    if let Some(water) = &case.water {
        water.check(problems);
    }
    for (path, of_section) in case.soils() {
        of_section.check(&path, problems);
    }
    names::parts("layer", &case.layers.iter().map(|layer| &*layer.name).collect::<Vec<_>>(), problems);
    case.layers.iter().for_each(|layer| layer.check(problems));
    names::parts("soil_body", &case.soil_bodies.iter().map(|b| &*b.name).collect::<Vec<_>>(), problems);
    for body in &case.soil_bodies {
        body.check(case.domain.plane_strain, problems);
    }
    case.relief.furrows.iter().for_each(|furrows| furrows.check(problems));
    case.numerics.check(problems);
    case.forecast.check(problems);
    names::parts("body", &case.bodies.iter().map(|body| &*body.name).collect::<Vec<_>>(), problems);
    names::parts("joint", &case.joints.iter().map(|joint| &*joint.name).collect::<Vec<_>>(), problems);
    for body in &case.bodies {
        body::check(body, case.fine_cells(), problems);
    }
    joint::check(&case.joints, &case.bodies, &case.domain, problems);
    stage::check(&case.stages, &case.bodies, &case.domain, problems);
    run::check(case.duration, problems);
    case.output.check(case.duration, problems);
    domain::check(&case.domain, problems);
    ground::numbers(&case.ground, case.velocity, case.overburden, problems);
    case.slope.check(problems);
    grid::check(&case.grid, &case.domain, problems);
}

/// Whether the parts fit each other.
fn fits_together(case: &Case, problems: &mut Problems) {
    ground::check(&case.ground, &case.domain, problems);
    ground::check_velocity(case.velocity, &case.domain, problems);
    fit::constant_stress(case, problems);
    ground::check_overburden(case.overburden, &case.soil, case.ground.surface(), &case.domain, problems);
    soil::slope(case, problems);
    soil::growing_strength(case, problems);
    soil::layers(case, problems);
    soil::density(case, problems);
    soil::flattened(case, problems);
    relief::relief(case, problems);
    fit::bodies_fit(&Paths::of(case), &case.domain, problems);
    if !problems.ignores_resolution() {
        fit::walls(case, problems);
    }
    follow::follow(case, problems);
    motions::times(case, problems);
    stages::ends(case, problems);
    water::water(case, problems);
}
