//! Motions that can hardly be meant: a tow backwards, one that is too short for the soil to fail, and one
//! faster than the soil can give way.

use super::values;
use crate::path::{fastest, range, travel};
use crate::resolved::{Body, Case};
use input::quantity::plain;

/// Way of a body that sinks or rolls freely over its length below which its tow is doubted (chosen): the
/// force on towed discs is steady after 0.5 to 1.5 diameters.
const SHORT: f64 = 0.1;
/// Speed over that of waves in the soil beyond which a motion is doubted (chosen): the dynamic pressure ρ v²
/// is then a tenth of the stiffness.
const FAST: f64 = 0.3;

/// Doubts motions.
pub(super) fn motions(case: &Case, doubts: &mut Vec<String>) {
    let waves = case.soil.material().wave_speed();
    for (path, motion) in values::motions(case) {
        let speed = fastest(&motion);
        if speed > FAST * waves {
            doubts.push(format!(
                "{path}: {} m/s is {:.0} % of the speed of waves in this soil, {waves:.1} m/s: it cannot give way; is the speed meant, and the \
                 stiffness?",
                plain(speed),
                100.0 * speed / waves
            ));
        }
    }
    for (_, body) in case.touching() {
        backwards(case, body, doubts);
        too_short(case, body, doubts);
    }
}

/// A body that is towed along −x and never along +x.
fn backwards(case: &Case, body: &Body, doubts: &mut Vec<String>) {
    let [low, high] = range(body, case.duration);
    let is_prescribed = !body.guided().translation[0].is_free();
    if is_prescribed && low.x < 0.0 && high.x <= 0.0 {
        doubts.push(format!(
            "{}: towed backwards, {} m along −x: a tow goes along +x, where wedges and blades have their front; is the sign of `forward` meant?",
            body.name,
            plain(-low.x)
        ));
    }
}

/// A body that rolls or sinks freely and is towed less than the soil needs to fail in front of it.
fn too_short(case: &Case, body: &Body, doubts: &mut Vec<String>) {
    let guide = body.guided();
    let settles = guide.translation[2].is_free() || body.spin().is_free();
    if !settles || body.staged.is_some() {
        return;
    }
    let [x, y] = [0, 1].map(|axis| travel(&guide.translation[axis], case.duration));
    let (way, length) = (x.hypot(y), body.size().x);
    if way > 0.0 && way < SHORT * length {
        doubts.push(format!(
            "{}: towed {} m only, {:.2} of its length: its force and its sinkage become steady after 0.5 to 1.5 lengths; see run.",
            body.name,
            plain(way),
            way / length
        ));
    }
}
