//! Where there is soil: volume fractions as level ground in layers.

use crate::eulerian::{Eulerian, near};
use crate::frame::Frame;
use crate::notes::Notes;
use deck::block::{Row, Wrong};

/// The ground of a deck, in axes of the case and units of the deck.
pub(super) struct Ground {
    /// Height of the surface.
    pub(super) surface: f64,
    /// Where there is soil along x and y; `None`: everywhere.
    pub(super) extent: [Option<[f64; 2]>; 2],
    /// Material and top of each layer, from above.
    pub(super) layers: Vec<(usize, f64)>,
    /// Block that says so.
    pub(super) block: usize,
    /// Material with most of the volume of each cell, by number + 1; 0 for none.
    pub(super) main: Vec<u8>,
}

/// Planes in axes of the case, and the numbering of its cells.
pub(super) struct Box3 {
    /// Planes along each axis.
    pub(super) faces: [Vec<f64>; 3],
    frame: Frame,
}

impl Box3 {
    /// The mesh in axes of the case.
    pub(super) fn new(mesh: &Eulerian, frame: &Frame) -> Self {
        let faces = [0, 1, 2].map(|n| {
            let (axis, same) = frame.axes[n];
            let mut planes: Vec<f64> =
                mesh.faces[axis].iter().map(|x| if same { *x } else { -*x } - frame.origin[n]).collect();
            planes.sort_by(f64::total_cmp);
            planes
        });
        Self { faces, frame: *frame }
    }

    /// Numbers of cells.
    pub(super) fn counts(&self) -> [usize; 3] {
        self.faces.each_ref().map(|planes| planes.len() - 1)
    }

    /// Number of a cell of the deck.
    pub(super) fn cell(&self, at: [usize; 3]) -> usize {
        let count = self.counts();
        let [i, j, k] = [0, 1, 2].map(|n| {
            let (axis, same) = self.frame.axes[n];
            if same { at[axis] } else { count[n] - 1 - at[axis] }
        });
        self.number([i, j, k])
    }

    fn number(&self, [i, j, k]: [usize; 3]) -> usize {
        let [_, ny, nz] = self.counts();
        (i * ny + j) * nz + k
    }

    fn height(&self, k: usize) -> f64 {
        self.faces[2][k + 1] - self.faces[2][k]
    }
}

/// Most cells times materials.
const MOST: usize = 100_000_000;
/// A share of a cell that counts as none.
const NONE: f32 = 1e-3;

/// The material that a name of the initial conditions means: `INSTANCE.NAME`, or the name itself.
pub(super) fn material(mesh: &Eulerian, name: &str) -> Option<usize> {
    let name = name.to_uppercase();
    let own = |material: &[String; 2]| {
        name == material[0]
            || name.ends_with(&format!(".{}", material[0]))
            || name.ends_with(&format!("_{}", material[0]))
    };
    mesh.materials.iter().position(own)
}

/// The ground; `skipped` says over which x and y a body may have displaced soil.
pub(super) fn ground(
    notes: &mut Notes,
    mesh: &Eulerian,
    at: &Box3,
    skipped: &[[[f64; 2]; 3]],
) -> Option<Ground> {
    let deck = notes.deck;
    let cells = mesh.cells.len();
    if cells.saturating_mul(mesh.materials.len()) > MOST {
        notes.lacks(format!("More than {MOST} cells times materials."));
        return None;
    }
    let mut shares = vec![vec![0.0_f32; cells]; mesh.materials.len()];
    let mut block = None;
    for (number, _) in deck.initial.iter().filter(|(_, kind)| kind == "VOLUME FRACTION") {
        block.get_or_insert(*number);
        let mut is_sound = true;
        for row in &deck.blocks[*number].rows {
            if let Err(wrong) = take(notes, mesh, at, row, &mut shares) {
                notes.refused(*number, wrong);
                is_sound = false;
            }
        }
        if is_sound {
            notes.understood(*number, "where there is soil at the start");
        }
    }
    let Some(block) = block else {
        notes.lacks("There is no *Initial Conditions, type=volume fraction: no cell holds soil.");
        return None;
    };
    match level(at, &shares, skipped) {
        Ok((mut ground, is_displaced)) => {
            ground.block = block;
            if is_displaced {
                let text = "cells around a body that are not as those beside it: the case removes the soil that bodies displace";
                notes.approximated(block, text);
            }
            Some(ground)
        }
        Err(message) => {
            notes.refused(block, message);
            None
        }
    }
}

fn take(notes: &Notes, mesh: &Eulerian, at: &Box3, row: &Row, shares: &mut [Vec<f32>]) -> Result<(), Wrong> {
    let missing = |what: &str, name: &str| Wrong::at(row.place, format!("there is no {what} {name:?}"));
    let ids = notes.deck.elements(0, row.field(0)).or_else(|| notes.deck.elements(mesh.region, row.field(0)));
    let ids = ids.ok_or_else(|| missing("element set", row.field(0)))?;
    let material =
        material(mesh, row.field(1)).ok_or_else(|| missing("material in the section", row.field(1)))?;
    let share = row.number(2)?.unwrap_or(0.0);
    if !(0.0..=1.0).contains(&share) {
        return Err(Wrong::at(row.place, "a volume fraction from 0 to 1 was expected"));
    }
    for id in ids {
        let cell = mesh.cells.get(&id).ok_or_else(|| missing("Eulerian element", &id.label.to_string()))?;
        shares[material][at.cell(*cell)] = share as f32;
    }
    Ok(())
}

/// A column of cells: its layers from below, material and thickness.
type Column = Vec<(usize, f64)>;

/// The layers of a column; `None` where soil lies over void.
fn column(at: &Box3, shares: &[Vec<f32>], [i, j]: [usize; 2]) -> Option<Column> {
    let mut layers: Column = Vec::new();
    let mut is_full = true;
    for k in 0..at.counts()[2] {
        let cell = at.number([i, j, k]);
        let total: f32 = shares.iter().map(|share| share[cell]).sum();
        if total > NONE && !is_full || total > 1.0 + NONE {
            return None;
        }
        is_full = total > 1.0 - NONE;
        let lowest = layers.last().map(|(material, _)| *material);
        // Of a cell with two materials the one that goes on lies below.
        let order = lowest.into_iter().chain((0..shares.len()).filter(|m| Some(*m) != lowest));
        for material in order {
            let share = shares[material][cell];
            if share <= NONE {
                continue;
            }
            let thickness = f64::from(share) * at.height(k);
            match layers.last_mut() {
                Some((last, sum)) if *last == material => *sum += thickness,
                _ => layers.push((material, thickness)),
            }
        }
    }
    Some(layers)
}

fn same(a: &Column, b: &Column, smallest: f64) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.0 == b.0 && (a.1 - b.1).abs() < 0.01 * smallest)
}

/// Level ground, or why it is none; and whether there is other soil about bodies.
fn level(at: &Box3, shares: &[Vec<f32>], skipped: &[[[f64; 2]; 3]]) -> Result<(Ground, bool), String> {
    let [nx, ny, nz] = at.counts();
    let smallest = (0..nz).map(|k| at.height(k)).fold(f64::INFINITY, f64::min);
    let overlaps = |axis: usize, n: usize, body: &[[f64; 2]; 3]| {
        let reach = at.faces[axis][n + 1] - at.faces[axis][n];
        at.faces[axis][n] - reach < body[axis][1] && at.faces[axis][n + 1] + reach > body[axis][0]
    };
    let is_skipped =
        |i: usize, j: usize| skipped.iter().any(|body| overlaps(0, i, body) && overlaps(1, j, body));
    let mut usual: Option<Column> = None;
    let mut extent = [[nx, 0], [ny, 0]];
    let (mut filled, mut is_displaced, mut hidden) = (0_usize, false, Vec::new());
    for i in 0..nx {
        for j in 0..ny {
            let own = column(at, shares, [i, j]);
            if is_skipped(i, j) {
                if own.as_ref().is_none_or(|own| !own.is_empty()) {
                    extent[0] = [extent[0][0].min(i), extent[0][1].max(i + 1)];
                    extent[1] = [extent[1][0].min(j), extent[1][1].max(j + 1)];
                }
                hidden.push(own);
                continue;
            }
            let [x, y] = [at.faces[0][i], at.faces[1][j]];
            let own = own.ok_or_else(|| format!("at ({x}, {y}) soil lies over void"))?;
            if own.is_empty() {
                continue;
            }
            if !same(usual.get_or_insert_with(|| own.clone()), &own, smallest) {
                return Err(format!(
                    "at ({x}, {y}) surface or layers are at other depths than elsewhere: level ground was expected (a case can have ground.height_map and soil bodies)"
                ));
            }
            filled += 1;
            extent[0] = [extent[0][0].min(i), extent[0][1].max(i + 1)];
            extent[1] = [extent[1][0].min(j), extent[1][1].max(j + 1)];
        }
    }
    let usual = match usual {
        Some(usual) => usual,
        // A body over all of the ground: what lies below it counts.
        None => hidden.iter().flatten().find(|own| !own.is_empty()).cloned().ok_or("no cell holds soil")?,
    };
    if filled == 0 {
        extent = [[0, nx], [0, ny]];
    }
    is_displaced |= hidden
        .iter()
        .any(|own| own.as_ref().is_none_or(|own| !own.is_empty() && !same(own, &usual, smallest)));
    let inside = |i: usize, j: usize| {
        (extent[0][0]..extent[0][1]).contains(&i) && (extent[1][0]..extent[1][1]).contains(&j)
    };
    let expected = (0..nx)
        .flat_map(|i| (0..ny).map(move |j| (i, j)))
        .filter(|(i, j)| inside(*i, *j) && !is_skipped(*i, *j));
    if expected.count() != filled {
        return Err("the soil seen from above is no rectangle".to_owned());
    }
    Ok((made(at, shares, usual, extent), is_displaced))
}

fn made(at: &Box3, shares: &[Vec<f32>], usual: Column, extent: [[usize; 2]; 2]) -> Ground {
    let counts = at.counts();
    let mut layers: Vec<(usize, f64)> = Vec::new();
    let mut height = at.faces[2][0];
    for (material, thickness) in usual {
        height += thickness;
        // A sum of thicknesses that ends at a plane of the mesh, but for rounding.
        let plane = at.faces[2][near(&at.faces[2], height)];
        height = if (plane - height).abs() < 1e-6 * thickness { plane } else { height };
        layers.insert(0, (material, height));
    }
    let part = |axis: usize| {
        let [low, high] = extent[axis];
        let whole = low == 0 && high == counts[axis];
        (!whole).then(|| [at.faces[axis][low], at.faces[axis][high]])
    };
    let main = |cell: usize| {
        let most = (0..shares.len()).max_by(|a, b| shares[*a][cell].total_cmp(&shares[*b][cell]));
        most.filter(|m| shares[*m][cell] > NONE).map_or(0, |m| u8::try_from(m + 1).unwrap_or(0))
    };
    let cells = counts.iter().product();
    Ground {
        surface: height,
        extent: [part(0), part(1)],
        layers,
        block: 0,
        main: (0..cells).map(main).collect(),
    }
}
