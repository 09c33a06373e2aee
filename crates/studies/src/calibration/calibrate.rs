//! A calibration from request to result.

use super::closed::{ClosedResponse, NoClosedForm};
use super::data::{MeasuredCurve, Selection, Taken};
use super::emulated::emulated;
use super::interruptible::Interruptible;
use super::likelihood::{Likelihood, Noise, Response};
use super::runs::{Solver, SolverError};
use super::solver_stage::{Plan, SolverStage, calibrate_solver, least_budget};
use super::space::Space;
use super::stage::{Effort, Stage, calibrate_response};
use crate::measured::{Quantity, Record, settle_force};
use crate::sources::{Along, ClosedForm, LeftOut};
use coulter::case::{self, CaseError};
use coulter::interrupts::Interrupts;
use coulter::run::Device;
use std::path::Path;
use xxhash_rust::xxh3::xxh3_64;

/// Which model is calibrated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModelChoice {
    /// The closed form.
    ClosedForm,
    /// The solver.
    Solver,
    /// Both models, the closed form first.
    Both,
}

/// The request for a calibration.
#[derive(Clone, Debug)]
pub struct Request<'a> {
    /// The case file.
    pub case: &'a Path,
    /// Keys that are set besides.
    pub overrides: &'a [String],
    /// The unknowns.
    pub space: Space,
    /// The measurements.
    pub records: Vec<Record>,
    /// How curves are taken from the measurements.
    pub selection: Selection,
    /// The model.
    pub model: ModelChoice,
    /// The closed form; `None` for the recommended one.
    pub closed_form: Option<&'a str>,
    /// The noise.
    pub noise: Noise,
    /// The error of the model that a curve has in common, as a part of the value.
    pub model_error: f64,
    /// How long to sample.
    pub effort: Effort,
    /// The runs of the solver.
    pub plan: Plan,
    /// Whether the design of the solver lies within what the closed form leaves open.
    pub narrow: bool,
    /// Threads of a run.
    pub threads: Option<usize>,
    /// What strains the soil of a run.
    pub device: Device,
    /// Where the runs lie.
    pub folder: &'a Path,
}

impl Request<'_> {
    /// Digits that change with the text of the case, with what was measured, and with the points that are run
    /// first.
    #[must_use]
    pub fn fingerprint(&self, case: &str) -> String {
        format!("{:016x}", xxh3_64(format!("{case}{:?}{:?}", self.records, self.plan.design).as_bytes()))
    }
}

/// The result of a calibration.
#[derive(Clone, Debug)]
pub struct Calibration {
    /// Points of the measurements that were not fitted.
    pub left_out: Vec<LeftOut>,
    /// The closed form.
    pub closed: Option<Stage>,
    /// The solver.
    pub solver: Option<SolverStage>,
    /// Remarks on how the measurements were read.
    pub remarks: Vec<String>,
}

impl Calibration {
    /// The calibration that counts: that of the solver, where there is one.
    #[must_use]
    pub fn last(&self) -> Option<&Stage> {
        self.solver.as_ref().map(|solver| &solver.stage).or(self.closed.as_ref())
    }
}

/// Why there is no calibration.
#[derive(Debug, thiserror::Error)]
pub enum CalibrationError {
    /// Case, parameters or measurements are wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The request cannot be met; says what to do instead.
    #[error("{0}")]
    Request(String),
    /// A signal stopped the calibration; what was run stays.
    #[error("stopped")]
    Stopped(i32),
}

impl From<NoClosedForm> for CalibrationError {
    fn from(error: NoClosedForm) -> Self {
        match error {
            NoClosedForm::Case(error) => Self::Case(error),
            NoClosedForm::Model(why) => Self::Request(why),
        }
    }
}

impl From<SolverError> for CalibrationError {
    fn from(error: SolverError) -> Self {
        match error {
            SolverError::Case(error) => Self::Case(error),
            SolverError::Stopped(signal) => Self::Stopped(signal),
            SolverError::Other(why) => Self::Request(why),
        }
    }
}

/// Standard deviations of the closed form's posterior to which a design is narrowed (chosen: the closed form
/// is in error, too).
const NARROWED: f64 = 3.0;

/// Calibrates a case; `tell` hears of the progress.
///
/// # Errors
/// [`CalibrationError`] says what is wrong, and what to do about it.
pub fn calibrate(
    request: &Request<'_>,
    interrupts: &Interrupts,
    tell: &mut dyn FnMut(&str),
) -> Result<Calibration, CalibrationError> {
    let Request { case, overrides, space, .. } = request;
    refuse_ends(request)?;
    let needs_closed = request.model != ModelChoice::Solver;
    let forms = ClosedResponse::forms(case, overrides, space, (&request.records, request.closed_form));
    let mut selection = request.selection.clone();
    selection.is_pressed = match &forms {
        Ok(forms) => forms.iter().all(|(form, _)| form.is_pressed()),
        // Without a closed form curves of a body that goes down follow its sinkage.
        Err(_) => is_pressed(request)?,
    };
    let records = &settled(&request.records, selection.is_pressed).map_err(CalibrationError::Request)?;
    let Taken { curves, left_out } = selection.curves(records).map_err(CalibrationError::Request)?;
    let remarks = records.iter().flat_map(Record::named_remarks).collect();
    let mut calibration = Calibration { left_out, closed: None, solver: None, remarks };
    if needs_closed {
        let models = ClosedResponse::models(forms?, records, &curves)?;
        let (stage, left_out) = closed_form(request, (&selection, records), models, (interrupts, tell))?;
        (calibration.closed, calibration.left_out) = (Some(stage), left_out);
    }
    if request.model == ModelChoice::ClosedForm {
        return Ok(calibration);
    }
    let likelihood = likelihood(request, curves.clone());
    refuse_budget(request, &curves)?;
    let mut plan = request.plan.clone();
    if request.narrow {
        plan.ranges = calibration.closed.as_ref().map_or_else(Vec::new, |stage| narrowed(space, stage));
    }
    let solver = Solver {
        case,
        overrides,
        space,
        records,
        curves: &curves,
        folder: request.folder,
        threads: request.threads,
        device: request.device,
        interrupts,
    };
    let stage = calibrate_solver(&solver, &likelihood, (&plan, request.effort), tell);
    stopped(interrupts)?;
    calibration.solver = Some(stage?);
    Ok(calibration)
}

fn likelihood(request: &Request<'_>, curves: Vec<MeasuredCurve>) -> Likelihood {
    let (noise, model_error) = (request.noise, request.model_error);
    Likelihood { space: request.space.clone(), curves, noise, model_error }
}

/// The calibration of the closed form, at the points where it applies, and the other points.
fn closed_form(
    request: &Request<'_>,
    (selection, records): (&Selection, &[Record]),
    models: Vec<(ClosedForm, Vec<String>)>,
    (interrupts, tell): (&Interrupts, &mut dyn FnMut(&str)),
) -> Result<(Stage, Vec<LeftOut>), CalibrationError> {
    let Request { case, overrides, space, effort, .. } = request;
    let judge =
        |number: usize, abscissa: Quantity, at: &[f64]| models[number].0.refusals(Along::of(abscissa), at);
    let Taken { curves, left_out } =
        selection.curves_where(records, &judge).map_err(CalibrationError::Request)?;
    let closed = ClosedResponse::new(case, overrides, space, (models.clone(), curves.clone()));
    let name = closed.name();
    let response = Interruptible { response: &closed, interrupts };
    tell(&format!("calibrating {name}"));
    let surrogate = emulated(space, &response, (effort.seed, selection.is_pressed));
    let used: &dyn Response = surrogate.as_ref().map_or(&response as &dyn Response, |found| found);
    let stage = calibrate_response(&likelihood(request, curves), used, &name, *effort);
    stopped(interrupts)?;
    Ok((stage.map_err(CalibrationError::Request)?, left_out))
}

/// The measurements, with forces turned that follow another convention of signs: what is pressed down is
/// pressed up, and what is towed is dragged back.
fn settled(records: &[Record], is_pressed: bool) -> Result<Vec<Record>, String> {
    let loads: &[Quantity] =
        if is_pressed { &[Quantity::Vertical, Quantity::Pressure] } else { &[Quantity::Drag] };
    let mut settled = records.to_vec();
    for record in &mut settled {
        record.refuse_groups()?;
        let along = if is_pressed { Some(Quantity::Sinkage) } else { record.abscissae().next() };
        for load in loads {
            settle_force(record, *load, along.unwrap_or(Quantity::Time), Some(1.0))?;
        }
    }
    Ok(settled)
}

/// What a stage says after a stop is of no use.
fn stopped(interrupts: &Interrupts) -> Result<(), CalibrationError> {
    interrupts.stopped_by().map_or(Ok(()), |signal| Err(CalibrationError::Stopped(signal)))
}

/// Refuses keys that the case does not know, and ranges of which it refuses an end.
fn refuse_ends(request: &Request<'_>) -> Result<(), CaseError> {
    let space = &request.space;
    let load = |values: &[f64]| {
        let unknowns = space.overrides(values);
        let unknowns =
            unknowns.map_err(|why| CaseError::unreadable("--link", why, "change the link or the priors"))?;
        let all = [request.overrides, &unknowns].concat();
        case::load_for_forecast(request.case, &all).map(|_| ())
    };
    let middle = vec![0.0; space.dimension()];
    load(&space.values(&middle))?;
    for (n, unknown) in space.unknowns.iter().enumerate().filter(|(_, u)| !u.prior.is_normal()) {
        for end in unknown.prior.spread() {
            let mut place = middle.clone();
            place[n] = end;
            load(&space.values(&place))?;
        }
    }
    Ok(())
}

/// Whether the first body that can touch the soil goes down and is not towed.
fn is_pressed(request: &Request<'_>) -> Result<bool, CaseError> {
    let space = &request.space;
    let unknowns = space.overrides(&space.values(&vec![0.0; space.dimension()])).unwrap_or_default();
    let (case, _) = case::load_for_forecast(request.case, &[request.overrides, &unknowns].concat())?;
    let towed = coulter::history::reference::Reference::all(&case);
    Ok(towed.iter().find(|reference| reference.has_surface()).is_some_and(|reference| !reference.towed))
}

fn refuse_budget(request: &Request<'_>, curves: &[MeasuredCurve]) -> Result<(), CalibrationError> {
    let least = least_budget(request.space.dimension());
    if request.plan.budget < least {
        return Err(CalibrationError::Request(format!(
            "--budget {}: a surrogate of {} unknowns needs {least} runs or more",
            request.plan.budget,
            request.space.dimension()
        )));
    }
    let along_slip = curves.iter().find(|curve| curve.abscissa == Some(Quantity::Slip));
    along_slip.map_or(Ok(()), |curve| {
        Err(CalibrationError::Request(format!(
            "{}: a run has one slip; give every slip a file of its own that begins with a line such as # set body.wheel.spin.speed=3 rad/s",
            curve.name
        )))
    })
}

/// The coordinates that the closed form leaves open, widened, within the spread of the priors.
fn narrowed(space: &Space, stage: &Stage) -> Vec<[f64; 2]> {
    let samples: Vec<Vec<f64>> =
        stage.posterior.samples.iter().map(|values| space.coordinates(values)).collect();
    let range = |n: usize| {
        let count = samples.len().max(1) as f64;
        let mean = samples.iter().map(|s| s[n]).sum::<f64>() / count;
        let deviation = (samples.iter().map(|s| (s[n] - mean).powi(2)).sum::<f64>() / count).sqrt();
        let [low, high] = space.unknowns[n].prior.spread();
        let [from, to] = [mean - NARROWED * deviation, mean + NARROWED * deviation];
        [from.clamp(low, high - 0.1), to.clamp(low + 0.1, high)]
    };
    (0..space.dimension()).map(range).collect()
}
