//! The checks of the forces that a report shows besides the drag: whether they are noisy, and whether they
//! are steady.

use super::body::BodyChecks;
use super::check::Check;
use super::contact::{radius, way};
use super::limits::{self, Limit};
use super::steadiness::Trend;
use crate::history::BodySample;
use crate::history::quantities::{LEAST_SCALE, Steady};
use crate::history::steady::{NOISE_WIDTH, moving_average};

/// Part of the whole force with which a vertical or lateral one is compared where it is less: a component
/// below a third of it is not what a run is made for (chosen).
const MINOR: f64 = 0.3;

/// A force or torque of a body, as long as it is shown.
struct Shown {
    value: fn(&BodySample) -> f64,
    mean: f64,
    /// The limits of its noise and of its change.
    limits: [&'static Limit; 2],
    /// What noise and change are compared with, in the unit of the force or torque.
    scale: f64,
    /// Whether the force is meant to stay as it is: that of a body that is pressed down grows with the depth.
    is_steady: bool,
}

impl BodyChecks<'_> {
    /// Noise and change of the vertical force of a body that is held or moved vertically, of its lateral
    /// force, and of the torque that turns it.
    pub(super) fn forces(&self, inside: &[BodySample], steady: &Steady, is_towed: bool) -> Vec<Check> {
        self.shown(steady, is_towed).into_iter().flat_map(|force| self.of_force(&force, inside)).collect()
    }

    /// Whether the vertical force of a body that does not bear its weight is a considerable part of the
    /// whole.
    pub(super) fn shows_vertical(&self, steady: &Steady) -> bool {
        let vertical = steady.vertical.unwrap_or(0.0).abs();
        !self.body.heaves_freely && vertical > (MINOR * steady.whole_force()).max(self.setting.least_force())
    }

    fn shown(&self, steady: &Steady, is_towed: bool) -> Vec<Shown> {
        let least = self.setting.least_force();
        let minor = MINOR * steady.whole_force();
        let mut shown = Vec::new();
        let body = self.body;
        if let Some(mean) = steady.vertical.filter(|_| !body.heaves_freely && (is_towed || body.heaves)) {
            shown.push(Shown {
                value: |s| s.vertical,
                mean,
                limits: [&limits::VERTICAL_NOISE, &limits::STEADY_VERTICAL],
                scale: mean.abs().max(minor).max(least),
                is_steady: !body.heaves,
            });
        }
        if let Some(mean) = steady.lateral.filter(|mean| is_towed && mean.abs() > minor) {
            shown.push(Shown {
                value: |s| s.lateral,
                mean,
                limits: [&limits::LATERAL_NOISE, &limits::STEADY_LATERAL],
                scale: mean.abs().max(least),
                is_steady: true,
            });
        }
        let torques: [fn(&BodySample) -> f64; 3] = [|s| s.moment_x, |s| s.axle_torque, |s| s.moment_z];
        if let Some(axis) = body.turned_about {
            let mean = [steady.moment.map(|m| m[0]), steady.axle_torque, steady.moment.map(|m| m[2])][axis];
            let arm = radius(body);
            shown.extend(mean.map(|mean| Shown {
                value: torques[axis],
                mean,
                limits: [&limits::TORQUE_NOISE, &limits::STEADY_TORQUE],
                scale: mean.abs().max(LEAST_SCALE * arm * steady.whole_force()).max(arm * least),
                is_steady: !body.heaves || body.heaves_freely,
            }));
        }
        shown
    }

    fn of_force(&self, force: &Shown, inside: &[BodySample]) -> Vec<Check> {
        let (values, way): (Vec<f64>, _) =
            (inside.iter().map(force.value).collect(), way(inside, radius(self.body)));
        let cell = self.body.cell.into_iter().fold(f64::INFINITY, f64::min);
        let length = way.last().copied().unwrap_or(0.0);
        // A short way is averaged over a quarter of it.
        let width = (NOISE_WIDTH * self.reference.length).max(cell).min(0.25 * length);
        // Without a scale there is no force, and of a body that stands no noise.
        if length <= 0.0 || force.scale <= 0.0 || !force.mean.is_finite() {
            return Vec::new();
        }
        let smooth = moving_average(&way, &values, width);
        let square: f64 = values.iter().zip(&smooth).map(|(f, s)| (f - s).powi(2)).sum();
        let noise = (square / values.len() as f64).sqrt();
        let [of_noise, of_change] = force.limits;
        let mut checks = vec![self.check(of_noise, 100.0 * noise / force.scale)];
        if force.is_steady {
            checks.extend(self.trend(of_change, Trend::of(&values), force.scale));
        }
        checks
    }
}
