//! A body that is pressed straight down: a plate, a disc that does not roll, any body by its facets.

use super::other_models::{PRESSED, RAISED};
use super::pushed::{held, pushed};
use super::{Body, Candidate, Load, Outline, Penetrometer, Plate, Prediction, Towing};
use crate::bearing::{
    Footing, growth_of_factor, round_over_square, undrained_factor, weight_factor_exact_smooth,
    weight_factor_martin_rough,
};
use crate::capacity::ultimate_pressure;
use crate::disc::{Disc, equilibrium_depth, indentation_force};
use crate::error::{ModelResult, undefined};
use crate::resistive::{Facet, Motion, PlanarLaw, SpatialLaw, Traction, rim_facets, wrench};

/// Width over breadth that stands for an infinite strip.
const STRIP: f64 = 1e9;
/// Friction of the base over tan φ from which it counts as rough (chosen: a rough base needs no more than
/// about half of it).
const ROUGH: f64 = 0.5;

/// The prediction of one model: the vertical force at a sinkage, or the sinkage under a load.
///
/// # Errors
/// If the model cannot be applied to the body, its input is out of range, or no sinkage carries the load.
pub(super) fn predict(model: Candidate, towing: &Towing) -> ModelResult<Prediction> {
    if towing.raised || model == Candidate::Uplift {
        return lifted(model, towing);
    }
    if model == Candidate::Penetration {
        return penetrated(towing);
    }
    let carried = force(model, towing)?;
    let (vertical, sinkage) = match towing.load {
        Load::Sinkage(z) => (carried(z)?, z),
        Load::Weight(weight) => (weight, equilibrium(towing, weight, &*carried)?),
    };
    Ok(Prediction::of_forces(0.0, vertical, Some(sinkage)))
}

/// A body that is pulled up: the soil holds it down.
fn lifted(model: Candidate, towing: &Towing) -> ModelResult<Prediction> {
    match towing.load {
        _ if !towing.raised => undefined(model.name(), RAISED),
        _ if model != Candidate::Uplift => undefined(model.name(), PRESSED),
        Load::Sinkage(z) => Ok(Prediction::of_forces(0.0, -held(towing, z)?, Some(z))),
        Load::Weight(_) => {
            undefined(model.name(), "it gives the force that holds a body, not where it comes to rest")
        }
    }
}

/// A cone or a pile, with the pressure on its end.
fn penetrated(towing: &Towing) -> ModelResult<Prediction> {
    // Sand bears nothing at its surface, where it has no stress.
    let carried = |z: f64| if z > 0.0 { Ok(pushed(towing, z)?.0) } else { Ok(0.0) };
    let (z, weight) = match towing.load {
        Load::Sinkage(z) => (z, None),
        Load::Weight(weight) => (equilibrium(towing, weight, &carried)?, Some(weight)),
    };
    let (vertical, end) = pushed(towing, z)?;
    let forces = Prediction::of_forces(0.0, weight.unwrap_or(vertical), Some(z));
    Ok(Prediction { end_pressure: Some(end), ..forces })
}

/// The least sinkage [m] that carries the weight [N]; 0 where the ground carries it at its surface.
fn equilibrium(towing: &Towing, weight: f64, carried: &dyn Fn(f64) -> ModelResult<f64>) -> ModelResult<f64> {
    let height = towing.body.height();
    // Evaluated once beforehand, so that an input out of range is reported as such.
    carried(0.1 * height)?;
    if matches!(towing.body, Body::Plate(_)) && carried(0.0)? >= weight {
        return Ok(0.0);
    }
    equilibrium_depth(height, weight, 1e-12, |z| carried(z).unwrap_or(f64::NAN)).or_else(|(most, _)| {
        undefined("the equilibrium sinkage", format!("the soil carries at most {:.3} N", most.max(0.0)))
    })
}

type Force<'a> = Box<dyn Fn(f64) -> ModelResult<f64> + 'a>;

/// The vertical force [N] as a function of the sinkage [m].
fn force(model: Candidate, towing: &Towing) -> ModelResult<Force<'_>> {
    match model {
        Candidate::Footing => footing(towing),
        Candidate::SpatialResistive => {
            let (soil, friction) = (&towing.soil, towing.soil.body_friction);
            resistive(SpatialLaw::new(soil.friction_angle, soil.unit_weight, friction)?, towing, |facet| {
                *facet
            })
        }
        Candidate::PlanarResistive => {
            resistive(PlanarLaw::new(super::other_models::plate_stiffness(towing)?)?, towing, Facet::sliced)
        }
        Candidate::Bekker => bekker(towing),
        Candidate::Pipe => pipe(towing),
        _ => undefined(model.name(), "it is for a body under tow"),
    }
}

fn footing(towing: &Towing) -> ModelResult<Force<'_>> {
    match &towing.body {
        Body::Plate(plate) => Ok(Box::new(move |z| capacity(towing, plate, z))),
        Body::Disc(disc) => Ok(Box::new(move |z| indentation_force(&towing.soil, disc, z, towing.method))),
        Body::Pipe(pipe) if !towing.soil.is_undrained() => {
            let thickness = if pipe.plane_strain { STRIP * pipe.diameter } else { pipe.length };
            let (disc, part) = (Disc { diameter: pipe.diameter, thickness }, pipe.length / thickness);
            Ok(Box::new(move |z| Ok(part * indentation_force(&towing.soil, &disc, z, towing.method)?)))
        }
        Body::Pipe(_) => {
            undefined(Candidate::Footing.name(), "of a pipe in clay more is known: see the model of a pipe")
        }
        Body::Block(_) | Body::Faceted(_) | Body::Cone(_) => undefined(
            Candidate::Footing.name(),
            "it is for a level base, or the rim of a disc; this body has neither",
        ),
    }
}

/// Bearing capacity [N] of a level plate at a sinkage [m].
fn capacity(towing: &Towing, plate: &Plate, z: f64) -> ModelResult<f64> {
    let soil = &towing.soil;
    let width = plate.breadth();
    let length = match plate.outline {
        Outline::Strip => STRIP * width,
        Outline::Rectangle | Outline::Circle => plate.width.max(plate.length),
    };
    let pressure =
        ultimate_pressure(soil, &Footing { width, length, depth: z, load_inclination: 0.0 }, towing.method)?;
    let base = pressure.base * base_ratio(towing, plate)?;
    let grown = growing_base(towing, plate, z, length)?;
    Ok((grown.unwrap_or(base) + pressure.by_depth * z) * plate.area())
}

/// Pressure [Pa] without the overburden under a base on clay whose strength grows with depth; `None` where it
/// does not.
///
/// s_u [N_c s_c (1 + 0.2 D/B s̄/s_u) + ΔN], with the strength s_u at the base and s̄ the mean above it, which
/// the depth factor is about (as ISO 19901-4 has it), and ΔN of [`growth_of_factor`].
fn growing_base(towing: &Towing, plate: &Plate, z: f64, length: f64) -> ModelResult<Option<f64>> {
    let soil = &towing.soil;
    if !soil.is_undrained() || soil.strength_gradient == 0.0 {
        return Ok(None);
    }
    let width = plate.breadth();
    let strength = soil.strength_at(z);
    let at = |depth: f64| undrained_factor(&Footing { width, length, depth, load_inclination: 0.0 });
    let (surface, deep) = (at(0.0)?, at(z)?);
    let depth_gain = (deep - surface) * soil.strength_at(0.5 * z) / strength;
    let growth = growth_of_factor(soil.strength_gradient * width / strength, width / length)?;
    Ok(Some(strength * ((surface + depth_gain) * base_ratio(towing, plate)? + growth)))
}

/// A pipe in clay [N].
fn pipe(towing: &Towing) -> ModelResult<Force<'_>> {
    let Body::Pipe(pipe) = &towing.body else {
        return undefined(
            Candidate::Pipe.name(),
            "it is for a pipe: a lying cylinder at least three diameters long",
        );
    };
    if !towing.soil.is_undrained() {
        return undefined(Candidate::Pipe.name(), "it is for undrained clay");
    }
    let roughness = towing.soil.roughness_of_clay();
    Ok(Box::new(move |z| {
        Ok(pipe.length * crate::pipe::pipe_penetration(&towing.soil, pipe.diameter, z, roughness)?)
    }))
}

/// What a base that is not rough, and in clay a round one, does to the pressure at the surface.
///
/// In sand the smooth strip's N_γ over the rough one's, both exact, with the friction of the base in between;
/// without effect on the cohesion term, which is nearly independent of it. In clay N_c of a circle over that
/// of a square.
fn base_ratio(towing: &Towing, plate: &Plate) -> ModelResult<f64> {
    let soil = &towing.soil;
    if soil.is_undrained() {
        let is_round = plate.outline == Outline::Circle;
        return Ok(if is_round { round_over_square(soil.roughness_of_clay()) } else { 1.0 });
    }
    if soil.cohesion > 0.0 {
        return Ok(1.0);
    }
    let phi = soil.friction_angle;
    let roughness = (soil.body_friction / (ROUGH * phi.tan())).min(1.0);
    let smooth = weight_factor_exact_smooth(phi)? / weight_factor_martin_rough(phi)?;
    Ok(smooth.powf(1.0 - roughness))
}

/// The vertical force of a traction law; `projected` maps facets to those of the law.
fn resistive<'a>(
    law: impl Traction + 'a,
    towing: &'a Towing,
    projected: fn(&Facet) -> Facet,
) -> ModelResult<Force<'a>> {
    if towing.soil.cohesion > 0.0 {
        return undefined("resistive force theory", "it is for cohesionless soil");
    }
    const DOWN: [f64; 3] = [0.0, 0.0, -1.0];
    let sum = move |facets: &[Facet], height: f64| {
        wrench(&law, facets, &Motion { height, velocity: DOWN, spin: [0.0; 3] }).force[2]
    };
    Ok(match &towing.body {
        Body::Plate(plate) => {
            let base = [Facet { centroid: [0.0; 3], normal: DOWN, area: plate.area(), half_height: 0.0 }];
            Box::new(move |z| Ok(sum(&base, -z)))
        }
        Body::Disc(_) | Body::Pipe(_) => Box::new(move |z| {
            let disc = &Disc { diameter: towing.body.length(), thickness: towing.body.width() };
            let angle = disc.contact(z, 0.0)?.angle;
            // The upper half of a disc moves away from the soil.
            let angle = angle.min(std::f64::consts::FRAC_PI_2);
            let half: Vec<Facet> = rim_facets(disc, 0.0, angle).iter().map(projected).collect();
            Ok(2.0 * sum(&half, 0.5 * disc.diameter - z))
        }),
        Body::Block(block) => {
            let facets = block.facets().map(|facet| projected(&facet));
            Box::new(move |z| Ok(sum(&facets, 0.5 * block.height() - z)))
        }
        Body::Faceted(body) | Body::Cone(Penetrometer { surface: body, .. }) => {
            let facets: Vec<Facet> = body.facets.iter().map(projected).collect();
            Box::new(move |z| Ok(sum(&facets, body.below - z)))
        }
    })
}

/// Bekker's plate: p = (k_c/b + k_φ) zⁿ, b the shorter side. Source: Bekker (1956).
fn bekker(towing: &Towing) -> ModelResult<Force<'_>> {
    let Body::Plate(plate) = &towing.body else {
        return undefined(Candidate::Bekker.name(), "pressed straight down it is for a plate");
    };
    let Some(terrain) = &towing.terrain else {
        return undefined("Bekker's plate", "no plate constants (k_c, k_φ, n) are given");
    };
    let stiffness = terrain.cohesive / plate.breadth() + terrain.frictional;
    Ok(Box::new(move |z| Ok(stiffness * z.powf(terrain.exponent) * plate.area())))
}
