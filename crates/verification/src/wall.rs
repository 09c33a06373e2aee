//! B5: a smooth vertical wall pushed into a bank of sand.

use crate::error::VerifyError;
use crate::runner::Runner;
use coulter::simulation::Simulation;

const CASE: &str = include_str!("../validation/B5_passive_wall/case.toml");
/// Height of the bank in the case file [m].
const HEIGHT: f64 = 1.0;
/// Displacements over the height between which the thrust is averaged, for a short push and for a long one.
const FROM_TO: [[f64; 2]; 2] = [[0.05, 0.1], [0.25, 0.3]];
/// The peak is looked for up to this displacement over the height.
const PEAK: f64 = 0.02;
/// The residual is the mean from this part of the push on.
const RESIDUAL: f64 = 2.0 / 3.0;

/// Angles of friction and dilation [°], cells over the height; first the short pushes, then the long ones.
const SHORT: [[u32; 3]; 7] =
    [[30, 0, 8], [30, 0, 16], [35, 0, 16], [40, 0, 16], [30, 30, 16], [35, 35, 16], [40, 40, 16]];
const LONG: [[u32; 3]; 4] = [[30, 0, 16], [30, 30, 16], [35, 35, 16], [40, 40, 16]];

const RESIDUAL_FACTOR: &str = "residual K_p over the last third, heave included";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    let short = SHORT.into_iter().map(|angles_and_cells| (angles_and_cells, FROM_TO[0]));
    let long = LONG.into_iter().map(|angles_and_cells| (angles_and_cells, FROM_TO[1]));
    for (angles_and_cells, from_to) in short.chain(long) {
        if !runner.wants("B5", &name(angles_and_cells, from_to))? {
            continue;
        }
        push(runner, angles_and_cells, from_to)?;
    }
    Ok(())
}

fn push(
    runner: &mut Runner,
    angles_and_cells @ [_, dilation, _]: [u32; 3],
    from_to @ [_, to]: [f64; 2],
) -> Result<(), VerifyError> {
    let variant = name(angles_and_cells, from_to);
    let (thrust, seconds) = thrust(runner, angles_and_cells, from_to)?;
    let heaved = |from_to| mean(&thrust, from_to, |t| t.heaved);
    let mut figures = vec![
        ("K_p, heave included", heaved(from_to)),
        ("K_p over the undisturbed height", mean(&thrust, from_to, |t| t.plain)),
    ];
    if dilation == 0 {
        let early = thrust.iter().filter(|t| t.displacement <= PEAK).map(|t| t.heaved);
        let residual = heaved([RESIDUAL * to, to]);
        let [low, high] = runner.expectation("B5", &variant, RESIDUAL_FACTOR)?.range()?;
        figures.extend([
            ("largest K_p up to 0.02 H, heave included", early.fold(f64::NAN, f64::max)),
            (RESIDUAL_FACTOR, residual),
            ("place of the residual between Davis (0) and Rankine (1)", (residual - low) / (high - low)),
        ]);
    }
    runner.put("B5", &variant, seconds, &figures)
}

fn name([angle, dilation, cells]: [u32; 3], [_, to]: [f64; 2]) -> String {
    let suffix = if to > FROM_TO[0][1] { ", pushed 0.3 H" } else { "" };
    format!("φ = {angle}°, ψ = {dilation}°, H/h = {cells}{suffix}")
}

/// K_p with φ = ψ = 30° and the heave included, on a mesh of this many cells over the height.
pub(crate) fn associated_on(runner: &mut Runner, cells: u32) -> Result<f64, VerifyError> {
    let (thrust, _) = thrust(runner, [30, 30, cells], FROM_TO[0])?;
    Ok(mean(&thrust, FROM_TO[0], |t| t.heaved))
}

/// Horizontal thrust at a time, over that with K_p = 1.
struct Thrust {
    /// Displacement of the wall over the height.
    displacement: f64,
    /// Time since the sample before [s].
    interval: f64,
    /// Thrust over that with K_p = 1, by the undisturbed height.
    plain: f64,
    /// Thrust over that with K_p = 1, by the weight of the wedge, heave included.
    heaved: f64,
}

/// Mean over time between two displacements over the height.
fn mean(thrust: &[Thrust], [from, to]: [f64; 2], value: impl Fn(&Thrust) -> f64) -> f64 {
    let within = thrust.iter().filter(|t| t.displacement >= from && t.displacement <= to);
    let [sum, time] =
        within.fold([0.0; 2], |[sum, time], t| [sum + t.interval * value(t), time + t.interval]);
    sum / time
}

/// Pushes the wall into sand of these angles of friction and dilation [°], with this many cells over the
/// height. Returns the thrust in the course of time, and the wall-clock time [s].
fn thrust(
    runner: &mut Runner,
    angles_and_cells @ [angle, dilation, cells]: [u32; 3],
    from_to @ [_, to]: [f64; 2],
) -> Result<(Vec<Thrust>, f64), VerifyError> {
    let variant = name(angles_and_cells, from_to);
    let mut overrides = vec![
        format!("soil.friction_angle={angle} deg"),
        format!("soil.dilation_angle={dilation} deg"),
        format!("grid.cell={} m", HEIGHT / f64::from(cells)),
        format!("run.tow_distance={} m", to * HEIGHT),
    ];
    // The exact factor is that of sand which dilates without end.
    if dilation > 0 {
        overrides.push("soil.critical_density=1 kg/m^3".to_owned());
    }
    let mut simulation = runner.simulation(CASE, &overrides)?;
    let half = 0.5 * f64::from(angle).to_radians();
    let rise = (std::f64::consts::FRAC_PI_4 - half).tan();
    let unit = 0.5 * simulation.case.soil.unit_weight;
    let mut thrust = Vec::new();
    while !simulation.is_done() {
        let before = simulation.state.time;
        simulation.advance()?;
        let Some(now) = simulation.history.bodies[0].last().copied() else { continue };
        thrust.push(Thrust {
            displacement: now.displacement / HEIGHT,
            interval: simulation.state.time - before,
            plain: now.drag / (unit * HEIGHT * HEIGHT),
            heaved: now.drag / (unit * 2.0 * wedge(&simulation, now.displacement, rise) * rise),
        });
    }
    runner.report_progress(&format!(
        "B5: {variant}, {} steps in {:.1} s",
        simulation.state.step, simulation.wall_s
    ));
    runner.record("B5", &variant, &simulation);
    Ok((thrust, simulation.wall_s))
}

/// Cross-section that the soil above a plane would have at its initial density [m²]: its mass over that
/// density and the slab's width. The plane rises from the toe of the wall with this slope.
fn wedge(simulation: &Simulation, displacement: f64, slope: f64) -> f64 {
    let (grid, mass) = (&simulation.model.grid, &simulation.state.soil.mass);
    let toe = grid.faces[2][0];
    let mut sum = 0.0;
    for i in (0..grid.cells()[0]).filter(|i| grid.faces[0][i + 1] > displacement) {
        let low = grid.faces[0][i].max(displacement);
        let plane = toe + slope * (0.5 * (low + grid.faces[0][i + 1]) - displacement);
        for k in 0..grid.cells()[2] {
            let above = (grid.faces[2][k + 1] - plane) / grid.width(2, k);
            sum += mass[grid.index(i, 0, k)] * above.clamp(0.0, 1.0);
        }
    }
    sum / (simulation.model.material().density * grid.width(1, 0))
}
