//! A model to start tests from.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used)]

use glam::DVec3;
use physics::elastic::{Elastic, Stiffening};
use physics::law::Law;
use physics::mohr_coulomb::MohrCoulomb;
use physics::sand::{Sand, SandParameters};
use solver::grid::Grid;
use solver::initial::Filling;
use solver::material::Material;
use solver::model::Model;

/// Equally spaced faces.
pub fn uniform(low: f64, high: f64, cells: usize) -> Vec<f64> {
    (0..=cells).map(|n| low + (high - low) * n as f64 / cells as f64).collect()
}

/// Dry sand without bodies, between smooth walls.
pub fn sand(faces: [Vec<f64>; 3]) -> Model {
    let elastic = Elastic::new(5e6, 0.3);
    let law = MohrCoulomb::new(elastic, 35_f64.to_radians(), 0.0, 0.0, 0.0);
    let material = Material {
        yield_law: Some(Law::MohrCoulomb(law)),
        k0: 0.43,
        strength: None,
        density_profile: None,
        ..Material::linear_elastic(elastic, 1600.0)
    };
    Model { gravity: 9.81, soil_gravity: 9.81, ..Model::bare(Grid::new(faces), material) }
}

/// Dense sand with its density as state, and a characteristic length [m].
pub fn dense_sand(characteristic_length: Option<f64>) -> Material {
    let elastic = Elastic::new(5e6, 0.3);
    let parameters = SandParameters {
        critical_friction: 33_f64.to_radians(),
        limit_density: [1350.0, 1650.0],
        bolton: [10.0, 0.7],
        reference_strain: 0.0009,
        compression_modulus: 20e6,
    };
    let law = Sand::new(elastic, Stiffening { least: 1e3, most: 2e4 }, &parameters);
    Material {
        yield_law: Some(Law::Sand(law)),
        k0: 0.45,
        strength: None,
        density_profile: None,
        characteristic_length,
        ..Material::linear_elastic(elastic, 1600.0)
    }
}

/// Soil everywhere below a height.
pub fn below(height: f64) -> Filling {
    Filling::between(DVec3::splat(-1e9), DVec3::new(1e9, 1e9, height))
}
