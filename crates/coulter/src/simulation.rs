//! The simulation of a case: its model, its state, and the history of samples.

use crate::case::model::model;
use crate::case::{Case, CaseError, case_text, require_valid};
use crate::history::reference::Reference;
use crate::history::{BodySample, EnergySample, History};
use crate::output::checkpoint::{Checkpoint, CheckpointView};
use crate::trust::{Setting, Trust, boundary};
use glam::DVec3;
use solver::balance;
use solver::cpu::stopwatch::Stopwatch;
use solver::energy::soil_volume;
use solver::error::Breakdown;
use solver::grid::Grid;
use solver::initial;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::{ContactImpulse, State};
use solver::step::step;
use solver::workspace::Workspace;

/// A run of a case, its fields in double or in single precision.
#[derive(Debug)]
pub struct Simulation<R: Precision = f64> {
    /// The case.
    pub case: Case,
    /// What is fixed.
    pub model: Model,
    /// What changes.
    pub state: State<R>,
    /// What the probes saw.
    pub history: History,
    /// Seconds of wall clock spent in steps.
    pub wall_s: f64,
    setting: Setting,
    workspace: Workspace<R>,
    /// Time and impulses at the last sample.
    sampled: (f64, Vec<ContactImpulse>),
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

    /// A run from the start, of a valid case: one that was read, or in which [`crate::case::validate`] finds no problem. For any
    /// other there is [`Simulation::checked`].
    ///
    /// # Panics
    /// May panic if the case is not valid.
    #[must_use]
    pub fn new(case: &Case) -> Self {
        let model = model(case, R::LANES);
        let mut state = initial::at_rest_on(&model, &model.ground);
        if case.velocity != DVec3::ZERO {
            initial::set_in_motion(&model, &mut state, case.velocity);
        }
        Self::with_state(case, model, state)
    }

    /// A run from the start with soil of another shape than the case's ground: its volume fraction in every cell.
    #[must_use]
    pub fn filled(case: &Case, fraction: impl FnOnce(&Grid) -> Vec<R>) -> Self {
        let model = model(case, R::LANES);
        let state = initial::at_rest_filled(&model, fraction(&model.grid));
        Self::with_state(case, model, state)
    }

    fn with_state(case: &Case, model: Model, mut state: State<R>) -> Self {
        let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        let threads = if case.numerics.threads == 0 { cores } else { case.numerics.threads };
        let workspace = Workspace::new(&model, &mut state, threads);
        let names: Vec<String> = case.bodies.iter().map(|b| b.name.clone()).collect();
        let history = History { bodies: vec![Vec::new(); names.len()], names, ..History::default() };
        let sampled = (state.time, state.bodies.iter().map(|b| b.contact_impulse).collect());
        let mut simulation = Self {
            case: case.clone(),
            model,
            state,
            history,
            wall_s: 0.0,
            setting: Setting::of(case),
            workspace,
            sampled,
        };
        if simulation.state.step == 0 {
            simulation.sample();
        }
        simulation
    }

    /// Sets soil and bodies in motion before the first step; the energy balance counts their energy as external work.
    pub fn set_in_motion(&mut self, push: impl FnOnce(&Model, &mut State<R>)) {
        push(&self.model, &mut self.state);
        self.state.energy_balance.kinetic_start = balance::kinetic_energy(&self.model, &self.state);
    }

    /// A run resumed from a checkpoint; `wall_s` seconds of wall clock have been spent on it.
    #[must_use]
    pub fn resume(case: &Case, checkpoint: Checkpoint<R>, wall_s: f64) -> Self {
        let Checkpoint { state, history, sampled, .. } = checkpoint;
        let simulation = Self::with_state(case, model(case, R::LANES), state);
        Self { history, sampled, wall_s, ..simulation }
    }

    /// The same run with its fields in double precision, for inspection.
    #[must_use]
    pub fn to_f64(&self) -> Simulation {
        let Self { case, history, sampled, wall_s, .. } = self;
        let simulation = Simulation::with_state(case, model(case, R::LANES), self.state.to_f64());
        Simulation { history: history.clone(), sampled: sampled.clone(), wall_s: *wall_s, ..simulation }
    }

    /// Everything that is needed to resume from here.
    #[must_use]
    pub fn checkpoint(&self) -> CheckpointView<'_, R> {
        CheckpointView {
            precision: R::NAME,
            case: case_text(&self.case),
            state: &self.state,
            history: &self.history,
            sampled: &self.sampled,
        }
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
        Trust::grade(&self.setting, &self.history, &references, self.case.output.steady_fraction, failure)
    }

    /// Whether the run has reached its end.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.state.time >= self.case.duration - 0.5 * self.model.time_step()
    }

    /// Number of threads at work.
    #[must_use]
    pub fn threads(&self) -> usize {
        self.workspace.threads()
    }

    /// Goes on to the next sample of the history (or to the end).
    ///
    /// # Errors
    /// [`Breakdown`] when the physics fails.
    pub fn advance(&mut self) -> Result<(), Breakdown> {
        self.advance_unless(|| false).map(|_| ())
    }

    /// The same, but stops between two steps when `interrupted` says so; returns whether the sample was reached. A
    /// checkpoint may be taken either way.
    ///
    /// # Errors
    /// [`Breakdown`] when the physics fails.
    pub fn advance_unless(&mut self, interrupted: impl Fn() -> bool) -> Result<bool, Breakdown> {
        let clock = std::time::Instant::now();
        let due = self.sampled.0 + self.case.output.history_interval - 0.5 * self.model.time_step();
        let mut is_due = self.is_done();
        let mut result = Ok(());
        while result.is_ok() && !is_due && !interrupted() {
            result = step(&self.model, &mut self.state, &mut self.workspace);
            is_due = self.state.time >= due || self.is_done();
        }
        self.wall_s += clock.elapsed().as_secs_f64();
        result?;
        if is_due {
            self.sample();
        }
        Ok(is_due)
    }

    /// Takes a number of steps, without samples.
    ///
    /// # Errors
    /// [`Breakdown`] when the physics fails.
    pub fn steps(&mut self, number: u32) -> Result<(), Breakdown> {
        (0..number).try_for_each(|_| step(&self.model, &mut self.state, &mut self.workspace))
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

    /// Cell-steps per second over the cells with soil, measured over some steps; `None` if not one step can be
    /// taken. The state is of no use afterwards.
    pub fn speed(&mut self, while_: std::time::Duration) -> Option<f64> {
        let filled = self.state.soil.fraction.iter().filter(|f| **f != R::default()).count();
        let clock = std::time::Instant::now();
        let mut steps = 0_u32;
        while clock.elapsed() < while_ {
            step(&self.model, &mut self.state, &mut self.workspace).ok()?;
            steps += 1;
        }
        Some(filled as f64 * f64::from(steps) / clock.elapsed().as_secs_f64())
    }

    /// Enters the present state into the history.
    fn sample(&mut self) {
        let interval = self.state.time - self.sampled.0;
        for n in 0..self.state.bodies.len() {
            let sample = self.body_sample(n, interval);
            self.history.bodies[n].push(sample);
        }
        let energy = self.energy_sample();
        self.history.energy.push(energy);
        self.history.boundaries.push(boundary::sample(&self.case, &self.model, &self.state));
        self.sampled = (self.state.time, self.state.bodies.iter().map(|b| b.contact_impulse).collect());
    }

    fn body_sample(&self, n: usize, interval: f64) -> BodySample {
        let (fixed, body) = (&self.model.bodies[n], &self.state.bodies[n]);
        let (pose, twist) = (self.state.pose(n), self.state.twist(n));
        let axle = pose.rotation * DVec3::Y;
        let (now, then) = (body.contact_impulse, self.sampled.1[n]);
        let rate = if interval > 0.0 { 1.0 / interval } else { 0.0 };
        let normal = (now.normal - then.normal) * rate;
        let friction = (now.friction - then.friction) * rate;
        let symmetry = self.model.symmetry();
        let normal = symmetry.of_whole(normal);
        let force = symmetry.of_whole(normal + friction);
        BodySample {
            time: self.state.time,
            displacement: pose.position.x - fixed.start.position.x,
            sinkage: self.model.surface - (pose.position.z + fixed.shape.bounds().0.z),
            drag: 0.0 - force.x,
            lateral: force.y,
            vertical: force.z,
            drag_normal: 0.0 - normal.x,
            vertical_normal: normal.z,
            axle_torque: symmetry.moment_of_whole((now.moment - then.moment) * rate).dot(axle),
            rotation: body.rotation,
            spin: twist.angular.dot(axle),
            speed: twist.linear.x,
            heave_speed: twist.linear.z,
            leaked_volume: body.leaked_volume / self.model.modelled_fraction(),
            embedded_volume: body.embedded_volume / self.model.modelled_fraction(),
        }
    }

    fn energy_sample(&self) -> EnergySample {
        let terms = &self.state.energy_balance;
        let whole = 1.0 / self.model.modelled_fraction();
        EnergySample {
            time: self.state.time,
            external: (terms.external + terms.kinetic_start + terms.inflow_elastic) * whole,
            kinetic: balance::kinetic_energy(&self.model, &self.state) * whole,
            elastic: (balance::elastic_energy(&self.model, &self.state) - terms.elastic_start) * whole,
            plastic: terms.plastic * whole,
            friction: terms.friction * whole,
            contact: terms.contact * whole,
            viscous: terms.viscous * whole,
            hourglass: terms.hourglass * whole,
            remap_loss: terms.remap * whole,
            volume_ratio: (soil_volume(&self.model.grid, &self.state.soil) - terms.inflow_volume)
                / terms.volume_start,
        }
    }
}
