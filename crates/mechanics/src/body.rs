//! One rigid body: what is fixed during a run, and its state.

use crate::configuration::Configuration;
use crate::error::Invalid;
use crate::fluid::Fluid;
use crate::gimbal;
use crate::inertia::Inertia;
use crate::motion::Motion;
use crate::pose::Pose;
use crate::twist::Twist;
use crate::wrench::Wrench;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// A body: its mass properties and its degrees of freedom.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Mass properties of the whole body.
    pub inertia: Inertia,
    /// Degrees of freedom: along x, y, z of space; yaw about z, tilt about the x axis that yaw carries, spin
    /// about the body's y axis, its axle. If all three rotations are free the body rotates freely.
    pub motion: [Motion; 6],
    /// Fraction of the body that is modelled: ½ for each symmetry plane through it; of a slice of a long body
    /// the slice over the width that the rest refers to. Impulses act on this fraction; everything else
    /// refers to the whole body.
    pub modelled_fraction: f64,
    /// The fluid that the body moves in.
    pub fluid: Fluid,
}

impl Body {
    /// A body that moves freely.
    #[must_use]
    pub fn free(inertia: Inertia) -> Self {
        Self::new(inertia, [const { Motion::FREE }; 6])
    }

    /// A body with given degrees of freedom, modelled as a whole.
    #[must_use]
    pub fn new(inertia: Inertia, motion: [Motion; 6]) -> Self {
        Self { inertia, motion, modelled_fraction: 1.0, fluid: Fluid::NONE }
    }

    /// Whether no rotation is fixed or prescribed.
    #[must_use]
    pub fn rotates_freely(&self) -> bool {
        self.motion[3..].iter().all(Motion::is_free)
    }

    /// Whether every motion is free.
    #[must_use]
    pub fn moves_freely(&self) -> bool {
        self.motion.iter().all(Motion::is_free)
    }

    /// Whether the body can be computed.
    ///
    /// # Errors
    /// [`Invalid`] where a free motion lacks the mass properties it needs.
    pub fn check(&self) -> Result<(), Invalid> {
        if !(self.modelled_fraction > 0.0 && self.modelled_fraction.is_finite()) {
            return Err(Invalid::ModelledFraction);
        }
        // Also without free motions: what is not a number would spread into momenta and reactions.
        if !(self.inertia.mass.is_finite() && self.inertia.centre.is_finite()) {
            return Err(Invalid::Mass);
        }
        let Fluid { displaced, centre, drag } = self.fluid;
        if !(displaced.is_finite() && centre.is_finite() && drag.is_finite()) {
            return Err(Invalid::Fluid);
        }
        if !self.inertia.tensor.is_finite() {
            return Err(Invalid::Tensor);
        }
        let may_turn = self.motion[3..].iter().any(Motion::is_free);
        let may_move = self.motion.iter().any(Motion::is_free);
        match self.inertia.check() {
            Err(Invalid::Mass) if may_move => Err(Invalid::Mass),
            Err(error) if may_turn => Err(error),
            _ => Ok(()),
        }
    }

    /// Speeds of the prescribed motions at a time [s], in [m/s or rad/s]; 0 for the others.
    #[must_use]
    pub fn speeds(&self, time: f64) -> [f64; 6] {
        self.motion.each_ref().map(|motion| motion.speed(time))
    }

    /// The state of the body at a pose with a velocity; what its fixed motions forbid is left out of the
    /// velocity.
    #[must_use]
    pub fn state(&self, pose: Pose, twist: Twist) -> BodyState {
        let rotation = pose.rotation.normalize();
        let pose =
            Pose { rotation: if rotation.is_finite() { rotation } else { glam::DQuat::IDENTITY }, ..pose };
        let attitude = pose.axes();
        let tilt_axis = gimbal::first_tilt_axis(&attitude);
        let axes = [DVec3::Z, tilt_axis, attitude.y_axis];
        let [yaw, tilt, spin] = gimbal::rates(twist.angular, &axes);
        let linear = twist.linear;
        let mut speeds = [linear.x, linear.y, linear.z, yaw, tilt, spin];
        for (speed, motion) in speeds.iter_mut().zip(&self.motion) {
            if motion.is_fixed() {
                *speed = 0.0;
            }
        }
        let columns = gimbal::unit_twists(&axes).into_iter().zip(speeds);
        let mut allowed = columns.fold(Twist::ZERO, |sum, (column, speed)| sum + speed * column);
        if self.rotates_freely() {
            allowed.angular = twist.angular;
        }
        let inertia = Configuration::new(&pose, &Twist::ZERO, 0.0).mean_inertia(&self.inertia);
        BodyState {
            pose,
            twist: allowed,
            momentum: Momentum {
                linear: inertia.mass * allowed.at(inertia.arm),
                angular: inertia.tensor * allowed.angular,
            },
            speeds: std::array::from_fn(|n| if self.motion[n].is_free() { 0.0 } else { speeds[n] }),
            tilt_axis,
        }
    }

    /// The state in which other motions take over: pose, velocity and momentum stay, and the prescribed
    /// motions begin at the speeds that the body has.
    #[must_use]
    pub fn taken_over(&self, state: &BodyState) -> BodyState {
        let rates = state.rates();
        BodyState {
            speeds: std::array::from_fn(|n| match self.motion[n] {
                Motion::Fixed | Motion::Free { .. } => 0.0,
                Motion::Prescribed { .. } | Motion::Course(_) => rates[n],
            }),
            ..*state
        }
    }

    /// Kinetic energy [J] of the whole body, prescribed motions included.
    #[must_use]
    pub fn kinetic_energy(&self, state: &BodyState) -> f64 {
        let Momentum { linear, angular } = state.momentum;
        let turning = state.pose.axes().transpose() * angular;
        let moving = if self.inertia.mass > 0.0 { linear.length_squared() / self.inertia.mass } else { 0.0 };
        0.5 * (moving + turning.dot(self.inertia.inverse_tensor() * turning))
    }

    /// Potential energy [J] of the whole body in a gravity field [m/s²], less that of the fluid that it
    /// displaces; 0 with both centres at the origin.
    #[must_use]
    pub fn potential_energy(&self, state: &BodyState, gravity: DVec3) -> f64 {
        let displaced = self.fluid.displaced * state.pose.point(self.fluid.centre);
        gravity.dot(displaced - self.inertia.mass * self.centre(state))
    }

    /// Centre of mass in space [m].
    #[must_use]
    pub fn centre(&self, state: &BodyState) -> DVec3 {
        state.pose.point(self.inertia.centre)
    }
}

impl BodyState {
    /// Axis of tilt: the level unit vector across the axle, forwards of a body that has not been turned
    /// round.
    #[must_use]
    pub fn tilt_axis(&self) -> DVec3 {
        self.tilt_axis
    }

    /// Speeds along x, y, z, of yaw, tilt and spin [m/s or rad/s].
    #[must_use]
    pub fn rates(&self) -> [f64; 6] {
        let axes = [DVec3::Z, self.tilt_axis, self.pose.axes().y_axis];
        let ([yaw, tilt, spin], linear) = (gimbal::rates(self.twist.angular, &axes), self.twist.linear);
        [linear.x, linear.y, linear.z, yaw, tilt, spin]
    }
}

/// Momentum of a whole body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Momentum {
    /// Linear momentum [N s].
    pub linear: DVec3,
    /// Angular momentum about the centre of mass, axes of space [N m s].
    pub angular: DVec3,
}

impl Momentum {
    /// The momentum after an impulse about the reference point, when the centre of mass is at `arm` from
    /// it [m].
    pub(crate) fn after(&self, impulse: &Wrench, arm: DVec3) -> Self {
        Self { linear: self.linear + impulse.force, angular: self.angular + impulse.moment_about(arm) }
    }

    /// Momentum, and angular momentum about the reference point, when the centre of mass is at `arm` from
    /// it [m].
    pub(crate) fn about_reference(&self, arm: DVec3) -> Wrench {
        Wrench { force: self.linear, moment: self.angular + arm.cross(self.linear) }
    }
}

/// The state of a body: what changes in a step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BodyState {
    /// Pose at the end of the last step.
    pub pose: Pose,
    /// Twist during the last step, half a step before the pose.
    pub twist: Twist,
    /// Momentum at the end of the last step.
    pub momentum: Momentum,
    /// Speeds of the prescribed motions during the last step [m/s or rad/s].
    pub(crate) speeds: [f64; 6],
    /// Axis of tilt.
    pub(crate) tilt_axis: DVec3,
}
