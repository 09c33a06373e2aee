//! The distribution of stress and slip along the rim of a body: sums over time, and their average over a
//! window.

use case::output_size::MOST_RIM_RECORDS;
use serde::{Deserialize, Serialize};
use solver::model::RimBin;
use solver::state::RimSums;

/// Normal stress over the largest along the rim below which a change of sign of the slip does not count
/// (chosen: at the ends of the contact a few grains slide one way and the other).
const LOADED: f64 = 0.02;
/// Slip over its largest magnitude along the rim up to which the soil sticks to the body (chosen).
const STICKING: f64 = 0.01;

/// The sums over one body's rim at one time.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RimRecord {
    /// Number of the sample.
    pub number: usize,
    /// Time [s].
    pub time: f64,
    /// Sums since the start over each bin, and last over the flanks; of the modelled portion, the impulse [N
    /// s] of the whole body, along its tow, across it and upwards.
    pub sums: Vec<RimSums>,
}

/// The sums over one body's rim in the course of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RimHistory {
    /// The bins of the rim, in the order of their arcs.
    pub bins: Vec<RimBin>,
    /// Portion of the body that is modelled.
    pub modelled_fraction: f64,
    /// Distance between the numbers of the records that are kept: a power of 2.
    pub stride: usize,
    /// The records; the last one is that of the last sample.
    pub records: Vec<RimRecord>,
}

/// Stress and slip in one bin of a rim, averaged over time and area; not-a-number where a number is not
/// defined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RimLine {
    /// Polar angle of the middle of the bin about the axle from straight below [rad].
    pub angle: f64,
    /// Distance of the middle of the bin from straight below along the outline [m].
    pub arc: f64,
    /// Position of the middle of the bin along x, from the reference point [m].
    pub x: f64,
    /// Position of the middle of the bin along z, from the reference point [m].
    pub z: f64,
    /// Area of the surface of the bin [m²].
    pub area: f64,
    /// Fraction of area and time in contact.
    pub contact: f64,
    /// Normal stress, positive in compression [Pa].
    pub normal_stress: f64,
    /// Shear stress of the soil on the body along the outline [Pa].
    pub shear_along: f64,
    /// Shear stress of the soil on the body along the axle [Pa].
    pub shear_lateral: f64,
    /// Shear stress of the soil on the body along the axle, away from the mid-plane [Pa].
    pub shear_outward: f64,
    /// Slip velocity of the body relative to the soil along the outline, while in contact [m/s].
    pub slip_along: f64,
    /// Slip velocity of the body relative to the soil along the axle, while in contact [m/s].
    pub slip_lateral: f64,
    /// Slip velocity of the body relative to the soil along the axle, away from the mid-plane, while in
    /// contact [m/s].
    pub slip_outward: f64,
    /// Friction over its limit, whatever its direction.
    pub mobilised: f64,
    /// Mean friction along the outline over the limit of friction, with its sign.
    pub mobilised_along: f64,
    /// Contribution to the drag [N].
    pub drag: f64,
    /// Contribution to the vertical force [N].
    pub vertical: f64,
}

/// A place on a rim where the slip along the outline changes its sign: from where it has fallen to a
/// hundredth of its largest magnitude to where it has risen to that again in the other direction. In between
/// the soil sticks to the body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SlipReversal {
    /// Polar angle about the axle at which the reversal begins, from straight below, positive towards the
    /// front [rad].
    pub from_rad: f64,
    /// Polar angle at which the reversal ends [rad].
    pub to_rad: f64,
    /// Arc along the outline at which the reversal begins [m].
    pub from_m: f64,
    /// Arc at which the reversal ends [m].
    pub to_m: f64,
}

/// A place on a rim.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RimPlace {
    /// Polar angle about the axle from straight below, positive towards the front [rad].
    pub angle_rad: f64,
    /// Arc along the outline [m].
    pub arc_m: f64,
}

/// The rim of a body, averaged over a window.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RimAverage {
    /// Begin and end of the window [s].
    pub window: [f64; 2],
    /// Bins of the rim, in the order of their arcs, without those that lie outside the grid.
    pub lines: Vec<RimLine>,
    /// Contribution of rim and flanks to the drag [N].
    pub drag: [f64; 2],
    /// Contribution of rim and flanks to the vertical force [N].
    pub vertical: [f64; 2],
    /// Friction on the rim over its limit.
    pub mobilised: f64,
}

impl RimHistory {
    /// The history of a rim that is about to begin.
    #[must_use]
    pub fn of(bins: &[RimBin], modelled_fraction: f64) -> Self {
        Self { bins: bins.to_vec(), modelled_fraction, stride: 1, records: Vec::new() }
    }

    /// Adds the record of a sample.
    pub fn push(&mut self, time: f64, sums: Vec<RimSums>) {
        let number = self.records.last().map_or(0, |last| last.number + 1);
        let stride = self.stride.max(1);
        if self.records.last().is_some_and(|last| !last.number.is_multiple_of(stride)) {
            self.records.pop();
        }
        self.records.push(RimRecord { number, time, sums });
        if self.records.len() > MOST_RIM_RECORDS {
            self.stride = 2 * stride;
            let (stride, last) = (self.stride, number);
            self.records.retain(|record| record.number.is_multiple_of(stride) || record.number == last);
        }
    }

    /// The average from a time to a later one [s], or rather between the records next to these; none where no
    /// time passes between them.
    #[must_use]
    pub fn average(&self, [from, to]: [f64; 2]) -> Option<RimAverage> {
        let begin = self.records.iter().rev().find(|record| record.time <= from).or(self.records.first())?;
        let end = self.records.iter().find(|record| record.time >= to).or(self.records.last())?;
        let duration = end.time - begin.time;
        let sums: Vec<_> = end.sums.iter().zip(&begin.sums).map(|(now, then)| now.since(then)).collect();
        let (flanks, rim) = sums.split_last()?;
        if duration <= 0.0 || rim.len() != self.bins.len() {
            return None;
        }
        let whole = 1.0 / self.modelled_fraction;
        let pairs = || self.bins.iter().zip(rim);
        let total = |of: fn(&RimSums) -> f64| rim.iter().map(of).sum::<f64>();
        let drag = |s: &RimSums| 0.0 - s.impulse.x / duration;
        let vertical = |s: &RimSums| s.impulse.z / duration;
        Some(RimAverage {
            window: [begin.time, end.time],
            lines: pairs()
                .filter(|(bin, _)| bin.area > 0.0)
                .map(|(bin, sums)| line(bin, sums, duration, whole))
                .collect(),
            drag: [rim.iter().map(drag).sum(), drag(flanks)],
            vertical: [rim.iter().map(vertical).sum(), vertical(flanks)],
            mobilised: ratio(total(|s| s.friction), total(|s| s.friction_limit)),
        })
    }
}

/// Friction over its limit; not a number where there is none, as on a rough body.
fn ratio(friction: f64, limit: f64) -> f64 {
    if limit.is_finite() { friction / limit } else { f64::NAN }
}

fn line(bin: &RimBin, sums: &RimSums, duration: f64, whole: f64) -> RimLine {
    let stress = |impulse: f64| impulse / (bin.area * duration);
    let [shear_along, shear_lateral, shear_outward] = sums.shear.map(stress);
    let [slip_along, slip_lateral, slip_outward] = sums.slip.map(|slip| slip / sums.contact);
    RimLine {
        angle: bin.middle.angle,
        arc: bin.middle.arc,
        x: bin.middle.x,
        z: bin.middle.z,
        area: bin.area * whole,
        contact: sums.contact / (bin.area * duration),
        normal_stress: stress(sums.normal),
        shear_along,
        shear_lateral,
        shear_outward,
        slip_along,
        slip_lateral,
        slip_outward,
        mobilised: ratio(sums.friction, sums.friction_limit),
        mobilised_along: ratio(sums.shear[0], sums.friction_limit),
        drag: 0.0 - sums.impulse.x / duration,
        vertical: sums.impulse.z / duration,
    }
}

/// Where the slip along the outline changes its sign, in a stretch of bins that are all loaded: there the
/// zones of flow meet under a body that turns.
#[must_use]
pub fn slip_reversals(lines: &[RimLine]) -> Vec<SlipReversal> {
    let is_loaded = loaded(lines);
    let largest = lines.iter().filter(|l| is_loaded(l)).map(|l| l.slip_along.abs()).fold(0.0, f64::max);
    let (mut reversals, mut last): (Vec<_>, Option<usize>) = (Vec::new(), None);
    for (n, line) in lines.iter().enumerate() {
        if !is_loaded(line) {
            last = None;
        } else if line.slip_along.abs() > STICKING * largest {
            if let Some(before) = last.filter(|before| lines[*before].slip_along * line.slip_along < 0.0) {
                let [from, to] = [[before, before + 1], [n, n - 1]]
                    .map(|ends| ends.map(|n| &lines[n]))
                    .map(|[a, b]| falls_to(STICKING * largest, a.slip_along, b.slip_along, [a, b]));
                reversals.push(SlipReversal {
                    from_rad: from[0],
                    to_rad: to[0],
                    from_m: from[1],
                    to_m: to[1],
                });
            }
            last = Some(n);
        }
    }
    reversals
}

/// Where the shear stress along the outline changes its sign between two neighbouring bins that are both
/// loaded; in soil that sticks to the body, too, where there is no slip to tell.
#[must_use]
pub fn shear_reversals(lines: &[RimLine]) -> Vec<RimPlace> {
    let is_loaded = loaded(lines);
    let reversal = |pair: &[RimLine]| {
        let (a, b) = (&pair[0], &pair[1]);
        let reverses = is_loaded(a) && is_loaded(b) && a.shear_along * b.shear_along < 0.0;
        let [angle_rad, arc_m] = falls_to(0.0, a.shear_along, b.shear_along, [a, b]);
        reverses.then_some(RimPlace { angle_rad, arc_m })
    };
    lines.windows(2).filter_map(reversal).collect()
}

/// Which lines bear more than a small part of the largest normal stress.
fn loaded(lines: &[RimLine]) -> impl Fn(&RimLine) -> bool + use<> {
    let most = lines.iter().map(|l| l.normal_stress).fold(0.0, f64::max);
    move |line| most > 0.0 && line.normal_stress >= LOADED * most
}

/// Angle and arc at which a value falls from that of a line to a smaller magnitude with the same sign,
/// towards the next line.
fn falls_to(size: f64, value: f64, next: f64, [from, to]: [&RimLine; 2]) -> [f64; 2] {
    let fraction = (value.abs() - size) / (value.abs() - value.signum() * next);
    [from.angle + fraction * (to.angle - from.angle), from.arc + fraction * (to.arc - from.arc)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::RimPoint;
    use glam::DVec3;

    /// A rim of two bins, pressed with 1 and 3 Pa on 2 m² each, and flanks; sampled every second.
    fn history(samples: usize) -> RimHistory {
        let bin = |arc: f64| RimBin { middle: RimPoint { arc, ..RimPoint::default() }, area: 2.0 };
        let mut history = RimHistory::of(&[bin(-1.0), bin(1.0)], 0.5);
        for n in 0..samples {
            let of = |stress: f64| RimSums {
                contact: n as f64,
                normal: 2.0 * stress * n as f64,
                slip: [(stress - 2.0) * n as f64, 0.0, 0.0],
                impulse: DVec3::new(-stress, 0.0, 4.0 * stress) * n as f64,
                ..RimSums::default()
            };
            history.push(n as f64, vec![of(1.0), of(3.0), of(0.5)]);
        }
        history
    }

    #[test]
    fn a_window_is_averaged_over_time_and_area() {
        let average = history(11).average([4.0, 9.0]).unwrap();
        assert_eq!(average.window, [4.0, 9.0]);
        assert_eq!([average.drag, average.vertical], [[4.0, 0.5], [16.0, 2.0]]);
        let lines = &average.lines;
        assert_eq!([lines[0].normal_stress, lines[1].normal_stress], [1.0, 3.0]);
        assert_eq!([lines[0].contact, lines[0].area, lines[0].slip_along], [0.5, 4.0, -1.0]);
        let reversal = slip_reversals(lines)[0];
        assert!((reversal.from_m + 0.01).abs() < 1e-12 && (reversal.to_m - 0.01).abs() < 1e-12);
        assert!(average.mobilised.is_nan() && history(1).average([0.0, 0.0]).is_none());
    }

    #[test]
    fn records_are_thinned_out_and_the_last_is_kept() {
        for samples in [3, 257, 258, 259, 1000, 5001] {
            let history = history(samples);
            let records = &history.records;
            assert!(records.len() <= MOST_RIM_RECORDS && records.len() >= samples.min(MOST_RIM_RECORDS / 2));
            assert_eq!((records[0].number, records[records.len() - 1].number), (0, samples - 1));
            let end = (samples - 1) as f64;
            let average = history.average([0.7 * end, end]).unwrap();
            assert!((average.drag[0] - 4.0).abs() < 1e-12);
            let begin = average.window[0];
            assert!(begin <= 0.7 * end && begin >= 0.7 * end - 1.0 - end / 128.0, "{samples}: {begin}");
        }
    }

    #[test]
    fn shear_reverses_at_one_place() {
        let line = |arc: f64, shear_along: f64| RimLine {
            arc,
            shear_along,
            normal_stress: 1.0,
            ..RimLine::default()
        };
        let places = shear_reversals(&[line(0.0, -3.0), line(1.0, -1.0), line(2.0, 3.0), line(3.0, 2.0)]);
        assert_eq!(places, [RimPlace { angle_rad: 0.0, arc_m: 1.25 }]);
    }

    #[test]
    fn soil_that_sticks_belongs_to_the_reversal() {
        let line =
            |arc: f64, slip_along: f64| RimLine { arc, slip_along, normal_stress: 1.0, ..RimLine::default() };
        let slips = [3.0, 2.0, 1.0, 0.01, -0.02, 0.015, -0.47, -5.0, -1.0];
        let mut lines: Vec<_> = slips.iter().enumerate().map(|(n, slip)| line(n as f64, *slip)).collect();
        let reversals = slip_reversals(&lines);
        assert_eq!(reversals.len(), 1);
        assert!((reversals[0].from_m - (2.0 + 0.95 / 0.99)).abs() < 1e-12, "{reversals:?}");
        assert!((reversals[0].to_m - (6.0 - 0.42 / 0.485)).abs() < 1e-12, "{reversals:?}");
        // Not across a gap without load, and not without slip.
        lines[4].normal_stress = 0.0;
        assert_eq!(slip_reversals(&lines), []);
        assert_eq!(slip_reversals(&[line(0.0, 0.0), line(1.0, 0.0)]), []);
    }
}
