//! The prediction of one model.

use super::{Body, Candidate, Load, Prediction, Towing, blade, other_models, pressed};
use crate::disc::{
    Disc, DiscForces, Drive, Equilibrium, Model, Passive, Setting, assembly_forces, disc_forces,
    equilibrium_of, vertical_force,
};
use crate::earth_pressure::{PressureTable, TableRange};
use crate::error::{ModelResult, undefined};

/// Why only resistive force theory applies to a body such as a sphere.
const NOT_PLANE: &str = "it is for a plane front or that of a disc across the tow";

/// The prediction of one model at the soil's friction angle as given; `table` speeds up the wedge within its
/// range.
///
/// With a resistance factor f all forces are f times those of the model: a weight W sinks to where the model
/// carries W/f. With a thrust factor g the thrust of a driven body is g times that as well, at most what the
/// soil can shear, W tan φ + c A.
///
/// # Errors
/// If the model cannot be applied to the case or has no solution.
pub fn predict(model: Candidate, towing: &Towing, table: Option<&PressureTable>) -> ModelResult<Prediction> {
    towing.check()?;
    let factor = towing.resistance_factor;
    if factor == 1.0 && towing.thrust_factor == 1.0 {
        return predict_unscaled(model, towing, table);
    }
    let load = match towing.load {
        Load::Weight(weight) => Load::Weight(weight / factor),
        Load::Sinkage(z) => Load::Sinkage(z),
    };
    let scaled = Towing { load, resistance_factor: 1.0, thrust_factor: 1.0, ..towing.clone() };
    let found = predict_unscaled(model, &scaled, table)?;
    let vertical = factor * found.vertical;
    let resistance = factor * (found.drag + found.thrust);
    let thrust =
        (towing.thrust_factor * factor * found.thrust).min(greatest_thrust(towing, &found, vertical));
    Ok(Prediction {
        drag: resistance - thrust,
        thrust,
        vertical,
        lateral: found.lateral.map(|force| factor * force),
        moment: found.moment.map(|moment| moment.map(|m| factor * m)),
        end_pressure: found.end_pressure.map(|pressure| factor * pressure),
        ..found
    })
}

/// The largest thrust [N] that the soil under a wheel can give: V tan φ + c A, in clay s_u A, with A the
/// contact (of a disc; without cohesion it does not matter). Source: the maximum soil thrust of Bekker
/// (1956).
pub(super) fn greatest_thrust(towing: &Towing, found: &Prediction, vertical: f64) -> f64 {
    let soil = &towing.soil;
    let contact = found.sinkage.unwrap_or(0.0).max(0.0) * towing.body.length();
    vertical * soil.friction_angle.tan() + soil.cohesion * towing.body.width() * contact.sqrt()
}

fn predict_unscaled(
    model: Candidate,
    towing: &Towing,
    table: Option<&PressureTable>,
) -> ModelResult<Prediction> {
    if towing.soil.is_undrained() && !suits_clay(model, towing) {
        return undefined(model.name(), "it is for frictional soil, not for undrained clay");
    }
    if towing.soil.strength_gradient > 0.0 && towing.soil.is_undrained() && !suits_growth(model, towing) {
        return undefined(
            model.name(),
            "it is for clay of uniform strength: give the mean over the depth that the body disturbs, without strength_gradient",
        );
    }
    let found = match (&towing.body, model) {
        _ if towing.pressed => pressed::predict(model, towing),
        (Body::Plate(_) | Body::Cone(_) | Body::Pipe(_), _) => {
            undefined(model.name(), "this body is pressed straight down, or pulled up")
        }
        (_, Candidate::SpatialResistive | Candidate::PlanarResistive) => other_models::predict(model, towing),
        (Body::Block(block), _) => blade::predict(model, towing, block, table),
        (Body::Faceted(_), _) => undefined(model.name(), NOT_PLANE),
        (Body::Disc(body), _) => match model {
            Candidate::Governing => disc(Model::Governing, towing, body, table),
            Candidate::Bearing => disc(Model::Bearing, towing, body, table),
            Candidate::Wedge => disc(Model::Wedge, towing, body, table),
            Candidate::PlaneStrain => disc(Model::PlaneStrain, towing, body, table),
            _ => other_models::predict(model, towing),
        },
    }?;
    if found.drag.is_finite() && found.vertical.is_finite() {
        Ok(found)
    } else {
        undefined("the force", "the numbers overflow for this input")
    }
}

/// Whether a model has a form for undrained clay.
fn suits_clay(model: Candidate, towing: &Towing) -> bool {
    match model {
        Candidate::Bearing => towing.body.disc().is_some(),
        Candidate::Footing
        | Candidate::Penetration
        | Candidate::Pipe
        | Candidate::Uplift
        | Candidate::Bekker
        | Candidate::WismerLuth
        | Candidate::Brixius => true,
        _ => false,
    }
}

/// Whether a model has a form for clay whose strength grows with depth.
fn suits_growth(model: Candidate, towing: &Towing) -> bool {
    match model {
        Candidate::Footing => matches!(towing.body, Body::Plate(_)),
        Candidate::Penetration | Candidate::Pipe | Candidate::Uplift => true,
        _ => false,
    }
}

/// A table of the smooth wedge for the friction angle of `towing`; only a driven disc, or one at a given
/// slip, needs wall friction as well, and nothing that is pressed down or stands in clay needs any.
pub(super) fn level_table(towing: &Towing) -> Option<PressureTable> {
    if towing.pressed || towing.soil.is_undrained() || towing.body.disc().is_none() {
        return None;
    }
    let phi = towing.soil.friction_angle;
    let range = TableRange {
        friction_angle: (phi, phi),
        wall_friction_ratio: (0.0, 0.0),
        surface: (0.0, 1.36),
        backfill: towing.backfill,
    };
    let is_smooth = matches!(towing.drive, Drive::Free | Drive::Locked | Drive::Braked(_));
    if is_smooth { PressureTable::new(range).ok() } else { None }
}

fn disc(
    model: Model,
    towing: &Towing,
    disc: &Disc,
    table: Option<&PressureTable>,
) -> ModelResult<Prediction> {
    let setting = Setting {
        soil: towing.soil,
        disc: *disc,
        drive: towing.drive,
        bow_wave_fraction: towing.bow_wave_fraction,
        backfill: towing.backfill,
        method: towing.method,
        passive: table.map_or(Passive::Solve, Passive::Table),
    };
    let at = |z: f64| match &towing.assembly {
        Some(assembly) => assembly_forces(model, &setting, assembly, z),
        None => disc_forces(model, &setting, z),
    };
    let carried = |z: f64| match &towing.assembly {
        Some(_) => Ok(at(z)?.vertical),
        None => vertical_force(model, &setting, z),
    };
    match towing.load {
        Load::Sinkage(z) => Ok(prediction(&at(z)?, z)),
        Load::Weight(weight) => match equilibrium_of(disc, weight, carried, at)? {
            Equilibrium::At { sinkage, forces } => Ok(prediction(&forces, sinkage)),
            Equilibrium::None { largest_weight, .. } => undefined(
                "the equilibrium sinkage",
                format!("no equilibrium: the soil carries at most {largest_weight:.3} N, the disc digs in"),
            ),
        },
    }
}

fn prediction(forces: &DiscForces, sinkage: f64) -> Prediction {
    Prediction {
        // The friction of the soil is the torque of the axle over the radius, and negative where it is
        // driven.
        thrust: (-forces.friction).max(0.0),
        contact_angle: Some(forces.contact_angle),
        force_inclination: forces.force_inclination,
        slip: Some(forces.slip),
        mechanism: Some(forces.mechanism),
        sideways_fraction: Some(forces.sideways_fraction),
        ..Prediction::of_forces(forces.drag, forces.vertical, Some(sinkage))
    }
}
