//! Whether a state that was read is one of a grid, and of a model: the method assumes that its arrays are as
//! long and that its numbers of bodies, points and cells are of something.

use crate::contact::Surface;
use crate::fields::HISTORY;
use crate::model::Model;
use crate::state::{Contact, State};

/// Most soils besides the first: numbers of soils have 8 bits.
const MOST_OTHERS: usize = 255;
/// Most steps of a run, far from what their number can hold (chosen).
const MOST_STEPS: u64 = 1 << 53;

impl<R> State<R> {
    /// Whether all arrays of soil and nodes have so many entries, those that soils of its kind do not need
    /// none.
    #[must_use]
    pub fn has_entries(&self, count: usize) -> bool {
        let mut arrays = self.soil.arrays().chain(self.nodes.arrays());
        self.soil.composition.len() <= MOST_OTHERS && arrays.all(|array| array.len() == count)
    }

    /// Whether the state can be a state of a model.
    #[must_use]
    pub fn is_of(&self, model: &Model) -> bool {
        let kinds = model.kinds();
        let mut history = HISTORY.iter().zip(&self.soil.history);
        self.has_entries(model.grid.entries)
            && history.all(|(variable, field)| kinds.need(variable) != field.is_empty())
            && self.soil.composition.len() + 1 == model.materials.len()
            && self.mechanism.bodies.len() == model.bodies.len()
            && self.mechanism.joints.len() == model.joints.len() + model.pairs.len()
            && (0.0..f64::INFINITY).contains(&self.time)
            && self.step < MOST_STEPS
            && self.has_bodies_of(model)
    }

    fn has_bodies_of(&self, model: &Model) -> bool {
        let surfaces: Vec<Surface> = model.bodies.iter().map(|body| Surface::new(model, body)).collect();
        let mut bodies = self.bodies.iter().zip(&model.bodies).zip(&surfaces);
        let cells = model.grid.whole_cells();
        let is_of = |c: &Contact| {
            surfaces.get(c.body as usize).is_some_and(|surface| (c.point as usize) < surface.len())
                && (c.material as usize) < model.materials.len()
                && (0..3).all(|axis| (c.cell[axis] as usize) < cells[axis])
                && c.octant < 8
                && c.side <= 2
        };
        self.bodies.len() == model.bodies.len()
            && bodies.all(|((body, fixed), surface)| {
                let parts = fixed.shape.parts();
                body.parts.len() == if parts > 1 { parts } else { 0 }
                    && body.rim.len() == surface.rim().len() + 1
            })
            && self.contacts.iter().all(is_of)
            && self.contacts.is_sorted_by(|a, b| (a.body, a.point) < (b.body, b.point))
    }
}
