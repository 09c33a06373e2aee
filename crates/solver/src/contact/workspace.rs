//! Memory that contact works in.

use super::body_fraction::BodyCell;
use super::constraint;
use super::law::ContactLaw;
use super::method::law;
use super::nodes::contact_nodes;
use super::scene::ContactNode;
use super::surface::Surface;
use crate::halo::{self, Halo};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::State;
use glam::DVec3;

/// What contact keeps between steps and between two searches.
pub(crate) struct ContactWorkspace {
    /// How soil and bodies act on each other.
    pub(crate) law: Box<dyn ContactLaw>,
    /// Surfaces of the bodies.
    pub(crate) surfaces: Vec<Surface>,
    /// The cells of which bodies take up a share, body by body.
    pub(crate) body_cells: Vec<BodyCell>,
    /// Nodes that contact acts on.
    pub(crate) nodes: Vec<ContactNode>,
    /// For each contact, the places of its cell's nodes among them.
    pub(crate) corner_nodes: Vec<[u32; 8]>,
    /// For each contact the number of its constraint; for each constraint the forces that are missing at its nodes.
    pub(crate) constraint: (Vec<usize>, Vec<[DVec3; 8]>),
    /// Frictional impulse at each contact in the last step [N s].
    pub(crate) friction: Vec<DVec3>,
}

impl std::fmt::Debug for ContactWorkspace {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "ContactWorkspace for {} nodes", self.nodes.len())
    }
}

impl ContactWorkspace {
    /// Memory for the bodies of a model and the contacts of a state.
    pub(crate) fn new<R: Scalar>(model: &Model, state: &State<R>, halo: &mut dyn Halo) -> Self {
        let mut workspace = Self {
            law: law(model),
            surfaces: model.bodies.iter().map(|body| Surface::new(model, body)).collect(),
            body_cells: Vec::new(),
            nodes: Vec::new(),
            corner_nodes: Vec::new(),
            constraint: (Vec::new(), Vec::new()),
            friction: Vec::new(),
        };
        workspace.connect(model, state, halo);
        workspace
    }

    /// Connects the contacts with the nodes and with each other, after a search.
    pub(super) fn connect<R: Scalar>(&mut self, model: &Model, state: &State<R>, halo: &mut dyn Halo) {
        (self.nodes, self.corner_nodes) = contact_nodes(model, &state.contacts);
        let fractions = fractions(model, state, halo);
        self.constraint = constraint::number(model, state, &fractions);
    }

    /// Memory that it takes up [bytes], but for what the contact law keeps during a step.
    pub(crate) fn memory(&self) -> usize {
        self.surfaces.iter().map(Surface::memory).sum::<usize>()
            + size_of_val(self.body_cells.as_slice())
            + size_of_val(self.nodes.as_slice())
            + size_of_val(self.corner_nodes.as_slice())
            + size_of_val(self.constraint.0.as_slice())
            + size_of_val(self.constraint.1.as_slice())
            + size_of_val(self.friction.as_slice())
    }
}

/// Volume fractions in the cells of all contacts.
fn fractions<R: Scalar>(model: &Model, state: &State<R>, halo: &mut dyn Halo) -> Vec<f64> {
    let grid = &model.grid;
    let own = state.contacts.iter().enumerate().filter_map(|(n, contact)| {
        let whole = contact.cell.map(|layer| layer as usize);
        let [i, j, k] = grid.in_block(whole).filter(|_| grid.owns(whole))?;
        Some((n, [state.soil.fraction[grid.index(i, j, k)].to_f64()]))
    });
    halo::in_order(halo, own).into_iter().map(|(_, [fraction])| fraction).collect()
}
