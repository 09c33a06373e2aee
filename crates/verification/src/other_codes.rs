//! E1 to E3: problems that other codes have been run on. Only the wall is judged, which has an exact
//! solution: the codes differ among themselves by more than any tolerance. Their figures and run times are in
//! `docs/reference/performance.md`.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use coulter::simulation::Simulation;

const COLUMN: &str = include_str!("../validation/E1_sand_column/case.toml");
const DISC: &str = include_str!("../validation/E2_disc_drag/case.toml");
const WALL: &str = include_str!("../validation/E3_wall/case.toml");
/// Fraction of the soil's mass that lies between the origin and the front of the heap.
const MASS_FRACTION: f64 = 0.995;

pub(crate) fn column(runner: &mut Runner) -> Result<(), VerifyError> {
    for size in [20, 10] {
        let variant = format!("h = {size} mm");
        if runner.wants("E1", &variant)? {
            let simulation = runner.run("E1", &variant, COLUMN, &[format!("grid.cell={size} mm")])?;
            let figures = [
                ("99.5 % of the mass within [m]", quantile(&simulation, 0)),
                ("99.5 % of the mass below [m]", quantile(&simulation, 2)),
            ];
            runner.put("E1", &variant, simulation.wall_s, &figures)?;
        }
    }
    Ok(())
}

pub(crate) fn disc(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "h = 10 mm";
    if !runner.wants("E2", variant)? {
        return Ok(());
    }
    let simulation = runner.run("E2", variant, DISC, &[])?;
    let window = [0.2, 0.3];
    let last = |value: &dyn Fn(&_) -> f64| {
        mean(&simulation.history.bodies[0], window, |s| s.displacement, |s| value(s))
    };
    let drag = last(&|s| s.drag);
    let variance = last(&|s| (s.drag - drag).powi(2));
    let figures = [
        ("drag F_H [N]", drag),
        ("standard deviation of the drag [N]", variance.sqrt()),
        ("vertical force F_V [N]", last(&|s| s.vertical)),
    ];
    runner.put("E2", variant, simulation.wall_s, &figures)
}

pub(crate) fn wall(runner: &mut Runner) -> Result<(), VerifyError> {
    let simulation = runner.run("E3", "H/h = 16", WALL, &[])?;
    let case = &simulation.case;
    let height = -case.domain.low.z;
    let unit = 0.5 * case.soil.unit_weight * height * height;
    let window = [0.05 * height, 0.1 * height];
    let thrust = mean(&simulation.history.bodies[0], window, |s| s.displacement, |s| s.drag);
    let figures = [("K_p over the undisturbed height", thrust / unit)];
    runner.put("E3", "H/h = 16", simulation.wall_s, &figures)
}

/// The coordinate along an axis below which [`MASS_FRACTION`] of the soil lies [m]; the soil of a cell counts
/// as distributed evenly over it.
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
