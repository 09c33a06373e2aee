//! A tow in any level direction, turned so that it goes along x: the closed forms know only that.

use crate::case::resolved::{Body, Motion};
use glam::DQuat;

/// The bodies turned about z, with their places, until the tow is along x; as they are where they are not towed sideways, or not all in
/// one direction at given speeds.
pub(super) fn along_the_tow(bodies: Vec<Body>, remarks: &mut Vec<String>) -> Vec<Body> {
    let speeds: Vec<[f64; 2]> = bodies.iter().filter_map(level_speeds).collect();
    let Some(&[x, y]) = speeds.first().filter(|_| speeds.len() == bodies.len()) else { return bodies };
    if y == 0.0 || speeds.iter().any(|other| *other != [x, y]) {
        return bodies;
    }
    let angle = y.atan2(x);
    remarks.push(format!(
        "towed at {:.2}° from x to the left: drag is along the tow, moments are about axes turned with it",
        angle.to_degrees()
    ));
    let turned = |mut body: Body| {
        body.position = DQuat::from_rotation_z(-angle) * body.position;
        body.attitude.yaw -= angle;
        if let [Motion::Prescribed { speed, .. }, ..] | [_, Motion::Prescribed { speed, .. }, _] =
            &mut body.translation
        {
            *speed = x.hypot(y);
        }
        let [forward, lateral, _] = &mut body.translation;
        if !matches!(forward, Motion::Prescribed { .. }) {
            std::mem::swap(forward, lateral);
        }
        *lateral = Motion::Fixed;
        body
    };
    bodies.into_iter().map(turned).collect()
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
    use crate::case::parse;
    use crate::forecast::model_input;

    const DISC: &str = include_str!("../../../../cases/light_disc.toml");

    fn drag(overrides: &[&str]) -> f64 {
        let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
        let text = DISC.replace("tow_distance = \"0.32 m\"", "duration = \"1 s\"");
        let case = parse(&text, "case.toml", &overrides).unwrap();
        crate::forecast::outlook(&case).unwrap().recommended().unwrap().prediction.as_ref().unwrap().drag
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
