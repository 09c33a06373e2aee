//! A case of a study, from its line to its outcome.

use super::assembly::together;
use super::expand::{self, reason};
use super::id::CaseId;
use super::line::CaseLine;
use super::outcome::{Ending, Outcome};
use super::store::{Store, StudyError};
use crate::responses::{self, Figures, GROUPS};
use crate::study::{BaseCase, ModelKind};
use coulter::case::{self, Case, CaseError};
use coulter::confidence::variations::{Asked, MESHES, variations};
use coulter::forecast::{self, Effort, Outlook};
use coulter::history::BodySample;
use coulter::history::quantities::{Quantity, Steady};
use coulter::history::reference::{Groups, Reference};
use coulter::history::steady::{SteadyPart, SteadyWindow};
use coulter::interrupts::Interrupts;
use coulter::output::folder::RunRecord;
use coulter::output::tables::read_history;
use coulter::output::{BodySummary, OutputError, Summary};
use coulter::run::{self, Device, End, Request, RunError, RunOptions, Start};
use coulter::trust::{Check, Verdict};
use std::path::Path;

/// Why a case has no outcome.
#[derive(Debug, thiserror::Error)]
pub enum Unended {
    /// The folder of the study could not be read or written, or no longer fits.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// The results of the run could not be written or read.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// Another engine is running the case.
    #[error("another engine is running the case {0}")]
    Busy(CaseId),
    /// A signal stopped the case; a run goes on from there.
    #[error("stopped by signal {0}")]
    Stopped(i32),
    /// Anything else.
    #[error("{0}")]
    Other(String),
}

/// What all cases of a study share.
#[derive(Clone, Debug)]
pub struct Shared {
    /// The folder of the study.
    pub store: Store,
    /// The cases that are varied.
    pub cases: Vec<BaseCase>,
    /// Threads of each run of the solver.
    pub threads: usize,
    /// What strains the soil.
    pub device: Device,
    /// Requests from outside.
    pub interrupts: Interrupts,
}

impl Shared {
    fn base(&self, line: &CaseLine) -> Result<&BaseCase, Unended> {
        let missing = || Unended::Other(format!("the study has no case number {}", line.case));
        self.cases.get(line.case).ok_or_else(missing)
    }
}

/// Brings a case to its outcome and enters it; one that has an outcome is left as it is.
///
/// # Errors
/// [`Unended`] where it has none; the reason is noted in the folder of the study, unless it was stopped or
/// another engine has it.
pub fn evaluate(shared: &Shared, line: &CaseLine) -> Result<Outcome, Unended> {
    if let Some(outcome) = shared.store.outcome(&line.id) {
        return Ok(outcome);
    }
    match outcome(shared, line) {
        Ok(outcome) => {
            shared.store.enter(&outcome)?;
            Ok(outcome)
        }
        Err(why @ (Unended::Busy(_) | Unended::Stopped(_))) => Err(why),
        Err(why) => {
            shared.store.note_failure(&line.id, &why.to_string())?;
            Err(why)
        }
    }
}

fn outcome(shared: &Shared, line: &CaseLine) -> Result<Outcome, Unended> {
    let refused =
        |reason: String| Outcome { id: line.id.clone(), ending: Ending::Refused, reason, rows: Vec::new() };
    if !line.refused.is_empty() {
        return Ok(refused(line.refused.clone()));
    }
    let base = shared.base(line)?;
    let case = match expand::read(base, line) {
        Ok(case) => case,
        Err(error) => return Err(Unended::Other(reason(&error))),
    };
    let now = expand::id(&case, line);
    if now != line.id {
        return Err(StudyError::Changed { id: line.id.clone(), now }.into());
    }
    match line.model {
        ModelKind::ClosedForm => Ok(match forecast::outlook(&case) {
            Ok(outlook) => Outcome {
                id: line.id.clone(),
                ending: Ending::Done,
                reason: if outlook.best().is_some() {
                    String::new()
                } else {
                    outlook.forecast.recommendation.replace('\n', " ")
                },
                rows: closed_forms(&outlook, &case, line),
            },
            Err(why) => refused(format!("there is no forecast for this case: {why}")),
        }),
        ModelKind::Solver => solved(shared, line, base, case),
    }
}

/// The radius [m] on which the first body that touches the soil rolls.
fn rolling_radius(case: &Case) -> Option<f64> {
    Reference::all(case).into_iter().find(Reference::has_surface)?.radius
}

/// The rows of the closed forms that apply to a case.
fn closed_forms(outlook: &Outlook, case: &Case, line: &CaseLine) -> Vec<Figures> {
    let recommended = outlook.best().map(|model| model.name);
    let groups = &outlook.forecast.groups;
    let radius = rolling_radius(case);
    let intervals = line.meshes.map(|_| forecast::intervals(outlook, Vec::new(), Effort::Quick));
    let intervals = intervals.map_or_else(Vec::new, |intervals| intervals.list);
    let applicable = outlook.forecast.models.iter().filter(|model| model.applicable);
    let rows = applicable.filter(|model| model.prediction.is_some()).map(|model| {
        let mut figures = Figures {
            model: model.name.to_owned(),
            body: outlook.input.kind.to_owned(),
            recommended: Some(model.name) == recommended,
            ..Figures::default()
        };
        for name in responses::names() {
            figures.say(name, outlook.predicted(model, name));
        }
        figures.say("t_bar", Some(groups.thickness));
        figures.say("W_bar", groups.weight);
        figures.say("E_bar", groups.stiffness);
        figures.say("c_bar", groups.cohesion);
        figures.say_traction(radius);
        for interval in intervals.iter().filter(|interval| interval.model == model.name) {
            figures.say_interval(interval.quantity, [interval.low, interval.high]);
        }
        figures
    });
    rows.collect()
}

/// Runs the solver: a new run, or one that goes on from its checkpoint.
fn solved(shared: &Shared, line: &CaseLine, base: &BaseCase, mut case: Case) -> Result<Outcome, Unended> {
    case.numerics.threads = shared.threads;
    let wrong = |error: CaseError| Unended::Other(reason(&error));
    let typed = case::overridden(&base.text, &base.path, &line.set).map_err(wrong)?;
    // The list of cases may come from anybody.
    if let Some(meshes) = line.meshes.filter(|meshes| !MESHES.contains(meshes)) {
        return Err(Unended::Other(format!("{meshes} meshes: two to six are possible")));
    }
    let asked = line.meshes.map(Asked::meshes_alone);
    let plan = asked.map(|asked| variations(&case, &typed, &base.path, &asked).map_err(wrong)).transpose()?;
    let folder = shared.store.run_folder(&line.id)?;
    let options = RunOptions {
        device: shared.device,
        ..RunOptions::quiet(&folder, Start::AutoResume, &typed, &base.path, &shared.interrupts)
    };
    let ended = |ending: Ending, reason: String, summary: &Summary| {
        let record = RunRecord::read(&folder)?;
        Ok(Outcome { id: line.id.clone(), ending, reason, rows: runs(&case, summary, (&folder, &record)) })
    };
    // A run that broke down has figures up to there, unless the machine went down with it.
    let broken = |reason: String| match Summary::read(&folder) {
        Ok(summary) => ended(Ending::Broken, reason, &summary),
        Err(_) => Ok(Outcome { id: line.id.clone(), ending: Ending::Broken, reason, rows: Vec::new() }),
    };
    let end = match &plan {
        Some(plan) => run::run_confidence(&case, Request { plan, budget: None }, &options),
        None => run::run(&case, &options),
    };
    match end {
        Ok(End::Finished(summary)) if summary.trust.verdict == Verdict::Broken => {
            ended(Ending::Broken, failed_checks(&summary), &summary)
        }
        Ok(End::Finished(summary)) => ended(Ending::Done, String::new(), &summary),
        Ok(End::Stopped(signal, _)) => Err(Unended::Stopped(signal)),
        Err(RunError::Physics { cause, .. }) => broken(cause.to_string()),
        Err(RunError::BrokeDownBefore { cause, .. }) => broken(cause),
        Err(RunError::Output(OutputError::Busy { .. })) => match shared.interrupts.stopped_by() {
            Some(signal) => Err(Unended::Stopped(signal)),
            None => Err(Unended::Busy(line.id.clone())),
        },
        Err(RunError::Output(error)) => Err(error.into()),
        Err(error) => Err(Unended::Other(error.to_string())),
    }
}

/// The checks that make a run broken, each with its figure and its limits.
fn failed_checks(summary: &Summary) -> String {
    let failed = summary.trust.checks.iter().filter(|check| check.verdict == Verdict::Broken);
    failed.map(Check::line).collect::<Vec<_>>().join("; ")
}

/// Part of a run, at its end, over which the figures of a body that still sinks are averaged (chosen: its
/// depth changes by some 2 %).
const AT_END: f64 = 0.02;

/// The means at the end of a run of a body that is pressed down until then, where a closed form is evaluated;
/// `None` for any other.
fn at_end(reference: &Reference, run: &RunRecord, samples: &[BodySample]) -> Option<Steady> {
    let whole = SteadyWindow::of(samples, reference, run.steady_part()).inside();
    let [first, last] = [whole.first()?.sinkage, whole.last()?.sinkage];
    let sinks = !reference.towed && last - first > AT_END * last.abs();
    let end = SteadyPart { fraction: AT_END, ..run.steady_part() };
    sinks.then(|| SteadyWindow::of(samples, reference, end).steady)
}

/// The rows of a run: one for every body with a surface; of several, before them one for all together.
fn runs(case: &Case, summary: &Summary, (folder, run): (&Path, &RunRecord)) -> Vec<Figures> {
    // A run that broke down may have no history that can be read; its means are what it has.
    let history = read_history(folder, &run.names(), false).map(|history| history.bodies).unwrap_or_default();
    let bodies = run.bodies.iter().enumerate().filter(|(_, reference)| reference.has_surface());
    let rows = bodies.filter_map(|(number, reference)| {
        let mut body = summary.bodies.get(&reference.name)?.clone();
        let end = history.get(number).and_then(|samples| at_end(reference, run, samples));
        body.steady = end.unwrap_or(body.steady);
        let groups =
            case.bodies.iter().find(|own| own.name == reference.name).map(|own| Groups::of(case, own));
        let mut figures = of_body(reference, &body);
        say_intervals(&mut figures, summary, &reference.name);
        figures.grade = Some(summary.trust.verdict.name().to_owned());
        figures.say("W_bar", groups.and_then(|groups| groups.w_bar));
        figures.say("E_bar", groups.and_then(|groups| groups.e_bar));
        figures.say("c_bar", groups.and_then(|groups| groups.c_bar));
        Some((figures, reference))
    });
    let (mut rows, references): (Vec<Figures>, Vec<&Reference>) = rows.unzip();
    if rows.len() > 1 {
        let weight = case.bodies.iter().map(|body| body.pressing_force(case.normal_weight(body))).sum();
        rows.insert(0, together(&rows, &references, weight));
    }
    if let Some(first) = rows.first_mut() {
        first.recommended = true;
    }
    rows
}

/// Says the intervals of a run on several meshes, and those of the dimensionless groups that follow.
fn say_intervals(figures: &mut Figures, summary: &Summary, body: &str) {
    let found = summary.confidence.as_ref().and_then(|confidence| confidence.bodies.get(body));
    for (quantity, figure) in found.iter().flat_map(|body| &body.figures) {
        figures.say_interval(quantity, figure.interval);
    }
}

fn of_body(reference: &Reference, BodySummary { steady, peak, .. }: &BodySummary) -> Figures {
    let mut figures =
        Figures { model: "solver".to_owned(), body: reference.name.clone(), ..Figures::default() };
    for quantity in Quantity::all() {
        figures.say(quantity.figure.name, quantity.mean(steady));
    }
    figures.say("slip", steady.slip);
    figures.say("pull", steady.traction.drawbar_pull);
    figures.say_traction(None);
    let group = |name: &str| {
        let quantity = Quantity::named(name)?;
        reference.group(quantity.column.unit, quantity.mean(steady)?)
    };
    figures.say("efficiency", steady.traction.tractive_efficiency);
    figures.say("peak_drag", peak.drag);
    figures.say("peak_vertical", peak.vertical);
    figures.say("drag_noise", steady.drag_noise);
    for [name, quantity] in GROUPS {
        figures.say(name, group(quantity));
    }
    figures.say("t_bar", reference.length_group(reference.width));
    figures
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_that_is_pressed_to_the_end_has_the_figures_of_its_last_depth() {
        let sample = |n: u32| BodySample {
            time: 1e-3 * f64::from(n),
            sinkage: 60e-6 * f64::from(n),
            vertical: f64::from(n),
            ..BodySample::default()
        };
        let samples: Vec<BodySample> = (0..=1000).map(sample).collect();
        let (plate, run) = (
            Reference { length: 0.1, ..Reference::default() },
            RunRecord { steady_fraction: 0.3, ..RunRecord::default() },
        );
        let end = at_end(&plate, &run, &samples).unwrap();
        assert!((end.vertical.unwrap() - 990.0).abs() < 1.0 && (end.sinkage.unwrap() - 0.0594).abs() < 1e-4);
        let held: Vec<BodySample> =
            samples.iter().map(|s| BodySample { sinkage: s.sinkage.min(0.03), ..*s }).collect();
        assert_eq!(at_end(&plate, &run, &held), None, "held at its depth in the whole window");
        let towed = Reference { towed: true, ..plate };
        assert_eq!(at_end(&towed, &run, &samples), None);
    }
}
