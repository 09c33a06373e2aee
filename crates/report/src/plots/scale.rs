//! Axes: tick positions, units, and labels.

/// Round positions inside `low..=high`, about `count` of them, and the decimals that their labels need.
pub(crate) fn ticks(low: f64, high: f64, count: usize) -> (Vec<f64>, usize) {
    let span = high - low;
    if !span.is_finite() || span <= 0.0 {
        return (vec![low], 3);
    }
    let raw = span / count.max(1) as f64;
    let decade = 10f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 2.5, 5.0, 10.0]
        .iter()
        .map(|m| m * decade)
        .find(|s| *s >= raw * 0.999)
        .unwrap_or(decade * 10.0);
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    let decimals = (0..12).find(|&d| is_whole(step * 10f64.powi(d))).unwrap_or(12) as usize;
    ((first..=last).take(100).map(|n| n as f64 * step).collect(), decimals)
}

/// Positions and labels of the ticks on an axis. On a logarithmic axis positions are logarithms.
pub(crate) fn labelled_ticks([low, high]: [f64; 2], count: usize, logarithmic: bool) -> Vec<(f64, String)> {
    if !logarithmic {
        let (positions, decimals) = ticks(low, high, count);
        return positions.into_iter().map(|x| (x, tick_label(x, decimals))).collect();
    }
    let span = high - low;
    let steps: &[f64] = if span < 1.2 {
        &[1.0, 2.0, 3.0, 5.0, 7.0]
    } else if span < 3.0 {
        &[1.0, 2.0, 5.0]
    } else {
        &[1.0]
    };
    let decades = low.floor() as i32..=high.ceil() as i32;
    let candidates = decades.take(60).flat_map(|decade| steps.iter().map(move |m| (decade, *m)));
    let stride = if span > 12.0 { 3 } else { 1 };
    candidates
        .filter(|(decade, _)| decade % stride == 0)
        .map(|(decade, m)| (f64::from(decade) + m.log10(), decade, m))
        .filter(|(position, ..)| (low..=high).contains(position))
        .map(|(position, decade, m)| {
            let decimals = usize::try_from(-decade).unwrap_or(0);
            (position, tick_label(m * 10f64.powi(decade), decimals))
        })
        .collect()
}

/// Decimal logarithm; not-a-number for values that are not positive.
pub(crate) fn logarithm(value: f64) -> f64 {
    if value > 0.0 { value.log10() } else { f64::NAN }
}

fn is_whole(value: f64) -> bool {
    value.round() != 0.0 && (value - value.round()).abs() < 1e-6 * value.abs()
}

/// A tick's label, with a true minus sign.
pub(crate) fn tick_label(value: f64, decimals: usize) -> String {
    let size = value.abs();
    let text = if size != 0.0 && (size >= 1e6 || decimals > 6) {
        format!("{value:.2e}")
    } else {
        format!("{:.decimals$}", value + 0.0)
    };
    text.replace('-', "\u{2212}")
}

/// Lowest and highest finite value with a margin; never empty or of zero extent.
pub(crate) fn padded_range(values: impl Iterator<Item = f64>, margin: f64) -> [f64; 2] {
    let (low, high) = values
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    if low > high {
        return [0.0, 1.0];
    }
    // A curve that is constant except for rounding is drawn as a level, not as an amplified rounding error.
    let size = low.abs().max(high.abs());
    if high - low <= 1e-9 * size || high == low {
        let margin = if size > 0.0 { 0.5 * size } else { 1.0 };
        return [low - margin, high + margin];
    }
    let margin = margin * (high - low);
    [low - margin, high + margin]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round() {
        assert_eq!(ticks(0.0, 1.0, 5), (vec![0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0], 1));
        assert_eq!(ticks(-3.0, 9.0, 4).0, vec![0.0, 5.0]);
        assert_eq!(ticks(0.0, 0.25, 5).1, 2);
        assert_eq!(ticks(f64::NAN, 1.0, 5).0.len(), 1);
        assert_eq!(tick_label(-0.5, 1), "\u{2212}0.5");
    }

    #[test]
    fn ranges_are_never_empty() {
        assert_eq!(padded_range([f64::NAN].into_iter(), 0.05), [0.0, 1.0]);
        assert_eq!(padded_range([2.0, 2.0].into_iter(), 0.05), [1.0, 3.0]);
        assert_eq!(padded_range([0.0].into_iter(), 0.05), [-1.0, 1.0]);
    }
}
