//! The paths of the usual element tests, and what is recorded on them.

use super::specimen::{Held, Specimen};
use physics::tensor::{Symmetric, mean, mises};
use solver::material::Material;

/// The usual tests.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TestKind {
    /// Drained triaxial compression at constant lateral stress.
    Triaxial,
    /// Vertical compression without lateral strain.
    Oedometer,
    /// Compression under equal pressure on all sides.
    Isotropic,
    /// Simple shear at constant vertical stress, after K₀ compression.
    Shear,
}

impl TestKind {
    /// Whether the specimen is sheared up to a strain; otherwise it is compressed up to a pressure and
    /// unloaded.
    #[must_use]
    pub fn shears(self) -> bool {
        matches!(self, Self::Triaxial | Self::Shear)
    }
}

/// A test of a specimen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Test {
    /// Kind of the test.
    pub kind: TestKind,
    /// Pressure at the start [Pa]: all round, but the vertical one in shear and in the oedometer.
    pub pressure: f64,
    /// Density at the start [kg/m³].
    pub density: f64,
    /// Largest strain of triaxial and shear tests: axial strain over the initial height, below 1; engineering
    /// shear strain.
    pub largest_strain: f64,
    /// Largest pressure [Pa] of oedometer and isotropic tests, from which the specimen is unloaded to the
    /// start.
    pub largest_pressure: f64,
}

/// A state on the path, compression positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// Logarithmic axial strain; engineering shear strain of shear tests.
    pub strain: f64,
    /// Logarithmic volumetric strain.
    pub volumetric_strain: f64,
    /// Vertical stress [Pa].
    pub vertical: f64,
    /// Lateral stress [Pa], across the plane of shear tests the one in it.
    pub lateral: f64,
    /// Shear stress [Pa].
    pub shear: f64,
    /// Mean pressure p [Pa].
    pub pressure: f64,
    /// Mises stress q [Pa].
    pub mises: f64,
    /// Density [kg/m³].
    pub density: f64,
    /// Whether the specimen is being unloaded.
    pub is_unloading: bool,
}

/// How a test ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// Complete: the test ended as asked.
    Complete,
    /// Early: no strain increment keeps the controlled stresses.
    Failed,
    /// Early: compressed to half its height, or its volume, before the largest pressure was reached.
    Crushed,
}

/// What a test gave.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// The points that were recorded, from the start on.
    pub points: Vec<PathPoint>,
    /// How the test ended.
    pub ending: Ending,
}

/// The soil cannot be at the stress at which a test starts: K₀ is beyond its strength.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "the soil cannot sustain a vertical pressure of {pressure} Pa with K₀ = {k0:.3}: it fails before the test begins"
)]
pub struct Unsustained {
    /// Vertical pressure at the start [Pa].
    pub pressure: f64,
    /// Coefficient of earth pressure at rest.
    pub k0: f64,
}

/// Largest strain increment. A quarter of this and of the next three changes no figure of sand by more than
/// 0.7 %, but for the strain at a flat peak (1.5 %).
const INCREMENT: f64 = 1e-5;
/// First strain increment, over that which would double the pressure at the start if the soil stayed elastic.
const FIRST: f64 = 0.002;
/// Largest strain increment of sheared specimens, over the strain so far.
const GROWTH: f64 = 0.01;
/// Change of the stress in a step of compression, over the stress, that is aimed at.
const STRESS_STEP: f64 = 0.0005;
/// Growth of the strain between two recorded points, at the beginning of tests that shear.
const STRAIN_RECORD: f64 = 0.05;
/// Recorded points of a test that shears, thereafter.
const RECORDS: f64 = 400.0;
/// Growth of the stress between two recorded points of compression.
const STRESS_RECORD: f64 = 1.02;

/// The course of a test.
///
/// # Errors
/// When the soil cannot sustain the stress at the start.
pub fn run(material: &Material, test: &Test) -> Result<Course, Unsustained> {
    let start = start(material, test)?;
    Ok(if test.kind.shears() { shear(start, test) } else { compress(start, test) })
}

fn start(material: &Material, test: &Test) -> Result<Specimen, Unsustained> {
    let k0 = match test.kind {
        TestKind::Triaxial | TestKind::Isotropic => 1.0,
        TestKind::Oedometer | TestKind::Shear => material.k0,
    };
    let lateral = k0 * test.pressure;
    let stress = [-lateral, -lateral, -test.pressure, 0.0, 0.0, 0.0];
    let specimen = Specimen::new(*material, stress, test.density);
    let kept = specimen.strained([0.0; 6]).stress();
    let is_kept = kept.iter().zip(stress).all(|(a, b)| (a - b).abs() <= 1e-9 * test.pressure);
    if is_kept { Ok(specimen) } else { Err(Unsustained { pressure: test.pressure, k0 }) }
}

/// Triaxial compression or simple shear up to the largest strain.
fn shear(mut specimen: Specimen, test: &Test) -> Course {
    let total = match test.kind {
        TestKind::Triaxial => -(-test.largest_strain).ln_1p(),
        _ => test.largest_strain,
    };
    let first = (FIRST * test.pressure / specimen.constrained_modulus()).min(INCREMENT);
    let mut points = vec![path_point(&specimen, test.kind, false)];
    let (mut strain, mut next) = (0.0, 0.0);
    while strain < total {
        let size = (GROWTH * strain).clamp(first, INCREMENT).min(total - strain);
        let Some(strained) = strained(&specimen, test, size) else {
            return Course { points, ending: Ending::Failed };
        };
        specimen = strained;
        strain += size;
        // What is left of the strain may be a rounding error.
        if total - strain < 1e-3 * size {
            strain = total;
        }
        if strain >= next || strain >= total {
            points.push(path_point(&specimen, test.kind, false));
            next = strain + (STRAIN_RECORD * strain).min(total / RECORDS);
        }
    }
    Course { points, ending: Ending::Complete }
}

/// Oedometer or isotropic compression up to the largest pressure, and back.
fn compress(mut specimen: Specimen, test: &Test) -> Course {
    let vertical = |specimen: &Specimen| -specimen.stress()[2];
    let mut size = (FIRST * test.pressure / specimen.constrained_modulus()).min(INCREMENT);
    let mut points = vec![path_point(&specimen, test.kind, false)];
    let (mut recorded, mut unloads) = (test.pressure, false);
    loop {
        let before = vertical(&specimen);
        specimen = match strained(&specimen, test, if unloads { -size } else { size }) {
            Some(strained) => strained,
            None => return Course { points, ending: Ending::Failed },
        };
        let now = vertical(&specimen);
        if now <= 0.0 && !unloads {
            return Course { points, ending: Ending::Failed };
        }
        let is_over = unloads && now <= test.pressure;
        let turns = !unloads && now >= test.largest_pressure;
        let is_crushed = -mean(specimen.strain) * 3.0 > std::f64::consts::LN_2;
        let factor = if unloads { recorded / now } else { now / recorded };
        if is_over || turns || is_crushed || factor >= STRESS_RECORD {
            points.push(path_point(&specimen, test.kind, unloads));
            recorded = now;
        }
        if is_over || is_crushed {
            return Course { points, ending: if is_over { Ending::Complete } else { Ending::Crushed } };
        }
        let change = (now / before - 1.0).abs() / STRESS_STEP;
        size = (size * (1.0 / change).clamp(0.5, 1.5)).min(INCREMENT);
        if turns {
            unloads = true;
            // Unloading is elastic at first.
            size = size.min(STRESS_STEP * now / specimen.constrained_modulus());
        }
    }
}

/// The specimen after a strain increment of a size; `None` where the stress of the test can no longer be
/// held.
fn strained(specimen: &Specimen, test: &Test, size: f64) -> Option<Specimen> {
    let stress = -test.pressure;
    match test.kind {
        TestKind::Triaxial => {
            let lateral = Held { component: 0, stress, direction: [1.0, 1.0, 0.0, 0.0, 0.0, 0.0] };
            specimen.strained_under([0.0, 0.0, -size, 0.0, 0.0, 0.0], &lateral)
        }
        TestKind::Oedometer => Some(specimen.strained([0.0, 0.0, -size, 0.0, 0.0, 0.0])),
        TestKind::Isotropic => {
            let third = -size / 3.0;
            Some(specimen.strained([third, third, third, 0.0, 0.0, 0.0]))
        }
        TestKind::Shear => {
            let vertical = Held { component: 2, stress, direction: [0.0, 0.0, 1.0, 0.0, 0.0, 0.0] };
            specimen.strained_under([0.0, 0.0, 0.0, 0.0, 0.0, 0.5 * size], &vertical)
        }
    }
}

fn path_point(specimen: &Specimen, kind: TestKind, is_unloading: bool) -> PathPoint {
    let stress: Symmetric = specimen.stress();
    let [xx, _, zz, .., xz] = stress;
    let [.., ezz, _, _, exz] = specimen.strain;
    PathPoint {
        strain: if kind == TestKind::Shear { 2.0 * exz } else { 0.0 - ezz },
        volumetric_strain: 0.0 - 3.0 * mean(specimen.strain),
        vertical: -zz,
        lateral: -xx,
        shear: xz.abs(),
        pressure: -mean(stress),
        mises: mises(stress),
        density: specimen.density(),
        is_unloading,
    }
}
