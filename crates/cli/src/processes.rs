//! The processes of a run for which several were started: with MPI, where the program was built with it.

use crate::failure::Failure;
use solver::halo::Communicator;

/// Variables in which launchers say how many processes they have started.
const LAUNCHED: [&str; 5] =
    ["OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MPI_LOCALNRANKS", "MV2_COMM_WORLD_SIZE", "SLURM_STEP_NUM_TASKS"];

/// How many processes a launcher has started for this command.
fn launched() -> usize {
    let said = LAUNCHED.iter().filter_map(|name| std::env::var(name).ok()?.parse().ok());
    said.max().unwrap_or(1)
}

/// All processes of a command, until its end.
pub(crate) struct World {
    /// MPI, where a launcher has started several processes.
    universe: Option<line::Universe>,
}

impl World {
    /// Joins the others, if a launcher has started any.
    pub(crate) fn begin() -> Result<Self, Failure> {
        let universe = if launched() > 1 { Some(line::join(launched())?) } else { None };
        Ok(Self { universe })
    }

    pub(crate) fn is_first(&self) -> bool {
        self.universe.as_ref().is_none_or(|universe| line::place(universe)[0] == 0)
    }

    /// Ends the work of this process, alike in all. Of several the first says why it failed, here and now: a
    /// launcher that sees one of them leave with a failure ends the others, which wait for each other only as
    /// long as there is a world.
    pub(crate) fn conclude(&self, outcome: Result<(), Failure>) -> Result<(), Failure> {
        outcome.map_err(|failure| {
            if self.size() == 1 {
                return failure;
            }
            if self.is_first() {
                failure.report();
            }
            failure.unsaid()
        })
    }

    pub(crate) fn size(&self) -> usize {
        self.universe.as_ref().map_or(1, |universe| line::place(universe)[1])
    }
}

#[cfg(not(feature = "mpi"))]
mod line {
    use super::{Communicator, Failure};
    pub(super) use std::convert::Infallible as Universe;

    /// Refuses to be one of several processes, each of which would run the whole case.
    pub(super) fn join(count: usize) -> Result<Universe, Failure> {
        Err(Failure::Request(format!(
            "{count} processes were started, but this program is built without MPI, and each would run the whole case; build it with \
             `cargo build --release --features mpi`, or start one process with --threads"
        )))
    }

    pub(super) fn place(universe: &Universe) -> [usize; 2] {
        match *universe {}
    }

    /// The communicator of a run in one process.
    pub(crate) fn communicator() -> Box<dyn Communicator> {
        coulter::run::alone()
    }
}

#[cfg(feature = "mpi")]
mod line {
    use super::{Communicator, Failure};
    use mpi::Threading;
    pub(super) use mpi::environment::Universe;
    use mpi::topology::SimpleCommunicator;
    use mpi::traits::Communicator as _;
    use std::sync::atomic::{AtomicBool, Ordering};

    /// Whether MPI has been initialised.
    static HAS_BEGUN: AtomicBool = AtomicBool::new(false);

    /// Joins so many processes.
    pub(super) fn join(count: usize) -> Result<Universe, Failure> {
        let begun = mpi::initialize_with_threading(Threading::Serialized);
        let Some((universe, threading)) = begun else {
            return Err(Failure::Request("MPI cannot be initialised".to_owned()));
        };
        if threading < Threading::Serialized {
            return Err(Failure::Request("this MPI library does not work with threads".to_owned()));
        }
        if universe.world().size() == 1 {
            return Err(Failure::Request(format!(
                "{count} processes were started, but MPI knows of one only, and each would run the whole case: this program was built \
                 for another MPI library than that of the launcher; start it with mpirun of the library it was built with, or with \
                 `srun --mpi=pmix`"
            )));
        }
        HAS_BEGUN.store(true, Ordering::Relaxed);
        // A process that panics would keep the others waiting for it.
        let report = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            report(panic);
            SimpleCommunicator::world().abort(101);
        }));
        Ok(universe)
    }

    /// Number of this process, and of all.
    pub(super) fn place(universe: &Universe) -> [usize; 2] {
        let world = universe.world();
        [world.rank() as usize, world.size() as usize]
    }

    /// The communicator of a run.
    pub(crate) fn communicator() -> Box<dyn Communicator> {
        if HAS_BEGUN.load(Ordering::Relaxed) {
            Box::new(solver::halo::mpi::World::default())
        } else {
            coulter::run::alone()
        }
    }
}

pub(crate) use line::communicator;
