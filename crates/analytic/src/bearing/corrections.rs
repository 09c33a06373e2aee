//! Correction factors for the shape and depth of a footing and the inclination of its load.

use super::surcharge_factor;
use crate::error::{ModelResult, non_negative, positive, within};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// Author of the correction factors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// Meyerhof (1963).
    #[default]
    Meyerhof,
    /// Hansen (1970) shape and depth, Vesić (1973) inclination.
    HansenVesic,
    /// Lyamin et al. (2007), three-dimensional limit analysis, with Meyerhof's inclination factor as it has
    /// none.
    Lyamin,
}

/// A rectangular footing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footing {
    /// Shorter side B [m].
    pub width: f64,
    /// Longer side [m].
    pub length: f64,
    /// Depth of the base below the ground D [m].
    pub depth: f64,
    /// Inclination of the load to the normal of the base [rad], in the plane of the length.
    pub load_inclination: f64,
}

/// Products of the shape, depth and inclination factors of the three terms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corrections {
    /// s_c d_c i_c.
    pub cohesion: f64,
    /// s_q d_q i_q.
    pub surcharge: f64,
    /// s_γ d_γ i_γ.
    pub weight: f64,
}

/// The correction factors of `method` for a footing on soil of friction angle φ [rad] (10° to 50°).
///
/// Sources: Meyerhof (1963): s_c = 1 + 0.2 K_p B/L, s_q = s_γ = 1 + 0.1 K_p B/L, d_c = 1 + 0.2 √K_p D/B,
/// d_q = d_γ = 1 + 0.1 √K_p D/B, i_c = i_q = (1 − δ/90°)², i_γ = (1 − δ/φ)² (0 beyond δ = φ).
/// Hansen (1970): s_c = 1 + N_q/N_c B/L, s_q = 1 + tan φ B/L, s_γ = 1 − 0.4 B/L, k = D/B or atan D/B beyond
/// 1, d_c = 1 + 0.4 k, d_q = 1 + 2 tan φ (1 − sin φ)² k, d_γ = 1; Vesić (1973): i_q = (1 − tan δ)^m, i_γ =
/// (1 − tan δ)^{m+1} for no cohesion, m = (2 + L/B)/(1 + L/B). Lyamin et al. (2007): as the code below,
/// validity 25° ≤ φ ≤ 45°. All recalled, not re-read.
///
/// # Errors
/// If φ or the footing is out of range, and for Lyamin outside 25° to 45°.
pub fn corrections(method: Method, friction_angle: f64, footing: &Footing) -> ModelResult<Corrections> {
    let (low, high) = if method == Method::Lyamin { (25_f64, 45_f64) } else { (10_f64, 50_f64) };
    let phi = within("friction angle [rad]", friction_angle, low.to_radians(), high.to_radians())?;
    let width = positive("footing width [m]", footing.width)?;
    let slenderness = width / within("footing length [m]", footing.length, width, f64::MAX)?;
    let depth = non_negative("footing depth [m]", footing.depth)? / width;
    let load = within("load inclination [rad]", footing.load_inclination, 0.0, FRAC_PI_2 - 1e-9)?;
    Ok(match method {
        Method::Meyerhof => meyerhof(phi, slenderness, depth, load),
        Method::HansenVesic => hansen_vesic(phi, slenderness, depth, load)?,
        Method::Lyamin => lyamin(phi, slenderness, depth, load),
    })
}

fn meyerhof(phi: f64, slenderness: f64, depth: f64, load: f64) -> Corrections {
    let (i_q, i_gamma) = meyerhof_inclination(phi, load);
    let root = (FRAC_PI_4 + 0.5 * phi).tan();
    let passive = root * root;
    let shape_depth = (1.0 + 0.1 * passive * slenderness) * (1.0 + 0.1 * root * depth);
    Corrections {
        cohesion: (1.0 + 0.2 * passive * slenderness) * (1.0 + 0.2 * root * depth) * i_q,
        surcharge: shape_depth * i_q,
        weight: shape_depth * i_gamma,
    }
}

fn meyerhof_inclination(phi: f64, load: f64) -> (f64, f64) {
    ((1.0 - load / FRAC_PI_2).powi(2), (1.0 - load / phi).max(0.0).powi(2))
}

fn hansen_vesic(phi: f64, slenderness: f64, depth: f64, load: f64) -> ModelResult<Corrections> {
    let n_q = surcharge_factor(phi)?;
    let n_c = (n_q - 1.0) / phi.tan();
    let k = if depth <= 1.0 { depth } else { depth.atan() };
    let m = (2.0 * slenderness + 1.0) / (slenderness + 1.0);
    let reduction = (1.0 - load.tan()).max(0.0);
    let i_q = reduction.powf(m);
    let i_c = (i_q - (1.0 - i_q) / (n_q - 1.0)).max(0.0);
    Ok(Corrections {
        cohesion: (1.0 + n_q / n_c * slenderness) * (1.0 + 0.4 * k) * i_c,
        surcharge: (1.0 + phi.tan() * slenderness)
            * (1.0 + 2.0 * phi.tan() * (1.0 - phi.sin()).powi(2) * k)
            * i_q,
        weight: (1.0 - 0.4 * slenderness) * reduction.powf(m + 1.0),
    })
}

fn lyamin(phi: f64, slenderness: f64, depth: f64, load: f64) -> Corrections {
    let (i_q, i_gamma) = meyerhof_inclination(phi, load);
    let degrees = phi.to_degrees();
    // The fits are singular at zero embedment; below D/B = 0.01 the surcharge term is negligible.
    let depth = depth.max(0.01);
    let s_q = 1.0
        + (0.098 * degrees - 1.64)
            * depth.powf(0.7 - 0.01 * degrees)
            * slenderness.powf((1.0 - 0.16 * depth).max(0.0));
    let d_q = 1.0 + (0.0044 * degrees + 0.356) * depth.powf(-0.28);
    let n_q = (std::f64::consts::PI * phi.tan()).exp() * (FRAC_PI_4 + 0.5 * phi).tan().powi(2);
    let shape_depth = s_q * d_q;
    Corrections {
        // Caquot's theorem of corresponding states: c N_c* = c cot φ (N_q* − 1).
        cohesion: (shape_depth * n_q - 1.0) / (n_q - 1.0) * i_q,
        surcharge: shape_depth * i_q,
        weight: (1.0 + (0.0336 * degrees - 1.0) * slenderness).max(0.0) * i_gamma,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meyerhof_matches_the_worked_example() {
        let footing = Footing { width: 0.05, length: 0.089_443, depth: 0.02, load_inclination: 0.0 };
        let found = corrections(Method::Meyerhof, 35_f64.to_radians(), &footing).unwrap();
        assert!((found.surcharge / (1.2063 * 1.0768) - 1.0).abs() < 1e-4);
        let inclined = Footing { load_inclination: 0.3_f64.atan(), ..footing };
        let reduced = corrections(Method::Meyerhof, 35_f64.to_radians(), &inclined).unwrap();
        assert!((reduced.surcharge / found.surcharge - 0.663).abs() < 1e-3);
        assert!((reduced.weight / found.weight - 0.273).abs() < 1e-3);
    }

    #[test]
    fn a_vertical_load_on_a_strip_at_the_surface_needs_no_correction() {
        let strip = Footing { width: 1e-6, length: 1.0, depth: 0.0, load_inclination: 0.0 };
        for method in [Method::Meyerhof, Method::HansenVesic] {
            let found = corrections(method, 0.6, &strip).unwrap();
            assert!((found.surcharge - 1.0).abs() < 1e-5 && (found.weight - 1.0).abs() < 1e-5);
        }
    }
}
