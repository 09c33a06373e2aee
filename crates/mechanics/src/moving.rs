//! Bodies and joints during one step.

use crate::body::{Body, BodyState, Momentum};
use crate::configuration::Configuration;
use crate::gimbal::Axes;
use crate::impulses::Impulses;
use crate::joint::{Row, Rows};
use crate::mobility::Mobility;
use crate::spatial::SpatialInertia;
use crate::twist::Twist;
use crate::wrench::Wrench;
use glam::DVec3;
use numerics::semidefinite;

/// A body during one step. Impulses are about the reference point, on the whole body.
#[derive(Clone, Debug)]
pub(crate) struct MovingBody {
    pub(crate) modelled_fraction: f64,
    /// Speeds of the prescribed motions [m/s or rad/s].
    pub(crate) speeds: [f64; 6],
    pub(crate) configuration: Configuration,
    /// Axis of tilt at the end.
    pub(crate) tilt_axis: DVec3,
    /// Mean axes of the rotational freedoms.
    pub(crate) axes: Axes,
    pub(crate) inertia: SpatialInertia,
    pub(crate) mobility: Mobility,
    pub(crate) impulses: Impulses,
    /// Change of the twist at the start of the step.
    pub(crate) kick: Twist,
    /// Momentum after the impulses at the start.
    pub(crate) struck: Momentum,
    /// Twist that the impulses at the start of the step meet.
    pub(crate) met: Twist,
    /// Angular impulse about the centre of mass within the step [N m s].
    pub(crate) torque: DVec3,
    /// Momentum at the end.
    pub(crate) end: Momentum,
    /// Twist of the step before.
    pub(crate) before: Twist,
    /// Twist without contact.
    pub(crate) predicted: Twist,
    /// Twist of this step.
    pub(crate) twist: Twist,
    /// Next iterate of the twist.
    pub(crate) next: Twist,
}

impl MovingBody {
    /// A body whose motion is yet to be found.
    pub(crate) fn new(body: &Body, now: &BodyState, speeds: [f64; 6]) -> Self {
        let configuration = Configuration::new(&now.pose, &Twist::ZERO, 0.0);
        Self {
            modelled_fraction: body.modelled_fraction,
            speeds,
            configuration,
            tilt_axis: now.tilt_axis,
            axes: DVec3::AXES,
            inertia: configuration.mean_inertia(&body.inertia),
            mobility: Mobility::default(),
            impulses: Impulses::default(),
            kick: Twist::ZERO,
            struck: now.momentum,
            met: Twist::ZERO,
            torque: DVec3::ZERO,
            end: now.momentum,
            before: now.twist,
            predicted: now.twist,
            twist: now.twist,
            next: now.twist,
        }
    }
}

/// A joint during one step.
#[derive(Clone, Debug)]
pub(crate) struct MovingJoint {
    pub(crate) bodies: [Option<usize>; 2],
    pub(crate) rows: Rows,
    /// Impulses of the rows: as a reaction; within the step, half of them; by relaxation.
    pub(crate) reaction: [f64; 6],
    pub(crate) within: [f64; 6],
    pub(crate) relaxed: [f64; 6],
    /// Factors of the joint's own block of the system.
    block: [f64; 36],
}

impl MovingJoint {
    /// A joint whose rows are yet to be found.
    pub(crate) fn new(bodies: [Option<usize>; 2]) -> Self {
        let none = [0.0; 6];
        Self { bodies, rows: Rows::default(), reaction: none, within: none, relaxed: none, block: [0.0; 36] }
    }

    /// The wrench of a row on a body, if the joint acts on it.
    pub(crate) fn on(&self, row: &Row, body: usize) -> Wrench {
        let side = |n: usize| if self.bodies[n] == Some(body) { row.wrench[n] } else { Wrench::ZERO };
        side(0) + side(1)
    }

    /// Relative velocity of a row.
    pub(crate) fn velocity(&self, row: &Row, twist: impl Fn(usize) -> Twist) -> f64 {
        let of = |n: usize| self.bodies[n].map_or(0.0, |body| row.wrench[n].dot(&twist(body)));
        of(0) + of(1)
    }

    /// Factors the joint's own block, for relaxation.
    pub(crate) fn prepare(&mut self, bodies: &[MovingBody]) {
        let rows = self.rows;
        let rows = rows.as_slice();
        let n = rows.len();
        let mut block = [0.0; 36];
        for (j, column) in rows.iter().enumerate() {
            let response = |body: usize| bodies[body].mobility.response(&self.on(column, body));
            for (i, row) in rows.iter().enumerate() {
                let yields = if i == j { row.compliance } else { 0.0 };
                block[i * n + j] = self.velocity(row, response) + yields;
            }
        }
        semidefinite::factor(&mut block[..n * n], n);
        self.block = block;
    }

    /// What is missing of a row's condition [m/s or rad/s].
    pub(crate) fn missing(&self, k: usize, row: &Row, bodies: &[MovingBody]) -> f64 {
        let yielding = row.compliance * (self.within[k] + self.relaxed[k]);
        row.bias - self.velocity(row, |body| bodies[body].twist) - yielding
    }

    /// Impulses that restore the joint, if it were alone.
    pub(crate) fn restoring(&self, bodies: &[MovingBody]) -> [f64; 6] {
        let rows = self.rows.as_slice();
        let n = rows.len();
        let mut impulses = [0.0; 6];
        for (k, row) in rows.iter().enumerate() {
            impulses[k] = self.missing(k, row, bodies);
        }
        semidefinite::solve(&self.block[..n * n], &mut impulses[..n]);
        impulses
    }

    /// Applies impulses of its rows to its bodies.
    pub(crate) fn apply(&mut self, impulses: &[f64], bodies: &mut [MovingBody]) {
        for (k, (row, impulse)) in self.rows.as_slice().iter().zip(impulses).enumerate() {
            self.relaxed[k] += impulse;
            for (body, wrench) in self.bodies.iter().zip(&row.wrench) {
                if let Some(body) = body {
                    let body = &mut bodies[*body];
                    body.twist += body.mobility.response(&(*impulse * *wrench));
                }
            }
        }
    }
}
