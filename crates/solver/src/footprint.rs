//! What a run will take up in memory, told from its model before any of it exists. All in bytes, as floats: what nobody could
//! ever hold has a number too.

use crate::model::{BodyModel, Model};
use crate::state::{Contact, Nodes, Soil};
use glam::DVec3;
use physics::rigid::Freedom;
use physics::shape::SurfacePoint;

/// Memory of a run [bytes].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Footprint {
    /// Fields of the state.
    pub fields: f64,
    /// Those of them that stay untouched where no soil has ever been: a system lends no memory for them.
    pub fields_of_soil: f64,
    /// What the step works in, but for contact.
    pub workspace: f64,
    /// Surfaces of the bodies, and what is kept for their points that have soil to act on.
    pub contact: f64,
    /// More that is needed for a moment, when the points of the body with the most are laid out.
    pub layout: f64,
}

/// Arrays of the state that are written in every cell at the start: fraction, mass, stress, and the mass of the nodes.
const WRITTEN: f64 = 9.0;
/// Sharing of a cell's nodes by neighbouring patches: about so many nodes for each patch of points.
const NODES_PER_PATCH: f64 = 2.5;
/// A list that grows leaves up to half of its room unused, a third in the mean of all lengths.
const GROWN: f64 = 4.0 / 3.0;

/// Fields of a state whose grid has so many entries, and those that only soil touches; `R` is their precision.
#[must_use]
pub(crate) fn fields<R>(entries: usize) -> [f64; 2] {
    // All that Soil and Nodes hold are arrays over the grid.
    let arrays = ((size_of::<Soil<R>>() + size_of::<Nodes<R>>()) / size_of::<Vec<R>>()) as f64;
    let one = (entries * size_of::<R>()) as f64;
    [arrays * one, (arrays - WRITTEN) * one]
}

/// Contact points of all bodies: what is kept for them, and what laying out the largest takes besides; `per_patch` is what the
/// contact law keeps of a patch.
#[must_use]
pub(crate) fn contact(model: &Model, [per_surface_point, per_patch]: [f64; 2]) -> [f64; 2] {
    /// Of a shape's list of points, its copy in pairs, and the tree that finds the pairs.
    const LAID_OUT: f64 = 2.0 * size_of::<SurfacePoint>() as f64 * GROWN + 100.0;
    let mut sums = [0.0_f64; 2];
    for body in &model.bodies {
        let all = surface_points(model, body);
        let kept = all * within(model, body);
        let touching = kept * wetted(model, body);
        let spacing = model.method.point_spacing;
        let patches = touching * spacing.min(1.0).powi(2);
        sums[0] += kept * per_surface_point + touching * per_contact() + patches * per_patch;
        sums[1] = sums[1].max(all * LAID_OUT);
    }
    sums
}

/// Number of surface points that are laid out on a body.
#[must_use]
pub fn surface_points(model: &Model, body: &BodyModel) -> f64 {
    let finest = DVec3::from_array(std::array::from_fn(|axis| model.grid.finest_along(axis)));
    let spacing = model.method.point_spacing * model.grid.finest();
    body.shape.surface_point_count(spacing, model.method.edge_inset * finest)
}

/// Cells that bodies take up, in the box.
#[must_use]
pub(crate) fn body_cells(model: &Model) -> f64 {
    let cells = |body: &BodyModel| {
        let (low, high) = body.shape.bounds();
        let size = high - low;
        let filling = body.shape.volume() / size.element_product();
        let layers = |axis: usize| {
            let faces = &model.grid.faces[axis];
            let first = faces.partition_point(|f| *f <= body.start[axis] + low[axis]).saturating_sub(1);
            let last = faces.partition_point(|f| *f < body.start[axis] + high[axis]);
            last.min(faces.len() - 1).saturating_sub(first) as f64
        };
        filling * (0..3).map(layers).product::<f64>()
    };
    model.bodies.iter().map(cells).sum()
}

/// What is kept for a point with soil to act on, old and new: itself, its corners, its patch, its friction.
fn per_contact() -> f64 {
    let one = size_of::<Contact>() as f64;
    let lists =
        size_of::<[u32; 8]>() + 2 * size_of::<Option<usize>>() + size_of::<DVec3>() + size_of::<[usize; 8]>();
    one * (1.0 + GROWN) + lists as f64
}

/// What is kept for a patch besides what the contact law keeps: the nodes, the forces that are missing, and how it is found.
pub(crate) fn per_patch(touched_node: usize) -> f64 {
    let missing = size_of::<[DVec3; 8]>() + size_of::<Option<[DVec3; 8]>>();
    NODES_PER_PATCH * touched_node as f64 + missing as f64 + 120.0
}

/// Share of a body's points that are not behind a plane of symmetry.
fn within(model: &Model, body: &BodyModel) -> f64 {
    if body.translation[1] != Freedom::Fixed {
        return 1.0;
    }
    let (low, high) = body.shape.bounds();
    let faces = &model.grid.faces[1];
    share([body.start.y + low.y, body.start.y + high.y], [faces[0], faces[faces.len() - 1]])
}

/// Share of them that lie in soil at the deepest place that can be told beforehand. A body that is free to sink is taken to
/// do so by a tenth of its height.
fn wetted(model: &Model, body: &BodyModel) -> f64 {
    let (low, high) = body.shape.bounds();
    let height = high.z - low.z;
    let faces = &model.grid.faces[2];
    let sunk = match body.translation[2] {
        Freedom::Fixed => 0.0,
        Freedom::Free { .. } => 0.1 * height,
        Freedom::Prescribed { .. } => 0.5 * height,
    };
    let z = body.start.z - sunk;
    share([z + low.z, z + high.z], [faces[0], model.surface.min(faces[faces.len() - 1])])
}

/// Share of a range that lies in another.
fn share([low, high]: [f64; 2], [from, to]: [f64; 2]) -> f64 {
    ((high.min(to) - low.max(from)) / (high - low)).clamp(0.0, 1.0)
}
