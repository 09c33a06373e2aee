//! What is known of the unknowns afterwards: intervals, correlations, and what cannot be told apart.

use super::likelihood::Likelihood;
use super::sampler::{Chains, covariance};
use numerics::quantile_of_sorted;

/// One unknown after the calibration, in its unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Marginal {
    /// Name of the unknown.
    pub name: String,
    /// Unit of the unknown.
    pub unit: String,
    /// Prior of the unknown, as it may be typed.
    pub prior: String,
    /// The most likely value, together with the others.
    pub best: f64,
    /// The median.
    pub median: f64,
    /// The 90 % interval: 5 and 95 % quantiles.
    pub interval: [f64; 2],
    /// Width of the interval over that of the prior's own 90 % interval, in the coordinates in which that is
    /// spread evenly or normally.
    pub width: f64,
    /// R̂ of the chains.
    pub reduction: f64,
    /// Effective number of draws.
    pub effective: f64,
}

/// What a user must know of a posterior.
#[derive(Clone, Debug, PartialEq)]
pub struct Advice {
    /// What is the matter, naming the unknowns.
    pub message: String,
    /// What would help.
    pub cure: String,
}

/// The posterior distribution.
#[derive(Clone, Debug, PartialEq)]
pub struct Posterior {
    /// The distribution of each unknown.
    pub marginals: Vec<Marginal>,
    /// Correlations of the coordinates of unknowns.
    pub correlations: Vec<Vec<f64>>,
    /// The noise and its 90 % interval, as a part of the value, where it was estimated.
    pub noise: Option<[f64; 3]>,
    /// The samples, values of the unknowns in their units.
    pub samples: Vec<Vec<f64>>,
    /// Fraction of proposals that were accepted.
    pub acceptance: f64,
}

/// Correlation from which two unknowns cannot be told apart.
const CORRELATED: f64 = 0.9;
/// Width of an interval over that of the prior from which the measurements say little.
const OPEN: f64 = 0.7;
/// R̂ above which chains have not found the same (Gelman et al. 2013).
const REDUCTION: f64 = 1.1;
/// Samples that are kept for charts and documents.
const KEPT: usize = 2000;

impl Posterior {
    /// The posterior from the best coordinates and samples of a density.
    pub(super) fn of(likelihood: &Likelihood, best: &[f64], chains: &Chains) -> Self {
        let space = &likelihood.space;
        let all: Vec<&Vec<f64>> = chains.all().collect();
        let values = space.values(best);
        let marginal = |(n, unknown): (usize, &super::space::Unknown)| {
            let mut coordinates: Vec<f64> = all.iter().map(|sample| sample[n]).collect();
            coordinates.sort_by(f64::total_cmp);
            let at = |q: f64| quantile_of_sorted(&coordinates, q);
            Marginal {
                name: unknown.name.clone(),
                unit: unknown.unit.clone(),
                prior: unknown.prior.text(&unknown.unit),
                best: values[n],
                median: unknown.prior.value(at(0.5)),
                interval: [0.05, 0.95].map(|q| unknown.prior.value(at(q))),
                width: (at(0.95) - at(0.05)) / unknown.prior.width(),
                reduction: chains.reduction(n),
                effective: chains.effective(n),
            }
        };
        let noise = likelihood.estimates_noise().then(|| {
            let last = space.dimension();
            let mut list: Vec<f64> = all.iter().map(|sample| sample[last]).collect();
            list.sort_by(f64::total_cmp);
            [0.5, 0.05, 0.95].map(|q| likelihood.noise.at(Some(quantile_of_sorted(&list, q))))
        });
        let every = all.len().div_ceil(KEPT).max(1);
        Self {
            marginals: space.unknowns.iter().enumerate().map(marginal).collect(),
            correlations: correlations(&all, space.dimension()),
            noise,
            samples: all.iter().step_by(every).map(|sample| space.values(sample)).collect(),
            acceptance: chains.acceptance,
        }
    }

    /// Warnings: unknowns that cannot be told apart, those that the measurements leave open, and chains that
    /// disagree.
    #[must_use]
    pub fn advice(&self) -> Vec<Advice> {
        let mut list = self.correlated();
        let open: Vec<&Marginal> = self.marginals.iter().filter(|m| m.width > OPEN).collect();
        list.extend(open.iter().map(|marginal| {
            let (name, width) = (&marginal.name, 100.0 * marginal.width);
            Advice {
                message: format!(
                    "{name} is left open: its interval is {width:.0} % as wide as that of its prior"
                ),
                cure: format!("its prior decides it, not the measurements; {}", separating(&[name])),
            }
        }));
        let worst = self.marginals.iter().map(|m| m.reduction).fold(1.0, f64::max);
        if worst > REDUCTION {
            list.push(Advice {
                message: format!("the chains of samples disagree (R̂ = {worst:.2})"),
                cure: "take intervals for rough; more samples, --samples, or narrower priors help".to_owned(),
            });
        }
        list
    }

    fn correlated(&self) -> Vec<Advice> {
        let mut list = Vec::new();
        for (i, one) in self.marginals.iter().enumerate() {
            for (j, other) in self.marginals.iter().enumerate().take(i) {
                let correlation = self.correlations[i][j];
                if correlation.abs() > CORRELATED {
                    let (one, other) = (&other.name, &one.name);
                    list.push(Advice {
                        message: format!(
                            "{one} and {other} cannot be told apart: the correlation of their samples is {correlation:.2}"
                        ),
                        cure: format!(
                            "only a combination of them is known; give one of them from elsewhere, or {}",
                            separating(&[one, other])
                        ),
                    });
                }
            }
        }
        list
    }
}

/// Which measurement would tell unknowns, by what their names end with.
fn separating(names: &[&str]) -> String {
    const KNOWN: [(&str, &str); 10] = [
        ("unit_weight", "weigh a known volume of the soil"),
        ("density", "weigh a known volume of the soil"),
        (
            "friction_angle",
            "add a direct shear test, or a body of another size: friction grows with the weight of the soil",
        ),
        ("dilation_angle", "add a shear test with its change of volume"),
        (
            "cohesion",
            "add a curve of a body of another size or at another depth: cohesion does not grow with depth",
        ),
        ("friction", "measure friction by sliding a loaded plate of the body's material over the soil"),
        ("modulus", "add an oedometer test"),
        ("strain", "add a triaxial or shear test from its start: it says how fast strength is mobilised"),
        ("shear_strength", "add a vane test"),
        ("e_max", "measure the densities of the loosest and the densest state"),
    ];
    let advice = |name: &&str| KNOWN.iter().find(|(end, _)| name.ends_with(end)).map(|(_, advice)| *advice);
    let mut found: Vec<&str> = names.iter().filter_map(advice).collect();
    found.dedup();
    if found.is_empty() { "add a curve of another kind of body".to_owned() } else { found.join("; or ") }
}

fn correlations(samples: &[&Vec<f64>], dimension: usize) -> Vec<Vec<f64>> {
    let samples: Vec<Vec<f64>> = samples.iter().map(|sample| sample[..dimension].to_vec()).collect();
    let covariance = covariance(&samples);
    let entry = |i: usize, j: usize| {
        let scale = (covariance[i][i] * covariance[j][j]).sqrt();
        if i == j {
            1.0
        } else if scale > 0.0 {
            covariance[i][j] / scale
        } else {
            0.0
        }
    };
    (0..dimension).map(|i| (0..dimension).map(|j| entry(i, j)).collect()).collect()
}
