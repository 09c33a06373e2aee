//! Several discs on one axle or frame.

use super::{Disc, DiscForces, Mechanism, Model, Setting, disc_forces};
use crate::earth_pressure::Face;
use crate::error::{ModelError, ModelResult, within};

/// Equal discs side by side at the same sinkage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assembly {
    /// Number of discs n.
    pub count: u32,
    /// Centre-to-centre spacing s [m], at least the thickness.
    pub spacing: f64,
}

/// Forces on the whole assembly [N]; angles and mechanism are those of one disc.
///
/// Group rule, derived for this project: touching discs (s = t) act as one disc of thickness n t; discs whose
/// gap exceeds twice the rupture distance r_f act independently. Beside each disc soil fails in a wedge whose
/// height falls to zero over r_f; two such wedges at a gap s − t share a triangle, which is to the one that
/// they share when the discs touch as (1 − (s − t)/(2 r_f))² to 1. That is the weight w of
/// F = (1 − w) n F(t) + w F(n t). Both limits are exact for the model. The square was taken after the forces
/// of discs in D9 were known, which an overlap that falls linearly missed (docs/models/disc-assembly.md).
///
/// # Errors
/// Unless 1 ≤ n ≤ 1000 and s ≥ t, and as [`disc_forces`].
pub fn assembly_forces(
    model: Model,
    setting: &Setting<'_>,
    assembly: &Assembly,
    sinkage: f64,
) -> ModelResult<DiscForces> {
    let count = within("number of discs", f64::from(assembly.count), 1.0, 1000.0)?;
    let thickness = setting.disc.thickness;
    let gap = within("disc spacing [m]", assembly.spacing, thickness, f64::MAX)? - thickness;
    let single = disc_forces(model, setting, sinkage)?;
    let independent = 2.0 * rupture_distance(setting, sinkage)?;
    let wide = Disc { thickness: count * thickness, ..setting.disc };
    let weight = (1.0 - gap / independent).max(0.0).powi(2);
    if weight == 0.0 || assembly.count == 1 {
        return Ok(scaled(&single, count));
    }
    let together = disc_forces(model, &Setting { disc: wide, ..*setting }, sinkage)?;
    Ok(interpolated(&scaled(&single, count), &together, weight))
}

/// Rupture distance before the disc [m]: that of the exact field without wall friction.
fn rupture_distance(setting: &Setting<'_>, sinkage: f64) -> ModelResult<f64> {
    let contact = setting.disc.contact(sinkage, 0.0)?;
    let face = Face {
        friction_angle: setting.soil.friction_angle,
        wall_friction: 0.0,
        surface: contact.inclination,
        backfill: setting.backfill,
    };
    let field = setting.passive.field(&face)?;
    Ok(field.rupture_ratio * contact.chord)
}

fn scaled(one: &DiscForces, count: f64) -> DiscForces {
    DiscForces {
        drag: count * one.drag,
        vertical: count * one.vertical,
        normal: count * one.normal,
        friction: count * one.friction,
        rim_torque: count * one.rim_torque,
        ..*one
    }
}

/// Forces between those of independent discs and those of one wide disc, which has this weight.
fn interpolated(independent: &DiscForces, together: &DiscForces, weight: f64) -> DiscForces {
    let mix = |a: f64, b: f64| (1.0 - weight) * a + weight * b;
    let sideways_fraction = mix(independent.sideways_fraction, together.sideways_fraction);
    let (drag, vertical) =
        (mix(independent.drag, together.drag), mix(independent.vertical, together.vertical));
    DiscForces {
        drag,
        vertical,
        normal: mix(independent.normal, together.normal),
        friction: mix(independent.friction, together.friction),
        rim_torque: mix(independent.rim_torque, together.rim_torque),
        force_inclination: drag.atan2(vertical),
        sideways_fraction,
        mechanism: Mechanism::governing(sideways_fraction),
        ..if weight < 0.5 { *independent } else { *together }
    }
}

impl Assembly {
    /// Checks count and spacing, which do not depend on the sinkage.
    ///
    /// # Errors
    /// Unless 1 ≤ n ≤ 1000 and s ≥ t.
    pub fn check(&self, disc: &Disc) -> Result<(), ModelError> {
        within("number of discs", f64::from(self.count), 1.0, 1000.0)?;
        within("disc spacing [m]", self.spacing, disc.thickness, f64::MAX)?;
        Ok(())
    }
}
