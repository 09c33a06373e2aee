//! Time by stage of a step. A stopwatch that was not started costs one comparison per lap.

use std::time::Instant;

/// A stage of the step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Strain, trial stress and nodal force coefficients.
    Lagrange,
    /// Return mapping.
    Plasticity,
    /// Forces gathered at the nodes, new velocities and displacements.
    Nodes,
    /// The Eulerian stage.
    Remap,
    /// Loads and drives of the bodies, contact, and contact search.
    Contact,
    /// Pore pressure.
    Seepage,
    /// Energy balance and checks.
    Other,
}

impl Stage {
    /// All stages, in the order of their numbers.
    pub const ALL: [Self; 7] = [
        Self::Lagrange,
        Self::Plasticity,
        Self::Nodes,
        Self::Remap,
        Self::Contact,
        Self::Seepage,
        Self::Other,
    ];
}

/// Time by stage of a worker.
#[derive(Clone, Debug, Default)]
pub struct Stopwatch {
    last: Option<Instant>,
    seconds: [f64; Stage::ALL.len()],
    returned: u64,
}

impl Stopwatch {
    /// Starts measuring from zero.
    pub fn start(&mut self) {
        *self = Self { last: Some(Instant::now()), ..Self::default() };
    }

    /// Adds the time since the last lap to `stage`.
    #[inline]
    pub(crate) fn lap(&mut self, stage: Stage) {
        if let Some(last) = &mut self.last {
            let now = Instant::now();
            self.seconds[stage as usize] += (now - *last).as_secs_f64();
            *last = now;
        }
    }

    /// Counts cells whose stress was returned to the yield surface.
    #[inline]
    pub(crate) fn count_returned(&mut self, cells: usize) {
        self.returned += cells as u64;
    }

    /// Time spent in a stage since the start [s].
    #[must_use]
    pub fn seconds(&self, stage: Stage) -> f64 {
        self.seconds[stage as usize]
    }

    /// Number of cells whose stress was returned to the yield surface, summed over the steps.
    #[must_use]
    pub fn returned(&self) -> u64 {
        self.returned
    }
}
