//! A case and its variations: the case first, whose cost tells what the variations will take, then those that
//! the budget allows.

use super::options::{End, RunError, RunOptions, Start};
use super::part::Part;
use super::start::{self, ended_before, lock};
use super::{run_locked, verdict};
use case::{Case, estimate, require_valid, resolved};
use report::{Summary, add_confidence, confidence_lines, finished, make_variations_folder, variation_folder};
use results::confidence::variations::{ErrorSource, LeftOut, Variation, VariationPlan, in_place_of};
use results::confidence::{Confidence, Status, VariationResult};
use results::folder::clear_beside;
use results::progress;
use results::trust::Verdict;
use std::collections::VecDeque;

/// How long the variations may take together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Budget {
    /// A multiple of the time of the case's own run.
    Times(f64),
    /// Seconds of wall clock.
    Seconds(f64),
}

impl Default for Budget {
    /// Enough for all variations of most cases: three coarser meshes take up to one and a half times the
    /// case's own time, half the speed twice, the other precision once, and a larger domain up to twice.
    fn default() -> Self {
        Self::Times(8.0)
    }
}

impl Budget {
    pub(super) fn seconds(self, own_s: f64) -> f64 {
        match self {
            Self::Times(times) => times * own_s,
            Self::Seconds(seconds) => seconds,
        }
    }
}

/// What intervals are asked for.
#[derive(Clone, Copy, Debug)]
pub struct Request<'a> {
    /// The variations.
    pub plan: &'a VariationPlan,
    /// How long the variations may take; `None` for as long as they do.
    pub budget: Option<Budget>,
}

/// Time per cell and step in single precision over that in double (docs/reference/performance.md: two
/// thirds).
const SINGLE: f64 = 0.67;

/// Runs a case and its variations, and writes its results with the intervals that follow from all of them.
///
/// The case's own results lie in the folder as those of [`super::run`], and those of the variations below it
/// in `variations`. A variation is run if the time that is predicted for it, from that of the case's own run,
/// fits into what is left of the budget; otherwise it is reported as not examined. With [`Start::Resume`] and
/// [`Start::AutoResume`] runs that have finished are left unchanged, the one that was stopped is resumed, and
/// a larger budget examines what was left out.
///
/// # Errors
/// As [`super::run`]; [`RunError::Physics`] only where the case itself breaks down.
pub fn run_confidence(case: &Case, request: Request, options: &RunOptions) -> Result<End, RunError> {
    require_valid(case)?;
    for variation in &request.plan.variations {
        require_valid(&variation.case)?;
    }
    let _lock = lock(case, options)?;
    let own = match own_run(case, options)? {
        End::Finished(summary) => summary,
        stopped @ End::Stopped(..) => return Ok(stopped),
    };
    make_variations_folder(options.folder)?;
    let budget = request.budget.map(|budget| budget.seconds(own.wall_s));
    let mut account = Account { own: &own, case, budget, spent: 0.0, results: Vec::new() };
    let (meshes, others): (Vec<&Variation>, Vec<&Variation>) =
        request.plan.variations.iter().partition(|variation| variation.source == ErrorSource::Mesh);
    if let Some(stopped) = account.examine_meshes(meshes, options)? {
        return Ok(stopped);
    }
    for variation in others {
        if let Some(stopped) = account.examine(variation, options)? {
            return Ok(stopped);
        }
    }
    account.results.extend(request.plan.left_out.iter().map(left_out));
    let confidence = Confidence { budget_s: budget, spent_s: account.spent, ..Confidence::default() };
    let summary = add_confidence(options.folder, confidence, &account.results)?;
    let lines = [confidence_lines(&summary), verdict(&summary)].concat();
    progress::tell(&lines.join("\n"), options.quiet);
    Ok(End::Finished(Box::new(summary)))
}

/// The run of the case itself, unless it has finished before.
fn own_run(case: &Case, options: &RunOptions) -> Result<End, RunError> {
    if matches!(options.start, Start::Resume | Start::AutoResume) {
        match ended_before(case, options.folder) {
            Ok(Some(summary)) => return Ok(End::Finished(Box::new(summary))),
            Ok(None) => {}
            // A person asks for it again.
            Err(RunError::BrokeDownBefore { .. }) if options.start == Start::Resume => {}
            Err(other) => return Err(other),
        }
    } else if options.start == Start::Replace {
        clear_beside(options.folder)?;
    }
    run_locked(case, options, &Part { label: "the case itself".to_owned(), ..Part::default() })
}

/// What is said of a variation that is not run.
pub(super) fn left_out(left_out: &LeftOut) -> VariationResult {
    VariationResult {
        name: left_out.name.clone(),
        source: left_out.source,
        status: if left_out.is_asked_for { Status::NotApplicable } else { Status::NotAskedFor },
        because: Some(left_out.why.clone()),
        ..VariationResult::default()
    }
}

/// What was allowed and spent, and what became of the variations so far.
struct Account<'a> {
    own: &'a Summary,
    case: &'a Case,
    /// [s]
    budget: Option<f64>,
    /// [s]
    spent: f64,
    results: Vec<VariationResult>,
}

impl Account<'_> {
    /// Examines the case on other cells, with another mesh in place of each whose run is broken; how a run
    /// was stopped, if it was.
    fn examine_meshes(
        &mut self,
        planned: Vec<&Variation>,
        options: &RunOptions,
    ) -> Result<Option<End>, RunError> {
        let mut waiting: VecDeque<Variation> = planned.into_iter().cloned().collect();
        let (mut usable, mut used, mut most) = (Vec::new(), Vec::new(), 2 * waiting.len());
        while let Some(variation) = waiting.pop_front() {
            if let Some(stopped) = self.examine(&variation, options)? {
                return Ok(Some(stopped));
            }
            used.push(variation.case.clone());
            most = most.saturating_sub(1);
            match finished(options.folder, &variation.name)? {
                Some((_, summary)) if summary.trust.verdict == Verdict::Broken => {
                    let all: Vec<&Case> =
                        used.iter().chain(waiting.iter().map(|other| &other.case)).collect();
                    let good: Vec<&Case> =
                        usable.iter().chain(waiting.iter().map(|other| &other.case)).collect();
                    let own = (self.case, options.typed, options.source_name);
                    waiting.extend(in_place_of(&variation, (&good, &all), own).filter(|_| most > 0));
                }
                Some(_) => usable.push(variation.case),
                None => {}
            }
        }
        Ok(None)
    }

    /// Examines a variation, if it can be; how its run was stopped, if it was.
    fn examine(&mut self, variation: &Variation, options: &RunOptions) -> Result<Option<End>, RunError> {
        let predicted = self.predicted(variation);
        let mut result = VariationResult {
            name: variation.name.clone(),
            source: variation.source,
            what: variation.what.clone(),
            predicted_wall_s: Some(predicted),
            time_factor: variation.time_factor,
            ..VariationResult::default()
        };
        let resumes = matches!(options.start, Start::Resume | Start::AutoResume);
        if !(resumes && has_ended(variation, options)?) {
            let why = match self.objection(predicted) {
                None => start::objection(&variation.case, options)?,
                some => some,
            };
            if let Some(why) = why {
                result.because = Some(why);
                self.results.push(result);
                return Ok(None);
            }
            let label = format!("variation {}, {}", self.results.len() + 1, variation.name.replace('_', " "));
            if let Some(stopped) = run_variation(variation, label, options)? {
                return Ok(Some(stopped));
            }
        }
        if let Some((wall_s, _)) = finished(options.folder, &variation.name)? {
            self.spent += wall_s;
            result.status = Status::Examined;
        }
        self.results.push(result);
        Ok(None)
    }

    /// Time that a variation will take [s], by the work that it is beside the case itself.
    fn predicted(&self, variation: &Variation) -> f64 {
        self.own.wall_s * relative_cost(self.case, variation)
    }

    fn objection(&self, predicted: f64) -> Option<String> {
        if self.own.trust.verdict_without_confidence() == Verdict::Broken {
            return Some("the case's own run is broken".to_owned());
        }
        let budget = self.budget?;
        let left = budget - self.spent;
        (predicted > left).then(|| {
            format!(
                "it would take about {predicted:.1} s, and {:.1} s of the budget of {budget:.1} s are left: give more with --budget \
                 and --resume",
                left.max(0.0)
            )
        })
    }
}

/// Work of a variation over that of the case itself: steps times cells with soil, and how fast they are.
#[must_use]
pub fn relative_cost(case: &Case, variation: &Variation) -> f64 {
    work(&variation.case) / work(case)
}

/// Work of a case: steps times cells with soil, fewer in single precision.
pub(super) fn work(case: &Case) -> f64 {
    let estimate = estimate::estimate(case);
    let speed = if case.numerics.precision == resolved::Precision::Single { SINGLE } else { 1.0 };
    estimate.steps * estimate.filled_cells * speed
}

/// Whether the run of a variation has finished before; one of another version of it is run anew.
pub(super) fn has_ended(variation: &Variation, options: &RunOptions) -> Result<bool, RunError> {
    match ended_before(&variation.case, &variation_folder(options.folder, &variation.name)?) {
        Ok(summary) => Ok(summary.is_some()),
        Err(RunError::BrokeDownBefore { .. }) => Ok(true),
        Err(RunError::OtherCase(_)) => Ok(false),
        Err(other) => Err(other),
    }
}

/// Runs a variation; how it was stopped, if it was.
pub(super) fn run_variation(
    variation: &Variation,
    label: String,
    options: &RunOptions,
) -> Result<Option<End>, RunError> {
    let folder = variation_folder(options.folder, &variation.name)?;
    // What lies there after a budget that was smaller, or a version that varied it otherwise, is no longer of
    // use.
    let is_other = matches!(ended_before(&variation.case, &folder), Err(RunError::OtherCase(_)));
    let start = if is_other { Start::Replace } else { options.start };
    let own = RunOptions { folder: &folder, typed: &variation.typed, warnings: &[], start, ..*options };
    let _lock = lock(&variation.case, &own)?;
    let part = Part { label, is_beside: true };
    match run_locked(&variation.case, &own, &part) {
        Ok(End::Finished(_)) | Err(RunError::Physics { .. }) => Ok(None),
        Ok(stopped @ End::Stopped(..)) => Ok(Some(stopped)),
        Err(other) => Err(other),
    }
}
