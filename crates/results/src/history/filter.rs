//! A low-pass filter for histories, without a shift in time.

use super::BodySample;
use super::quantities::FORCES;
use std::f64::consts::{LN_2, TAU};

/// The samples with forces, moments and velocities filtered: weighted means, by a Gauss function of the time
/// between samples, that let 1/√2 of the amplitude through at the cut-off frequency [Hz], of slow changes
/// all, and of one at three times it 4 %. Everything else of a sample stays. At both ends the means are over
/// what there is.
#[must_use]
pub fn filtered(samples: &[BodySample], cutoff: f64) -> Vec<BodySample> {
    let deviation = LN_2.sqrt() / (TAU * cutoff);
    // Farther away the weight is below that of round-off.
    let reach = 6.0 * deviation;
    let interval = |n: usize| if n == 0 { 0.0 } else { samples[n].time - samples[n - 1].time };
    let is_filtered = |unit: &str| matches!(unit, "N" | "N m" | "m/s" | "rad/s");
    let columns = FORCES.iter().filter(|column| is_filtered(column.unit));
    let places: Vec<fn(&mut BodySample) -> &mut f64> = columns.filter_map(|c| c.source.place()).collect();
    let mut first = 0;
    let one = |n: usize| {
        let now = samples[n].time;
        while samples[first].time < now - reach {
            first += 1;
        }
        let mut mean = samples[n];
        places.iter().for_each(|place| *place(&mut mean) = 0.0);
        let mut sum = 0.0;
        for (m, sample) in samples.iter().enumerate().skip(first).take_while(|(_, s)| s.time <= now + reach) {
            // A sample is the mean since the one before it.
            let middle = sample.time - 0.5 * interval(m);
            let away = (middle - now + 0.5 * interval(n)) / deviation;
            let weight = (-0.5 * away * away).exp() * interval(m);
            sum += weight;
            let mut sample = *sample;
            places.iter().for_each(|place| *place(&mut mean) += weight * *place(&mut sample));
        }
        if sum > 0.0 {
            places.iter().for_each(|place| *place(&mut mean) /= sum);
            mean
        } else {
            samples[n]
        }
    };
    (0..samples.len()).map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A drag of 10 N with a wave of 1 N of this frequency, at 250 Hz.
    fn wave(frequency: f64) -> Vec<BodySample> {
        let sample = |n: u32| {
            let time = 0.004 * f64::from(n);
            // Mean of the wave over the interval before.
            let mean = ((TAU * frequency * (time - 0.004)).cos() - (TAU * frequency * time).cos())
                / (TAU * frequency * 0.004);
            BodySample { time, drag: 10.0 + mean, ..BodySample::default() }
        };
        (0..1000).map(sample).collect()
    }

    fn amplitude(samples: &[BodySample]) -> f64 {
        let inside = &samples[300..700];
        inside.iter().map(|sample| (sample.drag - 10.0).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn the_cutoff_is_where_it_is_said_to_be() {
        for (frequency, share) in
            [(1.0, 0.5_f64.powf(0.005)), (10.0, 0.5_f64.sqrt()), (30.0, 0.5_f64.powf(4.5))]
        {
            let samples = wave(frequency);
            let ratio = amplitude(&filtered(&samples, 10.0)) / amplitude(&samples);
            assert!((ratio - share).abs() < 0.01, "{frequency} Hz: {ratio} instead of {share}");
        }
    }

    #[test]
    fn what_is_constant_stays_up_to_the_ends() {
        let constant: Vec<BodySample> =
            wave(1.0).into_iter().map(|sample| BodySample { drag: 10.0, ..sample }).collect();
        let filtered = filtered(&constant, 10.0);
        assert!(filtered.iter().skip(1).all(|sample| (sample.drag - 10.0).abs() < 1e-12));
        assert_eq!(filtered.len(), constant.len());
        assert!(super::filtered(&[], 10.0).is_empty());
    }
}
