//! How far two aligned curves differ.

use super::align::Aligned;

/// The largest value of a curve by magnitude.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// The value, with its sign [SI].
    pub value: f64,
    /// Place of the peak along the abscissa [SI].
    pub at: f64,
}

/// Differences of a curve and its reference at common abscissae.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Differences {
    /// Number of points.
    pub points: usize,
    /// Range that both share [SI].
    pub range: [f64; 2],
    /// Mean difference, other less reference [SI].
    pub bias: f64,
    /// Root of the mean square of the differences [SI].
    pub rms: f64,
    /// Root-mean-square difference over the mean magnitude of the reference; `None` where that is 0.
    pub relative: Option<f64>,
    /// Correlation; `None` where a curve is constant.
    pub correlation: Option<f64>,
    /// Peak of the reference within the range.
    pub peak_reference: Peak,
    /// Peak of the other curve.
    pub peak_other: Peak,
}

/// The differences of aligned curves; `None` without a point.
#[must_use]
pub fn differences(curves: &Aligned) -> Option<Differences> {
    let Aligned { at, reference, other, .. } = curves;
    let count = at.len() as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
    let [middle, middle_other] = [mean(reference), mean(other)];
    let product =
        |a: &[f64], b: &[f64], [m, n]: [f64; 2]| a.iter().zip(b).map(|(a, b)| (a - m) * (b - n)).sum::<f64>();
    let scale =
        (product(reference, reference, [middle; 2]) * product(other, other, [middle_other; 2])).sqrt();
    let magnitude = reference.iter().map(|value| value.abs()).sum::<f64>() / count;
    let rms = curves.mean_square().sqrt();
    let peak = |values: &[f64]| {
        let largest = values.iter().zip(at).max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        largest.map(|(value, at)| Peak { value: *value, at: *at })
    };
    Some(Differences {
        points: at.len(),
        range: [*at.first()?, *at.last()?],
        bias: middle_other - middle,
        rms,
        relative: (magnitude > 0.0).then(|| rms / magnitude),
        correlation: (scale > 0.0).then(|| product(reference, other, [middle, middle_other]) / scale),
        peak_reference: peak(reference)?,
        peak_other: peak(other)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_of_known_curves() {
        let curves = Aligned {
            at: vec![0.0, 1.0, 2.0],
            reference: vec![1.0, 2.0, 3.0],
            other: vec![2.0, 3.0, 4.0],
            shift: 0.0,
        };
        let found = differences(&curves).unwrap();
        assert_eq!((found.bias, found.rms, found.relative), (1.0, 1.0, Some(0.5)));
        assert!((found.correlation.unwrap() - 1.0).abs() < 1e-12);
        assert_eq!((found.peak_other.value, found.peak_other.at), (4.0, 2.0));
        assert_eq!(differences(&Aligned::default()), None);
    }
}
