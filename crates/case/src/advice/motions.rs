//! Whether motions begin within the run, and take the bodies into the soil.

use crate::path::{displacement, range};
use crate::resolved::{Body, Case, Ground, Law, MOTIONS, Motion};
use crate::told::lasts;
use glam::DVec3;
use input::quantity::plain;

/// Warns of motions that never begin.
pub(super) fn late(case: &Case, notes: &mut Vec<String>) {
    for (number, body) in case.bodies.iter().enumerate() {
        for (motion, how) in body.motions().iter().enumerate() {
            let path = format!("body.{}.{}", body.name, MOTIONS[motion]);
            begins(&path, how, lasts(case, number, motion, 0), notes);
        }
    }
    for (number, stage) in case.stages.iter().enumerate() {
        for change in &stage.changes {
            let (body, key) = (&case.bodies[change.body].name, MOTIONS[change.motion]);
            let path = format!("stage.{}.{body}.{key}", stage.name);
            begins(&path, &change.to, lasts(case, change.body, change.motion, number + 1), notes);
        }
    }
}

fn begins(path: &str, how: &Motion, lasts: f64, notes: &mut Vec<String>) {
    let start = match how {
        Motion::Prescribed { speed, start, .. } if *speed != 0.0 => *start,
        Motion::Free { load, start, .. } if *load != 0.0 => *start,
        Motion::Course(course) => course.begins(),
        _ => return,
    };
    // Before the first stage nothing has begun.
    if lasts > 0.0 && start >= lasts {
        notes.push(format!(
            "{path} begins at {} s, and nothing comes of it: it lasts until {} s.",
            plain(start),
            plain(lasts)
        ));
    }
}

/// Height of the lowest point of a body on its path [m], as far as that is prescribed.
pub(super) fn lowest(case: &Case, body: &Body) -> f64 {
    body.position.z + body.reach().0.z + range(body, case.duration)[0].z
}

/// Whether a body stays above the undisturbed ground on its whole path; heaps do not count.
pub(super) fn is_above_ground(case: &Case, body: &Body) -> bool {
    let highest = case.ground.surface() + case.relief.of_solver().extremes(case.area())[1];
    let falls = body.guided().translation[2].is_free();
    !falls && lowest(case, body) >= highest - 1e-9
}

/// Warns of bodies that never meet soil, and of those that are lifted out of it at once.
pub(super) fn in_soil(case: &Case, body: &Body, notes: &mut Vec<String>) {
    // Soil that moves may come to the body.
    let is_still = matches!(case.ground, Ground::Level { .. }) && case.velocity == DVec3::ZERO;
    let guide = body.guided();
    if !is_still || !case.is_even() || guide.translation[2].is_free() || body.guide.is_some() || body.steers()
    {
        return;
    }
    let [down, up] = range(body, case.duration);
    let lowest = body.position.z + body.bounds().0.z - case.ground.surface();
    let name = &body.name;
    if is_above_ground(case, body) {
        let moved = if up.z > 0.0 { format!(" and goes up {} m", plain(up.z)) } else { String::new() };
        notes.push(format!(
            "{name}: never gets into the soil: its lowest point is {} m above the surface at the start{moved}; give it a sinkage, or a heave \
             with a negative speed or displacement.",
            plain(lowest.max(0.0) + 0.0)
        ));
    } else if up.z > 0.0 && lowest + up.z >= 0.0 && down == DVec3::ZERO && up.x == 0.0 && up.y == 0.0 {
        notes.push(format!(
            "{name}: is lifted out of the soil, up {} m from a sinkage of {} m: a positive heave goes upwards.",
            plain(up.z),
            plain(-lowest)
        ));
    }
}

/// Part of the narrowest side of a body by which it may be moved through soil that has no strength (chosen: a
/// strain of one half).
const ELASTIC_TRAVEL: f64 = 0.5;

/// Warns of a body that is to plough soil which only stretches.
pub(super) fn through_elastic_soil(case: &Case, body: &Body, notes: &mut Vec<String>) {
    let Some((path, _)) = case.soils().find(|(_, soil)| matches!(soil.law, Law::Elastic)) else { return };
    let depth = case.ground.surface() - lowest(case, body);
    let mut size = body.size();
    if case.domain.plane_strain {
        size.y = f64::INFINITY;
    }
    let (travel, width) = (displacement(body, case.duration).length(), size.min_element());
    if depth > case.grid.fine_cell().z && travel > ELASTIC_TRAVEL * width {
        notes.push(format!(
            "{}: is moved by {} m through soil without a strength ({path}.law = \"elastic\"), which stretches and does not flow: the cells will be \
             torn; give the soil a strength, or move the body by less than {} m.",
            body.name,
            plain(travel),
            plain(ELASTIC_TRAVEL * width)
        ));
    }
}

#[cfg(test)]
mod tests {
    use crate::{advice, parse};

    /// A plate on the surface of sand, or where `more` puts it.
    fn notes(more: &str) -> String {
        let text = format!(
            "format = 2\nsoil = {{ law = 'mohr-coulomb', friction_angle = '32 deg', unit_weight = '15 kN/m^3', young_modulus = '1 MPa' }}\n\
             domain = {{ x = ['-0.3 m', '0.3 m'], y = ['-0.3 m', '0.3 m'], z = ['-0.3 m', '0.2 m'] }}\ngrid = {{ cell = '12.5 mm', growth = 1.3 }}\n\
             run = {{ duration = '0.5 s' }}\n[body.plate]\nshape = 'block'\nsize = ['0.1 m', '0.1 m', '0.05 m']\nfriction = 0.3\n{more}\n"
        );
        advice(&parse(&text, "case.toml", &[]).unwrap()).join("\n")
    }

    #[test]
    fn a_body_that_never_gets_into_the_soil_or_is_lifted_out_of_it_is_doubted() {
        for (more, words) in [
            (
                "heave = { speed = '0.05 m/s' }",
                "plate: never gets into the soil: its lowest point is 0 m above the surface at the start and goes up",
            ),
            ("heave = { displacement = '25 mm', ramp = '0.4 s' }", "plate: never gets into the soil"),
            (
                "sinkage = '-20 mm'\nforward = { speed = '0.2 m/s' }",
                "its lowest point is 0.02 m above the surface",
            ),
            (
                "sinkage = '-50 mm'\nheave = { displacement = '-30 mm', ramp = '0.4 s' }",
                "plate: never gets into the soil",
            ),
            (
                "sinkage = '20 mm'\nheave = { displacement = '25 mm', ramp = '0.4 s' }",
                "plate: is lifted out of the soil, up 0.025 m from a sinkage of 0.02 m",
            ),
            ("heave = { speed = '-0.1 m/s', start = '0.5 s' }", "body.plate.heave begins at 0.5 s"),
        ] {
            let notes = notes(more);
            assert!(notes.contains(words), "{more}: {notes}");
        }
    }

    #[test]
    fn a_body_that_is_pressed_down_buried_or_falls_is_not() {
        for more in [
            "heave = { displacement = '-25 mm', ramp = '0.4 s' }",
            "sinkage = '0.15 m'\nheave = { displacement = '25 mm', ramp = '0.4 s' }",
            "sinkage = '-20 mm'\nweight = '50 N'\nheave = 'free'",
            "sinkage = '20 mm'\nforward = { speed = '0.2 m/s' }",
            "sinkage = '-10 mm'\nheave = { displacement = '-30 mm', ramp = '0.4 s' }",
        ] {
            let notes = notes(more);
            assert!(
                !["never gets", "lifted out", "nothing comes"].iter().any(|word| notes.contains(word)),
                "{more}: {notes}"
            );
        }
    }

    #[test]
    fn what_carries_soil_above_the_ground_is_not_advised_as_if_it_stood_in_it() {
        let tray = "sinkage = '-40 mm'\nforward = { speed = '0.5 m/s', ramp = '0.2 s' }\n[soil_body.fill]\nshape = 'block'\n\
                    size = ['0.08 m', '0.08 m', '0.05 m']\nelevation = '0.115 m'\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\n\
                    unit_weight = '15 kN/m^3'\nyoung_modulus = '1 MPa'";
        let notes = notes(tray);
        assert!(
            !["Froude", "walls are near", "never gets"].iter().any(|word| notes.contains(word)),
            "{notes}"
        );
    }

    #[test]
    fn a_history_with_too_few_lines_for_steady_means_is_doubted() {
        let pressed = "heave = { speed = '-0.05 m/s' }\n[output]\nhistory_interval = ";
        let few = notes(&format!("{pressed}'50 ms'"));
        assert!(few.contains("output.history_interval = 0.05 s leaves 3 samples"), "{few}");
        assert!(!notes(&format!("{pressed}'5 ms'")).contains("samples"));
    }

    #[test]
    fn a_base_within_a_cell_is_doubted_with_the_depths_of_the_faces() {
        let held = |depth: &str| notes(&format!("forward = {{ speed = '0.1 m/s' }}\nsinkage = '{depth}'"));
        let within = held("33 mm");
        assert!(within.contains("body.plate: its base lies 0.36 cells inside a cell"), "{within}");
        assert!(within.contains("a sinkage of 25 mm or 37.5 mm"), "{within}");
        assert!(!held("25 mm").contains("inside a cell"));
    }

    #[test]
    fn a_weight_that_no_soil_bears_is_doubted() {
        let said = |weight: &str| notes(&format!("weight = '{weight}'\nheave = 'free'"));
        assert!(said("100 MN").contains("body.plate: it is pressed down with 1e8 N"), "{}", said("100 MN"));
        assert!(!said("5 kN").contains("no soil bears"));
    }

    #[test]
    fn ploughing_soil_without_a_strength_is_doubted() {
        let notes = |more: &str, law: &str| {
            let text = format!(
                "format = 2\nsoil = {{ {law}, unit_weight = '15 kN/m^3', young_modulus = '1 MPa', poisson_ratio = 0.3 }}\n\
                 domain = {{ x = ['-0.3 m', '0.3 m'], y = ['-0.3 m', '0.3 m'], z = ['-0.3 m', '0.2 m'] }}\ngrid = {{ cell = '12.5 mm', growth = 1.3 }}\n\
                 run = {{ duration = '0.5 s' }}\n[body.plate]\nshape = 'block'\nsize = ['0.1 m', '0.1 m', '0.05 m']\nfriction = 0.3\n{more}\n"
            );
            advice(&parse(&text, "case.toml", &[]).unwrap()).join("\n")
        };
        let (words, elastic) = ("plate: is moved by", "law = 'elastic'");
        for (more, law, is_doubted) in [
            ("sinkage = '40 mm'\nforward = { speed = '0.2 m/s' }", elastic, true),
            (
                "sinkage = '40 mm'\nforward = { speed = '0.2 m/s' }",
                "law = 'tresca', shear_strength = '2 kPa'",
                false,
            ),
            ("sinkage = '40 mm'\nforward = { displacement = '20 mm', ramp = '0.4 s' }", elastic, false),
            ("heave = { displacement = '-60 mm', ramp = '0.4 s' }", elastic, true),
            ("forward = { speed = '0.2 m/s' }\nheave = { load = '0 N' }\nweight = '20 N'", elastic, false),
        ] {
            assert_eq!(notes(more, law).contains(words), is_doubted, "{more}, {law}: {}", notes(more, law));
        }
    }
}
