//! Whether a case can be simulated, however it was made. It sees values only; problems name the path of the
//! key at fault.

pub(super) mod body;
mod cost;
pub(super) mod domain;
pub(super) mod fit;
mod follow;
pub(super) mod grid;
mod joint;
mod motions;
pub(super) mod names;
pub(super) mod relief;
pub(super) mod soil;
mod stages;
pub(super) mod timing;
pub(super) mod water;

use super::numbers::in_range;
use super::path::Paths;
use super::resolved::{Case, SOIL, Soil};
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

/// Every part by itself.
fn parts(case: &Case, problems: &mut Problems) {
    names::case_name(&case.name, problems);
    in_range("gravity", case.gravity, problems);
    if let Some(water) = &case.water {
        water.check(problems);
    }
    for (path, of_section) in case.soils() {
        of_section.check(&path, problems);
    }
    names::parts("layer", &case.layers.iter().map(|layer| &*layer.name).collect::<Vec<_>>(), problems);
    for layer in &case.layers {
        in_range(&format!("{}.top", layer.path()), layer.top, problems);
    }
    names::parts("soil_body", &case.soil_bodies.iter().map(|b| &*b.name).collect::<Vec<_>>(), problems);
    for body in &case.soil_bodies {
        relief::soil_body(body, case.domain.plane_strain, problems);
    }
    case.relief.furrows.iter().for_each(|furrows| furrows.check(problems));
    case.numerics.check(problems);
    case.forecast.check(problems);
    names::parts("body", &case.bodies.iter().map(|body| &*body.name).collect::<Vec<_>>(), problems);
    names::parts("joint", &case.joints.iter().map(|joint| &*joint.name).collect::<Vec<_>>(), problems);
    for body in &case.bodies {
        body::body(body, (case.grid.fine_cell(), case.domain.plane_strain), problems);
    }
    joint::joints(case, problems);
    stages::stages(case, problems);
    timing::duration(case.duration, problems);
    case.output.check(case.duration, problems);
    domain::domain(&case.domain, problems);
    domain::ground_numbers(&case.ground, problems);
    domain::velocity_numbers(case.velocity, problems);
    soil::overburden_number(case.overburden, problems);
    soil::slope_numbers(&case.slope, problems);
    grid::grid(&case.grid, &case.domain, problems);
}

/// Whether the parts fit each other.
fn fits_together(case: &Case, problems: &mut Problems) {
    domain::ground(&case.ground, &case.domain, problems);
    domain::velocity(case.velocity, &case.domain, problems);
    domain::constant_stress(case, problems);
    soil::overburden(case.overburden, &case.soil, case.ground.surface(), &case.domain, problems);
    soil::slope(case, problems);
    soil::growing_strength(case, problems);
    soil::layers(case, problems);
    soil::density(case, problems);
    soil::flattened(case, problems);
    relief::relief(case, problems);
    fit::bodies_fit(&Paths::of(case), &case.domain, problems);
    if !problems.ignores_resolution() {
        body::walls(case, problems);
    }
    follow::follow(case, problems);
    motions::times(case, problems);
    stages::ends(case, problems);
    water::water(case, problems);
}
