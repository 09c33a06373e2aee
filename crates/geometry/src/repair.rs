//! From the triangles of a file to a closed surface that is oriented everywhere, or why there is none.
//!
//! Points that coincide become one; triangles that join a point to itself are dropped; slivers without height
//! are turned into parts of their neighbours; and what is oriented against the rest is turned round. Edges
//! without two triangles are mended where one answer is safe (`mend`). A surface that cannot be, or that goes
//! through itself, is refused with a place.

mod crossing;
mod defect;
mod mend;
mod shells;
mod slivers;
mod weld;

pub use defect::Defect;
pub use mend::{Mend, MendKind};

use super::edges::{by_edge, sides};
use super::hierarchy::bounds;
use super::{MassProperties, Mesh, Polyhedron};
use glam::DVec3;

/// Distances below which points are the same, over the size of the body: rounding, and that of the single
/// precision of STL.
const SAME: [f64; 2] = [1e-9, 1e-6];
/// Depth over the size of the body up to which parts may touch or overlap: what the single precision of STL
/// leaves open.
const TOUCHING: f64 = 1e-6;
/// Volume over that of the bounding box below which a surface encloses no volume.
const NO_VOLUME: f64 = 1e-9;

/// A solid, and what was repaired of its surface.
#[derive(Clone, Debug)]
pub struct Repaired {
    /// The solid.
    pub solid: Polyhedron,
    /// Closed surfaces of which the solid consists, those of cavities included.
    pub shells: usize,
    /// Closed surfaces that bound cavities.
    pub cavities: usize,
    /// Triangles that joined a point to itself and were dropped.
    pub dropped: usize,
    /// Triangles without height that became part of their neighbours.
    pub flattened: usize,
    /// Triangles that were turned round.
    pub turned: usize,
    /// Whether all triangles were turned round.
    pub inverted: bool,
    /// Distance up to which points were merged [m], where that is more than rounding.
    pub merged_within: Option<f64>,
    /// What else was repaired so that every edge has two triangles.
    pub mends: Vec<Mend>,
    /// Whether there were so many triangles close together that not all pairs were searched for crossings.
    pub partly_searched: bool,
}

/// The solid that triangles bound, whose points need not be shared.
///
/// # Errors
/// [`Defect`] says why they bound none.
pub fn repaired(surface: &Mesh) -> Result<Repaired, Defect> {
    let (low, high) = check(surface)?;
    let size = (high - low).max_element();
    let Connected { mut surface, dropped, flattened, merged_within, mends } = closed(surface, size)?;
    let oriented = match shells::orient(&mut surface, size) {
        // A part that crosses another one lies partly inside it.
        Err(nested @ Defect::Nested { .. }) => {
            let solid = Polyhedron::new(surface);
            crossing::pierces(&solid, TOUCHING * size).map_err(|crossing| shells::named(&solid, crossing))?;
            return Err(nested);
        }
        other => other?,
    };
    let volume = MassProperties::of_mesh(&surface).volume;
    if volume.is_nan() || volume <= NO_VOLUME * (high - low).element_product() {
        return Err(Defect::NoVolume);
    }
    let solid = Polyhedron::new(surface);
    let is_searched =
        crossing::search(&solid, TOUCHING * size).map_err(|crossing| shells::named(&solid, crossing))?;
    Ok(Repaired {
        solid,
        shells: oriented.shells,
        cavities: oriented.cavities,
        dropped,
        flattened,
        turned: oriented.turned,
        inverted: oriented.inverted,
        merged_within,
        mends,
        partly_searched: !is_searched,
    })
}

/// The bounding box of points and triangles that make sense.
fn check(surface: &Mesh) -> Result<(DVec3, DVec3), Defect> {
    if let Some(point) = surface.points.iter().position(|x| !x.is_finite()) {
        return Err(Defect::NotFinite { point });
    }
    let exists = |n: &u32| (*n as usize) < surface.points.len();
    if let Some(triangle) = surface.triangles.iter().position(|t| !t.iter().all(exists)) {
        return Err(Defect::NoSuchPoint { triangle });
    }
    let used = surface.triangles.iter().flatten().map(|n| surface.points[*n as usize]);
    let (low, high) = bounds(used);
    let extent = (high - low).max_element();
    if extent > 0.0 && extent.is_finite() { Ok((low, high)) } else { Err(Defect::Empty) }
}

/// The surface with as few points merged as make it closed; mended where none do.
fn closed(surface: &Mesh, size: f64) -> Result<Connected, Defect> {
    // Where every triangle has points of its own, no edge has two triangles.
    let is_soup = surface.points.len() == 3 * surface.triangles.len();
    if !is_soup && let Ok(closed) = connected(surface, 0.0, size) {
        return Ok(closed);
    }
    connected(surface, SAME[0] * size, size).or_else(|defect| {
        let distance = SAME[1] * size;
        if let Ok(closed) = connected(surface, distance, size) {
            return Ok(Connected { merged_within: Some(distance), ..closed });
        }
        // What is wrong is said of the surface as it is.
        let (whole, mends, merged_within) = mend::mended(surface, [size, distance], defect)?;
        Ok(Connected { mends, merged_within, ..connected(&whole, 0.0, size)? })
    })
}

/// A surface with two triangles at every edge.
struct Connected {
    surface: Mesh,
    dropped: usize,
    flattened: usize,
    /// Distance up to which points were merged [m], where that is more than rounding.
    merged_within: Option<f64>,
    mends: Vec<Mend>,
}

/// The surface with points merged that are no more than a tolerance apart [m]; with 0 none are.
fn connected(surface: &Mesh, tolerance: f64, size: f64) -> Result<Connected, Defect> {
    let welded = if tolerance > 0.0 { weld::welded(surface, tolerance) } else { surface.clone() };
    let Mesh { points, mut triangles } = welded;
    let before = triangles.len();
    triangles.retain(|[a, b, c]| a != b && b != c && c != a);
    let dropped = before - triangles.len();
    if triangles.is_empty() {
        return Err(Defect::Empty);
    }
    let mut surface = weld::without_spare_points(&Mesh { points, triangles });
    require_closed(&surface)?;
    let flattened = slivers::flatten(&mut surface, SAME[1] * size);
    Ok(Connected { surface, dropped, flattened, merged_within: None, mends: Vec::new() })
}

/// Whether every edge has two triangles.
fn require_closed(surface: &Mesh) -> Result<(), Defect> {
    let (mut open, mut branching) = ((0, None), (0, None));
    let sides = sides(&surface.triangles);
    for edge in by_edge(&sides).filter(|edge| edge.len() != 2) {
        let (count, first) = if edge.len() == 1 { &mut open } else { &mut branching };
        *count += 1;
        first.get_or_insert(edge);
    }
    let middle = |edge: &[super::edges::Side]| {
        0.5 * (surface.points[edge[0].low as usize] + surface.points[edge[0].high as usize])
    };
    match (open, branching) {
        ((edges, Some(edge)), _) => Err(Defect::Open { edges, place: middle(edge) }),
        (_, (edges, Some(edge))) => {
            Err(Defect::NotManifold { edges, triangles: edge.len(), place: middle(edge) })
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests;
