//! The contact nodes of all blocks: every block must know their masses and velocities.

use super::problem::ContactNode;
use crate::halo::Halo;
use crate::scalar::Scalar;
use crate::state::Nodes;
use glam::DVec3;

/// Which block owns which of the contact nodes.
#[derive(Debug, Default)]
pub(crate) struct Owners {
    /// Indices of the nodes, those of the first block first.
    nodes: Vec<u32>,
    /// Numbers that each block sends of its nodes.
    counts: Vec<usize>,
}

/// Numbers sent of a node: its mass, and its velocity without contact and before the step.
const PER_NODE: usize = 7;

impl Owners {
    /// The owners of contact nodes; not needed where there is only one block.
    pub(super) fn of(nodes: &[ContactNode], halo: &Halo) -> Self {
        if halo.is_alone() {
            return Self::default();
        }
        let own = nodes.iter().enumerate().filter(|(_, node)| node.is_owned).map(|(n, _)| n as f64);
        let all = halo.gather_each(own.collect());
        let counts = all.iter().map(|own| PER_NODE * own.len()).collect();
        Self { nodes: all.iter().flatten().map(|n| *n as u32).collect(), counts }
    }

    /// Memory in use [bytes].
    pub(super) fn memory(&self) -> usize {
        size_of_val(self.nodes.as_slice()) + size_of_val(self.counts.as_slice())
    }
}

/// Nodes of the grid, and their velocities before the step [m/s].
type OfGrid<'a, R> = (&'a Nodes<R>, &'a [Vec<R>; 3]);

/// Mass, velocity without contact and velocity before the step of a node of this block.
fn of_node<R: Scalar>((nodes, before): OfGrid<R>, n: usize) -> (f64, DVec3, DVec3) {
    let at = |v: &[Vec<R>; 3]| DVec3::from_array(v.each_ref().map(|component| component[n].to_f64()));
    (nodes.mass[n].to_f64(), at(&nodes.velocity), at(before))
}

impl Owners {
    /// Begins to send the other blocks what they need to know of this one's contact nodes.
    pub(super) fn begin<R: Scalar>(&self, nodes: &[ContactNode], grid: OfGrid<R>, halo: &Halo) {
        if self.nodes.is_empty() {
            return;
        }
        let owned = nodes.iter().filter(|node| node.is_owned).filter_map(|node| node.node);
        let values = owned.flat_map(|n| {
            let (mass, velocity, before) = of_node(grid, n);
            let (now, before) = (velocity.to_array(), before.to_array());
            [mass, now[0], now[1], now[2], before[0], before[1], before[2]]
        });
        halo.begin_gather(values.collect(), &self.counts);
    }

    /// Takes masses and velocities of the contact nodes from the grid, and from the blocks that own them.
    pub(super) fn end<R: Scalar>(&self, nodes: &mut [ContactNode], grid: OfGrid<R>, halo: &Halo) {
        if self.nodes.is_empty() {
            for node in nodes {
                let own = node.node.map(|n| of_node(grid, n));
                (node.mass, node.velocity_free, node.velocity_before) = own.unwrap_or_default();
            }
            return;
        }
        let values = halo.end_gather();
        for (n, values) in self.nodes.iter().zip(values.chunks_exact(PER_NODE)) {
            let node = &mut nodes[*n as usize];
            node.mass = values[0];
            node.velocity_free = DVec3::from_slice(&values[1..4]);
            node.velocity_before = DVec3::from_slice(&values[4..7]);
        }
    }
}
