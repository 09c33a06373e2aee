//! Bodies with fixed and prescribed motions, and on gimbals.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod common;

use common::{GRAVITY, Largest, below, energy, run};
use glam::{DMat3, DQuat, DVec3};
use mechanics::{Body, Conditions, Inertia, Mechanism, Motion, Pose, Step, Twist};

const FIXED: Motion = Motion::Fixed;
const FREE: Motion = Motion::FREE;

fn alone(body: Body) -> Mechanism {
    Mechanism::new(vec![body], vec![]).unwrap()
}

/// A disc that heaves and spins: two scalar equations, v += P/m and ω += L/I, and nothing else moves at all.
#[test]
fn heave_and_spin_are_two_scalar_equations() {
    let inertia = Inertia::disc(7.0, 0.25, 0.02);
    let [load, torque] = [Motion::loaded(-7.0 * 9.81), Motion::loaded(0.3)];
    let mut body = Body::new(inertia, [FIXED, FIXED, load, FIXED, FIXED, torque]);
    body.modelled_fraction = 0.5;
    let mechanism = alone(body);
    let mut state = mechanism.state(&[(Pose::at(DVec3::new(0.1, 0.2, 0.3)), Twist::ZERO)]);
    let (mut speed, mut spin, mut height, dt) = (0.0, 0.0, 0.3, 1e-3);
    let (mut step, mut error, moment) = (Step::default(), Largest::default(), inertia.tensor.y_axis.y);
    for n in 0..1000 {
        mechanism.predict(&state, &Conditions { time: n as f64 * dt, dt, gravity: DVec3::ZERO }, &mut step);
        let (arm, impulse) = (DVec3::new(0.1, 0.01, -0.2), DVec3::new(0.01, -0.002, 0.03 + 1e-5 * n as f64));
        step.apply(0, arm, impulse);
        mechanism.advance(&mut state, &mut step);
        speed += (-7.0 * 9.81 * dt + 2.0 * impulse.z) / 7.0;
        spin += (0.3 * dt + 2.0 * arm.cross(impulse).y) / moment;
        height += speed * dt;
        let Twist { linear, angular } = state.bodies[0].twist;
        assert_eq!([linear.x, linear.y, angular.x, angular.z], [0.0; 4]);
        let pose = state.bodies[0].pose;
        assert_eq!(
            [pose.position.x, pose.position.y, pose.rotation.x, pose.rotation.z],
            [0.1, 0.2, 0.0, 0.0]
        );
        error.add((linear.z - speed) / 0.27);
        error.add((angular.y - spin) / spin);
        error.add(pose.position.z - height);
    }
    below("relative difference", error.0, 1e-12);
}

/// A prescribed body needs no mass, and nothing moves it.
#[test]
fn prescribed_bodies_need_no_mass() {
    let speeds = [0.5, 0.0, -0.1, 0.0, 0.0, 3.0];
    let mechanism = alone(Body::new(Inertia::NONE, speeds.map(Motion::prescribed)));
    let mut state = mechanism.state(&[(Pose::IDENTITY, Twist::ZERO)]);
    let mut step = Step::default();
    for n in 0..100 {
        mechanism.predict(
            &state,
            &Conditions { time: 0.01 * f64::from(n), dt: 0.01, gravity: GRAVITY },
            &mut step,
        );
        assert_eq!(step.inverse_mass(0, DVec3::ONE), DMat3::ZERO);
        step.apply(0, DVec3::ONE, DVec3::new(1.0, 2.0, 3.0));
        mechanism.advance(&mut state, &mut step);
    }
    assert_eq!(state.bodies[0].twist.linear, DVec3::new(0.5, 0.0, -0.1));
    assert_eq!(state.bodies[0].twist.angular, DVec3::new(0.0, 3.0, 0.0));
    below("position", state.bodies[0].pose.position.distance(DVec3::new(0.5, 0.0, -0.1)), 1e-14);
    let impulse = step.impulses(0).drive_reaction.force;
    assert_eq!(impulse, DVec3::new(-1.0, -2.0, -3.0));
}

/// A rotor with an eccentric centre spun at a prescribed rate: bearing force m e Ω² inwards plus the weight,
/// torque of the weight, and the work of the drive, to second order; the balance of energy to round-off.
#[test]
fn an_eccentric_rotor_loads_its_bearing() {
    let (mass, eccentricity, rate) = (3.0, 0.1, 20.0);
    let inertia = Inertia::disc(mass, 0.3, 0.1).with_centre(DVec3::new(eccentricity, 0.0, 0.0));
    let spin = Motion::prescribed(rate);
    let errors = [200, 400].map(|per_turn| {
        let mechanism = alone(Body::new(inertia, [FIXED, FIXED, FIXED, FIXED, FIXED, spin.clone()]));
        let mut state = mechanism.state(&[(Pose::IDENTITY, Twist::ZERO)]);
        let dt = std::f64::consts::TAU / rate / f64::from(per_turn);
        let (mut works, mut closure, mut force, mut torque) =
            (0.0, Largest::default(), Largest::default(), Largest::default());
        let scale = mass * eccentricity * rate * rate;
        run((&mechanism, &mut state), GRAVITY, (dt, 10 * per_turn as usize), |time, now, step| {
            works += step.work(0).total();
            closure.add((mechanism.kinetic_energy(now) - works) / mechanism.kinetic_energy(now));
            let angle = rate * (time - 0.5 * dt);
            let out = DVec3::new(angle.cos(), 0.0, -angle.sin());
            let reaction = step.impulses(0).drive;
            force.add((reaction.force / dt + mass * GRAVITY + scale * out).length() / scale);
            let weight = (eccentricity * out).cross(mass * GRAVITY);
            torque.add((reaction.moment / dt + weight).length() / (mass * 9.81 * eccentricity));
        });
        below("energy balance", closure.0, 1e-12);
        [force.0, torque.0]
    });
    eprintln!("bearing force and torque of the drive, relative errors {errors:?}");
    below("bearing force", errors[1][0], 1e-2);
    below("torque of the drive", errors[1][1], 1e-2);
}

/// The same rotor free to heave: its centre of mass falls freely.
#[test]
fn a_free_rotor_throws_its_bearing() {
    let inertia = Inertia::disc(3.0, 0.3, 0.1).with_centre(DVec3::new(0.1, 0.0, 0.0));
    let mechanism = alone(Body::new(inertia, [FIXED, FIXED, FREE, FIXED, FIXED, Motion::prescribed(20.0)]));
    let mut state = mechanism.state(&[(Pose::IDENTITY, Twist::ZERO)]);
    let (dt, mut works, mut error, mut closure) = (1e-3, 0.0, Largest::default(), Largest::default());
    run((&mechanism, &mut state), GRAVITY, (dt, 2000), |time, now, step| {
        works += step.work(0).total();
        closure.add((mechanism.kinetic_energy(now) - works) / works.abs().max(1.0));
        error.add(mechanism.bodies()[0].centre(&now.bodies[0]).z + 0.5 * 9.81 * time * time);
    });
    below("fall of the centre of mass [m]", error.0, 1e-11);
    below("energy balance", closure.0, 1e-12);
}

/// A disc on a gimbal, tilt fixed: yaw and spin are free. The inclination of the axle, energy and vertical
/// angular momentum stay, also for an asymmetric body.
#[test]
fn tilt_stays_fixed_while_yaw_and_spin_are_free() {
    for moments in [DVec3::new(0.6, 1.0, 0.6), DVec3::new(0.5, 1.0, 0.8)] {
        let body = Body::new(Inertia::principal(2.0, moments), [FIXED, FIXED, FIXED, FREE, FIXED, FREE]);
        let mechanism = alone(body);
        let rotation =
            DQuat::from_rotation_z(0.4) * DQuat::from_rotation_x(0.5) * DQuat::from_rotation_y(0.2);
        let axle = rotation * DVec3::Y;
        let angular = 2.0 * DVec3::Z + 9.0 * axle;
        let mut state = mechanism
            .state(&[(Pose { position: DVec3::ZERO, rotation }, Twist { linear: DVec3::ZERO, angular })]);
        below("velocity at the start", (state.bodies[0].twist.angular - angular).length(), 1e-14);
        let first = energy(&mechanism, &state, GRAVITY);
        let vertical = mechanism.angular_momentum(&state, DVec3::ZERO).z;
        let [mut tilt, mut of_energy, mut of_vertical] = [(); 3].map(|()| Largest::default());
        run((&mechanism, &mut state), GRAVITY, (2e-3, 10_000), |_, now, _| {
            tilt.add((now.bodies[0].pose.rotation * DVec3::Y).z - axle.z);
            of_energy.add(energy(&mechanism, now, GRAVITY) / first - 1.0);
            of_vertical.add(mechanism.angular_momentum(now, DVec3::ZERO).z / vertical - 1.0);
        });
        below("inclination of the axle", tilt.0, 1e-12);
        below("energy", of_energy.0, 1e-11);
        below("vertical angular momentum", of_vertical.0, 1e-11);
        let yaw = rotation * DVec3::Y;
        let turned = (state.bodies[0].pose.rotation * DVec3::Y).truncate().angle_to(yaw.truncate());
        if moments.x == moments.z {
            // Of a symmetric disc both rates are constant: 40 rad of yaw, to second order.
            let exact =
                (40.0_f64 + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI;
            below("angle of yaw [rad]", (-turned - exact).abs(), 1e-2);
        }
    }
}

/// A torque about the vertical turns a spinning disc with a fixed horizontal axle: ψ̈ = Q/I_d, and the
/// support of the tilt bears the gyroscopic moment I_p ω ψ̇.
#[test]
fn the_support_of_the_tilt_bears_the_gyroscopic_moment() {
    let (across, along, spin, torque) = (0.6, 1.0, 30.0, 0.25);
    let inertia = Inertia::principal(2.0, DVec3::new(across, along, across));
    let mechanism = alone(Body::new(inertia, [FIXED, FIXED, FIXED, Motion::loaded(torque), FIXED, FREE]));
    let mut state =
        mechanism.state(&[(Pose::IDENTITY, Twist { linear: DVec3::ZERO, angular: spin * DVec3::Y })]);
    let (dt, [mut moment, mut rate, mut momentum]) = (1e-3, [(); 3].map(|()| Largest::default()));
    run((&mechanism, &mut state), GRAVITY, (dt, 4000), |time, now, step| {
        let twist = now.bodies[0].twist;
        momentum.add(mechanism.angular_momentum(now, DVec3::ZERO).z - torque * time);
        rate.add(twist.angular.z / (torque / across * time) - 1.0);
        let axle = now.bodies[0].pose.rotation * DVec3::Y;
        let bears = step.impulses(0).drive.moment.length() / dt;
        if time > 1.0 {
            moment.add(bears / (along * twist.angular.dot(axle) * twist.angular.z) - 1.0);
        }
    });
    below("vertical angular momentum [N m s]", momentum.0, 1e-11);
    // The mean inertia is larger by 1 + (ω Δt)²/4.
    below("rate of yaw", rate.0, 3e-4);
    below("gyroscopic moment", moment.0, 1e-3);
}

/// A lopsided wheel that is steered at a prescribed, smoothly ramped rate while it spins and heaves freely
/// under a load: the energy that loads, gravity, contact and drives supply is what the wheel has.
#[test]
fn a_steered_wheel_balances_its_energy() {
    let moments = DVec3::new(0.5, 1.0, 0.8);
    let inertia = Inertia::principal(2.0, moments).with_centre(DVec3::new(0.05, 0.02, -0.03));
    let steer = Motion::Prescribed { before: 0.0, speed: 3.0, start: 0.5, ramp: 0.7, end: 2.5 };
    let torque = Motion::Free { load: 2.0, support: 0.0, start: 0.2, ramp: 0.5 };
    let mechanism = alone(Body::new(inertia, [Motion::prescribed(1.0), FIXED, FREE, steer, FIXED, torque]));
    let pose = Pose { position: DVec3::ZERO, rotation: DQuat::from_rotation_x(0.3) };
    let mut state = mechanism.state(&[(pose, Twist::ZERO)]);
    let axle = (pose.rotation * DVec3::Y).z;
    let (mut step, mut works, dt) = (Step::default(), 0.0, 1e-3);
    let [mut closure, mut tilt] = [(); 2].map(|()| Largest::default());
    for n in 0..4000 {
        mechanism.predict(&state, &Conditions { time: n as f64 * dt, dt, gravity: GRAVITY }, &mut step);
        step.apply(0, DVec3::new(0.1, 0.0, -0.3), DVec3::new(-1.0, 0.3, 18.0) * dt);
        mechanism.advance(&mut state, &mut step);
        works += step.work(0).total();
        closure.add((mechanism.kinetic_energy(&state) - works) / works.abs().max(1.0));
        tilt.add((state.bodies[0].pose.rotation * DVec3::Y).z - axle);
    }
    assert!(works > 5.0, "{works}");
    below("energy balance", closure.0, 1e-10);
    below("inclination of the axle", tilt.0, 1e-12);
}
