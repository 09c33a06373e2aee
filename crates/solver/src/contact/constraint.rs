//! Contact constraints: one for each quarter of a cell that a body's face crosses, one for the whole cell at the face's edges.
//!
//! A constraint's contact points are the quadrature points of the face. The area-weighted mean of their shape functions gives
//! the mean soil velocity over its part of the face; an impulse on the constraint acts there like a uniform pressure.
//!
//! A single constraint for a cell does not see velocities that alternate from node to node along the face. The soil below
//! resists them, but little where it yields, and the less the flatter the cells are. At an edge quarters would hold nodes
//! beyond the face.

use super::cut_cell;
use super::problem::{ContactJacobian, ContactProblem, side};
use crate::model::Model;
use crate::state::{Contact, State};
use glam::DVec3;
use std::collections::HashMap;

/// An active constraint of one step.
#[derive(Clone, Debug, Default)]
pub(super) struct Constraint {
    /// Its first contact point.
    pub(super) first: usize,
    /// Mean Jacobian of its points.
    pub(super) jacobian: ContactJacobian,
    /// Area [m²].
    pub(super) area: f64,
    /// Mean overlap of body and soil, in cells.
    pub(super) overlap: f64,
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
    overlap: f64,
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
        self.overlap += c.area * c.penetration.max(0.0) / c.width;
        self.impulse += c.impulse;
    }

    fn plus(&self, other: &Self) -> Self {
        Self {
            area: self.area + other.area,
            weight: std::array::from_fn(|n| self.weight[n] + other.weight[n]),
            normal: self.normal + other.normal,
            arm: self.arm + other.arm,
            overlap: self.overlap + other.overlap,
            impulse: self.impulse + other.impulse,
        }
    }
}

/// Memory for each constraint [bytes].
pub(super) const PER_CONSTRAINT: usize =
    size_of::<Constraint>() + size_of::<[Sums; 3]>() + size_of::<Option<usize>>();

/// The active constraints of a step.
#[derive(Debug, Default)]
pub(super) struct Constraints {
    /// The constraints, in the order of their first points.
    pub(super) each: Vec<Constraint>,
    /// For each contact point the index of its constraint, if it is active.
    pub(super) of_contact: Vec<Option<usize>>,
    /// For the number of a constraint its index, if it is active.
    index: Vec<Option<usize>>,
    /// Points on the two sides of the body's mid-plane are summed separately, so that mirroring in y changes
    /// no bit.
    sums: Vec<[Sums; 3]>,
}

impl Constraints {
    /// Collects the active points into constraints.
    pub(super) fn find(&mut self, problem: &ContactProblem, is_active: impl Fn(usize) -> bool) {
        let Self { each: constraints, of_contact, index, sums } = self;
        constraints.clear();
        sums.clear();
        for (list, length) in
            [(&mut *index, problem.hourglass_correction.len()), (&mut *of_contact, problem.contacts.len())]
        {
            list.clear();
            list.resize(length, None);
        }
        for (n, c) in problem.contacts.iter().enumerate().filter(|(n, _)| is_active(*n)) {
            let at = *index[problem.constraint[n]].get_or_insert(constraints.len());
            if at == constraints.len() {
                let (nodes, hourglass_correction) =
                    (problem.corner_nodes[n], problem.hourglass_correction[problem.constraint[n]]);
                let jacobian = ContactJacobian {
                    body: c.body as usize,
                    nodes,
                    hourglass_correction,
                    ..ContactJacobian::default()
                };
                constraints.push(Constraint { first: n, jacobian, ..Constraint::default() });
                sums.push(Default::default());
            }
            of_contact[n] = Some(at);
            sums[at][side(c)].add(c);
        }
        for (constraint, [left, right, middle]) in constraints.iter_mut().zip(sums) {
            let all = left.plus(right).plus(middle);
            constraint.area = all.area;
            constraint.jacobian.weight = all.weight.map(|w| w / all.area);
            constraint.jacobian.arm = all.arm / all.area;
            constraint.jacobian.normal = all.normal.normalize_or_zero();
            constraint.overlap = all.overlap / all.area;
            constraint.impulse = all.impulse;
        }
    }
}

/// For each contact point the number of its constraint (by body, face and quarter of a cell), and for each constraint its
/// cut-cell hourglass correction; `fraction` is the volume fraction in the cell of each contact point.
pub(crate) fn number<R>(
    model: &Model,
    State { bodies, grid_position, contacts, .. }: &State<R>,
    fraction: &[f64],
) -> (Vec<usize>, Vec<[DVec3; 8]>) {
    let surfaces = cut_cell::surfaces(model, bodies, *grid_position, contacts);
    let mut numbers = HashMap::new();
    let each = contacts.iter().map(|c| {
        let axis = model.grid.main_axis(c.normal);
        let is_whole = surfaces[&(c.body, c.cell)].is_whole();
        let quarter = if is_whole { c.octant & !(1 << axis) } else { 0 };
        let next = numbers.len();
        *numbers.entry((c.body, c.cell, axis, c.normal[axis] > 0.0, quarter)).or_insert(next)
    });
    let each: Vec<usize> = each.collect();
    let sampled = (contacts.as_slice(), fraction, &surfaces);
    let hourglass_correction =
        cut_cell::corrections(model, bodies, *grid_position, sampled, (&each, numbers.len()));
    (each, hourglass_correction)
}
