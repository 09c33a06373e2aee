//! Published plate constants of terrains.

use super::PressureSinkage;

/// A named terrain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Terrain {
    /// Name as published.
    pub name: &'static str,
    /// Constants of the soil, SI.
    pub soil: PressureSinkage,
}

const fn terrain(name: &'static str, row: [f64; 5], shear_modulus: f64) -> Terrain {
    let [exponent, cohesive, frictional, cohesion, degrees] = row;
    let friction_angle = degrees * (std::f64::consts::PI / 180.0);
    let (cohesive, frictional, cohesion) = (1e3 * cohesive, 1e3 * frictional, 1e3 * cohesion);
    let soil = PressureSinkage { exponent, cohesive, frictional, cohesion, friction_angle, shear_modulus };
    Terrain { name, soil }
}

/// Bekker constants of Wong, Theory of Ground Vehicles (2008), compared row by row with a public parameter
/// table for Project Chrono that cites it. Only n of LETE sand differs: 0.79 in that table, 0.793 in Chrono
/// itself.
///
/// Rows: n, k_c [kN/m^{n+1}], k_φ [kN/m^{n+2}], c [kPa], φ [°]; K chosen: 15 mm for sand and snow, 6 mm for
/// clay, 10 mm for loams in between (recalled ranges: 10 to 25 mm for sand, 6 mm for clay).
pub const TERRAINS: [Terrain; 21] = [
    terrain("dry sand (LLL)", [1.1, 0.99, 1528.43, 1.04, 28.0], 0.015),
    terrain("LETE sand", [0.793, 102.0, 5301.0, 1.3, 31.1], 0.015),
    terrain("sandy loam 15 %", [0.7, 5.27, 1515.04, 1.72, 29.0], 0.015),
    terrain("sandy loam 22 %", [0.2, 2.56, 43.12, 1.38, 38.0], 0.015),
    terrain("upland sandy loam 51 %", [1.10, 74.6, 2080.0, 3.3, 33.7], 0.015),
    terrain("Rubicon sandy loam 43 %", [0.66, 6.9, 752.0, 3.7, 29.8], 0.015),
    terrain("North Gower clayey loam 46 %", [0.73, 41.6, 2471.0, 6.1, 26.6], 0.01),
    terrain("Grenville loam 24 %", [1.01, 0.06, 5880.0, 3.1, 29.8], 0.01),
    terrain("clayey soil 38 %", [0.5, 13.19, 692.15, 4.14, 13.0], 0.006),
    terrain("heavy clay 25 %", [0.13, 12.70, 1555.95, 68.95, 34.0], 0.006),
    terrain("lean clay 22 %", [0.2, 16.43, 1724.69, 68.95, 20.0], 0.006),
    terrain("snow (US)", [1.6, 4.37, 196.72, 1.03, 19.7], 0.015),
    terrain("sandy loam 11 %", [0.9, 52.53, 1127.97, 4.83, 20.0], 0.015),
    terrain("sandy loam 23 %", [0.4, 11.42, 808.96, 9.65, 35.0], 0.015),
    terrain("sandy loam 26 %", [0.3, 2.79, 141.11, 13.79, 22.0], 0.015),
    terrain("sandy loam 32 %", [0.5, 0.77, 51.91, 5.17, 11.0], 0.015),
    terrain("clayey soil 55 %", [0.7, 16.03, 1262.53, 2.07, 10.0], 0.006),
    terrain("heavy clay 40 %", [0.11, 1.84, 103.27, 20.69, 6.0], 0.006),
    terrain("lean clay 32 %", [0.15, 1.52, 119.61, 13.79, 11.0], 0.006),
    terrain("snow (US, Harrison)", [1.6, 2.49, 245.90, 0.62, 23.2], 0.015),
    terrain("snow (Sweden)", [1.44, 10.55, 66.08, 6.0, 20.7], 0.015),
];

/// The dry sand of the wheel tests in robomechanics/3d-terramechanics, with the constants fitted there (read
/// in that repository).
pub const CMU_SAND: Terrain = terrain("CMU dry sand", [1.46, 0.0, 8000.0, 1.0, 29.0], 0.021);
