//! B12: a cone in boxes whose boundaries keep the stress at rest.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use std::f64::consts::PI;

const CASE: &str = include_str!("../validation/B12_box_at_constant_stress/case.toml");
/// Diameter of the cone [m].
const DIAMETER: f64 = 0.04;
/// Undrained strength and overburden [Pa].
const STRENGTH: f64 = 20e3;
const OVERBURDEN: f64 = 70e3;
/// Sinkages between which the resistance is averaged [m].
const RANGE: [f64; 2] = [0.149, 0.169];

const LID: &[&str] = &["domain.z_walls=['fixed', 'pressure']"];
const SIDES: &[&str] = &["domain.x_walls=['smooth', 'pressure']", "domain.y_walls=['smooth', 'pressure']"];
const LARGE: &[&str] =
    &["domain.x=['0 m', '0.4 m']", "domain.y=['0 m', '0.4 m']", "domain.z=['-0.5 m', '0 m']"];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let boxes: [(&str, &[&[&str]]); 5] = [
        ("box 0.4 m, lid and sides", &[LARGE, LID, SIDES]),
        ("box 0.2 m, lid and sides", &[LID, SIDES]),
        ("box 0.2 m, lid", &[LID]),
        ("box 0.2 m, sides", &[SIDES]),
        ("box 0.2 m, closed", &[]),
    ];
    for (variant, overrides) in boxes {
        if runner.wants("B12", variant)? {
            let overrides: Vec<String> =
                overrides.iter().copied().flatten().map(|set| (*set).to_owned()).collect();
            let simulation = runner.run("B12", variant, CASE, &overrides)?;
            let force = mean(&simulation.history.bodies[0], RANGE, |s| s.sinkage, |s| s.vertical);
            let resistance = force / (0.25 * PI * DIAMETER * DIAMETER);
            runner.put(
                "B12",
                variant,
                simulation.wall_s,
                &[("N_c", (resistance - OVERBURDEN) / STRENGTH)],
            )?;
        }
    }
    Ok(())
}
