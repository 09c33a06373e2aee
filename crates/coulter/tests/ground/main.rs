//! The ground at rest, on slopes, in layers and under water.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod density;
mod layers;
mod left_behind;
mod slope;
mod soil_bodies;
mod strength;
mod uneven;
mod water;

use coulter::case::{self, Case};
use coulter::simulation::Simulation;

const SAND: &str = "law = \"sand\"\ncritical_friction_angle = \"32 deg\"\nminimum_density = \"1400 kg/m^3\"\n\
                    maximum_density = \"1700 kg/m^3\"\nrelative_density = 0.5\nstiffness_limit = \"10 kPa\"\n";

fn read(text: &str) -> Result<Case, String> {
    case::parse(text, "ground", &[]).map_err(|error| error.to_string())
}

/// Everything that is wrong with a case: paths, messages and cures.
fn complaints(text: &str) -> String {
    let problems = case::parse(text, "ground", &[]).unwrap_err().problems;
    problems.into_iter().map(|p| format!("{}: {} {}\n", p.path, p.message, p.cure)).collect()
}

fn run(case: &Case) -> Simulation {
    let mut simulation = Simulation::new(case);
    while !simulation.is_done() {
        simulation.advance().unwrap();
    }
    simulation
}

/// Largest speed of a node along any axis [m/s].
fn fastest(simulation: &Simulation) -> f64 {
    simulation.state.nodes.velocity.iter().flatten().fold(0.0, |most: f64, v| most.max(v.abs()))
}
