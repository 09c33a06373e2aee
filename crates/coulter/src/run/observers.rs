//! Observers of a run on behalf of its results folder. Each knows one thing; what they share is in the
//! folder.

use super::options::Follower;
use super::watch::watch;
use crate::interrupts::Interrupts;
use crate::simulation::{Next, Observer, ObserverError, Simulation, Stop};
use results::folder::{Log, Outcome, RunRecord, RunStatistics, StageRecord};
use results::progress::Progress;
use results::tables::HistoryFiles;
use results::vtk::FieldSeries;
use solver::error::Breakdown;
use solver::precision::Precision;
use std::path::Path;
use std::sync::atomic::Ordering;
use std::time::Instant;

/// Adds every sample to the history files, in the process that keeps them.
pub(super) struct Tables<'a>(pub(super) Option<&'a mut HistoryFiles>);

impl<R: Precision> Observer<R> for Tables<'_> {
    fn sampled(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        if let Some(tables) = &mut self.0 {
            tables.append(&simulation.history)?;
        }
        Ok(Next::Continue)
    }

    fn restored(&mut self, simulation: &Simulation<R>) -> Result<(), ObserverError> {
        Ok(self.0.as_mut().map_or(Ok(()), |tables| tables.begin_again(&simulation.history))?)
    }
}

/// Shows how far the run is.
pub(super) struct ProgressBar<'a>(pub(super) &'a mut Progress);

impl<R: Precision> Observer<R> for ProgressBar<'_> {
    fn sampled(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        self.0.update(simulation.state.time, &simulation.history);
        Ok(Next::Continue)
    }
}

/// Ends a run that can no longer become valid.
pub(super) struct Watch;

impl<R: Precision> Observer<R> for Watch {
    fn sampled(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        Ok(watch(simulation).map_or_else(Next::BreakDown, |()| Next::Continue))
    }
}

/// Writes the fields where they are due.
pub(super) struct Fields<'a>(pub(super) &'a mut FieldSeries);

impl<R: Precision> Observer<R> for Fields<'_> {
    fn sampled(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        let Simulation { case, model, state, history, .. } = simulation;
        if self.0.is_due(state.time, case.output.field_interval) {
            self.0.write(case, (&model.grid, simulation.halo()), state, history)?;
        }
        Ok(Next::Continue)
    }

    fn restored(&mut self, simulation: &Simulation<R>) -> Result<(), ObserverError> {
        self.0.go_back(simulation.state.time);
        Ok(())
    }
}

/// Tells a follower. It comes after those who write at a sample, so that one at which it stops the run is
/// complete.
pub(super) struct Followed<'a>(pub(super) &'a mut dyn Follower);

impl<R: Precision> Observer<R> for Followed<'_> {
    fn sampled(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        Ok(self.0.sampled(&simulation.history))
    }
}

/// Stops the run when a signal asks for it: all processes when it asks one of them.
pub(super) struct Signals<'a>(pub(super) &'a Interrupts);

impl<R: Precision> Observer<R> for Signals<'_> {
    fn sampled(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        if let Some(at_sample) = self.0.at_sample {
            at_sample();
        }
        // Between two exchanges with a program that steers the run this is the only occasion.
        self.between_steps(simulation)
    }

    fn between_steps(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        let mut signal = [f64::from(self.0.stopped_by().unwrap_or_default())];
        simulation.halo().largest(&mut signal);
        if signal[0] == 0.0 {
            return Ok(Next::Continue);
        }
        let signal = signal[0] as usize;
        self.0.stop.store(signal, Ordering::Relaxed);
        Ok(Next::Stop(format!("signal {signal}")))
    }
}

/// Writes checkpoints: by the wall clock of the first process, on request, and at the end.
pub(super) struct Checkpoints<'a> {
    folder: &'a Path,
    interrupts: &'a Interrupts,
    /// Log and record, in the process that keeps them.
    books: Option<(&'a mut Log, &'a mut RunRecord)>,
    /// When the last checkpoint was written.
    last: Instant,
}

impl<'a> Checkpoints<'a> {
    pub(super) fn new(
        folder: &'a Path,
        interrupts: &'a Interrupts,
        books: Option<(&'a mut Log, &'a mut RunRecord)>,
    ) -> Self {
        Self { folder, interrupts, books, last: Instant::now() }
    }

    fn is_due<R: Precision>(&self, simulation: &Simulation<R>) -> bool {
        self.last.elapsed().as_secs_f64() >= simulation.case.output.checkpoint_interval
    }
}

impl<R: Precision> Observer<R> for Checkpoints<'_> {
    fn reads_fields(&self, simulation: &Simulation<R>) -> bool {
        self.interrupts.asks_for_checkpoint() || self.is_due(simulation)
    }

    fn between_steps(&mut self, simulation: &Simulation<R>) -> Result<Next, ObserverError> {
        let asks =
            simulation.fields_are_home() && (self.interrupts.take_checkpoint() || self.is_due(simulation));
        let mut asked = [f64::from(u8::from(asks))];
        simulation.halo().largest(&mut asked);
        if asked[0] > 0.0 {
            simulation.checkpoint().write(self.folder)?;
            if let Some((log, record)) = &mut self.books {
                record.update(self.folder, statistics(simulation, Outcome::Running))?;
                log.line(&format!("checkpoint at t = {} s", simulation.state.time))?;
            }
            self.last = Instant::now();
        }
        Ok(Next::Continue)
    }

    fn ended(&mut self, simulation: &Simulation<R>, stop: &Stop) -> Result<(), ObserverError> {
        let checkpoint = simulation.checkpoint();
        match stop {
            // Its state is not complete.
            Stop::BrokenDown(Breakdown::Device { .. }) => {}
            Stop::BrokenDown(_) => checkpoint.write_failed(self.folder)?,
            Stop::Finished | Stop::Asked(_) => checkpoint.write(self.folder)?,
        }
        Ok(())
    }
}

/// Statistics of a run up to this point.
pub(super) fn statistics(simulation: &Simulation<impl Precision>, outcome: Outcome) -> RunStatistics {
    RunStatistics {
        steps: simulation.state.step,
        wall_seconds: simulation.wall_s,
        threads: simulation.threads(),
        outcome,
        advice: case::advice(&simulation.case),
        exchange: simulation.history.exchange.clone(),
        stages: StageRecord::all(&simulation.case, &simulation.history),
    }
}
