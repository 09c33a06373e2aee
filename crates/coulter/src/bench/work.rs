//! How much work a step does, counted in the formulas as they stand: an addition, a multiplication, a
//! division and a root are one operation each, a comparison none. Remap and contact depend on the state and
//! are not counted.

use super::measurement::{Operations, Split};

/// Operations per cell and step: corner sums 135, trial stress 89, stress borne and dissipation 37, force
/// coefficients 34.
const LAGRANGE: f64 = 295.0;
/// The check whether a cell may yield.
const CHECK: f64 = 27.0;
/// The return of a cell that yields, with its dissipation: spectrum 225, return 63, stress and strain 65,
/// work 47.
const RETURN: f64 = 400.0;
/// Operations per node and step: forces gathered 73, motion 27, sums 9.
const NODES: f64 = 109.0;
/// Numbers per cell and step that cross the bus if each array does so once. Read: fraction, stress (6), gap,
/// mass, velocity (3), displacement (3). Written: stress (6), gap, velocity (3), displacement (3).
const NUMBERS: f64 = 15.0 + 13.0;

/// Work that was done, and the time that it took.
pub(super) struct Work {
    pub(super) cell_steps: f64,
    /// Cell-steps in which the soil yields.
    pub(super) returned: f64,
    /// Processor time [s].
    pub(super) seconds: f64,
    /// Size of a number [bytes].
    pub(super) bytes: usize,
}

impl Work {
    /// Rates of arithmetic [GFLOP/s].
    pub(super) fn operations(&self, split: &Split) -> Operations {
        let rate = |fraction: f64, operations: f64| 1e-9 * operations / (fraction * self.seconds);
        Operations {
            lagrange: rate(split.lagrange, LAGRANGE * self.cell_steps),
            plasticity: rate(split.plasticity, CHECK * self.cell_steps + RETURN * self.returned),
            nodes: rate(split.nodes, NODES * self.cell_steps),
        }
    }

    /// Traffic of the Lagrangian stage as a whole [GB/s].
    pub(super) fn traffic(&self, split: &Split) -> f64 {
        let fraction = split.lagrange + split.plasticity + split.nodes;
        1e-9 * NUMBERS * self.bytes as f64 * self.cell_steps / (fraction * self.seconds)
    }
}
