//! The constants of the loops, from those of a model.

use super::Real;
use super::cells::{MaterialConstants, RowConstants};
use super::nodes::NodeConstants;
use super::physics::brick::hourglass_coefficient;
use super::physics::elastic::{Elastic, Stiffening};
use super::physics::law::Law;
use super::physics::viscosity::BulkViscosity;
use crate::material::Material;
use crate::model::{Method, Model};

/// The materials of a model.
pub(crate) fn of_materials(model: &Model) -> Vec<MaterialConstants> {
    model.materials.iter().map(|material| of_material(material, &model.method)).collect()
}

fn of_material(material: &Material, method: &Method) -> MaterialConstants {
    let hourglass = hourglass_coefficient(
        method.hourglass as Real,
        material.density as Real,
        material.wave_speed() as Real,
        1.0,
    );
    MaterialConstants {
        elastic: Elastic::cast(&material.elastic),
        stiffening: material.stiffening().as_ref().map(Stiffening::cast),
        yield_law: material.yield_law.as_ref().map(Law::cast),
        critical_density: material.critical_density.unwrap_or(0.0) as Real,
        densest: material.densest() as Real,
        loosest: material.loosest() as Real,
        viscosity: BulkViscosity::cast(&material.viscosity(method.bulk_viscosity)),
        hourglass,
    }
}

/// Constants of the rows, with the first material; `width_x` holds the widths of the columns, and ¼ of their
/// inverses.
pub(crate) fn of_rows<'a>(
    model: &Model,
    materials: &'a [MaterialConstants],
    width_x: &'a [Vec<Real>; 2],
    dt: f64,
) -> RowConstants<'a> {
    let [width_x, per_width_x] = width_x.each_ref().map(|w| &w[1..]);
    let hourglass_yielding = model.method.hourglass_yielding as Real;
    let has_cubes = model.grid.has_cubes();
    RowConstants {
        material: &materials[0],
        hourglass_yielding,
        has_cubes,
        width_x,
        per_width_x,
        dt: dt as Real,
    }
}

/// Constants of all nodes.
pub(crate) fn of_nodes(model: &Model, dt: f64) -> NodeConstants {
    /// Fraction of the mass of a full node.
    const LIGHT: f64 = 0.02;
    let light = LIGHT * model.least_density() * model.least_volume();
    let [dt, mass_moved, light] = [dt, model.mass_moved(), light].map(|x| x as Real);
    let gravity = (model.soil_gravity * model.down).to_array().map(|g| g as Real);
    let is_tilted = gravity[0] != 0.0 || gravity[1] != 0.0;
    let per_aspect = model.grid.aspect().to_array().map(|a| (1.0 / a) as Real);
    NodeConstants { dt, gravity, is_tilted, mass_moved, light, per_aspect }
}
