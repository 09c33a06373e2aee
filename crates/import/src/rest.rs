//! The stress at the start: what of it a case has as K₀ and overburden, and whether the rest follows from
//! weight.

use crate::eulerian::Eulerian;
use crate::fill::{Box3, Ground};
use crate::frame::Frame;
use crate::notes::Notes;
use deck::block::{Row, Wrong};
use std::collections::HashMap;

/// K₀ of each material with its block, and the pressure on the surface in units of the deck.
#[derive(Default)]
pub(super) struct Rest {
    pub(super) k0: HashMap<usize, (f64, usize)>,
    pub(super) overburden: Option<(f64, usize)>,
}

/// What the ground looks like.
pub(super) struct Site<'a> {
    pub(super) mesh: &'a Eulerian,
    pub(super) at: &'a Box3,
    pub(super) ground: &'a Ground,
    pub(super) frame: &'a Frame,
    /// Gravity times density of each material, in units of the deck.
    pub(super) weight: Vec<f64>,
}

/// Stress from the initial conditions; other initial conditions are refused.
pub(super) fn rest(notes: &mut Notes, site: &Site) -> Rest {
    let mut rest = Rest::default();
    let deck = notes.deck;
    for (number, kind) in &deck.initial {
        match kind.as_str() {
            "VOLUME FRACTION" => {}
            "STRESS" if deck.blocks[*number].has("GEOSTATIC") => {
                for row in &deck.blocks[*number].rows {
                    if let Err(wrong) = geostatic(notes, site, *number, row, &mut rest) {
                        notes.refused(*number, wrong);
                    }
                }
            }
            "STRESS" => {
                for row in &deck.blocks[*number].rows {
                    if let Err(wrong) = uniform(notes, site, *number, row, &mut rest) {
                        notes.refused(*number, wrong);
                    }
                }
            }
            _ => notes.refused(*number, format!("initial conditions of type {kind} are not represented")),
        }
    }
    rest
}

/// The materials of the elements of a set, most of their cells.
fn material(notes: &Notes, site: &Site, row: &Row) -> Result<usize, Wrong> {
    let ids =
        notes.deck.elements(0, row.field(0)).or_else(|| notes.deck.elements(site.mesh.region, row.field(0)));
    let ids =
        ids.ok_or_else(|| Wrong::at(row.place, format!("there is no element set {:?}", row.field(0))))?;
    let mut counts = [0_usize; 256];
    for id in &ids {
        let cell = site.mesh.cells.get(id);
        let cell = cell.ok_or_else(|| Wrong::at(row.place, "elements that are not Eulerian"))?;
        counts[usize::from(site.ground.main[site.at.cell(*cell)])] += 1;
    }
    let most = (1..256).max_by_key(|n| counts[*n]).filter(|n| counts[*n] > 0);
    most.map(|n| n - 1).ok_or_else(|| Wrong::at(row.place, "the set holds no soil"))
}

fn geostatic(notes: &mut Notes, site: &Site, block: usize, row: &Row, rest: &mut Rest) -> Result<(), Wrong> {
    if site.frame.axes[2] != (2, true) {
        return Err(Wrong::at(row.place, "a geostatic stress is that of a model whose z points up"));
    }
    let get = |n: usize| {
        row.number(n)?
            .ok_or_else(|| Wrong::at(row.place, "set, two pairs of stress and height, and K0 were expected"))
    };
    let [s1, z1, s2, z2, k0] = [get(1)?, get(2)?, get(3)?, get(4)?, get(5)?];
    let k0y = row.number(6)?.unwrap_or(k0);
    let number = material(notes, site, row)?;
    if z1 == z2 || k0 < 0.0 {
        return Err(Wrong::at(row.place, "two heights that differ, and K0 of 0 or more, were expected"));
    }
    let slope = (s2 - s1) / (z2 - z1);
    let weight = site.weight.get(number).copied().unwrap_or(0.0);
    let at_surface = s1 + slope * (site.ground.surface + site.frame.origin[2] - z1);
    let scale = (weight * (site.ground.surface - site.at.faces[2][0])).abs().max(s1.abs()).max(s2.abs());
    rest.k0.insert(number, (k0, block));
    if (k0 - k0y).abs() > 1e-6 * k0 {
        notes.approximated(block, format!("K₀ is {k0} along both axes, not {k0y} along y"));
    }
    let is_layered = site.ground.layers.len() > 1;
    if (slope - weight).abs() > 0.02 * weight.abs().max(1e-30) && scale > 0.0 {
        notes.approximated(
            block,
            format!("the ground begins in equilibrium under its own weight {weight:.6e} per height; the deck states {slope:.6e}, and differs from that"),
        );
    } else if at_surface.abs() > 0.01 * scale && !is_layered {
        let [low, high] = [0, site.at.faces[2].len() - 1].map(|n| site.at.faces[2][n]);
        let is_full = (site.ground.surface - high).abs() < 1e-9 * (high - low);
        if at_surface < 0.0 && is_full {
            rest.overburden = Some((-at_surface, block));
        } else {
            notes.approximated(
                block,
                format!("the stress of {at_surface:.6e} at the surface is left out: it rests on no lid"),
            );
        }
    }
    notes.understood(block, "K₀; the vertical stress follows from the weight");
    Ok(())
}

fn uniform(notes: &mut Notes, site: &Site, block: usize, row: &Row, rest: &mut Rest) -> Result<(), Wrong> {
    let number = material(notes, site, row)?;
    let mut stress = [0.0; 3];
    for (axis, value) in stress.iter_mut().enumerate() {
        *value = row.number(axis + 1)?.unwrap_or(0.0);
    }
    let stress = [0, 1, 2].map(|n| stress[site.frame.axes[n].0]);
    if stress[2] < 0.0 {
        rest.k0.insert(number, (stress[0] / stress[2], block));
    }
    let text = "of a uniform stress only the ratio of horizontal to vertical is taken, as K₀; the ground begins in equilibrium under its own weight";
    notes.approximated(block, text);
    Ok(())
}
