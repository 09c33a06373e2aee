//! Points that coincide become one.

use crate::Mesh;
use crate::hierarchy::bounds;
use glam::DVec3;
use std::collections::HashMap;

const NONE: u32 = u32::MAX;

/// The surface with points merged that are no more than a tolerance apart [m]: the first of them stays.
pub(super) fn welded(surface: &Mesh, tolerance: f64) -> Mesh {
    // What no triangle has may lie anywhere, too far off for the number of a cell.
    let surface = &without_spare_points(surface);
    let (low, _) = bounds(surface.points.iter().copied());
    // A point within the tolerance of another one lies in one of eight cells.
    let width = 2.0 * tolerance;
    let mut cells: HashMap<[i64; 3], u32> = HashMap::new();
    let mut points: Vec<DVec3> = Vec::new();
    // The point before each one in its cell.
    let mut before: Vec<u32> = Vec::new();
    let mut number = Vec::with_capacity(surface.points.len());
    for x in &surface.points {
        let find = |cell: [i64; 3], points: &[DVec3], before: &[u32]| {
            let mut at = cells.get(&cell).copied().unwrap_or(NONE);
            while at != NONE && points[at as usize].distance(*x) > tolerance {
                at = before[at as usize];
            }
            (at != NONE).then_some(at)
        };
        let place = (*x - low) / width;
        let (own, corner) = (cell_of(place), cell_of(place - DVec3::splat(0.5)));
        let around = (0..8).map(|n| [corner[0] + (n & 1), corner[1] + (n >> 1 & 1), corner[2] + (n >> 2)]);
        let found = std::iter::once(own).chain(around).find_map(|cell| find(cell, &points, &before));
        number.push(found.unwrap_or_else(|| {
            let new = points.len() as u32;
            points.push(*x);
            before.push(cells.insert(own, new).unwrap_or(NONE));
            new
        }));
    }
    let triangles = surface.triangles.iter().map(|t| t.map(|n| number[n as usize])).collect();
    Mesh { points, triangles }
}

fn cell_of(x: DVec3) -> [i64; 3] {
    x.floor().to_array().map(|n| n as i64)
}

/// The surface with only those points that a triangle has.
pub(super) fn without_spare_points(surface: &Mesh) -> Mesh {
    let mut number = vec![NONE; surface.points.len()];
    let mut points = Vec::new();
    let mut renumbered = |n: u32| {
        let new = &mut number[n as usize];
        if *new == NONE {
            *new = points.len() as u32;
            points.push(surface.points[n as usize]);
        }
        *new
    };
    let triangles = surface.triangles.iter().map(|t| t.map(&mut renumbered)).collect();
    Mesh { points, triangles }
}
