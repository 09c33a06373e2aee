//! Run-out of a collapsing granular column.

use crate::error::{ModelResult, positive, within};

/// Final shape of a collapsed column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Collapse {
    /// Run-out beyond the initial edge [m].
    pub run_out: f64,
    /// Final height at the axis (or the wall) [m].
    pub height: f64,
}

/// Collapse of a cylindrical column of radius r₀ [m] and height h₀ [m], a = h₀/r₀.
///
/// Run-out/r₀ = 1.24 a (a < 1.7), 1.6 √a beyond; h∞ = h₀ (a < 1), 0.88 r₀ a^{1/6} (a > 1.7; the smaller of
/// the two in between). Source: Lube, Huppert, Sparks & Hallworth (2004), J. Fluid Mech. 508 (recalled). Any
/// dry sand, a ≤ 10.
///
/// # Errors
/// Unless both lengths are positive and a ≤ 10.
pub fn axisymmetric_collapse(radius: f64, height: f64) -> ModelResult<Collapse> {
    let (r, h) = (positive("column radius [m]", radius)?, positive("column height [m]", height)?);
    let a = within("aspect ratio", h / r, 0.0, 10.0)?;
    let run_out = if a < 1.7 { 1.24 * a * r } else { 1.6 * a.sqrt() * r };
    let final_height = if a < 1.0 { h } else { h.min(0.88 * r * a.powf(1.0 / 6.0)) };
    Ok(Collapse { run_out, height: final_height })
}

/// Collapse of a plane column of width d₀ [m] and height h₀ [m] released on one side, a = h₀/d₀.
///
/// Run-out/d₀ = 1.2 a (a < 1.8), 1.9 a^{2/3} (a > 2.8; the smaller of the two in between); h∞ = h₀ (a <
/// 1.15), 0.65 d₀ a^{2/5} beyond. Source: Lube, Huppert, Sparks & Freundt (2005), Phys. Rev. E 72 (recalled).
/// a ≤ 20.
///
/// # Errors
/// Unless both lengths are positive and a ≤ 20.
pub fn plane_collapse(width: f64, height: f64) -> ModelResult<Collapse> {
    let (d, h) = (positive("column width [m]", width)?, positive("column height [m]", height)?);
    let a = within("aspect ratio", h / d, 0.0, 20.0)?;
    let (shallow, deep) = (1.2 * a * d, 1.9 * a.powf(2.0 / 3.0) * d);
    let run_out = if a < 1.8 { shallow } else { shallow.min(deep) };
    let final_height = if a < 1.15 { h } else { h.min(0.65 * d * a.powf(0.4)) };
    Ok(Collapse { run_out, height: final_height })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn taller_columns_run_farther() {
        let mut last = 0.0;
        for n in 1..60 {
            let found = plane_collapse(0.1, 0.03 * f64::from(n)).unwrap();
            assert!(found.run_out > last && found.height <= 0.03 * f64::from(n) + 1e-12);
            last = found.run_out;
        }
        assert!(axisymmetric_collapse(0.1, 2.0).is_err());
        assert!((axisymmetric_collapse(0.1, 0.4).unwrap().run_out - 0.32).abs() < 1e-12);
    }
}
