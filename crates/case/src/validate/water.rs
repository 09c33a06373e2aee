//! The water: its numbers, whether soil and bodies lie below it, and whether the soil drains.

use crate::resolved::{Case, Contact, Motion, Water};
use input::problem::Problems;
use input::quantity::plain;

/// Largest portion of solids in a soil: one of a larger submerged unit weight is not what was meant.
const MOST_SOLIDS: f64 = 0.8;

/// Reports soil and bodies that are not submerged, and soil that does not drain.
pub(super) fn water(case: &Case, problems: &mut Problems) {
    let Some(water) = case.water else { return };
    below(case, &water, problems);
    unit_weights(case, &water, problems);
    floating(case, problems);
    if water.pore_pressure {
        pore_pressure(case, &water, problems);
    } else {
        drainage(case, &water, problems);
    }
}

/// Whether soil and bodies lie below the surface of the water.
fn below(case: &Case, water: &Water, problems: &mut Problems) {
    let tops =
        case.touching().map(|(_, body)| (format!("`{}`", body.name), body.position.z + body.bounds().1.z));
    for (what, top) in std::iter::once(("the ground".to_owned(), case.top_of_ground())).chain(tops) {
        if top > water.level {
            let message =
                format!("{what} reaches up to {} m, above the water at {} m", plain(top), plain(water.level));
            problems.add(
                "water.level",
                message,
                "soil and bodies must lie below the water; leave out [water] for dry ground",
            );
        }
    }
}

/// Whether the unit weights can be those of submerged soil.
fn unit_weights(case: &Case, water: &Water, problems: &mut Problems) {
    let all_solids = case.gravity * (water.grain_density - water.density);
    for (path, soil) in case.soils() {
        if soil.unit_weight > MOST_SOLIDS * all_solids {
            let message = format!(
                "the submerged unit weight γ′ = {} N/m³ is that of a soil with {:.0} % of solids",
                plain(soil.unit_weight.round()),
                100.0 * soil.unit_weight / all_solids
            );
            let cure = "with [water], `unit_weight` is the submerged one (8 to 11 kN/m^3 in sand) and `density` the dry one";
            problems.add(format!("{path}.unit_weight"), message, cure);
        }
    }
}

/// Bodies that rise from the ground.
fn floating(case: &Case, problems: &mut Problems) {
    for body in case.bodies.iter().filter(|body| !body.is_connected()) {
        let pushed_up = |motion: &Motion| matches!(motion, Motion::Free { load, .. } if *load >= 0.0);
        if case.weight(body) < 0.0 && pushed_up(&body.translation[2]) {
            let message = format!(
                "`{}` floats: it weighs {} N, and the water that it displaces {} N",
                body.name,
                plain((case.gravity * body.whole_mass() * 1e3).round() / 1e3),
                plain(((case.gravity * body.whole_mass() - case.weight(body)) * 1e3).round() / 1e3)
            );
            problems.add(
                format!("body.{}.heave", body.name),
                message,
                "give it more weight, or a load: heave = { load = \"-40 N\" }",
            );
        }
    }
}

/// Whether the pore pressure can be computed.
fn pore_pressure(case: &Case, water: &Water, problems: &mut Problems) {
    if water.permeability.is_none() {
        let message = "the permeability of the soil is not given, from which its pore pressure follows";
        problems.add("water", message, "add  permeability = \"1e-4 m/s\"  (fine sand) to [water]");
    }
    if water.accept_drained {
        let message = "the soil is taken for drained, and its pore pressure is to be computed";
        problems.add(
            "water.accept_drained",
            message,
            "leave out one of `pore_pressure` and `accept_drained`",
        );
    }
    for (path, _) in case.soils().filter(|(_, soil)| !soil.law.bears_effective_stress()) {
        let message = "the law is that of soil from which no water can flow: its stress is the total one, with the pore pressure in it";
        let cure = "use  law = \"sand\"  or  \"mohr-coulomb\", or leave out water.pore_pressure";
        problems.add(format!("{path}.law"), message, cure);
    }
    if case.numerics.contact == Contact::Penalty {
        let message = "the penalty method knows no pore pressure";
        problems.add("numerics.contact", message, "use  contact = \"impulse\"");
    }
}

/// Whether the drainage number is known and small enough.
fn drainage(case: &Case, water: &Water, problems: &mut Problems) {
    if case.soil.law.friction_angle().is_none() {
        return;
    }
    if water.permeability.is_none() {
        let message = "the permeability of the soil is not given, which says whether water can follow as the soil is sheared";
        problems.add("water", message, "add  permeability = \"1e-4 m/s\"  (fine sand) to [water]");
        return;
    }
    if case.volume_strain().is_none() {
        let message = "the volume strain of the soil as it fails is not given, and its law does not say it";
        let cure =
            "add  volume_strain = 0.05  (medium dense sand) to [water]; 0 for soil that keeps its volume";
        problems.add("water", message, cure);
        return;
    }
    let Some(number) = case.drainage_number() else { return };
    if number > Water::DRAINED[1] && !water.accept_drained && !problems.ignores_resolution() {
        let message = format!(
            "the soil does not drain: drainage number (γ_w/γ′) v ε/k = {number:.3} at {} m/s, at most {} for drained soil",
            plain(case.largest_speed()),
            plain(Water::DRAINED[1])
        );
        let cure = "compute the pore pressure:  pore_pressure = true  in [water]; or move more slowly, or run it as drained with --accept-drained";
        problems.add("water.permeability", message, cure);
    }
}
