//! A2: advection of the volume fraction by prescribed motions, which should preserve its shape.

use crate::advection::{Flow, advect};
use crate::error::VerifyError;
use crate::runner::Runner;
use glam::DVec3;
use std::f64::consts::PI;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for (radius, cells_per_remap) in [(0.2, 0.1), (0.15, 0.1), (0.15, 0.02), (0.15, 0.2), (0.15, 0.4)] {
        sphere(runner, radius, cells_per_remap)?;
    }
    zalesak(runner)?;
    for cells in [64, 128] {
        let flow = Flow {
            box_cells: [cells, cells, 1],
            period: runner.lasting(8.0),
            returns: true,
            velocity: vortex,
            cells_per_remap: 0.5,
        };
        let inside = |x: DVec3| (x.x - 0.5).hypot(x.y - 0.75) < 0.15;
        there_and_back(runner, &flow, &format!("vortex T = 8, {cells}²"), inside)?;
    }
    for cells in [32, 64] {
        let flow = Flow {
            box_cells: [cells; 3],
            period: runner.lasting(3.0),
            returns: true,
            velocity: deformation,
            cells_per_remap: 0.5,
        };
        let inside = |x: DVec3| (x - DVec3::splat(0.35)).length() < 0.15;
        there_and_back(runner, &flow, &format!("3D deformation, {cells}³"), inside)?;
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

const SHAPE: &str = "relative L1 error of the shape";

fn sphere(runner: &mut Runner, radius: f64, cells_per_remap: f64) -> Result<(), VerifyError> {
    const PATH: DVec3 = DVec3::new(0.4, 0.25, 0.15);
    const FROM: DVec3 = DVec3::new(0.3, 0.35, 0.4);
    let variant = format!("sphere, r = {radius}, {cells_per_remap} cells per remap");
    if !runner.wants("A2", &variant)? {
        return Ok(());
    }
    let period = runner.lasting(1.0);
    let flow = Flow { box_cells: [40; 3], period, returns: false, velocity: |_| PATH, cells_per_remap };
    let inside = |middle: DVec3| move |x: DVec3| (x - middle).length() < radius;
    let advected = advect(&flow, inside(FROM));
    runner.report_progress(&format!(
        "A2: sphere, r = {radius}, {cells_per_remap} cells per remap, {:.1} s",
        advected.seconds
    ));
    let size = 4.0 / 3.0 * PI * radius.powi(3);
    let mut figures = vec![(SHAPE, advected.distance(inside(FROM + PATH)) / size)];
    // The other steps show how the error of the shape depends on them.
    if cells_per_remap == 0.1 {
        figures.extend([
            ("change of volume, debris included", advected.volume_change()),
            ("volume fraction outside 0 to 1", advected.beyond),
            ("debris removed over the volume", advected.debris / advected.before),
        ]);
    }
    runner.put("A2", &variant, advected.seconds, &figures)
}

fn zalesak(runner: &mut Runner) -> Result<(), VerifyError> {
    let variant = "Zalesak's disc, 200²";
    if !runner.wants("A2", variant)? {
        return Ok(());
    }
    let turn = |x: DVec3| 2.0 * PI * DVec3::new(0.5 - x.y, x.x - 0.5, 0.0);
    let period = runner.lasting(1.0);
    let flow =
        Flow { box_cells: [200, 200, 1], period, returns: false, velocity: turn, cells_per_remap: 0.5 };
    let inside = |x: DVec3| {
        let in_slot = (x.x - 0.5).abs() < 0.025 && x.y < 0.85;
        (x.x - 0.5).hypot(x.y - 0.75) < 0.15 && !in_slot
    };
    let advected = advect(&flow, inside);
    runner.report_progress(&format!("A2: Zalesak's disc, {:.1} s", advected.seconds));
    let error = advected.distance(inside) / advected.before;
    runner.put("A2", variant, advected.seconds, &[(SHAPE, error)])
}

fn there_and_back(
    runner: &mut Runner,
    flow: &Flow,
    variant: &str,
    inside: impl Fn(DVec3) -> bool,
) -> Result<(), VerifyError> {
    if !runner.wants("A2", variant)? {
        return Ok(());
    }
    let advected = advect(flow, &inside);
    runner.report_progress(&format!("A2: {variant}, {:.1} s", advected.seconds));
    // In a slab the volume is that per unit of depth.
    let depth = *advected.model.grid.faces[2].last().unwrap_or(&1.0);
    let error = advected.distance(inside) / depth;
    runner.put("A2", variant, advected.seconds, &[("L1 error of the shape", error)])
}
