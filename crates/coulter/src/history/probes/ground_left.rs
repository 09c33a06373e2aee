//! The probe of the ground that a grid that travels leaves behind: the height of the soil where it flows out.

use crate::domain::PlacedDomain;
use crate::history::SurfacePoint;
use solver::boundary::Boundary;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;

/// Adds the surface over the last layer of cells at the outflow boundary to what the grid has left behind: at the start, and
/// whenever the grid has travelled at least the width of this layer since then.
pub fn record_ground_left<R: Precision>(model: &Model, state: &State<R>, left: &mut Vec<SurfacePoint>) {
    let Some((axis, end)) = outflow(model) else { return };
    let domain = PlacedDomain::of(&model.grid, state.grid_position);
    let cells = domain.cells();
    let (last, away) = if end == 0 { (0, 1.0) } else { (cells[axis] - 1, -1.0) };
    let (width, here) = (domain.width(axis, last), domain.centre(axis, last));
    let is_due = |point: &SurfacePoint| away * (here - point.along(axis)) >= width * (1.0 - 1e-9);
    if !left.last().is_none_or(is_due) {
        return;
    }
    left.extend((0..cells[1 - axis]).map(|n| {
        let [i, j] = if axis == 0 { [last, n] } else { [n, last] };
        let z = domain.surface_height(state, [i, j]);
        SurfacePoint { x: domain.centre(0, i), y: domain.centre(1, j), z }
    }));
}

/// Axis and end, the low one (0) or the high one (1), of the outflow boundary that the grid leaves ground behind at: of a grid
/// that travels along x and y that across x.
fn outflow(model: &Model) -> Option<(usize, usize)> {
    let travels = model.follow?.axes;
    let ends = (0..2).flat_map(|axis| [(axis, 0), (axis, 1)]);
    ends.into_iter().find(|&(axis, end)| travels[axis] && model.boundaries.0[axis][end] == Boundary::Outflow)
}
