//! A13: bodies that touch, without soil: exact motions and loads.

use crate::error::VerifyError;
use crate::runner::Runner;
use coulter::history::BodySample;
use coulter::simulation::Simulation;

const MOVING: &str = include_str!("../validation/A13_bodies_that_touch/moving.toml");
const STACK: &str = include_str!("../validation/A13_bodies_that_touch/stack.toml");
const GRAVITY: f64 = 9.81;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "ball on a plate, block on a ramp, Newton's cradle";
    if runner.wants("A13", variant)? {
        let simulation = runner.run("A13", variant, MOVING, &[])?;
        let (sin, cos) = 30.0_f64.to_radians().sin_cos();
        let slid = slid(samples(&simulation, "slider")) / (0.5 * GRAVITY * (sin - 0.3 * cos));
        let raised = 0.5 * (1.0 - cos);
        let last = heights(samples(&simulation, "swung_5"));
        let between = ["swung_2", "swung_3", "swung_4"].map(|name| heights(samples(&simulation, name)));
        let figures = [
            ("height of the rebound over e² h", rebound(samples(&simulation, "ball")) / (0.36 * 0.3)),
            ("way down the ramp over the exact value", slid),
            ("height of the cradle's last ball over that of the first", last / raised),
            ("height of those between", between.into_iter().fold(0.0, f64::max) / raised),
        ];
        runner.put("A13", variant, simulation.wall_s, &figures)?;
    }
    let variant = "five blocks on one another";
    if runner.wants("A13", variant)? {
        let simulation = runner.run("A13", variant, STACK, &[])?;
        let masses = [5.0, 1.0, 3.0, 0.5, 2.0];
        let error = |n: usize| {
            let weight = GRAVITY * masses[n..].iter().sum::<f64>();
            let force = simulation.history.joints[n].last().map_or(f64::NAN, |sample| sample.force_z);
            (force / weight - 1.0).abs()
        };
        let largest = (0..masses.len()).map(error).fold(0.0, f64::max);
        runner.put("A13", variant, simulation.wall_s, &[("largest error of a load", largest)])?;
    }
    Ok(())
}

fn samples<'a>(simulation: &'a Simulation, body: &str) -> &'a [BodySample] {
    let history = &simulation.history;
    history.names.iter().position(|name| name == body).map_or(&[], |number| &history.bodies[number])
}

/// How far the body has risen from its lowest place [m].
fn heights(samples: &[BodySample]) -> f64 {
    let (low, high) = samples
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(-s.sinkage), h.max(-s.sinkage)));
    high - low
}

/// Height of the first rebound of a ball from a plate 1.5 m above the ground [m].
fn rebound(samples: &[BodySample]) -> f64 {
    let struck = samples.iter().position(|s| s.heave_speed > 0.0).unwrap_or(0);
    let rising = samples[struck..].iter().take_while(|s| s.heave_speed > 0.0);
    rising.fold(f64::NAN, |highest, s| highest.max(-s.sinkage - 1.5))
}

/// Way of a body that was let go, over the square of the time [m/s²].
fn slid(samples: &[BodySample]) -> f64 {
    let (Some(first), Some(last)) = (samples.first(), samples.last()) else { return f64::NAN };
    let way = (last.displacement - first.displacement).hypot(last.sinkage - first.sinkage);
    way / last.time.powi(2)
}
