//! The pressure at which a spherical cavity grows without limit.

use crate::error::{ModelResult, finite, positive, undefined, within};
use crate::soil::Soil;
use numerics::search::root;

/// Elastic constants of the soil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffness {
    /// Young's modulus E [Pa].
    pub young_modulus: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
}

impl Stiffness {
    /// Shear modulus G = E/(2 (1 + ν)) [Pa].
    #[must_use]
    pub fn shear_modulus(&self) -> f64 {
        0.5 * self.young_modulus / (1.0 + self.poisson_ratio)
    }
}

/// Terms of the series at most; it converges like an exponential.
const TERMS: usize = 400;
/// Largest logarithm of the ratio of stresses that is searched.
const MOST: f64 = 25.0;

/// Limit pressure [Pa] of a spherical cavity in soil under the mean stress p₀ [Pa], with large strains,
/// friction and dilation.
///
/// Source: Yu & Houlsby (1991), Géotechnique 41(2), 173–183: Λ₁(R, ξ) = (η/γ)(1 − δ)^{(β+2)/β} for a/a₀ → ∞.
/// A numerical solution of the self-similar problem agrees within 0.3 %.
///
/// # Errors
/// Unless φ > 0, the other inputs are in range, and the soil is stiff enough to fail before it has halved its
/// volume.
pub fn limit_pressure(soil: &Soil, stiffness: &Stiffness, mean_stress: f64) -> ModelResult<f64> {
    let phi = within("friction angle [rad]", soil.friction_angle, 0.1_f64.to_radians(), 50_f64.to_radians())?;
    let psi = within("dilation angle [rad]", soil.dilation_angle, -phi, phi)?;
    let modulus = positive("elastic modulus [Pa]", stiffness.young_modulus)?;
    let nu = within("Poisson's ratio", stiffness.poisson_ratio, 0.0, 0.5)?;
    let p = positive("mean stress [Pa]", mean_stress)?;
    let flow = |angle: f64| (1.0 + angle.sin()) / (1.0 - angle.sin());
    let (alpha, beta) = (flow(phi), flow(psi));
    let strength = 2.0 * soil.cohesion * phi.cos() / (1.0 - phi.sin());
    let start = strength + (alpha - 1.0) * p;
    let gamma = alpha * (beta + 2.0) / (2.0 * (alpha - 1.0) * beta);
    let delta = start / (2.0 * (2.0 + alpha) * stiffness.shear_modulus());
    if delta > 0.5 {
        return undefined(
            "the limit pressure",
            "the soil is too soft: it would yield elastically to any push",
        );
    }
    let eta = ((beta + 2.0) * (1.0 - 2.0 * nu) * start / (modulus * (alpha - 1.0) * beta)).exp();
    let elastic = alpha * beta + 2.0 * (1.0 - 2.0 * nu) + 2.0 * nu - 2.0 * nu * (alpha + beta);
    let xi = 3.0 * delta / ((1.0 + nu) * (alpha - 1.0) * beta) * elastic;
    let target = eta / gamma * (1.0 - delta).powf((beta + 2.0) / beta);
    let excess = |log: f64| series(log, xi, gamma) - target;
    let most = (1..=50).map(|n| MOST * f64::from(n) / 50.0).find(|log| excess(*log) > 0.0);
    let found = most.and_then(|most| root(0.0, most, 1e-10, excess));
    let Some(log) = found else {
        return undefined("the limit pressure", "the cavity has none for these elastic constants");
    };
    let end = log.exp() * alpha * 3.0 * start / (2.0 + alpha);
    finite("limit pressure", (end - strength) / (alpha - 1.0))
}

/// Λ₁(x, y) = Σ yⁿ/n! (x^{n−γ} − 1)/(n − γ), ln x in place of the last fraction for n = γ; of ln x.
fn series(log: f64, y: f64, gamma: f64) -> f64 {
    let (mut sum, mut power) = (0.0, 1.0);
    for n in 0..TERMS {
        if n > 0 {
            power *= y / n as f64;
        }
        let order = n as f64 - gamma;
        let term = power * if order.abs() < 1e-9 { log } else { (order * log).exp_m1() / order };
        sum += term;
        if n > 4 && term.abs() < 1e-14 * sum.abs() {
            break;
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    fn soil(phi: f64, psi: f64, cohesion: f64) -> Soil {
        Soil {
            friction_angle: phi.to_radians(),
            dilation_angle: psi.to_radians(),
            cohesion,
            unit_weight: 16e3,
            body_friction: 0.3,
            adhesion_factor: 1.0,
            strength_gradient: 0.0,
        }
    }

    /// The expansion of the cavity solved along the similarity variable r/b: equilibrium and yield give the
    /// stresses of the plastic zone, the flow rule with Hooke's law in rates the velocity, and the cavity is
    /// where the soil moves with its wall (Collins, Pender & Wang 1992).
    fn integrated(soil: &Soil, stiffness: &Stiffness, p: f64) -> f64 {
        let (phi, psi) = (soil.friction_angle, soil.dilation_angle);
        let flow = |angle: f64| (1.0 + angle.sin()) / (1.0 - angle.sin());
        let (alpha, beta) = (flow(phi), flow(psi));
        let strength = 2.0 * soil.cohesion * phi.cos() / (1.0 - phi.sin());
        let start = strength + (alpha - 1.0) * p;
        let delta = start / (2.0 * (2.0 + alpha) * stiffness.shear_modulus());
        let (modulus, nu) = (stiffness.young_modulus, stiffness.poisson_ratio);
        let power = 2.0 * (alpha - 1.0) / alpha;
        let shift = strength / (alpha - 1.0);
        let scale = p + 4.0 * stiffness.shear_modulus() * delta + shift;
        let slope = |s: f64, w: f64| {
            let radial = -power * scale * s.powf(-power - 1.0) * (w - s);
            let hoop = radial / alpha;
            let rates = [radial - 2.0 * nu * hoop, (1.0 - nu) * hoop - nu * radial].map(|r| r / modulus);
            -rates[0] - 2.0 / beta * (w / s + rates[1])
        };
        let (mut s, mut w) = (1.0, 3.0 * delta);
        while w < s {
            let step = -5e-4 * s;
            let first = slope(s, w);
            let second = slope(s + 0.5 * step, w + 0.5 * step * first);
            let third = slope(s + 0.5 * step, w + 0.5 * step * second);
            let fourth = slope(s + step, w + step * third);
            (s, w) = (s + step, w + step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth));
        }
        scale * s.powf(-power) - shift
    }

    #[test]
    fn the_series_solves_the_self_similar_problem() {
        let rows = [
            (30.0, 0.0, 0.0, 5e6, 2.5e3),
            (40.0, 10.0, 0.0, 5e6, 2.5e3),
            (38.0, 8.0, 0.0, 50e6, 100e3),
            (25.0, 5.0, 3e3, 8e6, 5e3),
        ];
        for (phi, psi, cohesion, young_modulus, p) in rows {
            let (soil, stiffness) =
                (soil(phi, psi, cohesion), Stiffness { young_modulus, poisson_ratio: 0.3 });
            let found = limit_pressure(&soil, &stiffness, p).unwrap();
            let known = integrated(&soil, &stiffness, p);
            assert!((found / known - 1.0).abs() < 3e-3, "{phi} {psi}: {found} for {known}");
        }
    }

    /// Nearly without friction: 4/3 s_u (1 + ln G/s_u) above the pressure at rest (Bishop, Hill & Mott 1945).
    #[test]
    fn without_friction_it_is_that_of_metal() {
        let stiffness = Stiffness { young_modulus: 3e6, poisson_ratio: 0.499 };
        let (strength, p) = (10e3, 50e3);
        let found = limit_pressure(&soil(0.1, 0.0, strength), &stiffness, p).unwrap();
        let known = p + 4.0 / 3.0 * strength * (1.0 + (stiffness.shear_modulus() / strength).ln());
        assert!((found / known - 1.0).abs() < 0.02, "{found} for {known}");
        assert!(
            limit_pressure(&soil(30.0, 0.0, 0.0), &Stiffness { young_modulus: 1.0, ..stiffness }, p).is_err()
        );
    }
}
