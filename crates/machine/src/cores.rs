//! How many cores this program may use, and how many threads a run has by default.
//!
//! The scheduler's word comes first, then OpenMP's, then what the system grants: `available_parallelism` of
//! the standard library, which heeds affinity and the quotas of control groups of both versions. Several
//! processes of a run on one machine share its cores.

use std::path::Path;

/// Cores of a task, as SLURM was asked for them.
const OF_TASK: &str = "SLURM_CPUS_PER_TASK";
/// Threads of a program, or a list of them by level.
const OPENMP: &str = "OMP_NUM_THREADS";
/// Cores that a SLURM job has on this machine.
const OF_JOB: &str = "SLURM_CPUS_ON_NODE";
/// Processes that a launcher has started on this machine: `OpenMPI`, MPICH and Intel MPI, MVAPICH.
const BESIDE: [&str; 3] = ["OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS", "MV2_COMM_WORLD_LOCAL_SIZE"];
/// Processors of each machine, of `srun`: `4(x2),3`; and which of the machines this is.
const BY_MACHINE: [&str; 2] = ["SLURM_STEP_TASKS_PER_NODE", "SLURM_NODEID"];

/// A number of cores or threads, and how it came about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cores {
    /// The number, at least one.
    pub count: usize,
    /// What was asked for and is not granted, or cannot be read.
    pub notes: Vec<String>,
}

/// Threads of a run, as asked for, or for 0 as many as [`threads_by_default`].
#[must_use]
pub fn threads(asked: usize) -> usize {
    if asked == 0 { threads_by_default().count } else { asked }
}

/// Threads of a run by default: `SLURM_CPUS_PER_TASK`, else `OMP_NUM_THREADS`, else one per core that this
/// process may use.
#[must_use]
pub fn threads_by_default() -> Cores {
    Place::here(&variable).cores(&[OF_TASK, OPENMP])
}

/// Cores that this program may fill with runs side by side: without OpenMP's number, which is that of one
/// run.
#[must_use]
pub fn cores() -> Cores {
    Place::here(&variable).cores(&[OF_TASK])
}

/// A variable of the environment.
fn variable(name: &str) -> Option<String> {
    std::env::var_os(name).map(|value| value.to_string_lossy().into_owned())
}

/// What is known of the place of this process.
struct Place<'a> {
    /// The value of a variable of the environment.
    variable: &'a dyn Fn(&str) -> Option<String>,
    /// Cores that this process may use.
    own: usize,
    /// Cores that all processes of this process's launcher may use together.
    together: usize,
}

impl<'a> Place<'a> {
    fn here(variable: &'a dyn Fn(&str) -> Option<String>) -> Self {
        let own = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        let mask = |process: &str| allowed(Path::new("/proc").join(process).join("status").as_path());
        let launcher = parent().and_then(|process| mask(&process));
        Self { variable, own, together: together(own, mask("self"), launcher) }
    }

    /// The cores that the first of these variables asks for that is set, or this process's share; never more
    /// than it may use, as threads that wait for each other on one core are slower than one.
    fn cores(&self, names: &[&str]) -> Cores {
        let mut notes = Vec::new();
        for name in names {
            let Some(asked) = self.number(name, first_of_list, &mut notes) else { continue };
            if asked > self.own {
                notes.push(format!(
                    "{name} asks for {asked} threads, but this process may use {own} of the machine's cores (affinity or control \
                     group) and has as many threads; --threads {asked} forces them",
                    own = self.own
                ));
            }
            return Cores { count: asked.min(self.own), notes };
        }
        let job = self.number(OF_JOB, |text| text.parse().ok(), &mut notes).unwrap_or(usize::MAX);
        let count = match self.processes(&mut notes) {
            1 => job,
            several => job.min(self.together) / several,
        };
        Cores { count: count.clamp(1, self.own), notes }
    }

    /// Processes of this run on this machine, as far as launchers say.
    fn processes(&self, notes: &mut Vec<String>) -> usize {
        let mut said: Vec<Option<usize>> =
            BESIDE.iter().map(|name| self.number(name, |text| text.parse().ok(), notes)).collect();
        let [list, place] = BY_MACHINE;
        if let Some(machine) = (self.variable)(place).and_then(|text| text.trim().parse().ok()) {
            said.push(self.number(list, |text| of_machine(text, machine), notes));
        }
        said.into_iter().flatten().max().unwrap_or(1)
    }

    /// The number, at least one, that a variable states; none where it is not set or empty. What cannot be
    /// read is noted.
    fn number(
        &self,
        name: &str,
        read: impl Fn(&str) -> Option<usize>,
        notes: &mut Vec<String>,
    ) -> Option<usize> {
        let text = (self.variable)(name)?;
        let text = text.trim();
        let number = read(text).filter(|number| *number > 0);
        if number.is_none() && !text.is_empty() {
            notes.push(format!("{name} is \"{text}\", which is not a number from 1 on: it is disregarded"));
        }
        number
    }
}

/// The first number of a list such as `4,2`.
fn first_of_list(text: &str) -> Option<usize> {
    text.split(',').next()?.trim().parse().ok()
}

/// The number of tasks of a machine in SLURM's list of them, such as `4(x2),3`.
fn of_machine(list: &str, machine: usize) -> Option<usize> {
    let mut first = 0;
    for part in list.split(',') {
        let (tasks, times) = match part.split_once("(x") {
            Some((tasks, times)) => (tasks, times.strip_suffix(')')?.parse().ok()?),
            None => (part, 1_usize),
        };
        first += times;
        if machine < first {
            return tasks.parse().ok();
        }
    }
    None
}

/// Cores that the processes of a launcher have together, from what this process may use, its mask and the
/// launcher's. A launcher that binds its processes, each to other cores, is not bound itself. Where this
/// process may use less than its mask there is a quota, of all.
fn together(own: usize, mask: Option<usize>, launcher: Option<usize>) -> usize {
    let has_quota = mask.is_some_and(|mask| own < mask);
    launcher.map_or(own, |launcher| if has_quota { launcher.min(own) } else { launcher })
}

#[cfg(unix)]
fn parent() -> Option<String> {
    Some(std::os::unix::process::parent_id().to_string())
}

/// Nothing: the parent process is not known (untested).
#[cfg(not(unix))]
fn parent() -> Option<String> {
    None
}

/// Number of cores in the mask of a process, from its status; known on Linux only.
fn allowed(status: &Path) -> Option<usize> {
    let text = std::fs::read_to_string(status).ok()?;
    let list = text.lines().find_map(|line| line.strip_prefix("Cpus_allowed_list:"))?;
    length(list.trim())
}

/// Number of cores in a list such as `0-3,8`.
fn length(list: &str) -> Option<usize> {
    let part = |part: &str| {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        let [first, last] = [first, last].map(|text| text.parse::<usize>().ok());
        Some(last?.checked_sub(first?)? + 1)
    };
    list.split(',').map(part).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cores(set: &[(&str, &str)], [own, together]: [usize; 2], names: &[&str]) -> Cores {
        let value = |name: &str| set.iter().find(|(n, _)| *n == name).map(|(_, value)| (*value).to_owned());
        Place { variable: &value, own, together }.cores(names)
    }

    /// The threads on a machine with 16 cores, without a word said.
    fn quiet(set: &[(&str, &str)], own: usize) -> usize {
        let Cores { count, notes } = cores(set, [own, 16], &[OF_TASK, OPENMP]);
        assert_eq!(notes, Vec::<String>::new());
        count
    }

    #[test]
    fn the_scheduler_comes_first_then_openmp_then_the_system() {
        assert_eq!(quiet(&[(OF_TASK, "8"), (OPENMP, "4")], 16), 8);
        assert_eq!(quiet(&[(OPENMP, "4")], 16), 4);
        assert_eq!(quiet(&[(OPENMP, " 4 , 2 ")], 16), 4);
        assert_eq!(quiet(&[(OF_TASK, ""), (OPENMP, " ")], 16), 16);
        assert_eq!(quiet(&[], 3), 3);
        assert_eq!(quiet(&[(OF_JOB, "6")], 16), 6);
        assert_eq!(cores(&[(OPENMP, "4")], [16, 16], &[OF_TASK]).count, 16);
    }

    #[test]
    fn what_cannot_be_granted_or_read_is_noted() {
        let default = |set: &[(&str, &str)]| cores(set, [2, 2], &[OF_TASK, OPENMP]);
        let Cores { count, notes } = default(&[(OF_TASK, "8")]);
        assert_eq!((count, notes.len()), (2, 1));
        assert!(notes[0].starts_with("SLURM_CPUS_PER_TASK asks for 8 threads, but this process may use 2 "));
        for value in ["many", "0", "-1", "2.5", ",2", "4x"] {
            let Cores { count, notes } = default(&[(OF_TASK, value), (OPENMP, "1")]);
            assert_eq!((count, notes.len()), (1, 1), "{value}");
            assert!(notes[0].contains(&format!("\"{value}\"")), "{}", notes[0]);
        }
        let Cores { count, notes } = default(&[(BESIDE[0], "two"), (OF_JOB, "x")]);
        assert_eq!((count, notes.len()), (2, 2));
    }

    #[test]
    fn processes_of_a_run_share_the_cores_of_their_machine() {
        for name in BESIDE {
            assert_eq!(quiet(&[(name, "4")], 16), 4);
        }
        assert_eq!(quiet(&[(BESIDE[0], "5")], 16), 3);
        assert_eq!(quiet(&[(BESIDE[0], "40")], 16), 1);
        assert_eq!(quiet(&[(BESIDE[0], "4"), (OF_JOB, "8")], 16), 2);
        // Bound to one core each, and to one of two sockets.
        assert_eq!(quiet(&[(BESIDE[0], "4")], 1), 1);
        assert_eq!(quiet(&[(BESIDE[0], "4")], 8), 4);
        assert_eq!(quiet(&[(BESIDE[0], "2")], 4), 4);
        // What was asked for is that of each.
        assert_eq!(quiet(&[(BESIDE[0], "4"), (OPENMP, "2")], 16), 2);
        // `srun`, on the third of three machines; and `mpirun`, whose daemons it has started.
        assert_eq!(quiet(&[(BY_MACHINE[0], "2(x2),8"), (BY_MACHINE[1], "2")], 16), 2);
        assert_eq!(quiet(&[(BY_MACHINE[0], "1(x3)"), (BY_MACHINE[1], "1"), (BESIDE[0], "4")], 16), 4);
        // A batch script names the tasks of its job, and has started none yet.
        assert_eq!(quiet(&[("SLURM_TASKS_PER_NODE", "8"), (BY_MACHINE[1], "0")], 16), 16);
    }

    #[test]
    fn a_quota_and_the_mask_of_the_launcher_are_those_of_all() {
        assert_eq!(together(1, Some(1), Some(8)), 8);
        assert_eq!(together(8, Some(8), Some(8)), 8);
        assert_eq!(together(4, Some(32), Some(32)), 4);
        assert_eq!(together(4, None, None), 4);
    }

    #[test]
    fn lists_are_read() {
        let list = |machine| of_machine("4(x2),3,5(x1)", machine);
        assert_eq!([0, 1, 2, 3, 4].map(list), [Some(4), Some(4), Some(3), Some(5), None]);
        assert_eq!([of_machine("4(x", 0), of_machine("4(y2)", 0), of_machine("", 0)], [None; 3]);
        assert_eq!(["0-3,8", "5", "0-127"].map(length), [Some(5), Some(1), Some(128)]);
        assert_eq!(["", "3-1", "a-b"].map(length), [None; 3]);
    }

    #[test]
    fn this_process_has_cores() {
        assert!(threads_by_default().count >= 1);
        assert_eq!(threads(3), 3);
        if cfg!(target_os = "linux") {
            assert!(allowed(Path::new("/proc/self/status")).unwrap() >= 1);
        }
    }
}
