//! Whether a run has anything to say: a body that meets soil, and something that moves.

use super::check::Check;
use super::limits;
use super::setting::{BodySetting, Setting};
use crate::history::{BodySample, EnergySample, History};

/// The way of a body from its first sample to each [m]: of its reference point, and of its surface as it
/// rotates.
pub(super) fn way(samples: &[BodySample], radius: f64) -> Vec<f64> {
    let mut sum = 0.0;
    let mut add = |pair: &[BodySample]| {
        let [a, b] = [&pair[0], &pair[1]];
        let level = (b.displacement - a.displacement).hypot(b.lateral_displacement - a.lateral_displacement);
        let turned = (b.rotation - a.rotation).hypot(b.yaw - a.yaw).hypot(b.tilt - a.tilt);
        sum += level.hypot(b.sinkage - a.sinkage).hypot(radius * turned);
        sum
    };
    samples.first().map(|_| 0.0).into_iter().chain(samples.windows(2).map(&mut add)).collect()
}

/// Half of the longest edge of a body, in which its surface turns [m].
pub(super) fn radius(body: &BodySetting) -> f64 {
    0.5 * body.extent.into_iter().flatten().fold(0.0, f64::max)
}

/// The force of the soil in the steady window, in weights of a cell of soil; not in the first sample of a
/// run, before any step.
pub(super) fn of_body(
    setting: &Setting,
    body: &BodySetting,
    samples: &[BodySample],
    inside: &[BodySample],
) -> Option<Check> {
    let least = setting.least_force();
    // Elastic soil without a weight has no scale of its own.
    if least <= 0.0 || samples.len() < 2 {
        return None;
    }
    let largest = |samples: &[BodySample]| crate::history::largest(samples.iter().map(BodySample::force));
    let check = Check::of(&limits::CONTACT, Some(&body.name), largest(inside) / least);
    let advice = match largest(samples) / least {
        _ if check.advice.is_empty() => String::new(),
        all if all >= limits::CONTACT.good => {
            format!("the body has left the soil before the steady window; {}", check.advice)
        }
        _ => format!("the body has not met the soil in the whole run; {}", check.advice),
    };
    Some(Check { advice, ..check })
}

/// How far anything has moved, in cells.
pub(super) fn of_motion(setting: &Setting, history: &History) -> Option<Check> {
    let cell = setting.cell[2];
    if history.energy.is_empty() || cell <= 0.0 {
        return None;
    }
    let bodies = setting.bodies.iter().zip(&history.bodies).filter(|(body, _)| body.volume > 0.0);
    let of_bodies = bodies.filter_map(|(body, samples)| way(samples, radius(body)).last().copied());
    let farthest = crate::history::largest(of_bodies.chain([way_of_soil(setting.mass, &history.energy)]));
    Some(Check::of(&limits::MOTION, None, farthest / cell))
}

/// The way that all soil would have gone with the kinetic energy there was [m].
fn way_of_soil(mass: f64, energy: &[EnergySample]) -> f64 {
    let speed = |sample: &EnergySample| (2.0 * sample.kinetic.max(0.0) / mass).sqrt();
    let step =
        |pair: &[EnergySample]| 0.5 * (speed(&pair[0]) + speed(&pair[1])) * (pair[1].time - pair[0].time);
    if mass > 0.0 { energy.windows(2).map(step).sum() } else { 0.0 }
}
