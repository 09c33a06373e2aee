//! A2: the volume fraction is carried along by prescribed motions, and should keep its shape.

use super::bench::Bench;
use super::carried::{Flow, carry};
use super::error::VerifyError;
use super::row::Row;
use glam::DVec3;
use std::f64::consts::PI;

/// What it is about.
pub(super) const ABOUT: &str = "The remap alone: nodes get a prescribed displacement, a remap carries the volume fraction \
    back to the grid, again and again. Sphere: radius 0.2 and 0.15 (the trial did not say; its figures are those of 0.15) in the unit box with 40 cells along each edge, moved by (0.4, \
    0.25, 0.15), 0.1 cells per remap in the fastest direction unless it says otherwise; the error is Σ|f − f_exact| V over the \
    sphere's volume. Zalesak's slotted disc: one turn on 200² cells (relative). LeVeque's vortex and the 3D deformation flow \
    there and back: Σ|f − f_0| V in the unit box. The latter three with at most half a cell per remap, as in the studies \
    they are compared with.";

const OWN: &str = "exact: the shape moves unchanged; the limit is the design's";
const ZALESAK: &str = "Zalesak (1979); PLIC figures 1.1e-2 (Rudman 1997; Harvie and Fletcher 2000)";
const VORTEX: &str = "Rider and Kothe (1998): 6.96e-3 on 64², 1.44e-3 on 128², unsplit";
const DEFORMATION: &str =
    "LeVeque (1996), Enright et al. (2002); PLIC figures 7.4e-3 to 8e-3 on 32³, 2e-3 to 3e-3 on 64³";

pub(super) fn run(bench: &mut Bench) -> Result<(), VerifyError> {
    sphere(bench, 0.2, 0.1, true);
    sphere(bench, 0.15, 0.1, true);
    if bench.wish.fast {
        return Ok(());
    }
    for pace in [0.02, 0.2, 0.4] {
        sphere(bench, 0.15, pace, false);
    }
    zalesak(bench);
    for (cells, limit) in [(64, 1.3e-2), (128, 2.6e-3)] {
        let flow =
            Flow { box_cells: [cells, cells, 1], period: 8.0, turns_back: true, velocity: vortex, pace: 0.5 };
        let inside = |x: DVec3| (x.x - 0.5).hypot(x.y - 0.75) < 0.15;
        there_and_back(bench, &flow, &format!("vortex T = 8, {cells}²"), inside, limit, VORTEX);
    }
    for (cells, limit) in [(32, 9e-3), (64, 3.2e-3)] {
        let flow =
            Flow { box_cells: [cells; 3], period: 3.0, turns_back: true, velocity: deformation, pace: 0.5 };
        let inside = |x: DVec3| (x - DVec3::splat(0.35)).length() < 0.15;
        there_and_back(bench, &flow, &format!("3D deformation, {cells}³"), inside, limit, DEFORMATION);
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

fn sphere(bench: &mut Bench, radius: f64, pace: f64, judged: bool) {
    const WAY: DVec3 = DVec3::new(0.4, 0.25, 0.15);
    const FROM: DVec3 = DVec3::new(0.3, 0.35, 0.4);
    let flow = Flow { box_cells: [40; 3], period: 1.0, turns_back: false, velocity: |_| WAY, pace };
    let ball = |middle: DVec3| move |x: DVec3| (x - middle).length() < radius;
    let carried = carry(&flow, ball(FROM));
    bench.tell(&format!("A2: sphere, r = {radius}, {pace} cells per remap, {:.1} s", carried.seconds));
    let size = 4.0 / 3.0 * PI * radius.powi(3);
    let error = carried.distance(ball(FROM + WAY)) / size;
    let variant = format!("sphere, r = {radius}, {pace} cells per remap");
    let note = |quantity, value| Row::note("A2", variant.as_str(), quantity, value).took(carried.seconds);
    let shape = note("relative L1 error of the shape", error);
    if !judged {
        bench.rows.push(shape);
        return;
    }
    bench.rows.push(shape.at_most(0.02, OWN));
    bench.rows.push(note("change of volume, crumbs counted", carried.volume_change()).at_most(1e-12, OWN));
    bench.rows.push(note("volume fraction beyond 0 to 1", carried.beyond).at_most(0.0, OWN));
    bench.rows.push(note("crumbs taken out over the volume", carried.crumbs / carried.before));
}

fn zalesak(bench: &mut Bench) {
    let turn = |x: DVec3| 2.0 * PI * DVec3::new(0.5 - x.y, x.x - 0.5, 0.0);
    let flow = Flow { box_cells: [200, 200, 1], period: 1.0, turns_back: false, velocity: turn, pace: 0.5 };
    let inside = |x: DVec3| {
        let in_slot = (x.x - 0.5).abs() < 0.025 && x.y < 0.85;
        (x.x - 0.5).hypot(x.y - 0.75) < 0.15 && !in_slot
    };
    let carried = carry(&flow, inside);
    bench.tell(&format!("A2: Zalesak's disc, {:.1} s", carried.seconds));
    let row = Row::note(
        "A2",
        "Zalesak's disc, 200²",
        "relative L1 error of the shape",
        carried.distance(inside) / carried.before,
    );
    bench.rows.push(row.at_most(1.4e-2, ZALESAK).took(carried.seconds));
}

fn there_and_back(
    bench: &mut Bench,
    flow: &Flow,
    variant: &str,
    inside: impl Fn(DVec3) -> bool,
    limit: f64,
    source: &'static str,
) {
    let carried = carry(flow, &inside);
    bench.tell(&format!("A2: {variant}, {:.1} s", carried.seconds));
    // In a slab the volume is that per unit of depth.
    let depth = *carried.model.grid.faces[2].last().unwrap_or(&1.0);
    let row = Row::note("A2", variant, "L1 error of the shape", carried.distance(inside) / depth);
    bench.rows.push(row.at_most(limit, source).took(carried.seconds));
}
