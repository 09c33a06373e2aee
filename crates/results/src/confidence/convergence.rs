//! What infinitely small cells would give, from a figure on several meshes: Bayesian regression over the cell
//! width.
//!
//! Figures of contact jump from mesh to mesh with the place of a surface in a cell, so that a few of them say
//! little of an order of convergence. A figure is taken for f = f₀ + α (h/h₁)^p + scatter, with orders p of 1
//! and 2, a scatter of σ, and what is known beforehand of α and σ. The formulas, the priors and what the
//! method of Eça and Hoekstra (2014) gave on the same figures are in `docs/theory/confidence.md`.
//!
//! Source: Gelman, Carlin, Stern, Dunson, Vehtari and Rubin (2013), Bayesian data analysis, 3rd edition,
//! section 14.8 (regression with a prior on coefficients) and chapter 10 (quadrature of hyperparameters).

use serde::{Deserialize, Serialize};

/// Standard deviation of the discretisation error on the finest mesh before any other was run, over the scale
/// of the figure (chosen: about twice that of exact rows on cells that are graded good).
const EXPECTED_ERROR: f64 = 0.1;
/// Median of the scatter from mesh to mesh over the scale of the figure, and the standard deviation of its
/// logarithm (chosen: nine of ten scatters lie between 0.14 and 7 %).
const EXPECTED_SCATTER: [f64; 2] = [0.01, 1.2];
/// Orders of convergence: of what is placed to a fraction of a cell, and of smooth fields.
const ORDERS: [f64; 2] = [1.0, 2.0];
/// Scatters over the scale of the figure between which is integrated, and their number.
const SCATTERS: [f64; 2] = [1e-5, 0.5];
const COUNT: usize = 60;
/// Quantile of the normal distribution that leaves 5 % on a side.
const NORMAL_90: f64 = 1.645;

/// A figure on one mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnMesh {
    /// Representative cell width h [m].
    pub width: f64,
    /// The figure, in its unit.
    pub value: f64,
}

/// What infinitely small cells would give, as far as several meshes tell.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Convergence {
    /// Cell widths over that of the finest mesh, from coarse to fine.
    pub widths: Vec<f64>,
    /// Expected value for h = 0, in the unit of the figure.
    pub extrapolated: f64,
    /// Half-width (90 %) of the interval about it, in the unit of the figure.
    pub half_width: f64,
    /// Expected discretisation error on the finest mesh, in the unit of the figure.
    pub error: f64,
    /// Expected order of convergence: between that of the first and of the second.
    pub order: f64,
    /// Expected scatter from mesh to mesh, in the unit of the figure.
    pub scatter: f64,
    /// What error and scatter were compared with beforehand, in the unit of the figure.
    pub scale: f64,
}

impl Convergence {
    /// The convergence of a figure of the size `scale` on meshes from coarse to fine; `None` with fewer than
    /// two, with values that are not numbers and with widths that do not fall.
    #[must_use]
    pub fn of(meshes: &[OnMesh], scale: f64) -> Option<Self> {
        let is_usable = |m: &OnMesh| m.value.is_finite() && m.width.is_finite() && m.width > 0.0;
        let falls = meshes.windows(2).all(|pair| pair[0].width > pair[1].width);
        if meshes.len() < 2 || !falls || !meshes.iter().all(is_usable) || !scale.is_finite() {
            return None;
        }
        let finest = meshes.last()?;
        let widths: Vec<f64> = meshes.iter().map(|mesh| mesh.width / finest.width).collect();
        if scale <= 0.0 {
            let equal = Self { widths, extrapolated: finest.value, order: ORDERS[0], ..Self::default() };
            return meshes.iter().all(|mesh| mesh.value == finest.value).then_some(equal);
        }
        // In units of the scale and from the finest value, so that a large mean costs no digits.
        let values: Vec<f64> = meshes.iter().map(|mesh| (mesh.value - finest.value) / scale).collect();
        let mean = mixed(&widths, &values);
        Some(Self {
            widths,
            extrapolated: finest.value + scale * mean.limit,
            half_width: scale * NORMAL_90 * mean.variance.sqrt(),
            error: scale * mean.error,
            order: mean.order,
            scatter: scale * mean.scatter,
            scale,
        })
    }

    /// The expected figure on cells `ratio` times as wide as those of the finest mesh.
    #[must_use]
    pub fn at(&self, ratio: f64) -> f64 {
        self.extrapolated + self.error * ratio.powf(self.order)
    }

    /// The half-width that is to be expected once another mesh is known, with cells `ratio` times as wide as
    /// those of the finest.
    #[must_use]
    pub fn half_width_with(&self, ratio: f64) -> f64 {
        if self.scale <= 0.0 {
            return self.half_width;
        }
        let variance = |more: &[f64]| {
            let widths: Vec<f64> = self.widths.iter().chain(more).copied().collect();
            let none = vec![0.0; widths.len()];
            Posterior::of(&widths, &none, self.order, (self.scatter / self.scale).max(SCATTERS[0])).variance
        };
        // What is left of the present half-width, which also knows how uncertain order and scatter are.
        self.half_width * (variance(&[ratio]) / variance(&[])).sqrt()
    }
}

/// Mean and variance of what the figures tell, for one order and one scatter; or mixed over all.
#[derive(Clone, Copy, Debug, Default)]
struct Posterior {
    limit: f64,
    variance: f64,
    error: f64,
    order: f64,
    scatter: f64,
    /// Logarithm of the probability of the figures.
    evidence: f64,
}

impl Posterior {
    /// The posterior of figures with the covariance σ² I + s² g gᵀ, g = x^p, about a limit of which nothing
    /// is known.
    fn of(widths: &[f64], values: &[f64], order: f64, scatter: f64) -> Self {
        let powers: Vec<f64> = widths.iter().map(|width| width.powf(order)).collect();
        let (noise, prior) = (scatter * scatter, EXPECTED_ERROR * EXPECTED_ERROR);
        let dot = |a: &dyn Fn(usize) -> f64, b: &dyn Fn(usize) -> f64| -> f64 {
            (0..widths.len()).map(|n| a(n) * b(n)).sum()
        };
        let (one, power, value) = (|_: usize| 1.0, |n: usize| powers[n], |n: usize| values[n]);
        // Sherman and Morrison (1950): the inverse of the covariance.
        let squares = dot(&power, &power);
        let shrink = prior / (noise + prior * squares);
        let weighted = |a: &dyn Fn(usize) -> f64, b: &dyn Fn(usize) -> f64| {
            (dot(a, b) - shrink * dot(a, &power) * dot(b, &power)) / noise
        };
        let (precision, moment) = (weighted(&one, &one), weighted(&one, &value));
        let limit = moment / precision;
        let beside = |n: usize| values[n] - limit;
        let error = prior * weighted(&power, &beside);
        let misfit = weighted(&beside, &beside);
        let freedom = widths.len() as f64 - 1.0;
        let determinant = freedom * noise.ln() + (noise + prior * squares).ln();
        let evidence = -0.5 * (misfit + determinant + precision.ln());
        Self { limit, variance: 1.0 / precision, error, order, scatter, evidence }
    }
}

/// The posterior over all orders and scatters: means, and the variance of the limit with that of its means.
fn mixed(widths: &[f64], values: &[f64]) -> Posterior {
    let [least, most] = SCATTERS.map(f64::ln);
    let scatters = (0..COUNT).map(|n| least + (most - least) * n as f64 / (COUNT - 1) as f64);
    let all: Vec<Posterior> = scatters
        .flat_map(|scatter| ORDERS.map(|order| (scatter, order)))
        .map(|(scatter, order)| {
            let one = Posterior::of(widths, values, order, scatter.exp());
            let unusual = (scatter - EXPECTED_SCATTER[0].ln()) / EXPECTED_SCATTER[1];
            Posterior { evidence: one.evidence - 0.5 * unusual * unusual, ..one }
        })
        .collect();
    let largest = all.iter().map(|one| one.evidence).fold(f64::NEG_INFINITY, f64::max);
    let weight = |one: &Posterior| (one.evidence - largest).exp();
    let sum: f64 = all.iter().map(weight).sum();
    let mean =
        |of: &dyn Fn(&Posterior) -> f64| all.iter().map(|one| weight(one) * of(one)).sum::<f64>() / sum;
    let limit = mean(&|one| one.limit);
    Posterior {
        limit,
        variance: mean(&|one| one.variance + (one.limit - limit).powi(2)),
        error: mean(&|one| one.error),
        order: mean(&|one| one.order),
        scatter: mean(&|one| one.scatter),
        evidence: largest,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FOUR: [f64; 4] = [2.0, 1.587, 1.26, 1.0];

    fn on(meshes: &[[f64; 2]]) -> Convergence {
        let meshes: Vec<OnMesh> = meshes.iter().map(|&[width, value]| OnMesh { width, value }).collect();
        Convergence::of(&meshes, meshes[meshes.len() - 1].value.abs()).unwrap()
    }

    fn ends(found: &Convergence) -> [f64; 2] {
        [found.extrapolated - found.half_width, found.extrapolated + found.half_width]
    }

    #[test]
    fn the_limit_of_smooth_figures_is_held_by_a_narrow_interval() {
        for (order, half) in [(1.0, 0.06), (2.0, 0.04)] {
            let found = on(&FOUR.map(|h| [h, 100.0 + 5.0 * h.powf(order)]));
            let [low, high] = ends(&found);
            assert!(low < 100.0 && 100.0 < high && found.half_width < half * 100.0, "{order} {found:?}");
            assert!((found.error - 5.0).abs() < 2.5 && found.scatter < 1.0, "{found:?}");
        }
    }

    #[test]
    fn what_only_scatters_has_an_interval_of_the_size_of_its_scatter() {
        // The sinkage and the drag of a towed disc.
        let sinkage = on(&[[2.0, 41.2], [1.587, 48.3], [1.26, 39.8], [1.0, 44.0]]);
        assert!(sinkage.half_width > 4.0 && sinkage.half_width < 12.0, "{sinkage:?}");
        let drag = on(&[[2.0, 47.1], [1.587, 49.8], [1.26, 46.9], [1.0, 50.0]]);
        assert!(drag.half_width > 2.0 && drag.half_width < 7.0, "{drag:?}");
    }

    #[test]
    fn more_meshes_narrow_the_interval_as_was_expected() {
        let figure = |h: f64| 50.0 + 2.0 * h + 0.5 * (40.0 * h).sin().signum();
        let before = on(&FOUR.map(|h| [h, figure(h)]));
        let expected = before.half_width_with(0.7);
        let after = on(&[2.0, 1.587, 1.26, 1.0, 0.7].map(|h| [h, figure(h)]));
        assert!(
            expected < before.half_width && (after.half_width / expected - 1.0).abs() < 0.6,
            "{expected} {after:?}"
        );
        assert!(before.half_width_with(0.25) < expected);
    }

    #[test]
    fn two_meshes_say_something_and_unit_and_sign_do_not_matter() {
        let found = on(&[[1.5, 11.0], [1.0, 10.0]]);
        assert!(found.half_width > 0.5 && found.half_width < 3.0, "{found:?}");
        let other = on(&[[1.5e-3, -11e3], [1e-3, -10e3]]);
        assert!((other.half_width / found.half_width - 1e3).abs() < 1e-6, "{other:?}");
        assert!((other.extrapolated + 1e3 * found.extrapolated).abs() < 1e-6);
    }

    #[test]
    fn figures_that_are_all_the_same_have_next_to_no_interval() {
        let found = on(&FOUR.map(|h| [h, 7.0]));
        assert!((found.extrapolated - 7.0).abs() < 1e-9 && found.half_width < 0.2, "{found:?}");
        let nothing = Convergence::of(&FOUR.map(|width| OnMesh { width, value: 0.0 }), 0.0).unwrap();
        assert_eq!((nothing.half_width, nothing.half_width_with(0.5)), (0.0, 0.0));
    }

    #[test]
    fn what_is_no_mesh_study_has_no_interval() {
        let none = |meshes: &[[f64; 2]]| {
            let meshes: Vec<OnMesh> = meshes.iter().map(|&[width, value]| OnMesh { width, value }).collect();
            assert_eq!(Convergence::of(&meshes, 1.0), None);
        };
        none(&[]);
        none(&[[1.0, 1.0]]);
        none(&[[1.0, 1.0], [1.5, 1.0]]);
        none(&[[1.0, 1.0], [1.0, 1.0]]);
        none(&[[1.5, f64::NAN], [1.0, 1.0]]);
        none(&[[1.5, 1.0], [0.0, 1.0]]);
    }
}
