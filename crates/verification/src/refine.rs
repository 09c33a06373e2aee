//! `coulter verify --refine`: the same benchmark on finer and finer meshes, the observed order of convergence
//! and the Richardson extrapolation.

use crate::error::VerifyError;
use crate::findings::Findings;
use crate::grid_convergence::{extrapolated, observed_order};
use crate::list::expectations;
use crate::options::SuiteOptions;
use crate::runner::Runner;
use crate::{circle, column, disc, flow, footing, plate, positions, rough_wall, strip_sand, wall};
use coulter::confidence::OnMesh;

/// A figure that can be obtained on meshes of different fineness.
struct Study {
    id: &'static str,
    /// Name of the number of cells: the length that they resolve over their width.
    cells: &'static str,
    quantity: &'static str,
    /// Cells of the coarsest mesh.
    coarsest: u32,
    /// Ratio of the cells of one mesh to those of the next coarser, as numerator and denominator.
    ratio: [u32; 2],
    figure: fn(&mut Runner, u32) -> Result<f64, VerifyError>,
}

/// In plane strain the cells are halved, in 3D they become a third smaller: time grows with the third and
/// fourth power.
const STUDIES: [Study; 11] = [
    Study {
        id: "A11",
        cells: "d/h",
        quantity: "block pushed along the grid, drag over s_u d",
        coarsest: 8,
        ratio: [2, 1],
        figure: positions::block_on,
    },
    Study {
        id: "B1",
        cells: "B/h",
        quantity: "smooth strip, N_c",
        coarsest: 8,
        ratio: [2, 1],
        figure: footing::smooth_on,
    },
    Study {
        id: "B2",
        cells: "B/h",
        quantity: "rough strip, N_c",
        coarsest: 8,
        ratio: [2, 1],
        figure: footing::rough_on,
    },
    Study {
        id: "B3",
        cells: "D/h",
        quantity: "smooth circle, N_c",
        coarsest: 8,
        ratio: [3, 2],
        figure: circle::smooth_on,
    },
    Study {
        id: "B4",
        cells: "B/h",
        quantity: "smooth strip, φ = 30°, ψ = 0°, N_γ",
        coarsest: 8,
        ratio: [2, 1],
        figure: strip_sand::smooth_on,
    },
    Study {
        id: "B5",
        cells: "H/h",
        quantity: "φ = ψ = 30°, K_p, heave included",
        coarsest: 8,
        ratio: [2, 1],
        figure: wall::associated_on,
    },
    Study {
        id: "B6",
        cells: "H/h",
        quantity: "φ = ψ = 30°, δ = 15°, K_n",
        coarsest: 8,
        ratio: [2, 1],
        figure: rough_wall::first_on,
    },
    Study {
        id: "B7",
        cells: "L/h",
        quantity: "φ = ψ = 30°, α = 60°, K_n",
        coarsest: 8,
        ratio: [2, 1],
        figure: plate::first_on,
    },
    Study {
        id: "B8",
        cells: "D/h",
        quantity: "smooth cylinder, N",
        coarsest: 8,
        ratio: [2, 1],
        figure: flow::smooth_on,
    },
    Study {
        id: "C1",
        cells: "L₀/h",
        quantity: "a = 1, φ = 37°, run-out, front where 0.025 L₀ thick",
        coarsest: 10,
        ratio: [2, 1],
        figure: column::run_out_on,
    },
    Study {
        id: "D3",
        cells: "d/h",
        quantity: "towed disc, drag [N]",
        coarsest: 16,
        ratio: [5, 4],
        figure: disc::drag_on,
    },
];

/// Ids of the benchmarks that can be refined.
#[must_use]
pub fn ids() -> Vec<&'static str> {
    STUDIES.iter().map(|study| study.id).collect()
}

/// Runs the benchmarks with these ids (all that can be refined if there are none) on `meshes` meshes each.
pub fn refine(
    ids: &[&'static str],
    meshes: u32,
    options: &SuiteOptions,
    progress: &mut dyn FnMut(&str),
) -> Findings {
    let expectations = match expectations() {
        Ok(expectations) => expectations,
        Err(unreadable) => return Findings { broken: vec![unreadable], ..Findings::default() },
    };
    let mut runner = Runner::new(expectations, options, progress).refining();
    let mut broken = Vec::new();
    for study in STUDIES.iter().filter(|s| ids.is_empty() || ids.contains(&s.id)) {
        if let Err(error) = study.run(&mut runner, meshes) {
            broken.push((study.id, error.to_string()));
        }
    }
    Findings { balances: runner.balances, rows: runner.rows, broken }
}

impl Study {
    fn run(&self, runner: &mut Runner, meshes: u32) -> Result<(), VerifyError> {
        let [up, down] = self.ratio;
        let mut cells = self.coarsest;
        let mut figures = Vec::new();
        for _ in 0..meshes {
            let figure = (self.figure)(runner, cells)?;
            let case = format!("{} = {cells}", self.cells);
            runner.put(self.id, &case, 0.0, &[(self.quantity, figure)])?;
            figures.push(figure);
            cells = cells * up / down;
        }
        let Some(last) = figures.last_chunk::<3>() else { return Ok(()) };
        let (order, limit) = richardson(*last, f64::from(up) / f64::from(down));
        let figures = [
            ("observed order of convergence (NaN: the differences do not shrink)", order),
            ("Richardson extrapolation to h = 0", limit),
        ];
        runner.put(self.id, "finest three meshes", 0.0, &figures)
    }
}

/// Observed order and extrapolated value from three meshes, coarse to fine, each finer than the one before by
/// `ratio`. Both are not a number where the differences do not shrink with one sign: there is no order then.
fn richardson([coarse, middle, fine]: [f64; 3], ratio: f64) -> (f64, f64) {
    let on = |width: f64, value: f64| OnMesh { width, value };
    let meshes = [on(ratio * ratio, coarse), on(ratio, middle), on(1.0, fine)];
    let [_, middle, fine] = meshes;
    observed_order(&meshes)
        .map_or((f64::NAN, f64::NAN), |order| (order, extrapolated(&[middle, fine], order)))
}

#[cfg(test)]
mod tests {
    use super::richardson;

    #[test]
    fn an_error_of_known_order_is_found_and_removed() {
        let on = |h: f64| 3.0 + 0.4 * h.powf(1.5);
        let (order, limit) = richardson([on(0.4), on(0.2), on(0.1)], 2.0);
        assert!((order - 1.5).abs() < 1e-9 && (limit - 3.0).abs() < 1e-9, "{order} {limit}");
    }

    #[test]
    fn what_does_not_converge_has_no_order() {
        assert!(richardson([1.0, 1.1, 1.3], 2.0).0.is_nan());
        assert!(richardson([1.0, 1.1, 1.0], 2.0).1.is_nan());
    }
}
