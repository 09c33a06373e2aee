//! How far a figure may be off because of one source of uncertainty, and of all of them.
//!
//! The equations, their symbols and the reasons for the constants are in `docs/theory/confidence.md`.

use super::figures::{ConfidenceInterval, Contribution};
use crate::confidence::variations::{FARTHER, LONGER};

/// How far the figure of an infinite domain may be, in changes by the larger one: its effect falls at least
/// with the first power of the distance, c/R, so that a domain [`FARTHER`] times as far leaves the change
/// times s/(s − 1).
pub const REACH_DOMAIN: f64 = FARTHER / (FARTHER - 1.0);
/// How far the figure of a motion without speed may be, in changes by the slower one: viscosity adds to a
/// force with the first power of the speed, inertia with the second.
pub const REACH_SPEED: f64 = LONGER / (LONGER - 1.0);
/// How far the figure without rounding may be, in changes by the other precision, to either side: Roache's
/// factor where the better value is known.
pub const SAFETY_PRECISION: f64 = 1.25;
/// How far a bias reaches against its direction, in changes: a difference of two runs is not free of scatter.
const AGAINST: f64 = 1.0;

/// How far below and above its value a figure may be for a change that is the first part of a bias.
pub(super) fn bias(change: f64, reach: f64) -> [f64; 2] {
    let (towards, against) = (reach * change.abs(), AGAINST * change.abs());
    if change < 0.0 { [towards, against] } else { [against, towards] }
}

/// How far below and above its value a figure may be for a change that may go either way.
pub(super) fn scatter(change: f64) -> [f64; 2] {
    [SAFETY_PRECISION * change.abs(); 2]
}

/// The interval of a value from independent contributions: the squares of each side add up. `scale` is what
/// half-widths are compared with.
pub(super) fn combined(value: f64, scale: f64, mut contributions: Vec<Contribution>) -> ConfidenceInterval {
    let root =
        |side: fn(&Contribution) -> f64| contributions.iter().map(|c| side(c).powi(2)).sum::<f64>().sqrt();
    let (below, above) = (root(|c| c.below), root(|c| c.above));
    let relative = |part: f64| {
        let ratio = if part == 0.0 { 0.0 } else { part / scale };
        ratio.is_finite().then_some(ratio)
    };
    for contribution in &mut contributions {
        contribution.relative = relative(contribution.size());
    }
    let largest = contributions.iter().filter(|c| c.size() > 0.0);
    let largest = largest.max_by(|a, b| a.size().total_cmp(&b.size()));
    let half_width = 0.5 * (below + above);
    ConfidenceInterval {
        value,
        interval: [value - below, value + above],
        half_width,
        relative_half_width: relative(half_width),
        dominated_by: largest.map(|c| c.source),
        is_complete: !contributions.iter().any(|c| c.status.is_missing()),
        contributions,
    }
}

#[cfg(test)]
mod tests {
    use super::super::figures::Status;
    use super::*;
    use crate::confidence::variations::ErrorSource;

    fn part(source: ErrorSource, [below, above]: [f64; 2]) -> Contribution {
        Contribution { source, status: Status::Examined, below, above, ..Contribution::default() }
    }

    #[test]
    fn a_bias_of_the_first_power_ends_where_the_cause_vanishes() {
        // c/R at R and at 1.5 R: the limit is 3 changes away; c v at v and v/2: 2 changes.
        let of_domain = |r: f64| 10.0 + 2.0 / r;
        let change = of_domain(1.5) - of_domain(1.0);
        let [below, above] = bias(change, REACH_DOMAIN);
        assert!((of_domain(1.0) - below - 10.0).abs() < 1e-12 && (above - change.abs()).abs() < 1e-12);
        let [below, _] = bias(-1.0, REACH_SPEED);
        assert!((below - 2.0).abs() < 1e-12);
        // The second power falls faster: its limit is inside.
        let of_inertia = |v: f64| 10.0 + v * v;
        let change = of_inertia(0.5) - of_inertia(1.0);
        assert!(of_inertia(1.0) - bias(change, REACH_SPEED)[0] < 10.0);
    }

    #[test]
    fn squares_of_each_side_add_up() {
        let parts = vec![part(ErrorSource::Mesh, [3.0, 3.0]), part(ErrorSource::Domain, [4.0, 0.0])];
        let interval = combined(100.0, 50.0, parts);
        assert_eq!(interval.interval, [95.0, 103.0]);
        assert_eq!((interval.half_width, interval.relative_half_width), (4.0, Some(0.08)));
        assert_eq!(interval.dominated_by, Some(ErrorSource::Domain));
        assert_eq!(interval.contributions[0].relative, Some(0.06));
        assert!(interval.is_complete);
    }

    #[test]
    fn what_was_not_examined_is_not_silently_nothing() {
        let missing = Contribution { status: Status::NotExamined, ..Contribution::default() };
        let interval = combined(1.0, 1.0, vec![missing]);
        assert!(!interval.is_complete && interval.dominated_by.is_none());
        let left_out = Contribution { status: Status::NotApplicable, ..Contribution::default() };
        assert!(combined(1.0, 1.0, vec![left_out]).is_complete);
        assert_eq!(combined(0.0, 0.0, vec![part(ErrorSource::Mesh, [1.0; 2])]).relative_half_width, None);
    }
}
