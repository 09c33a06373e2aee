//! Contact by velocity impulses: non-penetration and Coulomb friction at the velocity level (Moreau 1988,
//! Jean 1999).
//!
//! Solved by symmetric projected Gauss–Seidel sweeps, warm-started from the impulses of the last step, with
//! the bodies inside the iteration: no contact stiffness, no limit on the time step, stable for bodies much
//! lighter than the soil that they displace.
//!
//! An open contact point keeps its gap and may close it within a step, but no further. Where the volume
//! fractions show soil inside a body, a bias velocity proportional to the body's speed removes the overlap; a
//! body at rest has none, so that its load does not drift.

use super::constraint::{self, Constraint, Constraints};
use super::cut_cell::is_aligned;
use super::law::ContactLaw;
use super::problem::{ContactJacobian, ContactProblem, over_corners};
use crate::state::Contact;
use glam::DVec3;

/// Impulse contact: the active constraints of a step and their effective masses.
#[derive(Debug, Default)]
pub(super) struct Impulses {
    constraints: Constraints,
    masses: Vec<Option<EffectiveMass>>,
    groups: Vec<Group>,
}

/// Memory for each constraint [bytes].
pub(super) const PER_CONSTRAINT: f64 =
    (constraint::PER_CONSTRAINT + size_of::<Option<EffectiveMass>>() + size_of::<Group>()) as f64;

/// Symmetric sweeps per step; fewer than two give wrong forces.
const SWEEPS: usize = 4;
/// Separation threshold: an active point of a curved or inclined face opens when the volume fractions show a
/// gap of this many cells. With a larger one a rolling wheel opens a void under itself and climbs on it.
const SEPARATION: f64 = 0.05;
/// The same on a face that is aligned with the grid. The edges of a sliding face cut cells, in which volume
/// fractions are a poor measure of the gap: with the smaller threshold the force on a sliding footing is 7 %
/// too low.
const SEPARATION_FLAT: f64 = 0.5;
/// Gap relaxation: fraction of the difference to the geometric gap that an open point takes over per tenth of
/// a cell of travel.
const GAP_RELAXATION: f64 = 0.3;
/// Fraction of an overlap that the bias velocity removes while the body travels one cell.
const OVERLAP_BIAS: f64 = 1.0;
/// Gaps that are less, in cells, are round-off of volume fractions that fill a cell, and closed: it must not decide which points of
/// a body act that starts in the soil.
const ROUND_OFF: f64 = 1e-12;
/// Points with a larger gap, in cells, cannot close within a step.
const REACH: f64 = 0.05;

impl ContactLaw for Impulses {
    fn update(&self, c: &mut Contact, gap: f64, travel: Option<f64>) {
        let touches = travel.is_some() && is_closed(c);
        let separation = if is_aligned(c.normal) { SEPARATION_FLAT } else { SEPARATION };
        if touches && gap < separation * c.width {
            c.penetration = (-gap).max(0.0);
            return;
        }
        let open = travel.filter(|_| !touches);
        let relaxation = open.map_or(1.0, |travel| (GAP_RELAXATION * travel / (0.1 * c.width)).min(1.0));
        c.penetration = (c.penetration + relaxation * (-gap - c.penetration)).min(0.0);
        c.impulse = DVec3::ZERO;
    }

    fn act(&mut self, problem: &mut ContactProblem) {
        let touches = |n: usize| {
            let c = &problem.contacts[n];
            let closing = || problem.slip_velocity_of(n).dot(c.normal);
            is_closed(c) || c.penetration > -REACH * c.width && c.penetration + closing() * problem.dt > 0.0
        };
        let Self { constraints, masses, groups } = self;
        constraints.find(problem, touches);
        let (constraints, constraint_of) = (&mut constraints.each, &constraints.of_contact);
        masses.clear();
        masses.extend(constraints.iter().map(|p| EffectiveMass::new(problem, p)));
        mirrored_groups(problem, constraints, masses, groups);
        for group in groups.iter() {
            group.apply(problem, constraints, [group.first, group.second].map(|n| constraints[n].impulse));
        }
        for _ in 0..SWEEPS {
            for group in groups.iter().chain(groups.iter().rev()) {
                group.relax(problem, constraints, masses);
            }
            problem.moving.relax_joints();
        }
        for (n, constraint) in constraint_of.iter().enumerate() {
            update_history(problem, n, constraint.map(|p| &constraints[p]));
        }
    }
}

/// Whether a point is in contact.
fn is_closed(c: &Contact) -> bool {
    c.penetration >= -ROUND_OFF * c.width
}

/// Updates the history of a point: its portion of its constraint's impulse, if it has one, and its distance.
fn update_history(problem: &mut ContactProblem, n: usize, constraint: Option<&Constraint>) {
    let area = problem.contacts[n].area;
    let impulse = constraint.map_or(DVec3::ZERO, |p| (area / p.area) * p.impulse);
    if let Some(constraint) = constraint {
        let normal = impulse.dot(constraint.jacobian.normal) * constraint.jacobian.normal;
        problem.record(n, normal, impulse - normal);
    }
    let slip = problem.slip_velocity_of(n);
    let c = &mut problem.contacts[n];
    let penetration = (c.penetration + slip.dot(c.normal) * problem.dt).min(c.penetration.max(0.0));
    // Round-off must not open an active point.
    let held = constraint.is_some_and(|p| p.impulse.dot(p.jacobian.normal) > 0.0);
    c.penetration = if held { penetration.max(0.0) } else { penetration };
    c.impulse = impulse;
}

/// Effective masses and limits of a constraint, constant during the sweeps of a step.
#[derive(Debug)]
struct EffectiveMass {
    /// Normal effective mass: inverse of the diagonal of the Delassus operator along the normal [kg].
    normal_mass: f64,
    /// Tangential effective mass: the same along the axis in which it is least [kg].
    tangential_mass: f64,
    /// Bias velocity: closing velocity that the constraint asks for [m/s].
    bias_velocity: f64,
    /// Coefficient of friction.
    friction: f64,
    /// Largest frictional impulse in a step [N s].
    shear_limit: f64,
}

impl EffectiveMass {
    /// `None` where neither soil nor body can move along the normal: there is nothing to solve for.
    fn new(problem: &ContactProblem, constraint: &Constraint) -> Option<Self> {
        let (jacobian, normal) = (&constraint.jacobian, constraint.jacobian.normal);
        let delassus_diagonal = delassus_diagonal(problem, jacobian);
        let soil = |n: usize| {
            let impulse = jacobian.on_node(n, normal);
            (impulse * impulse).dot(problem.nodes[jacobian.nodes[n] as usize].inverse_mass)
        };
        let normal_mass = over_corners(std::array::from_fn(soil))
            + delassus_of_body(problem, jacobian).dot(normal * normal);
        (normal_mass > 0.0).then(|| Self {
            normal_mass: 1.0 / normal_mass,
            tangential_mass: 1.0 / delassus_diagonal.max_element(),
            bias_velocity: -OVERLAP_BIAS * constraint.overlap * bias_speed(problem, constraint),
            friction: problem.model.bodies[constraint.jacobian.body].friction.min(1e6),
            // All points of a constraint lie in one cell.
            shear_limit: problem.contacts[constraint.first].shear_limit * constraint.area * problem.dt,
        })
    }

    /// The impulse after one relaxation, projected on the Coulomb cone.
    fn projected_impulse(&self, problem: &ContactProblem, constraint: &Constraint, relaxation: f64) -> DVec3 {
        let relative = problem.slip_velocity_of_constraint(&constraint.jacobian);
        let closing = relative.dot(constraint.jacobian.normal);
        let old_normal = constraint.impulse.dot(constraint.jacobian.normal);
        let new_normal =
            (old_normal + relaxation * (closing - self.bias_velocity) * self.normal_mass).max(0.0);
        if new_normal == 0.0 && old_normal == 0.0 {
            return DVec3::ZERO;
        }
        let old_friction = constraint.impulse - old_normal * constraint.jacobian.normal;
        let sliding = relative - closing * constraint.jacobian.normal;
        let limit = (self.friction * new_normal).min(self.shear_limit);
        let friction = (old_friction + relaxation * sliding * self.tangential_mass).clamp_length_max(limit);
        new_normal * constraint.jacobian.normal + friction
    }
}

/// Speed of the body for the bias velocity [m/s]. The overlap is measured in widths of the cell along the normal, the travel
/// within which it is removed in widths along the velocity.
fn bias_speed(problem: &ContactProblem, constraint: &Constraint) -> f64 {
    let velocity = problem.moving.twist(constraint.jacobian.body).linear;
    let grid = &problem.model.grid;
    let normal = grid.length_along(constraint.jacobian.normal);
    velocity.length() * (normal / grid.length_along(velocity.normalize_or_zero()))
}

/// One constraint (then both indices are the same), or two on opposite sides of the body's mid-plane. Two are
/// relaxed simultaneously, from the same velocities: a case and its mirror image then stay mirror images to
/// the bit, whatever the order of the constraints.
#[derive(Debug)]
struct Group {
    /// Indices of the constraints.
    first: usize,
    second: usize,
    /// Under-relaxation factor, so that two constraints on the same soil or body do not overshoot.
    relaxation: f64,
}

impl Group {
    fn relax(
        &self,
        problem: &mut ContactProblem,
        constraints: &mut [Constraint],
        masses: &[Option<EffectiveMass>],
    ) {
        let indices = [self.first, self.second];
        let new = indices.map(|n| {
            let old = constraints[n].impulse;
            masses[n].as_ref().map_or(old, |t| t.projected_impulse(problem, &constraints[n], self.relaxation))
        });
        let change = [new[0] - constraints[self.first].impulse, new[1] - constraints[self.second].impulse];
        self.apply(problem, constraints, change);
        for (n, impulse) in indices.into_iter().zip(new) {
            constraints[n].impulse = impulse;
        }
    }

    /// Applies impulses at the constraints.
    fn apply(&self, problem: &mut ContactProblem, constraints: &[Constraint], impulse: [DVec3; 2]) {
        let [first, second] = [self.first, self.second].map(|n| &constraints[n].jacobian);
        if impulse == [DVec3::ZERO; 2] {
            return;
        }
        if self.first == self.second {
            problem.exchange(first, impulse[0]);
        } else {
            problem.exchange_both((first, impulse[0]), (second, impulse[1]));
        }
    }
}

/// Groups the constraints. Mirror images are neighbours, as surface points are.
fn mirrored_groups(
    problem: &ContactProblem,
    constraints: &[Constraint],
    masses: &[Option<EffectiveMass>],
    groups: &mut Vec<Group>,
) {
    groups.clear();
    let mut first = 0;
    while first < constraints.len() {
        let next = first + 1;
        let is_pair =
            next < constraints.len() && are_mirrored(problem, &constraints[first], &constraints[next]);
        let second = if is_pair { next } else { first };
        let relaxation = match (&masses[first], &masses[second]) {
            (Some(a), Some(b)) if is_pair => {
                1.0 / (1.0 + coupling(problem, (&constraints[first], a), (&constraints[second], b)))
            }
            _ => 1.0,
        };
        groups.push(Group { first, second, relaxation });
        first = second + 1;
    }
}

/// Whether the first points of two constraints are each other's mirror image. In the mirror image of the case
/// their order is reversed, even when the grid cuts the two sides of the body differently.
fn are_mirrored(problem: &ContactProblem, a: &Constraint, b: &Constraint) -> bool {
    let (p, q) = (&problem.contacts[a.first], &problem.contacts[b.first]);
    b.first == a.first + 1 && p.body == q.body && p.is_paired && q.point == p.point + 1
}

/// Coupling of two constraints: velocity that an impulse at one causes at the other, over that at its own; 0
/// to 1.
fn coupling(
    problem: &ContactProblem,
    (a, mass_a): (&Constraint, &EffectiveMass),
    (b, mass_b): (&Constraint, &EffectiveMass),
) -> f64 {
    let shared = |n: usize| {
        let node = a.jacobian.nodes[n];
        let other = b.jacobian.nodes.iter().position(|m| *m == node);
        other.map_or(0.0, |m| {
            let both = a.jacobian.on_node(n, a.jacobian.normal) * b.jacobian.on_node(m, b.jacobian.normal);
            both.abs().dot(problem.nodes[node as usize].inverse_mass)
        })
    };
    let through_soil = over_corners(std::array::from_fn(shared));
    let through_body =
        0.5 * (delassus_of_body(problem, &a.jacobian) + delassus_of_body(problem, &b.jacobian));
    let size = through_soil + through_body.dot((a.jacobian.normal * b.jacobian.normal).abs());
    (size * mass_a.normal_mass.max(mass_b.normal_mass)).clamp(0.0, 1.0)
}

/// Diagonal of the Delassus operator: velocity per impulse along x, y, z, of soil and body together [1/kg].
fn delassus_diagonal(problem: &ContactProblem, jacobian: &ContactJacobian) -> DVec3 {
    let soil = |n: usize| {
        jacobian.weight[n] * jacobian.weight[n] * problem.nodes[jacobian.nodes[n] as usize].inverse_mass
    };
    over_corners(std::array::from_fn(soil)) + delassus_of_body(problem, jacobian)
}

/// Contribution of the body to the diagonal of the Delassus operator [1/kg].
fn delassus_of_body(problem: &ContactProblem, jacobian: &ContactJacobian) -> DVec3 {
    problem.moving.inverse_mass_diagonal(jacobian.body, jacobian.arm)
}
