//! Contact constraints: one for each body face in each cell; in flat cells one for each half of the cell along its long sides.
//!
//! The soil's velocity is a single trilinear field within a cell, so non-penetration of a face there is a
//! single condition; the face's contact points in the cell are its quadrature points. The area-weighted mean
//! of their shape functions gives the mean soil velocity over the face; an impulse on the constraint acts
//! like a uniform pressure on the face.
//!
//! A mean over the cell does not see velocities that alternate from node to node along the face. In cubes the soil below
//! resists them; in a flat cell it resists the less the flatter the cell is, so that such a cell is halved.

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

/// Aspect from which on a cell is halved along an axis (chosen: halves of longer cells are then about as long as cubes).
const WIDE: f64 = 1.5;

/// For each contact point the number of its constraint (by body, face and part of a cell), and for each constraint its cut-cell
/// hourglass correction; `fraction` is the volume fraction in the cell of each contact point.
pub(crate) fn number<R>(
    model: &Model,
    State { bodies, grid_position, contacts, .. }: &State<R>,
    fraction: &[f64],
) -> (Vec<usize>, Vec<[DVec3; 8]>) {
    let mut numbers = HashMap::new();
    let aspect = model.grid.aspect();
    let halved: u8 = (0..3).map(|axis| u8::from(aspect[axis] >= WIDE) << axis).sum();
    let each = contacts.iter().map(|c| {
        let axis = model.grid.main_axis(c.normal);
        let part = c.octant & halved & !(1 << axis);
        let next = numbers.len();
        *numbers.entry((c.body, c.cell, axis, c.normal[axis] > 0.0, part)).or_insert(next)
    });
    let each: Vec<usize> = each.collect();
    let hourglass_correction =
        cut_cell::corrections(model, bodies, *grid_position, (contacts, fraction), (&each, numbers.len()));
    (each, hourglass_correction)
}
