//! A block under tow: the plane front as a blade, and the base that carries what the front does not.

use super::{Block, Candidate, Front, Load, Prediction, Towing};
use crate::bearing::{
    Footing, Method, cohesion_factor, corrections, surcharge_factor, weight_factor_hansen,
    weight_factor_lyamin, weight_factor_meyerhof,
};
use crate::cutting::{Blade, CuttingForce, godwin_spoor, hansen_end_factor, mckyes_ali};
use crate::disc::{Passive, end_factor, first_depth};
use crate::earth_pressure::{Face, PassiveField, PressureTable, cohesion_coefficient, coulomb_active};
use crate::error::{Answer, none};
use std::f64::consts::{FRAC_PI_2, PI};

/// Rounding of a right angle [rad].
pub(super) const HAIR: f64 = 1e-9;
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
            let z = resting(towing, block, weight, &front)?;
            let (drag, vertical) = front(z)?;
            (drag + towing.soil.shared_friction() * (weight - vertical), weight, z)
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
        slip: None,
        mechanism: None,
        sideways_share: None,
    })
}

/// The least sinkage [m] at which front and base carry the weight [N].
fn resting(towing: &Towing, block: &Block, weight: f64, front: &dyn Fn(f64) -> Answer<Force>) -> Answer<f64> {
    let Front { lift, top, .. } = block.front();
    let carried = |z: f64| -> Answer<f64> { Ok(front(z)?.1 + base_capacity(towing, block, z)?) };
    // Asked for first, so that a bad input is refused with its own reason.
    carried(0.5 * (lift + top))?;
    match first_depth(block.height() - lift, weight, 1e-12, |depth| carried(lift + depth).unwrap_or(f64::NAN))
    {
        // The front alone may never press the block up by more than its weight.
        Ok(depth) if front(lift + depth)?.1 <= weight * (1.0 + 1e-6) => Ok(lift + depth),
        Ok(_) => none(
            "the equilibrium sinkage",
            "no steady state: the front is pressed up by more than the weight",
        ),
        Err((most, _)) => {
            none("the equilibrium sinkage", format!("at most {:.3} N are carried", most.max(0.0)))
        }
    }
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
