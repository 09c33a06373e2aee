//! Numbers as people read them.

/// A stress with its unit, in three digits; a dash where there is none.
pub(super) fn stress(value: f64) -> String {
    if !value.is_finite() {
        return "–".to_owned();
    }
    let (size, unit) = match value.abs() {
        size if size >= 1e9 => (1e9, "GPa"),
        size if size >= 1e6 => (1e6, "MPa"),
        size if size >= 1e3 => (1e3, "kPa"),
        _ => (1.0, "Pa"),
    };
    let shown = value / size;
    let whole = if shown == 0.0 { 0 } else { shown.abs().log10().floor() as i32 };
    format!("{shown:.*} {unit}", (2 - whole).clamp(0, 2) as usize)
}

/// A number with so many decimals, without the sign of a zero.
pub(super) fn decimals(value: f64, count: usize) -> String {
    let text = format!("{value:.count$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.chars().all(|c| matches!(c, '0' | '.')) => zero.to_owned(),
        _ => text,
    }
}
