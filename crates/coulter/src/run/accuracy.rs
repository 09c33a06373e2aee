//! A run that finds its own cells: coarse ones first, whose figures tell how fine the cells of the answer
//! have to be, with the effects of the domain and of the speed on one of these.

use super::confidence::{Budget, has_ended, left_out, run_variation, work};
use super::options::{End, RunError, RunOptions, Start};
use super::part::Part;
use super::start::{self, ended_before, lock};
use super::{run_locked, verdict};
use case::{Case, require_valid};
use report::{
    Summary, add_confidence, clear_all, confidence_lines, explored, finished, make_variations_folder,
    require_nothing, run_of,
};
use results::confidence::variations::{Asked, ErrorSource, Variation, on_step, variations};
use results::confidence::{Confidence, Status, VariationResult, Wanted};
use results::folder::hash_of;
use results::progress;
use results::trust::Verdict;

/// The coarsest cells that are tried, in steps of a quarter of an octave from the case's own: twice as wide.
const COARSEST: i32 = 4;
/// The finest: a quarter as wide.
const FINEST: i32 = -8;
/// Meshes before the answer's own: with it there are four, from which on trend and scatter are told apart.
const EXPLORED: usize = 3;
/// Steps beyond the finest mesh so far that a trend is trusted for; where finer cells are needed, one is
/// explored in between.
const TRUSTED: i32 = 3;

/// How accurate the figures of a run are to be.
#[derive(Clone, Debug, Default)]
pub struct Accuracy {
    /// Half-widths of the intervals of the figures.
    pub wanted: Wanted,
    /// How long all runs may take together.
    pub budget: Budget,
    /// Sources that are not examined.
    pub without: Vec<ErrorSource>,
}

/// Runs a case on cells of its own choice, so that the intervals (90 %) of its figures become as narrow as
/// wanted.
///
/// Meshes from cells twice as wide on are run as variations, each finer by a factor of 1.19, until three are
/// not broken. On the finest of these the effects of the domain and of the speed are examined, which are
/// taken for those on the cells of the answer. Trends, scatter and statistics tell the widest cells on which
/// the wanted half-widths are to be expected; the case is run on these, or on the finest that the budget
/// allows, and its results with the intervals from all meshes are those of the folder. A coarse mesh that
/// breaks is passed over.
///
/// # Errors
/// As [`super::run`]; [`RunError::Physics`] where the run on the cells that were chosen breaks down.
pub fn run_accuracy(case: &Case, accuracy: &Accuracy, options: &RunOptions) -> Result<End, RunError> {
    require_valid(case)?;
    let _lock = lock(case, options)?;
    match options.start {
        Start::Anew => require_nothing(options.folder)?,
        Start::Replace => clear_all(options.folder)?,
        Start::Resume | Start::AutoResume => {}
    }
    make_variations_folder(options.folder)?;
    let mut search =
        Search { case, accuracy, options, spent: 0.0, rate: None, meshes: Vec::new(), others: Vec::new() };
    if let Some(stopped) = search.explore()? {
        return Ok(stopped);
    }
    if let Some(stopped) = search.examine_others()? {
        return Ok(stopped);
    }
    match search.choose()? {
        Chosen::Stopped(end) => Ok(end),
        Chosen::Own(own) => search.conclude(&own),
    }
}

/// What follows from the meshes so far.
enum Chosen {
    /// The case on the cells of the answer.
    Own(Box<Variation>),
    /// A run was stopped.
    Stopped(End),
}

/// A mesh that was run.
struct Explored {
    step: i32,
    variation: Variation,
    /// Whether the run on the mesh is not broken.
    is_usable: bool,
}

struct Search<'a> {
    case: &'a Case,
    accuracy: &'a Accuracy,
    options: &'a RunOptions<'a>,
    /// [s]
    spent: f64,
    /// Time per work of the last mesh [s].
    rate: Option<f64>,
    meshes: Vec<Explored>,
    /// What was examined beside the cells.
    others: Vec<VariationResult>,
}

impl Search<'_> {
    /// The case on the cells of a step.
    fn mesh(&self, step: i32) -> Result<Variation, RunError> {
        let taken: Vec<&Case> = self.meshes.iter().map(|mesh| &mesh.variation.case).collect();
        on_step((self.case, self.options.typed, self.options.source_name), step, &taken)
            .map_err(RunError::Case)
    }

    /// Runs meshes from the coarsest on until three can be used; how a run was stopped, if it was.
    fn explore(&mut self) -> Result<Option<End>, RunError> {
        let mut refused = None;
        for step in (FINEST + TRUSTED..=COARSEST).rev() {
            if self.usable().count() == EXPLORED {
                return Ok(None);
            }
            match self.mesh(step) {
                Ok(mesh) if self.usable().count() > 1 && self.objection(&mesh)?.is_some() => return Ok(None),
                Ok(mesh) => {
                    if let Some(stopped) = self.examine(step, mesh)? {
                        return Ok(Some(stopped));
                    }
                }
                Err(error) => refused = refused.or(Some(error)),
            }
        }
        match refused {
            Some(error) if self.usable().count() == 0 => Err(error),
            _ => Ok(None),
        }
    }

    fn usable(&self) -> impl Iterator<Item = &Explored> {
        self.meshes.iter().filter(|mesh| mesh.is_usable)
    }

    /// The finest step so far.
    fn finest(&self) -> i32 {
        self.usable().map(|mesh| mesh.step).min().unwrap_or(1)
    }

    /// Why a mesh is not run, if what is left of the budget or the device does not allow it.
    fn objection(&self, mesh: &Variation) -> Result<Option<String>, RunError> {
        let exceeds = |rate: f64| {
            self.spent + rate * work(&mesh.case) > self.accuracy.budget.seconds(rate * work(self.case))
        };
        if self.rate.is_some_and(exceeds) {
            let why = "the budget is too small for it: give more with --budget and --resume";
            return Ok(Some(why.to_owned()));
        }
        Ok(start::objection(&mesh.case, self.options)?)
    }

    /// Runs a variation, unless it has finished before; how it was stopped, if it was.
    fn run(&self, variation: &Variation, label: String) -> Result<Option<End>, RunError> {
        let resumes = matches!(self.options.start, Start::Resume | Start::AutoResume);
        if resumes && has_ended(variation, self.options)? {
            return Ok(None);
        }
        run_variation(variation, label, self.options)
    }

    /// Examines the effects of the domain and of the speed on the finest mesh so far; how a run was stopped,
    /// if it was.
    fn examine_others(&mut self) -> Result<Option<End>, RunError> {
        let Some(base) = self.usable().min_by_key(|mesh| mesh.step).map(|mesh| mesh.variation.clone()) else {
            return Ok(None);
        };
        let both = [ErrorSource::Mesh, ErrorSource::Precision];
        let without = [&both, &self.accuracy.without[..]].concat();
        let asked = Asked { without, ..Asked::default() };
        let plan =
            variations(&base.case, &base.typed, self.options.source_name, &asked).map_err(RunError::Case)?;
        for variation in &plan.variations {
            let mut result = VariationResult {
                name: variation.name.clone(),
                source: variation.source,
                what: format!("{}, on {}", variation.what, base.what),
                time_factor: variation.time_factor,
                beside: Some(base.name.clone()),
                ..VariationResult::default()
            };
            result.because = self.objection(variation)?;
            if result.because.is_none() {
                let label = format!("{}, {}", variation.name.replace('_', " "), base.what);
                if let Some(stopped) = self.run(variation, label)? {
                    return Ok(Some(stopped));
                }
                if let Some((wall_s, _)) = finished(self.options.folder, &variation.name)? {
                    self.spent += wall_s;
                    result.status = Status::Examined;
                }
            }
            self.others.push(result);
        }
        let not_run = plan.left_out.iter().filter(|left_out| left_out.source != ErrorSource::Mesh);
        self.others.extend(not_run.map(left_out));
        Ok(None)
    }

    /// Runs a mesh, unless it has finished before; how it was stopped, if it was.
    fn examine(&mut self, step: i32, mesh: Variation) -> Result<Option<End>, RunError> {
        let label = format!("mesh {}, {}", self.meshes.len() + 1, mesh.what);
        if let Some(stopped) = self.run(&mesh, label)? {
            return Ok(Some(stopped));
        }
        let Some((wall_s, summary)) = finished(self.options.folder, &mesh.name)? else { return Ok(None) };
        self.spent += wall_s;
        self.rate = Some(wall_s / work(&mesh.case));
        let is_usable = summary.trust.verdict != Verdict::Broken;
        self.meshes.push(Explored { step, variation: mesh, is_usable });
        Ok(None)
    }

    fn results(&self) -> Vec<VariationResult> {
        let result = |mesh: &Explored| VariationResult {
            name: mesh.variation.name.clone(),
            source: mesh.variation.source,
            what: mesh.variation.what.clone(),
            status: Status::Examined,
            time_factor: 1.0,
            ..VariationResult::default()
        };
        self.meshes.iter().map(result).chain(self.others.iter().cloned()).collect()
    }

    /// The cells of the answer: those that were chosen before the run was stopped, or the widest that promise
    /// what is wanted, or the finest that the budget allows.
    fn choose(&mut self) -> Result<Chosen, RunError> {
        loop {
            let finest = self.finest();
            if let Some(chosen) = self.begun(finest)? {
                return Ok(chosen);
            }
            let needed = self.needed(finest)?.min(finest - 1);
            let affordable = (needed..finest)
                .find(|step| matches!(self.mesh(*step).and_then(|mesh| self.objection(&mesh)), Ok(None)))
                .unwrap_or(finest);
            if affordable == finest
                && let Some(at) = self.meshes.iter().position(|mesh| mesh.step == finest)
            {
                // The finest mesh so far, in the place of the answer.
                return Ok(Chosen::Own(Box::new(self.meshes.remove(at).variation)));
            }
            if affordable > finest - TRUSTED {
                return Ok(Chosen::Own(Box::new(self.mesh(affordable)?)));
            }
            let between = finest - TRUSTED + 1;
            match self.mesh(between) {
                Ok(mesh) => {
                    if let Some(stopped) = self.examine(between, mesh)? {
                        return Ok(Chosen::Stopped(stopped));
                    }
                }
                Err(_) => return Ok(Chosen::Own(Box::new(self.mesh(affordable)?))),
            }
            if self.finest() == finest {
                // Its run is broken, and says nothing.
                return Ok(Chosen::Own(Box::new(self.mesh(affordable)?)));
            }
        }
    }

    /// The case whose run the folder holds already, if it is resumed, after the meshes that were explored for
    /// it.
    fn begun(&mut self, finest: i32) -> Result<Option<Chosen>, RunError> {
        let Some(hash) = run_of(self.options.folder)? else { return Ok(None) };
        let is_it = |mesh: &Variation| hash_of(&mesh.case) == hash;
        if let Some(at) = self.meshes.iter().position(|mesh| is_it(&mesh.variation)) {
            return Ok(Some(Chosen::Own(Box::new(self.meshes.remove(at).variation))));
        }
        for step in (FINEST..finest).rev() {
            let Ok(mesh) = self.mesh(step) else { continue };
            if is_it(&mesh) {
                return Ok(Some(Chosen::Own(Box::new(mesh))));
            }
            if finished(self.options.folder, &mesh.name)?.is_some()
                && let Some(stopped) = self.examine(step, mesh)?
            {
                return Ok(Some(Chosen::Stopped(stopped)));
            }
        }
        Err(RunError::OtherCase(self.options.folder.to_path_buf()))
    }

    /// The widest cells, by their step, on which every figure is to be expected as accurate as wanted; the
    /// finest where none are.
    fn needed(&self, finest: i32) -> Result<i32, RunError> {
        let confidence = explored(self.options.folder, &self.results())?;
        let promises = |step: i32| {
            let ratio = 2_f64.powf(0.25 * f64::from(step - finest));
            let bodies = confidence.iter().flat_map(|confidence| confidence.bodies.values());
            let mut figures = bodies.flat_map(|body| &body.figures);
            figures.all(|(key, figure)| match (self.accuracy.wanted.of(key), figure.predicted(ratio)) {
                (Some(wanted), Some(predicted)) => predicted <= wanted,
                _ => true,
            })
        };
        Ok((FINEST..finest).rev().find(|step| promises(*step)).unwrap_or(FINEST))
    }

    /// Runs the case on the cells that were chosen, and adds the intervals from all meshes.
    fn conclude(&self, own: &Variation) -> Result<End, RunError> {
        let typed = format!("# With {}: chosen by coulter run --accuracy.\n{}", own.what, own.typed);
        let options = RunOptions { typed: &typed, ..*self.options };
        let summary = match ended_before(&own.case, options.folder) {
            Ok(Some(summary)) => Box::new(summary),
            Ok(None) | Err(RunError::BrokeDownBefore { .. }) => {
                let start = if run_of(options.folder)?.is_some() { options.start } else { Start::Anew };
                let part = Part { label: format!("the answer, {}", own.what), ..Part::default() };
                match run_locked(&own.case, &RunOptions { start, ..options }, &part)? {
                    End::Finished(summary) => summary,
                    stopped @ End::Stopped(..) => return Ok(stopped),
                }
            }
            Err(other) => return Err(other),
        };
        let Accuracy { wanted, budget, .. } = self.accuracy;
        let budget_s = self.rate.map(|rate| budget.seconds(rate * work(self.case)));
        let spent_s = self.spent + summary.wall_s;
        let confidence = Confidence { budget_s, spent_s, wanted: wanted.clone(), ..Confidence::default() };
        let summary = add_confidence(options.folder, confidence, &self.results())?;
        let lines = [confidence_lines(&summary), self.reached(&summary), verdict(&summary)].concat();
        progress::tell(&lines.join("\n"), options.quiet);
        Ok(End::Finished(Box::new(summary)))
    }

    /// What was wanted and what was reached, a line each; and what would reach the rest.
    fn reached(&self, summary: &Summary) -> Vec<String> {
        let mut lines = Vec::new();
        let Some(confidence) = &summary.confidence else { return lines };
        for (name, body) in &confidence.bodies {
            for (key, figure) in &body.figures {
                let (Some(wanted), Some(half)) = (self.accuracy.wanted.of(key), figure.relative_half_width)
                else {
                    continue;
                };
                let figure_name =
                    results::history::quantities::Quantity::keyed(key).map_or("", |q| q.figure.words);
                let what = format!("accuracy of the {figure_name} of {name}: ± {:.1} %", 100.0 * half);
                lines.push(if half <= wanted {
                    format!("{what}, {:.1} % wanted", 100.0 * wanted)
                } else {
                    format!(
                        "{what}, {:.1} % wanted and not reached: {}",
                        100.0 * wanted,
                        figure.what_helps(wanted)
                    )
                });
            }
        }
        lines
    }
}
