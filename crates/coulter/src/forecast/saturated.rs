//! A blade that cuts saturated sand, and a plough, under water.

use super::model_input::ModelInput;
use analytic::cutting::{Blade, PloughCoefficients, PloughForce, SaturatedCut};
use analytic::forecast::{Body, FacetedBody, Front};
use analytic::resistive::Facet;
use analytic::{Load, PoreWater};
use case::Case;
use case::resolved::Plough;
use std::f64::consts::FRAC_PI_2;

/// A blade in saturated sand, with a third of the suction, with it and with three times as much.
#[derive(Clone, Debug)]
pub struct BladeUnderWater {
    /// Blade angle [rad].
    pub angle: f64,
    /// Thickness of the layer that the blade cuts [m].
    pub depth: f64,
    /// The cuts of the blade; or why there are none, in words.
    pub cuts: Result<[SaturatedCut; 3], String>,
}

impl BladeUnderWater {
    /// The blade for a body with a plane front that is towed at a depth and a speed [m/s]; `None` for any
    /// other body.
    pub(super) fn of(input: &ModelInput, pores: &PoreWater, speed: f64, factors: [f64; 3]) -> Option<Self> {
        let towing = &input.towing;
        let (front, width) = match &towing.body {
            _ if towing.pressed => return None,
            Body::Block(block) => (block.front(), block.size[1]),
            Body::Faceted(body) => plane_front(body)?,
            Body::Disc(_) | Body::Plate(_) | Body::Cone(_) | Body::Pipe(_) => return None,
        };
        let mut found = Self {
            angle: front.rake,
            depth: f64::NAN,
            cuts: Err("it is for a blade at a given depth".into()),
        };
        let Load::Sinkage(sinkage) = towing.load else { return Some(found) };
        found.depth = sinkage - front.lower_edge;
        let blade = Blade { width, depth: found.depth, rake: front.rake, surcharge: 0.0 };
        let height = front.upper_edge - front.lower_edge;
        let at = |times: f64| pores.cut(&towing.soil, &blade, height, speed, times);
        let cuts = at(factors[0]).and_then(|low| Ok([low, at(factors[1])?, at(factors[2])?]));
        found.cuts = cuts.map_err(|why| why.to_string());
        Some(found)
    }
}

/// The front of a body whose facets that face forwards lie in one plane across the tow, as high as the body;
/// and its mean width [m].
fn plane_front(body: &FacetedBody) -> Option<(Front, f64)> {
    /// Normals that differ by less are the same.
    const SAME: f64 = 1e-6;
    let forward: Vec<&Facet> = body.facets.iter().filter(|facet| facet.normal[0] > SAME).collect();
    let normal = forward.first()?.normal;
    let is_same = |facet: &&Facet| facet.normal.iter().zip(normal).all(|(a, b)| (a - b).abs() < SAME);
    let is_plane = normal[1].abs() < SAME && forward.iter().all(is_same);
    // How far it extends upwards and downwards; the facets reach half their height beyond their middles.
    let reaches = |sign: f64| {
        let ends = forward.iter().map(|facet| sign * facet.centroid[2] + 2.0 * facet.half_height);
        ends.fold(f64::NEG_INFINITY, f64::max)
    };
    let is_high = reaches(1.0) > body.height - body.below && reaches(-1.0) > body.below;
    let rake = FRAC_PI_2 - normal[2].atan2(normal[0]);
    let width = forward.iter().map(|facet| facet.area).sum::<f64>() * rake.sin() / body.height;
    let front = Front { rake, lower_edge: 0.0, upper_edge: body.height, length_behind: 0.0 };
    (is_plane && is_high).then_some((front, width))
}

/// The tow force of a plough with the least and with the most of its coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PloughUnderWater {
    /// Weight of the plough in water [N].
    pub weight: f64,
    /// Depth of the plough [m].
    pub depth: f64,
    /// Tow force with the least and with the most of the coefficients.
    pub forces: [PloughForce; 2],
}

impl PloughUnderWater {
    /// The plough of a case with these coefficients.
    ///
    /// # Errors
    /// In words, where the body is not towed at a given depth.
    pub(super) fn of(case: &Case, input: &ModelInput, plough: &Plough, speed: f64) -> Result<Self, String> {
        let towing = &input.towing;
        let Load::Sinkage(depth) = towing.load else {
            return Err("the tow force of a plough is for one at a given depth: fix its heave".into());
        };
        if towing.pressed || speed == 0.0 {
            return Err("the tow force of a plough is for one under tow".into());
        }
        let named = case.bodies.iter().filter(|body| input.bodies.contains(&body.name));
        let weight = named.map(|body| case.weight(body)).sum();
        let of = |n: usize| {
            let coefficients =
                PloughCoefficients { weight: plough.weight[n], slow: plough.slow[n], rate: plough.rate[n] };
            coefficients
                .tow_force(weight, towing.soil.unit_weight, depth, speed)
                .map_err(|why| why.to_string())
        };
        Ok(Self { weight, depth, forces: [of(0)?, of(1)?] })
    }
}
