//! Contact by velocity impulses: non-penetration and Coulomb friction at the velocity level (Moreau 1988,
//! Jean 1999).
//!
//! Solved by symmetric projected Gauss–Seidel sweeps, warm-started from the impulses of the last step, with
//! the bodies inside the iteration: no contact stiffness, no limit on the time step, stable for bodies much
//! lighter than the soil that they displace.
//!
//! An open contact point keeps its gap and may close it within a step, but no further.

use super::constraint::Constraint;
use super::cut_cell::is_aligned;
use super::effective_mass::EffectiveMass;
use super::gauss_seidel::{self, Prepared, SweptIsland};
use super::law::ContactLaw;
use super::problem::{ContactProblem, POINTS_AT_ONCE, slip_velocity};
use crate::state::Contact;
use glam::DVec3;
use std::sync::atomic::{AtomicBool, Ordering};

/// Impulse contact: the constraints of a step and the islands during its sweeps.
#[derive(Debug, Default)]
pub(super) struct Impulses {
    /// Constraints with their effective masses, by number.
    prepared: Vec<Prepared>,
    /// Numbers of the active ones, in the order of their first points.
    order: Vec<usize>,
    /// For each contact point whether it is active.
    is_active: Vec<AtomicBool>,
    islands: Vec<SweptIsland>,
}

/// Memory for each constraint [bytes].
pub(super) const PER_CONSTRAINT: f64 =
    (size_of::<Prepared>() + size_of::<usize>() + gauss_seidel::PER_CONSTRAINT) as f64;

/// Constraints that a thread takes at least: fewer are not worth its waking.
const CONSTRAINTS_AT_ONCE: usize = 16;
/// Symmetric sweeps per step; fewer than two give wrong forces.
const SWEEPS: usize = 4;
/// Separation threshold: an active point of a curved or inclined face opens when the volume fractions show a
/// gap of this many cells. With a larger one a rolling wheel opens a void under itself and climbs on it.
const SEPARATION: f64 = 0.05;
/// Separation threshold [cells] on a face that is aligned with the grid. The edges of a sliding face cut
/// cells, in which volume fractions are a poor measure of the gap: with the smaller threshold the force on a
/// sliding footing is 7 % too low.
const SEPARATION_FLAT: f64 = 0.5;
/// Gap relaxation: fraction of the difference to the geometric gap that an open point takes over per tenth of
/// a cell of travel.
const GAP_RELAXATION: f64 = 0.3;
/// Gaps that are less, in cells, are round-off of volume fractions that fill a cell, and closed: it must not
/// decide which points of a body act that starts in the soil.
const ROUND_OFF: f64 = 1e-12;
/// Points with a larger gap, in cells, cannot close within a step.
const REACH: f64 = 0.05;

impl ContactLaw for Impulses {
    fn update(&self, c: &mut Contact, gap: f64, travel: Option<f64>) {
        let touches = travel.is_some() && is_closed(c);
        let separation = if is_aligned(c.normal) { SEPARATION_FLAT } else { SEPARATION };
        if touches && gap < separation * c.width {
            c.penetration = 0.0;
            return;
        }
        let open = travel.filter(|_| !touches);
        let relaxation = open.map_or(1.0, |travel| (GAP_RELAXATION * travel / (0.1 * c.width)).min(1.0));
        c.penetration = (c.penetration + relaxation * (-gap - c.penetration)).min(0.0);
        c.impulse = DVec3::ZERO;
    }

    fn act(&mut self, problem: &mut ContactProblem) {
        self.prepare(problem);
        self.sweep(problem);
        self.update_history(problem);
    }
}

impl Impulses {
    /// Finds the active points, their constraints and effective masses.
    fn prepare(&mut self, problem: &ContactProblem) {
        let touches = |n: usize| {
            let c = &problem.contacts[n];
            let closing = || problem.slip_velocity_of(n).dot(c.normal);
            is_closed(c) || c.penetration > -REACH * c.width && c.penetration + closing() * problem.dt > 0.0
        };
        let Self { prepared, order, is_active, .. } = self;
        is_active.resize_with(problem.contacts.len(), AtomicBool::default);
        prepared.resize_with(problem.constraint_points.len(), Prepared::default);
        problem.crew.portions(prepared, CONSTRAINTS_AT_ONCE, |first, prepared| {
            for (n, one) in prepared.iter_mut().enumerate() {
                let constraint = Constraint::of(problem, first + n, |point| {
                    let touches = touches(point);
                    is_active[point].store(touches, Ordering::Relaxed);
                    touches
                });
                let mass = constraint.first.and_then(|point| EffectiveMass::new(problem, &constraint, point));
                *one = (constraint, mass);
            }
        });
        order.clear();
        order.extend((0..prepared.len()).filter(|n| prepared[*n].0.first.is_some()));
        order.sort_unstable_by_key(|n| prepared[*n].0.first);
    }

    /// Finds the impulses of the constraints, and the velocities with them.
    fn sweep(&mut self, problem: &mut ContactProblem) {
        let Self { prepared, order, islands, .. } = self;
        let count = problem.islands.nodes.len();
        islands.resize_with(count, SweptIsland::default);
        let least = (CONSTRAINTS_AT_ONCE * count).div_ceil(order.len().max(1)).max(1);
        // Joints and touching bodies connect islands; without them all sweeps are one piece of work.
        let is_connected = problem.moving.are_bodies_connected();
        let (known, sweeps) = (&*problem, if is_connected { 0 } else { SWEEPS });
        problem.crew.portions(islands, least, |first, islands| {
            for (n, island) in islands.iter_mut().enumerate() {
                island.begin(known, first + n, prepared, order);
                island.sweep(sweeps);
            }
        });
        for _ in 0..if is_connected { SWEEPS } else { 0 } {
            problem
                .crew
                .portions(islands, least, |_, islands| islands.iter_mut().for_each(|island| island.sweep(1)));
            islands.iter().for_each(|island| island.put_bodies_back(problem));
            problem.moving.settle();
            islands.iter_mut().for_each(|island| island.strike(problem));
        }
        for (n, island) in islands.iter().enumerate() {
            island.put_back(problem, n, prepared);
        }
    }

    /// Updates the history of the points: the portion of each of its constraint's impulse, and its distance.
    fn update_history(&self, problem: &mut ContactProblem) {
        let Self { prepared, is_active, .. } = self;
        let ContactProblem {
            contacts,
            impulses,
            velocity,
            corner_nodes,
            moving,
            constraint_points,
            dt,
            crew,
            ..
        } = problem;
        let (velocity, moving, dt) = (&**velocity, &**moving, *dt);
        crew.portions2(contacts, impulses, POINTS_AT_ONCE, |first, contacts, impulses| {
            for (n, (c, impulses)) in contacts.iter_mut().zip(impulses).enumerate() {
                let n = first + n;
                let constraint = &prepared[constraint_points.number[n]].0;
                let constraint = is_active[n].load(Ordering::Relaxed).then_some(constraint);
                *impulses = take_portion(c, constraint);
                let closing = slip_velocity(c, velocity, &corner_nodes[n], moving).dot(c.normal);
                move_on(c, closing * dt, constraint);
            }
        });
    }
}

/// Whether a point is in contact.
fn is_closed(c: &Contact) -> bool {
    c.penetration >= -ROUND_OFF * c.width
}

/// Gives a point its portion of its constraint's impulse, if it has one. Returns its normal and frictional
/// portions [N s].
fn take_portion(c: &mut Contact, constraint: Option<&Constraint>) -> [DVec3; 2] {
    c.impulse = constraint.map_or(DVec3::ZERO, |p| (c.area / p.area) * p.impulse);
    constraint.map_or([DVec3::ZERO; 2], |p| {
        let normal = c.impulse.dot(p.jacobian.normal) * p.jacobian.normal;
        [normal, c.impulse - normal]
    })
}

/// Updates the distance of a point by how far it has closed in the step [m].
fn move_on(c: &mut Contact, closed: f64, constraint: Option<&Constraint>) {
    // Round-off must not open an active point.
    let held = constraint.is_some_and(|p| p.impulse.dot(p.jacobian.normal) > 0.0);
    c.penetration = if held { 0.0 } else { (c.penetration + closed).min(0.0) };
}
