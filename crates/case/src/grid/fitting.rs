//! Grid lines on the flat faces of bodies, along the axes in which they do not move.
//!
//! Contact acts on whole cells, so that a body whose flat face lies within a cell is effectively too wide or
//! too narrow. Where the face does not move, the cell width along that axis can be adjusted so that the face
//! coincides with a cell face.

use super::grading::AxisGrading;
use crate::body::Body;
use crate::domain::Domain;
use glam::DVec3;
use mechanics::Motion;

/// Largest factor by which a cell may become wider or narrower.
const MAX_CHANGE: f64 = 1.25;
/// Fraction of a cell below which two positions coincide.
const COINCIDE: f64 = 1e-6;

/// Cell width along an axis and position of one cell face [m] such that cell faces lie on the `fixed`
/// position and on the flat faces of the bodies that do not move along the axis; `None` if there are no such
/// faces, if no cell width fits, or if unchanged cells counted from `usual` fit already.
pub(super) fn fit(
    bodies: &[Body],
    domain: &Domain,
    axis: usize,
    plain: &AxisGrading,
    fixed: Option<f64>,
) -> Option<[f64; 2]> {
    let AxisGrading { anchor: usual, cell, .. } = *plain;
    let inside =
        |x: &f64| *x > domain.low[axis] + COINCIDE * cell && *x < domain.high[axis] - COINCIDE * cell;
    let sides: Vec<f64> = bodies.iter().flat_map(|b| flat_faces(b, axis)).filter(inside).collect();
    let is_near_whole = |layers: f64| (layers - layers.round()).abs() < COINCIDE;
    if sides.iter().all(|x| is_near_whole((x - usual) / cell)) {
        return None;
    }
    let anchor = fixed.or(sides.first().copied())?;
    let distances: Vec<f64> =
        sides.iter().map(|x| (x - anchor).abs()).filter(|d| *d > COINCIDE * cell).collect();
    let shortest = distances.iter().copied().reduce(f64::min)?;
    let layers = shortest / cell;
    let candidates = [layers.floor(), layers.ceil()].into_iter().filter(|n| *n >= 1.0).map(|n| shortest / n);
    let is_whole = |width: f64| distances.iter().all(|d| is_near_whole(d / width));
    let change = |width: f64| (width / cell).ln().abs();
    let best = candidates.filter(|w| is_whole(*w)).min_by(|a, b| change(*a).total_cmp(&change(*b)))?;
    (change(best) <= MAX_CHANGE.ln() + COINCIDE).then_some([best, anchor])
}

/// Positions of the flat faces of a body and its parts across an axis [m], if they do not move.
fn flat_faces(body: &Body, axis: usize) -> Vec<f64> {
    let keeps_axle = body.attitude.axle_is_across() && !body.steers();
    // Rotation about the axle turns the other faces.
    let rolls = body.attitude.pitch != 0.0 || *body.spin() != Motion::Fixed;
    let stays = body.guided().translation[axis] == Motion::Fixed && keeps_axle && (axis == 1 || !rolls);
    if !stays {
        return Vec::new();
    }
    let own = (&body.shape, body.own_solid(), DVec3::ZERO);
    let aligned = body.parts.iter().filter(|part| part.is_aligned());
    let parts = aligned.map(|part| (&part.shape, part.solid(), part.offset));
    let flat = std::iter::once(own).chain(parts).filter(|(shape, ..)| shape.has_flat_sides(axis));
    let faces = flat.flat_map(|(_, solid, offset)| {
        let (low, high) = solid.bounds();
        [low, high].map(|side| body.position[axis] + offset[axis] + side[axis])
    });
    faces.collect()
}

#[cfg(test)]
mod tests {
    use crate::{Case, parse};

    fn case(thickness: &str, more: &str) -> Case {
        let text = format!(
            "format = 2\ngravity = \"9.81 m/s^2\"\n[soil]\nlaw = \"tresca\"\nshear_strength = \"1 kPa\"\nunit_weight = \"16 kN/m^3\"\n\
             young_modulus = \"1 MPa\"\n[domain]\nx = [\"-0.5 m\", \"0.5 m\"]\ny = [\"0 m\", \"0.3 m\"]\n\
             z = [\"-0.3 m\", \"0.1 m\"]\nsymmetric = true\n[grid]\ncell = \"10 mm\"\n{more}\n[body.disc]\nshape = \"disc\"\n\
             diameter = \"0.2 m\"\nthickness = \"{thickness}\"\nfriction = 0.3\nweight = \"40 N\"\n[run]\nduration = \"0.1 s\"\n"
        );
        parse(&text, "case.toml", &[]).unwrap()
    }

    fn narrowest(case: &Case, axis: usize) -> f64 {
        case.grid.faces[axis].windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn a_face_that_does_not_move_lies_between_cells() {
        let fitted = case("50 mm", "");
        assert!(fitted.grid.faces[1].iter().any(|y| (y - 0.025).abs() < 1e-12), "{:?}", fitted.grid.faces[1]);
        assert!((narrowest(&fitted, 1) - 0.025 / 3.0).abs() < 1e-9);
        assert!(
            (narrowest(&fitted, 0) - 0.01).abs() < 1e-9,
            "the disc moves up and down, and is round along x"
        );
    }

    #[test]
    fn cells_that_fit_or_cannot_fit_are_unchanged() {
        assert!((narrowest(&case("60 mm", ""), 1) - 0.01).abs() < 1e-9);
        assert!((narrowest(&case("50 mm", "fit = false"), 1) - 0.01).abs() < 1e-9);
    }
}
