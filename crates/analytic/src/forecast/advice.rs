//! Which model to believe, in plain words.

use super::{Block, Body, Candidate, Load, ModelForecast, Prediction, Towing, blade};
use crate::disc::Drive;
use std::f64::consts::FRAC_PI_2;

/// The model to believe, if it has an answer.
pub(super) fn recommended(towing: &Towing, models: &[ModelForecast]) -> Option<Candidate> {
    let has_answer =
        |candidate: Candidate| models.iter().any(|model| model.model == candidate && model.applicable);
    let order: &[Candidate] = match &towing.body {
        Body::Disc(_) => &[Candidate::Weaker],
        Body::Block(block) if block.endless => {
            &[Candidate::PlaneStrain, Candidate::McKyesAli, Candidate::SpatialResistive]
        }
        Body::Block(_) => &[Candidate::Wedge, Candidate::McKyesAli, Candidate::SpatialResistive],
        Body::Round(_) => &[Candidate::SpatialResistive],
    };
    order.iter().copied().find(|candidate| has_answer(*candidate))
}

/// A recommendation for the case.
pub(super) fn recommend(towing: &Towing, models: &[ModelForecast]) -> String {
    let best = recommended(towing, models);
    let found = models.iter().find(|model| Some(model.model) == best).and_then(|model| model.prediction);
    let mut words = match (&towing.body, best, found) {
        (Body::Disc(_), _, Some(found)) => leading(towing, found.sideways_share.unwrap_or(1.0)),
        (Body::Disc(_), ..) => {
            let weaker = models.iter().find(|model| model.model == Candidate::Weaker);
            let why = weaker.map_or("", |model| model.note.as_str());
            format!(
                "The plasticity models give no answer ({why}). Only the solver can say what happens here."
            )
        }
        (Body::Block(block), Some(best), Some(found)) => before_block(towing, block, best, &found),
        (Body::Round(_), Some(_), _) => RESISTIVE.into(),
        _ => "No model applies. Only the solver can say what happens here.".into(),
    };
    for warning in warnings(towing).into_iter().chain(sideways_alone(towing, models)) {
        words.push(' ');
        words.push_str(&warning);
    }
    words
}

fn leading(towing: &Towing, sideways: f64) -> String {
    let thickness = towing.body.width() / towing.body.length();
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

/// What is said where resistive force theory stands alone.
const RESISTIVE: &str = "Believe 3D-RFT, for want of another: it is a fit to plates in sand. Where it can be compared, \
    on upright blocks, it gives 1 to 2 times the passive thrust at a width of half the depth, 3 to 8 times at ten depths. \
    Believe the trend rather than the number.";

/// What to believe of a block, and how far.
fn before_block(towing: &Towing, block: &Block, best: Candidate, found: &Prediction) -> String {
    let rake = block.front().rake.to_degrees();
    let sinkage = found.sinkage.unwrap_or(0.0);
    let slender = sinkage / block.size[1];
    if sinkage < 1e-6 * block.height() && matches!(towing.load, Load::Weight(_)) {
        return "The ground carries the block on its base: it does not sink, and its drag is the friction of the base. That \
                the base counts as a footing under a load inclined by its friction is an assumption that has not been \
                validated; 3D-RFT lets it sink."
            .into();
    }
    let mut words = match best {
        Candidate::PlaneStrain => format!(
            "Believe PW plane strain: for a plane front at a rake of {rake:.1}° in level soil it is the exact passive \
             thrust of Mohr-Coulomb soil with associated flow, before soil has heaped up. What is left is the friction \
             angle: the columns of 5 to 95 % show its part."
        ),
        Candidate::Wedge => format!(
            "Believe PW: the exact passive thrust on the front, with crescents of soil at its two ends. In plane strain it \
             is exact; at z/b = {slender:.2} the ends are a rule that no exact solution checks. Brinch Hansen's \
             formula for slabs gives less: how far the two lie apart is the least that is unknown."
        ),
        Candidate::McKyesAli => format!(
            "Believe McKyes-Ali: the front has a rake of {rake:.1}°, which the exact field does not reach and where a plane \
             slip surface is at its best. It was made for tools that cut the ground. With a plane slip surface it can only \
             err to the high side in plane strain."
        ),
        _ => RESISTIVE.into(),
    };
    if best == Candidate::SpatialResistive {
        return words;
    }
    if let Load::Sinkage(z) = towing.load {
        words.push_str(
            " The forces are those on the front before soil heaps up; in a long tow they grow with the heap.",
        );
        if let Some(most) = blade::base_capacity(towing, block, z).ok().filter(|most| *most > 0.0) {
            words.push_str(&format!(
                " Held at its height the block may be pressed up by anything between 0 and {most:.3} N under its base, and \
                 be braked by the friction of that: the blade models leave it out."
            ));
        }
    } else {
        words.push_str(if (block.front().rake - FRAC_PI_2).abs() < 1e-9 {
            " It sinks until front and base carry the weight; the base counts as a footing under a load inclined by its \
             friction, an assumption that has not been validated."
        } else {
            " It sinks until the front carries the weight; its lower edge counts as sharp."
        });
    }
    words
}

/// What is said where the weaker of two ways out is the only one that has an answer: PW ends at a wall friction of two
/// thirds of φ, and on steep chords. Beyond, BC alone is no lower bound, and the answer jumps where PW begins to have one.
pub(super) fn sideways_alone(towing: &Towing, models: &[ModelForecast]) -> Option<String> {
    let found = |candidate: Candidate| models.iter().find(|m| m.model == candidate);
    let stands = found(Candidate::Weaker).is_some_and(|m| m.prediction.is_some());
    let wedge = found(Candidate::Wedge).filter(|m| m.prediction.is_none())?;
    if !stands || towing.body.disc().is_none() {
        return None;
    }
    let from = (1.5 * towing.soil.shared_friction().atan()).to_degrees();
    Some(format!(
        "BC stands alone here: PW has no answer ({}), though the soil may well fail forwards. Where PW has one (a friction \
         angle in the models from {from:.1}° on, by its wall friction of at most two thirds of it) the weaker of both is far \
         less, a jump of the models and not of the soil; an interval that reaches across it may leave the value shown out.",
        wedge.note
    ))
}

fn warnings(towing: &Towing) -> Vec<String> {
    let mut warnings = Vec::new();
    let slides = match towing.drive {
        Drive::Locked => true,
        Drive::Slip(slip) => slip < -0.5,
        _ => false,
    };
    if slides && towing.body.disc().is_some() {
        warnings.push(
            "The disc slides: no closed form has reproduced the measured locked wheel (they fall short of its drag), \
             so take the drag as a lower estimate."
                .into(),
        );
    }
    let is_plastic = !matches!(towing.body, Body::Round(_));
    if is_plastic && towing.soil.dilation_angle < towing.soil.friction_angle - 1e-9 {
        warnings.push(
            "The flow is non-associated: the plasticity models use Davis' angle; the values at the full friction angle \
             stand beside them: a stronger soil, into which the same weight sinks less."
                .into(),
        );
    }
    let groups = towing.soil.cohesion / (towing.soil.unit_weight * towing.body.length());
    if groups > 0.006 && towing.body.disc().is_some() {
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
