//! The joints of a mechanism as one system of equations for their impulses: J W Jᵀ λ = b.
//!
//! Solved directly, with rows that repeat others left out, so that chains and closed loops need no iteration.

use crate::joint::Row;
use crate::moving::{MovingBody, MovingJoint};
use crate::wrench::Wrench;
use numerics::semidefinite;

/// Matrix of the system and its factors, kept between steps for their memory.
#[derive(Clone, Debug, Default)]
pub(crate) struct System {
    matrix: Vec<f64>,
    factors: Vec<f64>,
    impulses: Vec<f64>,
    wanted: Vec<f64>,
    rest: Vec<f64>,
}

/// Which joints answer: all, or only the rigid ones. A spring does not answer an impact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Answer {
    All,
    Rigid,
}

/// Rounds of iterative refinement, which recover what the factors lost to round-off.
const REFINEMENTS: usize = 2;

impl System {
    /// Sets up and factors the system.
    pub(crate) fn factor(&mut self, bodies: &[MovingBody], joints: &[MovingJoint], answer: Answer) {
        let n = joints.iter().map(|joint| joint.rows.as_slice().len()).sum();
        self.matrix.clear();
        self.matrix.resize(n * n, 0.0);
        let mut column = 0;
        for (number, joint) in joints.iter().enumerate() {
            for row in joint.rows.as_slice() {
                let mut line = 0;
                for other in &joints[..=number] {
                    for across in other.rows.as_slice() {
                        let value = coupling(bodies, joint, row, other, across);
                        self.matrix[column * n + line] = value;
                        self.matrix[line * n + column] = value;
                        line += 1;
                    }
                }
                self.matrix[column * n + column] += row.compliance;
                column += 1;
            }
        }
        if answer == Answer::Rigid {
            self.silence_springs(joints, n);
        }
        self.factors.clone_from(&self.matrix);
        semidefinite::factor(&mut self.factors, n);
    }

    /// Zero rows and columns get no impulse.
    fn silence_springs(&mut self, joints: &[MovingJoint], n: usize) {
        let rows = joints.iter().flat_map(|joint| joint.rows.as_slice());
        for (k, _) in rows.enumerate().filter(|(_, row)| row.compliance > 0.0) {
            for other in 0..n {
                self.matrix[k * n + other] = 0.0;
                self.matrix[other * n + k] = 0.0;
            }
        }
    }

    /// The impulses λ for which the system yields `wanted`, row by row.
    pub(crate) fn solve(&mut self, wanted: impl Iterator<Item = f64>) -> &[f64] {
        self.wanted.clear();
        self.wanted.extend(wanted);
        self.rest.clone_from(&self.wanted);
        let n = self.rest.len();
        self.impulses.clear();
        self.impulses.resize(n, 0.0);
        for _ in 0..=REFINEMENTS {
            semidefinite::solve(&self.factors, &mut self.rest);
            for (impulse, change) in self.impulses.iter_mut().zip(&self.rest) {
                *impulse += change;
            }
            for (k, rest) in self.rest.iter_mut().enumerate() {
                let product = self.matrix[k * n..(k + 1) * n].iter().zip(&self.impulses);
                *rest = self.wanted[k] - product.map(|(a, x)| a * x).sum::<f64>();
            }
        }
        &self.impulses
    }
}

/// Velocity of one row per impulse of another.
fn coupling(bodies: &[MovingBody], joint: &MovingJoint, row: &Row, other: &MovingJoint, across: &Row) -> f64 {
    let share = |body: &usize| other.bodies.contains(&Some(*body));
    joint.bodies.iter().zip(&row.wrench).filter(|(body, _)| body.as_ref().is_some_and(share)).fold(
        0.0,
        |sum, (body, wrench)| {
            body.map_or(sum, |body| sum + other.on(across, body).dot(&bodies[body].mobility.response(wrench)))
        },
    )
}

/// All rows of all joints, in order.
pub(crate) fn rows(joints: &[MovingJoint]) -> impl Iterator<Item = (&MovingJoint, &Row)> {
    joints.iter().flat_map(|joint| joint.rows.as_slice().iter().map(move |row| (joint, row)))
}

/// Hands the impulses of all rows to their joints.
pub(crate) fn share_out(
    impulses: &[f64],
    joints: &mut [MovingJoint],
    of: impl Fn(&mut MovingJoint) -> &mut [f64; 6],
) {
    let mut rest = impulses;
    for joint in joints {
        let (own, others) = rest.split_at(joint.rows.as_slice().len());
        of(joint)[..own.len()].copy_from_slice(own);
        rest = others;
    }
}

/// Sum of the joints' impulses on a body.
pub(crate) fn on_body(joints: &[MovingJoint], body: usize, of: impl Fn(&MovingJoint) -> &[f64; 6]) -> Wrench {
    let mut sum = Wrench::ZERO;
    for joint in joints.iter().filter(|joint| joint.bodies.contains(&Some(body))) {
        for (row, impulse) in joint.rows.as_slice().iter().zip(of(joint)) {
            sum += *impulse * joint.on(row, body);
        }
    }
    sum
}
