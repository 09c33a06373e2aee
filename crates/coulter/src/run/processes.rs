//! The processes that share a run, before each has its block of the grid.

use super::options::{RunError, RunOptions};
use solver::halo::Communicator;

/// The processes of a run, as one of them sees them. All must call the same functions in the same order.
pub(super) struct Processes {
    communicator: Box<dyn Communicator>,
}

impl Processes {
    /// The processes of a run.
    pub(super) fn of(options: &RunOptions) -> Self {
        Self { communicator: (options.communicator)() }
    }

    /// Number of this process, and of all.
    pub(super) fn place(&self) -> [usize; 2] {
        [self.communicator.rank(), self.communicator.size()]
    }

    /// The communicator, and what went through it.
    pub(super) fn into_communicator(self) -> Box<dyn Communicator> {
        self.communicator
    }

    /// Does what only the first process may do, such as to lock a folder, while the others wait; they have no
    /// result.
    ///
    /// # Errors
    /// That of the first process; in the others [`RunError::Elsewhere`].
    pub(super) fn first_alone<T>(
        &mut self,
        action: impl FnOnce() -> Result<T, RunError>,
    ) -> Result<Option<T>, RunError> {
        let own = (self.communicator.rank() == 0).then(action).transpose();
        self.agree(own)
    }

    /// Whether any process says yes.
    pub(super) fn is_anyone(&mut self, own: bool) -> bool {
        let mut said = [f64::from(u8::from(own))];
        self.communicator.largest(&mut said);
        said[0] > 0.0
    }

    /// The result of this process, if none has failed.
    ///
    /// # Errors
    /// The error of this process; where another one has failed, [`RunError::Elsewhere`].
    pub(super) fn agree<T>(&mut self, own: Result<T, RunError>) -> Result<T, RunError> {
        if self.is_anyone(own.is_err()) { own.and(Err(RunError::Elsewhere)) } else { own }
    }
}
