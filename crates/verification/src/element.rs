//! A5: element tests of the soil law.

use crate::confined::{isotropic, oedometer};
use crate::error::VerifyError;
use crate::runner::Runner;
use crate::specimen::{CONFINEMENT, Cell, Point, Specimen};
use physics::elastic::Elastic;
use physics::law::Law;
use physics::menetrey_willam::{Eccentricity, MenetreyWillam};
use physics::mohr_coulomb::MohrCoulomb;
use physics::tensor::{Spectrum, Symmetric};
use std::time::Instant;

/// Friction angle [°], dilation angle [°], cohesion [Pa].
const SOILS: [[f64; 3]; 6] = [
    [20.0, 0.0, 0.0],
    [30.0, 0.0, 0.0],
    [35.0, 10.0, 0.0],
    [40.0, 40.0, 0.0],
    [25.0, 5.0, 1e4],
    [0.0, 0.0, 2e4],
];
/// Strain increments, and the size of one.
const INCREMENTS: usize = 600;
const INCREMENT: f64 = 1e-4;

/// The kind of test.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Test {
    Compression,
    Extension,
    Shear,
}

/// The flow potential.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FlowPotential {
    Pyramid,
    Smooth,
}

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    yielding(runner)?;
    confined(runner)
}

/// Tests of soil that yields.
fn yielding(runner: &mut Runner) -> Result<(), VerifyError> {
    for (test, potential, name) in [
        (Test::Compression, FlowPotential::Pyramid, "triaxial compression"),
        (Test::Extension, FlowPotential::Pyramid, "triaxial extension"),
        (Test::Shear, FlowPotential::Pyramid, "simple shear"),
        (Test::Compression, FlowPotential::Smooth, "triaxial compression, smooth potential"),
        (Test::Extension, FlowPotential::Smooth, "triaxial extension, smooth potential"),
    ] {
        for on_cell in [false, true] {
            let clock = Instant::now();
            let mut worst = [0.0_f64; 3];
            for soil in SOILS {
                let off = if on_cell {
                    errors(test, potential, soil, Cell::new)?
                } else {
                    errors(test, potential, soil, point)?
                };
                // `max` would drop what is not a number.
                worst =
                    std::array::from_fn(
                        |n| if off[n] > worst[n] || off[n].is_nan() { off[n] } else { worst[n] },
                    );
            }
            let seconds = clock.elapsed().as_secs_f64();
            let variant = format!("{name}, one {}", if on_cell { "cell" } else { "point" });
            runner.report_progress(&format!("A5: {variant}, {seconds:.1} s"));
            let figures = [
                ("deviation of the strength from the exact value", worst[0]),
                ("yield function", worst[1]),
                ("deviation of the dilatancy from the analytic value", worst[2]),
            ];
            runner.put("A5", &variant, seconds, &figures)?;
        }
    }
    Ok(())
}

/// Tests in which every strain is prescribed.
fn confined(runner: &mut Runner) -> Result<(), VerifyError> {
    for on_cell in [false, true] {
        let clock = Instant::now();
        let mut worst = [0.0_f64; 2];
        for soil in SOILS {
            // A material point has no gap strain; only the cell has.
            let off = if on_cell {
                [oedometer(soil, Cell::new)?, isotropic(soil, true, Cell::new)?]
            } else {
                [oedometer(soil, point)?, isotropic(soil, false, point)?]
            };
            worst =
                std::array::from_fn(|n| if off[n] > worst[n] || off[n].is_nan() { off[n] } else { worst[n] });
        }
        let seconds = clock.elapsed().as_secs_f64();
        let on = if on_cell { "cell" } else { "point" };
        for (test, worst) in ["oedometer", "isotropic"].into_iter().zip(worst) {
            let figures = [("deviation of the stresses from the exact values", worst)];
            runner.put("A5", &format!("{test}, one {on}"), seconds, &figures)?;
        }
    }
    Ok(())
}

fn point(elastic: Elastic, law: Law, stress: Symmetric) -> Point {
    Point { elastic, law, stress }
}

/// Errors of strength, yield function and dilatancy at the end of a test.
fn errors<S: Specimen>(
    test: Test,
    potential: FlowPotential,
    [friction, dilation, cohesion]: [f64; 3],
    make: impl Fn(Elastic, Law, Symmetric) -> S,
) -> Result<[f64; 3], VerifyError> {
    // Stiff soil: the elastic strain, which hides the plastic flow, becomes negligible within the test.
    let elastic = Elastic::new(2e8, 0.3);
    let (phi, psi) = (friction.to_radians(), dilation.to_radians());
    let surface = MohrCoulomb::new(elastic, phi, psi, cohesion, 0.0);
    let usual = Eccentricity::usual(phi);
    let law = match potential {
        FlowPotential::Pyramid => Law::MohrCoulomb(surface),
        FlowPotential::Smooth => {
            Law::MenetreyWillam(MenetreyWillam::new(elastic, phi, psi, cohesion, 0.0, usual))
        }
    };
    let mut specimen = make(elastic, law, [-CONFINEMENT, -CONFINEMENT, -CONFINEMENT, 0.0, 0.0, 0.0]);
    let (driven, free): (Symmetric, &[usize]) = match test {
        Test::Compression => ([0.0, 0.0, -INCREMENT, 0.0, 0.0, 0.0], &[0, 1]),
        Test::Extension => ([0.0, 0.0, INCREMENT, 0.0, 0.0, 0.0], &[0, 1]),
        Test::Shear => ([0.0, 0.0, 0.0, 0.0, 0.0, 0.5 * INCREMENT], &[2]),
    };
    let mut last = driven;
    for _ in 0..INCREMENTS {
        last = controlled(&specimen, driven, free, last)?;
        specimen.strain(last)?;
    }
    let stress = specimen.stress();
    let yields = surface.yield_function(Spectrum::of(stress).principal).abs() / CONFINEMENT;
    let (strength, dilatancy) = match test {
        Test::Compression | Test::Extension => (-stress[2], (last[0] + last[1] + last[2]) / last[2].abs()),
        Test::Shear => (stress[5], last[2] / last[2].hypot(2.0 * last[5])),
    };
    let [exact_strength, exact_dilatancy] = exact(test, phi, psi, cohesion);
    let exact_dilatancy = match potential {
        FlowPotential::Pyramid => exact_dilatancy,
        FlowPotential::Smooth => {
            smooth_dilatancy(test, phi, psi, usual.meridional * cohesion, exact_strength)
        }
    };
    Ok([(strength - exact_strength).abs() / CONFINEMENT, yields, (dilatancy - exact_dilatancy).abs()])
}

/// Strength [Pa] and dilatancy of a test.
fn exact(test: Test, phi: f64, psi: f64, cohesion: f64) -> [f64; 2] {
    let (sp, sy) = (phi.sin(), psi.sin());
    let ratio = (1.0 + sp) / (1.0 - sp);
    let bond = 2.0 * cohesion * ratio.sqrt();
    match test {
        Test::Compression => [CONFINEMENT * ratio + bond, 2.0 * sy / (1.0 - sy)],
        Test::Extension => [(CONFINEMENT - bond) / ratio, 2.0 * sy / (1.0 + sy)],
        // Radius of Mohr's circle when the plane of zero extension carries the normal stress.
        Test::Shear => [(CONFINEMENT * sp + cohesion * phi.cos()) / (1.0 - sp * sy) * psi.cos(), sy],
    }
}

/// Dilatancy of a triaxial test with the smooth potential, whose ellipse meets the hexagon on both meridians.
/// `offset` is ε c [Pa], `axial` the axial stress at failure [Pa].
fn smooth_dilatancy(test: Test, phi: f64, psi: f64, offset: f64, axial: f64) -> f64 {
    let sign = if test == Test::Compression { 1.0 } else { -1.0 };
    let hexagon = (3.0 - sign * phi.sin()) / (6.0 * phi.cos());
    let sheared = hexagon * (axial - CONFINEMENT).abs();
    let slope = hexagon * sheared / sheared.hypot(offset * psi.tan());
    psi.tan() / (slope - sign * psi.tan() / 3.0)
}

/// The strain increment with the driven components as given, the free ones such that their stresses stay at
/// the confining pressure. Newton's method with finite differences: the law is piecewise linear.
fn controlled(
    specimen: &impl Specimen,
    driven: Symmetric,
    free: &[usize],
    guess: Symmetric,
) -> Result<Symmetric, VerifyError> {
    const PROBE: f64 = 1e-7;
    let mut strain = driven;
    free.iter().for_each(|n| strain[*n] = guess[*n]);
    for _ in 0..20 {
        let stress = specimen.response(strain)?;
        // Two free components are equal: the tests are symmetric about the axis.
        let off = stress[free[0]] + CONFINEMENT;
        if off.abs() < 1e-13 * CONFINEMENT {
            break;
        }
        let mut probe = strain;
        free.iter().for_each(|n| probe[*n] += PROBE);
        let slope = (specimen.response(probe)?[free[0]] - stress[free[0]]) / PROBE;
        free.iter().for_each(|n| strain[*n] -= off / slope);
    }
    Ok(strain)
}
