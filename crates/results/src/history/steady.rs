//! The steady window at the end of a run: its samples, their averages, and the noise of the drag.

use super::quantities::{BodySample, FORCES, NO_DRAG, Quantity, Steady, Traction, finite};
use super::reference::Reference;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Width of the moving average about which the noise is measured, over the reference length d.
pub(crate) const NOISE_WIDTH: f64 = 0.02;
/// Least number of samples in the moving average; with fewer the noise would vanish by construction.
pub(crate) const NOISE_SAMPLES: usize = 5;
/// Displacement over the reference length below which a body does not count as towed.
const NO_TOW: f64 = 1e-3;

/// Largest values of a run, with their sign; `null` in JSON where there is none.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Peak {
    /// Largest drag F_H [N].
    #[serde(rename = "drag_N")]
    pub drag: Option<f64>,
    /// Displacement at which the drag is largest [m].
    pub at_m: Option<f64>,
    /// Time at which the drag is largest [s].
    pub at_s: Option<f64>,
    /// Largest vertical force F_V [N].
    #[serde(rename = "vertical_N")]
    pub vertical: Option<f64>,
    /// Largest sinkage [m].
    #[serde(rename = "sinkage_m")]
    pub sinkage: Option<f64>,
    /// Largest torque about the axle [N m].
    #[serde(rename = "axle_torque_Nm")]
    pub axle_torque: Option<f64>,
    /// Largest volume of soil inside the body [m³].
    pub leaked_m3: Option<f64>,
}

/// Whether the body moves along x far enough for displacement to be the abscissa of its plots and averages.
pub fn is_tow(samples: &[BodySample], reference: &Reference) -> bool {
    let travel = extent(samples.iter().map(|s| s.displacement));
    travel > NO_TOW * reference.length
}

fn extent(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) = values
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    (high - low).max(0.0)
}

/// Displacement [m] of a body that is towed, otherwise time [s].
fn along(samples: &[BodySample], reference: &Reference) -> Vec<f64> {
    if is_tow(samples, reference) {
        samples.iter().map(|s| s.displacement).collect()
    } else {
        samples.iter().map(|s| s.time).collect()
    }
}

/// The samples from the first that has passed `begin` to the first that has reached `end`: a body that stops
/// before the end of the run is no longer towed, and the rest is cut off. `span` is the whole way, with its
/// sign.
fn between(along: &[f64], [begin, end]: [f64; 2], span: f64) -> Range<usize> {
    let passed = |x: f64, at: f64| if span >= 0.0 { x >= at } else { x <= at };
    let last = along.iter().position(|x| passed(*x, end - 1e-6 * span)).map_or(along.len(), |n| n + 1);
    let from = along.iter().position(|x| passed(*x, begin)).unwrap_or(0);
    from.min(last.saturating_sub(1))..last
}

/// Which part of a run averages are taken over: the last fraction of all of it, or of some times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyPart {
    /// Fraction of the tow, at its end.
    pub fraction: f64,
    /// From when to when the tow is looked at [s]; `None` for the whole run.
    pub during: Option<[f64; 2]>,
}

impl From<f64> for SteadyPart {
    fn from(fraction: f64) -> Self {
        Self { fraction, during: None }
    }
}

/// A body of a run over its steady window: the last fraction of the tow, or of the time for a body that is
/// not towed.
#[derive(Clone, Debug)]
pub struct SteadyWindow<'a> {
    /// The reference quantities of the body.
    pub reference: &'a Reference,
    /// Samples of the body over the whole run.
    pub samples: &'a [BodySample],
    /// Indices of the samples that lie in the window.
    pub range: Range<usize>,
    /// Means of these samples.
    pub steady: Steady,
}

impl<'a> SteadyWindow<'a> {
    /// The window at the end of a run, or of a part of it.
    pub fn of(samples: &'a [BodySample], reference: &'a Reference, part: impl Into<SteadyPart>) -> Self {
        let SteadyPart { fraction, during } = part.into();
        let [from, to] = during.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        // A stage begins with the sample that ended the one before.
        let first = samples.partition_point(|sample| sample.time < from);
        let last = samples.partition_point(|sample| sample.time <= to).max(first);
        let along = along(&samples[first..last], reference);
        let (Some(begin), Some(end)) = (along.first(), along.last()) else {
            return Self::over(samples, reference, 0..0);
        };
        let span = end - begin;
        let inside = between(&along, [end - fraction.clamp(0.0, 1.0) * span, *end], span);
        Self::over(samples, reference, first + inside.start..first + inside.end)
    }

    /// The window of another run that `other` was averaged over; `None` where the body has not come that far,
    /// but for one per cent of the window and the distance of two samples.
    #[must_use]
    pub fn same(samples: &'a [BodySample], reference: &'a Reference, other: &Steady) -> Option<Self> {
        let [begin, end] = if is_tow(samples, reference) {
            [other.from_m?, other.to_m?]
        } else {
            [other.from_s?, other.to_s?]
        };
        let along = along(samples, reference);
        let (span, length) = (along.last()? - along.first()?, (end - begin).abs());
        // Samples of two runs do not lie at the same places to the last digit.
        let begin = begin - 1e-6 * span;
        let range = between(&along, [begin, end], span);
        let (first, last) = (along.get(range.start)?, along.get(range.end.checked_sub(1)?)?);
        let spacing = (last - first).abs() / (range.len().max(2) - 1) as f64;
        let covers = (first - begin).abs().max((last - end).abs()) <= 0.01 * length + spacing;
        covers.then(|| Self::over(samples, reference, range))
    }

    /// A window of these samples.
    pub(crate) fn over(samples: &'a [BodySample], reference: &'a Reference, range: Range<usize>) -> Self {
        Self { reference, samples, steady: steady(samples, reference, range.clone()), range }
    }

    /// The samples of the window.
    #[must_use]
    pub fn inside(&self) -> &'a [BodySample] {
        self.samples.get(self.range.clone()).unwrap_or_default()
    }

    /// Whether the body is towed: [`is_tow`].
    pub(crate) fn is_towed(&self) -> bool {
        is_tow(self.samples, self.reference)
    }
}

/// Averages over the samples of `window`. Each sample is weighted by the interval that it averages over.
fn steady(samples: &[BodySample], reference: &Reference, window: Range<usize>) -> Steady {
    let Some(inside) = samples.get(window.clone()).filter(|inside| !inside.is_empty()) else {
        return Steady::default();
    };
    let weights = weights(samples, window);
    let mean = |value: &dyn Fn(&BodySample) -> f64| {
        let sum: f64 = inside.iter().zip(&weights).map(|(s, w)| value(s) * w).sum();
        sum / weights.iter().sum::<f64>()
    };
    let mut means = BodySample::default();
    for place in FORCES.iter().filter_map(|column| column.source.place()) {
        *place(&mut means) = mean(&|s| *place(&mut { *s }));
    }
    let (first, last) = (&inside[0], &inside[inside.len() - 1]);
    let are_finite = |numbers: &[f64]| numbers.iter().all(|number| number.is_finite());
    let pore_pressure = [means.pore_drag, means.pore_vertical];
    let mut steady = Steady {
        from_m: finite(first.displacement),
        to_m: finite(last.displacement),
        from_s: finite(first.time),
        to_s: finite(last.time),
        moment: Some([means.moment_x, means.moment_y, means.moment_z]).filter(|moment| are_finite(moment)),
        water_drag: finite(means.water_drag).filter(|drag| *drag != 0.0),
        pore_pressure: Some(pore_pressure).filter(|force| are_finite(force) && *force != [0.0; 2]),
        // The rest is filled in below, from the grade of the run.
        ..Steady::default()
    };
    // A ratio is that of the means.
    for quantity in Quantity::all() {
        *(quantity.figure.mean)(&mut steady) = finite(quantity.column.value(&means, reference));
    }
    steady.slip = steady.turn_ratio.map(analytic::slip);
    let powers = [mean(&|s| s.drag * s.speed), mean(&|s| -s.axle_torque * s.spin)].map(finite);
    steady.traction = Traction::of(reference, [steady.drag, steady.vertical, powers[0], powers[1]]);
    // The drag of a body that is only pushed down is almost zero, and means nothing.
    let has_drag = |drag: &f64| {
        is_tow(samples, reference) || drag.abs() > NO_DRAG * steady.vertical.unwrap_or(0.0).abs()
    };
    let scale = steady.drag_scale(reference);
    steady.drag_noise = steady.drag.filter(has_drag).and_then(|_| noise(inside, reference, scale));
    steady
}

/// Interval of each sample of the window; equal weights if all intervals vanish.
fn weights(samples: &[BodySample], window: Range<usize>) -> Vec<f64> {
    let interval = |n: usize| if n == 0 { 0.0 } else { (samples[n].time - samples[n - 1].time).max(0.0) };
    let weights: Vec<f64> = window.map(interval).collect();
    if weights.iter().sum::<f64>() > 0.0 { weights } else { vec![1.0; weights.len()] }
}

fn noise(inside: &[BodySample], reference: &Reference, scale: f64) -> Option<f64> {
    let drag: Vec<f64> = inside.iter().map(|s| s.drag).collect();
    let (along, width): (Vec<f64>, f64) = if is_tow(inside, reference) {
        (inside.iter().map(|s| s.displacement).collect(), NOISE_WIDTH * reference.length)
    } else {
        (inside.iter().map(|s| s.time).collect(), 0.0)
    };
    let smooth = moving_average(&along, &drag, width);
    let square: f64 = drag.iter().zip(&smooth).map(|(f, s)| (f - s).powi(2)).sum::<f64>() / drag.len() as f64;
    finite(square.sqrt() / scale)
}

/// Moving average of `values` centred on each sample over a width of `width` along `along`, at least
/// `NOISE_SAMPLES` samples. Centred and symmetric, hence without phase shift; shorter at the ends.
#[must_use]
pub fn moving_average(along: &[f64], values: &[f64], width: f64) -> Vec<f64> {
    let count = along.len().min(values.len());
    let mut sums = vec![0.0; count + 1];
    for n in 0..count {
        sums[n + 1] = sums[n] + if values[n].is_finite() { values[n] } else { 0.0 };
    }
    let mut reach = 0;
    (0..count)
        .map(|n| {
            let limit = n.min(count - 1 - n);
            let fits = |r: usize| (along[n + r] - along[n - r]).abs() <= width;
            // The half width changes little from sample to sample: grow or shrink the previous one.
            reach = reach.min(limit);
            while reach < limit && fits(reach + 1) {
                reach += 1;
            }
            while reach > 0 && !fits(reach) {
                reach -= 1;
            }
            let reach = reach.max(NOISE_SAMPLES / 2).min(limit);
            (sums[n + reach + 1] - sums[n - reach]) / (2 * reach + 1) as f64
        })
        .collect()
}

/// Largest values of a history.
pub fn peak(samples: &[BodySample]) -> Peak {
    let largest = |value: fn(&BodySample) -> f64| {
        samples
            .iter()
            .filter(|s| value(s).is_finite())
            .max_by(|a, b| value(a).abs().total_cmp(&value(b).abs()))
    };
    let drag = largest(|s| s.drag);
    Peak {
        drag: drag.map(|s| s.drag),
        at_m: drag.map(|s| s.displacement),
        at_s: drag.map(|s| s.time),
        vertical: largest(|s| s.vertical).map(|s| s.vertical),
        sinkage: samples.iter().map(|s| s.sinkage).filter(|z| z.is_finite()).max_by(f64::total_cmp),
        axle_torque: largest(|s| s.axle_torque).map(|s| s.axle_torque),
        leaked_m3: largest(|s| s.leaked_volume).map(|s| s.leaked_volume),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn disc() -> Reference {
        Reference {
            name: "disc".into(),
            kind: "disc".into(),
            length: 0.2,
            width: 0.04,
            across: 0.04,
            unit_weight: 16e3,
            radius: Some(0.1),
            towed: true,
            turns: true,
            ..Reference::default()
        }
    }

    #[test]
    fn a_driven_wheel_pulls_with_an_efficiency() {
        let driven = |n: u32| BodySample {
            time: f64::from(n),
            displacement: 0.1 * f64::from(n),
            speed: 0.1,
            spin: 2.0,
            drag: -30.0,
            vertical: 100.0,
            axle_torque: -5.0,
            ..BodySample::default()
        };
        let samples: Vec<_> = (0..20).map(driven).collect();
        let Traction {
            drawbar_pull,
            specific_resistance,
            drag_per_width,
            tow_power,
            axle_power,
            tractive_efficiency,
        } = steady(&samples, &disc(), 0..20).traction;
        assert_eq!([drawbar_pull, specific_resistance], [Some(30.0), Some(-0.3)]);
        assert!((drag_per_width.unwrap() + 750.0).abs() < 1e-9);
        assert!((tow_power.unwrap() + 3.0).abs() < 1e-12 && (axle_power.unwrap() - 10.0).abs() < 1e-12);
        assert!((tractive_efficiency.unwrap() - 0.3).abs() < 1e-12);
        let towed: Vec<_> = samples.iter().map(|s| BodySample { drag: 30.0, ..*s }).collect();
        assert_eq!(steady(&towed, &disc(), 0..20).traction.tractive_efficiency, None);
        // On a slope its weight is to be carried as well.
        let climbs = Reference { weight_along: Some(52.0), ..disc() };
        assert_eq!(steady(&samples, &climbs, 0..20).traction.drawbar_pull, Some(-22.0));
    }

    fn tow(count: usize, drag: impl Fn(f64) -> f64) -> Vec<BodySample> {
        (0..count)
            .map(|n| {
                let time = n as f64 * 0.01;
                BodySample {
                    time,
                    displacement: 0.1 * time,
                    speed: 0.1,
                    rolling_speed: 0.1,
                    spin: 0.9,
                    drag: drag(time),
                    ..Default::default()
                }
            })
            .collect()
    }

    #[test]
    fn the_window_is_the_last_fraction_of_the_tow() {
        let mut samples = tow(1001, |_| 5.0);
        assert_eq!(SteadyWindow::of(&samples, &disc(), 0.3).range, 700..1001);
        // Resting at the end does not count.
        let last = samples[1000];
        samples.extend((1..500).map(|n| BodySample { time: last.time + f64::from(n), drag: 0.0, ..last }));
        assert_eq!(SteadyWindow::of(&samples, &disc(), 0.3).range, 700..1001);
        let result = steady(&samples, &disc(), 700..1001);
        assert!((result.drag.unwrap() - 5.0).abs() < 1e-12);
        assert!((result.turn_ratio.unwrap() - 0.9).abs() < 1e-12);
        assert!(result.drag_noise.unwrap() < 1e-12);
    }

    #[test]
    fn another_run_is_averaged_over_the_same_window() {
        let samples = tow(1001, |_| 5.0);
        let own = steady(&samples, &disc(), SteadyWindow::of(&samples, &disc(), 0.3).range);
        // Twice as many samples over the same way, and twice the way.
        let fine: Vec<BodySample> = (0..2001)
            .map(|n| BodySample {
                time: 0.005 * f64::from(n),
                displacement: 5e-4 * f64::from(n),
                ..samples[0]
            })
            .collect();
        assert_eq!(SteadyWindow::same(&fine, &disc(), &own).map(|w| w.range), Some(1400..2001));
        assert_eq!(SteadyWindow::same(&tow(2001, |_| 5.0), &disc(), &own).map(|w| w.range), Some(700..1001));
        assert_eq!(SteadyWindow::same(&samples, &disc(), &own).map(|w| w.range), Some(700..1001));
        assert_eq!(SteadyWindow::same(&tow(900, |_| 5.0), &disc(), &own).map(|w| w.range), None);
        assert_eq!(SteadyWindow::same(&[], &disc(), &own).map(|w| w.range), None);
    }

    #[test]
    fn noise_is_the_scatter_and_not_the_trend() {
        let rough = tow(2001, |t| 100.0 + t + 10.0 * (t * 400.0).sin());
        let range = SteadyWindow::of(&rough, &disc(), 0.5).range;
        let noise = steady(&rough, &disc(), range).drag_noise.unwrap();
        let expected = 10.0 / 2.0_f64.sqrt() / 115.0;
        assert!((noise / expected - 1.0).abs() < 0.15, "{noise} against {expected}");
    }

    #[test]
    fn empty_and_invalid_histories_are_handled() {
        assert_eq!(SteadyWindow::of(&[], &disc(), 0.3).range, 0..0);
        assert_eq!(steady(&[], &disc(), 0..0), Steady::default());
        let broken = vec![BodySample { drag: f64::NAN, time: f64::NAN, ..Default::default() }; 3];
        let range = SteadyWindow::of(&broken, &disc(), 0.3).range;
        assert_eq!(steady(&broken, &disc(), range).drag, None);
        assert_eq!(peak(&broken).drag, None);
        assert!(moving_average(&[f64::NAN; 4], &[f64::NAN; 4], 1.0).iter().all(|v| v.is_finite()));
    }
}
