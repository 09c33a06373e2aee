//! Quantiles of a list of numbers.

/// The quantile of a portion 0 to 1 of numbers in ascending order, linear between neighbours; NaN of an empty
/// list.
#[must_use]
pub fn quantile_of_sorted(sorted: &[f64], portion: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else { return f64::NAN };
    let place = portion * last as f64;
    let below = place.floor() as usize;
    sorted[below] + place.fract() * (sorted[(below + 1).min(last)] - sorted[below])
}

/// The quantile of a portion 0 to 1 of numbers in any order, linear between neighbours; NaN of an empty list.
#[must_use]
pub fn quantile(values: &[f64], portion: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    quantile_of_sorted(&sorted, portion)
}
