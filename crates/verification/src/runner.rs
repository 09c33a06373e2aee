//! Runs the cases of the benchmarks, through the same public API as a user's, and collects their rows and
//! balances.

use crate::cache::{CachedPart, ResultCache};
use crate::error::VerifyError;
use crate::expectation::{Expectation, Suite, Target};
use crate::expectations::Expectations;
use crate::options::SuiteOptions;
use crate::row::{Expected, Row};
use crate::run_balances::RunBalances;
use crate::trace::Trace;
use coulter::case::resolved::Precision;
use coulter::case::{self, Case};
use coulter::history::largest;
use coulter::run::watch::watch as would_stop;
use coulter::simulation::Simulation;
use solver::energy::soil_mass;
use solver::halo::Halo;
use std::time::{Duration, Instant};

/// Runs cases and collects the results.
pub struct Runner<'a> {
    /// The options that were asked for.
    pub options: &'a SuiteOptions,
    /// The rows so far.
    pub rows: Vec<Row>,
    /// The balances of the runs so far.
    pub balances: Vec<RunBalances>,
    /// What is expected of the figures.
    pub(crate) expectations: &'static [Expectations],
    suite: Suite,
    /// Why a user's run would have been stopped, if the current one would.
    stopped: Option<String>,
    cache: Option<ResultCache>,
    progress: &'a mut dyn FnMut(&str),
}

impl std::fmt::Debug for Runner<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Runner with {} rows", self.rows.len())
    }
}

impl<'a> Runner<'a> {
    /// A runner without results; `progress` is called with a line of text whenever there is something to
    /// report.
    pub(crate) fn new(
        expectations: &'static [Expectations],
        options: &'a SuiteOptions,
        progress: &'a mut dyn FnMut(&str),
    ) -> Self {
        let suite = if options.fast { Suite::Fast } else { Suite::Full };
        let cache = options.folder.as_ref().and_then(|folder| ResultCache::new(folder, options));
        Self {
            options,
            rows: Vec::new(),
            balances: Vec::new(),
            expectations,
            suite,
            stopped: None,
            cache,
            progress,
        }
    }

    /// The runner for the study of convergence.
    pub(crate) fn refining(self) -> Self {
        Self { suite: Suite::Refine, ..self }
    }

    fn expectations(&self, id: &str) -> Result<&'static Expectations, VerifyError> {
        let known = self.expectations.iter().find(|known| known.id == id);
        known.ok_or_else(|| VerifyError::Expectation(format!("nothing is expected of {id}")))
    }

    /// What is expected of a figure.
    ///
    /// # Errors
    /// [`VerifyError::Expectation`] if its `expected.toml` does not say.
    pub(crate) fn expectation(
        &self,
        id: &str,
        case: &str,
        quantity: &str,
    ) -> Result<&'static Expectation, VerifyError> {
        self.expectations(id)?.find(case, quantity, self.suite)
    }

    /// Whether a variant is part of this verification.
    ///
    /// # Errors
    /// [`VerifyError::Expectation`] if nothing at all is expected of the benchmark.
    pub(crate) fn wants(&self, id: &str, case: &str) -> Result<bool, VerifyError> {
        Ok(self.expectations(id)?.contains(case, self.suite))
    }

    /// Enters figures of a variant, (quantity, value), beside what is expected of them; `seconds` is the
    /// wall-clock time of the runs behind them [s].
    ///
    /// # Errors
    /// [`VerifyError::Expectation`] if the `expected.toml` of the benchmark does not know one of them.
    pub(crate) fn put(
        &mut self,
        id: &'static str,
        case: &str,
        seconds: f64,
        figures: &[(&str, f64)],
    ) -> Result<(), VerifyError> {
        for &(quantity, obtained) in figures {
            let known = self.expectation(id, case, quantity)?;
            let expected = match &known.target {
                Target::Number(expected) => *expected,
                Target::SameAs(other) => Expected::Value(self.obtained(id, other, quantity)),
            };
            let info = Row::info(id, case, quantity, obtained).took(seconds);
            self.rows.push(info.expecting(expected, known.tolerance, &known.source));
        }
        Ok(())
    }

    /// Does one part of a benchmark, unless the cache holds its results from this same program with the same
    /// options; then the cached rows and balances are taken.
    ///
    /// # Errors
    /// What `work` returns; a part that fails is not cached.
    pub(crate) fn part(
        &mut self,
        id: &'static str,
        part: &str,
        work: impl FnOnce(&mut Self) -> Result<(), VerifyError>,
    ) -> Result<(), VerifyError> {
        let cached =
            self.cache.as_ref().filter(|_| !self.options.fresh).and_then(|cache| cache.read(id, part));
        if let Some(found) = cached {
            self.report_progress(&format!("{id}: {part}: from the cache (--fresh runs it again)"));
            self.rows.extend(found.rows);
            self.balances.extend(found.balances);
            return Ok(());
        }
        let (rows, balances) = (self.rows.len(), self.balances.len());
        work(self)?;
        let found =
            CachedPart { rows: self.rows[rows..].to_vec(), balances: self.balances[balances..].to_vec() };
        if let Some(Err(error)) = self.cache.as_ref().map(|cache| cache.write(id, part, &found)) {
            self.report_progress(&format!("{id}: {part}: cannot be cached: {error}"));
        }
        Ok(())
    }

    /// Passes a line on progress to whoever started the suite.
    pub fn report_progress(&mut self, text: &str) {
        (self.progress)(text);
    }

    /// The case of a file's text with overrides; those of the request come last.
    fn case(&self, text: &str, overrides: &[String]) -> Result<Case, VerifyError> {
        let all: Vec<String> = overrides.iter().chain(&self.options.overrides).cloned().collect();
        let mut case = case::parse(text, "case.toml", &all)?;
        if case.numerics.threads == 0 {
            case.numerics.threads = self.options.threads;
        }
        case.duration = self.lasting(case.duration);
        Ok(case)
    }

    /// How long something lasts, in seconds or steps: not at all where the rows are only listed.
    pub(crate) fn lasting<T: Default>(&self, length: T) -> T {
        if self.options.only_list { T::default() } else { length }
    }

    /// A simulation of a case file's text with overrides, which the benchmark itself advances in time; in
    /// double precision only.
    ///
    /// # Errors
    /// [`VerifyError`] when the case is refused or asks for single precision.
    pub fn simulation(&self, text: &str, overrides: &[String]) -> Result<Simulation, VerifyError> {
        let case = self.case(text, overrides)?;
        match case.numerics.precision {
            Precision::Double => Ok(Simulation::new(&case)),
            Precision::Single => Err(VerifyError::DoubleOnly),
        }
    }

    /// Runs a case to its end and records its balances.
    ///
    /// # Errors
    /// [`VerifyError`] when the case is refused or the physics fails.
    pub fn run(
        &mut self,
        id: &'static str,
        variant: &str,
        text: &str,
        overrides: &[String],
    ) -> Result<Simulation, VerifyError> {
        let case = self.case(text, overrides)?;
        let simulation = match case.numerics.precision {
            Precision::Double => {
                let mut simulation = Simulation::<f64>::new(&case);
                self.advance(id, variant, &mut simulation, |_| {})?;
                simulation
            }
            Precision::Single => {
                let mut simulation = Simulation::<f32>::new(&case);
                self.advance(id, variant, &mut simulation, |_| {})?;
                simulation.to_f64()
            }
        };
        self.record(id, variant, &simulation);
        Ok(simulation)
    }

    /// Runs a simulation to its end and records its balances.
    ///
    /// # Errors
    /// [`VerifyError::Physics`] when the physics fails.
    pub fn finish(
        &mut self,
        id: &'static str,
        variant: &str,
        simulation: &mut Simulation,
    ) -> Result<(), VerifyError> {
        self.finish_watched(id, variant, simulation, |_| {})
    }

    /// Runs a simulation to its end, like [`Runner::finish`], with a callback at every sample.
    ///
    /// # Errors
    /// [`VerifyError::Physics`] when the physics fails.
    pub fn finish_watched(
        &mut self,
        id: &'static str,
        variant: &str,
        simulation: &mut Simulation,
        watch: impl FnMut(&Simulation),
    ) -> Result<(), VerifyError> {
        self.advance(id, variant, simulation, watch)?;
        self.record(id, variant, simulation);
        Ok(())
    }

    /// Advances a simulation to its end and reports progress.
    fn advance<R: solver::precision::Precision>(
        &mut self,
        id: &'static str,
        variant: &str,
        simulation: &mut Simulation<R>,
        mut watch: impl FnMut(&Simulation<R>),
    ) -> Result<(), VerifyError> {
        const INTERVAL: Duration = Duration::from_secs(15);
        let clock = Instant::now();
        let mut reported = Instant::now();
        while !simulation.is_done() {
            simulation.advance()?;
            watch(simulation);
            if self.stopped.is_none() {
                self.stopped = would_stop(simulation).err().map(|why| why.to_string());
            }
            if reported.elapsed() > INTERVAL {
                reported = Instant::now();
                let per_cent = 1e2 * simulation.state.time / simulation.case.duration;
                self.report_progress(&format!("{id}: {variant}, {per_cent:.0} %"));
            }
        }
        let seconds = clock.elapsed().as_secs_f64();
        self.report_progress(&format!("{id}: {variant}, {} steps in {seconds:.1} s", simulation.state.step));
        Ok(())
    }

    /// A figure that is among the rows already; not a number if it is not.
    #[must_use]
    pub fn obtained(&self, id: &str, case: &str, quantity: &str) -> f64 {
        let row = self.rows.iter().find(|r| r.id == id && r.case == case && r.quantity == quantity);
        row.map_or(f64::NAN, |r| r.obtained)
    }

    /// Records the balances of a run that has reached its end.
    pub fn record(&mut self, id: &'static str, variant: &str, simulation: &Simulation) {
        let history = &simulation.history;
        let stopped = self.stopped.take();
        self.balances.push(RunBalances {
            id,
            case: variant.to_owned(),
            energy: history.energy.last().copied().unwrap_or_default(),
            volume_error: largest(history.energy.iter().map(|e| (e.volume_ratio - 1.0).abs())),
            overdense: largest(history.energy.iter().map(|e| e.overdense)),
            mass_error: mass_error(simulation),
            dilates: simulation.case.soil.law.changes_volume()[1],
            bodies: history.bodies.iter().filter_map(|b| b.last().copied()).collect(),
            seconds: simulation.wall_s,
            trace: Trace::of(simulation),
            trust: simulation.trust(stopped.as_deref()),
        });
    }
}

/// Relative change of the soil's mass since the start, VOF debris included, less what has entered.
fn mass_error(simulation: &Simulation) -> f64 {
    let Simulation { model, state, .. } = simulation;
    let before = model.material().density * state.energy_balance.volume_start;
    let balance = &state.energy_balance;
    let now = soil_mass(&model.grid, &state.soil, &Halo::whole()) + balance.debris_mass - balance.inflow_mass;
    (now - before) / before
}
