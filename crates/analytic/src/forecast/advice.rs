//! Which model to believe, in plain words.

use super::{Candidate, ModelForecast, Towing};
use crate::disc::Drive;

/// A recommendation for the case.
pub(super) fn recommend(towing: &Towing, models: &[ModelForecast]) -> String {
    let weaker = models.iter().find(|model| model.model == Candidate::Weaker);
    let mut words = match weaker.and_then(|model| model.prediction) {
        Some(found) => leading(towing, found.sideways_share.unwrap_or(1.0)),
        None => {
            let why = weaker.map_or("", |model| model.note.as_str());
            format!(
                "The plasticity models give no answer ({why}). Only the solver can say what happens here."
            )
        }
    };
    for warning in warnings(towing) {
        words.push(' ');
        words.push_str(&warning);
    }
    words
}

fn leading(towing: &Towing, sideways: f64) -> String {
    let thickness = towing.disc.thickness / towing.disc.diameter;
    let (percent, rest) = (100.0 * sideways, 100.0 * (1.0 - sideways));
    let way = if sideways > 0.95 {
        format!(
            "at t/d = {thickness:.2} the soil escapes sideways from under nearly all of the disc, as in BC, before it \
             fails forwards"
        )
    } else if sideways < 0.05 {
        format!(
            "at t/d = {thickness:.2} the disc pushes up a wedge of soil before nearly all of its rim, as in PW, before \
             the soil can escape sideways"
        )
    } else {
        format!(
            "each part of the rim meets the easier of two ways out. At t/d = {thickness:.2} the soil escapes sideways \
             from under {percent:.0} % of the thrust, deep down (BC), and is pushed up forwards before the other \
             {rest:.0} %, near the surface (PW)"
        )
    };
    format!(
        "Believe the weaker of BC and PW: {way}. Expect its forces to be wrong by 30 to 50 %, and to change by a factor \
         of 2.1 to 2.7 for 5° in the friction angle at a given sinkage. The other models are fits to other bodies or \
         soils: a second opinion, and a measure of how little is known."
    )
}

fn warnings(towing: &Towing) -> Vec<String> {
    let mut warnings = Vec::new();
    let slides = match towing.drive {
        Drive::Locked => true,
        Drive::Slip(slip) => slip < -0.5,
        _ => false,
    };
    if slides {
        warnings.push(
            "The disc slides: no closed form has reproduced the measured locked wheel (they fall short of its drag), \
             so take the drag as a lower estimate."
                .into(),
        );
    }
    if towing.soil.dilation_angle < towing.soil.friction_angle - 1e-9 {
        warnings.push(
            "The flow is non-associated: the plasticity models use Davis' angle; the values at the full friction angle \
             stand beside them: a stronger soil, into which the same weight sinks less."
                .into(),
        );
    }
    let groups = towing.soil.cohesion / (towing.soil.unit_weight * towing.disc.diameter);
    if groups > 0.006 {
        warnings.push(format!(
            "Cohesion matters: c/(γ d) = {groups:.3} raises the vertical force by more than 5 %."
        ));
    }
    if towing.heap_fraction > 0.0 {
        warnings.push("The heap is a hypothesis that has not been validated.".into());
    }
    if towing.assembly.is_some_and(|assembly| assembly.count > 1) {
        warnings.push("The group rule for several discs is an assumption between two exact limits.".into());
    }
    warnings
}
