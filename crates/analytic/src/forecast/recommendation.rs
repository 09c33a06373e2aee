//! The recommended model, and the reasons in words.

use super::{Block, Body, Candidate, Load, ModelForecast, Prediction, Strength, Towing, blade};
use crate::disc::Drive;
use crate::soil::Soil;
use std::f64::consts::FRAC_PI_2;

/// The best of the models that apply, whether or not its record lets it be recommended.
#[must_use]
pub fn best(towing: &Towing, models: &[ModelForecast]) -> Option<Candidate> {
    let is_applicable =
        |candidate: Candidate| models.iter().any(|model| model.model == candidate && model.applicable);
    order(towing).iter().copied().find(|candidate| is_applicable(*candidate))
}

/// The recommended model for the body: the best one, unless it is known to be far off for bodies of this
/// kind.
pub(super) fn recommended(towing: &Towing, models: &[ModelForecast]) -> Option<Candidate> {
    best(towing, models).filter(|best| failure(towing, *best).is_none())
}

/// Why the best model is not recommended: what it was beside measurements or the solver for bodies of this
/// kind.
fn failure(towing: &Towing, best: Candidate) -> Option<&'static str> {
    let Body::Faceted(body) = &towing.body else { return None };
    if towing.pressed || best != Candidate::SpatialResistive {
        return None;
    }
    if towing.drive.drives() {
        return Some(DRIVEN);
    }
    (body.axle.direction[1].abs() < ACROSS).then_some(TURNED)
}

/// Cosine of the angle between axle and the line across the tow from which it lies across: rounding.
const ACROSS: f64 = 1.0 - 1e-9;
/// What is known of resistive force theory for driven wheels with grousers.
const DRIVEN: &str = "No model is recommended. Only 3D-RFT applies, and the pull of a driven wheel by it is an upper bound: of a \
    wheel of 0.5 m with grousers under 1000 N at 40 % slip it gives 600 N, where the solver gave 229 N and a particle code 252 N \
    (both known when the interval was made; neither is a measurement), and a sinkage of 46 mm for 60 mm. It lets each grouser \
    push against undisturbed soil. The interval takes the errors of thrust and resistance to be independent, and the thrust to be \
    at most W tan φ.";
/// What is known of resistive force theory for discs with a yaw or a tilt.
const TURNED: &str = "No model is recommended. Only 3D-RFT applies, and for discs with a yaw or a tilt it gave two to three times \
    the drag and the vertical force of the solver, and three to ten times the lateral force (D8). Trust its trends, not its \
    values.";

/// The models that may be recommended, the best first: by the scores of docs/how-to/forecast.md.
pub(super) fn order(towing: &Towing) -> &'static [Candidate] {
    match &towing.body {
        _ if towing.raised => &[Candidate::Uplift],
        Body::Pipe(_) if towing.soil.is_undrained() => &[Candidate::Pipe],
        _ if towing.pressed && is_loose(&towing.soil) => {
            &[Candidate::SpatialResistive, Candidate::Footing, Candidate::Penetration]
        }
        Body::Cone(_) => &[Candidate::Penetration, Candidate::SpatialResistive],
        _ if towing.pressed => &[Candidate::Footing, Candidate::SpatialResistive, Candidate::Penetration],
        Body::Disc(_) if towing.soil.is_undrained() => &[Candidate::Bearing],
        Body::Disc(_) => &[Candidate::Governing],
        Body::Block(block) if block.plane_strain => {
            &[Candidate::PlaneStrain, Candidate::McKyesAli, Candidate::SpatialResistive]
        }
        Body::Block(_) => &[Candidate::Wedge, Candidate::McKyesAli, Candidate::SpatialResistive],
        Body::Faceted(_) | Body::Plate(_) | Body::Pipe(_) => &[Candidate::SpatialResistive],
    }
}

/// Whether the soil is loose sand: without cohesion, and it does not dilate.
fn is_loose(soil: &Soil) -> bool {
    soil.cohesion == 0.0 && soil.dilation_angle <= 0.0
}

/// The recommendation for the case, with the reasons and the caveats; `others` are the models at the other
/// friction angle.
pub(super) fn recommend(towing: &Towing, models: &[ModelForecast], others: &[ModelForecast]) -> String {
    let best = best(towing, models);
    let found = models.iter().find(|model| Some(model.model) == best).and_then(|model| model.prediction);
    let known = best.and_then(|best| failure(towing, best));
    let mut text = match (&towing.body, best, found) {
        _ if known.is_some() => known.unwrap_or_default().to_owned(),
        (_, Some(best), Some(found)) if towing.pressed => for_pressed(towing, best, &found),
        (Body::Disc(_), Some(Candidate::Bearing), _) => DISC_ON_CLAY.into(),
        (Body::Disc(_), _, Some(found)) => for_disc(towing, found.sideways_fraction.unwrap_or(1.0)),
        (Body::Disc(_), ..) if !towing.pressed => {
            let tried = order(towing)[0];
            let governing = models.iter().find(|model| model.model == tried);
            let why = governing.map_or("", |model| model.note.as_str());
            format!("The plasticity models have no solution ({why}). Run the solver for this case.")
        }
        (Body::Block(block), Some(best), Some(found)) => for_block(towing, block, best, &found),
        (Body::Faceted(_), Some(_), _) => RESISTIVE.into(),
        _ => {
            let first = models.iter().find(|model| model.model == order(towing)[0]);
            let why = first.map_or("", |model| model.note.as_str());
            format!("No model applies ({why}). Run the solver for this case.")
        }
    };
    let recommended = recommended(towing, models).filter(|model| model.is_plastic());
    let has_other = others.iter().any(|m| Some(m.model) == recommended && m.prediction.is_some());
    for warning in warnings(towing, has_other).into_iter().chain(bearing_only_note(towing, models)) {
        text.push(' ');
        text.push_str(&warning);
    }
    text
}

/// The recommendation for a disc or a wheel on undrained clay.
const DISC_ON_CLAY: &str = "Recommended: BC with the bearing capacity factor of undrained clay, s_u N_c with Skempton's factors for \
    shape and depth, on the front of the rim. In clay the shape matters little and the strength s_u decides; the forces have not \
    been compared with measurements. Suction under the rear, which can hold clay to the rim, is left out.";

/// The recommendation for a body that is pressed straight down.
fn for_pressed(towing: &Towing, best: Candidate, found: &Prediction) -> String {
    let at_surface = if found.sinkage == Some(0.0) {
        " The ground carries the load at its surface: it does not sink, but for elastic settlement, which is left out."
    } else {
        ""
    };
    let text = match best {
        Candidate::SpatialResistive if is_loose(&towing.soil) => {
            "Recommended: 3D-RFT. Loose sand (no cohesion, no dilation) gives way from the first millimetre, and its resistance \
             grows with depth from nothing; on the plate and the wheel that were measured in such sand the median error is \
             17 and 31 %, that of the bearing capacity 35 and 49 %, which is several times too high at first and too low later. \
             The solver, whose sand with ψ = 0 keeps its volume, is nearer to the bearing capacity."
        }
        Candidate::SpatialResistive => RESISTIVE,
        Candidate::Uplift => {
            "Recommended: the weight of the soil above the body and its shear on the planes at the sides, up to the flow around a deep \
             one in clay. Tests scatter about it by a quarter to a third; nothing holds the body from below."
        }
        Candidate::Pipe => {
            "Recommended: the penetration of a pipe into clay from its surface, a fit to finite elements with the heave beside it, \
             between a smooth and a rough pipe."
        }
        Candidate::Penetration if towing.soil.is_undrained() => {
            "Recommended: the bearing factor of a cone or a pile in clay, s_u N + σ_v0: that of a shallow one, up to that of a deep \
             one, which for a cone grows with the rigidity G/s_u; and the friction α s_u on a shaft as wide as its end."
        }
        Candidate::Penetration => {
            "Recommended: the limit pressure of a spherical cavity, which stiffness and dilation raise, with the wedge and the fan of \
             soil under the end; and the friction on a shaft as wide as it. Expect a factor of 1.5, and more where the modulus at \
             such a low pressure is not known. A smooth cone may bear a third less."
        }
        _ if towing.soil.is_undrained() && towing.soil.strength_gradient > 0.0 => {
            "Recommended: the bearing capacity of clay whose strength grows with depth, for a smooth strip by the method of \
             characteristics, for a circle by a fit to it, with a depth factor for the mean strength above the base."
        }
        _ if towing.soil.is_undrained() => {
            "Recommended: the bearing capacity of undrained clay, s_u N_c with Skempton's factors for shape and depth, plus the \
             overburden beside the base; the hole is taken to stay open. At the surface it is exact for a strip and a circle."
        }
        _ => {
            "Recommended: the bearing capacity, with factors for shape and depth. It is the load at which the soil fails, of dense \
             or cohesive soil; loose sand carries less at first."
        }
    };
    text.to_owned() + at_surface
}

/// The recommendation for a disc; `sideways` is the fraction of the thrust under which the soil fails
/// sideways.
fn for_disc(towing: &Towing, sideways: f64) -> String {
    let thickness = towing.body.width() / towing.body.length();
    let (percent, rest) = (100.0 * sideways, 100.0 * (1.0 - sideways));
    let mechanism = if sideways > 0.95 {
        format!(
            "At t/d = {thickness:.2} the soil fails sideways from under nearly the whole rim, as in BC, at a lower \
             pressure than forwards."
        )
    } else if sideways < 0.05 {
        format!(
            "At t/d = {thickness:.2} the soil fails forwards in a passive wedge before nearly the whole rim, as in PW, at \
             a lower pressure than sideways."
        )
    } else {
        format!(
            "At t/d = {thickness:.2} the soil fails sideways under {percent:.0} % of the thrust, at depth (BC), and \
             forwards under the other {rest:.0} %, near the surface (PW)."
        )
    };
    format!(
        "Recommended: the weaker of BC and PW at every point of the rim. {mechanism} Expect an error of 30 to 50 % in the \
         forces, and a factor of 2.1 to 2.7 for 5° in the friction angle at a given sinkage. Where a disc rolls in loose sand \
         and sinks by less than half its thickness, 3D-RFT was as near to measured sinkages. The other models are fits to other \
         bodies or soils."
    )
}

/// The recommendation where only resistive force theory applies.
const RESISTIVE: &str = "Recommended: 3D-RFT, a fit to plates in sand, for want of another: it has not been compared with \
    measurements of such a body. For upright blocks it gives 1 to 2 times the passive thrust at a width of half the depth and 3 \
    to 8 times at ten depths. Trust its trends more than its values.";

/// The recommendation for a block.
fn for_block(towing: &Towing, block: &Block, best: Candidate, found: &Prediction) -> String {
    let sinkage = found.sinkage.unwrap_or(0.0);
    if sinkage < 1e-6 * block.height() && matches!(towing.load, Load::Weight(_)) {
        return "The base carries the block at the surface: it does not sink, and its drag is the friction on the base. \
                The base is treated as a footing under a load inclined by its friction angle, an assumption that has not \
                been validated; 3D-RFT predicts sinkage."
            .into();
    }
    let rake = block.front().rake.to_degrees();
    let text = match best {
        Candidate::PlaneStrain => format!(
            "Recommended: PW plane strain. For a plane front at a rake of {rake:.1}° in level soil it is the exact passive \
             thrust of Mohr-Coulomb soil with associated flow, before a bow wave has formed. The remaining uncertainty is \
             that of the friction angle: see the columns 5 to 95 %."
        ),
        Candidate::Wedge => format!(
            "Recommended: PW, the exact passive thrust on the front, with side crescents. In plane strain it is exact; at \
             z/b = {:.2} the end effects are an approximation without an exact solution to compare with. Brinch Hansen's \
             formula for slabs gives less; the difference is the least uncertainty.",
            sinkage / block.size[1]
        ),
        Candidate::McKyesAli => format!(
            "Recommended: McKyes-Ali. The front has a rake of {rake:.1}°, outside the range of the exact field and where a \
             plane slip surface is most accurate. The model was made for tillage tools. In plane strain it is an upper \
             bound."
        ),
        _ => return RESISTIVE.into(),
    };
    text + &conditions_of_block(towing, block)
}

/// What the prediction for a block includes at its load.
fn conditions_of_block(towing: &Towing, block: &Block) -> String {
    let Load::Sinkage(z) = towing.load else {
        let axle_is_across = (block.front().rake - FRAC_PI_2).abs() < 1e-9;
        return if axle_is_across {
            " It sinks until front and base carry the weight; the base is treated as a footing under a load inclined by \
             its friction angle, an assumption that has not been validated."
        } else {
            " It sinks until the front carries the weight; its lower edge is treated as sharp."
        }
        .into();
    };
    let mut text = String::from(
        " The forces are those on the front before a bow wave has formed; in a long tow they increase with it.",
    );
    if let Some(capacity) = blade::base_capacity(towing, block, z).ok().filter(|capacity| *capacity > 0.0) {
        text.push_str(&format!(
            " At a prescribed sinkage the soil may also exert an upward force of 0 to {capacity:.3} N under its base, with \
             the corresponding friction; the blade models neglect it."
        ));
    }
    text
}

/// The caveat where the governing mechanism of a disc is that of BC only because PW has no solution (where
/// the ground falls before a steep chord).
pub(super) fn bearing_only_note(towing: &Towing, models: &[ModelForecast]) -> Option<String> {
    let found = |candidate: Candidate| models.iter().find(|m| m.model == candidate);
    let is_predicted = found(Candidate::Governing).is_some_and(|m| m.prediction.is_some());
    let wedge = found(Candidate::Wedge).filter(|m| m.prediction.is_none())?;
    (is_predicted && towing.body.disc().is_some())
        .then(|| format!("Only BC has a solution here: PW has none ({}).", wedge.note))
}

/// Which friction angle the plasticity models use in soil with ψ < φ, and why; `has_other` where the values
/// at the other one are shown.
fn strength_warning(towing: &Towing, has_other: bool) -> Option<String> {
    let [used, other] = match (&towing.body, Strength::recommended(towing)) {
        (Body::Faceted(_) | Body::Cone(_), _) => return None,
        _ if towing.raised => return None,
        (_, Strength::Full) => [
            "the friction angle itself, which was nearer to measurements and to the solver than Davis' angle",
            "Davis' angle are given as well, those of a weaker soil",
        ],
        (_, Strength::Davis) => [
            "Davis' angle, which was nearer to the solver for walls and blades",
            "the full friction angle are given as well, those of a stronger soil",
        ],
    };
    let given = if has_other { format!("; the values at {other}") } else { String::new() };
    Some(format!("The flow is non-associated: the plasticity models use {used}{given}."))
}

/// The largest slip of a wheel that was compared with measurements.
const MAX_COMPARED_SLIP: f64 = 0.75;

/// Caveats that do not depend on the predictions.
fn warnings(towing: &Towing, has_other: bool) -> Vec<String> {
    let mut warnings = Vec::new();
    let slides = match towing.drive {
        Drive::Locked => true,
        Drive::Slip(slip) => slip < -0.5,
        _ => false,
    };
    if slides && towing.body.disc().is_some() && !towing.pressed && !towing.soil.is_undrained() {
        warnings.push(
            "The disc slides: no closed form reproduces the drag measured on locked wheels, all are too low; take the drag \
             as a lower estimate."
                .into(),
        );
    }
    if towing.soil.dilation_angle < towing.soil.friction_angle - 1e-9 {
        warnings.extend(strength_warning(towing, has_other));
    }
    let cohesion = towing.soil.cohesion / (towing.soil.unit_weight * towing.body.length());
    if cohesion > 0.006 && towing.body.disc().is_some() && !towing.soil.is_undrained() {
        warnings.push(format!(
            "Cohesion matters: c/(γ d) = {cohesion:.3} raises the vertical force by more than 5 %."
        ));
    }
    if matches!(towing.drive, Drive::Slip(slip) if slip > MAX_COMPARED_SLIP) {
        warnings.push("No model has been compared with measurements beyond a slip of 0.75.".into());
    }
    if towing.bow_wave_fraction > 0.0 {
        warnings.push("The bow wave is a hypothesis that has not been validated.".into());
    }
    if towing.assembly.is_some_and(|assembly| assembly.count > 1) {
        let rule = "The group rule for several discs, an overlap of the wedges beside them, has not been compared with measurements.";
        warnings.push(rule.into());
    }
    warnings
}
