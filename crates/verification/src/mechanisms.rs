//! A6, second part: exact motions of rigid bodies and joints, without soil.

use crate::error::VerifyError;
use crate::runner::Runner;
use glam::{DQuat, DVec3};
use mechanics::joint::{Ball, Hinge, Joint};
use mechanics::{Body, Conditions, Inertia, Mechanism, MechanismState, Pose, Step, Twist};
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;
use std::time::Instant;

const GRAVITY: DVec3 = DVec3::new(0.0, 0.0, -9.81);
const STEPS: usize = 10_000;
const ENERGY: &str = "largest error of the energy";
const MOMENTUM: &str = "largest error of the angular momentum";

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    type Motion = fn() -> Figures;
    let motions: [(&str, Motion); 5] = [
        ("asymmetric top, 25 revolutions", asymmetric_top),
        ("gyroscope, 33 revolutions", gyroscope),
        ("pendulum, 20 swings of ±86°", pendulum),
        ("double pendulum, 20 swings", double_pendulum),
        ("sphere rolls down 23°, 20 revolutions", sphere),
    ];
    for (variant, motion) in motions {
        if !runner.wants("A6", variant)? {
            continue;
        }
        let clock = Instant::now();
        let figures = motion();
        runner.put("A6", variant, clock.elapsed().as_secs_f64(), &figures)?;
    }
    Ok(())
}

type Figures = Vec<(&'static str, f64)>;

/// A mechanism in motion. It is free of mistakes that [`Mechanism::check`] would find.
struct Motion {
    mechanism: Mechanism,
    state: MechanismState,
    step: Step,
    dt: f64,
    gravity: DVec3,
}

impl Motion {
    fn new(bodies: Vec<Body>, joints: Vec<Arc<dyn Joint>>, starts: &[(Pose, Twist)], dt: f64) -> Self {
        let mechanism = Mechanism::unchecked(bodies, joints);
        let state = mechanism.state(starts);
        Self { mechanism, state, step: Step::default(), dt, gravity: GRAVITY }
    }

    /// Takes a step; `contact` acts within it.
    fn advance(&mut self, number: usize, contact: impl FnOnce(&mut Step)) {
        let conditions = Conditions { time: number as f64 * self.dt, dt: self.dt, gravity: self.gravity };
        self.mechanism.predict(&self.state, &conditions, &mut self.step);
        contact(&mut self.step);
        self.mechanism.advance(&mut self.state, &mut self.step);
    }

    fn energy(&self) -> f64 {
        self.mechanism.kinetic_energy(&self.state)
            + self.mechanism.potential_energy(&self.state, self.gravity)
    }

    fn angular_momentum(&self) -> DVec3 {
        self.mechanism.angular_momentum(&self.state, DVec3::ZERO)
    }

    /// Largest error of the energy over [`STEPS`] steps, relative to `scale` [J]; `observe` sees every state.
    fn run(&mut self, scale: f64, mut observe: impl FnMut(f64, &Self)) -> f64 {
        let start = self.energy();
        let mut worst = 0.0;
        for n in 0..STEPS {
            self.advance(n, |_| {});
            worst = larger(worst, (self.energy() - start) / scale);
            observe((n + 1) as f64 * self.dt, self);
        }
        worst
    }
}

/// The larger magnitude; what is not a number stays one.
fn larger(worst: f64, error: f64) -> f64 {
    if error.abs() > worst || error.is_nan() { error.abs() } else { worst }
}

/// A body with three different moments of inertia, thrown near its middle axis, about which the motion is
/// unstable.
fn asymmetric_top() -> Figures {
    let rotation = DQuat::from_rotation_z(0.4) * DQuat::from_rotation_x(-1.1);
    let angular = DVec3::new(0.1, 1.0, 0.1);
    let start = (
        Pose { position: DVec3::ZERO, rotation },
        Twist { linear: DVec3::ZERO, angular: rotation * angular },
    );
    let body = Body::free(Inertia::principal(1.0, DVec3::new(1.0, 2.0, 2.5)));
    let mut motion = Motion::new(vec![body], vec![], &[start], TAU / angular.length() / 400.0);
    motion.gravity = DVec3::ZERO;
    let (scale, momentum) = (motion.energy(), motion.angular_momentum());
    let mut worst = 0.0;
    let energy = motion.run(scale, |_, now| {
        worst = larger(worst, (now.angular_momentum() - momentum).length() / momentum.length());
    });
    vec![(ENERGY, energy), (MOMENTUM, worst)]
}

/// A heavy symmetric top, its tip on a ball joint, in steady precession: I₃ ω₃ φ̇ − I₁ φ̇² cos θ = m g s,
/// with I₁ about the tip.
fn gyroscope() -> Figures {
    let (mass, arm, along, across) = (2.0, 0.15, 0.01, 0.006);
    let (tilt, precession): (f64, f64) = (0.7, 4.0);
    let transverse = across + mass * arm * arm;
    let spin = (mass * 9.81 * arm + transverse * precession.powi(2) * tilt.cos()) / (along * precession);
    let rotation = DQuat::from_rotation_x(tilt);
    let axis = rotation * DVec3::Z;
    let angular = precession * (DVec3::Z - tilt.cos() * axis) + spin * axis;
    let pose = Pose { position: arm * axis, rotation };
    let joint = Ball::at(DVec3::ZERO, [Some(0), None], [&pose, &Pose::IDENTITY]);
    let body = Body::free(Inertia::principal(mass, DVec3::new(across, across, along)));
    let start = (pose, Twist { linear: angular.cross(arm * axis), angular });
    let mut motion = Motion::new(vec![body], vec![Arc::new(joint)], &[start], TAU / spin / 300.0);
    let (scale, vertical) = (motion.energy(), motion.angular_momentum().z);
    let (mut worst, mut turned, mut last) = (0.0, 0.0, axis);
    let energy = motion.run(scale, |_, now| {
        worst = larger(worst, now.angular_momentum().z / vertical - 1.0);
        let axis = now.state.bodies[0].pose.rotation * DVec3::Z;
        turned += last.truncate().angle_to(axis.truncate());
        last = axis;
    });
    let rate = turned / (STEPS as f64 * motion.dt);
    vec![(ENERGY, energy), (MOMENTUM, worst), ("rate of precession over the exact value", rate / precession)]
}

const ROD: f64 = 0.8;

/// Rods on hinges along y, each released at an angle from the vertical; with `swing` [s] in 500 steps.
fn chain(angles: &[f64], swing: f64) -> Motion {
    let inertia = Inertia::cuboid(1.5, DVec3::new(0.05, 0.03, ROD));
    let mut hinge = DVec3::ZERO;
    let (mut starts, mut joints) = (Vec::<(Pose, Twist)>::new(), Vec::<Arc<dyn Joint>>::new());
    for (n, angle) in angles.iter().enumerate() {
        let rotation = DQuat::from_rotation_y(*angle);
        let half = rotation * DVec3::new(0.0, 0.0, -0.5 * ROD);
        let pose = Pose { position: hinge + half, rotation };
        let above = starts.last().map_or(Pose::IDENTITY, |start| start.0);
        joints.push(Arc::new(Hinge::at(hinge, DVec3::Y, [n.checked_sub(1), Some(n)], [&above, &pose])));
        starts.push((pose, Twist::ZERO));
        hinge += 2.0 * half;
    }
    Motion::new(vec![Body::free(inertia); angles.len()], joints, &starts, swing / 500.0)
}

/// Period of a rod on a hinge that is released at an angle [s]: 4 √(J/(m g s)) K(sin(θ/2)).
fn swing(angle: f64) -> f64 {
    let inertia = Inertia::cuboid(1.5, DVec3::new(0.05, 0.03, ROD));
    let (arm, mass) = (0.5 * ROD, inertia.mass);
    let about_hinge = inertia.tensor.y_axis.y + mass * arm * arm;
    // The complete elliptic integral by the arithmetic–geometric mean (Abramowitz & Stegun 17.6.3).
    let (mut a, mut b) = (1.0, (0.5 * angle).cos());
    while (a - b).abs() > 1e-15 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    4.0 * (about_hinge / (mass * 9.81 * arm)).sqrt() * FRAC_PI_2 / a
}

fn pendulum() -> Figures {
    let exact = swing(1.5);
    let mut motion = chain(&[1.5], exact);
    let depth = motion.energy() + 1.5 * 9.81 * 0.5 * ROD;
    let mut crossings = Vec::new();
    let mut before = (0.0, 1.0);
    let energy = motion.run(depth, |time, now| {
        let x = now.state.bodies[0].pose.position.x;
        if before.1 < 0.0 && x >= 0.0 {
            crossings.push(before.0 + (time - before.0) * before.1 / (before.1 - x));
        }
        before = (time, x);
    });
    let period = (crossings[crossings.len() - 1] - crossings[0]) / (crossings.len() - 1) as f64;
    vec![(ENERGY, energy), ("period over the exact value", period / exact)]
}

/// Two rods, released so high that their motion is chaotic: only the energy is known.
fn double_pendulum() -> Figures {
    let mut motion = chain(&[2.0, 2.5], swing(1.5));
    let depth = motion.energy() + 1.5 * 9.81 * 2.0 * ROD;
    vec![(ENERGY, motion.run(depth, |_, _| {}))]
}

/// A sphere that rolls down a plane on which friction lets it: a = 5/7 g sin θ.
fn sphere() -> Figures {
    const SLOPE: f64 = 0.4;
    let radius = 0.2;
    let normal = DVec3::new(SLOPE.sin(), 0.0, SLOPE.cos());
    let down = DVec3::new(SLOPE.cos(), 0.0, -SLOPE.sin());
    let start = (Pose::at(radius * normal), Twist::ZERO);
    let exact = 5.0 / 7.0 * 9.81 * SLOPE.sin();
    let duration = (2.0 * 20.0 * TAU * radius / exact).sqrt();
    let body = Body::free(Inertia::sphere(3.0, radius));
    let mut motion = Motion::new(vec![body], vec![], &[start], duration / STEPS as f64);
    let (first, mut energy, mut works) = (motion.energy(), 0.0, 0.0);
    for n in 0..STEPS {
        let gap = motion.state.bodies[0].pose.position.dot(normal) - radius;
        motion.advance(n, |step| roll(step, radius, normal, gap));
        works += motion.step.work(0).contact;
        let scale = motion.mechanism.kinetic_energy(&motion.state);
        energy = larger(energy, (motion.energy() - works - first) / scale.max(1e-3));
    }
    let acceleration = motion.state.bodies[0].twist.linear.dot(down) / duration / exact;
    vec![(ENERGY, energy), ("acceleration over the exact value", acceleration)]
}

/// Contact at one point, which may neither approach the plane beyond the gap [m] nor slide; by Gauss–Seidel.
fn roll(step: &mut Step, radius: f64, normal: DVec3, gap: f64) {
    let arm = -radius * normal;
    let mass = 1.0 / step.inverse_mass(0, arm).to_cols_array().into_iter().fold(0.0, f64::max);
    for _ in 0..60 {
        let missing = step.velocity_at(0, arm) + gap / step.dt() * normal;
        step.apply(0, arm, -mass * missing);
    }
}
