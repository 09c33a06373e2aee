//! The limits of the models: predictions that exist but lie outside them.

use super::blade::{self, ROUNDING};
use super::predict::greatest_thrust;
use super::{Block, Body, Candidate, Load, ModelForecast, Prediction, Towing};
use crate::disc::Mechanism;
use crate::earth_pressure::{Face, coulomb, sokolovskii};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};

/// The limit of resistive force theory in depth.
const TOO_DEEP: &str = "deeper than one and a half thicknesses: resistive force theory has no width term";
/// Sinkage over width beyond which side crescents do not form (chosen: about the critical depth of narrow
/// tines).
const MAX_SLENDERNESS: f64 = 5.0;
/// Largest overhang at which the soil is known to slide up along the front [rad] (chosen).
const MAX_OVERHANG: f64 = FRAC_PI_6;
/// Coulomb's thrust over the exact one up to which a plane slip surface is accepted (chosen).
const MAX_PLANE_EXCESS: f64 = 1.15;
/// Height of the front's lower edge over the sinkage up to which the face below it is neglected (chosen).
const MAX_BELOW_FRONT: f64 = 0.2;
/// Sinkage over breadth up to which a body that is pressed down is shallow (chosen: the depth to which
/// Skempton's factor grows).
const MAX_PRESSED_DEPTH: f64 = 2.5;
/// Drag of resistive force theory over that of PW up to which it is accepted (chosen).
const MAX_RESISTIVE_EXCESS: f64 = 2.0;

/// Marks the predictions that lie outside the limits of their model.
pub(super) fn mark_inapplicable(models: &mut [ModelForecast], towing: &Towing) {
    let of = |candidate: Candidate| models.iter().find(|m| m.model == candidate).and_then(|m| m.prediction);
    let governing = of(Candidate::Governing).and_then(|found| found.mechanism);
    let [plane_strain, wedge] =
        [Candidate::PlaneStrain, Candidate::Wedge].map(|model| of(model).map(|p| p.drag));
    for model in models {
        let Some(found) = model.prediction else { continue };
        let why = match &towing.body {
            _ if towing.pressed => limit_for_pressed(model.model, &found, towing),
            Body::Block(block) => {
                let passive = if block.plane_strain { plane_strain } else { wedge };
                limit_for_block(model.model, &found, towing, block, passive)
            }
            Body::Disc(_) | Body::Faceted(_) | Body::Plate(_) | Body::Cone(_) | Body::Pipe(_) => {
                limit_for_disc(model.model, &found, towing, governing)
            }
        };
        if let Some(why) = why {
            model.exclude(why);
        }
    }
}

/// The further models on whose predictions the limits of these depend.
pub(super) fn decisive(towing: &Towing, models: &[Candidate]) -> Vec<Candidate> {
    let has = |list: &[Candidate]| models.iter().any(|model| list.contains(model));
    let needed: &[Candidate] = match &towing.body {
        _ if towing.pressed => &[],
        Body::Disc(_) if has(&[Candidate::Bearing, Candidate::Wedge]) => &[Candidate::Governing],
        Body::Block(_) if has(&[Candidate::SpatialResistive, Candidate::PlanarResistive]) => {
            &[Candidate::PlaneStrain, Candidate::Wedge]
        }
        _ => &[],
    };
    needed.iter().copied().filter(|model| !models.contains(model)).collect()
}

/// Why a prediction for a body that is pressed straight down lies outside the limits of its model.
fn limit_for_pressed(model: Candidate, found: &Prediction, towing: &Towing) -> Option<&'static str> {
    let is_deep = found.sinkage.unwrap_or(0.0) > MAX_PRESSED_DEPTH * towing.body.breadth();
    match model {
        Candidate::Penetration if !is_deep && matches!(towing.body, Body::Plate(_)) => Some(
            "shallower than two and a half widths: the soil fails up to the surface (see the bearing capacity)",
        ),
        Candidate::Footing if is_deep => {
            Some("deeper than two and a half widths: the soil no longer fails up to the surface")
        }
        Candidate::SpatialResistive | Candidate::PlanarResistive if is_deep => {
            Some("deeper than two and a half widths: resistive force theory has no width term")
        }
        _ => None,
    }
}

/// Why a prediction for a disc or a faceted body lies outside the limits of its model.
fn limit_for_disc(
    model: Candidate,
    found: &Prediction,
    towing: &Towing,
    governing: Option<Mechanism>,
) -> Option<&'static str> {
    let (d, t) = (towing.body.length(), towing.body.width());
    let sinkage = found.sinkage.unwrap_or(0.0);
    let has_ends = !matches!(&towing.body, Body::Faceted(body) if body.plane_strain);
    match model {
        Candidate::Bearing if governing == Some(Mechanism::Forwards) => {
            Some("under most of the thrust the soil fails forwards, at a lower pressure (see PW)")
        }
        Candidate::Wedge if governing == Some(Mechanism::Sideways) => {
            Some("under most of the thrust the soil fails sideways, at a lower pressure (see BC)")
        }
        Candidate::PlaneStrain if t < 3.0 * (sinkage * d).sqrt() => {
            Some("narrower than three contact chords: the ends of the wedge carry much of the force")
        }
        Candidate::HetheringtonLittleton if sinkage > 0.2 * d => {
            Some("for shallow sinkage only, up to about a fifth of the diameter")
        }
        Candidate::SpatialResistive | Candidate::PlanarResistive if has_ends && sinkage > 1.5 * t => {
            Some(TOO_DEEP)
        }
        Candidate::SpatialResistive | Candidate::PlanarResistive
            if -found.drag > greatest_thrust(towing, found, found.vertical) =>
        {
            Some("it pulls with more than W tan φ, the most that the soil under it can shear")
        }
        Candidate::PlanarResistive if matches!(towing.body, Body::Faceted(_)) => Some(
            "the surface has lateral normals, for which the two-dimensional law, applied in slices along the tow, is not \
             meant",
        ),
        _ => None,
    }
}

/// Why a prediction for a block lies outside the limits of its model; `passive` is the drag [N] of PW.
fn limit_for_block(
    model: Candidate,
    found: &Prediction,
    towing: &Towing,
    block: &Block,
    passive: Option<f64>,
) -> Option<&'static str> {
    let front = block.front();
    let (width, overhang) = (block.size[1], front.rake - FRAC_PI_2);
    let sinkage = found.sinkage.unwrap_or(0.0);
    let is_held = matches!(towing.load, Load::Sinkage(_));
    let is_resistive = matches!(model, Candidate::SpatialResistive | Candidate::PlanarResistive);
    let is_exact = matches!(model, Candidate::Wedge | Candidate::PlaneStrain | Candidate::BrinchHansen);
    if is_resistive && !block.plane_strain && sinkage > 1.5 * width {
        Some(TOO_DEEP)
    } else if is_resistive && is_held && passive.is_some_and(|drag| found.drag > MAX_RESISTIVE_EXCESS * drag)
    {
        Some(
            "more than twice the passive thrust with end effects (see PW): the law does not account for the rise of the \
             ground before a wide front",
        )
    } else if is_exact && overhang > MAX_OVERHANG + ROUNDING {
        Some(
            "the front overhangs by more than 30°: it is not known whether the soil slides up along it or is dragged along",
        )
    } else if !is_resistive && front.lower_edge > MAX_BELOW_FRONT * sinkage {
        Some(
            "the lower face of the rotated block also ploughs: it reaches more than a fifth of the sinkage below the \
             front, and the model is for a thin blade",
        )
    } else if model == Candidate::PlaneStrain && !block.plane_strain && width < 10.0 * sinkage {
        Some("narrower than ten depths: the ends of the wedge carry much of the force (see PW)")
    } else if model == Candidate::McKyesAli && plane_excess(towing, block) > MAX_PLANE_EXCESS {
        Some("its plane slip surface gives more than 1.15 times the exact thrust at this friction (see PW)")
    } else if !is_resistive && !block.plane_strain && sinkage > MAX_SLENDERNESS * width {
        Some(
            "deeper than five widths: below a critical depth the soil fails sideways, without side crescents",
        )
    } else {
        None
    }
}

/// Coulomb's thrust on the front over the exact one; 1 where the exact one does not exist.
fn plane_excess(towing: &Towing, block: &Block) -> f64 {
    let ratio = |face: &Face| Some(coulomb(face).ok()? / sokolovskii(face).ok()?.coefficient);
    blade::face(towing, block).ok().as_ref().and_then(ratio).unwrap_or(1.0)
}
