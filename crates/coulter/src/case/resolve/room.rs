//! How much room the soil needs that a body pushes aside: the heap in front of it, and the ground that fails round it.
//!
//! Rough estimates, meant to be too large rather than too small: soil that meets a lid or a wall adds to the force.

use crate::case::path::{path, travel};
use crate::case::resolved::{Axis, Body, Case, Freedom, Law, Shape};
use glam::DVec3;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Sinkage of a body that is free to sink [body lengths]; chosen: the shipped disc sinks half as deep, a disc that does
/// not turn up to three times.
const FREE_SINKAGE: f64 = 0.1;
/// Slope at which soil with cohesion, or undrained, stands in a heap [rad]; chosen: steeper than sand, and it does break.
const COHESIVE_SLOPE: f64 = FRAC_PI_4;
/// Least slope of a heap [rad]; chosen: sand below it would flow away, and the heap's foot never end.
const LEAST_SLOPE: f64 = 10.0 * PI / 180.0;
/// Largest friction angle whose failure surfaces are believed [rad]; chosen: beyond it spirals grow without bounds.
const LARGEST_FRICTION: f64 = 50.0 * PI / 180.0;
/// Reach of the ground's failure before a rough face over Rankine's, which is that before a smooth one; chosen so that the
/// exact field with a wall friction of two thirds of φ stays within it up to φ = 45° (a test compares).
const ROUGH_REACH: f64 = 2.0;
/// Depth over the height of a body below which the ground fails round the body and no longer up to the surface; chosen:
/// buried plates are found to pass from one to the other at 3 to 8.
const DEEP: f64 = 4.0;
/// Share of Prandtl's field under a footing that is asked for: Hill's, under a smooth one, is half as large.
const FOOTING_SHARE: f64 = 0.5;

/// What the soil's part in it depends on.
#[derive(Clone, Copy, Debug)]
pub(in crate::case) struct Soil {
    /// Its strength.
    pub(in crate::case) law: Law,
    /// Height of its surface [m].
    pub(in crate::case) surface: f64,
    /// Height at which it ends below [m]; minus infinity as long as nobody has said where.
    pub(in crate::case) floor: f64,
    /// Its velocity at the start [m/s].
    pub(in crate::case) velocity: DVec3,
    /// Acceleration of gravity [m/s²].
    pub(in crate::case) gravity: f64,
    /// Whether it is a slab in plane strain, out of which nothing gets sideways.
    pub(in crate::case) plane_strain: bool,
    /// Whether it fills the box up to the lid, so that nothing can rise.
    pub(in crate::case) confined: bool,
}

impl Soil {
    /// The soil of a case.
    pub(in crate::case) fn of(case: &Case) -> Self {
        Self {
            law: case.soil.law,
            surface: case.ground.surface(),
            floor: case.domain.low.z,
            velocity: case.velocity,
            gravity: case.gravity,
            plane_strain: case.domain.plane_strain,
            confined: case.domain.high.z <= case.ground.surface(),
        }
    }

    /// Tangent of the slope of a heap.
    fn slope(&self) -> f64 {
        match self.law {
            Law::MohrCoulomb { friction_angle, cohesion: 0.0, .. } => friction_angle.max(LEAST_SLOPE),
            Law::MohrCoulomb { friction_angle, .. } => friction_angle.max(COHESIVE_SLOPE),
            Law::Tresca { .. } | Law::VonMises { .. } | Law::Elastic => COHESIVE_SLOPE,
        }
        .min(LARGEST_FRICTION)
        .tan()
    }

    /// Friction angle [rad], 0 without friction.
    fn friction_angle(&self) -> f64 {
        match self.law {
            Law::MohrCoulomb { friction_angle, .. } => friction_angle.min(LARGEST_FRICTION),
            _ => 0.0,
        }
    }

    /// How high soil in motion runs up a wall, v²/(2g) [m].
    fn run_up(&self) -> f64 {
        if self.gravity > 0.0 { self.velocity.length_squared() / (2.0 * self.gravity) } else { 0.0 }
    }
}

/// The room that the soil round one body needs [m].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::case) struct Room {
    /// Above the undisturbed surface: the top of the heap.
    pub(in crate::case) above: f64,
    /// Before the low and the high end of the body's path along x.
    pub(in crate::case) along: [f64; 2],
    /// At either side of the body's path.
    pub(in crate::case) beside: f64,
    /// Below the lowest place of the path.
    pub(in crate::case) below: f64,
}

impl Room {
    /// What is enough for both.
    pub(in crate::case) fn and(self, other: Self) -> Self {
        let [low, high] = self.along;
        Self {
            above: self.above.max(other.above),
            along: [low.max(other.along[0]), high.max(other.along[1])],
            beside: self.beside.max(other.beside),
            below: self.below.max(other.below),
        }
    }
}

/// Depth of the lowest point in the soil on the whole way [m]; of a body that is free to sink at least a stated share of
/// its length.
pub(in crate::case) fn deepest(body: &Body, soil: &Soil, duration: f64) -> f64 {
    let (low, high) = body.shape.solid().bounds();
    let free = match body.translation[2] {
        Freedom::Free { .. } => FREE_SINKAGE * (high - low).x.max((high - low).z),
        _ => 0.0,
    };
    (soil.surface - path(body, duration).low.z).max(free).min(soil.surface - soil.floor)
}

/// The room that the soil needs round a body on its way.
pub(in crate::case) fn room(body: &Body, soil: &Soil, duration: f64) -> Room {
    let depth = deepest(body, soil, duration);
    if soil.confined {
        return Room::default();
    }
    if depth <= 0.0 {
        return Room { above: soil.run_up(), ..Room::default() };
    }
    pressed(body, soil, depth, duration).and(towed(body, soil, depth, duration))
}

/// Room for what a tow pushes up and ahead.
fn towed(body: &Body, soil: &Soil, depth: f64, duration: f64) -> Room {
    let way = relative_way(body, soil, duration);
    let above = heap(body, soil, depth * way.x.hypot(way.y), (depth, duration));
    if way.x == 0.0 && way.y == 0.0 {
        return Room { above, ..Room::default() };
    }
    let (low, high) = body.shape.solid().bounds();
    let failing = depth.min(DEEP * (high - low).z);
    let wedge = failing * (FRAC_PI_4 + 0.5 * soil.friction_angle()).tan();
    let foot = above / soil.slope();
    let ahead = if body.friction > 0.0 { ROUGH_REACH * wedge } else { wedge } + foot;
    let along = [if way.x < 0.0 { ahead } else { 0.0 }, if way.x > 0.0 { ahead } else { 0.0 }];
    // Crescents at the ends of a face reach as far as the wedge before it.
    let beside = if way.y == 0.0 { wedge + foot } else { ahead };
    Room { above, along, beside, below: 0.0 }
}

/// Room for what a body that sinks presses down and up beside it: the heave, and the field under a footing.
fn pressed(body: &Body, soil: &Soil, depth: f64, duration: f64) -> Room {
    let sunk = match body.translation[2] {
        Freedom::Free { .. } => depth,
        Freedom::Prescribed { .. } => (-travel(&body.translation[2], duration)).clamp(0.0, depth),
        Freedom::Fixed => 0.0,
    };
    if sunk <= 0.0 {
        return Room::default();
    }
    let breadth = breadth(body, soil, depth);
    // What is displaced rises at both sides.
    let above = heap(body, soil, 0.5 * sunk * breadth, (depth, duration));
    let phi = soil.friction_angle();
    let turned = (FRAC_PI_4 + 0.5 * phi).tan();
    let reach = FOOTING_SHARE * breadth * turned * (FRAC_PI_2 * phi.tan()).exp();
    let spiral = 0.5 * breadth * phi.cos() / (FRAC_PI_4 - 0.5 * phi).sin().max(f64::MIN_POSITIVE);
    let below = FOOTING_SHARE * spiral * ((FRAC_PI_4 + 0.5 * phi) * phi.tan()).exp();
    Room { above, along: [reach; 2], beside: reach, below }
}

/// Height of the heap [m] that the soil swept, `area` over the body's width [m²], makes: a wedge at the slope of repose
/// before the whole width, b H²/(2 tan φ), which runs out into a quarter of a cone at either end, π H³/(12 tan²φ).
///
/// A body holds back no more than its own height; what flows over it is a layer no thicker than the depth it was cut at.
fn heap(body: &Body, soil: &Soil, area: f64, (depth, duration): (f64, f64)) -> f64 {
    let slope = soil.slope();
    let plane = (2.0 * area * slope).sqrt();
    let (low, high) = body.shape.solid().bounds();
    let way = relative_way(body, soil, duration);
    let size = high - low;
    let width = if way.y.abs() > way.x.abs() { size.x } else { size.y };
    let volume = |h: f64| width * h * h / (2.0 * slope) + PI * h.powi(3) / (6.0 * slope * slope);
    let (mut lower, mut upper) = (0.0, plane);
    for _ in 0..if soil.plane_strain { 0 } else { 40 } {
        let middle = 0.5 * (lower + upper);
        if volume(middle) < width * area { lower = middle } else { upper = middle }
    }
    let top = (path(body, duration).high.z - soil.surface).max(0.0);
    upper.min(top + depth).max(soil.run_up())
}

/// Way of the body along x and y, over the soil that moves by itself [m].
fn relative_way(body: &Body, soil: &Soil, duration: f64) -> DVec3 {
    let moved = DVec3::from_array(body.translation.each_ref().map(|freedom| travel(freedom, duration)));
    moved - duration * soil.velocity
}

/// The lesser width of what touches the soil from above [m].
fn breadth(body: &Body, soil: &Soil, depth: f64) -> f64 {
    let (low, high) = body.shape.solid().bounds();
    let size = high - low;
    let chord = |d: f64| 2.0 * (depth.min(0.5 * d) * (d - depth.min(0.5 * d))).sqrt();
    let along = match body.shape {
        Shape::Disc { diameter, .. } | Shape::Sphere { diameter } => chord(diameter),
        Shape::Cylinder { diameter, axis: Axis::Y, .. } => chord(diameter),
        Shape::Block { .. } | Shape::Cylinder { .. } => size.x,
    };
    if soil.plane_strain { along } else { along.min(size.y) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::parse;
    use analytic::earth_pressure::{Face, sokolovskii};

    /// A blade of 40 × 100 × 200 mm that leans back by 45°, 60 mm deep in sand, towed so far [m].
    fn blade(way: &str, more: &str) -> Case {
        let text = format!(
            "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
             [domain]\nsymmetric = true\n{more}\n[grid]\ncell = '12.5 mm'\n[body.blade]\nshape = 'block'\n\
             size = ['40 mm', '100 mm', '200 mm']\norientation = '-45 deg'\nsinkage = '60 mm'\nfriction = 0.3\n\
             forward = {{ speed = '0.2 m/s' }}\n[run]\ntow_distance = '{way}'\n"
        );
        parse(&text, "case.toml", &[]).unwrap()
    }

    fn room_of(case: &Case) -> Room {
        room(&case.bodies[0], &Soil::of(case), case.duration)
    }

    #[test]
    fn the_exact_field_before_a_rough_face_stays_within_its_reach() {
        for phi in [20.0, 25.0, 30.0, 35.0, 40.0, 45.0] {
            let exact = sokolovskii(&Face::degrees(phi, 2.0 / 3.0 * phi, 90.0, 0.0)).unwrap().rupture_ratio;
            let rankine = (FRAC_PI_4 + 0.5 * f64::to_radians(phi)).tan();
            assert!(exact <= ROUGH_REACH * rankine, "φ = {phi}°: {exact} beyond {}", ROUGH_REACH * rankine);
        }
    }

    #[test]
    fn a_heap_holds_what_was_swept_and_no_more_than_the_body_holds_back() {
        let case = blade("0.4 m", "");
        let (heap, slope) = (room_of(&case).above, 35_f64.to_radians().tan());
        let volume = 0.1 * heap * heap / (2.0 * slope) + PI * heap.powi(3) / (6.0 * slope * slope);
        assert!((volume / (0.06 * 0.4 * 0.1) - 1.0).abs() < 1e-3, "{volume}");
        let far = room_of(&blade("4 m", "")).above;
        assert!((far - (0.24 / 2_f64.sqrt() - 0.06 + 0.06)).abs() < 1e-9, "{far}");
    }

    #[test]
    fn the_box_of_a_blade_has_room_for_its_heap_and_a_low_lid_is_warned_of() {
        let case = blade("0.4 m", "");
        let lid = case.domain.high.z;
        assert!(lid >= room_of(&case).above + 2.0 * 0.0125 - 1e-12, "the lid is at {lid} m");
        assert!(
            !crate::case::advice(&case).iter().any(|note| note.contains("lid") || note.contains("walls"))
        );
        // Where the lid was before: 0.4 body lengths above the soil. The heap is as high as that after 0.4 m.
        let notes = crate::case::advice(&blade("0.4 m", "z = ['-0.272 m', '0.068 m']"));
        assert!(notes.iter().any(|note| note.contains("the lid is low")), "{notes:?}");
    }

    #[test]
    fn soil_under_a_lid_that_it_touches_needs_no_room_above() {
        let case = blade("0.4 m", "z = ['-0.3 m', '0 m']");
        assert_eq!(room_of(&case), Room::default());
    }
}
