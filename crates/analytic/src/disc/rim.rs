//! The pressure on the rim and what it adds up to.

use super::Contact;
use crate::numeric::{gauss_points, integrate};

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
        // Differences of cosines and sines as products: nothing cancels on a shallow arc.
        let left = (0.5 * (self.angle - theta)).sin();
        let depth = 2.0 * self.radius * (0.5 * (self.angle + theta)).sin() * left;
        let chord = 2.0 * self.radius * (0.5 * theta).cos() * left;
        self.base + self.by_depth * depth + self.along_chord * chord
    }

    /// Sums of the pressure over the whole arc, by quadrature.
    #[must_use]
    pub fn reaction(&self) -> Reaction {
        let area = self.width * self.radius;
        let mut sum = Reaction { normal: 0.0, vertical: 0.0, horizontal: 0.0 };
        for (theta, weight) in gauss_points(0.0, self.angle) {
            let force = self.at(theta) * weight * area;
            sum.normal += force;
            sum.vertical += force * theta.cos();
            sum.horizontal += force * theta.sin();
        }
        sum
    }

    /// ∫σ f(θ) dA from θ = `from` to `to` [N].
    pub(crate) fn sum(&self, from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
        self.width * self.radius * integrate(from, to, |theta| self.at(theta) * f(theta))
    }
}
