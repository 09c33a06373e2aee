//! The direction of the tow of a body: that of its level motion, against which drag is positive.

use super::path::travel;
use super::resolved::{Body, Case, Motion};
use super::shapes::{Block, Cylinder, Shape};
use geometry::Axis;
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

/// How far an angle may be from a multiple of 90° to count as one [rad].
const SQUARE: f64 = 1e-9;

/// The direction of a tow: the components of a level unit vector along x and y.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct TowDirection([f64; 2]);

impl Default for TowDirection {
    /// Along x.
    fn default() -> Self {
        Self([1.0, 0.0])
    }
}

impl TowDirection {
    /// The direction in which a body is towed: that of its prescribed level motion in the stage over which
    /// averages are taken. Without one that of the loads on its level motions, or the way in which it is
    /// driven to roll; of a body that others move, theirs. Along x where none of these says it.
    #[must_use]
    pub fn of(case: &Case, body: &Body) -> Self {
        let is_dragged = || body.guided().translation[..2].iter().any(Motion::is_free);
        own_of(case, body)
            .or_else(|| case.bodies.iter().find_map(|other| own_of(case, other)).filter(|_| is_dragged()))
            .unwrap_or_default()
    }

    /// The directions of all bodies of a case, in its order.
    #[must_use]
    pub fn all(case: &Case) -> Vec<Self> {
        case.bodies.iter().map(|body| Self::of(case, body)).collect()
    }

    /// Components of the direction along x and y.
    #[must_use]
    pub fn components(self) -> [f64; 2] {
        self.0
    }

    /// Whether the tow is along x, forwards or backwards.
    #[must_use]
    pub fn is_along_x(self) -> bool {
        self.0[1] == 0.0
    }

    /// Whether the tow is more along y than along x.
    #[must_use]
    pub fn is_lateral(self) -> bool {
        self.0[1].abs() > self.0[0].abs()
    }

    /// A vector of space along the tow, across it to the left, and upwards.
    #[must_use]
    pub fn turned(self, v: DVec3) -> DVec3 {
        self.rotated(v, -1.0)
    }

    /// A vector of space from one along the tow, across it to the left, and upwards.
    #[must_use]
    pub fn in_space(self, v: DVec3) -> DVec3 {
        self.rotated(v, 1.0)
    }

    /// Rotated about z by the angle of the tow from x, or by that against it. A tow along an axis changes no
    /// digit.
    fn rotated(self, v: DVec3, sign: f64) -> DVec3 {
        let [cos, sin] = [self.0[0], sign * self.0[1]];
        if sin == 0.0 {
            DVec3::new(cos * v.x, cos * v.y, v.z)
        } else if cos == 0.0 {
            DVec3::new(-sin * v.y, sin * v.x, v.z)
        } else {
            DVec3::new(cos * v.x - sin * v.y, sin * v.x + cos * v.y, v.z)
        }
    }

    /// Width of a body that is towed in this direction, across it [m].
    #[must_use]
    pub fn width_across(self, body: &Body) -> f64 {
        if self.is_along_x() {
            return body.size().y;
        }
        let left = body.attitude.of_axle().inverse() * self.in_space(DVec3::Y);
        body.solid().extent(left) + body.solid().extent(-left)
    }

    fn along(v: [f64; 2]) -> Option<Self> {
        let v = DVec2::from_array(v).try_normalize()?;
        Some(Self(match v.to_array() {
            [x, 0.0] => [x.signum(), 0.0],
            [0.0, y] => [0.0, y.signum()],
            both => both,
        }))
    }
}

/// The direction that a body itself says.
fn own_of(case: &Case, body: &Body) -> Option<TowDirection> {
    let guide = body.guided();
    let level = [&guide.translation[0], &guide.translation[1]];
    let prescribed = TowDirection::along(level.map(|motion| speed(motion, case.duration)));
    let farthest = |[low, high]: [f64; 2]| if -low > high { low } else { high };
    let staged =
        || guide.bounds.and_then(|bounds| TowDirection::along([farthest(bounds[0]), farthest(bounds[1])]));
    let load = |motion: &Motion| if let Motion::Free { load, .. } = motion { *load } else { 0.0 };
    let drive = match body.spin() {
        Motion::Prescribed { speed, .. } => *speed,
        motion => load(motion),
    };
    let (sin, cos) = body.attitude.yaw.sin_cos();
    let rolls = [0, 1].map(|n| if level[n].is_free() { drive * [cos, sin][n] } else { 0.0 });
    prescribed
        .or_else(staged)
        .or_else(|| TowDirection::along(level.map(load)))
        .or_else(|| TowDirection::along(rolls))
}

/// Mean speed of a motion that is prescribed, of one to and fro that of its longer way [m/s]; 0 of any other.
fn speed(motion: &Motion, duration: f64) -> f64 {
    match motion {
        Motion::Prescribed { speed, .. } => *speed,
        Motion::Course(course) => {
            let [low, high] = course.extremes(duration);
            let moved = travel(motion, duration);
            let returns = moved.abs() < 1e-9 * (high - low);
            (if !returns {
                moved
            } else if -low > high {
                low
            } else {
                high
            }) / duration
        }
        Motion::Fixed | Motion::Free { .. } => 0.0,
    }
}

/// What a body and the cells next to it measure along its tow, across it and upwards [m].
#[derive(Clone, Copy, Debug)]
pub struct Measures {
    /// Extent of the body along its own axes: first along the level axis in which it rolls, or, where it does
    /// not, along that nearest to the tow.
    pub extent: DVec3,
    /// Thickness of the body across the tow: of a dished disc less than its extent.
    pub thickness: f64,
    /// Widths of the cells along the axes of the body [m].
    pub cell: DVec3,
}

impl Measures {
    /// Measures of a body among cells of these widths along x, y and z [m].
    pub fn of(case: &Case, body: &Body, cell: DVec3) -> Self {
        let is_turned = |angle: f64| angle.sin().abs() > angle.cos().abs() + SQUARE;
        let (low, high) = body.solid().bounds();
        let (mut extent, mut cell) = (high - low, cell);
        let mut thickness = extent.y.min(body.thickness());
        if is_turned(body.attitude.yaw) {
            cell = DVec3::new(cell.y, cell.x, cell.z);
        }
        let [x, y] = TowDirection::of(case, body).components();
        if body.wheel_diameter().is_none() && is_turned(body.attitude.yaw - y.atan2(x)) {
            extent = DVec3::new(extent.y, extent.x, extent.z);
            cell = DVec3::new(cell.y, cell.x, cell.z);
            thickness = extent.y;
        }
        Self { extent, thickness, cell }
    }
}

/// A shape and its yaw [rad]; of a shape that looks the same with its edges along x and y exchanged, which is
/// turned by quarters, that shape without a yaw.
#[must_use]
pub fn squared(shape: &Shape, yaw: f64) -> (Shape, f64) {
    let quarters = yaw / std::f64::consts::FRAC_PI_2;
    if (quarters - quarters.round()).abs() > SQUARE {
        return (shape.clone(), yaw);
    }
    let is_across = (quarters.round() as i64) % 2 != 0;
    let exchanged = match *shape {
        Shape::Block(Block { size }) if is_across => {
            Shape::Block(Block { size: DVec3::new(size.y, size.x, size.z) })
        }
        Shape::Cylinder(cylinder) if is_across => {
            let axis = match cylinder.axis {
                Axis::X => Axis::Y,
                Axis::Y => Axis::X,
                Axis::Z => Axis::Z,
            };
            Shape::Cylinder(Cylinder { axis, ..cylinder })
        }
        Shape::Block(_) | Shape::Cylinder(_) | Shape::Sphere(_) | Shape::Cone(_) => shape.clone(),
        _ => return (shape.clone(), yaw),
    };
    (exchanged, 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vector_turned_to_the_tow_is_turned_back() {
        let v = DVec3::new(1.0, 2.0, 3.0);
        for (direction, along) in [
            ([1.0, 0.0], 1.0),
            ([-1.0, 0.0], -1.0),
            ([0.0, 1.0], 2.0),
            ([0.0, -1.0], -2.0),
            ([0.6, 0.8], 2.2),
        ] {
            let tow = TowDirection(direction);
            assert!((tow.turned(v).x - along).abs() < 1e-12, "{direction:?}");
            assert!((tow.in_space(tow.turned(v)) - v).length() < 1e-12);
        }
    }
}
