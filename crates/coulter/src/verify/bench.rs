//! The bench that benchmarks run on: it runs cases through the users' door, keeps their ledgers and collects rows.

use super::error::VerifyError;
use super::kept::{Found, Kept};
use super::options::Wish;
use super::row::Row;
use super::run_ledgers::Ledgers;
use super::trace::Trace;
use crate::case::resolved::{Law, Precision};
use crate::case::{self, Case};
use crate::run::watch::watch as would_stop;
use crate::simulation::Simulation;
use solver::cpu::energy::soil_mass;
use std::time::{Duration, Instant};

/// Runs cases and collects what comes out.
pub struct Bench<'a> {
    /// What was asked for.
    pub wish: &'a Wish,
    /// The rows so far.
    pub rows: Vec<Row>,
    /// The ledgers of the runs so far.
    pub ledgers: Vec<Ledgers>,
    /// Why a user's run would have been stopped, if the one under way would.
    stopped: Option<String>,
    kept: Option<Kept>,
    tell: &'a mut dyn FnMut(&str),
}

impl std::fmt::Debug for Bench<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Bench with {} rows", self.rows.len())
    }
}

impl<'a> Bench<'a> {
    /// An empty bench; `tell` hears what it is doing.
    pub fn new(wish: &'a Wish, tell: &'a mut dyn FnMut(&str)) -> Self {
        let kept = wish.folder.as_ref().and_then(|folder| Kept::new(folder, wish));
        Self { wish, rows: Vec::new(), ledgers: Vec::new(), stopped: None, kept, tell }
    }

    /// Does a part of a benchmark, unless an earlier verification by this very program, asked for the same, has done it:
    /// then its rows and ledgers are those that were kept.
    ///
    /// # Errors
    /// What `work` returns; a part that fails is not kept.
    pub fn part(
        &mut self,
        id: &'static str,
        part: &str,
        work: impl FnOnce(&mut Self) -> Result<(), VerifyError>,
    ) -> Result<(), VerifyError> {
        let known = self.kept.as_ref().filter(|_| !self.wish.fresh).and_then(|kept| kept.read(id, part));
        if let Some(found) = known {
            self.tell(&format!("{id}: {part}: as found before by this program (--fresh does it again)"));
            self.rows.extend(found.rows);
            self.ledgers.extend(found.ledgers);
            return Ok(());
        }
        let (rows, ledgers) = (self.rows.len(), self.ledgers.len());
        work(self)?;
        let found = Found { rows: self.rows[rows..].to_vec(), ledgers: self.ledgers[ledgers..].to_vec() };
        if let Some(Err(error)) = self.kept.as_ref().map(|kept| kept.write(id, part, &found)) {
            self.tell(&format!("{id}: {part}: cannot be kept for another time: {error}"));
        }
        Ok(())
    }

    /// Says what is going on.
    pub fn tell(&mut self, text: &str) {
        (self.tell)(text);
    }

    /// A case file's text with overrides; those of the request come last.
    fn case(&self, text: &str, overrides: &[String]) -> Result<Case, VerifyError> {
        let all: Vec<String> = overrides.iter().chain(&self.wish.overrides).cloned().collect();
        let mut case = case::parse(text, "case.toml", &all)?;
        if case.numerics.threads == 0 {
            case.numerics.threads = self.wish.threads;
        }
        Ok(case)
    }

    /// A simulation of a case file's text with overrides, to be taken through time by the benchmark itself: that is done in
    /// double precision alone.
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

    /// Runs a case to its end and keeps its ledgers.
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
                simulation.widened()
            }
        };
        self.keep(id, variant, &simulation);
        Ok(simulation)
    }

    /// Runs a simulation to its end and keeps its ledgers.
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

    /// The same, with a look at every sample.
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
        self.keep(id, variant, simulation);
        Ok(())
    }

    /// Takes a simulation to its end and says how it goes.
    fn advance<R: solver::precision::Precision>(
        &mut self,
        id: &'static str,
        variant: &str,
        simulation: &mut Simulation<R>,
        mut watch: impl FnMut(&Simulation<R>),
    ) -> Result<(), VerifyError> {
        const NEWS: Duration = Duration::from_secs(15);
        let clock = Instant::now();
        let mut told = Instant::now();
        while !simulation.is_done() {
            simulation.advance()?;
            watch(simulation);
            if self.stopped.is_none() {
                self.stopped = would_stop(simulation).err().map(|why| why.to_string());
            }
            if told.elapsed() > NEWS {
                told = Instant::now();
                let share = 1e2 * simulation.state.time / simulation.case.duration;
                self.tell(&format!("{id}: {variant}, {share:.0} %"));
            }
        }
        let seconds = clock.elapsed().as_secs_f64();
        self.tell(&format!("{id}: {variant}, {} steps in {seconds:.1} s", simulation.state.step));
        Ok(())
    }

    /// A figure that is among the rows already; not a number if it is not.
    #[must_use]
    pub fn obtained(&self, id: &str, case: &str, quantity: &str) -> f64 {
        let row = self.rows.iter().find(|r| r.id == id && r.case == case && r.quantity == quantity);
        row.map_or(f64::NAN, |r| r.obtained)
    }

    /// Keeps the ledgers of a run that has come to its end.
    pub fn keep(&mut self, id: &'static str, variant: &str, simulation: &Simulation) {
        let history = &simulation.history;
        let stopped = self.stopped.take();
        let off = history.energy.iter().map(|e| (e.volume_ratio - 1.0).abs());
        self.ledgers.push(Ledgers {
            id,
            case: variant.to_owned(),
            energy: history.energy.last().copied().unwrap_or_default(),
            // `max` would drop what is not a number.
            volume_off: off.fold(0.0, |most, v| if v > most || v.is_nan() { v } else { most }),
            mass_off: mass_off(simulation),
            dilates: matches!(simulation.case.soil.law, Law::MohrCoulomb { dilation_angle, .. } if dilation_angle > 0.0),
            bodies: history.bodies.iter().filter_map(|b| b.last().copied()).collect(),
            seconds: simulation.wall_s,
            trace: Trace::of(simulation),
            trust: simulation.trust(stopped.as_deref()),
        });
    }
}

/// Change of the soil's mass since the start, with what the remaps took out, as a share.
fn mass_off(simulation: &Simulation) -> f64 {
    let Simulation { model, state, .. } = simulation;
    // Mass and volume of the soil at the start go together by its density.
    let before = model.density * state.ledger.volume_start;
    (soil_mass(&state.soil) + state.ledger.crumbs_mass - before) / before
}
