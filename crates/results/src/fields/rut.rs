//! What a body leaves of the ground: sections across its rut along the whole tow.

use super::surface::HeightMap;
use crate::history::{BodySample, RutSection};
use case::resolved::{Body, Case};
use case::tow::TowDirection;
use glam::DVec3;
use solver::precision::Precision;
use solver::state::State;

/// The rut of a body.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rut {
    /// Sections along the tow, over every column of cells.
    pub sections: Vec<RutSection>,
    /// Mean section behind the body, from one length behind its middle on, over the last part of the tow or
    /// at least half a length; `None` where the body has not gone farther than its length.
    pub mean: Option<RutSection>,
}

/// The rut of every body, nothing of a frame. Where several run beside each other, the ground is shared at
/// the middle between their tracks; of bodies in one track each has the whole.
#[must_use]
pub fn ruts(
    case: &Case,
    map: &HeightMap,
    state: &State<impl Precision>,
    samples: &[Vec<BodySample>],
) -> Vec<Rut> {
    let tracks: Vec<(usize, f64)> =
        case.touching().map(|(n, body)| (n, state.pose(n).position[1 - tow_axis(case, body)])).collect();
    let of_body = |n: usize| {
        let body = &case.bodies[n];
        if !body.has_surface() || case.ground.surface() != map.reference {
            return Rut::default();
        }
        let axis = tow_axis(case, body);
        let own = state.pose(n).position[1 - axis];
        let width = body.size()[1 - axis];
        // Tracks that are less than half a width apart are one.
        let beside = |side: f64| {
            let others = tracks.iter().filter(|(_, track)| side * (track - own) > 0.5 * width);
            let nearest = others.map(|(_, track)| 0.5 * side * (track + own)).fold(f64::INFINITY, f64::min);
            side * nearest
        };
        let band = [beside(-1.0), beside(1.0)];
        let sections = sections(map, axis, (own, band));
        let passed = passed(case, n, (axis, state.pose(n).position[axis]), samples);
        let inside: Vec<RutSection> = sections
            .iter()
            .filter(|s| passed.is_some_and(|[low, high]| s.position >= low && s.position <= high))
            .copied()
            .collect();
        Rut { mean: RutSection::mean(&inside), sections }
    };
    (0..case.bodies.len()).map(of_body).collect()
}

/// The axis along which a body is towed, or next to which.
fn tow_axis(case: &Case, body: &Body) -> usize {
    usize::from(TowDirection::of(case, body).is_lateral())
}

/// What the body has left behind in the last part of the tow [m], in which averages are taken.
fn passed(case: &Case, n: usize, (axis, end): (usize, f64), samples: &[Vec<BodySample>]) -> Option<[f64; 2]> {
    let first = samples.get(n)?.first()?;
    let tow = TowDirection::of(case, &case.bodies[n]);
    let travelled = tow.in_space(DVec3::new(first.displacement, first.lateral_displacement, 0.0));
    let first = case.bodies[n].position[axis] + travelled[axis];
    let length = case.bodies[n].size()[axis];
    if (end - first).abs() <= length {
        return None;
    }
    // One length behind its middle the sides of the rut have come to rest.
    let along = (end - first).signum();
    let rear = end - length * along;
    let part = (case.output.steady_fraction * (rear - first).abs()).max(0.5 * length);
    let from = rear - part * along;
    Some([from.min(rear), from.max(rear)])
}

/// Sections across an axis over the columns in a band along the other, on both sides of a track [m].
fn sections(map: &HeightMap, axis: usize, (track, band): (f64, [f64; 2])) -> Vec<RutSection> {
    let across = &map.centres[1 - axis];
    let inside: Vec<usize> =
        (0..across.len()).filter(|m| across[*m] >= band[0] && across[*m] <= band[1]).collect();
    let positions = map.centres[axis].iter().enumerate();
    positions.map(|(n, position)| section(map, axis, (n, *position), (track, &inside))).collect()
}

/// The section over line `n` of columns across an axis.
fn section(
    map: &HeightMap,
    axis: usize,
    (n, position): (usize, f64),
    (track, inside): (f64, &[usize]),
) -> RutSection {
    let column = |m: usize| if axis == 0 { map.column(n, m) } else { map.column(m, n) };
    let (edges, across) = (&map.edges[1 - axis], &map.centres[1 - axis]);
    let before = |m: usize| if axis == 0 { map.column_before(n, m) } else { map.column_before(m, n) };
    let rise = |m: usize| column(m).z - before(m).z;
    let mut found = RutSection { position, ..RutSection::default() };
    let Some(deepest) = inside.iter().copied().min_by(|a, b| rise(*a).total_cmp(&rise(*b))) else {
        return found;
    };
    for m in inside.iter().copied() {
        let (width, rise, column) = (edges[m + 1] - edges[m], rise(m), column(m));
        found.area += width * (-rise).max(0.0);
        found.berm_area += width * rise.max(0.0);
        found.compaction += width * column.compaction;
        found.void += width * (column.void - before(m).void);
        found.disturbed += width * column.disturbed;
        found.mixed += width * column.mixed;
        if column.disturbed > 0.0 {
            found.disturbed_depth = found.disturbed_depth.max(before(m).z - column.disturbed_to);
        }
        let berm = if across[m] > track { &mut found.high_berm } else { &mut found.low_berm };
        *berm = berm.max(rise);
    }
    found.depth = (-rise(deepest)).max(0.0);
    if found.depth > 0.0 {
        let (first, last) = (inside[0], inside[inside.len() - 1]);
        let high = edge((deepest..=last).collect(), across, rise).unwrap_or(edges[last + 1]);
        let low = edge((first..=deepest).rev().collect(), across, rise).unwrap_or(edges[first]);
        found.width = high - low;
    }
    found
}

/// Where the surface rises to the undisturbed one on the way through some columns [m].
fn edge(way: Vec<usize>, across: &[f64], rise: impl Fn(usize) -> f64) -> Option<f64> {
    way.windows(2).find(|pair| rise(pair[1]) >= 0.0).map(|pair| {
        let [inner, outer] = [rise(pair[0]), rise(pair[1])];
        across[pair[0]] + (across[pair[1]] - across[pair[0]]) * inner / (inner - outer)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::history::GroundColumn;

    /// One line across x: a rut of triangular section, 0.2 m deep and 0.8 m wide at the surface, with a berm
    /// of 0.1 m at y > 0.
    fn map() -> HeightMap {
        let edges: Vec<f64> = (0..=400).map(|n| -2.0 + 0.01 * f64::from(n)).collect();
        let centres: Vec<f64> = edges.windows(2).map(|e| 0.5 * (e[0] + e[1])).collect();
        let height = |y: f64| match y.abs() {
            inside if inside < 0.4 => -0.2 * (1.0 - inside / 0.4),
            beside if beside < 0.6 && y > 0.0 => 0.1 * (1.0 - (beside - 0.5).abs() / 0.1),
            _ => 0.0,
        };
        let column = |y: &f64| GroundColumn {
            z: 1.0 + height(*y),
            disturbed: if y.abs() < 0.5 { 0.3 } else { 0.0 },
            disturbed_to: 0.6,
            compaction: 0.01,
            ..GroundColumn::default()
        };
        HeightMap {
            columns: centres.iter().map(column).collect(),
            undisturbed: Vec::new(),
            centres: [vec![0.5], centres],
            inside: [[0.0, 1.0], [-2.0, 2.0]],
            edges: [vec![0.0, 1.0], edges],
            reference: 1.0,
        }
    }

    #[test]
    fn a_section_has_the_depth_width_and_areas_of_the_rut() {
        let close = |a: f64, b: f64| assert!((a - b).abs() < 6e-3, "{a}, not {b}");
        let found = sections(&map(), 0, (0.0, [-1.0, 1.0]))[0];
        close(found.position, 0.5);
        close(found.depth, 0.2);
        close(found.width, 0.8);
        close(found.area, 0.08);
        close(found.high_berm, 0.1);
        close(found.low_berm, 0.0);
        close(found.berm_area, 0.01);
        close(found.disturbed, 0.3);
        close(found.disturbed_depth, 0.4);
        close(found.compaction, 0.02);
        // Half of it, where another body has the other half.
        let half = sections(&map(), 0, (0.0, [f64::NEG_INFINITY, 0.0]))[0];
        close(half.area, 0.04);
        close(half.width, 0.4);
        close(half.berm_area, 0.0);
    }

    #[test]
    fn the_mean_is_over_all_sections() {
        let one = sections(&map(), 0, (0.0, [-1.0, 1.0]))[0];
        assert_eq!(RutSection::mean(&[one, one]), Some(one));
        assert_eq!(RutSection::mean(&[]), None);
    }
}
