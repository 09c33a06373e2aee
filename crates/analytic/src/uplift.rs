//! What holds a buried pipe or plate that is pulled up: the soil above it, and its shear.

use crate::error::{ModelResult, positive, undefined, within};
use crate::pipe::flow_round_factor;
use crate::soil::Soil;
use std::f64::consts::PI;

/// Meyerhof & Adams' values at φ: largest H/B of a shallow plate, m of the shape factor, K_u.
const PLATES: [(f64, f64, f64, f64); 7] = [
    (20.0, 2.5, 0.05, 0.85),
    (25.0, 3.0, 0.10, 0.89),
    (30.0, 4.0, 0.15, 0.91),
    (35.0, 5.0, 0.25, 0.94),
    (40.0, 7.0, 0.35, 0.96),
    (45.0, 9.0, 0.50, 0.98),
    (48.0, 11.0, 0.60, 1.00),
];
/// Vesić's breakout factor of a circle in clay at H/B.
const CIRCLES: [(f64, f64); 6] =
    [(0.0, 0.0), (0.5, 1.76), (1.0, 3.80), (1.5, 6.12), (2.5, 11.6), (5.0, 30.3)];
/// Limits of a deep strip (Merifield, Sloan & Yu 2001) and of a deep smooth circle (Martin & Randolph 2001)
/// in clay.
const DEEP: (f64, f64) = (11.16, 12.42);
/// Depth of the middle of a pipe over its diameter to which sand above it is lifted as a whole (chosen: the
/// range of the tests).
const DEEPEST_PIPE: f64 = 8.0;

/// Shear on the two vertical planes above a strip over γ H²: tan ψ + (tan φ − tan
/// ψ)[(1 + K₀)/2 − (1 − K₀) cos 2ψ/2].
///
/// Source: White, Cheuk & Bolton (2008), Géotechnique 58(10), 771–779.
#[must_use]
pub fn uplift_shear(soil: &Soil, k0: f64) -> f64 {
    let psi = soil.dilation_angle.max(0.0);
    let normal = 0.5 * ((1.0 + k0) - (1.0 - k0) * (2.0 * psi).cos());
    psi.tan() + (soil.friction_angle.tan() - psi.tan()) * normal
}

/// Force [N/m] that holds a pipe of the diameter d [m] whose middle lies h [m] below the ground: the weight
/// of the soil above it, γ (h d − π d²/8), and the shear on the vertical planes at its sides; in clay 2 s_u
/// h, at most the flow around it.
///
/// Sources: [`uplift_shear`]; in clay Schaminée, Zorn & Schotman (1990), OTC 6486, with
/// [`flow_round_factor`].
///
/// # Errors
/// If the pipe is not covered, or in sand deeper than 8 d.
pub fn pipe_uplift(soil: &Soil, diameter: f64, h: f64, (k0, roughness): (f64, f64)) -> ModelResult<f64> {
    if h < 0.5 * diameter {
        return undefined("the uplift resistance", "the top of the pipe is not covered by soil");
    }
    let weight = soil.unit_weight * (h * diameter - PI * diameter * diameter / 8.0);
    if soil.is_undrained() {
        let mean = soil.cohesion + 0.5 * soil.strength_gradient * h;
        let around = flow_round_factor(roughness)? * (soil.cohesion + soil.strength_gradient * h) * diameter;
        return Ok((weight + 2.0 * mean * h).min(around));
    }
    within("depth over the diameter of the pipe", h / diameter, 0.5, DEEPEST_PIPE)?;
    Ok(weight + soil.unit_weight * h * h * uplift_shear(soil, k0))
}

/// Force [N/m] that holds a strip of the width B [m] whose top lies H [m] below the ground; in clay soil
/// breaks away under it at once.
///
/// Sources: in sand [`uplift_shear`]; in clay Merifield, Sloan & Yu (2001), Géotechnique 51(2), 141–153, N =
/// 2.56 ln(2 H/B) + γ H/s_u ≤ 11.16, below H = B linear to 0 (chosen).
///
/// # Errors
/// If an input is out of range, or H/B in sand is beyond what Meyerhof & Adams call shallow.
pub fn strip_uplift(soil: &Soil, width: f64, h: f64, k0: f64) -> ModelResult<f64> {
    let depth = positive("depth of the top [m]", h)? / positive("width [m]", width)?;
    if soil.is_undrained() {
        let factor = if depth < 1.0 { 2.56 * 2_f64.ln() * depth } else { 2.56 * (2.0 * depth).ln() };
        return Ok(breakout(soil, h, factor, DEEP.0) * width);
    }
    shallow(soil, depth)?;
    Ok(soil.unit_weight * h * (width + h * uplift_shear(soil, k0)))
}

/// Force [N] that holds a circle of the diameter B [m], or a rectangle of the sides B and L [m] in sand,
/// whose top lies H [m] below the ground.
///
/// Sources: in sand Meyerhof & Adams (1968), Can. Geotech. J. 5(4), 225–244: weight of the soil above and s
/// (π/2) B γ H² K_u tan φ, s = 1 + m H/B, of a rectangle γ H² (2 s B + L − B) K_u tan φ; in clay the factors
/// of Vesić (1971), at most the 12.42 of a deep circle.
///
/// # Errors
/// If H/B is beyond what is shallow, and for rectangles in clay.
pub fn plate_uplift(soil: &Soil, [width, length]: [f64; 2], is_round: bool, h: f64) -> ModelResult<f64> {
    let depth = positive("depth of the top [m]", h)? / positive("width [m]", width)?;
    let area = width * length * if is_round { 0.25 * PI } else { 1.0 };
    if soil.is_undrained() {
        if !is_round {
            return undefined(
                "the uplift resistance",
                "in clay it is known for strips and circles, not for rectangles",
            );
        }
        let deepest = CIRCLES[CIRCLES.len() - 1];
        let factor = interpolated(&CIRCLES, depth).unwrap_or(deepest.1);
        return Ok(breakout(soil, h, factor, DEEP.1) * area);
    }
    let (m, k_u) = shallow(soil, depth)?;
    let shape = 1.0 + m * depth;
    let shear = soil.unit_weight * h * h * k_u * soil.friction_angle.tan();
    let along = if is_round { 0.5 * PI * shape * width } else { 2.0 * shape * width + length - width };
    Ok(soil.unit_weight * h * area + shear * along)
}

/// Pressure [Pa] in clay: its factor and the weight above, at most the factor of a deep plate.
fn breakout(soil: &Soil, h: f64, factor: f64, deep: f64) -> f64 {
    let mean = soil.cohesion + 0.5 * soil.strength_gradient * h;
    (factor * mean + soil.unit_weight * h).min(deep * (soil.cohesion + soil.strength_gradient * h))
}

/// m and K_u for the friction angle of the soil.
fn shallow(soil: &Soil, depth: f64) -> ModelResult<(f64, f64)> {
    let degrees =
        within("friction angle [rad]", soil.friction_angle, 20_f64.to_radians(), 48_f64.to_radians())?
            .to_degrees();
    let column = |of: fn(&(f64, f64, f64, f64)) -> f64| {
        let pairs: Vec<(f64, f64)> = PLATES.iter().map(|row| (row.0, of(row))).collect();
        interpolated(&pairs, degrees).unwrap_or(of(&PLATES[PLATES.len() - 1]))
    };
    within("depth of the top over the width", depth, 0.0, column(|row| row.1))?;
    Ok((column(|row| row.2), column(|row| row.3)))
}

/// The value between two rows; `None` beyond the last.
fn interpolated(rows: &[(f64, f64)], x: f64) -> Option<f64> {
    rows.windows(2).find(|pair| x <= pair[1].0 * (1.0 + 1e-12)).map(|pair| {
        let [(a, y), (b, z)] = [pair[0], pair[1]];
        y + (z - y) * ((x - a) / (b - a)).max(0.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn soil(phi: f64, psi: f64, cohesion: f64) -> Soil {
        Soil {
            friction_angle: f64::to_radians(phi),
            dilation_angle: f64::to_radians(psi),
            cohesion,
            unit_weight: 10e3,
            body_friction: 1.0,
            adhesion_factor: 1.0,
            strength_gradient: 0.0,
        }
    }

    #[test]
    fn sand_that_dilates_as_much_as_it_rubs_is_an_inclined_wedge() {
        // Associated flow: planes at φ to the vertical, tan φ; without dilation K₀ tan φ.
        assert!((uplift_shear(&soil(35.0, 35.0, 0.0), 0.4) - 35_f64.to_radians().tan()).abs() < 1e-12);
        assert!((uplift_shear(&soil(35.0, 0.0, 0.0), 0.4) - 0.4 * 35_f64.to_radians().tan()).abs() < 1e-12);
        let found = pipe_uplift(&soil(35.0, 35.0, 0.0), 0.5, 1.0, (0.4, 1.0)).unwrap();
        let known = 10e3 * (0.5 - PI * 0.25 / 8.0 + 35_f64.to_radians().tan());
        assert!((found / known - 1.0).abs() < 1e-12);
        assert!(pipe_uplift(&soil(35.0, 0.0, 0.0), 0.5, 0.2, (0.4, 1.0)).is_err());
    }

    #[test]
    fn plates_in_sand_are_those_of_meyerhof_and_adams() {
        // φ = 30°, H/B = 3: s = 1.45, K_u = 0.91; breakout factor 1 + 2 s K_u tan φ H/B.
        let found = plate_uplift(&soil(30.0, 0.0, 0.0), [0.2, 0.2], true, 0.6).unwrap();
        let factor = found / (10e3 * 0.6 * 0.25 * PI * 0.04);
        assert!(
            (factor - (1.0 + 2.0 * 1.45 * 0.91 * 30_f64.to_radians().tan() * 3.0)).abs() < 1e-9,
            "{factor}"
        );
        // A square is nearly a circle; beyond the table's depth nothing is said.
        let square =
            plate_uplift(&soil(30.0, 0.0, 0.0), [0.2, 0.2], false, 0.6).unwrap() / (10e3 * 0.6 * 0.04);
        assert!((square / factor - 1.0).abs() < 0.01, "{square} {factor}");
        assert!(plate_uplift(&soil(30.0, 0.0, 0.0), [0.2, 0.2], true, 0.9).is_err());
    }

    #[test]
    fn clay_breaks_away_up_to_the_limit_of_deep_plates() {
        let mut clay = soil(0.0, 0.0, 5e3);
        clay.unit_weight = 0.0;
        let strip = |h: f64| strip_uplift(&clay, 1.0, h, 1.0).unwrap() / 5e3;
        assert!(
            (strip(2.0) - 2.56 * 4_f64.ln()).abs() < 1e-9 && (strip(1.0) - strip(1.0 - 1e-9)).abs() < 1e-6
        );
        let circle = |h: f64| plate_uplift(&clay, [1.0; 2], true, h).unwrap() / (5e3 * 0.25 * PI);
        assert!((circle(1.0) - 3.8).abs() < 1e-9 && (circle(20.0) - 12.42).abs() < 1e-9);
        assert!((pipe_uplift(&clay, 1.0, 20.0, (1.0, 0.0)).unwrap() / 5e3 - 9.142).abs() < 1e-3);
        assert!(plate_uplift(&clay, [1.0, 2.0], false, 1.0).is_err());
    }
}
