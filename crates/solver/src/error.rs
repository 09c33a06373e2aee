//! What can go wrong in a step.

use glam::DVec3;
use std::fmt;
use thiserror::Error;

/// The physics failed: the state is not to be trusted any more.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum Breakdown {
    /// A field holds something that is not a number.
    #[error(
        "{field} is not a number at t = {time:.6} s (step {step}){place}; a smaller numerics.courant or a stiffer soil may help"
    )]
    NotANumber {
        /// Which field.
        field: String,
        /// When [s].
        time: f64,
        /// In which step.
        step: u64,
        /// Where.
        place: Place,
    },
    /// Soil moves so fast that it crosses a good part of a cell in one step.
    #[error(
        "soil moved {cells:.2} cells between two remaps at t = {time:.6} s (step {step}){place}; a smaller numerics.courant, \
         a slower body or a finer grid may help"
    )]
    Runaway {
        /// How far, in cells of the smallest width.
        cells: f64,
        /// When [s].
        time: f64,
        /// In which step.
        step: u64,
        /// Where.
        place: Place,
    },
    /// A body that moves freely has left the box.
    #[error(
        "the body `{body}` left the box {side} at t = {time:.6} s (step {step}){place}; check its weight and loads, or make \
         the domain larger"
    )]
    LeftTheBox {
        /// Name of the body.
        body: String,
        /// Through which face: "ahead", "below", …
        side: &'static str,
        /// When [s].
        time: f64,
        /// In which step.
        step: u64,
        /// Where its reference point is.
        place: Place,
    },
    /// A check of the run that cannot be passed any more.
    #[error("{what} at t = {time:.6} s (step {step}){place}; {cure}")]
    Untrustworthy {
        /// What is wrong, with the figure and its limit.
        what: String,
        /// What may help.
        cure: String,
        /// When [s].
        time: f64,
        /// In which step.
        step: u64,
        /// Where.
        place: Place,
    },
}

/// A place [m], where one is known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Place(Option<DVec3>);

impl Place {
    /// No place in particular.
    pub const UNKNOWN: Self = Self(None);

    /// This place [m]; unknown if a coordinate is not a number.
    #[must_use]
    pub fn at(place: DVec3) -> Self {
        Self(Some(place).filter(|p| p.is_finite()))
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(p) => write!(f, ", near ({:.4}, {:.4}, {:.4}) m", p.x, p.y, p.z),
            None => Ok(()),
        }
    }
}
