//! What a surface was like.

use glam::DVec3;
use physics::shape::{Repaired, Shape};
use serde::Serialize;

/// What the surface of a body is like, and what was repaired.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeshReport {
    /// Number of triangles.
    pub triangles: usize,
    /// Number of points.
    pub points: usize,
    /// Edges of its bounding box [m].
    pub size: DVec3,
    /// Volume [m³].
    pub volume: f64,
    /// Centroid in the body frame [m].
    pub centroid: DVec3,
    /// Closed surfaces of which it consists.
    pub shells: usize,
    /// Those that bound cavities.
    pub cavities: usize,
    /// What was repaired, a sentence each.
    pub repairs: Vec<String>,
}

impl MeshReport {
    pub(super) fn of(found: &Repaired) -> Self {
        let solid = &found.solid;
        let ((low, high), mass) = (solid.bounds(), solid.mass_properties());
        let surface = solid.surface();
        Self {
            triangles: surface.triangles.len(),
            points: surface.points.len(),
            size: high - low,
            volume: mass.volume,
            centroid: mass.centroid,
            shells: found.shells,
            cavities: found.cavities,
            repairs: repairs(found),
        }
    }
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
