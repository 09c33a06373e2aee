//! The steady window at the end of a run: its samples, their averages, and the noise of the drag.

use super::BodySample;
use super::reference::Reference;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Width of the moving average about which the noise is measured, over the reference length d.
pub const NOISE_WIDTH: f64 = 0.02;
/// Least number of samples in the moving average; with fewer the noise would vanish by construction.
pub const NOISE_SAMPLES: usize = 5;
/// Ratio of drag to vertical force below which a body that is not towed has no noticeable drag.
pub(crate) const NO_DRAG: f64 = 1e-3;
/// Part of the whole force on a body with which a smaller component is compared: relative to itself, what is almost zero is all noise.
pub const LEAST_SCALE: f64 = 0.1;
/// Part of the reference force γ t d² below which a force is none: the weight of the soil in some cells.
const NO_FORCE: f64 = 1e-4;
/// Displacement over the reference length below which a body does not count as towed.
const NO_TOW: f64 = 1e-3;

/// Averages over the steady window; `null` in JSON where there is nothing to average.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Steady {
    /// Displacement at which the window begins [m].
    pub from_m: Option<f64>,
    /// Displacement at which it ends [m].
    pub to_m: Option<f64>,
    /// Time at which it begins [s].
    pub from_s: Option<f64>,
    /// Time at which it ends [s].
    pub to_s: Option<f64>,
    /// Mean drag F_H [N].
    #[serde(rename = "drag_N")]
    pub drag: Option<f64>,
    /// Mean vertical force F_V [N].
    #[serde(rename = "vertical_N")]
    pub vertical: Option<f64>,
    /// Mean lateral force [N].
    #[serde(rename = "lateral_N")]
    pub lateral: Option<f64>,
    /// Mean moments of the soil about the axes of space through the reference point [N m].
    #[serde(rename = "moment_Nm")]
    pub moment: Option<[f64; 3]>,
    /// Mean drag of the water against the tow [N], not part of `drag`; `null` on dry ground.
    #[serde(rename = "water_drag_N")]
    pub water_drag: Option<f64>,
    /// Mean portions of `drag` and `vertical` that excess pore pressure exerts [N]; `null` where none is computed.
    #[serde(rename = "pore_pressure_N")]
    pub pore_pressure: Option<[f64; 2]>,
    /// Mean sinkage [m].
    #[serde(rename = "sinkage_m")]
    pub sinkage: Option<f64>,
    /// Mean turn ratio ω r / v, from the mean rotation rate and speed.
    pub turn_ratio: Option<f64>,
    /// The corresponding slip: 1 − v/(ωr) where ωr > v, otherwise ωr/v − 1.
    pub slip: Option<f64>,
    /// Mean torque about the axle [N m].
    #[serde(rename = "axle_torque_Nm")]
    pub axle_torque: Option<f64>,
    /// What it costs to move the body, and what it pulls.
    pub traction: Traction,
    /// Scatter of the drag: root mean square of the drag less its moving average over 0.02 d (at least five samples),
    /// over [`Steady::drag_scale`].
    pub drag_noise: Option<f64>,
    /// Whether drag and sinkage change by less than their limits over the window; `null` without a tow, and of too few samples.
    pub is_steady: Option<bool>,
    /// Interval of the mean drag [N] from a mesh study; `null` where only one mesh was run, as are the next three.
    #[serde(rename = "drag_N_interval")]
    pub drag_interval: Option<[f64; 2]>,
    /// Interval of the mean vertical force [N].
    #[serde(rename = "vertical_N_interval")]
    pub vertical_interval: Option<[f64; 2]>,
    /// Interval of the mean sinkage [m].
    #[serde(rename = "sinkage_m_interval")]
    pub sinkage_interval: Option<[f64; 2]>,
    /// Interval of the mean turn ratio.
    pub turn_ratio_interval: Option<[f64; 2]>,
}

impl Steady {
    /// What a component of the force on the body is compared with [N]: itself, or a tenth of the whole force where that is larger.
    #[must_use]
    pub fn scale(&self, component: Option<f64>) -> f64 {
        component.unwrap_or(0.0).abs().max(LEAST_SCALE * self.whole_force())
    }

    /// What the drag is compared with [N]: as any component, or the thrust of a body that turns, torque over radius, where that is
    /// larger: its pull is the difference of thrust and resistance.
    #[must_use]
    pub fn drag_scale(&self, reference: &Reference) -> f64 {
        let turning = reference.radius.filter(|_| reference.turns);
        let thrust = turning.zip(self.axle_torque).map_or(0.0, |(radius, torque)| (torque / radius).abs());
        let least = NO_FORCE * reference.force().unwrap_or(0.0);
        self.scale(self.drag).max(thrust).max(least)
    }

    /// Magnitude of the mean force [N].
    #[must_use]
    pub fn whole_force(&self) -> f64 {
        let force = [self.drag, self.vertical, self.lateral].map(Option::unwrap_or_default);
        force.iter().map(|f| f * f).sum::<f64>().sqrt()
    }
}

/// Steady means of what it costs to move a body through the soil, and of what a driven body pulls; `null` in JSON where there is none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Traction {
    /// Drawbar pull [N]: −F_H, what the soil pushes the body forwards with, less its weight along a slope; negative where it resists.
    #[serde(rename = "drawbar_pull_N")]
    pub drawbar_pull: Option<f64>,
    /// Specific resistance F_H/F_V: drag over the vertical force.
    pub specific_resistance: Option<f64>,
    /// Drag over the width of the body across the tow, of one that consists of several over the sum of theirs [N/m].
    #[serde(rename = "drag_per_width_N_m")]
    pub drag_per_width: Option<f64>,
    /// Power that moves the body against its drag, F_H v [W].
    #[serde(rename = "tow_power_W")]
    pub tow_power: Option<f64>,
    /// Power that turns the body against the torque of the soil, −M ω [W].
    #[serde(rename = "axle_power_W")]
    pub axle_power: Option<f64>,
    /// Tractive efficiency of a driven body: power of −F_H over that of its axle; on a slope climbing counts.
    pub tractive_efficiency: Option<f64>,
}

impl Traction {
    /// From the means of drag and vertical force [N], of the power of the tow and of the axle [W].
    fn of(reference: &Reference, [drag, vertical, tow_power, axle_power]: [Option<f64>; 4]) -> Self {
        // What would be a thousandfold is a quotient of almost nothing.
        let over = |a: Option<f64>, b: Option<f64>| {
            a.zip(b).filter(|(a, b)| *b > NO_DRAG * a.abs()).map(|(a, b)| a / b)
        };
        let axle_power = axle_power.filter(|_| reference.turns);
        Self {
            drawbar_pull: drag.map(|drag| 0.0 - drag - reference.weight_along.unwrap_or(0.0)),
            specific_resistance: over(drag, vertical),
            drag_per_width: drag.and_then(|drag| finite(drag / reference.across)),
            tow_power,
            axle_power,
            tractive_efficiency: over(tow_power.map(|power| -power).filter(|power| *power > 0.0), axle_power),
        }
    }
}

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
#[must_use]
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

/// The samples from the first that has passed `begin` to the first that has reached `end`: a body that stops before the end
/// of the run is no longer towed, and the rest is cut off. `span` is the whole way, with its sign.
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

/// The samples of the steady window: the last fraction of the tow, or of the time for a body that is not towed.
#[must_use]
pub fn window(samples: &[BodySample], reference: &Reference, part: impl Into<SteadyPart>) -> Range<usize> {
    let SteadyPart { fraction, during } = part.into();
    let [from, to] = during.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    // A stage begins with the sample that ended the one before.
    let first = samples.partition_point(|sample| sample.time < from);
    let last = samples.partition_point(|sample| sample.time <= to).max(first);
    let along = along(&samples[first..last], reference);
    let (Some(begin), Some(end)) = (along.first(), along.last()) else { return 0..0 };
    let span = end - begin;
    let inside = between(&along, [end - fraction.clamp(0.0, 1.0) * span, *end], span);
    first + inside.start..first + inside.end
}

/// The samples of the same body in another run over the window that `other` was averaged over; `None` where the body has not
/// come that far, but for one per cent of the window and the distance of two samples.
#[must_use]
pub fn same_window(samples: &[BodySample], reference: &Reference, other: &Steady) -> Option<Range<usize>> {
    let [begin, end] =
        if is_tow(samples, reference) { [other.from_m?, other.to_m?] } else { [other.from_s?, other.to_s?] };
    let along = along(samples, reference);
    let (span, length) = (along.last()? - along.first()?, (end - begin).abs());
    // Samples of two runs do not lie at the same places to the last digit.
    let begin = begin - 1e-6 * span;
    let range = between(&along, [begin, end], span);
    let (first, last) = (along.get(range.start)?, along.get(range.end.checked_sub(1)?)?);
    let spacing = (last - first).abs() / (range.len().max(2) - 1) as f64;
    let covers = (first - begin).abs().max((last - end).abs()) <= 0.01 * length + spacing;
    covers.then_some(range)
}

/// Averages over the samples of `window`. Each sample is weighted by the interval that it averages over.
#[must_use]
pub fn steady(samples: &[BodySample], reference: &Reference, window: Range<usize>) -> Steady {
    let Some(inside) = samples.get(window.clone()).filter(|inside| !inside.is_empty()) else {
        return Steady::default();
    };
    let weights = weights(samples, window);
    let mean = |value: fn(&BodySample) -> f64| {
        let sum: f64 = inside.iter().zip(&weights).map(|(s, w)| value(s) * w).sum();
        finite(sum / weights.iter().sum::<f64>())
    };
    let drag = mean(|s| s.drag);
    let vertical = mean(|s| s.vertical);
    let (first, last) = (&inside[0], &inside[inside.len() - 1]);
    let turn_ratio = mean(|s| s.spin)
        .zip(mean(|s| s.rolling_speed))
        .and_then(|(spin, speed)| reference.turn_ratio(spin, speed));
    let mut steady = Steady {
        from_m: finite(first.displacement),
        to_m: finite(last.displacement),
        from_s: finite(first.time),
        to_s: finite(last.time),
        drag,
        vertical,
        lateral: mean(|s| s.lateral),
        moment: mean(|s| s.moment_x)
            .zip(mean(|s| s.moment_y))
            .zip(mean(|s| s.moment_z))
            .map(|((x, y), z)| [x, y, z]),
        water_drag: mean(|s| s.water_drag).filter(|drag| *drag != 0.0),
        pore_pressure: mean(|s| s.pore_drag)
            .zip(mean(|s| s.pore_vertical))
            .map(|(drag, vertical)| [drag, vertical])
            .filter(|force| *force != [0.0; 2]),
        sinkage: mean(|s| s.sinkage),
        turn_ratio,
        slip: turn_ratio.map(analytic::slip),
        axle_torque: mean(|s| s.axle_torque),
        traction: Traction::of(
            reference,
            [drag, vertical, mean(|s| s.drag * s.speed), mean(|s| -s.axle_torque * s.spin)],
        ),
        // The rest is filled in below, from the grade of the run, and from a mesh study.
        ..Steady::default()
    };
    // The drag of a body that is only pushed down is almost zero, and means nothing.
    let has_drag =
        |drag: &f64| is_tow(samples, reference) || drag.abs() > NO_DRAG * vertical.unwrap_or(0.0).abs();
    let scale = steady.drag_scale(reference);
    steady.drag_noise = drag.filter(has_drag).and_then(|_| noise(inside, reference, scale));
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

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}

/// Moving average of `values` centred on each sample over a width of `width` along `along`, at least
/// [`NOISE_SAMPLES`] samples. Centred and symmetric, hence without phase shift; shorter at the ends.
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
#[must_use]
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
        assert_eq!(window(&samples, &disc(), 0.3), 700..1001);
        // Resting at the end does not count.
        let last = samples[1000];
        samples.extend((1..500).map(|n| BodySample { time: last.time + f64::from(n), drag: 0.0, ..last }));
        assert_eq!(window(&samples, &disc(), 0.3), 700..1001);
        let result = steady(&samples, &disc(), 700..1001);
        assert!((result.drag.unwrap() - 5.0).abs() < 1e-12);
        assert!((result.turn_ratio.unwrap() - 0.9).abs() < 1e-12);
        assert!(result.drag_noise.unwrap() < 1e-12);
    }

    #[test]
    fn another_run_is_averaged_over_the_same_window() {
        let samples = tow(1001, |_| 5.0);
        let own = steady(&samples, &disc(), window(&samples, &disc(), 0.3));
        // Twice as many samples over the same way, and twice the way.
        let fine: Vec<BodySample> = (0..2001)
            .map(|n| BodySample {
                time: 0.005 * f64::from(n),
                displacement: 5e-4 * f64::from(n),
                ..samples[0]
            })
            .collect();
        assert_eq!(same_window(&fine, &disc(), &own), Some(1400..2001));
        assert_eq!(same_window(&tow(2001, |_| 5.0), &disc(), &own), Some(700..1001));
        assert_eq!(same_window(&samples, &disc(), &own), Some(700..1001));
        assert_eq!(same_window(&tow(900, |_| 5.0), &disc(), &own), None);
        assert_eq!(same_window(&[], &disc(), &own), None);
    }

    #[test]
    fn noise_is_the_scatter_and_not_the_trend() {
        let rough = tow(2001, |t| 100.0 + t + 10.0 * (t * 400.0).sin());
        let range = window(&rough, &disc(), 0.5);
        let noise = steady(&rough, &disc(), range).drag_noise.unwrap();
        let expected = 10.0 / 2.0_f64.sqrt() / 115.0;
        assert!((noise / expected - 1.0).abs() < 0.15, "{noise} against {expected}");
    }

    #[test]
    fn empty_and_invalid_histories_are_handled() {
        assert_eq!(window(&[], &disc(), 0.3), 0..0);
        assert_eq!(steady(&[], &disc(), 0..0), Steady::default());
        let broken = vec![BodySample { drag: f64::NAN, time: f64::NAN, ..Default::default() }; 3];
        let range = window(&broken, &disc(), 0.3);
        assert_eq!(steady(&broken, &disc(), range).drag, None);
        assert_eq!(peak(&broken).drag, None);
        assert!(moving_average(&[f64::NAN; 4], &[f64::NAN; 4], 1.0).iter().all(|v| v.is_finite()));
    }
}
