//! Figures that are read from a run.

use coulter::history::BodySample;
use coulter::simulation::Simulation;

/// Mean of a figure over the samples whose abscissa lies in `from..=to`, each weighted by its interval; not a
/// number if there are none.
#[must_use]
pub(crate) fn mean(
    samples: &[BodySample],
    [from, to]: [f64; 2],
    along: impl Fn(&BodySample) -> f64,
    value: impl Fn(&BodySample) -> f64,
) -> f64 {
    let (mut sum, mut weight) = (0.0, 0.0);
    for pair in samples.windows(2) {
        let at = along(&pair[1]);
        if at >= from && at <= to {
            let interval = pair[1].time - pair[0].time;
            sum += value(&pair[1]) * interval;
            weight += interval;
        }
    }
    sum / weight
}

/// Thickness of the soil in the column of cells `(i, j)` [m].
pub(crate) fn thickness(simulation: &Simulation, i: usize, j: usize) -> f64 {
    let (grid, fraction) = (&simulation.model.grid, &simulation.state.soil.fraction);
    (0..grid.cells()[2]).map(|k| fraction[grid.index(i, j, k)] * grid.width(2, k)).sum()
}
