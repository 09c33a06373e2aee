//! The probe of the ground that a grid that travels leaves behind: the height of the soil where it flows out.

use crate::domain::PlacedDomain;
use crate::history::{GroundColumn, SurfacePoint};
use solver::boundary::Boundary;
use solver::halo::Halo;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;

/// Adds the surface over the last layer of cells at the outflow boundary to what the grid has left behind: at
/// the start, and whenever the grid has travelled at least the width of this layer since then. Each block of
/// a grid has the whole of it.
pub fn record_ground_left<R: Precision>(
    model: &Model,
    state: &State<R>,
    halo: &Halo,
    left: &mut Vec<SurfacePoint>,
) {
    let Some((axis, end)) = outflow(model) else { return };
    let (faces, inside) = (&model.grid.whole[axis], &model.grid.domain[axis]);
    let (last, away) = if end == 0 { (inside.start, 1.0) } else { (inside.end - 1, -1.0) };
    let [low, high] = [faces[last], faces[last + 1]].map(|face| face + state.grid_position[axis]);
    let (width, here) = (faces[last + 1] - faces[last], 0.5 * (high + low));
    let is_due = |point: &SurfacePoint| away * (here - point.along(axis)) >= width * (1.0 - 1e-9);
    if !left.last().is_none_or(is_due) {
        return;
    }
    let domain = PlacedDomain::of(&model.grid, state.grid_position);
    let [columns, rows, _] = domain.layers();
    let in_line = if axis == 0 { rows } else { columns };
    let number = if end == 0 { 0 } else { domain.cells()[axis] - 1 };
    let places: Vec<[usize; 2]> = if domain.reaches(axis, end) {
        (0..in_line.len()).map(|n| if axis == 0 { [number, n] } else { [n, number] }).collect()
    } else {
        Vec::new()
    };
    let own = GroundColumn::of_all(&domain, state, (&model.materials, halo), &places);
    let points = places.iter().zip(own).map(|(&[i, j], column)| SurfacePoint {
        x: domain.centre(0, i),
        y: domain.centre(1, j),
        column,
    });
    // Blocks beside each other are in the order of y.
    let all = halo.gather(points.flat_map(SurfacePoint::to_array).collect());
    left.extend(all.chunks_exact(SurfacePoint::NUMBERS).map(SurfacePoint::of));
}

/// Axis and end, the low one (0) or the high one (1), of the outflow boundary that the grid leaves ground
/// behind at: of a grid that travels along x and y that across x.
fn outflow(model: &Model) -> Option<(usize, usize)> {
    let travels = model.follow?.axes;
    let ends = (0..2).flat_map(|axis| [(axis, 0), (axis, 1)]);
    ends.into_iter().find(|&(axis, end)| travels[axis] && model.boundaries.0[axis][end] == Boundary::Outflow)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use physics::elastic::Elastic;
    use solver::boundary::Boundary::{Inflow, Outflow};
    use solver::grid::Grid;
    use solver::initial::{Filling, at_rest};
    use solver::material::Material;
    use solver::model::Follow;

    /// Unit cells, five along x and y, that travel along an axis away from one of its ends.
    fn travelling(axis: usize, end: usize) -> Model {
        let mut open = [[false; 2]; 3];
        open[axis] = [true; 2];
        let faces = [5, 5, 3].map(|n| (0..=n).map(f64::from).collect());
        let material = Material::linear_elastic(Elastic::new(1e6, 0.3), 1600.0);
        let mut model = Model::bare(Grid::with_open_faces(faces, open, 8), material);
        model.boundaries.0[axis] = if end == 0 { [Outflow, Inflow] } else { [Inflow, Outflow] };
        model.follow = Some(Follow { body: 0, axes: [axis == 0, axis == 1, false] });
        model
    }

    #[test]
    fn a_line_is_kept_for_every_cell_that_the_grid_travels_whichever_way() {
        for (axis, end, away) in [(0, 0, 1.0), (0, 1, -1.0), (1, 0, 1.0), (1, 1, -1.0)] {
            let model = travelling(axis, end);
            let ground = Filling::between(DVec3::NEG_INFINITY, DVec3::new(1e9, 1e9, 1.25));
            let (mut state, mut left) = (at_rest::<f64>(&model, &ground), Vec::new());
            // The grid moves back in between, over ground that it has left before.
            for travelled in [0.0, 0.5, 1.0, 1.5, 0.0, 2.5, 3.0] {
                state.grid_position[axis] = away * travelled;
                record_ground_left(&model, &state, &Halo::whole(), &mut left);
            }
            let first = if end == 0 { 0.5 } else { 4.5 };
            let expected = [0.0, 1.0, 2.5].map(|travelled| first + away * travelled);
            let lines: Vec<f64> = left.chunks(5).map(|line| line[0].along(axis)).collect();
            assert_eq!(lines, expected, "axis {axis}, end {end}");
            for (n, point) in left.iter().enumerate() {
                assert_eq!((point.along(1 - axis), point.column.z), (0.5 + (n % 5) as f64, 1.25));
            }
        }
    }

    #[test]
    fn a_grid_that_stands_still_leaves_nothing() {
        let model = Model { follow: None, ..travelling(0, 0) };
        let (state, mut left) =
            (at_rest::<f64>(&model, &Filling::between(DVec3::ZERO, DVec3::ONE)), Vec::new());
        record_ground_left(&model, &state, &Halo::whole(), &mut left);
        assert!(left.is_empty());
    }
}
