//! What was measured, and what the solver gave: forces and sinkages beside which the closed forms are scored.

use analytic::disc::{Disc, Drive};
use analytic::forecast::{Block, Body, Outline, Plate};
use analytic::{Load, Soil, Towing};

/// A class of rows that are scored together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Class {
    Plate,
    PressedWheel,
    RollingWheel,
    SlidingWheel,
    SolverPressed,
    SolverTowed,
    SolverFootings,
    SolverWalls,
}

impl Class {
    pub(crate) const ALL: [Self; 8] = [
        Self::Plate,
        Self::PressedWheel,
        Self::RollingWheel,
        Self::SlidingWheel,
        Self::SolverPressed,
        Self::SolverTowed,
        Self::SolverFootings,
        Self::SolverWalls,
    ];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Plate => "measured: plate Ø 80 mm, pressed 5 to 25 mm",
            Self::PressedWheel => "measured: wheel, pressed 5 to 40 mm, not turning",
            Self::RollingWheel => "measured: wheel under tow, rolling or driven, s = 0, 0.23, 0.75",
            Self::SlidingWheel => "measured: wheel under tow, sliding, s = −1, −0.5",
            Self::SolverPressed => "solver, ψ = 0: plate and wheel, pressed",
            Self::SolverTowed => "solver, ψ = 0: discs and wheel under tow",
            Self::SolverFootings => "solver, ψ = 0: rough strip footings (B4)",
            Self::SolverWalls => "solver, ψ ≤ 5°: smooth passive walls (B5), a blade",
        }
    }

    pub(crate) fn is_measured(self) -> bool {
        matches!(self, Self::Plate | Self::PressedWheel) || self.is_towed_wheel()
    }

    /// Whether friction on the rim, which was not measured, matters to it.
    pub(crate) fn is_towed_wheel(self) -> bool {
        matches!(self, Self::RollingWheel | Self::SlidingWheel)
    }
}

/// One row: a case, and what was found.
pub(crate) struct Row {
    pub(crate) class: Class,
    pub(crate) label: String,
    /// The case; its soil is that of the row, but for the friction angle of the measured ones.
    pub(crate) case: Towing,
    /// Drag [N].
    pub(crate) drag: Option<f64>,
    /// Vertical force [N], where the sinkage is held.
    pub(crate) vertical: Option<f64>,
    /// Sinkage [m], where it is free.
    pub(crate) sinkage: Option<f64>,
}

/// Sand with ψ = 0.
pub(crate) fn sand(degrees: f64, unit_weight: f64, friction: f64) -> Soil {
    Soil {
        friction_angle: degrees.to_radians(),
        dilation_angle: 0.0,
        cohesion: 0.0,
        unit_weight,
        body_friction: friction,
        adhesion_factor: 1.0,
        strength_gradient: 0.0,
    }
}

/// Friction of the smooth rim, which was not measured: what is usual for a smooth surface on dry sand.
pub(crate) const FRICTIONS: [f64; 3] = [0.3, 0.4, 0.5];

/// The sand of the wheel test bed: γ = 13.03 kN/m³, and the middle of the range of friction.
pub(crate) fn measured_sand(degrees: f64) -> Soil {
    sand(degrees, 13_030.0, FRICTIONS[1])
}

const PLATE: Plate = Plate { outline: Outline::Circle, width: 0.08, length: 0.08, height: 0.05 };
const WHEEL: Disc = Disc { diameter: 0.116, thickness: 0.05 };
const SHIPPED: Disc = Disc { diameter: 0.2, thickness: 0.05 };

/// Force [N] on the plate at a sinkage [mm]; medians of two or three repeats.
pub(crate) const PLATE_CURVE: [(f64, f64); 5] =
    [(5.0, 22.1), (10.0, 51.4), (15.0, 87.9), (20.0, 134.7), (25.0, 192.8)];
/// The same of the wheel.
const WHEEL_CURVE: [(f64, f64); 8] = [
    (5.0, 4.7),
    (10.0, 19.1),
    (15.0, 37.5),
    (20.0, 67.1),
    (25.0, 99.3),
    (30.0, 142.7),
    (35.0, 195.4),
    (40.0, 246.8),
];
/// Slip, drag [N], vertical force [N] and sinkage [mm] of the wheel under tow; means of three repeats.
const WHEEL_ROWS: [[f64; 4]; 5] = [
    [-1.0, 38.84, 19.50, 50.31],
    [-0.5, 17.15, 23.24, 23.66],
    [0.0, 1.34, 24.58, 14.43],
    [0.23, -0.70, 24.62, 17.88],
    [0.75, -0.82, 24.00, 25.44],
];
/// What the solver gave for the same plate and wheel at φ = 32°, ψ = 0 (8 cells over the width of the wheel).
const SOLVER_PLATE: [(f64, f64); 5] =
    [(5.0, 73.0), (10.0, 100.0), (15.0, 117.0), (20.0, 130.0), (25.0, 147.0)];
const SOLVER_WHEEL: [(f64, f64); 4] = [(5.0, 21.0), (10.0, 41.0), (20.0, 74.0), (30.0, 118.0)];

/// Friction angle [deg] and N_γ of rough strip footings with ψ = 0 (B4).
const STRIPS: [(f64, f64); 4] = [(20.0, 3.239), (25.0, 6.733), (30.0, 13.39), (35.0, 23.98)];
/// Friction angle [deg] and K_p of smooth walls with ψ = 0, heave included (B5).
const WALLS: [(f64, f64); 3] = [(30.0, 2.878), (35.0, 3.342), (40.0, 3.625)];

/// Every row; the friction angle of the measured sand is 29°, its angle of repose.
pub(crate) fn rows() -> Vec<Row> {
    let measured = measured_sand(29.0);
    let solver = measured_sand(32.0);
    let mut rows = Vec::new();
    rows.extend(PLATE_CURVE.map(|point| pressed(Class::Plate, measured, PLATE, point)));
    rows.extend(WHEEL_CURVE.map(|point| pressed(Class::PressedWheel, measured, WHEEL, point)));
    rows.extend(WHEEL_ROWS.map(|[slip, drag, weight, z]| {
        let case = Towing::new(measured, WHEEL, Load::Weight(weight), Drive::Slip(slip));
        let class = if slip < 0.0 { Class::SlidingWheel } else { Class::RollingWheel };
        sinking(class, format!("s = {slip}"), case, (drag, z))
    }));
    rows.extend(SOLVER_PLATE.map(|point| pressed(Class::SolverPressed, solver, PLATE, point)));
    rows.extend(SOLVER_WHEEL.map(|point| pressed(Class::SolverPressed, solver, WHEEL, point)));
    let disc = |label: &str, weight: f64, found| {
        let case = Towing::new(sand(35.0, 16e3, 0.3), SHIPPED, Load::Weight(weight), Drive::Free);
        sinking(Class::SolverTowed, label.to_owned(), case, found)
    };
    // The finest mesh of D11; cases/towed_disc_mohr_coulomb.toml.
    rows.push(disc("light disc, free", 40.0, (15.40, 16.93)));
    rows.push(disc("towed disc, free", 100.0, (50.8, 41.0)));
    let wheel =
        |label: &str, load: Load, drive: Drive| (label.to_owned(), Towing::new(solver, WHEEL, load, drive));
    for ((label, case), found) in [
        (wheel("wheel, locked", Load::Weight(19.5), Drive::Locked), (17.5, 34.5)),
        (wheel("wheel, s = 0", Load::Weight(24.58), Drive::Slip(0.0)), (6.5, 17.5)),
        (wheel("wheel, free", Load::Weight(24.0), Drive::Free), (14.0, 26.0)),
    ] {
        rows.push(sinking(Class::SolverTowed, label, case, found));
    }
    for ((label, case), (drag, vertical)) in [
        (wheel("wheel, locked, held", Load::Sinkage(0.0503), Drive::Locked), (29.1, 28.7)),
        (wheel("wheel, s = 0, held", Load::Sinkage(0.0144), Drive::Slip(0.0)), (5.2, 20.8)),
    ] {
        let (drag, vertical) = (Some(drag), Some(vertical));
        rows.push(Row { class: Class::SolverTowed, label, case, drag, vertical, sinkage: None });
    }
    rows.extend(STRIPS.map(|(degrees, factor)| strip(degrees, factor)));
    rows.extend(WALLS.map(|(degrees, coefficient)| wall(degrees, coefficient)));
    rows.push(blade());
    rows
}

/// A rough strip footing at the surface, 1 m wide, whose load is ½ γ B² N_γ per metre.
fn strip(degrees: f64, factor: f64) -> Row {
    let plate = Plate { outline: Outline::Strip, width: 1.0, length: 1.0, height: 1.0 };
    let soil = sand(degrees, 16e3, 1.0);
    pressed(Class::SolverFootings, soil, plate, (1e-6, 0.5 * 16e3 * factor))
}

/// A block towed through sand, held at the sinkage z [m], whose drag [N] the solver gave.
fn block(label: String, soil: Soil, block: Block, z: f64, drag: f64) -> Row {
    let case = Towing::new(soil, block, Load::Sinkage(z), Drive::Locked);
    Row { class: Class::SolverWalls, label, case, drag: Some(drag), vertical: None, sinkage: None }
}

/// A smooth wall, 1 m high, whose thrust is ½ γ H² K_p per metre.
fn wall(degrees: f64, coefficient: f64) -> Row {
    let wall = Block { size: [0.5, 1.0, 1.0], orientation: 0.0, plane_strain: true, has_base: false };
    block(format!("wall, φ = {degrees}°"), sand(degrees, 16e3, 0.0), wall, 1.0, 0.5 * 16e3 * coefficient)
}

/// The blade of docs/models/block.md: the thrust on its front over 5 to 15 mm of tow, on the finer grid.
fn blade() -> Row {
    let blade = Block { size: [0.06, 0.3, 0.25], orientation: 0.0, plane_strain: false, has_base: true };
    let soil = Soil { dilation_angle: 5_f64.to_radians(), ..sand(35.0, 16e3, 0.4) };
    block("blade".into(), soil, blade, 0.1, 212.0)
}

fn pressed(class: Class, soil: Soil, body: impl Into<Body>, (z, force): (f64, f64)) -> Row {
    let mut case = Towing::new(soil, body, Load::Sinkage(1e-3 * z), Drive::Locked);
    case.pressed = true;
    let what = if matches!(case.body, Body::Plate(_)) { "plate" } else { "wheel" };
    let label = format!("{what}, z = {z} mm");
    Row { class, label, case, drag: None, vertical: Some(force), sinkage: None }
}

fn sinking(class: Class, label: String, case: Towing, (drag, z): (f64, f64)) -> Row {
    Row { class, label, case, drag: Some(drag), vertical: None, sinkage: Some(1e-3 * z) }
}
