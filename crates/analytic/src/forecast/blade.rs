//! A towed block: its plane front as a blade, its base as a footing that carries the rest of the weight.

use super::{Block, Candidate, Front, Load, Prediction, Towing};
use crate::bearing::Footing;
use crate::capacity::ultimate_pressure;
use crate::cutting::{Blade, CuttingForce, godwin_spoor, hansen_end_factor, mckyes_ali};
use crate::disc::{Passive, end_factor, equilibrium_depth};
use crate::earth_pressure::{Face, PassiveField, PressureTable, cohesion_coefficient, coulomb_active};
use crate::error::{ModelResult, undefined};
use std::f64::consts::{FRAC_PI_2, PI};

/// Tolerance for the rounding of a right angle [rad].
pub(super) const ROUNDING: f64 = 1e-9;
/// Width over depth that stands for plane strain in models of finite blades and footings.
const PLANE_STRAIN_WIDTH: f64 = 1e9;

/// Soil reaction on the front of the block: drag and vertical force [N].
type Force = (f64, f64);

/// The prediction of a blade model for a block.
///
/// At a prescribed sinkage it is the force on the front alone, as in the models. A block that is free to sink
/// also rests on its base: a footing at the depth of the sinkage under a load inclined by the friction angle
/// of the base. It sinks until front and base carry the weight, and the load on the base adds its friction to
/// the drag.
///
/// # Errors
/// If the model cannot be applied to the block, its input is out of range, or no sinkage carries the weight.
pub(super) fn predict(
    model: Candidate,
    towing: &Towing,
    block: &Block,
    table: Option<&PressureTable>,
) -> ModelResult<Prediction> {
    let front = front_force(model, towing, block, table)?;
    let (drag, vertical, sinkage) = match towing.load {
        Load::Sinkage(z) => {
            let (drag, vertical) = front(z)?;
            (drag, vertical, z)
        }
        Load::Weight(weight) => {
            let z = equilibrium_sinkage(towing, block, weight, &front)?;
            let (drag, vertical) = front(z)?;
            (drag + towing.soil.interface_friction() * (weight - vertical), weight, z)
        }
    };
    // A vertical force within rounding is 0.
    let vertical = if vertical.abs() < 1e-12 * drag { 0.0 } else { vertical };
    Ok(Prediction::of_forces(drag, vertical, Some(sinkage)))
}

/// The least sinkage [m] at which front and base carry the weight [N].
fn equilibrium_sinkage(
    towing: &Towing,
    block: &Block,
    weight: f64,
    front: &dyn Fn(f64) -> ModelResult<Force>,
) -> ModelResult<f64> {
    let Front { lower_edge, upper_edge, .. } = block.front();
    let carried = |z: f64| -> ModelResult<f64> { Ok(front(z)?.1 + base_capacity(towing, block, z)?) };
    // Evaluated once beforehand, so that an input out of range is reported as such.
    carried(0.5 * (lower_edge + upper_edge))?;
    match equilibrium_depth(block.height() - lower_edge, weight, 1e-12, |depth| {
        carried(lower_edge + depth).unwrap_or(f64::NAN)
    }) {
        // The front alone must not press the block up with more than its weight.
        Ok(depth) if front(lower_edge + depth)?.1 <= weight * (1.0 + 1e-6) => Ok(lower_edge + depth),
        Ok(_) => undefined(
            "the equilibrium sinkage",
            "no steady state: the upward force on the front exceeds the weight",
        ),
        Err((most, _)) => {
            undefined("the equilibrium sinkage", format!("the soil carries at most {:.3} N", most.max(0.0)))
        }
    }
}

/// Bearing capacity [N] of the sliding base of an upright block at a sinkage [m]; 0 for a rotated block,
/// whose lower edge is sharp, and for one without soil under it.
///
/// q = ½ γ B N_γ* + c N_c* + γ z N_q*, N* = N s d i, with the load inclined by the friction angle of the
/// base.
///
/// # Errors
/// If the friction angle is outside the range of the factors.
pub(super) fn base_capacity(towing: &Towing, block: &Block, z: f64) -> ModelResult<f64> {
    let (soil, front) = (&towing.soil, block.front());
    if !block.has_base || (front.rake - FRAC_PI_2).abs() > ROUNDING {
        return Ok(0.0);
    }
    let across = block.size[1];
    let footing_width = if block.plane_strain { PLANE_STRAIN_WIDTH * front.length_behind } else { across };
    let width = front.length_behind.min(footing_width);
    let length = front.length_behind.max(footing_width);
    let load_inclination = soil.interface_friction().atan();
    let footing = Footing { width, length, depth: z, load_inclination };
    let pressure = ultimate_pressure(soil, &footing, towing.method)?.at(z);
    Ok(pressure * front.length_behind * across)
}

/// The force on the front as a function of the sinkage [m].
///
/// # Errors
/// If the model cannot be applied to such a block.
fn front_force<'a>(
    model: Candidate,
    towing: &'a Towing,
    block: &'a Block,
    table: Option<&PressureTable>,
) -> ModelResult<Box<dyn Fn(f64) -> ModelResult<Force> + 'a>> {
    match model {
        Candidate::Wedge if block.plane_strain => {
            undefined(model.name(), "in plane strain the wedge has no ends")
        }
        Candidate::Wedge => exact(towing, block, table, Ends::Crescents),
        Candidate::PlaneStrain => exact(towing, block, table, Ends::None),
        Candidate::BrinchHansen => {
            upright(model, block)?;
            if block.plane_strain {
                return undefined(model.name(), "in plane strain the slab has no ends");
            }
            if towing.soil.cohesion > 0.0 {
                return undefined(model.name(), "it is for cohesionless soil");
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
            if block.plane_strain {
                return undefined(
                    model.name(),
                    "in plane strain a blade has no effective width (see PW plane strain)",
                );
            }
            Ok(Box::new(|z| cutting(towing, block, z, godwin_spoor)))
        }
        Candidate::Footing | Candidate::Penetration | Candidate::Pipe => {
            undefined(model.name(), super::other_models::PRESSED)
        }
        Candidate::Uplift => undefined(model.name(), super::other_models::RAISED),
        _ => undefined(model.name(), "it is for discs and wheels, which have a curved front"),
    }
}

fn upright(model: Candidate, block: &Block) -> ModelResult<()> {
    let rake = block.front().rake;
    if (rake - FRAC_PI_2).abs() > ROUNDING {
        let degrees = rake.to_degrees();
        return undefined(
            model.name(),
            format!("it is for an upright blade; this one has a rake of {degrees:.1}°"),
        );
    }
    Ok(())
}

fn level(model: Candidate, towing: &Towing) -> ModelResult<()> {
    if towing.backfill != 0.0 {
        return undefined(model.name(), "it is for level ground");
    }
    Ok(())
}

/// Height of the front below the ground at a sinkage [m].
fn depth(block: &Block, z: f64) -> ModelResult<f64> {
    let front = block.front();
    if z <= front.lower_edge {
        let lower_edge = 1e3 * front.lower_edge;
        return undefined(
            "the force on the front",
            format!(
                "its lower edge, {lower_edge:.4} mm above the lowest edge of the block, is not in the soil"
            ),
        );
    }
    if z > front.upper_edge * (1.0 + ROUNDING) {
        let upper_edge = 1e3 * front.upper_edge;
        return undefined(
            "the force on the front",
            format!("at a sinkage above {upper_edge:.4} mm the soil flows over its upper edge"),
        );
    }
    Ok(z - front.lower_edge)
}

fn cutting(
    towing: &Towing,
    block: &Block,
    z: f64,
    model: fn(&crate::Soil, &Blade) -> ModelResult<CuttingForce>,
) -> ModelResult<Force> {
    let (depth, rake) = (depth(block, z)?, block.front().rake);
    let width = if block.plane_strain { PLANE_STRAIN_WIDTH * depth } else { block.size[1] };
    let found = model(&towing.soil, &Blade { width, depth, rake, surcharge: 0.0 })?;
    let ratio = block.size[1] / width;
    Ok((ratio * found.drag, ratio * found.vertical))
}

/// End effects on the thrust in plane strain.
#[derive(Clone, Copy, PartialEq)]
enum Ends {
    None,
    Crescents,
    Hansen,
}

/// The exact field before the front: P_n = (½ γ L² K_n + c L K_c) w S with the friction force P_n tan δ along
/// the front.
///
/// Before an upright or overhanging front the soil slides upwards, so friction acts upwards on the block.
fn exact<'a>(
    towing: &'a Towing,
    block: &'a Block,
    table: Option<&PressureTable>,
    ends: Ends,
) -> ModelResult<Box<dyn Fn(f64) -> ModelResult<Force> + 'a>> {
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

/// The front as a face of the earth pressure models.
///
/// # Errors
/// If it leans back: the exact field is for upright and overhanging faces.
pub(super) fn face(towing: &Towing, block: &Block) -> ModelResult<Face> {
    let rake = block.front().rake;
    if rake < FRAC_PI_2 - ROUNDING {
        let degrees = rake.to_degrees();
        return undefined(
            "the exact field",
            format!("the front leans back (rake {degrees:.1}°): the exact field is for 90° and more"),
        );
    }
    Ok(Face {
        friction_angle: towing.soil.friction_angle,
        wall_friction: towing.soil.interface_friction().atan(),
        surface: (PI - rake).min(FRAC_PI_2),
        backfill: towing.backfill,
    })
}
