//! Patches: the parts of a body's faces that lie in one cell and touch the soil.
//!
//! The soil's velocity is one trilinear field in a cell, so the flow through a face there is one condition, and the surface
//! points of the face in the cell are its quadrature. Their weights, each by its area, make the mean velocity of the soil
//! over the patch; an impulse on the patch acts like a uniform pressure on it.

use super::cut_cell;
use super::scene::{Grip, Scene, largest_axis, side};
use crate::model::Model;
use crate::state::{Body, Contact};
use glam::DVec3;
use std::collections::HashMap;

/// A patch that touches, during one step.
#[derive(Clone, Debug, Default)]
pub(super) struct Patch {
    /// The contact that it began with.
    pub(super) first: usize,
    /// Where it acts: the mean over its points.
    pub(super) grip: Grip,
    /// Area [m²].
    pub(super) area: f64,
    /// Mean overlap of body and soil, in cells.
    pub(super) overlap: f64,
    /// Impulse on the soil in this step [N s].
    pub(super) impulse: DVec3,
}

/// Sums over the points of a patch.
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

/// What is kept for each patch [bytes].
pub(super) const PER_PATCH: usize = size_of::<Patch>() + size_of::<[Sums; 3]>() + size_of::<Option<usize>>();

/// The patches made of the points that touch in a step.
#[derive(Debug, Default)]
pub(super) struct Patches {
    /// In the order of their first points.
    pub(super) each: Vec<Patch>,
    /// For each contact the place of its patch among them, if it touches.
    pub(super) of_contact: Vec<Option<usize>>,
    /// For the number of a patch its place among them.
    place: Vec<Option<usize>>,
    /// Points on the two sides of the body's middle are added up apart: a mirror in y then changes no bit of the sum.
    sums: Vec<[Sums; 3]>,
}

impl Patches {
    /// Finds them.
    pub(super) fn find(&mut self, scene: &Scene, touches: impl Fn(usize) -> bool) {
        let Self { each: patches, of_contact, place, sums } = self;
        patches.clear();
        sums.clear();
        for (list, length) in [(&mut *place, scene.missing.len()), (&mut *of_contact, scene.contacts.len())] {
            list.clear();
            list.resize(length, None);
        }
        for (n, c) in scene.contacts.iter().enumerate().filter(|(n, _)| touches(*n)) {
            let at = *place[scene.patch[n]].get_or_insert(patches.len());
            if at == patches.len() {
                let (nodes, missing) = (scene.corner_nodes[n], scene.missing[scene.patch[n]]);
                let grip = Grip { body: c.body, nodes, missing, ..Grip::default() };
                patches.push(Patch { first: n, grip, ..Patch::default() });
                sums.push(Default::default());
            }
            of_contact[n] = Some(at);
            sums[at][side(c)].add(c);
        }
        for (patch, [left, right, middle]) in patches.iter_mut().zip(sums) {
            let all = left.plus(right).plus(middle);
            patch.area = all.area;
            patch.grip.weight = all.weight.map(|w| w / all.area);
            patch.grip.arm = all.arm / all.area;
            patch.grip.normal = all.normal.normalize_or_zero();
            patch.overlap = all.overlap / all.area;
            patch.impulse = all.impulse;
        }
    }
}

/// For each contact the number of its patch (that of its body, face and cell), and for each patch the forces that are missing
/// at its nodes, over the force on it; `fraction` is the volume fraction in the cell of each contact.
pub(crate) fn number(
    model: &Model,
    bodies: &[Body],
    contacts: &[Contact],
    fraction: &[f64],
) -> (Vec<usize>, Vec<[DVec3; 8]>) {
    let mut numbers = HashMap::new();
    let each = contacts.iter().map(|c| {
        let axis = largest_axis(c.normal);
        let next = numbers.len();
        *numbers.entry((c.body, c.cell, axis, c.normal[axis] > 0.0)).or_insert(next)
    });
    let each: Vec<usize> = each.collect();
    let missing = cut_cell::corrections(model, bodies, (contacts, fraction), (&each, numbers.len()));
    (each, missing)
}
