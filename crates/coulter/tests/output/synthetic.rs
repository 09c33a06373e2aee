//! A made-up case: nothing here was simulated. A rut and berms shaped by a formula, histories that look like
//! a tow.

use coulter::case::Case;
use coulter::case::relief::Relief;
use coulter::case::resolved as case;
use coulter::case::shapes::{Block, Disc, Shape};
use coulter::case::slope::Slope;
use coulter::history::{BodySample, EnergySample, History};
use coulter::output::folder::{Outcome, RunStatistics};
use geometry::DiscRim;
use glam::{DQuat, DVec3};
use mechanics::{BodyState, Inertia, MechanismState, Twist};
use solver::fields::{Kinds, PLASTIC_STRAIN};
use solver::grid::Grid;
use solver::state::{Body, Nodes, Pose, Soil, State};

/// Diameter of the disc [m].
pub(crate) const DIAMETER: f64 = 0.2;
const TRAVEL: f64 = 0.5;
const DEPTH: f64 = 0.045;

/// Which made-up case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// One disc, symmetric.
    Disc,
    /// A disc and a block, not symmetric.
    Two,
    /// A column of weightless soil and no body.
    Column,
}

/// Cell faces: fine in the middle, growing outwards.
fn faces(low: f64, high: f64, fine: [f64; 2], cell: f64, growth: f64) -> Vec<f64> {
    let count = ((fine[1] - fine[0]) / cell).round() as usize;
    let mut faces: Vec<f64> = (0..=count).map(|n| fine[0] + cell * n as f64).collect();
    let mut width = cell;
    while faces[faces.len() - 1] < high - 1e-9 {
        width *= growth;
        faces.push((faces[faces.len() - 1] + width).min(high));
    }
    width = cell;
    while faces[0] > low + 1e-9 {
        width *= growth;
        faces.insert(0, (faces[0] - width).max(low));
    }
    faces
}

const OUTPUT: case::Output = case::Output {
    history_interval: 1e-3,
    field_interval: 1.0,
    checkpoint_interval: f64::INFINITY,
    steady_fraction: 0.3,
    filter_cutoff: 10.0,
};

/// The case.
pub(crate) fn case(kind: Kind, cell: f64) -> Case {
    let symmetric = kind == Kind::Disc;
    let (low, high) =
        (DVec3::new(-0.4, if symmetric { 0.0 } else { -0.3 }, -0.35), DVec3::new(1.0, 0.3, 0.12));
    let fine_low = DVec3::new(-0.2, if symmetric { 0.0 } else { -0.12 }, -0.15);
    let fine_high = DVec3::new(0.8, 0.12, 0.08);
    let disc = Disc { diameter: DIAMETER, thickness: 0.04, rim: DiscRim::Square, dish: None };
    let disc = body("disc", Shape::Disc(disc), DVec3::new(0.0, 0.0, 0.1));
    let block = Block { size: DVec3::new(0.03, 0.08, 0.1) };
    let block = body("scraper", Shape::Block(block), DVec3::new(-0.1, 0.0, 0.05));
    Case {
        name: "synthetic_disc".into(),
        title: "Free disc towed over medium dense sand (made-up data)".into(),
        gravity: 9.81,
        slope: Slope::default(),
        water: None,
        soil: sand(if kind == Kind::Column { 0.0 } else { 16e3 }),
        ground: match kind {
            Kind::Column => {
                let (low, high) = (DVec3::new(-0.4, -0.3, -0.35), DVec3::new(0.0, 0.3, 0.0));
                case::Ground::Column { low, high, radius: None }
            }
            _ => case::Ground::Level { surface: 0.0 },
        },
        relief: Relief::default(),
        soil_bodies: Vec::new(),
        overburden: 0.0,
        velocity: DVec3::ZERO,
        domain: case::Domain {
            low,
            high,
            walls: [[case::Wall::Smooth; 2]; 3],
            symmetric,
            symmetric_x: false,
            plane_strain: false,
        },
        grid: case::Grid {
            aspect: DVec3::ONE,
            follow: None,
            cell,
            fine_low,
            fine_high,
            growth: 1.12,
            faces: std::array::from_fn(|a| faces(low[a], high[a], [fine_low[a], fine_high[a]], cell, 1.12)),
        },
        bodies: match kind {
            Kind::Disc => vec![disc],
            Kind::Two => vec![disc, block],
            Kind::Column => vec![],
        },
        joints: Vec::new(),
        layers: Vec::new(),
        stages: Vec::new(),
        tables: Vec::new(),
        remarks: Vec::new(),
        duration: 6.0,
        output: OUTPUT,
        numerics: numerics(),
        forecast: case::Measured::default(),
    }
}

fn sand(unit_weight: f64) -> case::Soil {
    case::Soil {
        law: case::Law::MohrCoulomb(case::MohrCoulomb {
            friction_angle: 0.61,
            dilation_angle: 0.1,
            cohesion: 0.0,
            tension_cutoff: 0.0,
            potential: case::Potential::MohrCoulomb,
            critical_density: None,
        }),
        density: 1631.0,
        unit_weight,
        young_modulus: 2e6,
        poisson_ratio: 0.3,
        k0: 0.43,
    }
}

fn numerics() -> case::Numerics {
    case::Numerics {
        courant: 0.5,
        remap_displacement: 0.1,
        hourglass: 0.03,
        hourglass_yielding: 1.0,
        bulk_viscosity_linear: 0.02,
        bulk_viscosity_quadratic: 1.2,
        contact: case::Contact::Penalty,
        edge_inset: 0.5,
        point_spacing: 0.5,
        threads: 2,
        precision: case::Precision::Double,
    }
}

fn body(name: &str, shape: Shape, position: DVec3) -> case::Body {
    let free = |load| case::Motion::Free { load, support: 0.0, start: 0.0, ramp: 0.1 };
    case::Body {
        name: name.into(),
        shape,
        position,
        attitude: case::Attitude::default(),
        mass: 6.0,
        axle_inertia: 0.03,
        friction: 0.5,
        adhesion_factor: f64::INFINITY,
        translation: [
            case::Motion::Prescribed { before: 0.0, speed: 0.1, start: 0.5, ramp: 0.2, end: f64::INFINITY },
            case::Motion::Fixed,
            free(-60.0),
        ],
        rotation: [case::Motion::Fixed, case::Motion::Fixed, free(0.0)],
        parts: Vec::new(),
        guide: None,
        staged: None,
    }
}

/// Height of the made-up surface [m].
fn height(kind: Kind, x: f64, y: f64) -> f64 {
    if kind == Kind::Column {
        return (0.25 - 0.45 * (x + 0.2)).clamp(0.0, 0.3) - 0.35;
    }
    let end = TRAVEL - 0.02;
    let along = 1.0 / (1.0 + ((x - end) / 0.012).exp()) / (1.0 + (-(x + 0.03) / 0.02).exp());
    let rut = -0.85 * DEPTH * (-(y / 0.026).powi(4)).exp();
    let berm = 0.014 * (-((y.abs() - 0.045) / 0.016).powi(2)).exp();
    let bow = 0.016 * (-((x - end - 0.075) / 0.03).powi(2) - (y / 0.045).powi(2)).exp();
    along * (rut + berm) + bow
}

/// The grid and the state at time `time` [s].
pub(crate) fn state(case: &Case, kind: Kind, time: f64) -> (Grid, State) {
    let grid = Grid::new(case.grid.faces.clone());
    let (mut soil, mut nodes) = (Soil::empty(&grid, 1, Kinds::default()), Nodes::at_rest(&grid));
    let [columns, rows, layers] = grid.cells();
    let toe = DVec3::new(TRAVEL + 0.04, 0.0, -DEPTH);
    for (k, j, i) in triples(layers, rows, columns) {
        let n = grid.index(i, j, k);
        let x = DVec3::new(grid.centre(0, i), grid.centre(1, j), grid.centre(2, k));
        let surface = height(kind, x.x, x.y);
        soil.fraction[n] = ((surface - grid.faces[2][k]) / grid.width(2, k)).clamp(0.0, 1.0);
        soil.mass[n] = 1631.0 * soil.fraction[n] * grid.volume(i, j, k);
        let near = (-(x - toe).length_squared() / 0.005).exp();
        let deep = (surface - x.z).max(0.0);
        let vertical = -16e3 * deep - 2.2e4 * near;
        for (c, ratio) in [0.6, 0.5, 1.0, 0.0, 0.0, 0.25].into_iter().enumerate() {
            soil.stress[c][n] = ratio * vertical;
        }
        let band = ((x.z + DEPTH) - 0.55 * (x.x - TRAVEL)).abs() / 0.012;
        let wake = if x.x < TRAVEL && x.x > -0.05 { (-(x.z + DEPTH).abs() / 0.012).exp() } else { 0.0 };
        let ahead = if x.x > TRAVEL && x.x < TRAVEL + 0.16 { (-band * band).exp() } else { 0.0 };
        let sheared = (0.9 * ahead + 1.4 * wake) * (-(x.y / 0.05).powi(2)).exp();
        // Every history variable differs, so that none can be taken for another.
        for (number, field) in soil.history.iter_mut().enumerate() {
            let share = if number == PLASTIC_STRAIN { 1.0 } else { 1e-3 * (number + 1) as f64 };
            // Sand alone has all of them.
            if let Some(own) = field.get_mut(n) {
                *own = share * sheared;
            }
        }
    }
    for (k, j, i) in triples(layers + 1, rows + 1, columns + 1) {
        let n = grid.index(i, j, k);
        let x = DVec3::new(grid.faces[0][i], grid.faces[1][j], grid.faces[2][k]);
        let near = (-(x - toe).length_squared() / 0.004).exp();
        nodes.mass[n] = 1.0;
        nodes.velocity[0][n] = 0.1 * near;
        nodes.velocity[2][n] = 0.05 * near;
    }
    let bodies = case.bodies.iter().map(towed).collect();
    let mechanism = MechanismState { bodies: case.bodies.iter().map(moved).collect(), joints: vec![] };
    (
        grid,
        State {
            grid_position: DVec3::ZERO,
            time,
            step: 5000,
            soil,
            nodes,
            bodies,
            mechanism,
            contacts: vec![],
            energy_balance: Default::default(),
            remaps: 0,
        },
    )
}

/// What the soil has done to a body at the end of its tow.
fn towed(body: &case::Body) -> Body {
    Body {
        rotation: 0.85 * TRAVEL / (0.5 * DIAMETER),
        leaked_volume: 6e-9,
        embedded_volume: 5e-6,
        searched_at: Pose::at(body.position),
        ..Body::default()
    }
}

/// Pose and velocity of a body at the end of its tow.
fn moved(body: &case::Body) -> BodyState {
    let pose = Pose {
        position: body.position + DVec3::new(TRAVEL, 0.0, -DEPTH),
        rotation: DQuat::from_rotation_y(0.85 * TRAVEL / (0.5 * DIAMETER)),
    };
    let twist = Twist { linear: DVec3::new(0.1, 0.0, 0.0), angular: DVec3::new(0.0, 0.85, 0.0) };
    mechanics::Body::free(Inertia::principal(6.0, DVec3::splat(0.03))).state(pose, twist)
}

fn triples(layers: usize, rows: usize, columns: usize) -> impl Iterator<Item = (usize, usize, usize)> {
    (0..layers).flat_map(move |k| (0..rows).flat_map(move |j| (0..columns).map(move |i| (k, j, i))))
}

/// A history of `count` samples.
pub(crate) fn history(case: &Case, count: usize) -> History {
    let mut energy = Vec::new();
    let bodies = case.bodies.iter().map(|_| samples(count)).collect();
    for n in 0..count.max(2) / 2 {
        let time = 6.0 * n as f64 / (count.max(2) as f64 / 2.0);
        let work = 4.0 * time.powf(1.3);
        energy.push(EnergySample {
            time,
            external: work,
            kinetic: 0.01 * work.min(1.0),
            elastic: 0.08 * work.min(3.0),
            plastic: 0.72 * work,
            friction: 0.18 * work,
            contact: 0.01 * work,
            viscous: 0.02 * work,
            hourglass: 0.015 * work,
            seepage: 0.0,
            remap_loss: 0.01 * work,
            volume_ratio: 1.0 + 2e-4 * time / 6.0,
            compression: 0.0,
            overdense: 0.0,
            void: 0.0,
        });
    }
    History {
        names: case.bodies.iter().map(|b| b.name.clone()).collect(),
        bodies,
        energy,
        ..History::default()
    }
}

fn samples(count: usize) -> Vec<BodySample> {
    let mut noise = 1u64;
    (0..count)
        .map(|n| {
            // A plain congruential generator: the same noise every time.
            noise = noise.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let random = (noise >> 33) as f64 / f64::from(1u32 << 31) - 0.5;
            let time = 6.0 * n as f64 / count as f64;
            let moved = (time - 0.5).clamp(0.0, 5.0) * 0.1;
            let rise = 1.0 - (-moved / 0.06).exp();
            let sinkage = 0.012 * (time / 0.5).min(1.0) + (DEPTH - 0.012) * rise;
            let drag = 38.0 * rise * (1.0 + 0.05 * (moved * 90.0).sin()) + 4.0 * random * rise;
            let vertical = 60.0 * (time / 0.5).min(1.0) + 5.0 * random;
            let speed = if time > 0.5 { 0.1 } else { 0.0 };
            BodySample {
                time,
                displacement: moved,
                sinkage,
                drag,
                vertical,
                drag_normal: 0.7 * drag,
                vertical_normal: 0.9 * vertical,
                axle_torque: 0.4 * (-moved / 0.03).exp() + 0.2 * random,
                rotation: 0.85 * moved / 0.1,
                spin: 0.85 * rise * speed / 0.1,
                speed,
                rolling_speed: speed,
                leaked_volume: 1e-9 * time,
                embedded_volume: 1e-4 * sinkage,
                ..Default::default()
            }
        })
        .collect()
}

/// Statistics of a run that went well.
pub(crate) fn statistics() -> RunStatistics {
    RunStatistics {
        steps: 48_213,
        wall_seconds: 1734.2,
        threads: 8,
        outcome: Outcome::Finished,
        stages: Vec::new(),
        exchange: Default::default(),
        advice: vec![
            "Run once more with grid.cell = \"3 mm\" to see how much the drag depends on the grid.".into(),
        ],
    }
}
