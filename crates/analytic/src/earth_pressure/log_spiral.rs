//! Upper bound from a block rotating on a log-spiral slip surface.

use super::Face;
use crate::error::{ModelResult, undefined};
use numerics::search::minimum;

/// A point or vector in the plane, x into the soil and z up, in units of the face length.
type Vector = (f64, f64);

/// Upper bound on K_n from one block that rotates on a log-spiral slip surface from the toe to the ground.
///
/// r = r_A e^{ω tan φ}; the reactions on such a spiral act at φ to its normal, hence through its pole, so the
/// moments about the pole give the thrust (at two thirds of the face from its top edge) from the weight
/// alone. The bound is the minimum over the exit point and the swept angle; a plane slip surface is the limit
/// of zero sweep. Source: Rendulic (1935), Terzaghi (1943), as a kinematic bound Chen (1975) (recalled, not
/// re-read). Valid for 5° ≤ φ ≤ 55°, |δ| ≤ φ, 10° ≤ α ≤ 90°, β ≤ α − 5°.
///
/// # Errors
/// Outside that range, or if the angles are not physical.
pub fn log_spiral(face: &Face) -> ModelResult<f64> {
    face.check()?;
    let degrees = face.friction_angle.to_degrees();
    if !(5.0..=55.0).contains(&degrees)
        || face.surface.to_degrees() < 10.0 - 1e-9
        || (face.surface - face.backfill).to_degrees() < 5.0 - 1e-9
    {
        return undefined("the log-spiral bound", "it needs 5° ≤ φ ≤ 55°, α ≥ 10° and β ≤ α − 5°");
    }
    let block = Block::of(face);
    // ln of the exit distance in face lengths; then the swept angle [rad]. With a negative sweep (pole below
    // the ground) the far end would move down, and the thrust at a fixed point would be no bound.
    let least = |exit: f64| scanned_minimum(0.0, 0.12, 26, |sweep| block.thrust(exit.exp(), sweep));
    match scanned_minimum(-1.5, 0.125, 40, least) {
        k if k.is_finite() => Ok(k),
        _ => undefined("the log-spiral bound", "there is no admissible block"),
    }
}

/// The minimum of `f`: a scan of (start, step, count), then a golden-section search around its best point.
///
/// `f` is infinite where the block is not admissible, which a golden-section search alone cannot handle.
fn scanned_minimum(start: f64, step: f64, count: u32, f: impl Fn(f64) -> f64) -> f64 {
    let scan = (0..count).map(|n| start + step * f64::from(n)).map(|x| (x, f(x)));
    let (x, value) = scan.fold((0.0, f64::INFINITY), |best, here| if here.1 < best.1 { here } else { best });
    if value.is_finite() { minimum((x - step).max(start), x + step, 20, f).1.min(value) } else { value }
}

/// Geometry of the moment balance, in units of the face length.
struct Block {
    slope: f64,     // tan φ
    toe: Vector,    // A
    ground: Vector, // unit vector from O along the ground
    thrust: Vector, // thrust of unit normal component on the soil
}

impl Block {
    fn of(face: &Face) -> Self {
        let (sin, cos) = face.surface.sin_cos();
        let along = (-cos, -sin);
        let normal = (sin, -cos);
        let friction = face.wall_friction.tan();
        Self {
            slope: face.friction_angle.tan(),
            toe: along,
            ground: (face.backfill.cos(), face.backfill.sin()),
            thrust: (normal.0 + friction * along.0, normal.1 + friction * along.1),
        }
    }

    /// K_n for the block that exits the ground at the distance `exit` after a sweep of `sweep` [rad] about
    /// its pole.
    fn thrust(&self, exit: f64, sweep: f64) -> f64 {
        // At zero sweep the pole is at infinity; this small sweep changes the thrust by less than 1e-5.
        let sweep = sweep.max(3e-3);
        let exit = (exit * self.ground.0, exit * self.ground.1);
        // Complex arithmetic: AB = r_A (e^{(tan φ + i) sweep} − 1).
        let chord = (exit.0 - self.toe.0, exit.1 - self.toe.1);
        let grown = (self.slope * sweep).exp();
        let arm = divide(chord, (grown * sweep.cos() - 1.0, grown * sweep.sin()));
        let pole = (self.toe.0 - arm.0, self.toe.1 - arm.1);
        let from_pole = |p: Vector| (p.0 - pole.0, p.1 - pole.1);
        if !self.is_admissible(pole) {
            return f64::INFINITY;
        }
        let weight = spiral_moment(arm, self.slope, sweep)
            + triangle_moment(from_pole(exit), from_pole((0.0, 0.0)))
            + triangle_moment(from_pole((0.0, 0.0)), arm);
        let lever = cross(from_pole((2.0 / 3.0 * self.toe.0, 2.0 / 3.0 * self.toe.1)), self.thrust);
        if weight > 0.0 && lever > 0.0 { 2.0 * weight / lever } else { f64::INFINITY }
    }
}

impl Block {
    /// Whether the block, rotating about `pole`, is pushed by the whole face and slides upwards along it.
    ///
    /// Otherwise the thrust would not be inclined as assumed, and its value would be no bound.
    fn is_admissible(&self, pole: Vector) -> bool {
        let normal = (-self.toe.1, self.toe.0);
        let velocity = |p: Vector| (pole.1 - p.1, p.0 - pole.0);
        let dot = |a: Vector, b: Vector| a.0 * b.0 + a.1 * b.1;
        let (top, toe) = (velocity((0.0, 0.0)), velocity(self.toe));
        dot(top, normal) >= 0.0 && dot(toe, normal) >= 0.0 && dot(top, self.toe) <= 0.0
    }
}

/// ∬ x dA of the sector between the pole and the spiral that starts at `arm`.
fn spiral_moment(arm: Vector, slope: f64, sweep: f64) -> f64 {
    let grown = (3.0 * slope * sweep).exp();
    let integral = divide((grown * sweep.cos() - 1.0, grown * sweep.sin()), (3.0 * slope, 1.0));
    (arm.0 * arm.0 + arm.1 * arm.1) / 3.0 * (arm.0 * integral.0 - arm.1 * integral.1)
}

/// ∬ x dA of the triangle from the pole to the edge `from`–`to`, signed by its orientation.
fn triangle_moment(from: Vector, to: Vector) -> f64 {
    cross(from, to) * (from.0 + to.0) / 6.0
}

fn cross(a: Vector, b: Vector) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

fn divide(a: Vector, b: Vector) -> Vector {
    let square = b.0 * b.0 + b.1 * b.1;
    ((a.0 * b.0 + a.1 * b.1) / square, (a.1 * b.0 - a.0 * b.1) / square)
}
