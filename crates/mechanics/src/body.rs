//! One rigid body: what is fixed during a run, and its state.

use crate::configuration::Configuration;
use crate::error::Invalid;
use crate::fluid::Fluid;
use crate::gimbal;
use crate::inertia::Inertia;
use crate::motion::Motion;
use crate::pose::Pose;
use crate::steering::Steering;
use crate::twist::Twist;
use crate::wrench::Wrench;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// A body: its mass properties and its degrees of freedom.
#[derive(Clone, Debug, PartialEq)]
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
    /// How another program steers the body, if one does.
    pub steering: Option<Steering>,
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
        Self { inertia, motion, modelled_fraction: 1.0, fluid: Fluid::NONE, steering: None }
    }

    /// The body as another program steers it. Where that replaces its motion, mass and fluid are those of the
    /// other program.
    #[must_use]
    pub fn steered(self, steering: Steering) -> Self {
        let motion = match steering {
            Steering::Loaded(_) => return Self { steering: Some(steering), ..self },
            Steering::Prescribed(_) => [const { Motion::Fixed }; 6],
            Steering::Coupled { .. } => [const { Motion::FREE }; 6],
        };
        let modelled_fraction = self.modelled_fraction;
        Self { modelled_fraction, steering: Some(steering), ..Self::new(Inertia::NONE, motion) }
    }

    /// Twist of the prescribed motions at their speeds, for rotational freedoms with these axes; other
    /// entries are ignored.
    pub(crate) fn driven(&self, speeds: &[f64; 6], axes: &gimbal::Axes) -> Twist {
        if let Some(Steering::Prescribed(_)) = self.steering {
            return Twist::of(*speeds);
        }
        let each = gimbal::unit_twists(axes).into_iter().zip(speeds).zip(&self.motion);
        let moving = each.filter(|((_, speed), motion)| !motion.is_free() && **speed != 0.0);
        moving.fold(Twist::ZERO, |sum, ((column, speed), _)| sum + *speed * column)
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
        if self.steering.is_some_and(|steering| steering.replaces_motion()) {
            return Ok(());
        }
        let may_turn = self.motion[3..].iter().any(Motion::is_free);
        let may_move = self.motion.iter().any(Motion::is_free);
        match self.inertia.check() {
            Err(Invalid::Mass) if may_move => Err(Invalid::Mass),
            Err(error) if may_turn => Err(error),
            _ => Ok(()),
        }
    }

    /// Speeds of the prescribed motions at a time [s], in [m/s or rad/s]; 0 for the others. Of a twist that
    /// another program prescribes, its components.
    #[must_use]
    pub fn speeds(&self, time: f64) -> [f64; 6] {
        if let Some(Steering::Prescribed(twist)) = self.steering {
            return twist.components();
        }
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
        BodyState {
            pose,
            twist: allowed,
            momentum: self.momentum(&pose, &allowed),
            is_elsewhere: false,
            speeds: std::array::from_fn(|n| if self.motion[n].is_free() { 0.0 } else { speeds[n] }),
            tilt_axis,
        }
    }

    /// The state in which other motions take over: pose, velocity and momentum stay, and the prescribed
    /// motions begin at the speeds that the body has. A body that another program moves has its momentum
    /// there, and gets it from its velocity when it returns.
    #[must_use]
    pub fn taken_over(&self, state: &BodyState) -> BodyState {
        let is_elsewhere = self.steering.is_some_and(|steering| steering.replaces_motion());
        let speeds = state.twist.components();
        if is_elsewhere {
            return BodyState { speeds, momentum: Momentum::default(), is_elsewhere, ..*state };
        }
        let rates = state.rates();
        let momentum =
            if state.is_elsewhere { self.momentum(&state.pose, &state.twist) } else { state.momentum };
        BodyState {
            momentum,
            is_elsewhere,
            speeds: std::array::from_fn(|n| match self.motion[n] {
                Motion::Fixed | Motion::Free { .. } => 0.0,
                Motion::Prescribed { .. } | Motion::Course(_) => rates[n],
            }),
            ..*state
        }
    }

    /// Momentum of the body at a pose with a velocity.
    fn momentum(&self, pose: &Pose, twist: &Twist) -> Momentum {
        let inertia = Configuration::new(pose, &Twist::ZERO, 0.0).mean_inertia(&self.inertia);
        Momentum { linear: inertia.mass * twist.at(inertia.arm), angular: inertia.tensor * twist.angular }
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

    /// Whether another program moves the body and keeps its momentum.
    #[must_use]
    pub fn is_elsewhere(&self) -> bool {
        self.is_elsewhere
    }

    /// Speeds along x, y, z, of yaw, tilt and spin [m/s or rad/s].
    #[must_use]
    pub fn rates(&self) -> [f64; 6] {
        self.rates_of(&self.twist)
    }

    /// Speeds of a twist along x, y, z, of yaw, tilt and spin [m/s or rad/s], in the attitude of the body.
    #[must_use]
    pub fn rates_of(&self, twist: &Twist) -> [f64; 6] {
        let ([yaw, tilt, spin], linear) = (gimbal::rates(twist.angular, &self.axes()), twist.linear);
        [linear.x, linear.y, linear.z, yaw, tilt, spin]
    }

    /// Twists of unit speed along x, y, z, of yaw, tilt and spin.
    #[must_use]
    pub fn unit_twists(&self) -> [Twist; 6] {
        gimbal::unit_twists(&self.axes())
    }

    /// Axes of yaw, tilt and spin.
    fn axes(&self) -> gimbal::Axes {
        [DVec3::Z, self.tilt_axis, self.pose.axes().y_axis]
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
    /// Whether another program moves the body and keeps its momentum.
    pub(crate) is_elsewhere: bool,
}
