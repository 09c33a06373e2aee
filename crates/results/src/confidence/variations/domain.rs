//! A variation of the case in a larger domain.

use super::change::{Change, Original};
use case::path::Paths;
use case::resolved::{Case, Ground};

/// How much farther from the bodies the domain ends (chosen: an effect that falls with the first power of the
/// distance falls by a third, and a graded grid needs a few more cells only).
pub const FARTHER: f64 = 1.5;
/// Least rise of the lid over the depth of the soil (chosen: a heap that touches a low lid gets space
/// enough).
const LID: f64 = 0.25;
/// Distance from a face of the domain at which a body counts as touching it, in cells.
const TOUCHING: f64 = 0.5;

/// Why a face of the domain stays where it is, if it does.
type Stays = Option<&'static str>;

const SYMMETRY: Stays = Some("plane of symmetry");
const TOUCHED: Stays = Some("a body reaches it");

/// The domain, [`FARTHER`] times as far from the bodies; faces that are a part of the problem stay.
pub(super) fn larger_domain(original: Original) -> Result<Change, String> {
    let case = original.case;
    let names = [["low x", "high x"], ["low y", "high y"], ["floor", "lid"]];
    let (mut overrides, mut moved, mut kept) = (Vec::new(), Vec::new(), Vec::new());
    for (axis, key) in ["x", "y", "z"].into_iter().enumerate() {
        if axis == 1 && case.domain.plane_strain {
            continue;
        }
        let mut ends = [case.domain.low[axis], case.domain.high[axis]];
        for side in 0..2 {
            match stays(case, axis, side) {
                Some(why) => kept.push(format!("{} ({why})", names[axis][side])),
                None => {
                    ends[side] += extension(case, axis, side);
                    moved.push(names[axis][side]);
                }
            }
        }
        overrides.push(format!("domain.{key}=[\"{} m\", \"{} m\"]", ends[0], ends[1]));
        overrides.extend(longer_ground(case, axis, ends));
    }
    if moved.is_empty() {
        return Err(format!("every face of the domain is a part of the problem: {}", kept.join(", ")));
    }
    let stays = if kept.is_empty() { String::new() } else { format!("; stays: {}", kept.join(", ")) };
    let what = format!("domain {FARTHER} times as far from the bodies: {}{stays}", moved.join(", "));
    Ok(Change { overrides, what, time_factor: 1.0 })
}

/// Why a face stays where it is.
fn stays(case: &Case, axis: usize, side: usize) -> Stays {
    let domain = &case.domain;
    let is_plane = [domain.symmetric_x, domain.symmetric];
    if side == 0 && is_plane.get(axis) == Some(&true) {
        return SYMMETRY;
    }
    let surface = case.ground.surface();
    if (axis, side) == (2, 1) {
        let is_covered = case.overburden != 0.0 || surface >= domain.high.z - TOUCHING * case.grid.cell;
        return is_covered.then_some("it covers the soil");
    }
    if (axis, side) == (2, 0) && matches!(case.ground, Ground::Column { .. }) {
        return Some("the soil is heaped on it");
    }
    let touches = Paths::of(case).all().is_some_and(|path| {
        let reach = TOUCHING * case.grid.fine_cell()[axis];
        let gap =
            if side == 0 { path.low[axis] - domain.low[axis] } else { domain.high[axis] - path.high[axis] };
        gap <= reach
    });
    if touches { TOUCHED } else { None }
}

/// How far a face moves [m], a whole number of cells: what is filled by them stays so.
fn extension(case: &Case, axis: usize, side: usize) -> f64 {
    let (domain, cell) = (&case.domain, case.grid.fine_cell()[axis]);
    let path = Paths::of(case).all();
    let distance = if (axis, side) == (2, 1) {
        let surface = case.ground.surface();
        (domain.high.z - surface).max(LID / (FARTHER - 1.0) * (surface - domain.low.z))
    } else {
        path.map_or(0.0, |path| {
            if side == 0 { path.low[axis] - domain.low[axis] } else { domain.high[axis] - path.high[axis] }
        })
    };
    let farther = ((FARTHER - 1.0) * distance / cell).ceil().max(1.0) * cell;
    if side == 0 { -farther } else { farther }
}

/// The ground along x or y, of soil that ends with the domain: it goes on to its new ends.
fn longer_ground(case: &Case, axis: usize, ends: [f64; 2]) -> Option<String> {
    let Ground::Column { low, high, radius: None } = case.ground else { return None };
    let (domain, reach) = (&case.domain, TOUCHING * case.grid.fine_cell()[axis]);
    let key = ["x", "y"].get(axis)?;
    let from = if low[axis] <= domain.low[axis] + reach { ends[0] } else { low[axis] };
    let to = if high[axis] >= domain.high[axis] - reach { ends[1] } else { high[axis] };
    Some(format!("ground.{key}=[\"{from} m\", \"{to} m\"]"))
}
