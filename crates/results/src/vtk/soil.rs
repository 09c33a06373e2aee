//! The soil on its grid: `.vtr`.

use super::file::{DataArray, Dataset};
use crate::domain::PlacedDomain;
use crate::fields::{CellView, node_velocity};
use crate::files::{Inside, OutputError};
use solver::fields::HISTORY;
use solver::halo::Halo;
use solver::precision::Precision;
use solver::state::State;
use std::ops::Range;

/// Indices of `[columns, rows, layers]`, the first running fastest.
fn each_place([columns, rows, layers]: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    (0..layers).flat_map(move |k| (0..rows).flat_map(move |j| (0..columns).map(move |i| [i, j, k])))
}

/// Writes the soil of a whole grid.
pub(super) fn write_soil(
    file: &Inside,
    domain: &PlacedDomain,
    state: &State<impl Precision>,
) -> Result<(), OutputError> {
    dataset(domain, state).write(file)
}

/// Writes the soil of each block beside `file`, and in `file` how they make up the whole; the first block
/// writes that when all others have written theirs.
pub(super) fn write_blocks(
    file: &Inside,
    (domain, halo): (&PlacedDomain, &Halo),
    state: &State<impl Precision>,
) -> Result<(), OutputError> {
    let name = |rank: usize| {
        let stem = file.stem();
        format!("{stem}_{rank:04}.vtr")
    };
    let own = dataset(domain, state);
    let whole = extent(&domain.grid.domain.clone().map(|layers| 0..layers.len()));
    let layers = domain.layers();
    own.write(&file.beside(name(halo.rank())))?;
    let all = halo.collect(layers.iter().flat_map(|own| [own.start as f64, own.end as f64]).collect());
    if all.is_empty() {
        return Ok(());
    }
    let of_block = |ends: &Vec<f64>| {
        extent(&std::array::from_fn(|axis| ends[2 * axis] as usize..ends[2 * axis + 1] as usize))
    };
    let pieces: Vec<_> = all.iter().enumerate().map(|(rank, ends)| (of_block(ends), name(rank))).collect();
    dataset(domain, state).write_joined(file, &whole, &pieces)
}

/// The attribute of some layers.
fn extent(layers: &[Range<usize>; 3]) -> String {
    let [x, y, z] = layers;
    format!("Extent=\"{} {} {} {} {} {}\"", x.start, x.end, y.start, y.end, z.start, z.end)
}

/// The soil of a domain as arrays.
fn dataset<'a>(domain: &'a PlacedDomain<'a>, state: &'a State<impl Precision>) -> Dataset<'a> {
    let extent = extent(&domain.layers());
    let nodes = domain.cells().map(|n| n + 1);
    let node_velocities =
        each_place(nodes).flat_map(move |at| node_velocity(state, domain.index(at)).to_array());
    let axes = ["x", "y", "z"].into_iter().zip(&domain.faces);
    Dataset {
        kind: "RectilinearGrid",
        extent: format!(" Whole{extent}"),
        piece: extent,
        time: state.time,
        facts: Vec::new(),
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
