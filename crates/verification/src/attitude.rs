//! D8: a disc with a yaw and a tilt, towed at a fixed depth; its mirror image, and the whole set-up turned by
//! 90°.

use crate::error::VerifyError;
use crate::probe::mean;
use crate::runner::Runner;
use analytic::forecast::Candidate;
use coulter::case::Case;
use coulter::case::tow::TowDirection;
use coulter::forecast::outlook;
use coulter::history::BodySample;
use coulter::history::reference::Reference;
use coulter::simulation::Simulation;
use glam::DVec3;

const CASE: &str = include_str!("../validation/D8_yaw_and_tilt/case.toml");
/// Yaw and tilt [°].
const YAWS: [f64; 5] = [0.0, 10.0, 20.0, 30.0, 45.0];
const TILTS: [f64; 2] = [0.0, 15.0];
/// Attitudes whose first steps are compared with those of their mirror image, and of the set-up turned by
/// 90° [°].
const MIRRORED: [[f64; 2]; 3] = [[20.0, 0.0], [0.0, 15.0], [45.0, 15.0]];
const TURNED: [[f64; 2]; 2] = [[0.0, 0.0], [20.0, 15.0]];
/// The attitude of the whole tow that is turned [°].
const TOWED: [f64; 2] = [20.0, 15.0];
/// Steps that are compared one by one.
const STEPS: usize = 100;
/// The steady part: the last so much of the time.
const STEADY: f64 = 0.3;
/// Radius of the disc in the case file, the lever of its moments [m].
const RADIUS: f64 = 0.1;

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for [yaw, tilt] in MIRRORED {
        let variant = format!("{}, mirrored, {STEPS} steps", name([yaw, tilt]));
        compare(runner, &variant, [attitude([yaw, tilt]), attitude([-yaw, -tilt])], mirrored)?;
    }
    for angles in TURNED {
        let variant = format!("{}, turned by 90°, {STEPS} steps", name(angles));
        compare(runner, &variant, [attitude(angles), turned_attitude(angles)], turned_back)?;
    }
    let mut kept = None;
    for tilt in TILTS {
        for yaw in YAWS {
            let load = tow(runner, [yaw, tilt])?;
            if [yaw, tilt] == TOWED {
                kept = load;
            }
        }
    }
    kept.map_or(Ok(()), |load| tow_turned(runner, load))
}

fn name([yaw, tilt]: [f64; 2]) -> String {
    format!("yaw {yaw}°, tilt {tilt}°")
}

fn attitude([yaw, tilt]: [f64; 2]) -> Vec<String> {
    vec![format!("body.disc.yaw={yaw} deg"), format!("body.disc.tilt={tilt} deg")]
}

/// Overrides of the case with everything turned by 90° about z: the disc, its tow (after this ramp), the box
/// and the fine cells in it.
fn turned([yaw, tilt]: [f64; 2], ramp: &str) -> Vec<String> {
    let mut sets = attitude([yaw + 90.0, tilt]);
    let whole = [
        "domain.x=['-0.32 m', '0.32 m']",
        "domain.y=['-0.3 m', '0.42 m']",
        "grid.fine_x=['-0.15 m', '0.15 m']",
        "grid.fine_y=['-0.1625 m', '0.2 m']",
        "grid.follow.axes=y",
        "body.disc.forward=fixed",
    ];
    sets.extend(whole.map(str::to_owned));
    sets.push(format!("body.disc.lateral={{ speed = '0.2 m/s', ramp = '{ramp}' }}"));
    sets
}

fn turned_attitude(angles: [f64; 2]) -> Vec<String> {
    turned(angles, "0 s")
}

/// Force and moment of the soil on the disc [N, N m].
#[derive(Clone, Copy, Debug)]
struct Load {
    force: DVec3,
    moment: DVec3,
}

impl Load {
    fn of(sample: &BodySample, tow: TowDirection) -> Self {
        Self {
            force: tow.in_space(DVec3::new(-sample.drag, sample.lateral, sample.vertical)),
            moment: DVec3::new(sample.moment_x, sample.moment_y, sample.moment_z),
        }
    }

    /// Mean over the steady part of a run.
    fn steady(simulation: &Simulation) -> Self {
        let tow = TowDirection::of(&simulation.case, &simulation.case.bodies[0]);
        let over = |value: &dyn Fn(&Self) -> f64| steady(simulation, |sample| value(&Self::of(sample, tow)));
        let vector = |of: fn(&Self) -> DVec3| DVec3::from_array([0, 1, 2].map(|n| over(&|load| of(load)[n])));
        Self { force: vector(|load| load.force), moment: vector(|load| load.moment) }
    }
}

/// Mean of a figure over the steady part of a run.
fn steady(simulation: &Simulation, value: impl Fn(&BodySample) -> f64) -> f64 {
    let duration = simulation.case.duration;
    let range = [(1.0 - STEADY) * duration, f64::INFINITY];
    mean(&simulation.history.bodies[0], range, |sample| sample.time, value)
}

/// The load on the original, from that on its mirror image in y.
fn mirrored(load: &Load) -> Load {
    let Load { force: f, moment: m } = *load;
    Load { force: DVec3::new(f.x, -f.y, f.z), moment: DVec3::new(-m.x, m.y, -m.z) }
}

/// The load on the original, from that on what was turned by 90°.
fn turned_back(load: &Load) -> Load {
    let back = |v: DVec3| DVec3::new(v.y, -v.x, v.z);
    Load { force: back(load.force), moment: back(load.moment) }
}

/// The first steps of two runs, at full speed from the first, with a remap for each hundredth of a cell, so
/// that there are some in every order of the sweeps. `back` changes a load of the second run to what it would
/// be in the first.
fn compare(
    runner: &mut Runner,
    variant: &str,
    runs: [Vec<String>; 2],
    back: fn(&Load) -> Load,
) -> Result<(), VerifyError> {
    if !runner.wants("D8", variant)? {
        return Ok(());
    }
    let [(one, first), (other, second)] = [first_steps(runner, &runs[0])?, first_steps(runner, &runs[1])?];
    let scale = one.iter().map(|load| load.force.z.abs()).fold(0.0, f64::max);
    let apart = |of: fn(&Load) -> f64| {
        let pairs = one.iter().zip(&other);
        pairs.map(|(a, b)| (of(a) - of(&back(b))).abs() / scale).fold(0.0, larger)
    };
    let figures = [
        ("deviation of the drag over F_V", apart(|load| load.force.x)),
        ("deviation of the vertical force over F_V", apart(|load| load.force.z)),
        ("deviation of the lateral force over F_V", apart(|load| load.force.y)),
        ("deviation of the moment about x over F_V d/2", apart(|load| load.moment.x) / RADIUS),
        ("deviation of the moment about y over F_V d/2", apart(|load| load.moment.y) / RADIUS),
        ("deviation of the moment about z over F_V d/2", apart(|load| load.moment.z) / RADIUS),
    ];
    runner.put("D8", variant, first + second, &figures)
}

/// The larger of two; not a number if one of them is not.
fn larger(most: f64, value: f64) -> f64 {
    if value > most || value.is_nan() { value } else { most }
}

/// Loads on the disc after each of the first steps, and the seconds that they took.
fn first_steps(runner: &Runner, sets: &[String]) -> Result<(Vec<Load>, f64), VerifyError> {
    let all = [
        "body.disc.forward={ speed = '0.2 m/s', ramp = '0 s' }",
        "numerics.remap_displacement=0.01",
        "output.history_interval=1e-6 s",
    ];
    let sets: Vec<String> = all.iter().map(|set| (*set).to_owned()).chain(sets.iter().cloned()).collect();
    let mut simulation = runner.simulation(CASE, &sets)?;
    for _ in 0..runner.lasting(STEPS) {
        simulation.advance()?;
    }
    let tow = TowDirection::of(&simulation.case, &simulation.case.bodies[0]);
    let loads = simulation.history.bodies[0].iter().skip(1).map(|sample| Load::of(sample, tow)).collect();
    Ok((loads, simulation.wall_s))
}

/// Tows the disc: means over the steady part, beside 3D-RFT; the mean load.
fn tow(runner: &mut Runner, angles: [f64; 2]) -> Result<Option<Load>, VerifyError> {
    let variant = name(angles);
    if !runner.wants("D8", &variant)? {
        return Ok(None);
    }
    let simulation = runner.run("D8", &variant, CASE, &attitude(angles))?;
    let load = Load::steady(&simulation);
    let reference = &Reference::all(&simulation.case)[0];
    let ratio = steady(&simulation, |sample| sample.turn_ratio(reference).unwrap_or(f64::NAN));
    let forecast = forecast(&simulation.case);
    let expected = |of: fn(&Load) -> f64| forecast.as_ref().map_or(f64::NAN, |(load, _)| of(load));
    let figures = [
        ("drag F_H [N]", -load.force.x),
        ("drag, 3D-RFT [N]", expected(|load| -load.force.x)),
        ("vertical force F_V [N]", load.force.z),
        ("vertical force, 3D-RFT [N]", expected(|load| load.force.z)),
        ("lateral force [N]", load.force.y),
        ("lateral force, 3D-RFT [N]", expected(|load| load.force.y)),
        ("moment about x [N m]", load.moment.x),
        ("moment about x, 3D-RFT [N m]", expected(|load| load.moment.x)),
        ("moment about y [N m]", load.moment.y),
        ("moment about y, 3D-RFT [N m]", expected(|load| load.moment.y)),
        ("moment about z [N m]", load.moment.z),
        ("moment about z, 3D-RFT [N m]", expected(|load| load.moment.z)),
        ("turn ratio ω r / v", ratio),
        ("turn ratio, 3D-RFT", forecast.map_or(f64::NAN, |(_, ratio)| ratio)),
    ];
    runner.put("D8", &variant, simulation.wall_s, &figures)?;
    Ok(Some(load))
}

/// What 3D-RFT says of a case: load and turn ratio. Where it gives no lateral force and no moments, of an
/// upright disc along the tow, they vanish: by symmetry, and because the axle is free.
fn forecast(case: &Case) -> Option<(Load, f64)> {
    let outlook = outlook(case).ok()?;
    let model = outlook.forecast.models.iter().find(|m| m.model == Candidate::SpatialResistive)?;
    let found = model.prediction?;
    let force = DVec3::new(-found.drag, found.lateral.unwrap_or(0.0), found.vertical);
    let moment = DVec3::from_array(outlook.moment(model).unwrap_or([0.0; 3]));
    Some((Load { force, moment }, analytic::turn_ratio(found.slip?)))
}

/// The tow with everything turned by 90°, beside the steady load of the original.
fn tow_turned(runner: &mut Runner, original: Load) -> Result<(), VerifyError> {
    let variant = format!("{}, turned by 90°", name(TOWED));
    if !runner.wants("D8", &variant)? {
        return Ok(());
    }
    let simulation = runner.run("D8", &variant, CASE, &turned(TOWED, "0.1 s"))?;
    let load = turned_back(&Load::steady(&simulation));
    let force = (load.force - original.force).length() / original.force.length();
    let moment = (load.moment - original.moment).length() / (RADIUS * original.force.length());
    let figures = [
        ("deviation of the mean force from the original", force),
        ("deviation of the mean moment from the original, over F d/2", moment),
    ];
    runner.put("D8", &variant, simulation.wall_s, &figures)
}
