//! What holds the faces of the box: walls, and planes of symmetry.

use crate::eulerian::{Eulerian, near};
use crate::notes::Notes;
use deck::block::{Row, Wrong};
use deck::model::Id;
use std::collections::{HashMap, HashSet};

/// Nodes of faces that are held, by axis and side of the face and the axis along which they are held.
pub(super) struct HeldNodes<'a> {
    mesh: &'a Eulerian,
    found: HashMap<(usize, usize, usize), HashSet<Id>>,
    blocks: Vec<usize>,
}

/// For each axis of the deck, side and axis of motion, whether the face is held.
pub(super) type Held = [[[bool; 3]; 2]; 3];

impl<'a> HeldNodes<'a> {
    /// None yet.
    pub(super) fn new(mesh: &'a Eulerian) -> Self {
        Self { mesh, found: HashMap::new(), blocks: Vec::new() }
    }

    /// Whether a node is one of the mesh.
    pub(super) fn has(&self, id: Id) -> bool {
        self.mesh.nodes.contains(&id)
    }

    /// Takes a row that holds nodes of the mesh along an axis.
    pub(super) fn hold(
        &mut self,
        notes: &Notes,
        block: usize,
        row: &Row,
        ids: &[Id],
        axis: usize,
    ) -> Result<(), Wrong> {
        for id in ids {
            let Some(at) = place(notes, self.mesh, *id) else { continue };
            let mut is_inside = true;
            for normal in 0..3 {
                for (side, plane) in [0, self.mesh.faces[normal].len() - 1].into_iter().enumerate() {
                    if at[normal] == plane {
                        is_inside = false;
                        self.found.entry((normal, side, axis)).or_default().insert(*id);
                    }
                }
            }
            if is_inside {
                let message =
                    format!("node {} lies inside the Eulerian mesh: only its faces can be held", id.label);
                return Err(Wrong::at(row.place, message));
            }
        }
        if self.blocks.last() != Some(&block) {
            self.blocks.push(block);
        }
        Ok(())
    }

    /// The faces that are held as a whole; a face of which a part is held is refused.
    pub(super) fn faces(&self, notes: &mut Notes) -> Held {
        let mut held = [[[false; 3]; 2]; 3];
        for ((normal, side, axis), ids) in &self.found {
            let plane = if *side == 0 { 0 } else { self.mesh.faces[*normal].len() - 1 };
            let inner = |id: &&Id| {
                place(notes, self.mesh, **id)
                    .is_some_and(|at| at[*normal] == plane && self.is_inner(at, *normal))
            };
            let all = self.mesh.nodes.iter().filter(inner).count();
            let those = ids.iter().filter(inner).count();
            held[*normal][*side][*axis] = those == all;
            if those != 0 && those != all {
                let name = ["x", "y", "z"];
                let text = format!(
                    "{those} of {all} nodes inside the face across {} are held along {}: only whole faces can be",
                    name[*normal], name[*axis]
                );
                self.blocks.iter().take(1).for_each(|block| notes.refused(*block, text.clone()));
            }
        }
        self.blocks
            .iter()
            .for_each(|block| notes.understood(*block, "walls of the box, and planes of symmetry"));
        held
    }

    /// Whether a node of a face lies on none of its edges; across a single cell there is nothing else.
    fn is_inner(&self, at: [usize; 3], normal: usize) -> bool {
        (0..3).filter(|axis| *axis != normal).all(|axis| {
            let last = self.mesh.faces[axis].len() - 1;
            last == 1 || at[axis] > 0 && at[axis] < last
        })
    }
}

/// The planes in which a node lies.
fn place(notes: &Notes, mesh: &Eulerian, id: Id) -> Option<[usize; 3]> {
    let point = notes.deck.node(id)?;
    Some([0, 1, 2].map(|axis| near(&mesh.faces[axis], point[axis])))
}
