//! The pressure on the rim and what it adds up to.

use super::Contact;
use crate::numeric::gauss_points;
use std::f64::consts::TAU;

/// Normal pressure on the contact arc: σ(θ) = base + by_depth · h(θ) + along_chord · r(θ) [Pa].
///
/// h = R(cos θ − cos θ_f) is the depth below the leading contact, r = R[sin α − sin(θ − α)] the distance from it along
/// the chord.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RimPressure {
    /// Pressure that does not change along the arc [Pa].
    pub base: f64,
    /// Growth with depth [Pa/m].
    pub by_depth: f64,
    /// Growth along the chord [Pa/m].
    pub along_chord: f64,
    /// Width over which it acts [m]: the thickness, or more where the ends of the wedge count.
    pub width: f64,
    /// Radius of the disc R [m].
    pub radius: f64,
    /// Contact angle θ_f [rad].
    pub angle: f64,
}

/// What the normal pressure of the rim adds up to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction {
    /// ∫σ dA, the normal thrust P_n [N].
    pub normal: f64,
    /// Vertical part V = ∫σ cos θ dA [N].
    pub vertical: f64,
    /// Horizontal part H = ∫σ sin θ dA [N].
    pub horizontal: f64,
}

impl RimPressure {
    /// A pressure-free arc of the given contact, to be filled in.
    pub(crate) fn on(contact: &Contact, diameter: f64, width: f64) -> Self {
        let (radius, angle) = (0.5 * diameter, contact.angle);
        Self { base: 0.0, by_depth: 0.0, along_chord: 0.0, width, radius, angle }
    }

    /// Pressure at θ [rad], 0 ≤ θ ≤ θ_f [Pa].
    #[must_use]
    pub fn at(&self, theta: f64) -> f64 {
        self.between((0.5 * self.angle).sin_cos(), (0.5 * theta).sin_cos())
    }

    /// Pressure [Pa] from the sine and cosine of θ_f/2 and of θ/2.
    fn between(&self, (sin_f, cos_f): (f64, f64), (sin, cos): (f64, f64)) -> f64 {
        // Differences of cosines and sines as products: nothing cancels on a shallow arc.
        let left = sin_f * cos - cos_f * sin;
        let depth = 2.0 * self.radius * (sin_f * cos + cos_f * sin) * left;
        let chord = 2.0 * self.radius * cos * left;
        self.base + self.by_depth * depth + self.along_chord * chord
    }
}

/// The load on the rim where the soil has one way out, or two and takes at each place the one that needs less.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RimLoad {
    pieces: [Piece; 3],
}

/// A stretch of the arc with one pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    from: f64,
    to: f64,
    pressure: RimPressure,
    /// Whether the pressure is that of the first of the two ways out.
    first: bool,
}

impl From<RimPressure> for RimLoad {
    fn from(pressure: RimPressure) -> Self {
        let end = pressure.angle;
        let piece = |from: f64| Piece { from, to: end, pressure, first: true };
        Self { pieces: [piece(0.0), piece(end), piece(end)] }
    }
}

impl RimLoad {
    /// At every place of the arc the smaller of two line loads σ · width [N/m].
    ///
    /// Their difference is a single sinusoid of θ, so that they cross at most twice, at angles known in closed form.
    #[must_use]
    pub fn weaker(first: RimPressure, second: RimPressure) -> Self {
        let end = first.angle;
        let [low, high] = crossings(&first, &second);
        let front = (0.5 * end).sin_cos();
        let piece = |from: f64, to: f64| {
            let middle = (0.25 * (from + to)).sin_cos();
            let load = |rim: &RimPressure| rim.width * rim.between(front, middle);
            let first_is_weaker = to > from && load(&first) <= load(&second);
            let pressure = if first_is_weaker { first } else { second };
            Piece { from, to, pressure, first: first_is_weaker }
        };
        Self { pieces: [piece(0.0, low), piece(low, high), piece(high, end)] }
    }

    /// Contact angle θ_f [rad].
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.pieces[0].pressure.angle
    }

    /// Radius of the disc R [m].
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.pieces[0].pressure.radius
    }

    /// Sums of the pressure over the whole arc.
    #[must_use]
    pub fn reaction(&self) -> Reaction {
        let mut sum = Reaction { normal: 0.0, vertical: 0.0, horizontal: 0.0 };
        for piece in &self.pieces {
            piece.forces(piece.from, piece.to, |force, sin, cos| {
                sum.normal += force;
                sum.vertical += force * cos;
                sum.horizontal += force * sin;
            });
        }
        sum
    }

    /// The normal thrust between the angles `from` and `to` [N].
    #[must_use]
    pub fn thrust(&self, from: f64, to: f64) -> f64 {
        self.sum(from, to, |_, _| 1.0)
    }

    /// ∫σ f(sin θ, cos θ) dA from θ = `from` to `to` [N].
    pub(crate) fn sum(&self, from: f64, to: f64, f: impl Fn(f64, f64) -> f64) -> f64 {
        let mut sum = 0.0;
        for piece in &self.pieces {
            let (from, to) = (from.max(piece.from), to.min(piece.to));
            piece.forces(from, to, |force, sin, cos| sum += force * f(sin, cos));
        }
        sum
    }

    /// Share of the normal thrust where the first of the two ways out needs less, 0 to 1.
    #[must_use]
    pub fn share_of_first(&self) -> f64 {
        let part = |piece: &Piece| self.thrust(piece.from, piece.to);
        let first: f64 = self.pieces.iter().filter(|piece| piece.first).map(part).sum();
        first / self.thrust(0.0, self.angle())
    }
}

impl Piece {
    /// Hands the normal force of every quadrature point between two angles to `add`, with the sine and cosine of θ.
    fn forces(&self, from: f64, to: f64, mut add: impl FnMut(f64, f64, f64)) {
        if to <= from {
            return;
        }
        let rim = &self.pressure;
        let front = (0.5 * rim.angle).sin_cos();
        for (half, weight) in gauss_points(0.5 * from, 0.5 * to) {
            let (sin, cos) = half.sin_cos();
            let force = rim.between(front, (sin, cos)) * 2.0 * weight * rim.width * rim.radius;
            add(force, 2.0 * sin * cos, (cos - sin) * (cos + sin));
        }
    }
}

/// Angles [rad] at which two line loads on the same arc cross, in order; an end of the arc where there is none.
fn crossings(one: &RimPressure, other: &RimPressure) -> [f64; 2] {
    let end = one.angle;
    let (sin, cos) = (0.5 * end).sin_cos();
    let (by_depth, along) = (
        one.radius * (one.width * one.by_depth - other.width * other.by_depth),
        one.radius * (one.width * one.along_chord - other.width * other.along_chord),
    );
    // h = R (cos θ − cos θ_f) and r = R [sin α − sin(θ − α)]: the difference is constant + a cos θ + b sin θ.
    let constant =
        one.width * one.base - other.width * other.base - by_depth * (cos * cos - sin * sin) + along * sin;
    let (a, b) = (by_depth + along * sin, -along * cos);
    let turn = (-constant / a.hypot(b)).acos();
    let middle = b.atan2(a);
    let inside = |theta: f64| {
        let theta = theta.rem_euclid(TAU);
        if theta < end { theta } else { 0.0 }
    };
    if turn.is_nan() {
        return [0.0, 0.0];
    }
    let (low, high) = (inside(middle - turn), inside(middle + turn));
    [low.min(high), low.max(high)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_weaker_load_is_the_smaller_everywhere() {
        let arc = |base: f64, by_depth: f64, along_chord: f64, width: f64| RimPressure {
            base,
            by_depth,
            along_chord,
            width,
            radius: 0.1,
            angle: 1.3,
        };
        let pairs = [
            (arc(10.0, 900.0, 0.0, 0.05), arc(0.0, 0.0, 600.0, 0.1)),
            (arc(30.0, 300.0, 0.0, 0.05), arc(0.0, 0.0, 900.0, 0.05)),
            (arc(1.0, 50.0, 0.0, 0.05), arc(5.0, 0.0, 900.0, 0.05)),
            (arc(5.0, 0.0, 0.0, 0.05), arc(1.0, 0.0, 0.0, 0.05)),
        ];
        for (one, other) in pairs {
            let weaker = RimLoad::weaker(one, other);
            let steps = 20_000;
            let width = 1.3 / f64::from(steps);
            let line = |rim: &RimPressure, theta: f64| rim.width * rim.at(theta);
            let sum: f64 = (0..steps)
                .map(|n| (f64::from(n) + 0.5) * width)
                .map(|theta| 0.1 * width * line(&one, theta).min(line(&other, theta)))
                .sum();
            assert!((weaker.reaction().normal / sum - 1.0).abs() < 1e-7, "{weaker:?}");
            assert!((weaker.thrust(0.0, 1.3) / sum - 1.0).abs() < 1e-7);
            assert!((0.0..=1.0).contains(&weaker.share_of_first()));
        }
    }
}
