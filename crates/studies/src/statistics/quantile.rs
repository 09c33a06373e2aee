//! Quantiles of a list.

/// The quantile of a portion 0 to 1, linear between members; not a number of an empty list.
pub(super) fn quantile(values: &[f64], portion: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let place = portion * last as f64;
    let below = place.floor() as usize;
    sorted[below] + place.fract() * (sorted[(below + 1).min(last)] - sorted[below])
}
