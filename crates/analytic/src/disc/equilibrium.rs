//! The sinkage at which the soil carries the weight.

use super::{Disc, DiscForces, Model, Setting, disc_forces, vertical_force};
use crate::error::{Answer, none, positive};
use crate::numeric::root;

/// The deepest sinkage searched, as a fraction of the diameter.
pub const DEEPEST: f64 = 0.9;

/// Whether and where a disc comes to rest at a depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Equilibrium {
    /// The soil carries the weight.
    At {
        /// Sinkage z [m].
        sinkage: f64,
        /// Forces there.
        forces: DiscForces,
    },
    /// No sinkage up to 0.9 d carries the weight: the disc digs in.
    None {
        /// The largest weight that would be carried [N].
        largest_weight: f64,
        /// Sinkage at which it would be [m].
        sinkage: f64,
    },
}

/// The least sinkage at which F_V equals the weight [N].
///
/// F_V grows with the sinkage of a free disc; that of a locked one levels off, so that a heavy one may find no rest.
///
/// # Errors
/// If an input is out of range or the model has no answer anywhere.
pub fn equilibrium(model: Model, setting: &Setting<'_>, weight: f64) -> Answer<Equilibrium> {
    let vertical = |z: f64| vertical_force(model, setting, z);
    equilibrium_of(&setting.disc, weight, vertical, |z| disc_forces(model, setting, z))
}

/// [`equilibrium`] of anything whose forces are known at every sinkage [m], such as an assembly of discs.
///
/// `vertical` is the vertical force [N] alone, which the search asks for often; `forces` is asked once, at the end.
///
/// # Errors
/// If the weight [N] is not positive, or `vertical` has no answer at a tenth of the diameter.
pub fn equilibrium_of(
    disc: &Disc,
    weight: f64,
    vertical: impl Fn(f64) -> Answer<f64>,
    forces: impl Fn(f64) -> Answer<DiscForces>,
) -> Answer<Equilibrium> {
    positive("weight [N]", weight)?;
    disc.check()?;
    // An answer at some depth is asked for first, so that a bad input is refused with its own reason.
    vertical(0.1 * disc.diameter)?;
    match first_depth(disc.diameter, weight, 1e-15, |z| vertical(z).unwrap_or(f64::NAN)) {
        Ok(sinkage) => {
            let forces = forces(sinkage)?;
            carries(weight, forces.vertical, 1e-6)?;
            Ok(Equilibrium::At { sinkage, forces })
        }
        Err((largest_weight, sinkage)) => Ok(Equilibrium::None { largest_weight, sinkage }),
    }
}

/// Refuses a vertical force [N] that is not the weight [N] to `tolerance`: under a brake or an engine a disc that sinks may
/// jump from sliding to rolling, and the vertical force with it, past the weight.
///
/// # Errors
/// As said.
pub(crate) fn carries(weight: f64, vertical: f64, tolerance: f64) -> Answer<()> {
    if (vertical / weight - 1.0).abs() <= tolerance {
        return Ok(());
    }
    none(
        "the equilibrium sinkage",
        "no steady state: where the soil would carry the weight, the torque makes the disc jump between sliding and rolling",
    )
}

/// The least sinkage [m] at which `vertical` reaches `weight` [N]; otherwise the largest value met, and where.
///
/// Where `vertical` is not a number the model has no answer, and the search goes on beyond. `precision`, as a fraction of
/// the diameter (of another body: its height), should not be finer than `vertical` is smooth, or the search takes long.
///
/// # Errors
/// The largest vertical force [N] and its sinkage [m], if no sinkage up to [`DEEPEST`] carries the weight.
pub fn first_depth(
    diameter: f64,
    weight: f64,
    precision: f64,
    vertical: impl Fn(f64) -> f64,
) -> Result<f64, (f64, f64)> {
    let excess = |relative: f64| vertical(relative * diameter) / weight - 1.0;
    let shallow = (0..9).map(|n| 1e-9 * 8_f64.powi(n));
    // Beyond, steps short enough not to jump over a locked disc's shallow summit.
    let deep = (0..24).map(|n| 0.05 + 0.037 * f64::from(n));
    let (mut last, mut most) = (0.0, (f64::NEG_INFINITY, 0.0));
    for relative in shallow.chain(deep).map(|z| z.min(DEEPEST)) {
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
