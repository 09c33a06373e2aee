//! A2: advection of the volume fraction by prescribed motions, which should preserve its shape.

use crate::advection::{Flow, advect};
use crate::error::VerifyError;
use crate::row::Row;
use crate::runner::Runner;
use glam::DVec3;
use std::f64::consts::PI;

/// Text for the documentation.
pub(crate) const ABOUT: &str = "The remap alone: the nodes are given a prescribed displacement and a remap maps the volume \
    fraction back to the grid, again and again. Sphere: radius 0.2 and 0.15 (the trial did not say; its figures are those of 0.15) in the unit box with 40 cells along each edge, moved by (0.4, \
    0.25, 0.15), 0.1 cells per remap in the fastest direction unless stated otherwise; the error is Σ|f − f_exact| V over the \
    sphere's volume. Zalesak's slotted disc: one revolution on 200² cells (relative). LeVeque's vortex and the 3D deformation flow, \
    forward and back: Σ|f − f_0| V in the unit box. The latter three use at most half a cell per remap, as in the studies \
    they are compared with.";

const OWN: &str = "exact: the shape moves unchanged; limit of the design";
const ZALESAK: &str = "Zalesak (1979); PLIC figures 1.1e-2 (Rudman 1997; Harvie and Fletcher 2000)";
const VORTEX: &str = "Rider and Kothe (1998): 6.96e-3 on 64², 1.44e-3 on 128², unsplit";
const DEFORMATION: &str =
    "LeVeque (1996), Enright et al. (2002); PLIC figures 7.4e-3 to 8e-3 on 32³, 2e-3 to 3e-3 on 64³";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    sphere(runner, 0.2, 0.1, true);
    sphere(runner, 0.15, 0.1, true);
    if runner.options.fast {
        return Ok(());
    }
    for cells_per_remap in [0.02, 0.2, 0.4] {
        sphere(runner, 0.15, cells_per_remap, false);
    }
    zalesak(runner);
    for (cells, limit) in [(64, 1.3e-2), (128, 2.6e-3)] {
        let flow = Flow {
            box_cells: [cells, cells, 1],
            period: 8.0,
            returns: true,
            velocity: vortex,
            cells_per_remap: 0.5,
        };
        let inside = |x: DVec3| (x.x - 0.5).hypot(x.y - 0.75) < 0.15;
        there_and_back(runner, &flow, &format!("vortex T = 8, {cells}²"), inside, limit, VORTEX);
    }
    for (cells, limit) in [(32, 9e-3), (64, 3.2e-3)] {
        let flow = Flow {
            box_cells: [cells; 3],
            period: 3.0,
            returns: true,
            velocity: deformation,
            cells_per_remap: 0.5,
        };
        let inside = |x: DVec3| (x - DVec3::splat(0.35)).length() < 0.15;
        there_and_back(runner, &flow, &format!("3D deformation, {cells}³"), inside, limit, DEFORMATION);
    }
    Ok(())
}

/// LeVeque's vortex in the unit square.
fn vortex(x: DVec3) -> DVec3 {
    let (sx, sy) = ((PI * x.x).sin(), (PI * x.y).sin());
    DVec3::new(-sx * sx * (2.0 * PI * x.y).sin(), sy * sy * (2.0 * PI * x.x).sin(), 0.0)
}

/// The 3D deformation field of LeVeque and of Enright et al.
fn deformation(x: DVec3) -> DVec3 {
    let single = DVec3::new((PI * x.x).sin(), (PI * x.y).sin(), (PI * x.z).sin()).powf(2.0);
    let double = DVec3::new((2.0 * PI * x.x).sin(), (2.0 * PI * x.y).sin(), (2.0 * PI * x.z).sin());
    DVec3::new(
        2.0 * single.x * double.y * double.z,
        -double.x * single.y * double.z,
        -double.x * double.y * single.z,
    )
}

fn sphere(runner: &mut Runner, radius: f64, cells_per_remap: f64, judged: bool) {
    const PATH: DVec3 = DVec3::new(0.4, 0.25, 0.15);
    const FROM: DVec3 = DVec3::new(0.3, 0.35, 0.4);
    let flow = Flow { box_cells: [40; 3], period: 1.0, returns: false, velocity: |_| PATH, cells_per_remap };
    let inside = |middle: DVec3| move |x: DVec3| (x - middle).length() < radius;
    let advected = advect(&flow, inside(FROM));
    runner.report_progress(&format!(
        "A2: sphere, r = {radius}, {cells_per_remap} cells per remap, {:.1} s",
        advected.seconds
    ));
    let size = 4.0 / 3.0 * PI * radius.powi(3);
    let error = advected.distance(inside(FROM + PATH)) / size;
    let variant = format!("sphere, r = {radius}, {cells_per_remap} cells per remap");
    let info = |quantity, value| Row::info("A2", variant.as_str(), quantity, value).took(advected.seconds);
    let shape = info("relative L1 error of the shape", error);
    if !judged {
        runner.rows.push(shape);
        return;
    }
    runner.rows.push(shape.at_most(0.02, OWN));
    runner.rows.push(info("change of volume, debris included", advected.volume_change()).at_most(1e-12, OWN));
    runner.rows.push(info("volume fraction outside 0 to 1", advected.beyond).at_most(0.0, OWN));
    runner.rows.push(info("debris removed over the volume", advected.debris / advected.before));
}

fn zalesak(runner: &mut Runner) {
    let turn = |x: DVec3| 2.0 * PI * DVec3::new(0.5 - x.y, x.x - 0.5, 0.0);
    let flow =
        Flow { box_cells: [200, 200, 1], period: 1.0, returns: false, velocity: turn, cells_per_remap: 0.5 };
    let inside = |x: DVec3| {
        let in_slot = (x.x - 0.5).abs() < 0.025 && x.y < 0.85;
        (x.x - 0.5).hypot(x.y - 0.75) < 0.15 && !in_slot
    };
    let advected = advect(&flow, inside);
    runner.report_progress(&format!("A2: Zalesak's disc, {:.1} s", advected.seconds));
    let row = Row::info(
        "A2",
        "Zalesak's disc, 200²",
        "relative L1 error of the shape",
        advected.distance(inside) / advected.before,
    );
    runner.rows.push(row.at_most(1.4e-2, ZALESAK).took(advected.seconds));
}

fn there_and_back(
    runner: &mut Runner,
    flow: &Flow,
    variant: &str,
    inside: impl Fn(DVec3) -> bool,
    limit: f64,
    source: &'static str,
) {
    let advected = advect(flow, &inside);
    runner.report_progress(&format!("A2: {variant}, {:.1} s", advected.seconds));
    // In a slab the volume is that per unit of depth.
    let depth = *advected.model.grid.faces[2].last().unwrap_or(&1.0);
    let row = Row::info("A2", variant, "L1 error of the shape", advected.distance(inside) / depth);
    runner.rows.push(row.at_most(limit, source).took(advected.seconds));
}
