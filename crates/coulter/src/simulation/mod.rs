//! The simulation of a case: its model, its state, the loop of a run, and who observes it.

mod exchange;

use crate::blocks::{self, Balance, TooManyBlocks};
use crate::stages;
use case::model::model;
use case::tow::TowDirection;
use case::{Case, case_text, cores, require_valid};
use cpu_time::ProcessTime;
use glam::DVec3;
use input::CaseError;
use results::OutputError;
use results::checkpoint::{Checkpoint, CheckpointView};
use results::domain::PlacedDomain;
use results::history::History;
use results::history::probes::{self, LastSample};
use results::history::reference::Reference;
use results::history::rim::RimHistory;
use results::history::steady::SteadyPart;
use results::trust::{Setting, Trust};
use solver::balance;
use solver::cpu::stopwatch::Stopwatch;
use solver::device::{DeviceError, Driver};
use solver::error::Breakdown;
use solver::grid::Grid;
use solver::halo::decomposition::Decomposition;
use solver::halo::{Communicator, Halo};
use solver::initial;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;
use solver::step::step;
use solver::workspace::Workspace;
use std::path::Path;

pub use exchange::{Command, Coupled, Exchange, ExchangeError, Reaction, Steerer, Wish};

/// What an observer could not do: its file could not be written, its window was closed.
pub type ObserverError = Box<dyn std::error::Error + Send + Sync>;

/// How an observer wants a run to go on.
#[derive(Clone, Debug, PartialEq)]
pub enum Next {
    /// The run goes on as before.
    Continue,
    /// The run is to stop here, for this reason; it can be resumed.
    Stop(String),
    /// The run is broken: what would follow is of no use.
    BreakDown(Breakdown),
}

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// The run reached its end.
    Finished,
    /// An observer stopped the run between two steps, for this reason.
    Asked(String),
    /// The physics failed, or an observer found the run broken.
    BrokenDown(Breakdown),
}

/// Whoever follows a run: writes it to files, shows it, stops it. It sees the simulation as it is (case,
/// model, state, history) and cannot change it: a run takes the same course whoever observes it.
///
/// An observer of runs in either precision implements this for every `R`.
pub trait Observer<R: Precision = f64> {
    /// The history has a new sample: the last one of [`Simulation::history`].
    ///
    /// # Errors
    /// Whatever keeps the observer from its work; it ends the run at once.
    fn sampled(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        let _ = simulation;
        Ok(Next::Continue)
    }

    /// Whether [`Observer::between_steps`] will read fields of the soil: where a device holds them, they are
    /// brought back for that. They are up to date at every sample, and when a run has ended.
    fn reads_fields(&self, simulation: &Simulation<R>) -> bool {
        let _ = simulation;
        false
    }

    /// The run stands between two steps, or before the first. This is called often and must be quick.
    ///
    /// # Errors
    /// Whatever keeps the observer from its work; it ends the run at once.
    fn between_steps(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        let _ = simulation;
        Ok(Next::Continue)
    }

    /// The simulation has gone back to an earlier state: what was said of later times does not count.
    ///
    /// # Errors
    /// Whatever keeps the observer from its work; it ends the run at once.
    fn restored(&mut self, simulation: &Simulation<R>) -> Result<(), ObserverError> {
        let _ = simulation;
        Ok(())
    }

    /// The run has ended, in this way.
    ///
    /// # Errors
    /// Whatever keeps the observer from its work; the observers after it are not told then.
    fn ended(&mut self, simulation: &Simulation<R>, stop: &Stop) -> Result<(), ObserverError> {
        let _ = (simulation, stop);
        Ok(())
    }
}

/// A run of a case, its fields in double or in single precision.
#[derive(Debug)]
pub struct Simulation<R: Precision = f64> {
    /// The case.
    pub case: Case,
    /// The model: what does not change in a run.
    pub model: Model,
    /// The state: what changes in a run.
    pub state: State<R>,
    /// The history of the samples of the probes.
    pub history: History,
    /// Seconds of wall clock spent in steps.
    pub wall_s: f64,
    setting: Setting,
    tows: Vec<TowDirection>,
    workspace: Workspace<R>,
    last_sample: LastSample,
    balance: Balance,
}

impl<R: Precision> Simulation<R> {
    /// A run from the start, of a case from anywhere.
    ///
    /// # Errors
    /// [`CaseError`] holds everything that is wrong with the case.
    pub fn checked(case: &Case) -> Result<Self, CaseError> {
        require_valid(case)?;
        Ok(Self::new(case))
    }

    /// A run from the start, of a valid case: one that was read, or in which [`case::validate`] finds no
    /// problem. For any other there is [`Simulation::checked`].
    ///
    /// # Panics
    /// May panic if the case is not valid.
    #[must_use]
    pub fn new(case: &Case) -> Self {
        Self::of_model(case, model(case, R::LANES))
    }

    /// A run from the start of a model that no case file can state (see [`case::model::model`]): that of a
    /// case with a change by hand. The case says what samples and results need beyond the model.
    #[must_use]
    pub fn of_model(case: &Case, model: Model) -> Self {
        let mut state = initial::at_rest_on(&model, &model.ground);
        if case.velocity != DVec3::ZERO {
            initial::set_in_motion(&model, &mut state, case.velocity, &Halo::whole());
        }
        Self::with_state(case, model, state)
    }

    /// A run from the start with soil of another shape than the case's ground: its volume fraction in every
    /// cell.
    #[must_use]
    pub fn filled(case: &Case, fraction: impl FnOnce(&Grid) -> Vec<R>) -> Self {
        let model = model(case, R::LANES);
        let state = initial::at_rest_filled(&model, fraction(&model.grid));
        Self::with_state(case, model, state)
    }

    /// The block of a grid that a process has in a run from the start of a valid case, in which each process
    /// has one. Every block has the whole history, bodies and energy balance; soil and nodes are its own.
    ///
    /// # Errors
    /// When the grid has too few layers of cells for so many blocks.
    ///
    /// # Panics
    /// May panic if the case is not valid.
    pub fn of_block(case: &Case, communicator: Box<dyn Communicator>) -> Result<Self, TooManyBlocks> {
        let mut model = model(case, R::LANES);
        let cut = blocks::decompose(&model, communicator.size())?;
        let mut state = initial::at_rest_in_block(&mut model, cut.own(communicator.rank()));
        let halo = Halo::of_block(&cut, communicator);
        if case.velocity != DVec3::ZERO {
            initial::set_in_motion(&model, &mut state, case.velocity, &halo);
        }
        Ok(Self::with_halo(case, model, state, halo))
    }

    /// The block of a grid that a process has in a run resumed from a checkpoint that was read for this block
    /// (see [`blocks::of_case`]).
    ///
    /// # Errors
    /// As [`Simulation::of_block`].
    pub fn resume_block(
        case: &Case,
        checkpoint: Checkpoint<R>,
        communicator: Box<dyn Communicator>,
        wall_s: f64,
    ) -> Result<Self, TooManyBlocks> {
        let mut model = model(case, R::LANES);
        let cut = blocks::decompose(&model, communicator.size())?;
        model.grid = model.grid.block(cut.own(communicator.rank()));
        let Checkpoint { state, history, last_sample, .. } = checkpoint;
        let halo = Halo::of_block(&cut, communicator);
        Ok(Self::with_halo(case, model, state, halo).with_history(history, last_sample, wall_s))
    }

    fn with_state(case: &Case, model: Model, state: State<R>) -> Self {
        Self::with_halo(case, model, state, Halo::whole())
    }

    fn with_halo(case: &Case, model: Model, mut state: State<R>, halo: Halo) -> Self {
        let workspace = Workspace::of_block(&model, &mut state, cores::threads(case.numerics.threads), halo);
        let names: Vec<String> = case.bodies.iter().map(|b| b.name.clone()).collect();
        let rims = workspace.rims().map(|bins| RimHistory::of(bins, model.modelled_fraction())).collect();
        let part_names: Vec<String> = probes::places(case).into_iter().map(|(name, _)| name).collect();
        let joint_names: Vec<String> = case.joints.iter().map(|joint| joint.name.clone()).collect();
        let history = History {
            bodies: vec![Vec::new(); names.len()],
            names,
            rims,
            joints: vec![Vec::new(); joint_names.len()],
            joint_names,
            parts: vec![Vec::new(); part_names.len()],
            part_names,
            ..History::default()
        };
        let last_sample = LastSample::of(&state);
        let balance = Balance::from(state.step);
        let mut simulation = Self {
            case: case.clone(),
            model,
            state,
            history,
            wall_s: 0.0,
            setting: Setting::of(case),
            tows: TowDirection::all(case),
            workspace,
            last_sample,
            balance,
        };
        if simulation.state.step == 0 {
            let Self { case, model, state, workspace, history, .. } = &mut simulation;
            if stages::begin_first(case, model, history) {
                workspace.take_over(model, state);
            }
            simulation.record_ground_left();
            simulation.sample();
        }
        simulation
    }

    /// Sets soil and bodies in motion before the first step; the energy balance counts their energy as
    /// external work.
    pub fn set_in_motion(&mut self, push: impl FnOnce(&Model, &mut State<R>)) {
        self.workspace.bring_home(&mut self.state, true);
        push(&self.model, &mut self.state);
        self.state.energy_balance.kinetic_start =
            balance::kinetic_energy(&self.model, &self.state, self.workspace.halo());
    }

    /// A run resumed from a checkpoint; `wall_s` seconds of wall clock have been spent on it.
    #[must_use]
    pub fn resume(case: &Case, checkpoint: Checkpoint<R>, wall_s: f64) -> Self {
        Self::resume_model(case, model(case, R::LANES), checkpoint, wall_s)
    }

    /// A run with the same model as before, resumed from a checkpoint of one that began with
    /// [`Simulation::of_model`]; `wall_s` seconds of wall clock have been spent on it.
    #[must_use]
    pub fn resume_model(case: &Case, model: Model, checkpoint: Checkpoint<R>, wall_s: f64) -> Self {
        let Checkpoint { state, history, last_sample, .. } = checkpoint;
        Self::with_state(case, model, state).with_history(history, last_sample, wall_s)
    }

    /// The run with this history, in the stage that was on.
    fn with_history(mut self, history: History, last_sample: LastSample, wall_s: f64) -> Self {
        stages::restore(&history, &mut self.model);
        self.workspace.set_motions(&self.model);
        Self { history, last_sample, wall_s, ..self }
    }

    /// The run with its fields in double precision, for inspection.
    #[must_use]
    pub fn to_f64(&self) -> Simulation {
        let Self { case, history, last_sample, wall_s, .. } = self;
        let simulation = Simulation::with_state(case, model(case, R::LANES), self.state.to_f64());
        simulation.with_history(history.clone(), last_sample.clone(), *wall_s)
    }

    /// Everything that is needed to resume from here.
    #[must_use]
    pub fn checkpoint(&self) -> CheckpointView<'_, R> {
        CheckpointView {
            precision: R::NAME,
            case: case_text(&self.case),
            state: &self.state,
            block: (&self.model.grid, self.halo()),
            history: &self.history,
            last_sample: &self.last_sample,
        }
    }

    /// Goes back, or on, to a checkpoint of this case in one process, as bytes (see
    /// [`CheckpointView::to_bytes`]).
    ///
    /// # Errors
    /// Where it is none, or that of another case; the simulation stands as before.
    pub fn restore(&mut self, checkpoint: &[u8]) -> Result<(), OutputError> {
        let read = Checkpoint::of_bytes(checkpoint, &self.model.grid)?;
        if read.case != case_text(&self.case) || !read.is_of(&self.case, &self.model) {
            return Err(OutputError::content(Path::new("the checkpoint"), "it is that of another case"));
        }
        let Self { model, state, workspace, history, last_sample, balance, .. } = self;
        (*state, *history, *last_sample) = (read.state, read.history, read.last_sample);
        workspace.restart(model, state);
        *balance = Balance::from(state.step);
        stages::restore(history, model);
        workspace.set_motions(model);
        Ok(())
    }

    /// What the checks of the run must know of its case.
    #[must_use]
    pub fn setting(&self) -> &Setting {
        &self.setting
    }

    /// The grade of the run so far; `failure` says why it was stopped, if it was.
    #[must_use]
    pub fn trust(&self, failure: Option<&str>) -> Trust {
        let references = Reference::all(&self.case);
        Trust::grade(&self.setting, &self.history, &references, self.steady_part(), failure)
    }

    /// Which part of the run averages are taken over.
    #[must_use]
    pub fn steady_part(&self) -> SteadyPart {
        let during = stages::steady_times(&self.case, &self.history);
        SteadyPart { fraction: self.case.output.steady_fraction, during }
    }

    /// Whether the run has reached its end.
    #[must_use]
    pub fn is_done(&self) -> bool {
        if self.case.stages.is_empty() {
            self.state.time >= self.case.duration - 0.5 * self.model.time_step()
        } else {
            self.history.stages_ended.is_some()
        }
    }

    /// Communication with the other blocks of the grid.
    #[must_use]
    pub fn halo(&self) -> &Halo {
        self.workspace.halo()
    }

    /// Number of threads at work.
    #[must_use]
    pub fn threads(&self) -> usize {
        self.workspace.threads()
    }

    /// Runs the case to its end, or until an observer stops it.
    ///
    /// Observers are notified of a sample, and asked between two steps, in their order; the first that does
    /// not want to go on ends the run, and those after it are not asked any more. All are notified of the
    /// end. A run that was stopped goes on where it stood when this is called again.
    ///
    /// # Errors
    /// That of the first observer that fails: the run ends between two steps, and no observer is told.
    ///
    /// # Examples
    /// A column of soil collapses, until it has come to rest:
    ///
    /// ```
    /// use coulter::simulation::{Next, Observer, ObserverError, Simulation, Stop};
    ///
    /// /// Stops a run when little of the work is still on the move.
    /// struct UntilRest;
    ///
    /// impl Observer for UntilRest {
    ///     fn sampled(&mut self, simulation: &Simulation) -> Result<Next, ObserverError> {
    ///         let energy = simulation.history.energy.last().ok_or("no sample yet")?;
    ///         let is_at_rest = energy.time > 0.1 && energy.kinetic < 0.05 * energy.external;
    ///         Ok(if is_at_rest { Next::Stop("the soil is at rest".to_owned()) } else { Next::Continue })
    ///     }
    /// }
    ///
    /// # let text = include_str!("../../../../cases/column_collapse.toml");
    /// # let coarse = ["grid.cell=50 mm", "run.duration=1 s"].map(str::to_owned);
    /// let case = coulter::case::parse(text, "case.toml", &coarse)?;
    /// let mut simulation = Simulation::new(&case);
    /// let stop = simulation.run(&mut [&mut UntilRest])?;
    /// assert_eq!(stop, Stop::Asked("the soil is at rest".to_owned()));
    /// # Ok::<(), Box<dyn std::error::Error + Send + Sync>>(())
    /// ```
    pub fn run(&mut self, observers: &mut [&mut dyn Observer<R>]) -> Result<Stop, ObserverError> {
        let stop = loop {
            if let Some(stop) = self.between_steps(observers)? {
                break stop;
            }
            if self.is_done() {
                break Stop::Finished;
            }
            match self.step_and_sample() {
                Err(cause) => break Stop::BrokenDown(cause),
                Ok(false) => {}
                Ok(true) => {
                    if let Some(stop) = asked(observers, |observer| observer.sampled(self))? {
                        break stop;
                    }
                }
            }
        };
        self.end(stop, observers)
    }

    /// Asks the observers between two steps; how the run ended, if it did.
    fn between_steps(
        &mut self,
        observers: &mut [&mut dyn Observer<R>],
    ) -> Result<Option<Stop>, ObserverError> {
        if observers.iter().any(|observer| observer.reads_fields(self))
            && let Err(cause) = self.bring_home()
        {
            return Ok(Some(Stop::BrokenDown(cause)));
        }
        asked(observers, |observer| observer.between_steps(self))
    }

    /// Tells the observers that the run has ended in this way, or because its state cannot be completed.
    fn end(&mut self, stop: Stop, observers: &mut [&mut dyn Observer<R>]) -> Result<Stop, ObserverError> {
        let stop = self.bring_home().map_or_else(Stop::BrokenDown, |()| stop);
        observers.iter_mut().try_for_each(|observer| observer.ended(self, &stop))?;
        Ok(stop)
    }

    /// Goes on to the next sample of the history, or to the end.
    ///
    /// # Errors
    /// [`Breakdown`] when the physics fails.
    pub fn advance(&mut self) -> Result<(), Breakdown> {
        while !self.is_done() && !self.step_and_sample()? {}
        Ok(())
    }

    /// Takes a step.
    fn step(&mut self) -> Result<(), Breakdown> {
        let talked = self.halo().traffic().seconds;
        let clock = std::time::Instant::now();
        let stepped = step(&self.model, &mut self.state, &mut self.workspace);
        let seconds = clock.elapsed().as_secs_f64();
        self.wall_s += seconds;
        self.balance.count(seconds - (self.halo().traffic().seconds - talked));
        stepped?;
        self.record_ground_left();
        self.rebalance();
        Ok(())
    }

    /// Cuts the grid anew where that makes steps shorter, as soil and yielding move over it.
    fn rebalance(&mut self) {
        let Self { model, state, workspace, balance, .. } = self;
        let costs = || workspace.costs(&model.grid);
        let Some(cut) = balance.decide(&model.grid, costs, (state.step, workspace.halo())) else { return };
        self.recut(&cut);
    }

    /// Passes soil from block to block until the grid is cut in this way; changes no bit of the run. All
    /// blocks must do so at the same step, which is not the first.
    ///
    /// # Panics
    /// If there are not as many blocks as before.
    pub fn recut(&mut self, cut: &Decomposition) {
        let Self { model, state, workspace, .. } = self;
        workspace.recut(model, state, cut);
    }

    /// Takes a step, and a sample where one is due; returns whether one was.
    fn step_and_sample(&mut self) -> Result<bool, Breakdown> {
        self.step()?;
        let due = self.last_sample.time + self.case.output.history_interval - 0.5 * self.model.time_step();
        let Self { case, history, state, .. } = &*self;
        let stage_is_over = stages::time_is_over(case, history, state.time, self.model.time_step());
        let is_due = state.time >= due || self.is_done() || stage_is_over;
        if is_due {
            self.bring_home()?;
            self.sample();
            let Self { case, model, state, workspace, history, .. } = self;
            if stages::proceed(case, model, state, history)? {
                workspace.take_over(model, state);
            }
        }
        Ok(is_due)
    }

    /// Enters the present state into the history.
    fn sample(&mut self) {
        let Self { case, model, state, workspace, last_sample, history, tows, .. } = self;
        probes::sample((case, model, tows), state, workspace.halo(), last_sample, history);
    }

    /// Keeps the surface of the soil that is about to leave a grid that travels; after every step, so that
    /// its lines lie as close as the cells however far samples are apart.
    fn record_ground_left(&mut self) {
        let Self { model, state, workspace, history, .. } = self;
        probes::record_ground_left(model, state, workspace.halo(), &mut history.ground_left);
    }

    /// Takes a number of steps, without samples.
    ///
    /// # Errors
    /// [`Breakdown`] when the physics fails.
    pub fn steps(&mut self, number: u32) -> Result<(), Breakdown> {
        let stepped = (0..number).try_for_each(|_| self.step());
        stepped.and(self.bring_home())
    }

    /// Has a device strain the soil from here on; changes no bit of the run.
    ///
    /// # Errors
    /// [`DeviceError`] if the device has not enough memory, or if the case needs what devices cannot do.
    pub fn use_device(&mut self, driver: Box<dyn Driver>) -> Result<(), DeviceError> {
        let Self { model, state, workspace, .. } = self;
        workspace.use_device(model, state, driver)
    }

    /// Bytes that have crossed to the device and back; `None` without one.
    #[must_use]
    pub fn crossed_to_device(&self) -> Option<u64> {
        self.workspace.crossed_to_device()
    }

    /// Whether the fields of the state are up to date, and not on a device.
    #[must_use]
    pub fn fields_are_home(&self) -> bool {
        self.workspace.is_home()
    }

    /// Completes the state with what a device holds.
    ///
    /// # Errors
    /// [`Breakdown::Device`] where that is lost.
    fn bring_home(&mut self) -> Result<(), Breakdown> {
        let Self { state, workspace, .. } = self;
        workspace.bring_home(state, false);
        workspace.device_works(state)
    }

    /// Where the time of the calling thread goes.
    pub fn stopwatch(&mut self) -> &mut Stopwatch {
        self.workspace.stopwatch()
    }

    /// Memory that state and workspace take up [bytes].
    #[must_use]
    pub fn memory(&self) -> usize {
        self.workspace.memory() + self.state.memory()
    }

    /// Cell-steps per second of processor time and thread over the cells with soil, measured over some steps
    /// for this time of wall clock: other programs take the clock's time, and not the processor's. `None` if
    /// not one step can be taken. The state is of no use afterwards.
    pub fn speed(&mut self, while_: std::time::Duration) -> Option<f64> {
        let domain = PlacedDomain::of(&self.model.grid, self.state.grid_position);
        let filled = domain.filled_cells(&self.state);
        let clock = std::time::Instant::now();
        let (processor, mut steps) = (ProcessTime::now(), 0_u32);
        while clock.elapsed() < while_ {
            match step(&self.model, &mut self.state, &mut self.workspace) {
                // Of a region of a case the body may reach out of the box from the start.
                Ok(_) | Err(Breakdown::LeftTheBox { .. }) => steps += 1,
                Err(_) => return None,
            }
        }
        let used = processor.elapsed().as_secs_f64();
        (used > 0.0).then(|| filled as f64 * f64::from(steps) / used)
    }
}

/// Asks the observers in their order, until one does not want to go on.
fn asked<R: Precision>(
    observers: &mut [&mut dyn Observer<R>],
    ask: impl Fn(&mut dyn Observer<R>) -> Result<Next, ObserverError>,
) -> Result<Option<Stop>, ObserverError> {
    for observer in observers {
        match ask(*observer)? {
            Next::Continue => {}
            Next::Stop(why) => return Ok(Some(Stop::Asked(why))),
            Next::BreakDown(cause) => return Ok(Some(Stop::BrokenDown(cause))),
        }
    }
    Ok(None)
}
