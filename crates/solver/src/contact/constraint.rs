//! Contact constraints: one for each quarter of a cell that a body's face crosses, one for the whole cell at
//! the face's edges.
//!
//! A constraint's contact points are the quadrature points of the face. The area-weighted mean of their shape
//! functions gives the mean soil velocity over its part of the face; an impulse on the constraint acts there
//! like a uniform pressure.
//!
//! A single constraint for a cell does not see velocities that alternate from node to node along the face.
//! The soil below resists them, but little where it yields, and the less the flatter the cells are. At an
//! edge quarters would hold nodes beyond the face.

use super::constraint_points::ConstraintPoints;
use super::cut_cell::{self, Sampled};
use super::problem::{ContactJacobian, ContactProblem, side};
use crate::cpu::threads::Crew;
use crate::model::Model;
use crate::state::{Contact, State};
use glam::DVec3;
use rustc_hash::FxHashMap;

/// A constraint in one step.
#[derive(Clone, Debug, Default)]
pub(super) struct Constraint {
    /// The constraint's first contact point that is active, if there is one.
    pub(super) first: Option<usize>,
    /// Mean Jacobian of the active points of the constraint.
    pub(super) jacobian: ContactJacobian,
    /// Area of the constraint's contact points [m²].
    pub(super) area: f64,
    /// Impulse on the soil in this step [N s].
    pub(super) impulse: DVec3,
}

/// Sums over the points of a constraint.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    area: f64,
    weight: [f64; 8],
    normal: DVec3,
    arm: DVec3,
    impulse: DVec3,
}

impl Sums {
    fn add(&mut self, c: &Contact) {
        self.area += c.area;
        for (sum, w) in self.weight.iter_mut().zip(c.weight) {
            *sum += c.area * w;
        }
        self.normal += c.area * c.normal;
        self.arm += c.area * c.arm;
        self.impulse += c.impulse;
    }

    fn plus(&self, other: &Self) -> Self {
        Self {
            area: self.area + other.area,
            weight: std::array::from_fn(|n| self.weight[n] + other.weight[n]),
            normal: self.normal + other.normal,
            arm: self.arm + other.arm,
            impulse: self.impulse + other.impulse,
        }
    }
}

impl Constraint {
    /// The constraint with this number, of those of its points that are active.
    pub(super) fn of(problem: &ContactProblem, number: usize, is_active: impl Fn(usize) -> bool) -> Self {
        // Points on the two sides of the body's mid-plane are summed separately, so that mirroring in y
        // changes no bit.
        let (mut first, mut sums) = (None, [Sums::default(); 3]);
        for n in problem.constraint_points.of(number).filter(|n| is_active(*n)) {
            first.get_or_insert(n);
            let c = &problem.contacts[n];
            sums[side(c)].add(c);
        }
        let Some(n) = first else { return Self::default() };
        let [left, right, middle] = sums;
        let all = left.plus(&right).plus(&middle);
        let jacobian = ContactJacobian {
            body: problem.contacts[n].body as usize,
            arm: all.arm / all.area,
            nodes: problem.corner_nodes[n],
            weight: all.weight.map(|w| w / all.area),
            normal: all.normal.normalize_or_zero(),
            hourglass_correction: problem.hourglass_correction[number],
        };
        Self { first, jacobian, area: all.area, impulse: all.impulse }
    }
}

/// Numbers the constraints (by body, face and quarter of a cell), in the order of their first contact points,
/// and finds for each its cut-cell hourglass correction; `fraction` is the volume fraction in the cell of
/// each contact point.
pub(crate) fn number<R>(
    model: &Model,
    State { bodies, grid_position, contacts, .. }: &State<R>,
    fraction: &[f64],
    crew: Crew,
) -> (ConstraintPoints, Vec<[DVec3; 8]>) {
    let surfaces = cut_cell::surfaces(model, bodies, *grid_position, contacts, crew);
    let mut numbers = FxHashMap::default();
    let each = contacts.iter().map(|c| {
        let axis = model.grid.main_axis(c.normal);
        let is_whole = surfaces[&(c.body, c.cell)].is_whole();
        let quarter = if is_whole { c.octant & !(1 << axis) } else { 0 };
        let next = numbers.len();
        *numbers.entry((c.body, c.cell, axis, c.normal[axis] > 0.0, quarter)).or_insert(next)
    });
    let each: Vec<usize> = each.collect();
    let mut first = vec![0; numbers.len()];
    each.iter().enumerate().rev().for_each(|(n, number)| first[*number] = n);
    let sampled = Sampled { contacts, fraction, surfaces: &surfaces };
    let hourglass_correction = cut_cell::corrections(model, bodies, *grid_position, &sampled, &first, crew);
    (ConstraintPoints::new(each), hourglass_correction)
}
