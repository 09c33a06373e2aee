//! A block under tow: the plane front as a blade, and the base that carries what the front does not.

use super::predict::TOO_DEEP;
use super::{Block, Candidate, Load, ModelForecast, Prediction, Towing};
use crate::bearing::{
    Footing, Method, cohesion_factor, corrections, surcharge_factor, weight_factor_hansen,
    weight_factor_lyamin, weight_factor_meyerhof,
};
use crate::cutting::{Blade, CuttingForce, godwin_spoor, hansen_end_factor, mckyes_ali};
use crate::disc::{Passive, end_factor, first_depth};
use crate::earth_pressure::{
    Face, PassiveField, PressureTable, cohesion_coefficient, coulomb, coulomb_active, sokolovskii,
};
use crate::error::{Answer, none};
use std::f64::consts::{FRAC_PI_2, PI};

/// Rounding of a right angle [rad].
const HAIR: f64 = 1e-9;
/// Width over depth of a blade that stands for an endless one.
const ENDLESS: f64 = 1e9;

/// What the soil does to the front of the block: drag and vertical force [N].
type Force = (f64, f64);

/// The answer of a blade model to a block.
///
/// Held at a sinkage it is the force on the front alone, as the models have it. A block that is free to sink rests on
/// its base, too: the base is a footing at the depth of the sinkage whose load is inclined by the friction, and the
/// block sinks until front and base carry the weight; what the base carries it also holds back by friction.
///
/// # Errors
/// If the model is not for such a block, its input is out of range, or no sinkage carries the weight.
pub(super) fn predict(
    model: Candidate,
    towing: &Towing,
    block: &Block,
    table: Option<&PressureTable>,
) -> Answer<Prediction> {
    let front = front_force(model, towing, block, table)?;
    let (drag, vertical, sinkage) = match towing.load {
        Load::Sinkage(z) => {
            let (drag, vertical) = front(z)?;
            (drag, vertical, z)
        }
        Load::Weight(weight) => {
            let (height, middle) = (block.height(), block.front());
            let carried = |z: f64| Ok::<f64, crate::Refusal>(front(z)?.1 + base_capacity(towing, block, z)?);
            // Asked for first, so that a bad input is refused with its own reason.
            carried(0.5 * (middle.lift + middle.top))?;
            match first_depth(height, weight, 1e-12, |z| carried(z).unwrap_or(f64::NAN)) {
                Ok(z) => {
                    let (drag, vertical) = front(z)?;
                    (drag + towing.soil.shared_friction() * (weight - vertical), weight, z)
                }
                Err((most, _)) => {
                    let most = most.max(0.0);
                    return none("the equilibrium sinkage", format!("at most {most:.3} N are carried"));
                }
            }
        }
    };
    // A vertical force that is nothing but rounding is none.
    let vertical = if vertical.abs() < 1e-12 * drag { 0.0 } else { vertical };
    Ok(Prediction {
        drag,
        vertical,
        sinkage: Some(sinkage),
        contact_angle: None,
        force_inclination: drag.atan2(vertical),
        skid: None,
        mechanism: None,
        sideways_share: None,
    })
}

/// Sinkage over width beyond which crescents are not to be believed.
const NARROW: f64 = 5.0;
/// Steepest overhang before which the soil is known to slide up along the front [rad].
const OVERHANG: f64 = std::f64::consts::FRAC_PI_6;
/// Coulomb's thrust over the exact one beyond which a plane slip surface is not to be believed.
const PLANE_EXCESS: f64 = 1.15;
/// Share of the sinkage beyond which what lies below the front is not to be left out.
const BELOW_FRONT: f64 = 0.2;
/// Drag over that of the exact front with crescents beyond which resistive force theory is not to be believed.
const RESISTIVE_EXCESS: f64 = 2.0;

/// Marks the answers that exist but are not to be believed for this block.
pub(super) fn set_apart(models: &mut [ModelForecast], towing: &Towing, block: &Block) {
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
    face(towing, block).ok().as_ref().and_then(ratio).unwrap_or(1.0)
}

/// The most that the base of an upright block carries at a sinkage [m] while it slides [N]; 0 for a turned block, whose
/// lower edge is sharp, and for one with no soil under it.
///
/// q = ½ γ B N_γ* + c N_c* + γ z N_q*, N* = N s d i, with the load inclined by the friction angle of the base.
///
/// # Errors
/// If the friction angle is outside the range of the factors.
pub(super) fn base_capacity(towing: &Towing, block: &Block, z: f64) -> Answer<f64> {
    let (soil, front) = (&towing.soil, block.front());
    if !block.has_base || (front.rake - FRAC_PI_2).abs() > HAIR {
        return Ok(0.0);
    }
    let (phi, across) = (soil.friction_angle, block.size[1]);
    let endless = if block.endless { ENDLESS * front.behind } else { across };
    let (width, length) = (front.behind.min(endless), front.behind.max(endless));
    let load_inclination = soil.shared_friction().atan();
    let factor = corrections(towing.method, phi, &Footing { width, length, depth: z, load_inclination })?;
    let n_gamma = match towing.method {
        Method::Meyerhof => weight_factor_meyerhof(phi)?,
        Method::HansenVesic => weight_factor_hansen(phi)?,
        Method::Lyamin => weight_factor_lyamin(phi)?,
    };
    let pressure = 0.5 * soil.unit_weight * width * n_gamma * factor.weight
        + soil.cohesion * cohesion_factor(phi)? * factor.cohesion
        + soil.unit_weight * z * surcharge_factor(phi)? * factor.surcharge;
    Ok(pressure * front.behind * across)
}

/// The force on the front as a function of the sinkage [m].
fn front_force<'a>(
    model: Candidate,
    towing: &'a Towing,
    block: &'a Block,
    table: Option<&PressureTable>,
) -> Answer<Box<dyn Fn(f64) -> Answer<Force> + 'a>> {
    match model {
        Candidate::Wedge if block.endless => none(model.name(), "in plane strain the wedge has no ends"),
        Candidate::Wedge => exact(towing, block, table, Ends::Crescents),
        Candidate::PlaneStrain => exact(towing, block, table, Ends::None),
        Candidate::BrinchHansen => {
            upright(model, block)?;
            if block.endless {
                return none(model.name(), "in plane strain the slab has no ends");
            }
            if towing.soil.cohesion > 0.0 {
                return none(model.name(), "it is for cohesionless soil");
            }
            exact(towing, block, table, Ends::Hansen)
        }
        Candidate::McKyesAli => {
            level(model, towing)?;
            Ok(Box::new(|z| cutting(towing, block, z, mckyes_ali)))
        }
        Candidate::GodwinSpoor => {
            level(model, towing)?;
            upright(model, block)?;
            if block.endless {
                return none(
                    model.name(),
                    "in plane strain a blade has no effective width: see PW plane strain",
                );
            }
            Ok(Box::new(|z| cutting(towing, block, z, godwin_spoor)))
        }
        _ => none(model.name(), "it is for a disc or a wheel, whose front is round"),
    }
}

fn upright(model: Candidate, block: &Block) -> Answer<()> {
    let rake = block.front().rake;
    if (rake - FRAC_PI_2).abs() > HAIR {
        let degrees = rake.to_degrees();
        return none(
            model.name(),
            format!("it is for an upright blade; this one has a rake of {degrees:.1}°"),
        );
    }
    Ok(())
}

fn level(model: Candidate, towing: &Towing) -> Answer<()> {
    if towing.backfill != 0.0 {
        return none(model.name(), "it is for level ground");
    }
    Ok(())
}

/// Height of the front below the ground at a sinkage [m].
fn depth(block: &Block, z: f64) -> Answer<f64> {
    let front = block.front();
    if z <= front.lift {
        let lift = 1e3 * front.lift;
        return none(
            "the force on the front",
            format!("its lower edge, {lift:.4} mm above the lowest one, is not in the soil"),
        );
    }
    if z > front.top * (1.0 + HAIR) {
        let top = 1e3 * front.top;
        return none(
            "the force on the front",
            format!("at a sinkage above {top:.4} mm the soil flows over its upper edge"),
        );
    }
    Ok(z - front.lift)
}

fn cutting(
    towing: &Towing,
    block: &Block,
    z: f64,
    model: fn(&crate::Soil, &Blade) -> Answer<CuttingForce>,
) -> Answer<Force> {
    let (depth, rake) = (depth(block, z)?, block.front().rake);
    let width = if block.endless { ENDLESS * depth } else { block.size[1] };
    let found = model(&towing.soil, &Blade { width, depth, rake, surcharge: 0.0 })?;
    let share = block.size[1] / width;
    Ok((share * found.drag, share * found.vertical))
}

/// What the ends of the front add to its plane-strain thrust.
#[derive(Clone, Copy, PartialEq)]
enum Ends {
    None,
    Crescents,
    Hansen,
}

/// The exact field before the front: P_n = (½ γ L² K_n + c L K_c) w S, friction P_n tan δ up the soil's way along it.
///
/// Upright or overhanging, the wedge of soil slides up along the front, so that the friction lifts the block.
fn exact<'a>(
    towing: &'a Towing,
    block: &'a Block,
    table: Option<&PressureTable>,
    ends: Ends,
) -> Answer<Box<dyn Fn(f64) -> Answer<Force> + 'a>> {
    let face = face(towing, block)?;
    let PassiveField { coefficient, rupture_ratio } =
        table.map_or(Passive::Solve, Passive::Table).field(&face)?;
    let soil = &towing.soil;
    let cohesive = if soil.cohesion > 0.0 {
        soil.cohesion * cohesion_coefficient(&Face { backfill: 0.0, ..face })?
    } else {
        0.0
    };
    let (sin, cos) = face.surface.sin_cos();
    let tan = face.wall_friction.tan();
    let active = coulomb_active(soil.friction_angle, face.wall_friction)?;
    let excess = coefficient / face.wall_friction.cos() - active;
    Ok(Box::new(move |z| {
        let depth = depth(block, z)?;
        let (length, width) = (depth / sin, block.size[1]);
        let ends = match ends {
            Ends::None => 1.0,
            Ends::Crescents => end_factor(rupture_ratio * length, width),
            Ends::Hansen => hansen_end_factor(excess, width, depth, 0.0, f64::INFINITY)?,
        };
        let thrust = (0.5 * soil.unit_weight * length * coefficient + cohesive) * length * width * ends;
        Ok((thrust * (sin - tan * cos), thrust * (cos + tan * sin)))
    }))
}

/// The front as the earth pressure models see it.
///
/// # Errors
/// If it leans back: the exact field is for upright and overhanging faces.
pub(super) fn face(towing: &Towing, block: &Block) -> Answer<Face> {
    let rake = block.front().rake;
    if rake < FRAC_PI_2 - HAIR {
        let degrees = rake.to_degrees();
        return none(
            "the exact field",
            format!("the front leans back (rake {degrees:.1}°): the exact field is for 90° and more"),
        );
    }
    Ok(Face {
        friction_angle: towing.soil.friction_angle,
        wall_friction: towing.soil.shared_friction().atan(),
        surface: (PI - rake).min(FRAC_PI_2),
        backfill: towing.backfill,
    })
}
