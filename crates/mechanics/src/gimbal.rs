//! The axes of the three rotational degrees of freedom: yaw about the vertical of space, tilt about the x
//! axis that yaw carries, spin about the body's own y axis, its axle.
//!
//! Mean axes ½(a₀ + a₁) over a step make the restrictions exact: with the Cayley map Δa = Δt ω × ā, so that
//! an angular velocity without a tilt component, ω in the plane of z and ā, keeps a · z to round-off.

use crate::twist::Twist;
use glam::{DMat3, DVec3};

/// Below this sine of the angle between axle and vertical, yaw and spin are taken for parallel.
const PARALLEL: f64 = 1e-9;

/// Axes of yaw, tilt and spin in space.
pub(crate) type Axes = [DVec3; 3];

/// Tilt axis of an attitude, given that of a nearby one; where the axle is vertical it stays what it was.
pub(crate) fn tilt_axis(attitude: &DMat3, near: DVec3) -> DVec3 {
    let horizontal = attitude.y_axis.cross(DVec3::Z);
    let sine = horizontal.length();
    if sine < PARALLEL { near } else { horizontal * (near.dot(horizontal).signum() / sine) }
}

/// Tilt axis of an attitude whose axle is inclined by less than 90°; of a vertical axle, the body's own x
/// axis.
pub(crate) fn first_tilt_axis(attitude: &DMat3) -> DVec3 {
    let horizontal = attitude.y_axis.cross(DVec3::Z);
    let own = DVec3::new(attitude.x_axis.x, attitude.x_axis.y, 0.0).try_normalize().unwrap_or(DVec3::X);
    tilt_axis(attitude, if horizontal.length() < PARALLEL { own } else { horizontal })
}

/// Mean axes between two attitudes with their tilt axes.
pub(crate) fn mean_axes(start: &DMat3, tilt: DVec3, end: &DMat3, end_tilt: DVec3) -> Axes {
    [DVec3::Z, 0.5 * (tilt + end_tilt), 0.5 * (start.y_axis + end.y_axis)]
}

/// Rates of yaw, tilt and spin of an angular velocity [rad/s].
pub(crate) fn rates(angular: DVec3, [yaw, tilt, spin]: &Axes) -> [f64; 3] {
    let rest = angular - angular.dot(*tilt) * *tilt;
    let cosine = yaw.dot(*spin);
    let determinant = 1.0 - cosine * cosine;
    if determinant < PARALLEL {
        return [0.0, angular.dot(*tilt), rest.dot(*spin)];
    }
    let (along_yaw, along_spin) = (rest.dot(*yaw), rest.dot(*spin));
    [
        (along_yaw - cosine * along_spin) / determinant,
        angular.dot(*tilt),
        (along_spin - cosine * along_yaw) / determinant,
    ]
}

/// Twists of unit speed: along x, y, z; about the axes of yaw, tilt and spin.
pub(crate) fn unit_twists(axes: &Axes) -> [Twist; 6] {
    std::array::from_fn(|n| {
        if n < 3 {
            Twist { linear: DVec3::AXES[n], angular: DVec3::ZERO }
        } else {
            Twist { linear: DVec3::ZERO, angular: axes[n - 3] }
        }
    })
}
