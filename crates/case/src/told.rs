//! Where motions take a body, in words: `down 25 mm from 0.1 to 0.6 s`.

use super::path::travel;
use super::resolved::{Case, Change, MOTIONS, Motion};
use input::quantity::plain;
use mechanics::Course;

/// A motion of a body in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ToldMotion {
    /// Path of the key of the motion: `body.plate.heave`, `stage.press.plate.heave`.
    pub path: String,
    /// What the body does: direction, distance and times. Those of a stage count from its beginning.
    pub words: String,
}

/// The words of one degree of freedom.
struct Words {
    /// Words before a distance; empty where the direction says all.
    verb: &'static str,
    /// Words after a distance: against and along the axis.
    ways: [&'static str; 2],
    /// Whether the direction stands before the distance.
    leads: bool,
    /// Words for what a load does, against and along the axis.
    loads: [&'static str; 2],
}

const WORDS: [Words; 6] = [
    words("towed", ["along −x", "along +x"], ["pulled along −x", "pulled along +x"]),
    words("moved", ["to the right (−y)", "to the left (+y)"], ["pushed to the right", "pushed to the left"]),
    Words { leads: true, ..words("", ["down", "up"], ["pressed down", "lifted"]) },
    words("turned by", ["to the right", "to the left"], ["turned to the right", "turned to the left"]),
    words(
        "tilted by",
        ["with its left end down", "with its left end up"],
        ["left end pressed", "left end lifted"],
    ),
    words("rolled by", ["backwards", "forwards"], ["driven backwards", "driven forwards"]),
];

const fn words(verb: &'static str, ways: [&'static str; 2], loads: [&'static str; 2]) -> Words {
    Words { verb, ways, leads: false, loads }
}

/// The motions of a body at the start, by its number, but for rotations of the axle that are locked.
#[must_use]
pub fn told_of_body(case: &Case, number: usize) -> Vec<ToldMotion> {
    let body = &case.bodies[number];
    let all = MOTIONS.into_iter().zip(body.motions()).enumerate();
    // Steering is the exception.
    let shown = all.filter(|(_, (key, how))| *how != Motion::Fixed || !key.ends_with("_motion"));
    let one = |(motion, (key, how)): (usize, (&str, Motion))| ToldMotion {
        path: format!("body.{}.{key}", body.name),
        words: tell(&how, motion, lasts(case, number, motion, 0)),
    };
    shown.map(one).collect()
}

/// The motions that change in a stage, by its number.
#[must_use]
pub fn told_of_stage(case: &Case, number: usize) -> Vec<ToldMotion> {
    let stage = &case.stages[number];
    let one = |change: &Change| ToldMotion {
        path: format!("stage.{}.{}.{}", stage.name, case.bodies[change.body].name, MOTIONS[change.motion]),
        words: tell(&change.to, change.motion, lasts(case, change.body, change.motion, number + 1)),
    };
    stage.changes.iter().map(one).collect()
}

/// How long a motion of a body lasts at most [s] that is in force before the stage of this number begins:
/// until a stage changes it.
pub(super) fn lasts(case: &Case, body: usize, motion: usize, before: usize) -> f64 {
    if case.stages.is_empty() {
        return case.duration;
    }
    let changes = |n: usize| case.stages[n].changes.iter().any(|c| c.body == body && c.motion == motion);
    let next = (before..case.stages.len()).find(|n| changes(*n)).unwrap_or(case.stages.len());
    case.stages[before.saturating_sub(1).min(next)..next].iter().map(|stage| stage.duration).sum()
}

/// One motion in words, by its number in [`MOTIONS`], as long as it lasts [s].
fn tell(how: &Motion, motion: usize, lasts: f64) -> String {
    match *how {
        Motion::Fixed => "fixed".into(),
        _ if lasts <= 0.0 => "until the first stage begins".into(),
        Motion::Course(ref course) => given(legs(&points(course, lasts)), motion, lasts),
        Motion::Prescribed { speed, start, ramp, .. } => {
            let mut text = given(legs(&moments(how, lasts)), motion, lasts);
            if start < lasts && speed != 0.0 {
                text += &format!(", {}", rate(speed.abs(), motion));
                if ramp > 0.0 {
                    text += &format!(" after a ramp of {} s", plain(ramp));
                }
            }
            text
        }
        Motion::Free { load: 0.0, support: 0.0, .. } => "free".into(),
        Motion::Free { load, start, ramp, .. } => {
            let Words { loads, .. } = &WORDS[motion];
            let unit = if motion < 3 { "N" } else { "N m" };
            let what = match load {
                0.0 => "released".to_owned(),
                _ => format!("{} with {} {unit}", loads[usize::from(load > 0.0)], plain(load.abs())),
            };
            format!("free, {what} from {} s within {} s", plain(start), plain(ramp))
        }
    }
}

/// A part of a motion that goes one way.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Leg {
    /// When the leg begins and ends [s].
    times: [f64; 2],
    /// Displacement over the leg [m or rad].
    way: f64,
}

/// Most parts of a motion that are told one by one.
const MOST_LEGS: usize = 4;

/// A prescribed motion that lasts for a time [s].
fn given(legs: Vec<Leg>, motion: usize, lasts: f64) -> String {
    if legs.is_empty() {
        return format!("at rest for all of its {} s", plain(lasts));
    }
    if legs.len() <= MOST_LEGS {
        return legs.iter().map(|leg| leg.tell(motion)).collect::<Vec<_>>().join(", then ");
    }
    let reached = legs.iter().scan(0.0, |at, leg| {
        *at += leg.way;
        Some(*at)
    });
    let [low, high] = reached.fold([0.0_f64; 2], |[low, high], at| [low.min(at), high.max(at)]);
    let [down, up] = [low, high].map(|end| distance(end.abs(), motion));
    let [against, along] = WORDS[motion].ways;
    format!(
        "to and fro {} times from {} to {} s, between {down} {against} and {up} {along}",
        legs.len(),
        plain(rounded(legs[0].times[0])),
        plain(rounded(legs[legs.len() - 1].times[1])),
    )
}

impl Leg {
    fn tell(&self, motion: usize) -> String {
        let Words { verb, ways, leads, .. } = &WORDS[motion];
        let (far, way) = (distance(self.way.abs(), motion), ways[usize::from(self.way > 0.0)]);
        let path = if *leads { format!("{way} {far}") } else { format!("{verb} {far} {way}") };
        let [from, to] = self.times.map(|time| plain(rounded(time)));
        format!("{path} from {from} to {to} s")
    }
}

/// A distance or an angle for display.
fn distance(way: f64, motion: usize) -> String {
    match motion {
        0..3 if way < 0.1 => format!("{} mm", plain(rounded(1e3 * way))),
        0..3 => format!("{} m", plain(rounded(way))),
        _ => format!("{}°", plain(rounded(way.to_degrees()))),
    }
}

/// A speed or a rate of turning for display.
fn rate(speed: f64, motion: usize) -> String {
    format!("{} {}", plain(speed), if motion < 3 { "m/s" } else { "rad/s" })
}

/// A number in four digits.
fn rounded(number: f64) -> f64 {
    format!("{number:.3e}").parse().unwrap_or(number)
}

/// Times [s] and displacements of a speed that rises to a value.
fn moments(how: &Motion, lasts: f64) -> Vec<[f64; 2]> {
    let &Motion::Prescribed { start, ramp, end, .. } = how else { return Vec::new() };
    let mut times: Vec<f64> =
        [0.0, start, start + ramp, end, end + ramp].into_iter().filter(|t| *t < lasts).collect();
    times.push(lasts);
    times.sort_by(f64::total_cmp);
    times.into_iter().map(|time| [time, travel(how, time)]).collect()
}

/// Points of a course, time [s] and displacement [m or rad], as long as the motion lasts [s].
fn points(course: &Course, lasts: f64) -> Vec<[f64; 2]> {
    let inside = course.moments(lasts).into_iter().filter(|time| *time > 0.0);
    std::iter::once(0.0).chain(inside).map(|time| [time, course.displacement(time)]).collect()
}

/// Change of direction that is no more than noise of a measured motion, over its whole range (chosen).
const NOISE: f64 = 0.02;
/// Displacement over the whole range that is no more than rest (chosen).
const REST: f64 = 1e-3;

/// The parts of a motion through points that go one way each, without the rests between them.
fn legs(points: &[[f64; 2]]) -> Vec<Leg> {
    let [low, high] =
        points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], p| [l.min(p[1]), h.max(p[1])]);
    let range = high - low;
    if points.is_empty() || range <= 0.0 {
        return Vec::new();
    }
    // Where it turns round by more than noise: the farthest point of each part.
    let mut ends = vec![0];
    let (mut farthest, mut sign) = (0, 0.0);
    for (n, point) in points.iter().enumerate().skip(1) {
        let beyond = point[1] - points[farthest][1];
        if sign == 0.0 && beyond.abs() > NOISE * range {
            (farthest, sign) = (n, beyond.signum());
        } else if sign != 0.0 && beyond * sign > 0.0 {
            farthest = n;
        } else if beyond * sign < -NOISE * range {
            ends.push(farthest);
            (farthest, sign) = (n, -sign);
        }
    }
    ends.push(farthest);
    ends.windows(2).filter_map(|pair| leg(&points[pair[0]..=pair[1]], REST * range)).collect()
}

/// One leg, from when the motion has left its first point to when it has reached its last.
fn leg(points: &[[f64; 2]], rest: f64) -> Option<Leg> {
    let (first, last) = (points.first()?[1], points.last()?[1]);
    let begins = points.iter().rfind(|point| (point[1] - first).abs() <= rest)?[0];
    let ends = points.iter().find(|point| (point[1] - last).abs() <= rest)?[0];
    Some(Leg { times: [begins, ends], way: last - first })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told_course(times: &[f64], displacements: &[f64], motion: usize) -> String {
        let course = Course::through(times.to_vec(), displacements.to_vec()).unwrap();
        tell(&Motion::Course(course), motion, 2.0)
    }

    #[test]
    fn a_course_is_told_by_direction_distance_and_times() {
        for (times, displacements, motion, words) in [
            (&[0.1, 0.6][..], &[0.0, -0.025][..], 2, "down 25 mm from 0.1 to 0.6 s"),
            (&[0.0, 0.1, 0.4, 0.6], &[0.0, 0.0, 0.025, 0.025], 2, "up 25 mm from 0.1 to 0.4 s"),
            (&[0.0, 1.0], &[0.0, 0.36], 0, "towed 0.36 m along +x from 0 to 1 s"),
            (&[0.0, 1.0], &[0.0, -0.36], 0, "towed 0.36 m along −x from 0 to 1 s"),
            (&[0.0, 1.0], &[0.0, 0.05], 1, "moved 50 mm to the left (+y) from 0 to 1 s"),
            (
                &[0.0, 1.0, 1.5, 1.8],
                &[0.0, -0.05, -0.05, -0.01],
                2,
                "down 50 mm from 0 to 1 s, then up 40 mm from 1.5 to 1.8 s",
            ),
            // Noise of a measurement is no change of direction.
            (&[0.0, 0.4, 0.5, 1.0], &[0.0, -0.010, -0.0098, -0.030], 2, "down 30 mm from 0 to 1 s"),
            (&[3.0, 4.0], &[0.0, -0.1], 2, "at rest for all of its 2 s"),
        ] {
            assert_eq!(told_course(times, displacements, motion), words);
        }
        let times: Vec<f64> = (0..=12).map(|n| 0.1 * f64::from(n)).collect();
        let waves: Vec<f64> = (0..=12).map(|n| if n % 2 == 1 { 0.01 } else { -0.01 }).collect();
        let told = told_course(&times, &waves, 2);
        assert!(told.starts_with("to and fro 12 times from 0 to 1.2 s"), "{told}");
    }

    #[test]
    fn a_speed_is_told_as_far_as_it_goes() {
        let told = |speed: f64, start: f64, ramp: f64, end: f64, motion: usize| {
            tell(&Motion::Prescribed { before: 0.0, speed, start, ramp, end }, motion, 2.0)
        };
        for (text, words) in [
            (told(0.2, 0.3, 0.0, f64::INFINITY, 0), "towed 0.34 m along +x from 0.3 to 2 s, 0.2 m/s"),
            (told(-0.05, 0.0, 0.0, 0.5, 2), "down 25 mm from 0 to 0.5 s, 0.05 m/s"),
            (told(-0.1, 0.0, 0.1, 0.9, 2), "down 90 mm from 0 to 1 s, 0.1 m/s after a ramp of 0.1 s"),
            (told(1.0, 0.0, 0.0, 1.0, 5), "rolled by 57.3° forwards from 0 to 1 s, 1 rad/s"),
            (told(0.2, 5.0, 0.1, f64::INFINITY, 0), "at rest for all of its 2 s"),
            (told(0.0, 0.0, 0.1, f64::INFINITY, 5), "at rest for all of its 2 s"),
        ] {
            assert_eq!(text, words);
        }
        let pressed = Motion::Free { load: -20.0, support: 0.0, start: 0.0, ramp: 0.1 };
        assert_eq!(tell(&pressed, 2, 2.0), "free, pressed down with 20 N from 0 s within 0.1 s");
    }

    #[test]
    fn the_motions_of_stages_are_told_for_as_long_as_they_last() {
        let text = include_str!("../../../cases/press_and_tow.toml");
        let case = crate::parse(text, "case.toml", &[]).unwrap();
        let told: Vec<_> = (0..4).flat_map(|n| told_of_stage(&case, n)).collect();
        let words = |path: &str| &*told.iter().find(|t| t.path == path).expect(path).words;
        assert!(words("stage.press.disc.heave").starts_with("down 40.5 mm from 0 to 0.7 s"));
        assert!(words("stage.tow.disc.forward").starts_with("towed 0.19 m along +x from 0 to 1 s"));
        assert!(words("stage.lift.disc.heave").starts_with("up 65 mm from 0 to 0.7 s"));
    }
}
