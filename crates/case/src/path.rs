//! Where prescribed motions take the bodies.

use super::body::Body;
use glam::DVec3;
use mechanics::Motion;
use solver::model::Follow;

/// A box with faces along the axes.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Low corner [m].
    pub low: DVec3,
    /// High corner [m].
    pub high: DVec3,
}

/// Displacement of a prescribed motion after `time` [m or rad]; 0 for any other.
pub fn travel(freedom: &Motion, time: f64) -> f64 {
    let (before, speed, start, ramp, end) = match *freedom {
        Motion::Prescribed { before, speed, start, ramp, end } => (before, speed, start, ramp, end),
        Motion::Course(ref course) => return course.displacement(time),
        Motion::Fixed | Motion::Free { .. } => return 0.0,
    };
    // Integral of the smooth step 3x² − 2x³ over a ramp, then of 1.
    let ramped = |since: f64| {
        let x = if ramp > 0.0 { (since / ramp).clamp(0.0, 1.0) } else { 1.0 };
        ramp * (x.powi(3) - 0.5 * x.powi(4)) + (since - ramp).max(0.0)
    };
    let since = |event: f64| if time > event { ramped(time - event) } else { 0.0 };
    let driven = speed * (since(start) - since(end));
    if before == 0.0 { driven } else { driven + before * (time - since(start)) }
}

/// Largest speed of a prescribed motion, without its sign [m/s or rad/s]; 0 for any other.
pub fn fastest(motion: &Motion) -> f64 {
    match motion {
        Motion::Prescribed { speed, .. } => speed.abs(),
        Motion::Course(course) => course.fastest(),
        Motion::Fixed | Motion::Free { .. } => 0.0,
    }
}

/// Least and largest displacement of a body along x, y, z within a time [m], as far as it is prescribed.
pub(super) fn range(body: &Body, time: f64) -> [DVec3; 2] {
    let guide = body.guided();
    let each: [[f64; 2]; 3] = match guide.bounds {
        Some(bounds) if time > 0.0 => bounds,
        Some(_) => [[0.0; 2]; 3],
        None => guide.translation.each_ref().map(|freedom| match freedom {
            Motion::Course(course) => course.extremes(time),
            _ => {
                let travelled = travel(freedom, time);
                [travelled.min(0.0), travelled.max(0.0)]
            }
        }),
    };
    [0, 1].map(|side| DVec3::from_array(each.map(|ends| ends[side])))
}

/// Displacement of a body by a time [m], as far as it is prescribed: the larger of that forwards and that
/// backwards, of a body that goes both ways.
pub(super) fn displacement(body: &Body, time: f64) -> DVec3 {
    let [low, high] = range(body, time);
    DVec3::select((-low).cmpgt(high), low, high)
}

/// The box that encloses a body on its whole path.
pub(super) fn path(body: &Body, duration: f64) -> Extent {
    extent(body, range(body, duration))
}

/// The box that encloses a body between two displacements [m].
fn extent(body: &Body, [back, ahead]: [DVec3; 2]) -> Extent {
    let (low, high) = body.reach();
    Extent { low: body.position + back + low, high: body.position + ahead + high }
}

/// The paths of bodies in the grid, which may follow one of them.
#[derive(Clone, Copy, Debug)]
pub struct Paths<'a> {
    pub(super) bodies: &'a [Body],
    pub(super) follow: Option<Follow>,
    /// Duration of the run [s].
    pub(super) duration: f64,
}

impl Paths<'_> {
    /// The box that encloses a body on its whole path in the grid.
    pub(super) fn of_body(&self, body: &Body) -> Extent {
        let (own, grid) = (range(body, self.duration), self.of_grid());
        let guide = body.guided();
        // A body that moves with the grid stays in its place, even where it moves to and fro. Of a free
        // one it is not known whether it is taken along: the run says where it leaves the grid.
        let relative = |axis: usize| {
            let ([low, high], [back, ahead]) = ([own[0][axis], own[1][axis]], [grid[0][axis], grid[1][axis]]);
            let goes_one_way = low * high == 0.0 && back * ahead == 0.0;
            if [low, high] == [back, ahead] || guide.translation[axis].is_free() {
                [0.0; 2]
            } else if goes_one_way {
                let end = (low + high) - (back + ahead);
                [end.min(0.0), end.max(0.0)]
            } else {
                [(low - ahead).min(0.0), (high - back).max(0.0)]
            }
        };
        let each = [0, 1, 2].map(relative);
        extent(body, [0, 1].map(|side| DVec3::from_array(each.map(|ends| ends[side]))))
    }

    /// The box that encloses all bodies that can touch the soil on their whole paths in the grid.
    pub fn all(&self) -> Option<Extent> {
        let touching = self.bodies.iter().filter(|body| body.has_surface());
        let all = touching.map(|body| self.of_body(body));
        all.reduce(|a, b| Extent { low: a.low.min(b.low), high: a.high.max(b.high) })
    }

    /// Least and largest displacement of the grid [m]: those of the body that it follows.
    pub(super) fn of_grid(&self) -> [DVec3; 2] {
        let Some(Follow { body, axes }) = self.follow else { return [DVec3::ZERO; 2] };
        let followed = self.bodies.get(body).map_or([DVec3::ZERO; 2], |body| range(body, self.duration));
        followed.map(|end| DVec3::from_array(std::array::from_fn(|n| if axes[n] { end[n] } else { 0.0 })))
    }
}

/// The largest edge of any body in the plane of the tow [m].
pub(super) fn body_length(bodies: &[Body]) -> f64 {
    let length = |b: &Body| {
        let size = b.size();
        size.x.max(size.z)
    };
    bodies.iter().map(length).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn travel_is_the_integral_of_the_speed() {
        let towed = Motion::Prescribed { before: 0.0, speed: 0.2, start: 0.4, ramp: 0.1, end: 1.0 };
        let at = |time: f64| travel(&towed, time);
        assert!((at(0.4), at(0.3)) == (0.0, 0.0));
        assert!((at(0.45) - 0.2 * 0.1 * (0.125 - 0.03125)).abs() < 1e-15, "inside the ramp");
        assert!((at(0.5) - 0.2 * 0.05).abs() < 1e-15, "a ramp covers half of what the full speed would");
        assert!((at(0.9) - 0.2 * 0.45).abs() < 1e-15);
        assert!(
            (at(5.0) - 0.2 * 0.6).abs() < 1e-15,
            "from start to end: the two ramps compensate each other"
        );
        assert_eq!(travel(&Motion::Fixed, 9.0), 0.0);
        let at_once =
            Motion::Prescribed { before: 0.0, speed: -1.0, start: 0.0, ramp: 0.0, end: f64::INFINITY };
        assert_eq!(travel(&at_once, 2.0), -2.0);
    }
}
