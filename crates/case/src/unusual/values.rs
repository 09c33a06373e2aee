//! Values outside the usual ranges of their keys.

use crate::keys::{self, Key, Kind};
use crate::resolved::{Case, Law, MOTIONS, Motion, Soil};
use crate::shapes::Shape;

/// Acceleration of gravity to which unit weights refer [m/s²].
const EARTH: f64 = 9.81;

/// Doubts numbers outside the usual range of their key.
pub(super) fn values(case: &Case, doubts: &mut Vec<String>) {
    let mut doubt = |path: &str, number: f64, scale: f64| doubts.extend(outside(path, number, scale));
    doubt("gravity", case.gravity, 1.0);
    for (path, soil) in case.soils().filter(|(_, soil)| is_soil(soil)) {
        let weighs = soil.density * case.gravity;
        let follows = (soil.unit_weight - weighs).abs() <= 1e-9 * weighs;
        // A density that follows from a weight is doubted once.
        let of_weight = |key: &Key| {
            follows
                && key.name == "density"
                && outside(&format!("{path}.unit_weight"), soil.unit_weight, case.gravity / EARTH).is_some()
        };
        for (key, number) in soil.numbers().into_iter().filter(|(key, _)| !of_weight(key)) {
            let scale = if key.name == "unit_weight" { case.gravity / EARTH } else { 1.0 };
            doubt(&format!("{path}.{}", key.name), number, scale);
        }
    }
    if let Some(water) = case.water {
        doubt("water.density", water.density, 1.0);
        doubt("water.grain_density", water.grain_density, 1.0);
        doubt("water.permeability", water.permeability.unwrap_or(0.0), 1.0);
    }
    for (_, body) in case.touching() {
        doubt(&format!("body.{}.friction", body.name), body.friction, 1.0);
    }
    for (path, motion) in motions(case) {
        if let Motion::Prescribed { speed, .. } = motion {
            doubt(&format!("{path}.speed"), speed, 1.0);
        }
    }
    for (_, body) in case.touching() {
        if let Shape::Disc(disc) = &body.shape
            && disc.thickness > disc.diameter
        {
            doubts.push(format!(
                "body.{}.thickness = {} m is more than the diameter, {} m, which no disc has; a roller is a cylinder with axis = \"y\".",
                body.name, disc.thickness, disc.diameter
            ));
        }
    }
}

/// Whether a material is soil: not metal, and not elastic for good.
pub(super) fn is_soil(soil: &Soil) -> bool {
    !matches!(soil.law, Law::VonMises(_) | Law::Elastic)
}

/// The translations of all bodies, at the start and in stages, each with its path.
pub(super) fn motions(case: &Case) -> Vec<(String, Motion)> {
    let mut all = Vec::new();
    for body in &case.bodies {
        let own = MOTIONS.iter().zip(&body.translation);
        all.extend(own.map(|(key, motion)| (format!("body.{}.{key}", body.name), motion.clone())));
    }
    for stage in &case.stages {
        for change in stage.changes.iter().filter(|change| change.motion < 3) {
            let (body, key) = (&case.bodies[change.body].name, MOTIONS[change.motion]);
            all.push((format!("stage.{}.{body}.{key}", stage.name), change.to.clone()));
        }
    }
    all
}

/// The doubt about a number outside the usual range of its key, which is larger or smaller by a factor
/// `scale`. 0 is written on purpose and not doubted.
fn outside(path: &str, number: f64, scale: f64) -> Option<String> {
    let key = keys::at(path)?;
    let ends = key.usual_ends()?.map(|end| end * scale);
    // A limit that was typed comes back with a rounding error.
    let within =
        |number: f64| number >= ends[0] * (1.0 - 1e-9 * ends[0].signum()) && number <= ends[1] * (1.0 + 1e-9);
    if number == 0.0 || number.is_infinite() || within(number) {
        return None;
    }
    let factors: &[f64] = if matches!(key.kind, Kind::Quantity(_)) { &PREFIXES } else { &DIGITS };
    let meant = factors.iter().find(|factor| within(number * *factor));
    let meant =
        meant.map_or_else(String::new, |factor| format!("; was {} meant?", key.shown(number * factor)));
    Some(format!(
        "{path} = {} is unusual: {}{meant}",
        key.shown(number),
        Key::usual_text(key).unwrap_or_default()
    ))
}

/// By what a quantity is mistaken: the prefix of its unit, or a digit; and a number without a unit.
const PREFIXES: [f64; 8] = [1e3, 1e-3, 1e6, 1e-6, 1e9, 1e-9, 10.0, 0.1];
const DIGITS: [f64; 3] = [0.1, 0.01, 10.0];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_outside_are_doubted_with_what_may_be_meant() {
        let doubt = |path: &str, number: f64| outside(path, number, 1.0);
        let said = |path: &str, number: f64| doubt(path, number).unwrap();
        assert!(said("soil.young_modulus", 1e-3).ends_with("was 1000000 Pa meant?"));
        assert!(said("soil.unit_weight", 1440.0).ends_with("was 14400 N/m^3 meant?"));
        assert!(said("layer.clay.shear_strength", 20.0).ends_with("was 20000 Pa meant?"));
        assert!(said("body.disc.friction", 3.0).contains("0 to 1"));
        assert!(said("body.disc.forward.speed", -20.0).contains("m/s"));
        assert!(said("soil.friction_angle", 0.05).contains("15 deg to 50 deg"));
        for (path, number) in [
            ("soil.unit_weight", 0.0),
            ("soil.unit_weight", 3e3),
            ("soil.young_modulus", 1e9),
            ("body.disc.friction", f64::INFINITY),
            ("body.disc.forward.speed", -10.0),
            ("soil.friction_angle", 15_f64.to_radians()),
            ("soil.bolton_q", 1e9),
        ] {
            assert_eq!(doubt(path, number), None, "{path}");
        }
        // On the Moon soil weighs a sixth.
        assert_eq!(outside("soil.unit_weight", 2500.0, 1.62 / 9.81), None);
    }
}
