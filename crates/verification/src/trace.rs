//! What a run did, reduced to what a picture can show.

use crate::probe::thickness;
use coulter::simulation::Simulation;
use serde::{Deserialize, Serialize};

/// Points of a run in one picture at most.
const MOST_POINTS: usize = 120;

/// The course of a run, as one line of a picture.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub enum Trace {
    /// No line to be drawn.
    #[default]
    None,
    /// Force against the motion [N], in plane strain per metre of width, over the displacement along it [m].
    Force(Vec<[f64; 2]>),
    /// Thickness of the soil at the end [m] along x [m], in the first layer of cells along y.
    Heap(Vec<[f64; 2]>),
}

impl Trace {
    /// The trace of a run that has reached its end.
    #[must_use]
    pub fn of(simulation: &Simulation) -> Self {
        match simulation.history.bodies.first().filter(|samples| samples.len() > 1) {
            Some(samples) => {
                let (first, last) = (samples[0], samples[samples.len() - 1]);
                let sinks =
                    (last.sinkage - first.sinkage).abs() > (last.displacement - first.displacement).abs();
                let points = samples
                    .iter()
                    .map(|s| if sinks { [s.sinkage, s.vertical] } else { [s.displacement, s.drag] });
                Self::Force(averaged(&points.collect::<Vec<_>>()))
            }
            None if simulation.case.bodies.is_empty() => Self::Heap(heap(simulation)),
            None => Self::None,
        }
    }
}

/// Means over groups of neighbouring points.
fn averaged(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let size = points.len().div_ceil(MOST_POINTS).max(1);
    let mean = |group: &[[f64; 2]], n: usize| group.iter().map(|p| p[n]).sum::<f64>() / group.len() as f64;
    points.chunks(size).map(|group| [mean(group, 0), mean(group, 1)]).collect()
}

fn heap(simulation: &Simulation) -> Vec<[f64; 2]> {
    let grid = &simulation.model.grid;
    let column = |i: usize| [grid.centre(0, i), thickness(simulation, i, 0)];
    averaged(&(0..grid.cells()[0]).map(column).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_run_is_thinned_to_its_means() {
        let points: Vec<[f64; 2]> = (0..1000).map(|n| [f64::from(n), 1.0]).collect();
        let thin = averaged(&points);
        assert!(thin.len() <= MOST_POINTS && thin.iter().all(|p| p[1] == 1.0) && thin[0][0] == 4.0);
    }
}
