//! Which answers exist, but are not to be believed for the case.

use super::blade::{self, HAIR};
use super::{Block, Body, Candidate, Load, ModelForecast, Towing};
use crate::disc::Mechanism;
use crate::earth_pressure::{Face, coulomb, sokolovskii};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};

/// Where resistive force theory is not to be believed.
const TOO_DEEP: &str = "deeper than one and a half thicknesses: resistive force theory has no width term";
/// Sinkage over width beyond which crescents are not to be believed.
const NARROW: f64 = 5.0;
/// Steepest overhang before which the soil is known to slide up along the front [rad].
const OVERHANG: f64 = FRAC_PI_6;
/// Coulomb's thrust over the exact one beyond which a plane slip surface is not to be believed.
const PLANE_EXCESS: f64 = 1.15;
/// Share of the sinkage beyond which what lies below the front is not to be left out.
const BELOW_FRONT: f64 = 0.2;
/// Drag over that of the exact front with crescents beyond which resistive force theory is not to be believed.
const RESISTIVE_EXCESS: f64 = 2.0;

/// Marks the answers that exist but are not to be believed for this case.
pub(super) fn set_apart(models: &mut [ModelForecast], towing: &Towing) {
    if let Body::Block(block) = &towing.body {
        set_blades_apart(models, towing, block);
        return;
    }
    let governing =
        models.iter().find(|m| m.model == Candidate::Weaker).and_then(|m| m.prediction?.mechanism);
    let (d, t) = (towing.body.length(), towing.body.width());
    for model in models {
        let sinkage = model.prediction.and_then(|p| p.sinkage).unwrap_or(0.0);
        match model.model {
            Candidate::Bearing if governing == Some(Mechanism::Forwards) => {
                model.exclude(
                    "most of the thrust is met where the soil fails forwards, which takes less (see PW)",
                );
            }
            Candidate::Wedge if governing == Some(Mechanism::Sideways) => {
                model.exclude(
                    "most of the thrust is met where the soil escapes sideways, which takes less (see BC)",
                );
            }
            Candidate::PlaneStrain if t < 3.0 * (sinkage * d).sqrt() => {
                model.exclude(
                    "narrower than three contact chords: the ends of the wedge carry much of the force",
                );
            }
            Candidate::HetheringtonLittleton if sinkage > 0.2 * d => {
                model.exclude("made for shallow sinkage, up to about a fifth of the diameter");
            }
            Candidate::SpatialResistive | Candidate::PlanarResistive if sinkage > 1.5 * t => {
                model.exclude(TOO_DEEP)
            }
            Candidate::PlanarResistive if matches!(towing.body, Body::Round(_)) => {
                model.exclude(
                    "its surface is turned sideways: the law, taken in slices along the tow, was not made for that",
                );
            }
            _ => {}
        }
    }
}

/// As [`set_apart`], for a block.
fn set_blades_apart(models: &mut [ModelForecast], towing: &Towing, block: &Block) {
    let front = block.front();
    let (width, overhang) = (block.size[1], front.rake - FRAC_PI_2);
    let drag =
        |model: Candidate| models.iter().find(|m| m.model == model).and_then(|m| Some(m.prediction?.drag));
    let passive = drag(if block.endless { Candidate::PlaneStrain } else { Candidate::Wedge });
    let is_held = matches!(towing.load, Load::Sinkage(_));
    for model in models {
        let Some(found) = model.prediction else { continue };
        let sinkage = found.sinkage.unwrap_or(0.0);
        let is_resistive = matches!(model.model, Candidate::SpatialResistive | Candidate::PlanarResistive);
        let is_exact =
            matches!(model.model, Candidate::Wedge | Candidate::PlaneStrain | Candidate::BrinchHansen);
        if is_resistive && !block.endless && sinkage > 1.5 * width {
            model.exclude(TOO_DEEP);
        } else if is_resistive && is_held && passive.is_some_and(|most| found.drag > RESISTIVE_EXCESS * most)
        {
            model.exclude(
                "more than twice the passive thrust with its ends (see PW): the law does not know that the ground rises \
                 before a wide front",
            );
        } else if is_exact && overhang > OVERHANG + HAIR {
            model.exclude(
                "the front overhangs by more than 30°: whether the soil slides up along it or is dragged along is not \
                 known",
            );
        } else if !is_resistive && front.lift > BELOW_FRONT * sinkage {
            model.exclude(
                "the turned block ploughs with its lower face, too, which reaches more than a fifth of the sinkage below \
                 the front: a blade is thin",
            );
        } else if model.model == Candidate::PlaneStrain && !block.endless && width < 10.0 * sinkage {
            model.exclude("narrower than ten depths: the ends of the wedge carry much of the force (see PW)");
        } else if model.model == Candidate::McKyesAli && plane_excess(towing, block) > PLANE_EXCESS {
            model.exclude(
                "its plane slip surface gives more than 1.15 times the exact thrust at this friction (see PW)",
            );
        } else if !is_resistive && !block.endless && sinkage > NARROW * width {
            model.exclude(
                "deeper than five widths: below a critical depth the soil escapes sideways, which crescents do not know",
            );
        }
    }
}

/// Coulomb's thrust on the front over the exact one; 1 where there is no exact one to compare with.
fn plane_excess(towing: &Towing, block: &Block) -> f64 {
    let ratio = |face: &Face| Some(coulomb(face).ok()? / sokolovskii(face).ok()?.coefficient);
    blade::face(towing, block).ok().as_ref().and_then(ratio).unwrap_or(1.0)
}
