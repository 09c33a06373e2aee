//! Memory of a run, predicted from its model before anything is allocated. All in bytes, as floats, since a
//! prediction may exceed any integer.

use crate::contact::{BodyCell, ContactNode, SlipTerms, kept_per_constraint, layout, rim, stays_across};
use crate::cpu::{seepage, workspace};
use crate::fields::arrays;
use crate::model::{BodyModel, Model};
use crate::scalar::Scalar;
use crate::state::Contact;
use geometry::SurfacePoint;
use glam::DVec3;

/// Memory of a run [bytes].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Footprint {
    /// Fields of the state.
    pub fields: f64,
    /// Portion of the fields of the state that stays untouched where there has never been soil: the operating
    /// system commits no memory for it.
    pub fields_of_soil: f64,
    /// Workspace of the step, without contact.
    pub workspace: f64,
    /// Surfaces of the bodies, and their contact points with soil to act on.
    pub contact: f64,
    /// Temporary memory while the points of the largest body are laid out.
    pub layout: f64,
}

/// Arrays of the state that are written in every cell at the start: volume fraction, mass, stress, nodal
/// mass.
const WRITTEN: f64 = 9.0;
/// Contact nodes per constraint: there are four in a cell, and neighbouring cells share nodes.
const NODES_PER_CONSTRAINT: f64 = 2.5;

/// Memory of a run with `threads` threads, each body ending at the displacement `moved` from its start [m].
#[must_use]
pub fn footprint<R: Scalar>(model: &Model, threads: usize, moved: &[DVec3]) -> Footprint {
    let grid = &model.grid;
    let [fields, fields_of_soil] = self::fields::<R>(model);
    let per_surface_point = size_of::<(DVec3, u32, u16)>() as f64;
    let per_constraint = per_constraint(size_of::<ContactNode>()) + kept_per_constraint(model);
    let [contact, layout] = contact(model, moved, [per_surface_point, per_constraint]);
    let workspace =
        workspace::footprint::<R>(model, workspace::team_size(grid, threads)) + seepage::footprint(model);
    let body_cells = body_cells(model) * size_of::<BodyCell>() as f64;
    Footprint { fields, fields_of_soil, workspace, contact: contact + body_cells, layout }
}

/// Fields of a state, and those that are written only where there is soil.
fn fields<R>(model: &Model) -> [f64; 2] {
    let arrays = arrays(model.materials.len(), model.kinds()) as f64;
    let one = (model.grid.entries * size_of::<R>()) as f64;
    [arrays * one, (arrays - WRITTEN) * one]
}

/// Contact points of all bodies, each ending at the displacement `moved` from its start [m]: memory kept for
/// them, and temporary memory for the largest body. `per_constraint` is the memory for each constraint.
fn contact(model: &Model, moved: &[DVec3], [per_point, per_constraint]: [f64; 2]) -> [f64; 2] {
    /// For each point: the shape's list, its copy in pairs, and the tree that finds the pairs.
    const LAID_OUT: f64 = 2.0 * size_of::<SurfacePoint>() as f64 + 60.0;
    let points_per_constraint = (2.0 * model.method.point_spacing).min(1.0).powi(-2);
    let mut sums = [0.0_f64; 2];
    for (n, body) in model.bodies.iter().enumerate().filter(|(_, body)| body.shape.has_surface()) {
        let all = surface_points(model, body);
        let [kept, touching] = point_fractions(model, body, moved.get(n).copied().unwrap_or_default());
        let each = per_contact() + per_constraint / points_per_constraint;
        sums[0] += all * (kept * per_point + touching * each);
        sums[1] = sums[1].max(all * LAID_OUT);
    }
    sums
}

/// Number of surface points that are laid out on a body.
#[must_use]
pub fn surface_points(model: &Model, body: &BodyModel) -> f64 {
    let (spacing, inset) = layout(model, body);
    body.shape.surface_point_count(spacing, inset)
}

/// Number of bins in which the sums over a body's rim are kept, that of the flanks included.
#[must_use]
pub fn rim_bins(model: &Model, body: &BodyModel) -> f64 {
    rim(model, body).middles().len() as f64 + 1.0
}

/// Number of cells that bodies occupy, wholly or in part.
fn body_cells(model: &Model) -> f64 {
    let cells = |body: &BodyModel| {
        let (low, high) = body.bounds(&body.start);
        let filling = body.shape.mass_properties().volume / (high - low).element_product();
        let layers = |axis: usize| {
            let faces = &model.grid.faces[axis];
            let first = faces.partition_point(|f| *f <= low[axis]).saturating_sub(1);
            let last = faces.partition_point(|f| *f < high[axis]);
            last.min(faces.len() - 1).saturating_sub(first) as f64
        };
        filling * (0..3).map(layers).product::<f64>()
    };
    model.bodies.iter().filter(|body| body.shape.has_surface()).map(cells).sum()
}

/// Memory of a contact point, before and after a search: the point, its nodes, its constraint and whether it
/// is active, its impulses, and what it adds to the sums over the rim.
fn per_contact() -> f64 {
    let one = size_of::<Contact>() as f64;
    let lists = size_of::<[u32; 8]>()
        + size_of::<(usize, u32, bool)>()
        + size_of::<[DVec3; 2]>()
        + size_of::<SlipTerms>()
        + size_of::<[usize; 8]>();
    2.0 * one + lists as f64
}

/// Memory of a constraint besides that of the contact law: its nodes, its cut-cell correction, and its entry
/// in the search.
fn per_constraint(contact_node: usize) -> f64 {
    let hourglass_correction = size_of::<[DVec3; 8]>() + size_of::<Option<[DVec3; 8]>>();
    NODES_PER_CONSTRAINT * contact_node as f64 + hourglass_correction as f64 + 120.0
}

/// Fractions of a body's surface points that are kept, and that have soil to act on, at the start or at the
/// displacement `moved` [m], whichever is more; by area, from a coarse set of points.
fn point_fractions(model: &Model, body: &BodyModel, moved: DVec3) -> [f64; 2] {
    /// Points along the diagonal.
    const FEW: f64 = 16.0;
    let (low, high) = body.shape.bounds();
    let points = body.shape.surface_points(DVec3::splat((high - low).length() / FEW), DVec3::ZERO);
    let spacing = model.method.point_spacing * model.grid.fine_cell().y;
    let stays = stays_across(body, 1);
    let is_in = |axis: usize, x: DVec3, margin: f64| {
        let faces = &model.grid.faces[axis];
        (faces[0] - margin..=faces[faces.len() - 1] + margin).contains(&x[axis])
    };
    let fraction = |of: &dyn Fn(DVec3) -> bool| {
        let area = |p: &&SurfacePoint| p.area;
        let those = points.iter().filter(|p| of(body.start.position + body.rotated(&body.start, p.position)));
        those.map(|p| area(&p)).sum::<f64>() / points.iter().map(|p| p.area).sum::<f64>()
    };
    let top = model.top_of_ground();
    let in_soil = |x: DVec3| x.z <= top && (0..3).all(|axis| is_in(axis, x, 0.0));
    let touching = fraction(&in_soil).max(fraction(&|x| in_soil(x + moved)));
    [fraction(&|x| !stays || is_in(1, x, spacing)), touching]
}
