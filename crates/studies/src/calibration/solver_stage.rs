//! The solver, calibrated through a surrogate of its curves: a design of runs, refinement where the best
//! values lie, and a last run that verifies what the surrogate says of them.

use super::interruptible::Interruptible;
use super::likelihood::{Likelihood, Response, Seen};
use super::prior::Prior;
use super::runs::{RunOutcome, Solver, SolverError, SolverPoint};
use super::stage::{Effort, Stage, calibrate_response};
use super::surrogate::Surrogate;
use crate::statistics::design::latin_hypercube;

/// Part of the budget that refines the design where the best values lie.
const REFINED: f64 = 0.25;
/// Runs besides one for each unknown that a surrogate needs.
const MORE_THAN_UNKNOWNS: usize = 5;
/// Points of a design over those that are wanted, at most, where cases refuse some of them.
const MOST_TRIED: usize = 8;
/// Distance of two points of the design, in standard deviations of the priors, below which a run says nothing
/// new.
const NEAR: f64 = 0.15;
/// Samples of each chain while the design is refined.
const QUICK: usize = 300;

/// The result of the solver.
#[derive(Clone, Debug)]
pub struct SolverStage {
    /// The calibration of the surrogate.
    pub stage: Stage,
    /// Every run, in order; the last one verifies.
    pub points: Vec<SolverPoint>,
    /// Q² of the surrogate's first component.
    pub predictivity: f64,
    /// Components of the surrogate.
    pub components: usize,
    /// The curves of the run at the best values, as residuals see them; `None` where it failed.
    pub verified: Option<Vec<f64>>,
    /// Largest difference between the run at the best values and the surrogate, over the surrogate's own
    /// error there.
    pub surprise: Option<f64>,
}

/// What the runs are to be.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Plan {
    /// Runs at most.
    pub budget: usize,
    /// Points that are run first, in the units of the unknowns.
    pub design: Vec<Vec<f64>>,
    /// Coordinates between which the design lies, by unknown; empty for the spread of the priors.
    pub ranges: Vec<[f64; 2]>,
}

/// The surrogate where the case allows the values.
struct Allowed<'a>(&'a Surrogate, &'a Solver<'a>);

impl Response for Allowed<'_> {
    fn at(&self, values: &[f64]) -> Result<Seen, String> {
        let surrogate = Interruptible { response: self.0, interrupts: self.1.interrupts };
        self.1.refusal(values).map_or_else(|| surrogate.at(values), Err)
    }
}

/// The least budget for so many unknowns.
#[must_use]
pub fn least_budget(unknowns: usize) -> usize {
    unknowns + MORE_THAN_UNKNOWNS + 2
}

/// Runs the plan and calibrates.
///
/// # Errors
/// [`SolverError`] where a signal stops it, a folder cannot be used, or too few runs are usable.
pub fn calibrate_solver(
    solver: &Solver<'_>,
    likelihood: &Likelihood,
    (plan, effort): (&Plan, Effort),
    tell: &mut dyn FnMut(&str),
) -> Result<SolverStage, SolverError> {
    let refined = ((REFINED * plan.budget as f64).ceil() as usize).max(1);
    let first = plan.budget.saturating_sub(refined + 1);
    let mut points = Vec::new();
    for values in initial(solver, plan, (first, effort.seed)) {
        points.push(told(solver, &values, (points.len() + 1, plan.budget), tell)?);
    }
    while points.len() + 1 < plan.budget {
        let values = next(solver, likelihood, &points, effort)?;
        points.push(told(solver, &values, (points.len() + 1, plan.budget), tell)?);
    }
    let surrogate = surrogate(solver, &points)?;
    tell("sampling the posterior of the surrogate");
    let allowed = Allowed(&surrogate, solver);
    let stage = calibrate_response(likelihood, &allowed, "the solver, through its surrogate", effort)
        .map_err(SolverError::Other)?;
    let last = told(solver, &stage.best, (points.len() + 1, plan.budget), tell)?;
    let verified = usable(&last).cloned();
    let surprise = verified.as_ref().map(|run| surprise(run, &surrogate, &stage.best));
    points.push(last);
    Ok(SolverStage {
        predictivity: surrogate.predictivity(),
        components: surrogate.components(),
        stage,
        points,
        verified,
        surprise,
    })
}

/// The curves of a run that can be used.
fn usable(point: &SolverPoint) -> Option<&Vec<f64>> {
    match &point.outcome {
        RunOutcome::Curves(values) => Some(values),
        RunOutcome::Failed(_) | RunOutcome::Refused(_) => None,
    }
}

fn told(
    solver: &Solver<'_>,
    values: &[f64],
    (number, of): (usize, usize),
    tell: &mut dyn FnMut(&str),
) -> Result<SolverPoint, SolverError> {
    let unknowns = solver.space.unknowns.iter().zip(values);
    let list: Vec<String> = unknowns.map(|(u, v)| format!("{} = {v} {}", u.name, u.unit)).collect();
    tell(&format!("run {number} of {of}: {}", list.join(", ").replace(" ,", ",")));
    let point = solver.run(values)?;
    match &point.outcome {
        RunOutcome::Curves(_) => {}
        RunOutcome::Failed(why) => tell(&format!("run {number} cannot be used: {why}")),
        RunOutcome::Refused(why) => tell(&format!("run {number}: the case refuses these values: {why}")),
    }
    Ok(point)
}

/// The points that are run before anything is known: those of the plan, then a Latin hypercube, without what
/// the case refuses.
fn initial(solver: &Solver<'_>, plan: &Plan, (count, seed): (usize, u64)) -> Vec<Vec<f64>> {
    let mut found: Vec<Vec<f64>> = plan.design.iter().take(count).cloned().collect();
    let spread = |prior: &Prior, n: usize| plan.ranges.get(n).copied().unwrap_or_else(|| prior.spread());
    let mut tried = count.saturating_sub(found.len());
    while found.len() < count && tried <= MOST_TRIED * count {
        let wanted = count - found.len();
        let design = latin_hypercube(tried.max(wanted), solver.space.dimension(), seed + tried as u64);
        let place = |unit: &Vec<f64>| {
            let unknowns = solver.space.unknowns.iter().enumerate();
            let coordinate = |(n, u): (usize, &super::space::Unknown)| {
                let [low, high] = spread(&u.prior, n);
                low + unit[n] * (high - low)
            };
            solver.space.values(&unknowns.map(coordinate).collect::<Vec<f64>>())
        };
        let allowed = design
            .unwrap_or_default()
            .iter()
            .map(place)
            .filter(|v| solver.refusal(v).is_none())
            .collect::<Vec<_>>();
        // A design of which the case allows too few is drawn again with as many more: what is left of a
        // hypercube fills space better than two of them.
        if allowed.len() >= wanted || 2 * tried > MOST_TRIED * count {
            found.extend(allowed.into_iter().take(wanted));
            break;
        }
        tried = 2 * tried.max(1);
    }
    found
}

fn surrogate(solver: &Solver<'_>, points: &[SolverPoint]) -> Result<Surrogate, SolverError> {
    let good: Vec<(Vec<f64>, Vec<f64>)> =
        points.iter().filter_map(|p| Some((p.values.clone(), usable(p)?.clone()))).collect();
    Surrogate::of(solver.space, &good).map_err(|why| {
        let reasons: Vec<&str> = points
            .iter()
            .filter_map(|point| match &point.outcome {
                RunOutcome::Failed(why) | RunOutcome::Refused(why) => Some(why.as_str()),
                RunOutcome::Curves(_) => None,
            })
            .take(3)
            .collect();
        SolverError::Other(format!(
            "{} of {} runs can be used, and no surrogate can be made of them: {why}\n{}",
            good.len(),
            points.len(),
            reasons.join("\n")
        ))
    })
}

/// The next point: the best one, or, where a run is near it already, the sample of the posterior that the
/// surrogate knows least of.
fn next(
    solver: &Solver<'_>,
    likelihood: &Likelihood,
    points: &[SolverPoint],
    effort: Effort,
) -> Result<Vec<f64>, SolverError> {
    let surrogate = surrogate(solver, points)?;
    let effort = Effort { samples: QUICK, seed: effort.seed + points.len() as u64 };
    let allowed = Allowed(&surrogate, solver);
    let stage =
        calibrate_response(likelihood, &allowed, "the surrogate", effort).map_err(SolverError::Other)?;
    let coordinates = |values: &[f64]| solver.space.coordinates(values);
    let distance = |values: &[f64]| {
        let here = coordinates(values);
        let to = |point: &SolverPoint| {
            let there = coordinates(&point.values);
            here.iter().zip(&there).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
        };
        points.iter().map(to).fold(f64::INFINITY, f64::min)
    };
    if distance(&stage.best) > NEAR {
        return Ok(stage.best);
    }
    let samples = stage.posterior.samples.iter();
    let open = samples.max_by(|a, b| surrogate.error_at(a).total_cmp(&surrogate.error_at(b)));
    Ok(open.cloned().unwrap_or(stage.best))
}

/// The largest difference between a run and the surrogate, in standard deviations of the latter.
fn surprise(run: &[f64], surrogate: &Surrogate, values: &[f64]) -> f64 {
    let Ok(seen) = surrogate.at(values) else { return f64::NAN };
    let error = |n: usize| {
        let shared: f64 = seen.shared.iter().map(|column| column[n] * column[n]).sum();
        (shared + seen.variances[n]).sqrt().max(1e-12)
    };
    let differences = run.iter().zip(&seen.values).enumerate();
    differences.map(|(n, (run, said))| (run - said).abs() / error(n)).fold(0.0, f64::max)
}
