//! The rival models, brought to the form of the forecast.

use super::{Body, Candidate, Load, Prediction, Towing};
use crate::disc::{Disc, Drive};
use crate::error::{Answer, none};
use crate::resistive::{
    Facet, PlanarLaw, Rolled, SpatialLaw, Traction, at_depth, body_at_depth, body_under_weight,
    strength_scale, under_weight,
};
use crate::soil::Soil;
use crate::wheel::{
    PressureSinkage, Rolling, bekker_at_depth, bekker_towed, brixius_towed, hetherington_littleton,
    hetherington_littleton_at_depth, wismer_luth_towed, wong_reece_at_depth, wong_reece_towed,
};

/// Pressure over depth under a level plate in 3D-RFT, per unit of its stiffness ξ_n.
const LEVEL_PLATE: f64 = 0.875;

pub(super) fn predict(model: Candidate, towing: &Towing) -> Answer<Prediction> {
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
        return none(model.name(), "it is for a wheel");
    };
    if towing.assembly.is_some_and(|assembly| assembly.count > 1) {
        return none(model.name(), "it knows a single disc only");
    }
    if towing.soil.cohesion > 0.0 && matches!(model, Candidate::HetheringtonLittleton) {
        return none(model.name(), "it is for cohesionless soil");
    }
    match model {
        Candidate::McKyesAli | Candidate::GodwinSpoor | Candidate::BrinchHansen => none(
            model.name(),
            "the front of a disc overhangs the soil (rake beyond 90°), where this blade model ends",
        ),
        _ if towing.drive != Drive::Free => none(model.name(), "it is for a towed wheel that turns freely"),
        Candidate::HetheringtonLittleton => hetherington(towing, disc),
        Candidate::Bekker => bekker(towing, disc),
        Candidate::WongReece => wong_reece(towing, disc),
        _ => mobility(model, towing, disc),
    }
}

fn plate_stiffness(towing: &Towing) -> Answer<f64> {
    match towing.plate_stiffness {
        Some(stiffness) => Ok(stiffness),
        None => Ok(LEVEL_PLATE * strength_scale(towing.soil.friction_angle)? * towing.soil.unit_weight),
    }
}

/// The answer of a law; `seen` is how it sees a piece of a surface.
fn resistive(law: &impl Traction, towing: &Towing, seen: fn(&Facet) -> Facet) -> Answer<Prediction> {
    if towing.assembly.is_some_and(|assembly| assembly.count > 1) {
        return none("resistive force theory", "it knows a single disc only");
    }
    if towing.soil.cohesion > 0.0 {
        return none("resistive force theory", "it is for cohesionless soil");
    }
    let of_pieces = |facets: &[Facet], drive: Drive| {
        let (facets, height): (Vec<Facet>, f64) = (facets.iter().map(seen).collect(), towing.body.height());
        match towing.load {
            Load::Weight(weight) => body_under_weight(law, &facets, height, weight, drive),
            Load::Sinkage(z) => body_at_depth(law, &facets, height, z, drive),
        }
    };
    let Rolled { drag, vertical, sinkage, slip, .. } = match (&towing.body, towing.load) {
        (Body::Disc(disc), Load::Weight(weight)) => under_weight(law, disc, weight, towing.drive)?,
        (Body::Disc(disc), Load::Sinkage(z)) => at_depth(law, disc, z, towing.drive)?,
        (Body::Block(block), _) => of_pieces(&block.facets(), Drive::Locked)?,
        (Body::Round(round), _) => of_pieces(&round.facets, towing.drive)?,
    };
    let turns = towing.body.disc().is_some() || towing.drive != Drive::Locked;
    prediction(towing, drag, vertical, Some(sinkage), turns.then_some(slip))
}

fn hetherington(towing: &Towing, disc: &Disc) -> Answer<Prediction> {
    let (phi, gamma) = (towing.soil.friction_angle, towing.soil.unit_weight);
    let (Rolling { resistance, sinkage }, weight) = match towing.load {
        Load::Weight(weight) => (hetherington_littleton(phi, gamma, disc, weight)?, weight),
        Load::Sinkage(z) => hetherington_littleton_at_depth(phi, gamma, disc, z)?,
    };
    if sinkage > 0.95 * disc.diameter {
        return none("Hetherington and Littleton's sinkage", "the wheel would be buried");
    }
    prediction(towing, resistance, weight, Some(sinkage), None)
}

fn bekker(towing: &Towing, disc: &Disc) -> Answer<Prediction> {
    let Some(terrain) = &towing.terrain else {
        return none("Bekker's wheel", "no plate constants (k_c, k_φ, n) are given");
    };
    let (Rolling { resistance, sinkage }, weight) = match towing.load {
        Load::Weight(weight) => (bekker_towed(terrain, disc, weight)?, weight),
        Load::Sinkage(z) => bekker_at_depth(terrain, disc, z)?,
    };
    prediction(towing, resistance, weight, Some(sinkage), None)
}

fn wong_reece(towing: &Towing, disc: &Disc) -> Answer<Prediction> {
    let Some(terrain) = towing.terrain else {
        return none("Wong and Reece's wheel", "no plate constants (k_c, k_φ, n) are given");
    };
    let Soil { cohesion, friction_angle, .. } = towing.soil;
    let terrain = PressureSinkage { cohesion, friction_angle, ..terrain };
    let wheel = match towing.load {
        Load::Weight(weight) => wong_reece_towed(&terrain, disc, weight)?,
        Load::Sinkage(z) => wong_reece_at_depth(&terrain, disc, z)?,
    };
    prediction(towing, wheel.drag, wheel.vertical, Some(wheel.sinkage), Some(wheel.slip))
}

fn mobility(model: Candidate, towing: &Towing, disc: &Disc) -> Answer<Prediction> {
    let Load::Weight(weight) = towing.load else {
        return none(model.name(), "it gives the drag under a weight; it knows no sinkage");
    };
    let Some(cone_index) = towing.cone_index else {
        return none(model.name(), "no cone index is given");
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
) -> Answer<Prediction> {
    let contact_angle = match (sinkage, towing.body.disc()) {
        (Some(z), Some(disc)) if z > 0.0 => Some(disc.contact(z, 0.0)?.angle),
        _ => None,
    };
    let force_inclination = drag.atan2(vertical);
    let (mechanism, sideways_share) = (None, None);
    Ok(Prediction {
        drag,
        vertical,
        sinkage,
        contact_angle,
        force_inclination,
        slip,
        mechanism,
        sideways_share,
    })
}
