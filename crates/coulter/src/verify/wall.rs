//! B5: a smooth vertical wall pushed into a bank of sand.

use super::bench::{Bench, VerifyError};
use super::row::Row;
use crate::output::surface::HeightMap;
use crate::simulation::Simulation;

const CASE: &str = include_str!("../../../../validation/B5_passive_wall/case.toml");
const SOURCE: &str = "Rankine (1857): exact, tan²(45° + φ/2)";
/// Height of the bank in the case file [m].
const HEIGHT: f64 = 1.0;
/// Displacements between which the thrust is read [m].
const FROM_TO: [f64; 2] = [0.05 * HEIGHT, 0.1 * HEIGHT];

/// What it is about.
pub(super) const ABOUT: &str = "A smooth vertical wall is pushed into a bank of dry sand on a smooth floor, which makes \
    the soil fail in the passive Rankine state: E_p = ½ K_p γ H². Read as the mean of the horizontal thrust over a \
    displacement of 0.05 to 0.1 H, once over ½ γ H² with the undisturbed height, once with the heave counted: over the \
    weight that the Rankine wedge really has then, that is with H² = 2 A tan(45° − φ/2), A being the area of the soil \
    above the plane that rises from the wall's toe at 45° − φ/2 to the deformed surface.";

pub(super) fn run(bench: &mut Bench) -> Result<(), VerifyError> {
    let variants: &[(u32, u32)] =
        if bench.wish.fast { &[(30, 8)] } else { &[(30, 8), (30, 16), (35, 16), (40, 16)] };
    for &(angle, cells) in variants {
        push(bench, angle, cells)?;
    }
    Ok(())
}

fn push(bench: &mut Bench, angle: u32, cells: u32) -> Result<(), VerifyError> {
    let variant = format!("φ = {angle}°, H/h = {cells}");
    let overrides =
        [format!("soil.friction_angle={angle} deg"), format!("grid.cell={} m", HEIGHT / f64::from(cells))];
    let mut simulation = bench.simulation(CASE, &overrides)?;
    let half = 0.5 * f64::from(angle).to_radians();
    let rise = (std::f64::consts::FRAC_PI_4 - half).tan();
    let (mut plain, mut heaved, mut time) = (0.0, 0.0, 0.0);
    while !simulation.is_done() {
        let before = simulation.state.time;
        simulation.advance()?;
        let Some(now) = simulation.history.bodies[0].last().copied() else { continue };
        if now.displacement >= FROM_TO[0] && now.displacement <= FROM_TO[1] {
            let interval = simulation.state.time - before;
            let slab = simulation.case.domain.high.y - simulation.case.domain.low.y;
            let unit = 0.5 * simulation.case.soil.unit_weight * slab;
            plain += interval * now.drag / (unit * HEIGHT * HEIGHT);
            heaved += interval * now.drag / (unit * 2.0 * wedge(&simulation, now.displacement, rise) * rise);
            time += interval;
        }
    }
    bench.tell(&format!("B5: {variant}, {} steps in {:.1} s", simulation.state.step, simulation.wall_s));
    bench.keep("B5", &variant, &simulation);
    let exact = 1.0 / (rise * rise);
    for (quantity, sum) in [("K_p, heave counted", heaved), ("K_p over the undisturbed height", plain)] {
        let row = Row::note("B5", variant.as_str(), quantity, sum / time);
        bench.rows.push(row.within(exact, 0.02, SOURCE).took(simulation.wall_s));
    }
    Ok(())
}

/// Area of the soil above a plane that rises from the wall's toe with this slope [m²].
fn wedge(simulation: &Simulation, displacement: f64, slope: f64) -> f64 {
    let map = HeightMap::of(&simulation.case, &simulation.model.grid, &simulation.state);
    let floor = simulation.case.domain.low.z;
    let columns = map.edges[0].windows(2).enumerate();
    columns
        .filter(|(_, edge)| edge[1] > displacement)
        .map(|(i, edge)| {
            let (low, width) = (edge[0].max(displacement), edge[1] - edge[0].max(displacement));
            let plane = floor + slope * (low + 0.5 * width - displacement);
            (map.at(i, 0) - plane).max(0.0) * width
        })
        .sum()
}
