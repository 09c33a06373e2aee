//! Symmetric projected Gauss–Seidel sweeps over the constraints of an island.
//!
//! The order of the constraints is part of the result: each meets the velocities that the ones before have
//! left. An island's nodes, bodies and constraints are therefore copied into little memory before the sweeps,
//! and back afterwards.

use super::constraint::Constraint;
use super::effective_mass::{EffectiveMass, coupling};
use super::problem::{ContactProblem, over_corners};
use glam::DVec3;
use mechanics::{StruckBody, Wrench};
use multiversion::multiversion;

/// A vector as the first three of four lanes.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(32))]
struct Lanes([f64; 4]);

impl Lanes {
    #[inline(always)]
    fn of(v: DVec3) -> Self {
        Self([v.x, v.y, v.z, 0.0])
    }

    #[inline(always)]
    fn vector(self) -> DVec3 {
        DVec3::new(self.0[0], self.0[1], self.0[2])
    }

    #[inline(always)]
    fn dot(self, other: Self) -> f64 {
        let Self([x, y, z, _]) = self * other;
        x + y + z
    }
}

impl std::ops::Add for Lanes {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let ([a, b, c, d], [p, q, r, s]) = (self.0, other.0);
        Self([a + p, b + q, c + r, d + s])
    }
}

impl std::ops::Mul for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let ([a, b, c, d], [p, q, r, s]) = (self.0, other.0);
        Self([a * p, b * q, c * r, d * s])
    }
}

impl std::ops::Mul<Lanes> for f64 {
    type Output = Lanes;
    #[inline(always)]
    fn mul(self, v: Lanes) -> Lanes {
        let [a, b, c, d] = v.0;
        Lanes([self * a, self * b, self * c, self * d])
    }
}

/// A contact node during the sweeps.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
struct SweptNode {
    /// Velocity [m/s].
    velocity: Lanes,
    /// Inverse mass [1/kg].
    inverse_mass: Lanes,
}

/// A constraint during the sweeps.
#[derive(Clone, Debug)]
struct SweptConstraint {
    /// Number of the constraint.
    number: usize,
    /// Place of the body in the island.
    body: usize,
    /// Places of the nodes in the island, and their weights.
    nodes: [u32; 8],
    weight: [f64; 8],
    /// Cut-cell hourglass correction at the nodes per unit normal force.
    hourglass_correction: [Lanes; 8],
    normal: DVec3,
    /// Lever arm from the body's reference point [m].
    arm: DVec3,
    /// Impulse on the soil in this step [N s].
    impulse: DVec3,
    /// `None` where nothing can move along the normal.
    mass: Option<EffectiveMass>,
}

impl SweptConstraint {
    /// Relative velocity [m/s], including the cut-cell correction, so that it is work-conjugate to the
    /// impulse.
    #[inline(always)]
    fn slip_velocity(&self, nodes: &[SweptNode], body: &StruckBody) -> DVec3 {
        let (mut soil, mut corrected) = ([Lanes::default(); 8], [0.0; 8]);
        for n in 0..8 {
            let velocity = nodes[self.nodes[n] as usize].velocity;
            soil[n] = self.weight[n] * velocity;
            corrected[n] = self.hourglass_correction[n].dot(velocity);
        }
        body.twist.at(self.arm) - over_corners(soil).vector() - over_corners(corrected) * self.normal
    }

    /// The impulse after one relaxation.
    #[inline(always)]
    fn relaxed(&self, nodes: &[SweptNode], bodies: &[StruckBody], relaxation: f64) -> DVec3 {
        let Some(mass) = &self.mass else { return self.impulse };
        let relative = self.slip_velocity(nodes, &bodies[self.body]);
        mass.projected_impulse(relative, (self.normal, self.impulse), relaxation)
    }

    /// Changes of the nodes' velocities by an impulse on the soil [m/s].
    #[inline(always)]
    fn gains(&self, nodes: &[SweptNode], impulse: DVec3) -> [Lanes; 8] {
        let (along, impulse) = (impulse.dot(self.normal), Lanes::of(impulse));
        let mut gains = [Lanes::default(); 8];
        for n in 0..8 {
            let on_node = self.weight[n] * impulse + along * self.hourglass_correction[n];
            gains[n] = nodes[self.nodes[n] as usize].inverse_mass * on_node;
        }
        gains
    }
}

/// One constraint (then both indices are the same), or two on opposite sides of the body's mid-plane. Two are
/// relaxed simultaneously, from the same velocities: a case and its mirror image then stay mirror images to
/// the bit, whatever the order of the constraints.
#[derive(Clone, Copy, Debug)]
struct Group {
    /// Indices of the constraints.
    first: usize,
    second: usize,
    /// Under-relaxation factor, so that two constraints on the same soil or body do not overshoot.
    relaxation: f64,
}

/// Memory for each constraint [bytes].
pub(super) const PER_CONSTRAINT: usize = size_of::<SweptConstraint>() + size_of::<Group>();

/// An island during the sweeps.
#[derive(Debug, Default)]
pub(super) struct SweptIsland {
    nodes: Vec<SweptNode>,
    /// The bodies, with their numbers.
    bodies: Vec<StruckBody>,
    numbers: Vec<usize>,
    constraints: Vec<SweptConstraint>,
    groups: Vec<Group>,
}

/// Constraints with their effective masses, by number.
pub(super) type Prepared = (Constraint, Option<EffectiveMass>);

impl SweptIsland {
    /// Copies an island: the constraints of this order that lie in it. Their impulses of the last step are
    /// applied.
    pub(super) fn begin(
        &mut self,
        problem: &ContactProblem,
        island: usize,
        prepared: &[Prepared],
        order: &[usize],
    ) {
        let own = problem.islands.nodes[island].iter().map(|node| *node as usize);
        self.nodes.clear();
        self.nodes.extend(own.map(|node| SweptNode {
            velocity: Lanes::of(problem.velocity[node]),
            inverse_mass: Lanes::of(problem.inverse_mass[node]),
        }));
        self.numbers.clear();
        self.constraints.clear();
        for number in order {
            let (constraint, mass) = &prepared[*number];
            let jacobian = &constraint.jacobian;
            if problem.islands.of(jacobian.body) != island {
                continue;
            }
            if self.numbers.last() != Some(&jacobian.body) {
                self.numbers.push(jacobian.body);
            }
            self.constraints.push(SweptConstraint {
                number: *number,
                body: self.numbers.len() - 1,
                nodes: jacobian.nodes.map(|node| problem.islands.place[node as usize]),
                weight: jacobian.weight,
                hourglass_correction: jacobian.hourglass_correction.map(Lanes::of),
                normal: jacobian.normal,
                arm: jacobian.arm,
                impulse: constraint.impulse,
                mass: *mass,
            });
        }
        self.strike(problem);
        self.group(problem, prepared);
        for group in &self.groups {
            let both = [group.first, group.second].map(|n| self.constraints[n].impulse);
            group.apply(both, &self.constraints, (&mut self.nodes, &mut self.bodies));
        }
    }

    /// Copies the bodies as they now are.
    pub(super) fn strike(&mut self, problem: &ContactProblem) {
        self.bodies.clear();
        self.bodies.extend(self.numbers.iter().map(|body| problem.moving.struck(*body)));
    }

    /// Takes over the bodies into the problem.
    pub(super) fn put_bodies_back(&self, problem: &mut ContactProblem) {
        for (number, body) in self.numbers.iter().zip(&self.bodies) {
            problem.moving.put_back(*number, body);
        }
    }

    /// Takes over velocities and impulses.
    pub(super) fn put_back(&self, problem: &mut ContactProblem, island: usize, prepared: &mut [Prepared]) {
        self.put_bodies_back(problem);
        for (node, own) in problem.islands.nodes[island].iter().zip(&self.nodes) {
            problem.velocity[*node as usize] = own.velocity.vector();
        }
        for constraint in &self.constraints {
            prepared[constraint.number].0.impulse = constraint.impulse;
        }
    }

    /// Groups the constraints. Mirror images are neighbours, as surface points are.
    fn group(&mut self, problem: &ContactProblem, prepared: &[Prepared]) {
        let of = |n: usize| self.constraints.get(n).map(|constraint| &prepared[constraint.number]);
        self.groups.clear();
        let mut first = 0;
        while let Some((own, mass)) = of(first) {
            let next = of(first + 1).filter(|(other, _)| are_mirrored(problem, own, other));
            let relaxation = match (mass, next) {
                (Some(a), Some((other, Some(b)))) => 1.0 / (1.0 + coupling(problem, own, a, other, b)),
                _ => 1.0,
            };
            let second = first + usize::from(next.is_some());
            self.groups.push(Group { first, second, relaxation });
            first = second + 1;
        }
    }

    /// Sweeps through the constraints and back, so many times.
    pub(super) fn sweep(&mut self, times: usize) {
        sweep(times, &self.groups, &mut self.constraints, (&mut self.nodes, &mut self.bodies));
    }
}

/// Whether the first points of two constraints are each other's mirror image. In the mirror image of the case
/// their order is reversed, even when the grid cuts the two sides of the body differently.
fn are_mirrored(problem: &ContactProblem, a: &Constraint, b: &Constraint) -> bool {
    let (Some(first), Some(second)) = (a.first, b.first) else { return false };
    let (p, q) = (&problem.contacts[first], &problem.contacts[second]);
    second == first + 1 && p.body == q.body && p.is_paired && q.point == p.point + 1
}

/// What the sweeps change, but for the impulses.
type Velocities<'a> = (&'a mut [SweptNode], &'a mut [StruckBody]);

#[multiversion(targets("x86_64+avx2+fma"))]
fn sweep(times: usize, groups: &[Group], constraints: &mut [SweptConstraint], (nodes, bodies): Velocities) {
    for _ in 0..times {
        for group in groups.iter().chain(groups.iter().rev()) {
            group.relax(constraints, (nodes, bodies));
        }
    }
}

impl Group {
    #[inline(always)]
    fn relax(&self, constraints: &mut [SweptConstraint], (nodes, bodies): Velocities) {
        let first = constraints[self.first].relaxed(nodes, bodies, self.relaxation);
        let is_single = self.first == self.second;
        let second =
            if is_single { first } else { constraints[self.second].relaxed(nodes, bodies, self.relaxation) };
        let new = [first, second];
        let change = [new[0] - constraints[self.first].impulse, new[1] - constraints[self.second].impulse];
        self.apply(change, constraints, (nodes, bodies));
        constraints[self.first].impulse = new[0];
        constraints[self.second].impulse = new[1];
    }

    /// Applies impulses at the constraints to soil and bodies; swapping two constraints changes no bit.
    #[inline(always)]
    fn apply(&self, impulse: [DVec3; 2], constraints: &[SweptConstraint], (nodes, bodies): Velocities) {
        if impulse == [DVec3::ZERO; 2] {
            return;
        }
        let first = &constraints[self.first];
        let body = &mut bodies[first.body];
        let gains = first.gains(nodes, impulse[0]);
        if self.first == self.second {
            for (node, gain) in first.nodes.iter().zip(gains) {
                let velocity = &mut nodes[*node as usize].velocity;
                *velocity = *velocity + gain;
            }
            body.apply(&Wrench::at(first.arm, -impulse[0]));
            return;
        }
        let second = &constraints[self.second];
        let others = second.gains(nodes, impulse[1]);
        for (node, own) in first.nodes.iter().zip(gains) {
            let shared = second.nodes.iter().position(|other| other == node);
            let velocity = &mut nodes[*node as usize].velocity;
            // Not a closure: the wide version of the sweeps would leave it to the narrow one.
            let both = match shared {
                Some(m) => own + others[m],
                None => own,
            };
            *velocity = *velocity + both;
        }
        for (node, own) in second.nodes.iter().zip(others).filter(|(node, _)| !first.nodes.contains(node)) {
            let velocity = &mut nodes[*node as usize].velocity;
            *velocity = *velocity + own;
        }
        body.apply(&(Wrench::at(first.arm, -impulse[0]) + Wrench::at(second.arm, -impulse[1])));
    }
}
