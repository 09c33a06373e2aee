//! A tow in any level direction, turned so that it goes along x: the closed forms know only that.

use case::resolved::{Body, Motion};
use case::tow::squared;
use glam::DQuat;
use std::f64::consts::FRAC_PI_2;

/// The bodies turned about z, with their places, until the tow is along x; as they are where they are not
/// towed sideways, or not all in one direction.
pub(super) fn along_the_tow(bodies: Vec<Body>, remarks: &mut Vec<String>) -> Vec<Body> {
    let Some(angle) = angle(&bodies) else { return bodies };
    remarks.push(format!(
        "towed at {:.2}° from x to the left: drag is along the tow, moments are about axes turned with it",
        angle.to_degrees()
    ));
    bodies.into_iter().map(|body| turned(body, angle)).collect()
}

/// The angle from x of the tow of all bodies [rad]; `None` where none is towed sideways, or not all in one
/// direction. Of a tow along y that is not at a given speed it is that of y, whichever way the body goes.
fn angle(bodies: &[Body]) -> Option<f64> {
    let first = bodies.first()?;
    let is_still = |motion: &Motion| matches!(motion, Motion::Fixed | Motion::Prescribed { speed: 0.0, .. });
    if let Some([x, y]) = level_speeds(first) {
        let are_alike = bodies.iter().all(|other| level_speeds(other) == Some([x, y]));
        return (are_alike && y != 0.0).then(|| y.atan2(x));
    }
    let is_pushed = |motion: &Motion| match motion {
        Motion::Course(_) => true,
        Motion::Free { load, .. } => *load != 0.0,
        Motion::Fixed | Motion::Prescribed { .. } => false,
    };
    let [_, lateral, _] = &first.translation;
    let are_alike = bodies.iter().all(|b| is_still(&b.translation[0]) && b.translation[1] == *lateral);
    (are_alike && is_pushed(lateral)).then_some(FRAC_PI_2)
}

/// A body turned about z, so that a tow at this angle from x [rad] goes along x.
fn turned(mut body: Body, angle: f64) -> Body {
    body.position = DQuat::from_rotation_z(-angle) * body.position;
    body.attitude.yaw -= angle;
    if body.attitude.tilt == 0.0 && body.attitude.pitch == 0.0 {
        (body.shape, body.attitude.yaw) = squared(&body.shape, body.attitude.yaw);
    }
    let speed = level_speeds(&body).map(|[x, y]| x.hypot(y));
    let [forward, lateral, _] = &mut body.translation;
    if !matches!(forward, Motion::Prescribed { speed, .. } if *speed != 0.0) {
        std::mem::swap(forward, lateral);
    }
    if let (Motion::Prescribed { speed, .. }, Some(along)) = (&mut *forward, speed) {
        *speed = along;
    }
    *lateral = Motion::Fixed;
    body
}

/// Speeds along x and y [m/s] of a body whose level motions are fixed or at given speeds.
fn level_speeds(body: &Body) -> Option<[f64; 2]> {
    let speed = |motion: &Motion| match motion {
        Motion::Fixed => Some(0.0),
        Motion::Prescribed { speed, .. } => Some(*speed),
        Motion::Course(_) | Motion::Free { .. } => None,
    };
    let [forward, lateral, _] = &body.translation;
    Some([speed(forward)?, speed(lateral)?])
}

#[cfg(test)]
mod tests {
    use crate::forecast::model_input;
    use case::parse;

    const DISC: &str = include_str!("../../../../cases/light_disc.toml");

    fn drag(overrides: &[&str]) -> f64 {
        let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
        let text = DISC.replace("tow_distance = \"0.32 m\"", "duration = \"1 s\"");
        let case = parse(&text, "case.toml", &overrides).unwrap();
        crate::forecast::outlook(&case).unwrap().best().unwrap().prediction.as_ref().unwrap().drag
    }

    #[test]
    fn a_tow_along_y_is_one_along_x_of_a_body_that_is_turned() {
        let whole = ["domain.symmetric=false", "domain.x=['-0.5 m', '1 m']", "domain.y=['-0.5 m', '1 m']"];
        let along = |more: &[&'static str]| drag(&[&whole[..], more].concat());
        let sideways = ["body.disc.forward=fixed", "body.disc.lateral={ speed = '0.2 m/s' }"];
        let turned = along(&["body.disc.forward={ speed = '0.2 m/s' }", "body.disc.yaw=-90 deg"]);
        let lateral = along(&sideways);
        assert!((lateral / turned - 1.0).abs() < 1e-9, "{lateral} {turned}");
        assert!(
            model_input(&parse(DISC, "case.toml", &[]).unwrap())
                .unwrap()
                .remarks
                .iter()
                .all(|r| !r.contains("towed at"))
        );
    }
}
