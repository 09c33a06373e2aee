//! Amplitudes as the courses that a motion of a case can take.

use deck::model::Amplitude;

/// An amplitude over the time of a step, in units of the deck.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Course {
    /// The same throughout.
    Constant(f64),
    /// Smooth from 0 to a value.
    Smooth { start: f64, ramp: f64, to: f64 },
    /// Straight from 0 to a value, and constant before and after.
    Straight { start: f64, ramp: f64, to: f64 },
    /// Straight lines between points, or smooth ones taken in small pieces.
    Points { points: Vec<[f64; 2]>, is_smooth: bool },
}

/// Pieces of each smooth step in a table.
const PIECES: u32 = 16;

/// Points of the fastest swing in a table, and most of a table.
const PER_SWING: f64 = 32.0;
const MOST: f64 = 100_000.0;

/// The course of an amplitude in a step that begins at `begin` and lasts `duration`; `None` where it swings
/// too often for a table.
pub(super) fn course(amplitude: &Amplitude, begin: f64, duration: f64) -> Option<Course> {
    let shift = if amplitude.is_total_time { begin } else { 0.0 };
    if let Some(periodic) = &amplitude.periodic {
        let swings = periodic.frequency * periodic.terms.len() as f64 * duration / std::f64::consts::TAU;
        let count = (swings * PER_SWING).ceil().max(PER_SWING);
        let times = (0..=count as u32).map(|n| duration * f64::from(n) / count);
        let points = || times.map(|time| [time, periodic.value(time + shift)]).collect();
        return (count <= MOST).then(|| Course::Points { points: points(), is_smooth: true });
    }
    let is_smooth = amplitude.definition == "SMOOTH STEP";
    let points: Vec<[f64; 2]> = amplitude.points.iter().map(|[time, value]| [time - shift, *value]).collect();
    Some(match points[..] {
        [[_, first], .., [_, last]] if points.iter().all(|[_, value]| *value == first) => {
            Course::Constant(last)
        }
        [[start, 0.0], [end, to]] if start >= 0.0 => {
            let ramp = end - start;
            if is_smooth { Course::Smooth { start, ramp, to } } else { Course::Straight { start, ramp, to } }
        }
        _ => {
            let all = if is_smooth { rounded(&points) } else { points };
            Course::Points { points: clipped(&all, duration), is_smooth }
        }
    })
}

/// The fifth-order steps between points, τ³(10 − 15τ + 6τ²), in small pieces.
fn rounded(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut all: Vec<[f64; 2]> = points.first().copied().into_iter().collect();
    for pair in points.windows(2) {
        let [[t0, a0], [t1, a1]] = [pair[0], pair[1]];
        all.extend((1..=PIECES).map(|n| {
            let tau = f64::from(n) / f64::from(PIECES);
            [t0 + (t1 - t0) * tau, a0 + (a1 - a0) * tau.powi(3) * (10.0 - 15.0 * tau + 6.0 * tau * tau)]
        }));
    }
    all
}

/// The value at a time: before the first point the first, after the last the last.
pub(super) fn value(points: &[[f64; 2]], time: f64) -> f64 {
    let next = points.partition_point(|[at, _]| *at <= time);
    match (next.checked_sub(1).and_then(|n| points.get(n)), points.get(next)) {
        (Some([t0, a0]), Some([t1, a1])) => a0 + (a1 - a0) * (time - t0) / (t1 - t0),
        (Some([_, a]), None) | (None, Some([_, a])) => *a,
        (None, None) => 0.0,
    }
}

/// From 0 to the end of the step.
fn clipped(points: &[[f64; 2]], duration: f64) -> Vec<[f64; 2]> {
    let inner = points.iter().filter(|[time, _]| *time > 0.0 && *time < duration).copied();
    let ends = |time: f64| [time, value(points, time)];
    std::iter::once(ends(0.0)).chain(inner).chain([ends(duration)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn amplitude(definition: &str, points: &[[f64; 2]]) -> Amplitude {
        Amplitude {
            block: 0,
            definition: definition.to_owned(),
            is_total_time: false,
            points: points.to_vec(),
            periodic: None,
        }
    }

    #[test]
    fn courses_are_recognised() {
        let of = |definition, points: &[[f64; 2]]| course(&amplitude(definition, points), 0.0, 2.0).unwrap();
        assert_eq!(of("TABULAR", &[[0.0, 1.0], [9.0, 1.0]]), Course::Constant(1.0));
        assert_eq!(
            of("SMOOTH STEP", &[[0.0, 0.0], [0.1, 1.0]]),
            Course::Smooth { start: 0.0, ramp: 0.1, to: 1.0 }
        );
        assert_eq!(
            of("TABULAR", &[[0.5, 0.0], [1.0, 2.0]]),
            Course::Straight { start: 0.5, ramp: 0.5, to: 2.0 }
        );
        let points = vec![[0.0, 0.0], [1.0, 1.0], [2.0, 0.5]];
        assert_eq!(
            of("TABULAR", &[[0.0, 0.0], [1.0, 1.0], [3.0, 0.0]]),
            Course::Points { points, is_smooth: false }
        );
    }
}
