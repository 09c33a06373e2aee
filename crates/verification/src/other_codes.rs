//! E1 to E3: problems that other codes have been run on. Only the wall is judged, which has an exact solution: the codes
//! differ among themselves by more than any tolerance. Their figures and run times are in `docs/performance.md`.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::row::Row;
use crate::runner::Runner;
use coulter::simulation::Simulation;

const COLUMN: &str = include_str!("../../../validation/E1_sand_column/case.toml");
const DISC: &str = include_str!("../../../validation/E2_disc_drag/case.toml");
const WALL: &str = include_str!("../../../validation/E3_wall/case.toml");
/// Fraction of the soil's mass that lies between the origin and the front of the heap.
const MASS_FRACTION: f64 = 0.995;

/// What E1 is about.
pub(crate) const ABOUT_COLUMN: &str = "A column of dry sand, 0.3 × 0.1 × 0.3 m, collapses between smooth walls on a floor \
    without slip. Evaluated after 0.8 s: the distance within which 99.5 % of the mass lies, and the height below which it lies. \
    Four other codes gave 0.394 to 0.618 m and 0.128 to 0.293 m on 20 mm cells: there is no agreed answer.";
/// What E2 is about.
pub(crate) const ABOUT_DISC: &str = "A disc of 0.1 × 0.02 m, half buried, that neither sinks nor turns is towed through dry \
    sand at 0.5 m/s. Evaluated over the last third of 0.3 m of tow. On 10 mm cells the disc is only two cells thick.";
/// What E3 is about.
pub(crate) const ABOUT_WALL: &str = "A smooth wall is pushed into the same sand, 16 cells high. Exact: the passive Rankine \
    state. Evaluated as in B5, over the undisturbed height, between displacements of 0.05 and 0.1 of it. With ψ = 0 the sand \
    localises into shear bands, which carry less (see B5).";

pub(crate) fn column(runner: &mut Runner) -> Result<(), VerifyError> {
    let sizes: &[u32] = if runner.options.fast { &[20] } else { &[20, 10] };
    for size in sizes {
        let variant = format!("h = {size} mm");
        let simulation = runner.run("E1", &variant, COLUMN, &[format!("grid.cell={size} mm")])?;
        let info =
            |quantity, value| Row::info("E1", variant.as_str(), quantity, value).took(simulation.wall_s);
        let source = "four other codes on 20 mm cells, see docs/performance.md";
        runner.rows.extend([
            info("99.5 % of the mass within [m]", quantile(&simulation, 0))
                .compared_with(0.394, 0.618, source),
            info("99.5 % of the mass below [m]", quantile(&simulation, 2))
                .compared_with(0.128, 0.293, source),
        ]);
    }
    Ok(())
}

pub(crate) fn disc(runner: &mut Runner) -> Result<(), VerifyError> {
    if runner.options.fast {
        return Ok(());
    }
    let variant = "h = 10 mm";
    let simulation = runner.run("E2", variant, DISC, &[])?;
    let window = [0.2, 0.3];
    let last = |value: &dyn Fn(&_) -> f64| {
        mean(&simulation.history.bodies[0], window, |s| s.displacement, |s| value(s))
    };
    let drag = last(&|s| s.drag);
    let variance = last(&|s| (s.drag - drag).powi(2));
    let info = |quantity, value| Row::info("E2", variant, quantity, value).took(simulation.wall_s);
    let source = "an MPM script of this project on 12.5 mm, Drucker–Prager; at 20 mm it gave exactly 0";
    runner.rows.extend([
        info("drag F_H [N]", drag).compared_with(24.8, 30.2, source),
        info("standard deviation of the drag [N]", variance.sqrt()),
        info("vertical force F_V [N]", last(&|s| s.vertical)).compared_with(11.2, 14.2, source),
    ]);
    Ok(())
}

pub(crate) fn wall(runner: &mut Runner) -> Result<(), VerifyError> {
    let simulation = runner.run("E3", "H/h = 16", WALL, &[])?;
    let case = &simulation.case;
    let height = -case.domain.low.z;
    let unit = 0.5 * case.soil.unit_weight * (case.domain.high.y - case.domain.low.y) * height * height;
    let window = [0.05 * height, 0.1 * height];
    let thrust = mean(&simulation.history.bodies[0], window, |s| s.displacement, |s| s.drag);
    let row = Row::info("E3", "H/h = 16", "K_p over the undisturbed height", thrust / unit);
    let exact = std::f64::consts::FRAC_PI_4 + 0.5 * 35_f64.to_radians();
    runner.rows.push(row.took(simulation.wall_s).within(
        exact.tan().powi(2),
        0.02,
        "Rankine (1857): exact, tan²(45° + φ/2)",
    ));
    Ok(())
}

/// The coordinate along an axis below which [`MASS_FRACTION`] of the soil lies [m]; the soil of a cell counts as distributed
/// evenly over it.
fn quantile(simulation: &Simulation, axis: usize) -> f64 {
    let (grid, mass) = (&simulation.model.grid, &simulation.state.soil.mass);
    let [nx, ny, nz] = grid.cells();
    let mut layers = vec![0.0; grid.cells()[axis]];
    for (k, j, i) in cells(nz, ny, nx) {
        layers[[i, j, k][axis]] += mass[grid.index(i, j, k)];
    }
    let target = MASS_FRACTION * layers.iter().sum::<f64>();
    let mut below = 0.0;
    for (n, layer) in layers.iter().enumerate() {
        if below + layer >= target {
            return grid.faces[axis][n] + grid.width(axis, n) * (target - below) / layer;
        }
        below += layer;
    }
    grid.faces[axis][layers.len()]
}

/// Every cell (k, j, i), x fastest.
fn cells(nz: usize, ny: usize, nx: usize) -> impl Iterator<Item = (usize, usize, usize)> {
    (0..nz).flat_map(move |k| (0..ny).flat_map(move |j| (0..nx).map(move |i| (k, j, i))))
}
