//! A case as input of the closed-form models: one body, or a row of equal discs, in level soil of Mohr and
//! Coulomb or in clay.

use super::carried::touching;
use super::direction::along_the_tow;
use super::towed::{Course, bodies, body, course};
use analytic::bearing::Method;
use analytic::disc::Drive;
use analytic::forecast::Body;
use analytic::wheel::PressureSinkage;
use analytic::{Load, Soil, Towing};
use case::path::travel;
use case::resolved::{Body as Towed, Case, Factors, Ground, Measured, Motion};
use case::soil::Strength;
use input::quantity::short;
use results::history::reference::Reference;

/// The input of the closed-form models, and the assumptions made to obtain it.
#[derive(Clone, Debug)]
pub struct ModelInput {
    /// Names of the bodies: one, or several equal discs.
    pub bodies: Vec<String>,
    /// Kind of the bodies, in one word.
    pub kind: &'static str,
    /// The body under tow.
    pub towing: Towing,
    /// Whether the body is towed along −x, so that the models are given its mirror image.
    pub mirrored: bool,
    /// Load on a free heave in addition to the weight m g, downwards [N].
    pub extra_load: f64,
    /// The assumptions, in words.
    pub remarks: Vec<String>,
}

/// The input of the closed-form models for a case.
///
/// # Errors
/// The reason, in words, why they do not apply.
pub fn model_input(case: &Case) -> Result<ModelInput, String> {
    is_plain(case)?;
    let mut remarks = Vec::new();
    let staged = case.steady_stage().map(|_| case.in_steady_stage()).transpose()?;
    if let Some(stage) = case.steady_stage() {
        remarks.push(format!("stage `{}` of the run", case.stages[stage].name));
    }
    let case = staged.as_ref().unwrap_or(case);
    let touching = along_the_tow(touching(case, &mut remarks), &mut remarks);
    let (bodies, assembly) = bodies(&touching, &mut remarks)?;
    let first = *bodies.first().ok_or("the case has no body that can touch the soil")?;
    no_lateral_tow(&bodies)?;
    let course = course(case, first)?;
    if case.domain.plane_strain {
        remarks.push("plane strain: weights and forces are those per metre of width".into());
    }
    let (mut body, kind) = body(case, first, course, &mut remarks)?;
    let ground = ground(case, &body)?;
    let soil = soil(case, first, &mut remarks)?;
    suits_clay(&soil, &body, course)?;
    let count = bodies.len() as f64;
    let load = match course {
        Course::Raised => lifted_from(first, &ground, &mut remarks)?,
        _ => load(case, first, &ground, count, &mut remarks)?,
    };
    if let (Body::Block(block), Load::Sinkage(z)) = (&mut body, load) {
        block.has_base = z < ground.depth() * (1.0 - 1e-9);
    }
    let drive = drive_of(first, &body, course)?;
    let is_towed = !matches!(course, Course::Pressed | Course::Raised);
    if is_towed && drive == Drive::Locked && !matches!(first.spin(), Motion::Fixed) {
        remarks.push(format!("`{}` may rotate; the models assume that it does not", first.name));
    }
    let mut towing = Towing::new(soil, body, load, drive);
    (towing.pressed, towing.raised) = (!is_towed, course == Course::Raised);
    towing.assembly = assembly;
    if matches!(towing.body, Body::Faceted(_) | Body::Plate(_)) {
        let reference = Reference::of(case, first);
        towing.reference = Some([reference.length, reference.width]);
    }
    if towing.pressed && towing.assembly.is_some() {
        return Err(
            "several bodies are pressed down or pulled up; the closed forms are for one of them".into()
        );
    }
    towing.elastic_modulus = Some(case.soil.young_modulus);
    (towing.poisson_ratio, towing.rest_pressure) = (case.soil.poisson_ratio, case.soil.k0);
    add_measured(&mut towing, &case.forecast, &mut remarks);
    remarks.extend(unused_keys(&towing, kind).into_iter().chain(inertia(case, first)));
    if case.gravity > 0.0 {
        towing.gravity = case.gravity;
    }
    let extra_load = match first.translation[2] {
        Motion::Free { load, .. } => -load * count,
        _ => 0.0,
    };
    let bodies = bodies.iter().map(|b| b.name.clone()).collect();
    let mirrored = course == Course::TowedBackwards;
    Ok(ModelInput { bodies, kind, towing, mirrored, extra_load, remarks })
}

/// What is said of a motion so fast that inertia counts, which no closed form contains.
fn inertia(case: &Case, body: &Towed) -> Option<String> {
    let case::Inertia { froude, depth, share } = case::inertia(case, body)?;
    Some(format!(
        "`{}` moves at a Froude number v²/(g z) of {froude:.2} (z = {depth:.3} m): the soil's inertia, which no closed form \
         contains, adds some {:.0} % to the force",
        body.name,
        100.0 * share
    ))
}

/// Refuses ground that is not that of the closed forms: level, and of one uniform soil.
fn is_plain(case: &Case) -> Result<(), String> {
    if !case.layers.is_empty() {
        return Err("the ground lies in layers, and the closed forms are for one soil; run the solver".into());
    }
    if !case.slope.is_level() {
        return Err("the ground slopes, and the closed forms are for level ground; run the solver".into());
    }
    if !case.is_even() {
        return Err("the ground is uneven or has soil bodies in it, and the closed forms are for level ground of one soil; run the solver".into());
    }
    if case.soil.density_gradient() > 0.0 {
        return Err("the density of the sand grows with depth; the closed forms are for a uniform one: give the mean over the depth that the \
                    body disturbs, without relative_density_gradient"
            .into());
    }
    Ok(())
}

/// Refuses a body that is moved or loaded sideways otherwise than by a tow at given speeds.
fn no_lateral_tow(bodies: &[&Towed]) -> Result<(), String> {
    let is_moved = |b: &&&Towed| match b.translation[1] {
        Motion::Prescribed { speed, .. } => speed != 0.0,
        Motion::Course(_) => true,
        Motion::Free { load, .. } => load != 0.0,
        Motion::Fixed => false,
    };
    match bodies.iter().find(is_moved) {
        Some(body) => Err(format!(
            "`{}` moves sideways (lateral), but not in the one direction in which all bodies are towed at given speeds; write \
             lateral = \"fixed\" for a forecast of the motion along x, or run the solver",
            body.name
        )),
        None => Ok(()),
    }
}

/// A remark on the keys of `[forecast]` that no model of such a body uses.
fn unused_keys(towing: &Towing, kind: &str) -> Option<String> {
    let is_round = matches!(towing.body, Body::Faceted(_));
    let given = [
        ("bow_wave", towing.bow_wave_fraction != 0.0),
        ("backfill", is_round && towing.backfill != 0.0),
        ("factors", is_round && towing.method != Method::default()),
        ("cone_index", towing.cone_index.is_some()),
        ("plate constants", towing.terrain.is_some()),
    ];
    let unused: Vec<&str> = given.iter().filter(|(_, given)| *given).map(|(key, _)| *key).collect();
    (towing.body.disc().is_none() && !unused.is_empty())
        .then(|| format!("no model of a {kind} uses {} in [forecast]", unused.join(", ")))
}

/// Adds the parameters of the section `[forecast]`.
fn add_measured(towing: &mut Towing, measured: &Measured, remarks: &mut Vec<String>) {
    (towing.bow_wave_fraction, towing.backfill) = (measured.bow_wave, measured.backfill);
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
        shear_modulus: plate.shear_deformation_modulus,
    });
    if let Some(name) = &plate.name {
        remarks.push(format!("plate constants of {name}, as published; c and φ are those of the case"));
    }
}

/// The level ground in front of the body.
struct LevelGround {
    /// Height of the surface of the ground [m].
    surface: f64,
    /// Height of the floor [m].
    floor: f64,
}

impl LevelGround {
    /// Depth of the soil [m].
    fn depth(&self) -> f64 {
        self.surface - self.floor
    }
}

/// The ground; for a block also a bank of soil, with its height.
fn ground(case: &Case, body: &Body) -> Result<LevelGround, String> {
    if case.overburden > 0.0 {
        return Err("the soil is under an overburden; the models are for a free surface".into());
    }
    match case.ground {
        Ground::Level { surface } => Ok(LevelGround { surface, floor: case.domain.low.z }),
        Ground::Column { low, high, radius: None } if body.block().is_some() => {
            Ok(LevelGround { surface: high.z, floor: low.z.max(case.domain.low.z) })
        }
        Ground::Column { .. } => Err("the soil is heaped up; the models are for level ground".into()),
    }
}

fn soil(case: &Case, body: &Towed, remarks: &mut Vec<String>) -> Result<Soil, String> {
    let unit_weight = case.soil.unit_weight;
    let Strength { friction_angle, dilation_angle, cohesion, gradient } =
        case.soil.for_closed_forms(remarks)?;
    if unit_weight <= 0.0 && friction_angle > 0.0 {
        return Err("the soil is weightless; in the closed forms strength comes from weight".into());
    }
    let body_friction = friction_of(body, friction_angle, remarks);
    let adhesion_factor = if friction_angle > 0.0 { 1.0 } else { body.adhesion_factor.clamp(0.0, 1.0) };
    Ok(Soil {
        friction_angle,
        dilation_angle,
        cohesion,
        unit_weight,
        body_friction,
        adhesion_factor,
        strength_gradient: gradient,
    })
}

/// Friction of the soil of this friction angle [rad] on the body.
fn friction_of(body: &Towed, friction_angle: f64, remarks: &mut Vec<String>) -> f64 {
    if body.friction.is_finite() {
        body.friction
    } else if friction_angle > 0.0 {
        remarks.push("rough surface: friction tan φ".into());
        friction_angle.tan()
    } else {
        remarks.push("rough surface: shear stress up to s_u".into());
        1.0
    }
}

/// Refuses a body for which there is no closed form in undrained clay, with the reason for its kind.
fn suits_clay(soil: &Soil, body: &Body, course: Course) -> Result<(), String> {
    let why = match body {
        _ if !soil.is_undrained() => return Ok(()),
        Body::Block(_) if course == Course::Pressed => {
            "a block whose base is not level presses on clay with two faces at once, for which no factor is published"
        }
        Body::Block(_) => {
            "a blade is held by a wedge of clay before it and by shear at its sides, and where its top is buried the clay flows round it; no \
             published form spans the two and has been compared with measurements"
        }
        Body::Faceted(body) if body.axle.direction[1].abs() < 1.0 - 1e-9 => {
            "on a yawed or tilted disc the clay is cut by one flank and leaves a gap behind the other; how they share the force is not \
             published in closed form"
        }
        Body::Faceted(_) if course == Course::Towed || course == Course::TowedBackwards => {
            "bearing factors in clay are known for discs and wheels across the tow, not for another surface under tow"
        }
        Body::Faceted(_) => {
            "bearing factors in clay are known for level bases, cones, discs and pipes, not for another surface that is pressed down"
        }
        Body::Disc(_) | Body::Plate(_) | Body::Cone(_) | Body::Pipe(_) => return Ok(()),
    };
    Err(format!("the soil is undrained clay: {why}; run the solver"))
}

/// Where a body that is pulled up begins, by its lowest point.
fn lifted_from(body: &Towed, ground: &LevelGround, remarks: &mut Vec<String>) -> Result<Load, String> {
    let depth = ground.surface - (body.position.z + body.bounds().0.z);
    if depth <= 0.0 {
        return Err(format!("`{}` is pulled up and does not reach into the soil", body.name));
    }
    remarks.push(format!(
        "`{}` is pulled up: the force is that of the soil where it begins, with its lowest point at a depth of {depth:.4} m; its own weight \
         is not part of it",
        body.name
    ));
    Ok(Load::Sinkage(depth))
}

/// The load of a free heave, or the deepest sinkage [m] that the motion prescribes.
fn load(
    case: &Case,
    body: &Towed,
    ground: &LevelGround,
    count: f64,
    remarks: &mut Vec<String>,
) -> Result<Load, String> {
    let name = &body.name;
    let start = ground.surface - (body.position.z + body.bounds().0.z);
    let heave = &body.translation[2];
    match body.pressing_force(case.weight(body)) {
        Some(load) if load > 0.0 => return Ok(Load::Weight(load * count)),
        Some(_) => {
            return Err(format!(
                "`{name}` is not pressed into the soil: its weight and load are not directed downwards"
            ));
        }
        None => {}
    }
    let steps = 200;
    let at = |n: u32| start - travel(heave, case.duration * f64::from(n) / f64::from(steps));
    let deepest = (0..=steps).map(at).fold(f64::NEG_INFINITY, f64::max);
    if deepest <= 0.0 {
        return Err(format!("`{name}` never moves below the surface of the soil"));
    }
    let soil = ground.depth();
    if deepest >= soil {
        remarks.push(format!(
            "`{name}` extends through the soil to its floor: a sinkage of {} m, the whole depth of the soil",
            short(soil)
        ));
        return Ok(Load::Sinkage(soil));
    }
    remarks.push(format!(
        "the heave of `{name}` is prescribed: evaluated at its deepest position, a sinkage of {} m",
        short(deepest)
    ));
    Ok(Load::Sinkage(deepest))
}

/// How a body is driven, as far as its models know: one that cannot roll, or moves straight down or up, is
/// locked.
fn drive_of(towed: &Towed, body: &Body, course: Course) -> Result<Drive, String> {
    Ok(match body {
        _ if matches!(course, Course::Pressed | Course::Raised) => Drive::Locked,
        Body::Block(_) | Body::Plate(_) | Body::Cone(_) | Body::Pipe(_) => Drive::Locked,
        Body::Disc(_) => drive(towed, 0.5 * body.length())?,
        Body::Faceted(_) if towed.shape.rolling_diameter().is_some() => drive(towed, 0.5 * body.length())?,
        Body::Faceted(_) => Drive::Locked,
    })
}

/// The condition at the axle of a body of this radius [m]; a prescribed rotation gives the slip.
fn drive(body: &Towed, radius: f64) -> Result<Drive, String> {
    match (body.spin(), &body.translation[0]) {
        (Motion::Free { load, .. }, _) if *load > 0.0 => Ok(Drive::Driven(*load)),
        (Motion::Free { load, .. }, _) if *load < 0.0 => Ok(Drive::Braked(-load)),
        (Motion::Free { .. }, _) => Ok(Drive::Free),
        (Motion::Fixed, _) => Ok(Drive::Locked),
        (Motion::Prescribed { speed: spin, .. }, Motion::Prescribed { speed, .. }) if *speed != 0.0 => {
            let rolling_speed = speed * body.attitude.yaw.cos();
            Ok(Drive::Slip(analytic::slip(spin * radius / rolling_speed)))
        }
        _ => Err(format!(
            "`{}` rotates at a given rate, but is not towed at a given speed: its slip is unknown",
            body.name
        )),
    }
}
