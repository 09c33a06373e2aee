//! The bodies of a case as the closed-form models represent them.

use crate::case::resolved::{Body as Towed, Case, Motion};
use crate::case::shapes::ClosedForm;
use analytic::disc::{Assembly, Disc};
use analytic::forecast::{Block, Body, FacetedBody};
use analytic::resistive::Facet;
use glam::DVec3;
use physics::shape::SurfacePoint;
use std::f64::consts::PI;

/// Points across the diameter of a body that is represented by points on its surface.
const POINTS_ACROSS: f64 = 40.0;
/// Upper limit of diameter times length over the spacing squared.
const MAX_POINTS: f64 = 2000.0;

/// The bodies of the case: one, or several equal discs side by side, which form an assembly on one axle.
///
/// # Errors
/// If there are several that are not equal discs, evenly spaced side by side.
pub(super) fn bodies<'a>(
    case: &'a Case,
    remarks: &mut Vec<String>,
) -> Result<(Vec<&'a Towed>, Option<Assembly>), String> {
    let mut discs: Vec<&Towed> = case.bodies.iter().collect();
    if discs.len() > 1
        && let Some(other) = discs.iter().find(|b| disc(b).is_none())
    {
        return Err(format!(
            "`{}` is not the only body; the closed forms are for one body, or for equal discs",
            other.name
        ));
    }
    discs.sort_by(|a, b| a.position.y.total_cmp(&b.position.y));
    let Some([first, second]) = discs.first_chunk::<2>().copied() else { return Ok((discs, None)) };
    let spacing = second.position.y - first.position.y;
    let is_equal = |b: &&Towed| {
        b.shape == first.shape
            && b.friction == first.friction
            && b.translation == first.translation
            && b.spin == first.spin
            && (b.position.x - first.position.x).abs() < 1e-9
            && (b.position.z - first.position.z).abs() < 1e-9
    };
    let even = discs.windows(2).all(|pair| {
        let gap = pair[1].position.y - pair[0].position.y;
        (gap - spacing).abs() < 1e-6 * spacing
    });
    if !(discs.iter().all(is_equal) && even && spacing > 0.0) {
        return Err(format!(
            "the case has {} discs that are not equal or not evenly spaced side by side; the closed forms are for one \
             disc, or for a row of equal ones",
            discs.len()
        ));
    }
    let count = discs.len();
    remarks.push(format!(
        "{count} equal discs at a spacing of {:.4} m: treated as one assembly; drag, vertical force and weight are those \
         of all discs",
        spacing
    ));
    let assembly = Assembly { count: u32::try_from(count).unwrap_or(u32::MAX), spacing };
    Ok((discs, Some(assembly)))
}

/// A disc, or a cylinder across the tow, which is geometrically a disc.
fn disc(body: &Towed) -> Option<Disc> {
    match body.shape.closed_form() {
        ClosedForm::Disc { diameter, thickness } => Some(Disc { diameter, thickness }),
        ClosedForm::Block { .. } | ClosedForm::Facets { .. } => None,
    }
}

/// The body as the models represent it, its kind in one word, and whether it is towed backwards, so that the models are
/// given its mirror image.
///
/// # Errors
/// If it is a disc in plane strain, or anything else that is not towed.
pub(super) fn body(
    case: &Case,
    body: &Towed,
    remarks: &mut Vec<String>,
) -> Result<(Body, &'static str, bool), String> {
    let kind = body.shape.kind();
    if let Some(disc) = disc(body) {
        if case.domain.plane_strain {
            return Err(format!("the case is plane strain; the models are for a {kind} of finite width"));
        }
        return Ok((disc.into(), kind, false));
    }
    let is_mirrored = match body.translation[0] {
        Motion::Prescribed { speed, .. } if speed != 0.0 => speed < 0.0,
        Motion::Free { load, .. } => load < 0.0,
        _ => {
            return Err(format!(
                "`{}` is not towed; a body that is pressed straight down is a footing, which has no forecast",
                body.name
            ));
        }
    };
    let represented = match body.shape.closed_form() {
        ClosedForm::Block { size, orientation } => {
            let orientation = if is_mirrored { -orientation } else { orientation };
            block(case, size, orientation, remarks).into()
        }
        ClosedForm::Facets { length, width } | ClosedForm::Disc { diameter: length, thickness: width } => {
            Body::Faceted(faceted(body, length, width))
        }
    };
    Ok((represented, kind, is_mirrored))
}

/// A block rotated by `orientation` [rad]; in plane strain as wide as the slab.
fn block(case: &Case, size: DVec3, orientation: f64, remarks: &mut Vec<String>) -> Block {
    let plane_strain = case.domain.plane_strain;
    let across = if plane_strain { case.domain.high.y - case.domain.low.y } else { size.y };
    if plane_strain {
        remarks.push(format!("plane strain: the forces are those on a slab {across:.4} m wide"));
    }
    let orientation = (orientation + PI).rem_euclid(2.0 * PI) - PI;
    Block { size: [size.x, across, size.z], orientation, plane_strain, has_base: true }
}

/// A body represented by points on its surface.
fn faceted(body: &Towed, diameter: f64, length: f64) -> FacetedBody {
    let solid = body.shape.solid();
    let (low, high) = solid.bounds();
    // Some thousand points at most, even for a slender body.
    let spacing = (diameter / POINTS_ACROSS).max((diameter * length / MAX_POINTS).sqrt());
    let facet = |p: SurfacePoint| Facet {
        centroid: p.position.to_array(),
        normal: p.normal.to_array(),
        area: p.area,
        half_height: 0.5 * (p.area * (1.0 - p.normal.z.powi(2)).max(0.0)).sqrt(),
    };
    let facets = solid.surface_points(DVec3::splat(spacing), DVec3::ZERO).into_iter().map(facet).collect();
    FacetedBody { length: diameter, width: diameter, height: high.z - low.z, facets }
}
