//! Pressure on the rim and its resultants.

use super::Contact;
use numerics::quadrature::gauss_points;
use std::f64::consts::TAU;

/// Normal pressure on the contact arc: σ(θ) = base + by_depth · h(θ) + along_chord · r(θ) [Pa].
///
/// h = R(cos θ − cos θ_f) is the depth below the leading contact, r = R[sin α − sin(θ − α)] the distance from
/// it along the chord.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RimPressure {
    /// Uniform pressure [Pa].
    pub base: f64,
    /// Gradient over the depth h [Pa/m].
    pub by_depth: f64,
    /// Gradient over the distance r along the chord [Pa/m].
    pub along_chord: f64,
    /// Effective width [m]: the thickness, times the end factor for a wedge.
    pub width: f64,
    /// Radius of the disc R [m].
    pub radius: f64,
    /// Contact angle θ_f [rad].
    pub angle: f64,
}

/// Resultants of the normal pressure on the rim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction {
    /// ∫σ dA, the normal thrust P_n [N].
    pub normal: f64,
    /// Vertical component V = ∫σ cos θ dA [N].
    pub vertical: f64,
    /// Horizontal component H = ∫σ sin θ dA [N].
    pub horizontal: f64,
}

impl RimPressure {
    /// Zero pressure on the given contact arc, to be filled in.
    pub(crate) fn on(contact: &Contact, diameter: f64, width: f64) -> Self {
        let (radius, angle) = (0.5 * diameter, contact.angle);
        Self { base: 0.0, by_depth: 0.0, along_chord: 0.0, width, radius, angle }
    }

    /// Pressure at θ [rad], 0 ≤ θ ≤ θ_f, in [Pa].
    #[must_use]
    pub fn at(&self, theta: f64) -> f64 {
        self.at_half_angles((0.5 * self.angle).sin_cos(), (0.5 * theta).sin_cos())
    }

    /// Pressure [Pa] from the sine and cosine of θ_f/2 and of θ/2.
    fn at_half_angles(&self, (sin_f, cos_f): (f64, f64), (sin, cos): (f64, f64)) -> f64 {
        // Differences of cosines and sines as products, which avoids cancellation on a shallow arc.
        let sine = sin_f * cos - cos_f * sin;
        let depth = 2.0 * self.radius * (sin_f * cos + cos_f * sin) * sine;
        let chord = 2.0 * self.radius * cos * sine;
        self.base + self.by_depth * depth + self.along_chord * chord
    }
}

/// Load on the rim from one failure mechanism, or at each point from the governing one of two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RimLoad {
    segments: [Segment; 3],
}

/// A segment of the arc on which one mechanism governs.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Segment {
    from: f64,
    to: f64,
    pressure: RimPressure,
    /// Whether the pressure is that of the first mechanism.
    first: bool,
}

impl From<RimPressure> for RimLoad {
    fn from(pressure: RimPressure) -> Self {
        let end = pressure.angle;
        let segment = |from: f64| Segment { from, to: end, pressure, first: true };
        Self { segments: [segment(0.0), segment(end), segment(end)] }
    }
}

impl RimLoad {
    /// The lower envelope of two line loads σ · width [N/m]: the lower one at every point of the arc.
    ///
    /// The lower of two pressures along the rim. Their difference is a single sinusoid of θ, so they cross at
    /// most twice, at angles known in closed form.
    #[must_use]
    pub fn lower_envelope(first: RimPressure, second: RimPressure) -> Self {
        let end = first.angle;
        let [low, high] = crossings(&first, &second);
        let front = (0.5 * end).sin_cos();
        let segment = |from: f64, to: f64| {
            let middle = (0.25 * (from + to)).sin_cos();
            let load = |rim: &RimPressure| rim.width * rim.at_half_angles(front, middle);
            let first_governs = to > from && load(&first) <= load(&second);
            let pressure = if first_governs { first } else { second };
            Segment { from, to, pressure, first: first_governs }
        };
        Self { segments: [segment(0.0, low), segment(low, high), segment(high, end)] }
    }

    /// Contact angle θ_f [rad].
    #[must_use]
    pub fn angle(&self) -> f64 {
        self.segments[0].pressure.angle
    }

    /// Radius of the disc R [m].
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.segments[0].pressure.radius
    }

    /// Resultants over the whole arc.
    #[must_use]
    pub fn reaction(&self) -> Reaction {
        let mut sum = Reaction { normal: 0.0, vertical: 0.0, horizontal: 0.0 };
        for segment in &self.segments {
            segment.forces(segment.from, segment.to, |force, sin, cos| {
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
        for segment in &self.segments {
            let (from, to) = (from.max(segment.from), to.min(segment.to));
            segment.forces(from, to, |force, sin, cos| sum += force * f(sin, cos));
        }
        sum
    }

    /// Fraction of the normal thrust where the first mechanism governs, 0 to 1.
    #[must_use]
    pub fn fraction_of_first(&self) -> f64 {
        let thrust = |segment: &Segment| self.thrust(segment.from, segment.to);
        let first: f64 = self.segments.iter().filter(|segment| segment.first).map(thrust).sum();
        first / self.thrust(0.0, self.angle())
    }
}

impl Segment {
    /// Calls `add` with the normal force of every quadrature point between two angles and the sine and cosine
    /// of θ.
    fn forces(&self, from: f64, to: f64, mut add: impl FnMut(f64, f64, f64)) {
        if to <= from {
            return;
        }
        let rim = &self.pressure;
        let front = (0.5 * rim.angle).sin_cos();
        for (half, weight) in gauss_points(0.5 * from, 0.5 * to) {
            let (sin, cos) = half.sin_cos();
            let force = rim.at_half_angles(front, (sin, cos)) * 2.0 * weight * rim.width * rim.radius;
            add(force, 2.0 * sin * cos, (cos - sin) * (cos + sin));
        }
    }
}

/// Angles [rad] at which two line loads on the same arc cross, in ascending order; 0 where there is no
/// crossing.
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
    let half_width = (-constant / a.hypot(b)).acos();
    let middle = b.atan2(a);
    let inside = |theta: f64| {
        let theta = theta.rem_euclid(TAU);
        if theta < end { theta } else { 0.0 }
    };
    if half_width.is_nan() {
        return [0.0, 0.0];
    }
    let (low, high) = (inside(middle - half_width), inside(middle + half_width));
    [low.min(high), low.max(high)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lower_envelope_is_the_pointwise_minimum() {
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
            let envelope = RimLoad::lower_envelope(one, other);
            let steps = 20_000;
            let width = 1.3 / f64::from(steps);
            let line = |rim: &RimPressure, theta: f64| rim.width * rim.at(theta);
            let sum: f64 = (0..steps)
                .map(|n| (f64::from(n) + 0.5) * width)
                .map(|theta| 0.1 * width * line(&one, theta).min(line(&other, theta)))
                .sum();
            assert!((envelope.reaction().normal / sum - 1.0).abs() < 1e-7, "{envelope:?}");
            assert!((envelope.thrust(0.0, 1.3) / sum - 1.0).abs() < 1e-7);
            assert!((0.0..=1.0).contains(&envelope.fraction_of_first()));
        }
    }
}
