//! A case as the closed forms take it: one disc, or a row of equal ones, in level Mohr–Coulomb soil.

use crate::case::resolved::{Body, Case, Factors, Freedom, Ground, Law, Measured, Shape};
use crate::case::travel;
use analytic::bearing::Method;
use analytic::disc::{Assembly, Disc, Drive};
use analytic::wheel::PressureSinkage;
use analytic::{Load, Soil, Towing};

/// A case in the form of the models, and what had to be decided for that.
#[derive(Clone, Debug)]
pub struct Setting {
    /// Names of the discs.
    pub discs: Vec<String>,
    /// The disc under tow.
    pub towing: Towing,
    /// Load on a free heave besides the weight m g, downwards [N].
    pub extra_load: f64,
    /// What was decided, in words.
    pub remarks: Vec<String>,
}

/// Brings a case to the form of the models.
///
/// # Errors
/// The reason, in words, why they cannot take it.
pub fn setting(case: &Case) -> Result<Setting, String> {
    let mut remarks = Vec::new();
    let (bodies, assembly) = discs(case, &mut remarks)?;
    let surface = level_surface(case)?;
    let first = *bodies.first().ok_or("the case has no disc")?;
    let Shape::Disc { diameter, thickness } = first.shape else {
        return Err(format!("`{}` is no disc", first.name));
    };
    let soil = soil(case, first, &mut remarks)?;
    let count = bodies.len() as f64;
    let load = load(case, first, surface, diameter, count, &mut remarks)?;
    let drive = drive(first)?;
    if matches!(first.translation[0], Freedom::Fixed) {
        remarks.push(format!("the case does not tow `{}`; the forces are those of a steady tow", first.name));
    }
    let mut towing = Towing::new(soil, Disc { diameter, thickness }, load, drive);
    towing.assembly = assembly;
    towing.elastic_modulus = Some(case.soil.young_modulus);
    add_measured(&mut towing, &case.forecast, &mut remarks);
    if case.gravity > 0.0 {
        towing.gravity = case.gravity;
    }
    let extra_load = match (load, case.gravity) {
        (Load::Weight(weight), gravity) => weight - count * first.mass * gravity,
        _ => 0.0,
    };
    Ok(Setting { discs: bodies.iter().map(|b| b.name.clone()).collect(), towing, extra_load, remarks })
}

/// What the section `[forecast]` of the case says.
fn add_measured(towing: &mut Towing, measured: &Measured, remarks: &mut Vec<String>) {
    (towing.heap_fraction, towing.backfill) = (measured.heap, measured.backfill);
    (towing.cone_index, towing.plate_stiffness) = (measured.cone_index, measured.plate_stiffness);
    towing.method = match measured.factors {
        Factors::Meyerhof => Method::Meyerhof,
        Factors::HansenVesic => Method::HansenVesic,
        Factors::Lyamin => Method::Lyamin,
    };
    let Some(plate) = &measured.plate else { return };
    towing.terrain = Some(PressureSinkage {
        exponent: plate.exponent,
        cohesive: plate.cohesive,
        frictional: plate.frictional,
        cohesion: towing.soil.cohesion,
        friction_angle: towing.soil.friction_angle,
        shear_modulus: plate.shear_displacement,
    });
    if let Some(name) = &plate.name {
        remarks.push(format!("plate constants of {name}, as published; c and φ are those of the case"));
    }
}

/// Height of the soil's surface [m].
fn level_surface(case: &Case) -> Result<f64, String> {
    if case.domain.plane_strain {
        return Err("the case is plane strain; the models are for a disc of finite thickness".into());
    }
    match case.ground {
        Ground::Level { surface } => Ok(surface),
        Ground::Column { .. } => Err("the soil is heaped up in a box; the models need level ground".into()),
    }
}

/// The discs of the case: one, or several equal ones side by side, which count as an assembly on one axle.
fn discs<'a>(case: &'a Case, remarks: &mut Vec<String>) -> Result<(Vec<&'a Body>, Option<Assembly>), String> {
    let is_disc = |b: &&Body| matches!(b.shape, Shape::Disc { .. });
    let mut discs: Vec<&Body> = case.bodies.iter().filter(is_disc).collect();
    if discs.is_empty() {
        return Err("the case has no disc; the closed forms are for discs under tow (for an upright face: coulter pressure)".into());
    }
    if let Some(other) = case.bodies.iter().find(|b| !is_disc(b)) {
        return Err(format!("`{}` moves beside the disc; the closed forms know discs only", other.name));
    }
    discs.sort_by(|a, b| a.position.y.total_cmp(&b.position.y));
    let Some([first, second]) = discs.first_chunk::<2>().copied() else { return Ok((discs, None)) };
    let spacing = second.position.y - first.position.y;
    let alike = |b: &&Body| {
        b.shape == first.shape
            && b.friction == first.friction
            && b.translation == first.translation
            && b.spin == first.spin
            && (b.position.x - first.position.x).abs() < 1e-9
            && (b.position.z - first.position.z).abs() < 1e-9
    };
    let even = discs.windows(2).all(|pair| {
        let gap = pair[1].position.y - pair[0].position.y;
        (gap - spacing).abs() < 1e-6 * spacing
    });
    if !(discs.iter().all(alike) && even && spacing > 0.0) {
        return Err(format!(
            "the case has {} discs that are not alike or not evenly spaced side by side; the closed forms know one \
             disc, or a row of equal ones",
            discs.len()
        ));
    }
    let count = discs.len();
    remarks.push(format!(
        "{count} equal discs at a spacing of {:.4} m: taken as one assembly; drag, vertical force and weight are those \
         of all of them",
        spacing
    ));
    let assembly = Assembly { count: u32::try_from(count).unwrap_or(u32::MAX), spacing };
    Ok((discs, Some(assembly)))
}

fn soil(case: &Case, body: &Body, remarks: &mut Vec<String>) -> Result<Soil, String> {
    let Law::MohrCoulomb { friction_angle, dilation_angle, cohesion, .. } = case.soil.law else {
        let law = if matches!(case.soil.law, Law::Elastic) { "elastic" } else { "undrained (tresca)" };
        return Err(format!("the soil is {law}; the closed forms are for Mohr-Coulomb soil"));
    };
    if case.soil.unit_weight <= 0.0 {
        return Err("the soil is weightless; the strength of the closed forms comes from its weight".into());
    }
    let body_friction = if body.friction.is_finite() {
        body.friction
    } else {
        remarks.push("a rough surface: friction tan φ".into());
        friction_angle.tan()
    };
    let unit_weight = case.soil.unit_weight;
    Ok(Soil { friction_angle, dilation_angle, cohesion, unit_weight, body_friction })
}

/// The load of a free heave, or the deepest sinkage [m] that the motion prescribes.
fn load(
    case: &Case,
    body: &Body,
    surface: f64,
    diameter: f64,
    count: f64,
    remarks: &mut Vec<String>,
) -> Result<Load, String> {
    let name = &body.name;
    let start = surface - (body.position.z - 0.5 * diameter);
    let heave = &body.translation[2];
    match *heave {
        Freedom::Free { load, .. } if load < 0.0 => return Ok(Load::Weight(-load * count)),
        Freedom::Free { .. } => {
            return Err(format!(
                "nothing presses `{name}` into the soil: its weight and load are not downwards"
            ));
        }
        Freedom::Fixed => {}
        Freedom::Prescribed { .. } => {}
    }
    let steps = 200;
    let at = |n: u32| start - travel(heave, case.duration * f64::from(n) / f64::from(steps));
    let deepest = (0..=steps).map(at).fold(f64::NEG_INFINITY, f64::max);
    if deepest <= 0.0 {
        return Err(format!("`{name}` never comes below the surface of the soil"));
    }
    remarks.push(format!(
        "the heave of `{name}` is prescribed: held at its deepest position, a sinkage of {:.4} m",
        deepest
    ));
    Ok(Load::Sinkage(deepest))
}

/// What happens at the axle; a prescribed turn is a slip.
fn drive(body: &Body) -> Result<Drive, String> {
    match (&body.spin, &body.translation[0]) {
        (Freedom::Free { load, .. }, _) if *load > 0.0 => Ok(Drive::Driven(*load)),
        (Freedom::Free { load, .. }, _) if *load < 0.0 => Ok(Drive::Braked(-load)),
        (Freedom::Free { .. }, _) => Ok(Drive::Free),
        (Freedom::Fixed, _) => Ok(Drive::Locked),
        (Freedom::Prescribed { speed: spin, .. }, Freedom::Prescribed { speed, .. }) if *speed != 0.0 => {
            let Shape::Disc { diameter, .. } = body.shape else { return Err("no disc".into()) };
            Ok(Drive::Slip(spin * 0.5 * diameter / speed - 1.0))
        }
        _ => Err(format!(
            "`{}` is turned at a given rate, but not towed at one: its slip is unknown",
            body.name
        )),
    }
}
