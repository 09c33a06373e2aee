//! Stress and slip along the rims, by way of the nodes.
//!
//! Contact points outnumber the nodes behind a face, and share its load as they like: in the middle of a
//! footing that bears 5.1 kPa neighbouring ones bore 2 and 8 kPa. What the nodes bear is determined. So what
//! acts at the points goes to the nodes with their weights, is divided by the area of the surface that each
//! node stands for, and comes back to the surface by interpolation: to samples of all of it, up to its edges.
//! Sums over a face stay the same. Which part of a node's sums falls to which bin of a rim stays the same
//! until the next contact search.

use super::nodes::corners_in_whole;
use super::place::{place, trilinear};
use super::problem::of_body;
use super::slip_terms::SlipTerms;
use super::surface::Surface;
use crate::halo::{self, Halo};
use crate::model::Model;
use crate::state::{Body, Contact, RimSums, State};
use rustc_hash::FxHashMap;

/// A node behind one face of a body: the body, the face's main axis and side, and the node's number in the
/// whole grid.
type Key = (u32, usize, bool, usize);

/// Places of a cell's nodes among those behind the rims; `NONE` for a node that no contact point acts on.
type Places = [u32; 8];

const NONE: u32 = u32::MAX;

/// Area of the surface in a bin of a body's rim that a node stands for.
#[derive(Clone, Copy, Debug)]
struct Share {
    body: u16,
    bin: u16,
    node: u32,
    /// [m²]
    area: f64,
}

/// The nodes behind the rims of all bodies, until the next contact search.
#[derive(Debug, Default)]
pub(crate) struct RimStress {
    /// For each contact point the places of its nodes; `None` on a flank.
    of_contacts: Vec<Option<Places>>,
    shares: Vec<Share>,
    /// Area of the surface that each node stands for [m²], and the same of what the contact points represent.
    area: Vec<f64>,
    held: Vec<f64>,
    /// Sums over the contact points of a step at each node.
    sums: Vec<RimSums>,
}

impl RimStress {
    /// The nodes behind the rims of all bodies after a contact search.
    pub(super) fn new<R>(model: &Model, state: &State<R>, surfaces: &[Surface], halo: &Halo) -> Self {
        let mut places = FxHashMap::default();
        let mut place_of = |c: &Contact| {
            let axis = model.grid.main_axis(c.normal);
            corners_in_whole(&model.grid, c.cell.map(|layer| layer as usize)).map(|node| {
                let next = places.len() as u32;
                *places.entry((c.body, axis, c.normal[axis] > 0.0, node)).or_insert(next)
            })
        };
        let is_on_rim = |c: &Contact| {
            let surface = &surfaces[c.body as usize];
            surface.bin_of(c.point) < surface.rim().len()
        };
        let of_contacts: Vec<_> = state.contacts.iter().map(|c| is_on_rim(c).then(|| place_of(c))).collect();
        let shares = shares(model, state, surfaces, &places, halo);
        let [mut area, mut held] = [0, 1].map(|_| vec![0.0; places.len()]);
        shares.iter().for_each(|share| area[share.node as usize] += share.area);
        for (c, nodes) in state.contacts.iter().zip(&of_contacts) {
            let represented = surfaces[c.body as usize].represented(c);
            let each = nodes.iter().flat_map(|nodes| nodes.iter().zip(c.weight));
            each.for_each(|(node, weight)| held[*node as usize] += weight * represented);
        }
        let sums = vec![RimSums::default(); places.len()];
        Self { of_contacts, shares, area, held, sums }
    }

    /// Adds what acts at the contact points in a step to the sums over the rims: on the rims by way of the
    /// nodes, on the flanks as it is.
    pub(super) fn add(&mut self, contacts: &[Contact], bodies: &mut [Body], terms: &[SlipTerms]) {
        let Self { of_contacts, shares, area, held, sums } = self;
        sums.fill(RimSums::default());
        for ((c, nodes), terms) in contacts.iter().zip(&*of_contacts).zip(terms) {
            let Some(nodes) = nodes.filter(|_| terms.sums != RimSums::default()) else { continue };
            for (node, weight) in nodes.iter().zip(c.weight).filter(|(_, weight)| *weight > 0.0) {
                sums[*node as usize].add(&terms.sums.times([weight; 2]));
            }
        }
        for ((sums, area), held) in sums.iter_mut().zip(area).zip(held) {
            let is_behind = *area > 0.0 && *held > 0.0;
            *sums = if is_behind { sums.times([1.0 / *area, 1.0 / *held]) } else { RimSums::default() };
        }
        for (n, body) in bodies.iter_mut().enumerate() {
            let own = of_body(contacts, n);
            let flank = body.rim.len() - 1;
            let each = of_contacts[own.clone()].iter().zip(&terms[own]);
            each.filter(|(nodes, _)| nodes.is_none()).for_each(|(_, terms)| body.rim[flank].add(&terms.sums));
        }
        for share in &*shares {
            let rim = &mut bodies[usize::from(share.body)].rim[usize::from(share.bin)];
            rim.add(&sums[share.node as usize].times([share.area; 2]));
        }
    }

    /// Memory in use [bytes].
    pub(super) fn memory(&self) -> usize {
        size_of_val(self.of_contacts.as_slice())
            + size_of_val(self.shares.as_slice())
            + size_of_val(self.area.as_slice())
            + size_of_val(self.held.as_slice())
            + size_of_val(self.sums.as_slice())
    }
}

/// The parts of all rims that fall to the nodes that contact points act on, from samples of their surfaces in
/// all blocks; each pair of a bin and a node once.
fn shares<R>(
    model: &Model,
    state: &State<R>,
    surfaces: &[Surface],
    places: &FxHashMap<Key, u32>,
    halo: &Halo,
) -> Vec<Share> {
    let nodes_of = |body: usize, axis: usize, is_high: bool, cell: [usize; 3]| {
        corners_in_whole(&model.grid, cell)
            .map(|node| places.get(&(body as u32, axis, is_high, node)).copied().unwrap_or(NONE))
    };
    let mut own = Vec::new();
    let mut first = 0;
    for (n, surface) in surfaces.iter().enumerate() {
        let (body, pose) = (&model.bodies[n], &state.bodies[n].searched_at);
        for (m, (position, normal, area, bin)) in surface.samples().enumerate() {
            let [arm, normal] = [position, normal].map(|v| body.rotated(pose, v));
            let at = pose.position - state.grid_position + arm;
            let Some(found) = place(&model.grid, at, (arm, normal)) else { continue };
            let axis = model.grid.main_axis(normal);
            let face = f64::from(2 * axis as u8 + u8::from(normal[axis] > 0.0));
            let ([i, j, k], [x, y, z]) = (found.whole.map(|n| n as f64), found.along.map(|[_, high]| high));
            own.push((first + m, [n as f64, bin as f64, area, face, i, j, k, x, y, z]));
        }
        first += surface.samples().len();
    }
    let all = if halo.is_alone() { own } else { halo::in_order(halo, own.into_iter()) };
    let each = all.into_iter().flat_map(|(_, [body, bin, area, face, i, j, k, x, y, z])| {
        let (face, cell) = (face as usize, [i, j, k].map(|layer| layer as usize));
        let weight = trilinear(&[x, y, z].map(|high| [1.0 - high, high]));
        let nodes = nodes_of(body as usize, face / 2, face % 2 == 1, cell).into_iter().zip(weight);
        let held = nodes.filter(|(node, weight)| *node != NONE && *weight > 0.0);
        held.map(move |(node, weight)| Share {
            body: body as u16,
            bin: bin as u16,
            node,
            area: weight * area,
        })
    });
    let mut shares: Vec<_> = each.collect();
    let key = |share: &Share| (share.body, share.bin, share.node);
    shares.sort_by_key(key);
    shares.dedup_by(|next, kept| {
        let is_same = key(next) == key(kept);
        if is_same {
            kept.area += next.area;
        }
        is_same
    });
    shares
}
