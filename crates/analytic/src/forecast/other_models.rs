//! Wheel models and resistive force theory as models of the forecast.

use super::{Body, Candidate, Load, Prediction, Towing};
use crate::disc::{Disc, Drive};
use crate::error::{ModelResult, undefined};
use crate::resistive::{
    Axle, Facet, Faceted, PlanarLaw, SpatialLaw, SteadyTow, Traction, at_depth, body_at_depth,
    body_under_weight, stiffness_per_unit_weight, under_weight,
};
use crate::soil::Soil;
use crate::wheel::{
    PressureSinkage, RollingResistance, bekker_at_depth, bekker_towed, brixius_towed, hetherington_littleton,
    hetherington_littleton_at_depth, wismer_luth_towed, wong_reece_at_depth, wong_reece_towed,
};

/// Why a footing is no model of a towed body.
pub(super) const PRESSED: &str = "it is for a body that is pressed straight down";
/// Why uplift is no model of another body.
pub(super) const RAISED: &str = "it is for a body that is pulled up";
/// Pressure over depth under a level plate in 3D-RFT, relative to its stiffness ξ_n.
const LEVEL_PLATE: f64 = 0.875;

pub(super) fn predict(model: Candidate, towing: &Towing) -> ModelResult<Prediction> {
    if model == Candidate::SpatialResistive {
        let (soil, friction) = (&towing.soil, towing.soil.body_friction);
        return resistive(
            &SpatialLaw::new(soil.friction_angle, soil.unit_weight, friction)?,
            towing,
            |facet| *facet,
        );
    }
    if model == Candidate::PlanarResistive {
        return resistive(&PlanarLaw::new(plate_stiffness(towing)?)?, towing, Facet::sliced);
    }
    let Body::Disc(disc) = &towing.body else {
        return undefined(model.name(), "it is for a wheel");
    };
    if towing.assembly.is_some_and(|assembly| assembly.count > 1) {
        return undefined(model.name(), "it is for a single disc");
    }
    if towing.soil.cohesion > 0.0 && matches!(model, Candidate::HetheringtonLittleton) {
        return undefined(model.name(), "it is for cohesionless soil");
    }
    match model {
        Candidate::Footing | Candidate::Penetration | Candidate::Pipe => undefined(model.name(), PRESSED),
        Candidate::Uplift => undefined(model.name(), RAISED),
        Candidate::McKyesAli | Candidate::GodwinSpoor | Candidate::BrinchHansen => undefined(
            model.name(),
            "the front of a disc overhangs the soil (rake above 90°), beyond the range of this blade model",
        ),
        _ if towing.drive != Drive::Free => undefined(model.name(), "it is for a free-rolling towed wheel"),
        Candidate::HetheringtonLittleton => hetherington(towing, disc),
        Candidate::Bekker => bekker(towing, disc),
        Candidate::WongReece => wong_reece(towing, disc),
        _ => mobility(model, towing, disc),
    }
}

pub(super) fn plate_stiffness(towing: &Towing) -> ModelResult<f64> {
    match towing.plate_stiffness {
        Some(stiffness) => Ok(stiffness),
        None => {
            Ok(LEVEL_PLATE * stiffness_per_unit_weight(towing.soil.friction_angle)? * towing.soil.unit_weight)
        }
    }
}

/// The prediction of a traction law; `projected` maps the facets to those of the law.
fn resistive(
    law: &impl Traction,
    towing: &Towing,
    projected: fn(&Facet) -> Facet,
) -> ModelResult<Prediction> {
    if towing.assembly.is_some_and(|assembly| assembly.count > 1) {
        return undefined("resistive force theory", "it is for a single disc");
    }
    if towing.soil.cohesion > 0.0 {
        return undefined("resistive force theory", "it is for cohesionless soil");
    }
    let height = towing.body.height();
    let of_facets = |facets: &[Facet], below: f64, axle: Axle, drive: Drive| {
        let facets: Vec<Facet> = facets.iter().map(projected).collect();
        let body = Faceted { facets: &facets, height, below, axle };
        match towing.load {
            Load::Weight(weight) => body_under_weight(law, &body, weight, drive),
            Load::Sinkage(z) => body_at_depth(law, &body, z, drive),
        }
    };
    let SteadyTow { drag, vertical, lateral, moment, torque, sinkage, slip } =
        match (&towing.body, towing.load) {
            (Body::Disc(disc), Load::Weight(weight)) => under_weight(law, disc, weight, towing.drive)?,
            (Body::Disc(disc), Load::Sinkage(z)) => at_depth(law, disc, z, towing.drive)?,
            (Body::Block(block), _) => {
                of_facets(&block.facets(), 0.5 * height, Axle::across(0.5 * height), Drive::Locked)?
            }
            (Body::Faceted(body), _) => of_facets(&body.facets, body.below, body.axle, towing.drive)?,
            (Body::Plate(_) | Body::Cone(_) | Body::Pipe(_), _) => {
                return undefined("the tow", "this body is pressed straight down");
            }
        };
    let rotates = towing.body.disc().is_some() || towing.drive != Drive::Locked;
    let found = prediction(towing, drag, vertical, Some(sinkage), rotates.then_some(slip))?;
    // In a plane no force acts sideways.
    let is_spatial = matches!(towing.body, Body::Faceted(_));
    let radius = match &towing.body {
        Body::Faceted(body) => body.axle.radius,
        body => 0.5 * body.length(),
    };
    Ok(Prediction {
        thrust: if towing.drive.drives() { (-torque / radius).max(0.0) } else { 0.0 },
        lateral: is_spatial.then_some(lateral),
        moment: is_spatial.then_some(moment),
        ..found
    })
}

fn hetherington(towing: &Towing, disc: &Disc) -> ModelResult<Prediction> {
    let (phi, gamma) = (towing.soil.friction_angle, towing.soil.unit_weight);
    let (RollingResistance { resistance, sinkage }, weight) = match towing.load {
        Load::Weight(weight) => (hetherington_littleton(phi, gamma, disc, weight)?, weight),
        Load::Sinkage(z) => hetherington_littleton_at_depth(phi, gamma, disc, z)?,
    };
    if sinkage > 0.95 * disc.diameter {
        return undefined("Hetherington and Littleton's sinkage", "the wheel would be buried");
    }
    prediction(towing, resistance, weight, Some(sinkage), None)
}

fn bekker(towing: &Towing, disc: &Disc) -> ModelResult<Prediction> {
    let Some(terrain) = &towing.terrain else {
        return undefined("Bekker's wheel", "no plate constants (k_c, k_φ, n) are given");
    };
    let (RollingResistance { resistance, sinkage }, weight) = match towing.load {
        Load::Weight(weight) => (bekker_towed(terrain, disc, weight)?, weight),
        Load::Sinkage(z) => bekker_at_depth(terrain, disc, z)?,
    };
    prediction(towing, resistance, weight, Some(sinkage), None)
}

fn wong_reece(towing: &Towing, disc: &Disc) -> ModelResult<Prediction> {
    let Some(terrain) = towing.terrain else {
        return undefined("Wong and Reece's wheel", "no plate constants (k_c, k_φ, n) are given");
    };
    let Soil { cohesion, friction_angle, .. } = towing.soil;
    let terrain = PressureSinkage { cohesion, friction_angle, ..terrain };
    let wheel = match towing.load {
        Load::Weight(weight) => wong_reece_towed(&terrain, disc, weight)?,
        Load::Sinkage(z) => wong_reece_at_depth(&terrain, disc, z)?,
    };
    prediction(towing, wheel.drag, wheel.vertical, Some(wheel.sinkage), Some(wheel.slip))
}

fn mobility(model: Candidate, towing: &Towing, disc: &Disc) -> ModelResult<Prediction> {
    let Load::Weight(weight) = towing.load else {
        return undefined(model.name(), "it gives the drag under a weight, not at a sinkage");
    };
    let Some(cone_index) = towing.cone_index else {
        return undefined(model.name(), "no cone index is given");
    };
    let found = match model {
        Candidate::WismerLuth => wismer_luth_towed(cone_index, disc, weight)?,
        _ => brixius_towed(cone_index, disc, weight, 0.0)?,
    };
    prediction(towing, found.resistance, weight, None, None)
}

fn prediction(
    towing: &Towing,
    drag: f64,
    vertical: f64,
    sinkage: Option<f64>,
    slip: Option<f64>,
) -> ModelResult<Prediction> {
    let contact_angle = match (sinkage, towing.body.disc()) {
        (Some(z), Some(disc)) if z > 0.0 => Some(disc.contact(z, 0.0)?.angle),
        _ => None,
    };
    Ok(Prediction { contact_angle, slip, ..Prediction::of_forces(drag, vertical, sinkage) })
}
