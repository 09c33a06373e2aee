//! A10: a copper bar hits a rigid wall end on.

use super::bench::{Bench, VerifyError};
use super::carried::fill;
use super::column::thickness;
use super::row::Row;
use crate::simulation::Simulation;
use std::f64::consts::PI;

const CASE: &str = include_str!("../../../../validation/A10_taylor_bar/case.toml");
const SOURCE: &str = "Lagrangian codes";
/// Radius and length of the bar [m], its speed [m/s].
const RADIUS: f64 = 3.2e-3;
const LENGTH: f64 = 32.4e-3;
const SPEED: f64 = 227.0;

/// What it is about.
pub(super) const ABOUT: &str = "x";

pub(super) fn run(bench: &mut Bench) -> Result<(), VerifyError> {
    let meshes: &[u32] = if bench.wish.fast { &[8] } else { &[8, 16, 4] };
    for cells in meshes {
        impact(bench, *cells)?;
    }
    Ok(())
}

fn impact(bench: &mut Bench, cells: u32) -> Result<(), VerifyError> {
    let variant = format!("R/h = {cells}");
    let cell = RADIUS / f64::from(cells);
    let case = bench.simulation(CASE, &[format!("grid.cell={cell} m")])?.case;
    let mut simulation = Simulation::filled(&case, |grid| {
        let mut fraction = vec![0.0; grid.entries];
        fill(grid, |x| x.x.hypot(x.y) <= RADIUS && x.z <= LENGTH, &mut fraction);
        fraction
    });
    let floor = 2 * simulation.model.grid.stride[2];
    simulation.set_in_motion(|state| {
        for (v, mass) in state.nodes.velocity[2].iter_mut().zip(&state.nodes.mass).skip(floor) {
            *v = if *mass > 0.0 { -SPEED } else { 0.0 };
        }
    });
    bench.finish_watched("A10", &variant, &mut simulation, |now| {
        let e = now.history.energy.last().unwrap();
        if std::env::var("TAYLOR").is_ok() {
            eprintln!("{:.2} us L {:.4} r {:.4} kin {:.4} el {:.4} pl {:.4} visc {:.4} hg {:.4} remap {:.5} close {:.5} vol {:.5}", now.state.time*1e6, 1e3*thickness(now,0,0), 1e3*radius(now,0), e.kinetic/e.external, e.elastic/e.external, e.plastic/e.external, e.viscous/e.external, e.hourglass/e.external, e.remap_loss/e.external, e.closure(), e.volume_ratio);
        }
    })?;
    let kinetic = simulation.history.energy.last().map_or(f64::NAN, |e| e.kinetic / e.external);
    let strain = simulation.state.soil.plastic_strain.iter().zip(&simulation.state.soil.fraction);
    let most = strain.filter(|(_, f)| **f > 0.5).map(|(e, _)| *e).fold(0.0, f64::max);
    if std::env::var("TAYLOR").is_ok() {
        for k in 0..simulation.model.grid.cells()[2] {
            eprint!("{:.3} ", 1e3 * radius(&simulation, k));
        }
        eprintln!();
        for i in 0..simulation.model.grid.cells()[0] {
            eprint!("{:.3} ", 1e3 * thickness(&simulation, i, 0));
        }
        eprintln!();
        eprintln!(
            "crumbs {:e} {:e} remaps {} steps {}",
            simulation.state.ledger.crumbs_volume / simulation.state.ledger.volume_start,
            simulation.state.ledger.crumbs_mass,
            simulation.state.remaps,
            simulation.state.step
        );
    }
    let note = |quantity, value| Row::note("A10", variant.as_str(), quantity, value).took(simulation.wall_s);
    bench.rows.extend([
        note("final length [mm]", 1e3 * thickness(&simulation, 0, 0)).between(21.4, 21.5, 0.015, SOURCE),
        note("foot radius [mm]", 1e3 * radius(&simulation, 0)).between(6.8, 7.2, 0.0, SOURCE),
        note("largest equivalent plastic strain", most).beside(2.5, 3.2, SOURCE),
        note("kinetic energy left, share", kinetic),
    ]);
    Ok(())
}

/// Radius of the circle that has the area of the bar in a layer of cells [m].
fn radius(simulation: &Simulation, layer: usize) -> f64 {
    let (grid, fraction) = (&simulation.model.grid, &simulation.state.soil.fraction);
    let [nx, ny, _] = grid.cells();
    let places = (0..nx).flat_map(|i| (0..ny).map(move |j| (i, j)));
    let area = |(i, j)| fraction[grid.index(i, j, layer)] * grid.width(0, i) * grid.width(1, j);
    (4.0 * places.map(area).sum::<f64>() / PI).sqrt()
}
