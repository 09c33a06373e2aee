//! The soil on its grid: `.vtr`.

use super::file::{DataArray, Dataset};
use crate::domain::PlacedDomain;
use crate::output::fields::{CellView, node_velocity};
use crate::output::files::OutputError;
use solver::fields::HISTORY;
use solver::precision::Precision;
use solver::state::State;
use std::path::Path;

/// Indices of `[columns, rows, layers]`, the first running fastest.
fn each_place([columns, rows, layers]: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    (0..layers).flat_map(move |k| (0..rows).flat_map(move |j| (0..columns).map(move |i| [i, j, k])))
}

/// Writes the soil.
pub(super) fn write_soil(
    path: &Path,
    domain: &PlacedDomain,
    state: &State<impl Precision>,
) -> Result<(), OutputError> {
    let [x, y, z] = domain.cells();
    let extent = format!("Extent=\"0 {x} 0 {y} 0 {z}\"");
    let nodes = [x + 1, y + 1, z + 1];
    let node_velocities = each_place(nodes).flat_map(|at| node_velocity(state, domain.index(at)).to_array());
    let axes = ["x", "y", "z"].into_iter().zip(&domain.faces);
    Dataset {
        kind: "RectilinearGrid",
        extent: format!(" Whole{extent}"),
        piece: extent,
        time: state.time,
        sections: vec![
            ("PointData", vec![DataArray::singles("velocity", [nodes.iter().product(), 3], node_velocities)]),
            ("CellData", cell_arrays(domain, state)),
            (
                "Coordinates",
                axes.map(|(name, faces)| DataArray::doubles(name, [faces.len(), 1], faces.iter().copied()))
                    .collect(),
            ),
        ],
    }
    .write(path)
}

fn cell_arrays<'a, R: Precision>(domain: &'a PlacedDomain<'a>, state: &'a State<R>) -> Vec<DataArray<'a>> {
    let cells = || each_place(domain.cells()).map(|at| CellView::of(domain, state, at));
    let one = [domain.cells().iter().product(), 1];
    let several = |components| [one[0], components];
    let mut arrays = vec![
        DataArray::singles("evf", one, cells().map(|c| c.fraction)),
        DataArray::singles("velocity", several(3), cells().flat_map(|c| c.velocity().to_array())),
        DataArray::singles("stress", several(6), cells().flat_map(|c| c.stress())),
        DataArray::singles("pressure", one, cells().map(|c| c.pressure())),
        DataArray::singles("mises", one, cells().map(|c| c.mises())),
        DataArray::singles("density", one, cells().map(|c| c.density())),
    ];
    for (n, variable) in HISTORY.iter().enumerate().filter(|(n, _)| !state.soil.history[*n].is_empty()) {
        arrays.push(DataArray::singles(variable.name, one, cells().map(move |c| c.history(n))));
    }
    arrays
}
