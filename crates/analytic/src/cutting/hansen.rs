//! Brinch Hansen and Ovesen: the end effect of a short anchor slab.

use crate::error::{ModelResult, non_negative, positive, within};

/// Ratio R of the thrust on a short slab to that in plane strain.
///
/// R = 1 + (K_p−K_a)^{2/3} [1.1 E⁴ + 1.6 B/(1 + 5 b/h) + 0.4 (K_p−K_a) E³ B²/(1 + 0.05 b/h)], E = 1 −
/// h/(z_top + h), B = 1 − (b/s)² (1 for a single slab). Source: Brinch Hansen (1966), Ovesen (1964)
/// (recalled). `coefficient_excess` is K_p − K_a, lengths in metres, `spacing` infinite for a single slab. US
/// pile-cap practice limits R to 2.
///
/// # Errors
/// If a length is not positive or the slabs overlap.
pub fn hansen_end_factor(
    coefficient_excess: f64,
    width: f64,
    height: f64,
    top_depth: f64,
    spacing: f64,
) -> ModelResult<f64> {
    let excess = non_negative("coefficient excess", coefficient_excess)?;
    let (b, h) = (positive("slab width [m]", width)?, positive("slab height [m]", height)?);
    let buried = 1.0 - h / (non_negative("depth of the top [m]", top_depth)? + h);
    let covered =
        if spacing.is_infinite() { 0.0 } else { b / within("slab spacing [m]", spacing, b, f64::MAX)? };
    let isolation = 1.0 - covered * covered;
    let ratio = b / h;
    let sum = 1.1 * buried.powi(4)
        + 1.6 * isolation / (1.0 + 5.0 * ratio)
        + 0.4 * excess * buried.powi(3) * isolation * isolation / (1.0 + 0.05 * ratio);
    Ok(1.0 + excess.powf(2.0 / 3.0) * sum)
}
