//! Heights of the free surface at given places.

use crate::domain::PlacedDomain;
use crate::history::GroundColumn;
use case::Case;
use solver::halo::Halo;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;
use std::collections::BTreeMap;

/// Two layers of cells next to a place along an axis, and the weight of the second.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Between {
    layers: [usize; 2],
    weight: f64,
}

/// Heights [m] of the free surface of a state at places `(x, y)` [m]: linear between the centres of columns
/// of cells, and that of the outermost column beyond its centre. `None` outside the grid. Mirror images of
/// what is modelled are known, and in plane strain every y. Only the columns next to the places are read.
/// Each block of a grid gets all heights; it must ask for the same places as the others.
#[must_use]
pub fn surface_heights<R: Precision>(
    case: &Case,
    model: &Model,
    halo: &Halo,
    state: &State<R>,
    places: &[[f64; 2]],
) -> Vec<Option<f64>> {
    let faces = [0, 1].map(|axis| PlacedDomain::whole_faces(&model.grid, axis, state.grid_position));
    let between = |place: &[f64; 2]| {
        let [x, y] = modelled(case, *place);
        Some([between(&faces[0], x)?, between(&faces[1], y)?])
    };
    let places: Vec<Option<[Between; 2]>> = places.iter().map(between).collect();
    let mut heights: BTreeMap<[usize; 2], f64> = BTreeMap::new();
    for [x, y] in places.iter().flatten() {
        heights.extend(x.layers.iter().flat_map(|i| y.layers.map(|j| ([*i, j], f64::NAN))));
    }
    let domain = PlacedDomain::of(&model.grid, state.grid_position);
    let [columns, rows, _] = domain.layers();
    let is_own = |[i, j]: &&[usize; 2]| columns.contains(i) && rows.contains(j);
    let own: Vec<[usize; 2]> = heights.keys().filter(is_own).copied().collect();
    let layers: Vec<[usize; 2]> = own.iter().map(|[i, j]| [i - columns.start, j - rows.start]).collect();
    let found = GroundColumn::of_all(&domain, state, (&model.materials, halo), &layers);
    let found = own.iter().zip(found).flat_map(|([i, j], column)| [*i as f64, *j as f64, column.z]);
    for column in halo.gather(found.collect()).as_chunks::<3>().0 {
        let [i, j, z] = *column;
        heights.insert([i as usize, j as usize], z);
    }
    let height = |[x, y]: [Between; 2]| {
        let [low, high] = y.layers.map(|j| x.mean(x.layers.map(|i| heights[&[i, j]])));
        y.mean([low, high])
    };
    places.into_iter().map(|place| place.map(height)).collect()
}

impl Between {
    /// The value at the place of something that is linear between the layers.
    fn mean(self, [low, high]: [f64; 2]) -> f64 {
        low + self.weight * (high - low)
    }
}

/// The place that is modelled and has the same ground.
fn modelled(case: &Case, [x, y]: [f64; 2]) -> [f64; 2] {
    let domain = &case.domain;
    let mirrored = |is_plane: bool, at: f64| if is_plane { at.abs() } else { at };
    let middle = 0.5 * (domain.low.y + domain.high.y);
    [
        mirrored(domain.symmetric_x, x),
        if domain.plane_strain { middle } else { mirrored(domain.symmetric, y) },
    ]
}

/// The layers between these faces [m] whose middles lie next to a place [m]; `None` outside.
fn between(faces: &[f64], at: f64) -> Option<Between> {
    let last = faces.len() - 2;
    if !(faces[0] <= at && at <= faces[last + 1]) {
        return None;
    }
    let middle = |n: usize| 0.5 * (faces[n] + faces[n + 1]);
    let layer = faces.partition_point(|face| *face <= at).saturating_sub(1).min(last);
    let low = if at < middle(layer) { layer.saturating_sub(1) } else { layer };
    let high = if at < middle(layer) { layer } else { (layer + 1).min(last) };
    let apart = middle(high) - middle(low);
    Some(Between { layers: [low, high], weight: if low == high { 0.0 } else { (at - middle(low)) / apart } })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_lie_between_the_middles_of_layers() {
        let faces = [0.0, 1.0, 3.0, 4.0];
        let found = |at: f64| between(&faces, at).map(|found| (found.layers, found.weight));
        assert_eq!(found(0.25), Some(([0, 0], 0.0)));
        assert_eq!(found(0.5), Some(([0, 1], 0.0)));
        assert_eq!(found(1.25), Some(([0, 1], 0.5)));
        assert_eq!(found(2.0), Some(([1, 2], 0.0)));
        assert_eq!(found(3.125), Some(([1, 2], 0.75)));
        assert_eq!(found(4.0), Some(([2, 2], 0.0)));
        assert_eq!(found(0.0), Some(([0, 0], 0.0)));
        assert_eq!([found(-1e-9), found(4.1), found(f64::NAN)], [None; 3]);
        assert_eq!(between(&[0.0, 1.0], 0.7).map(|found| found.layers), Some([0, 0]));
    }
}
