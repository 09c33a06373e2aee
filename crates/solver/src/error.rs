//! What can go wrong in a step.

use glam::DVec3;
use std::fmt;
use thiserror::Error;

/// The physics failed: the state can no longer be trusted.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Breakdown {
    /// A field holds something that is not a number.
    #[error(
        "{field} is not a number at t = {time:.6} s (step {step}){location}; a smaller numerics.courant or a stiffer soil may help"
    )]
    NotANumber {
        /// Name of the field.
        field: String,
        /// Time of the breakdown [s].
        time: f64,
        /// Step of the breakdown.
        step: u64,
        /// Position of the breakdown.
        location: Location,
    },
    /// Soil moves so fast that it crosses most of a cell between two remaps.
    #[error(
        "soil moved {cells:.2} cells between two remaps at t = {time:.6} s (step {step}){location}; a smaller numerics.courant, \
         a slower body or a finer grid may help"
    )]
    Runaway {
        /// Distance between two remaps, in cells of the smallest width.
        cells: f64,
        /// Time of the breakdown [s].
        time: f64,
        /// Step of the breakdown.
        step: u64,
        /// Position of the breakdown.
        location: Location,
    },
    /// A freely moving body has left the box.
    #[error(
        "the body `{body}` left the box {side} at t = {time:.6} s (step {step}){location}; check its weight and loads, or make \
         the domain larger"
    )]
    LeftTheBox {
        /// Name of the body.
        body: String,
        /// Through which face of the box: "ahead", "below", …
        side: &'static str,
        /// Time of the breakdown [s].
        time: f64,
        /// Step of the breakdown.
        step: u64,
        /// Position of the body's reference point.
        location: Location,
    },
    /// The device that strains the soil does not do so any more.
    #[error("the device failed at t = {time:.6} s (step {step}): {why}")]
    Device {
        /// What the device says.
        why: String,
        /// Time of the failure [s].
        time: f64,
        /// Step of the failure.
        step: u64,
    },
    /// A check that the run can no longer pass.
    #[error("{what} at t = {time:.6} s (step {step}){location}; {cure}")]
    Untrustworthy {
        /// What is wrong, with the figure and its limit.
        what: String,
        /// What may help.
        cure: String,
        /// Time of the breakdown [s].
        time: f64,
        /// Step of the breakdown.
        step: u64,
        /// Position of the breakdown.
        location: Location,
    },
}

/// A position [m], where one is known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Location(Option<DVec3>);

impl Location {
    /// No position in particular.
    pub const UNKNOWN: Self = Self(None);

    /// A known position [m]; unknown if a coordinate is not a number.
    #[must_use]
    pub fn at(position: DVec3) -> Self {
        Self(Some(position).filter(|p| p.is_finite()))
    }
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(p) => write!(f, ", near ({:.4}, {:.4}, {:.4}) m", p.x, p.y, p.z),
            None => Ok(()),
        }
    }
}
