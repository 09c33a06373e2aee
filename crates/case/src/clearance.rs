//! The clearance that a body needs round its path: for the heap in front of it, and for the ground that fails
//! round it.
//!
//! Rough, conservative estimates: soil that reaches a lid or a wall increases the force.

use crate::body::Body;
use crate::context::Context;
use crate::path::{displacement, path, range};
use crate::soil::Law;
use glam::DVec3;
use mechanics::Motion;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Sinkage of a body that is free to sink [body lengths]; chosen: the shipped disc sinks half as deep, a disc
/// that does not turn up to three times.
const FREE_SINKAGE: f64 = 0.1;
/// Sinkage of a body that is free to sink, for the height of the heap [body lengths]; chosen: air above the
/// heap costs little, and soil that reaches the lid ends the run.
const FREE_SINKAGE_AT_MOST: f64 = 1.0;
/// Slope of a heap of cohesive or undrained soil [rad]; chosen: steeper than sand, and such soil does break
/// up.
const COHESIVE_SLOPE: f64 = FRAC_PI_4;
/// Least slope of a heap [rad]; chosen: with less the foot of the heap would extend without limit.
const MIN_SLOPE: f64 = 10.0 * PI / 180.0;
/// Largest friction angle for the size of failure surfaces [rad]; chosen: beyond it logarithmic spirals grow
/// without bounds.
const LARGEST_FRICTION: f64 = 50.0 * PI / 180.0;
/// Extent of the failure zone in front of a rough face over Rankine's in front of a smooth one; chosen so
/// that the exact field with a wall friction of two thirds of φ stays within it up to φ = 45° (a test
/// compares).
const ROUGH_REACH: f64 = 2.0;
/// Depth over the height of a body below which the ground fails round the body instead of up to the surface;
/// chosen: buried plates are found to change from one mechanism to the other at 3 to 8.
const DEEP: f64 = 4.0;
/// Fraction of Prandtl's field under a footing that must fit: Hill's, under a smooth one, is half as large.
const FOOTING_FRACTION: f64 = 0.5;

/// What the clearance depends on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SoilConditions {
    /// Yield law of the soil.
    pub(crate) law: Law,
    /// Height of the surface of the soil [m].
    pub(crate) surface: f64,
    /// Height of the floor [m]; minus infinity as long as it is not known.
    pub(crate) floor: f64,
    /// Initial velocity of the soil [m/s].
    pub(crate) velocity: DVec3,
    /// Acceleration of gravity [m/s²].
    pub(crate) gravity: f64,
    /// Whether the soil is a slab in plane strain, without lateral flow.
    pub(crate) plane_strain: bool,
    /// Whether the soil fills the box up to the lid, so that nothing can rise.
    pub(crate) confined: bool,
}

impl SoilConditions {
    /// The soil before the box is known.
    pub(crate) fn before_the_box(context: &Context) -> Self {
        Self {
            law: context.law.unwrap_or(Law::Elastic),
            surface: context.surface,
            floor: f64::NEG_INFINITY,
            velocity: context.velocity,
            gravity: context.gravity,
            plane_strain: context.slab.is_some(),
            confined: false,
        }
    }

    /// Tangent of the slope of a heap.
    fn slope(&self) -> f64 {
        let least = if self.law.cohesion() == Some(0.0) { MIN_SLOPE } else { COHESIVE_SLOPE };
        self.law.friction_angle().unwrap_or(0.0).max(least).min(LARGEST_FRICTION).tan()
    }

    /// Friction angle [rad], 0 without friction.
    fn friction_angle(&self) -> f64 {
        self.law.friction_angle().unwrap_or(0.0).min(LARGEST_FRICTION)
    }

    /// How high soil in motion runs up a wall, v²/(2g) [m].
    fn run_up(&self) -> f64 {
        if self.gravity > 0.0 { self.velocity.length_squared() / (2.0 * self.gravity) } else { 0.0 }
    }
}

/// The clearance round the path of a body [m].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Clearance {
    /// Clearance above the undisturbed surface: the top of the heap [m].
    pub(crate) above: f64,
    /// Clearance above the soil if a body that is free to sink sinks much more than expected [m].
    pub(crate) above_at_most: f64,
    /// Clearance in front of the low and the high end of the path along x [m].
    pub(crate) along: [f64; 2],
    /// Clearance on either side of the path [m].
    pub(crate) sideways: f64,
    /// Clearance below the lowest point of the path [m].
    pub(crate) below: f64,
}

impl Clearance {
    /// The larger of both, in every direction.
    pub(crate) fn and(self, other: Self) -> Self {
        let [low, high] = self.along;
        Self {
            above: self.above.max(other.above),
            above_at_most: self.above_at_most.max(other.above_at_most),
            along: [low.max(other.along[0]), high.max(other.along[1])],
            sideways: self.sideways.max(other.sideways),
            below: self.below.max(other.below),
        }
    }
}

/// Depth of the lowest point of a body, or of any of its parts, in the soil on the whole path [m]; for a body
/// that is free to sink at least [`FREE_SINKAGE`].
pub(crate) fn deepest(body: &Body, soil: &SoilConditions, duration: f64) -> f64 {
    if !body.parts.is_empty() {
        let parts = body.surfaces();
        return parts.iter().map(|part| deepest(part, soil, duration)).fold(f64::NEG_INFINITY, f64::max);
    }
    sunk(body, soil, duration, FREE_SINKAGE)
}

/// Depth of the lowest point of a body without parts [m]; where it is free to sink at least so many body
/// lengths.
fn sunk(body: &Body, soil: &SoilConditions, duration: f64, free: f64) -> f64 {
    let size = body.size();
    let least = match body.guided().translation[2] {
        Motion::Free { .. } => free * size.x.max(size.z),
        _ => 0.0,
    };
    (soil.surface - path(body, duration).low.z).max(least).min(soil.surface - soil.floor)
}

/// The clearance that a body needs round its path: the largest that any of its parts needs.
pub(crate) fn clearance(body: &Body, soil: &SoilConditions, duration: f64) -> Clearance {
    if !body.parts.is_empty() {
        let parts = body.surfaces();
        return parts
            .iter()
            .map(|part| clearance(part, soil, duration))
            .fold(Clearance::default(), Clearance::and);
    }
    let depth = deepest(body, soil, duration);
    if soil.confined {
        return Clearance::default();
    }
    if depth <= 0.0 {
        return Clearance { above: soil.run_up(), above_at_most: soil.run_up(), ..Clearance::default() };
    }
    let at_most = sunk(body, soil, duration, FREE_SINKAGE_AT_MOST);
    let [own, deeper] = [depth, at_most]
        .map(|depth| pressed(body, soil, depth, duration).and(towed(body, soil, depth, duration)));
    Clearance { above_at_most: own.above.max(deeper.above), ..own }
}

/// Clearance for the heap and the failure zone of a tow.
fn towed(body: &Body, soil: &SoilConditions, depth: f64, duration: f64) -> Clearance {
    let moved = relative_displacement(body, soil, duration);
    let above = heap(body, soil, depth * moved.x.hypot(moved.y), depth, duration);
    if moved.x == 0.0 && moved.y == 0.0 {
        return Clearance { above, ..Clearance::default() };
    }
    let failing = depth.min(DEEP * body.size().z);
    let wedge = failing * (FRAC_PI_4 + 0.5 * soil.friction_angle()).tan();
    let foot = above / soil.slope();
    let ahead = if body.friction > 0.0 { ROUGH_REACH * wedge } else { wedge } + foot;
    let along = [if moved.x < 0.0 { ahead } else { 0.0 }, if moved.x > 0.0 { ahead } else { 0.0 }];
    // The crescents at the ends of a face extend as far as the wedge in front of it.
    let sideways = if moved.y == 0.0 { wedge + foot } else { ahead };
    Clearance { above, along, sideways, ..Clearance::default() }
}

/// Clearance for a body that sinks: the heave next to it, and the failure zone under a footing.
fn pressed(body: &Body, soil: &SoilConditions, depth: f64, duration: f64) -> Clearance {
    let sunk = match body.guided().translation[2] {
        Motion::Free { .. } => depth,
        Motion::Prescribed { .. } | Motion::Course(_) => (-range(body, duration)[0].z).clamp(0.0, depth),
        Motion::Fixed => 0.0,
    };
    if sunk <= 0.0 {
        return Clearance::default();
    }
    let breadth = breadth(body, soil, depth);
    // The displaced soil rises on both sides.
    let above = heap(body, soil, 0.5 * sunk * breadth, depth, duration);
    let phi = soil.friction_angle();
    let flank = (FRAC_PI_4 + 0.5 * phi).tan();
    let reach = FOOTING_FRACTION * breadth * flank * (FRAC_PI_2 * phi.tan()).exp();
    let spiral = 0.5 * breadth * phi.cos() / (FRAC_PI_4 - 0.5 * phi).sin().max(f64::MIN_POSITIVE);
    let below = FOOTING_FRACTION * spiral * ((FRAC_PI_4 + 0.5 * phi) * phi.tan()).exp();
    Clearance { above, along: [reach; 2], sideways: reach, below, ..Clearance::default() }
}

/// Height of the heap [m] formed by the swept soil, `area` over the body's width [m²]: a wedge at the slope
/// of repose in front of the whole width, b H²/(2 tan φ), which ends in a quarter of a cone on either side, π
/// H³/(12 tan²φ).
///
/// A body retains soil up to its own height; what flows over it is a layer no thicker than the depth of cut.
fn heap(body: &Body, soil: &SoilConditions, area: f64, depth: f64, duration: f64) -> f64 {
    let slope = soil.slope();
    let plane = (2.0 * area * slope).sqrt();
    let moved = relative_displacement(body, soil, duration);
    let size = body.size();
    let width = if moved.y.abs() > moved.x.abs() { size.x } else { size.y };
    let volume = |h: f64| width * h * h / (2.0 * slope) + PI * h.powi(3) / (6.0 * slope * slope);
    let (mut lower, mut upper) = (0.0, plane);
    for _ in 0..if soil.plane_strain { 0 } else { 40 } {
        let middle = 0.5 * (lower + upper);
        if volume(middle) < width * area { lower = middle } else { upper = middle }
    }
    let top = (path(body, duration).high.z - soil.surface).max(0.0);
    upper.min(top + depth).max(soil.run_up())
}

/// Displacement of the body along x and y relative to soil that moves [m].
fn relative_displacement(body: &Body, soil: &SoilConditions, duration: f64) -> DVec3 {
    displacement(body, duration) - duration * soil.velocity
}

/// Length of the contact of what rolls in a diameter at a sinkage [m].
pub(crate) fn chord(diameter: f64, sinkage: f64) -> f64 {
    let depth = sinkage.min(0.5 * diameter);
    2.0 * (depth * (diameter - depth)).sqrt()
}

/// The smaller width of the contact area with the soil [m].
fn breadth(body: &Body, soil: &SoilConditions, depth: f64) -> f64 {
    let size = body.size();
    let along = body.rolling_diameter().map_or(size.x, |diameter| chord(diameter, depth));
    if soil.plane_strain { along } else { along.min(size.y) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Case, parse};
    use analytic::earth_pressure::{Face, sokolovskii};

    /// A blade of 40 × 100 × 200 mm that leans back by 45°, 60 mm deep in sand, towed this far [m].
    fn blade(distance: &str, more: &str) -> Case {
        let text = format!(
            "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
             [domain]\nsymmetric = true\n{more}\n[grid]\ncell = '12.5 mm'\n[body.blade]\nshape = 'block'\n\
             size = ['40 mm', '100 mm', '200 mm']\npitch = '-45 deg'\nsinkage = '60 mm'\nfriction = 0.3\n\
             forward = {{ speed = '0.2 m/s' }}\n[run]\ntow_distance = '{distance}'\n"
        );
        parse(&text, "case.toml", &[]).unwrap()
    }

    fn clearance_of(case: &Case) -> Clearance {
        clearance(&case.bodies[0], &SoilConditions::of(case), case.duration)
    }

    #[test]
    fn the_exact_field_in_front_of_a_rough_face_stays_within_its_extent() {
        for phi in [20.0, 25.0, 30.0, 35.0, 40.0, 45.0] {
            let exact = sokolovskii(&Face::degrees(phi, 2.0 / 3.0 * phi, 90.0, 0.0)).unwrap().rupture_ratio;
            let rankine = (FRAC_PI_4 + 0.5 * f64::to_radians(phi)).tan();
            assert!(exact <= ROUGH_REACH * rankine, "φ = {phi}°: {exact} beyond {}", ROUGH_REACH * rankine);
        }
    }

    #[test]
    fn a_heap_contains_what_was_swept_and_no_more_than_the_body_retains() {
        let case = blade("0.4 m", "");
        let (heap, slope) = (clearance_of(&case).above, 35_f64.to_radians().tan());
        let volume = 0.1 * heap * heap / (2.0 * slope) + PI * heap.powi(3) / (6.0 * slope * slope);
        assert!((volume / (0.06 * 0.4 * 0.1) - 1.0).abs() < 1e-3, "{volume}");
        let far = clearance_of(&blade("4 m", "")).above;
        assert!((far - (0.24 / 2_f64.sqrt() - 0.06 + 0.06)).abs() < 1e-9, "{far}");
    }

    #[test]
    fn the_box_of_a_blade_has_space_for_its_heap_and_a_low_lid_is_warned_of() {
        let case = blade("0.4 m", "");
        let lid = case.domain.high.z;
        assert!(lid >= clearance_of(&case).above + 2.0 * 0.0125 - 1e-12, "the lid is at {lid} m");
        assert!(!crate::advice(&case).iter().any(|note| note.contains("lid") || note.contains("walls")));
        // Where the lid was before: 0.4 body lengths above the soil. The heap is as high as that after 0.4 m.
        let notes = crate::advice(&blade("0.4 m", "z = ['-0.272 m', '0.068 m']"));
        assert!(notes.iter().any(|note| note.contains("the lid is low")), "{notes:?}");
    }

    #[test]
    fn soil_that_touches_the_lid_needs_no_clearance() {
        let case = blade("0.4 m", "z = ['-0.3 m', '0 m']");
        assert_eq!(clearance_of(&case), Clearance::default());
    }
}
