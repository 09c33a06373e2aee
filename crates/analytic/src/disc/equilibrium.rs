//! Equilibrium sinkage: where the soil carries the weight.

use super::{Disc, DiscForces, Model, Setting, disc_forces, vertical_force};
use crate::error::{ModelResult, positive, undefined};
use numerics::search::root;

/// Largest sinkage searched, as a fraction of the diameter.
pub const MAX_RELATIVE_SINKAGE: f64 = 0.9;

/// Equilibrium sinkage of a disc, if there is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Equilibrium {
    /// The soil carries the weight.
    At {
        /// Sinkage z [m].
        sinkage: f64,
        /// Forces there.
        forces: DiscForces,
    },
    /// The soil carries the weight at no sinkage up to 0.9 d: the disc digs in.
    None {
        /// Largest weight carried at any sinkage [N].
        largest_weight: f64,
        /// Sinkage at which the largest weight is carried [m].
        sinkage: f64,
    },
}

/// The least sinkage at which F_V equals the weight [N].
///
/// F_V of a free disc increases with sinkage; that of a locked disc levels off, so a heavy one may have no
/// equilibrium.
///
/// # Errors
/// If an input is out of range or the model has no result at any sinkage.
pub fn equilibrium(model: Model, setting: &Setting<'_>, weight: f64) -> ModelResult<Equilibrium> {
    let vertical = |z: f64| vertical_force(model, setting, z);
    equilibrium_of(&setting.disc, weight, vertical, |z| disc_forces(model, setting, z))
}

/// [`equilibrium`] of anything whose forces are known as a function of sinkage [m], such as an assembly of
/// discs.
///
/// `vertical` gives the vertical force [N] alone and is evaluated often; `forces` is evaluated once, at the
/// result.
///
/// # Errors
/// If the weight [N] is not positive, or `vertical` has no value at a tenth of the diameter.
pub fn equilibrium_of(
    disc: &Disc,
    weight: f64,
    vertical: impl Fn(f64) -> ModelResult<f64>,
    forces: impl Fn(f64) -> ModelResult<DiscForces>,
) -> ModelResult<Equilibrium> {
    positive("weight [N]", weight)?;
    disc.check()?;
    // Evaluated once beforehand, so that an input out of range is reported as such.
    vertical(0.1 * disc.diameter)?;
    match equilibrium_depth(disc.diameter, weight, 1e-15, |z| vertical(z).unwrap_or(f64::NAN)) {
        Ok(sinkage) => {
            let forces = forces(sinkage)?;
            check_weight_carried(weight, forces.vertical, 1e-6)?;
            Ok(Equilibrium::At { sinkage, forces })
        }
        Err((largest_weight, sinkage)) => Ok(Equilibrium::None { largest_weight, sinkage }),
    }
}

/// Checks that a vertical force [N] equals the weight [N] to the relative `tolerance`.
///
/// Under a brake or a motor a disc may jump from sliding to rolling as it sinks, and its vertical force past
/// the weight.
///
/// # Errors
/// If the two differ by more.
pub(crate) fn check_weight_carried(weight: f64, vertical: f64, tolerance: f64) -> ModelResult<()> {
    if (vertical / weight - 1.0).abs() <= tolerance {
        return Ok(());
    }
    undefined(
        "the equilibrium sinkage",
        "no steady state: at the sinkage that would carry the weight, the torque makes the disc jump between sliding and \
         rolling",
    )
}

/// The least sinkage [m] at which `vertical` reaches `weight` [N].
///
/// `vertical` returns NaN where the model has no result; the search skips such sinkages. `precision` is
/// relative to the diameter (for other bodies, to the height); one finer than the smoothness of `vertical`
/// slows the search down.
///
/// # Errors
/// The largest vertical force [N] and its sinkage [m], if no sinkage up to [`MAX_RELATIVE_SINKAGE`] carries
/// the weight.
pub fn equilibrium_depth(
    diameter: f64,
    weight: f64,
    precision: f64,
    vertical: impl Fn(f64) -> f64,
) -> Result<f64, (f64, f64)> {
    let excess = |relative: f64| vertical(relative * diameter) / weight - 1.0;
    let shallow = (0..9).map(|n| 1e-9 * 8_f64.powi(n));
    // Steps short enough not to miss the shallow maximum of a locked disc.
    let deep = (0..24).map(|n| 0.05 + 0.037 * f64::from(n));
    let (mut last, mut most) = (0.0, (f64::NEG_INFINITY, 0.0));
    for relative in shallow.chain(deep).map(|z| z.min(MAX_RELATIVE_SINKAGE)) {
        let here = excess(relative);
        if here >= 0.0 {
            let bracketed = if last > 0.0 { root(last, relative, precision, excess) } else { None };
            return Ok(bracketed.unwrap_or(relative) * diameter);
        }
        if here.is_finite() {
            last = relative;
            if here > most.0 {
                most = (here, relative);
            }
        }
    }
    Err(((1.0 + most.0.max(-1.0)) * weight, most.1 * diameter))
}
