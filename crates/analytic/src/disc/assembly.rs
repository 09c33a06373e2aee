//! Several discs on one axle or frame.

use super::{Disc, DiscForces, Mechanism, Model, Setting, disc_forces};
use crate::earth_pressure::Face;
use crate::error::{Answer, Refusal, within};

/// Equal discs side by side, at one sinkage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assembly {
    /// Number of discs n.
    pub count: u32,
    /// Distance between the middles of neighbours s [m], at least the thickness.
    pub spacing: f64,
}

/// Forces on the whole assembly [N]; angles and mechanism are those of one disc.
///
/// Group rule, an assumption of this project: touching discs (s = t) act as one disc of the thickness n t; discs whose
/// gap exceeds twice the reach r_f of the failure act alone; in between the two are mixed in proportion to the gap,
/// F = (1 − w) n F(t) + w F(n t), w = 1 − (s − t)/(2 r_f). Both ends are exact for the model; the middle is not tested.
///
/// # Errors
/// Unless 1 ≤ n ≤ 1000 and s ≥ t, and as [`disc_forces`].
pub fn assembly_forces(
    model: Model,
    setting: &Setting<'_>,
    assembly: &Assembly,
    sinkage: f64,
) -> Answer<DiscForces> {
    let count = within("number of discs", f64::from(assembly.count), 1.0, 1000.0)?;
    let thickness = setting.disc.thickness;
    let gap = within("disc spacing [m]", assembly.spacing, thickness, f64::MAX)? - thickness;
    let alone = disc_forces(model, setting, sinkage)?;
    let independent = 2.0 * reach(setting, sinkage)?;
    let wide = Disc { thickness: count * thickness, ..setting.disc };
    let share = (1.0 - gap / independent).max(0.0);
    if share == 0.0 || assembly.count == 1 {
        return Ok(scaled(&alone, count));
    }
    let together = disc_forces(model, &Setting { disc: wide, ..*setting }, sinkage)?;
    Ok(mixed(&scaled(&alone, count), &together, share))
}

/// How far before the disc the ground breaks [m]: the reach of the exact field without wall friction.
fn reach(setting: &Setting<'_>, sinkage: f64) -> Answer<f64> {
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

fn mixed(apart: &DiscForces, together: &DiscForces, share: f64) -> DiscForces {
    let mix = |a: f64, b: f64| (1.0 - share) * a + share * b;
    let sideways_share = mix(apart.sideways_share, together.sideways_share);
    let (drag, vertical) = (mix(apart.drag, together.drag), mix(apart.vertical, together.vertical));
    DiscForces {
        drag,
        vertical,
        normal: mix(apart.normal, together.normal),
        friction: mix(apart.friction, together.friction),
        rim_torque: mix(apart.rim_torque, together.rim_torque),
        force_inclination: drag.atan2(vertical),
        sideways_share,
        mechanism: Mechanism::of_share(sideways_share),
        ..if share < 0.5 { *apart } else { *together }
    }
}

impl Assembly {
    /// The sinkage-independent part of the rule's range, for a message before anything runs.
    ///
    /// # Errors
    /// Unless 1 ≤ n ≤ 1000 and s ≥ t.
    pub fn check(&self, disc: &Disc) -> Result<(), Refusal> {
        within("number of discs", f64::from(self.count), 1.0, 1000.0)?;
        within("disc spacing [m]", self.spacing, disc.thickness, f64::MAX)?;
        Ok(())
    }
}
