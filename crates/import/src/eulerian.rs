//! The Eulerian mesh: a box of bricks along the axes, with the planes between them.

use crate::notes::Notes;
use deck::model::Id;
use std::collections::{HashMap, HashSet};

/// A rectilinear mesh, in axes and units of the deck.
pub(super) struct Eulerian {
    /// Region of its nodes.
    pub(super) region: usize,
    /// Planes along each axis, increasing.
    pub(super) faces: [Vec<f64>; 3],
    /// Where each element lies.
    pub(super) cells: HashMap<Id, [usize; 3]>,
    /// Its nodes.
    pub(super) nodes: HashSet<Id>,
    /// Block of its section.
    pub(super) section: usize,
    /// Its materials: name of the instance of the material, name of the material.
    pub(super) materials: Vec<[String; 2]>,
}

/// Most materials of a section.
const MOST_MATERIALS: usize = 16;

/// The mesh of the only Eulerian section.
pub(super) fn mesh(notes: &mut Notes) -> Option<Eulerian> {
    let deck = notes.deck;
    let all = deck.regions.iter().enumerate();
    let sections = all.flat_map(|(n, region)| region.sections.iter().map(move |section| (n, section)));
    let mut sections = sections.filter(|(_, s)| deck.blocks[s.block].keyword == "EULERIAN SECTION");
    let Some((region, section)) = sections.next() else {
        notes.lacks("There is no *Eulerian Section: no soil to be modelled by the Eulerian method.");
        return None;
    };
    if let Some((_, second)) = sections.next() {
        notes.refused(second.block, "a case has one box of cells, and this is a second Eulerian section");
    }
    let Some(ids) = deck.elements(region, &section.elements) else {
        notes.refused(section.block, format!("there is no element set {}", section.elements));
        return None;
    };
    let materials: Vec<[String; 2]> =
        section.rows.iter().map(|row| [row.field(1), row.field(0)].map(str::to_uppercase)).collect();
    let materials: Vec<_> = materials
        .into_iter()
        .map(|[name, of]| [if name.is_empty() { of.clone() } else { name }, of])
        .collect();
    if materials.is_empty() || materials.len() > MOST_MATERIALS {
        notes.refused(section.block, format!("one to {MOST_MATERIALS} materials were expected"));
        return None;
    }
    match rectilinear(notes, &ids) {
        Ok((faces, cells)) => {
            let count: Vec<String> = faces.iter().map(|planes| (planes.len() - 1).to_string()).collect();
            notes.understood(section.block, format!("the box of cells, {} in the deck", count.join(" × ")));
            let elements = ids.iter().filter_map(|id| deck.element(*id));
            let nodes = elements.flat_map(|element| element.nodes.iter().copied()).collect();
            let region = ids.first().map_or(region, |id| id.region);
            Some(Eulerian { region, nodes, faces, cells, section: section.block, materials })
        }
        Err(message) => {
            notes.refused(section.block, message);
            None
        }
    }
}

type Planes = ([Vec<f64>; 3], HashMap<Id, [usize; 3]>);

/// Planes and cells of elements that are all boxes of one grid.
fn rectilinear(notes: &Notes, ids: &[Id]) -> Result<Planes, String> {
    let mut corners: Vec<(Id, [[f64; 2]; 3])> = Vec::with_capacity(ids.len());
    for id in ids {
        let element = notes.deck.element(*id).ok_or_else(|| format!("there is no element {}", id.label))?;
        if !element.kind.starts_with("EC3D8") {
            return Err(format!("element {} is a {}, not an EC3D8R", id.label, element.kind));
        }
        corners.push((*id, bounds(notes, id.label, &element.nodes)?));
    }
    let faces = [0, 1, 2].map(|axis| planes(&corners, axis));
    let mut cells = HashMap::with_capacity(corners.len());
    for (id, bounds) in &corners {
        let mut at = [0; 3];
        for axis in 0..3 {
            let low = near(&faces[axis], bounds[axis][0]);
            if near(&faces[axis], bounds[axis][1]) != low + 1 {
                return Err(format!(
                    "element {} spans several of the planes of others: a grid of planes was expected",
                    id.label
                ));
            }
            at[axis] = low;
        }
        cells.insert(*id, at);
    }
    let [x, y, z] = faces.each_ref().map(|planes| planes.len().saturating_sub(1));
    if x * y * z == 0 || cells.len() != x * y * z {
        return Err(format!(
            "{} elements do not fill a box of {x} × {y} × {z} cells: a rectilinear mesh was expected",
            cells.len()
        ));
    }
    Ok((faces, cells))
}

/// Low and high of an element along each axis; refuses what is no box.
fn bounds(notes: &Notes, label: u32, nodes: &[Id]) -> Result<[[f64; 2]; 3], String> {
    let points: Option<Vec<[f64; 3]>> = nodes.iter().map(|id| notes.deck.node(*id)).collect();
    let points = points.ok_or_else(|| format!("element {label} has a node that is not there"))?;
    let bounds = [0, 1, 2].map(|axis| {
        let along = points.iter().map(|point| point[axis]);
        [along.clone().fold(f64::INFINITY, f64::min), along.fold(f64::NEG_INFINITY, f64::max)]
    });
    let size = bounds.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
    let is_corner = |point: &[f64; 3]| {
        (0..3).all(|axis| bounds[axis].iter().any(|side| (point[axis] - side).abs() <= 1e-4 * size))
    };
    let is_flat = bounds.iter().any(|[low, high]| high - low <= 1e-6 * size);
    if is_flat || !points.iter().all(is_corner) {
        return Err(format!(
            "element {label} is no box along the axes: the Eulerian mesh must be rectilinear"
        ));
    }
    Ok(bounds)
}

/// The planes along an axis, those within a hundredth of the smallest cell taken as one.
fn planes(corners: &[(Id, [[f64; 2]; 3])], axis: usize) -> Vec<f64> {
    let smallest = corners.iter().map(|(_, b)| b[axis][1] - b[axis][0]).fold(f64::INFINITY, f64::min);
    let mut all: Vec<f64> = corners.iter().flat_map(|(_, b)| b[axis]).collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|next, before| *next - *before < 0.01 * smallest);
    all
}

/// The plane nearest to a coordinate.
pub(super) fn near(planes: &[f64], at: f64) -> usize {
    let next = planes.partition_point(|plane| *plane < at).min(planes.len().saturating_sub(1));
    let before = next.saturating_sub(1);
    if (planes[before] - at).abs() < (planes[next] - at).abs() { before } else { next }
}
