//! A surrogate of a closed form: some of them take milliseconds, and a posterior takes ten thousands of
//! evaluations.

use super::likelihood::Response;
use super::prior::Prior;
use super::space::Space;
use super::surrogate::Surrogate;
use crate::statistics::design::latin_hypercube;

/// Evaluations: so many, and so many for each unknown, at most (chosen).
const POINTS: [usize; 3] = [16, 24, 160];
/// Standard deviations over which a normal prior is covered: nearly all of it.
const COVERED: f64 = 3.5;
/// Predictivity Q² from which the surrogate stands for the closed form of a body that is pressed down, whose
/// curves can be evaluated instead (chosen: an error of a thousandth of their spread), and of one under tow,
/// where that takes minutes (a hundredth).
const PREDICTIVE: [f64; 2] = [0.999_999, 0.9999];

/// A surrogate of a response over the priors; `None` where the response has no value somewhere, or is not
/// smooth enough to be predicted. What the surrogate errs enters the likelihood.
pub(super) fn emulated(
    space: &Space,
    response: &dyn Response,
    (seed, is_pressed): (u64, bool),
) -> Option<Surrogate> {
    let [few, each, most] = POINTS;
    let count = (few + each * space.dimension()).min(most);
    let covered = |prior: &Prior| if prior.is_normal() { [-COVERED, COVERED] } else { prior.spread() };
    let place = |unit: &Vec<f64>| {
        let unknowns = space.unknowns.iter().zip(unit);
        let coordinate = |(unknown, u): (&super::space::Unknown, &f64)| {
            let [low, high] = covered(&unknown.prior);
            low + u * (high - low)
        };
        space.values(&unknowns.map(coordinate).collect::<Vec<f64>>())
    };
    let design = latin_hypercube(count, space.dimension(), seed).ok()?;
    let evaluated = |values: Vec<f64>| {
        let seen = response.at(&values).ok()?;
        Some((values, seen.values))
    };
    let points: Vec<_> = design.iter().map(|unit| evaluated(place(unit))).collect::<Option<_>>()?;
    let surrogate = Surrogate::of(space, &points).ok()?;
    (surrogate.predictivity() >= PREDICTIVE[usize::from(!is_pressed)]).then_some(surrogate)
}
