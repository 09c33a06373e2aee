//! Scratch memory of contact.

use super::body_fraction::BodyCell;
use super::confined::Confined;
use super::constraint;
use super::constraint_points::ConstraintPoints;
use super::gather::Owners;
use super::islands::Islands;
use super::law::ContactLaw;
use super::method::law;
use super::nodes::contact_nodes;
use super::problem::ContactNode;
use super::rim_stress::RimStress;
use super::slip_terms::SlipTerms;
use super::surface::Surface;
use crate::cpu::threads::Crew;
use crate::grid::Grid;
use crate::halo::{self, Halo};
use crate::model::Model;
use crate::scalar::Scalar;
use crate::state::{Nodes, State};
use glam::DVec3;

/// Memory that contact keeps between steps, and between two contact searches.
pub(crate) struct ContactWorkspace {
    /// Contact law.
    pub(crate) law: Box<dyn ContactLaw>,
    /// Contact points of the bodies' surfaces.
    pub(crate) surfaces: Vec<Surface>,
    /// Cells that bodies occupy, wholly or in part, in the order of the bodies.
    pub(crate) body_cells: Vec<BodyCell>,
    /// Cells with soil that overlaps a body and found no space beside it.
    pub(crate) confined: Vec<Confined>,
    /// Contact nodes.
    pub(crate) nodes: Vec<ContactNode>,
    /// The blocks that own them.
    pub(crate) owners: Owners,
    /// Velocities of the nodes during a step; once slip is accounted for, the sums of those before and after
    /// it [m/s].
    pub(crate) velocity: Vec<DVec3>,
    /// Inverse masses of the nodes along x, y, z [1/kg]; 0 where a node has no mass or a boundary holds it.
    pub(crate) inverse_mass: Vec<DVec3>,
    /// For each contact point the indices of its cell's nodes among the contact nodes.
    pub(crate) corner_nodes: Vec<[u32; 8]>,
    /// The contact points of each constraint.
    pub(crate) constraint_points: ConstraintPoints,
    /// Bodies that share contact nodes.
    pub(crate) islands: Islands,
    /// For each constraint the cut-cell hourglass correction at its cell's nodes, per unit normal force.
    pub(crate) hourglass_correction: Vec<[DVec3; 8]>,
    /// Normal and frictional impulse on the soil at each contact point in the last step [N s].
    pub(crate) impulses: Vec<[DVec3; 2]>,
    /// What each contact point adds to the sums over the rim in a step.
    pub(crate) terms: Vec<SlipTerms>,
    /// Nodes by way of which stress and slip are summed over the rim.
    pub(crate) rim_stress: RimStress,
    /// For each contact point the index in memory of the cell whose pore pressure acts there, if the block
    /// has it.
    pub(crate) pressure_cells: Vec<Option<usize>>,
    /// Pore pressures that act at the contact points in a step [Pa]; empty where none is computed.
    pub(crate) pore_pressures: Vec<f64>,
    /// Volume per time by which gaps between soil and bodies grow there [m³/s].
    pub(crate) openings: Vec<f64>,
}

impl std::fmt::Debug for ContactWorkspace {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "ContactWorkspace for {} nodes", self.nodes.len())
    }
}

impl ContactWorkspace {
    /// Workspace for the bodies of a model and the contacts of a state.
    pub(crate) fn new<R: Scalar>(model: &Model, state: &State<R>, crew: Crew, halo: &Halo) -> Self {
        let mut workspace = Self {
            law: law(model),
            surfaces: model.bodies.iter().map(|body| Surface::new(model, body)).collect(),
            body_cells: Vec::new(),
            confined: Vec::new(),
            nodes: Vec::new(),
            owners: Owners::default(),
            velocity: Vec::new(),
            inverse_mass: Vec::new(),
            corner_nodes: Vec::new(),
            constraint_points: ConstraintPoints::default(),
            islands: Islands::default(),
            hourglass_correction: Vec::new(),
            impulses: Vec::new(),
            terms: Vec::new(),
            rim_stress: RimStress::default(),
            pressure_cells: Vec::new(),
            pore_pressures: Vec::new(),
            openings: Vec::new(),
        };
        workspace.connect(model, state, crew, halo);
        workspace
    }

    /// Finds contact nodes and constraints after a contact search.
    pub(super) fn connect<R: Scalar>(&mut self, model: &Model, state: &State<R>, crew: Crew, halo: &Halo) {
        (self.nodes, self.corner_nodes) = contact_nodes(model, &state.contacts);
        self.owners = Owners::of(&self.nodes, halo);
        self.islands = Islands::new(&state.contacts, &self.corner_nodes, self.nodes.len());
        let fractions = fractions(model, state, halo);
        (self.constraint_points, self.hourglass_correction) =
            constraint::number(model, state, &fractions, crew);
        self.rim_stress = RimStress::new(model, state, &self.surfaces, halo);
    }

    /// Begins to send the other blocks what they need to know of this one's contact nodes.
    pub(crate) fn begin_gather<R: Scalar>(&self, nodes: &Nodes<R>, before: &[Vec<R>; 3], halo: &Halo) {
        self.owners.begin(&self.nodes, (nodes, before), halo);
    }

    /// Contact nodes of this block, and cells with confined soil: indices in memory.
    pub(crate) fn entries(&self) -> (impl Iterator<Item = usize>, impl Iterator<Item = usize>) {
        (self.nodes.iter().filter_map(|node| node.node), self.confined.iter().map(|own| own.cell))
    }

    /// First row of nodes in memory that other blocks need of this one, if there is one.
    pub(crate) fn first_row(&self, grid: &Grid, halo: &Halo) -> Option<usize> {
        let owned = self.nodes.iter().filter(|node| node.is_owned).filter_map(|node| node.node);
        owned.min().filter(|_| !halo.is_alone()).map(|n| n / grid.stride[1])
    }

    /// Memory in use [bytes], except what the contact law keeps during a step.
    pub(crate) fn memory(&self) -> usize {
        self.surfaces.iter().map(Surface::memory).sum::<usize>()
            + size_of_val(self.body_cells.as_slice())
            + size_of_val(self.confined.as_slice())
            + size_of_val(self.nodes.as_slice())
            + self.owners.memory()
            + size_of_val(self.velocity.as_slice())
            + size_of_val(self.inverse_mass.as_slice())
            + size_of_val(self.corner_nodes.as_slice())
            + self.constraint_points.memory()
            + self.islands.memory()
            + size_of_val(self.hourglass_correction.as_slice())
            + size_of_val(self.impulses.as_slice())
            + size_of_val(self.terms.as_slice())
            + self.rim_stress.memory()
            + size_of_val(self.pressure_cells.as_slice())
            + size_of_val(self.pore_pressures.as_slice())
            + size_of_val(self.openings.as_slice())
    }
}

/// Volume fractions in the cells of all contact points.
fn fractions<R: Scalar>(model: &Model, state: &State<R>, halo: &Halo) -> Vec<f64> {
    let grid = &model.grid;
    let own = state.contacts.iter().enumerate().filter_map(|(n, contact)| {
        let whole = contact.cell.map(|layer| layer as usize);
        let [i, j, k] = grid.in_block(whole).filter(|_| grid.owns(whole))?;
        Some((n, [state.soil.fraction[grid.index(i, j, k)].to_f64()]))
    });
    halo::in_order(halo, own).into_iter().map(|(_, [fraction])| fraction).collect()
}
