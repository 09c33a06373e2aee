//! What pictures and report show of a state: of a grid in blocks, what the first has been given of the
//! others.

use super::scene::{plane_shown, row_at};
use case::Case;
use results::domain::PlacedDomain;
use results::fields::{HeightMap, filled_cells};
use results::history::SurfacePoint;
use solver::grid::{GHOSTS, Grid};
use solver::halo::Halo;
use solver::portion::Portion;
use solver::precision::Precision;
use solver::state::State;
use std::borrow::Cow;
use std::ops::Range;

/// What is shown of a state.
#[derive(Clone, Debug)]
pub struct Shown<'a, R: Precision> {
    /// The grid, or the portion of it round the slices.
    pub grid: Cow<'a, Grid>,
    /// The state on that grid.
    pub state: Cow<'a, State<R>>,
    /// The free surface of the whole grid.
    pub map: HeightMap,
    /// Cells that hold soil, of all of it.
    pub filled_cells: u64,
}

impl<'a, R: Precision> Shown<'a, R> {
    /// What is shown of a state, with the surface that its grid has `left` behind. Of a grid in blocks the
    /// first gets this of all, and the others get nothing.
    #[must_use]
    pub fn of(
        case: &Case,
        (grid, halo): (&'a Grid, &Halo),
        state: &'a State<R>,
        left: &[SurfacePoint],
    ) -> Option<Self> {
        let mut filled = [filled_cells(&PlacedDomain::of(grid, state.grid_position), state) as i64];
        halo.add(&mut filled);
        let map = HeightMap::of(case, (grid, halo), state, left);
        let (grid, state) = if halo.is_alone() {
            (Cow::Borrowed(grid), Cow::Borrowed(state))
        } else {
            let (grid, state) = slab(case, (grid, halo), state)?;
            (Cow::Owned(grid), Cow::Owned(state))
        };
        Some(Self { grid, state, map: map?, filled_cells: filled[0].cast_unsigned() })
    }
}

/// The row of cells along which the slices lie, with its neighbours, whose stresses have a share in what is
/// shown of it, in the first block.
fn slab<R: Precision>(
    case: &Case,
    (grid, halo): (&Grid, &Halo),
    state: &State<R>,
) -> Option<(Grid, State<R>)> {
    let faces = PlacedDomain::whole_faces(grid, 1, state.grid_position);
    let [columns, rows, planes] = grid.domain.clone();
    let row = rows.start + row_at(&faces, plane_shown(case, state));
    let start = row.saturating_sub(1).min(rows.end.saturating_sub(GHOSTS)).max(rows.start);
    let shown = grid.uncut().block([columns, start..(start + GHOSTS).min(rows.end), planes]);
    let shared: [Range<usize>; 3] = std::array::from_fn(|axis| {
        let (own, shown) = (&grid.own[axis], &shown.own[axis]);
        own.start.max(shown.start)..own.end.min(shown.end)
    });
    let holds_some = shared.iter().all(|layers| !layers.is_empty());
    let own = if holds_some { state.portion(grid, shared).to_numbers() } else { Vec::new() };
    let all = halo.collect(own);
    if all.is_empty() {
        return None;
    }
    let arrays = [state.soil.arrays().count(), state.nodes.arrays().count()];
    let mut joined = state.without_soil(&shown);
    for numbers in all.iter().filter(|numbers| !numbers.is_empty()) {
        joined.put(&shown, &Portion::of_numbers(numbers, arrays));
    }
    Some((shown, joined))
}
