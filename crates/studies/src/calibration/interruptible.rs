//! A response that can be interrupted.

use super::likelihood::{Response, Seen};
use coulter::interrupts::Interrupts;

/// A response that has no value anywhere once a stop is requested: fits and samplers then finish at once.
pub(super) struct Interruptible<'a> {
    /// The response.
    pub(super) response: &'a dyn Response,
    /// Requests to stop.
    pub(super) interrupts: &'a Interrupts,
}

impl Response for Interruptible<'_> {
    fn at(&self, values: &[f64]) -> Result<Seen, String> {
        match self.interrupts.stopped_by() {
            Some(_) => Err("stopped".to_owned()),
            None => self.response.at(values),
        }
    }
}
