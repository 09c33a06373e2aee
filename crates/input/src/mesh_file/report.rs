//! What a surface was like.

use super::explain::place_in_file;
use super::surface::Surface;
use geometry::{Mend, MendKind, Repaired, Shape};
use glam::DVec3;
use serde::Serialize;

/// What the surface of a body is like, and what was repaired.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeshReport {
    /// Number of triangles.
    pub triangles: usize,
    /// Number of points.
    pub points: usize,
    /// Edges of the bounding box [m].
    pub size: DVec3,
    /// Volume [m³].
    pub volume: f64,
    /// Centroid in the body frame [m].
    pub centroid: DVec3,
    /// Closed surfaces of which the surface consists.
    pub shells: usize,
    /// Closed surfaces that bound cavities.
    pub cavities: usize,
    /// What was repaired, a sentence each.
    pub repairs: Vec<String>,
}

impl MeshReport {
    /// The report on what was found in a surface that was read in this unit [m].
    pub(super) fn of(found: &Repaired, surface: &Surface, unit: (&str, f64)) -> Self {
        let mut repairs = repairs(found);
        repairs.extend(found.mends.iter().map(|mend| mended(mend, surface, unit)));
        repairs.extend(surface.uneven.map(|(faces, off, first)| {
            format!(
                "{faces} faces are not plane, by up to {off:.3e} {}, and were divided into triangles, the first in {} {first}",
                unit.0, surface.counted
            )
        }));
        repairs.extend(surface.unit.as_ref().and_then(|stated| stated.remark(unit.0)));
        let solid = &found.solid;
        let ((low, high), mass) = (solid.bounds(), solid.mass_properties());
        let mesh = solid.surface();
        Self {
            triangles: mesh.triangles.len(),
            points: mesh.points.len(),
            size: high - low,
            volume: mass.volume,
            centroid: mass.centroid,
            shells: found.shells,
            cavities: found.cavities,
            repairs,
        }
    }
}

/// A repair in words.
fn mended(mend: &Mend, surface: &Surface, unit: (&str, f64)) -> String {
    let count = mend.triangles;
    let what = match mend.kind {
        MendKind::Doubled => format!("{count} triangles that were there twice were dropped"),
        MendKind::InnerWall => {
            format!("{count} triangles of an inner wall between two parts were removed: they are one")
        }
        MendKind::Flap => {
            format!("{count} triangles of a flap, which hung on the surface by an edge, were removed")
        }
        MendKind::Divided => {
            format!("{count} triangles were divided at corners of others in the middle of their edges")
        }
        MendKind::Seam => format!("a seam of {count} edges was closed"),
    };
    format!("{what}, at {}{}", place_in_file(mend.place, unit), surface.named(mend.place))
}

fn repairs(found: &Repaired) -> Vec<String> {
    let mut repairs = Vec::new();
    if let Some(distance) = found.merged_within {
        repairs.push(format!(
            "points up to {distance:.1e} m apart were merged, without which the surface has gaps"
        ));
    }
    if found.dropped > 0 {
        repairs.push(format!("{} triangles that join a point to itself were dropped", found.dropped));
    }
    if found.flattened > 0 {
        repairs
            .push(format!("{} triangles without height were made part of their neighbours", found.flattened));
    }
    if found.inverted {
        repairs.push("all triangles face inwards and were turned round".to_owned());
    } else if found.turned > 0 {
        repairs.push(format!("{} triangles face inwards and were turned round", found.turned));
    }
    if found.partly_searched {
        repairs
            .push("so many triangles lie close together that not all were searched for crossings".to_owned());
    }
    repairs
}
