//! What this machine has available: memory, within the limits of containers and job schedulers, and disk
//! space.
//!
//! Tested on Linux; on other systems the crate `sysinfo` reports the free memory, which is untested here.

use std::path::Path;

/// Where Linux mounts its control groups.
const GROUPS: &str = "/sys/fs/cgroup";

/// Memory that is available, and what sets the limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemoryLeft {
    /// Memory that is left [bytes].
    pub bytes: f64,
    /// Owner of the memory, to be read after "free": empty for that of the machine.
    pub of: &'static str,
}

/// What a run needs beside its grid, its contact points and its tables while it draws pictures and writes the
/// report, with its program and its libraries mapped [bytes], chosen. It counts where the system limits what
/// is mapped.
const BESIDE: f64 = 32e6;

/// Memory that is available to a run, where the system reports it: the free memory, or less where a control
/// group (of a container, of a SLURM job) or a limit of this process (`ulimit`, batch systems) allows less.
#[must_use]
pub fn memory_left() -> Option<MemoryLeft> {
    let free = sysinfo::System::new().ok().and_then(|mut system| {
        system.refresh_memory();
        Some(system.available_memory() as f64).filter(|bytes| *bytes > 0.0)
    });
    let own = std::fs::read_to_string("/proc/self/cgroup").unwrap_or_default();
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let [space, data] = limits();
    let within = |limit: Option<f64>, name: &str| Some((limit? - mapped(&status, name) - BESIDE).max(0.0));
    let all = [
        (free, ""),
        (left_in_groups(Path::new(GROUPS), &own), " in the control group (of a container or a job)"),
        (within(space, "VmSize:"), " within the limit of address space of this process (ulimit -v)"),
        (within(data, "VmData:"), " within the limit of data of this process (ulimit -d)"),
    ];
    let known = all.into_iter().filter_map(|(bytes, of)| Some(MemoryLeft { bytes: bytes?, of }));
    known.min_by(|a, b| a.bytes.total_cmp(&b.bytes))
}

/// Memory that is available [bytes], as [`memory_left`] finds it.
#[must_use]
pub fn memory_available() -> Option<f64> {
    memory_left().map(|left| left.bytes)
}

/// The limits of address space and of data of this process [bytes].
#[cfg(unix)]
fn limits() -> [Option<f64>; 2] {
    use rustix::process::{Resource, getrlimit};
    [Resource::As, Resource::Data].map(|resource| getrlimit(resource).current.map(|bytes| bytes as f64))
}

/// No limits: the system has none (untested).
#[cfg(not(unix))]
fn limits() -> [Option<f64>; 2] {
    [None; 2]
}

/// What of a limit is used, by its name in `/proc/self/status` [bytes]; 0 where the system has no such file.
fn mapped(status: &str, name: &str) -> f64 {
    let value = status.lines().find_map(|line| line.strip_prefix(name));
    let kilobytes: Option<f64> = value.and_then(|value| value.trim().strip_suffix("kB")?.trim().parse().ok());
    1024.0 * kilobytes.unwrap_or(0.0)
}

/// Free space on the file system of a folder, which need not exist yet [bytes]; `None` where it is not known.
#[must_use]
pub fn free_space(folder: &Path) -> Option<f64> {
    let absolute = std::path::absolute(folder).ok()?;
    let there = absolute.ancestors().find(|path| path.exists())?;
    fs4::available_space(there).ok().map(|bytes| bytes as f64)
}

/// Names of the files of a control group: its limit, its usage, and the portion of it that is only cached
/// [bytes].
struct Names {
    limit: &'static str,
    used: &'static str,
    cached: [&'static str; 2],
}

const FIRST: Names = Names {
    limit: "memory.limit_in_bytes",
    used: "memory.usage_in_bytes",
    cached: ["total_inactive_file", "total_active_file"],
};
const SECOND: Names =
    Names { limit: "memory.max", used: "memory.current", cached: ["inactive_file", "active_file"] };

/// Memory that is left in the control groups of this program, as `/proc/self/cgroup` names them, and in those
/// above them
/// [bytes]; `None` where none has a limit.
fn left_in_groups(mount: &Path, own: &str) -> Option<f64> {
    let groups = own.lines().filter_map(|line| {
        let (_, rest) = line.split_once(':')?;
        let (controllers, path) = rest.split_once(':')?;
        match controllers {
            "" => Some((mount.to_path_buf(), path, &SECOND)),
            _ if controllers.split(',').any(|c| c == "memory") => Some((mount.join("memory"), path, &FIRST)),
            _ => None,
        }
    });
    let left = groups.flat_map(|(top, path, names)| {
        let below = Path::new(path.trim_start_matches('/')).ancestors().map(Path::to_path_buf);
        below.filter_map(move |folder| left_in(&top.join(folder), names)).collect::<Vec<_>>()
    });
    left.reduce(f64::min)
}

/// Memory that is left in one group [bytes]; cached files are released on demand.
fn left_in(group: &Path, names: &Names) -> Option<f64> {
    let number = |name| std::fs::read_to_string(group.join(name)).ok()?.trim().parse::<f64>().ok();
    // Without a limit version 1 states the largest possible number, version 2 `max`.
    let limit = number(names.limit).filter(|bytes| *bytes < 1e18)?;
    let text = std::fs::read_to_string(group.join("memory.stat")).unwrap_or_default();
    let value = |line: &str| {
        let (name, value) = line.split_once(' ')?;
        names.cached.contains(&name).then(|| value.trim().parse::<f64>().ok())?
    };
    let cached: f64 = text.lines().filter_map(value).sum();
    Some((limit - number(names.used)? + cached).clamp(0.0, limit))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn group(at: &Path, files: &[(&str, &str)]) {
        std::fs::create_dir_all(at).unwrap();
        for (name, text) in files {
            std::fs::write(at.join(name), text).unwrap();
        }
    }

    #[test]
    fn the_narrowest_group_counts() {
        let top = tempfile::tempdir().unwrap();
        let job = top.path().join("slurm/job_7");
        group(&job, &[("memory.max", "4000000\n"), ("memory.current", "1500000\n")]);
        group(&job, &[("memory.stat", "anon 1\ninactive_file 300000\nactive_file 200000\nfile 9\n")]);
        group(&job.join("step_0"), &[("memory.max", "max\n"), ("memory.current", "10\n")]);
        let left = || left_in_groups(top.path(), "0::/slurm/job_7/step_0\n");
        assert_eq!(left(), Some(3e6));
        group(&top.path().join("slurm"), &[("memory.max", "2000000"), ("memory.current", "1900000")]);
        assert_eq!(left(), Some(1e5));
        assert_eq!(left_in_groups(top.path(), "0::/elsewhere\n"), None);
        assert_eq!(left_in_groups(top.path(), "no such\nfile"), None);
    }

    #[test]
    fn the_first_version_of_control_groups_is_read_too() {
        let top = tempfile::tempdir().unwrap();
        let memory = top.path().join("memory");
        let own = "5:cpu,memory:/docker/ab\n1:name=systemd:/\n";
        let none = [("memory.limit_in_bytes", "9223372036854771712"), ("memory.usage_in_bytes", "7")];
        group(&memory, &none);
        assert_eq!(left_in_groups(top.path(), own), None);
        // A container sees its own group as the top.
        group(&memory, &[("memory.limit_in_bytes", "1000000"), ("memory.usage_in_bytes", "1200000")]);
        assert_eq!(left_in_groups(top.path(), own), Some(0.0));
        group(&memory, &[("memory.stat", "inactive_file 1\ntotal_inactive_file 700000\n")]);
        assert_eq!(left_in_groups(top.path(), own), Some(5e5));
    }

    #[test]
    fn what_is_mapped_is_read() {
        let status = "Name:\tcoulter\nVmSize:\t  123456 kB\nVmData:\t   10 kB\n";
        assert_eq!([mapped(status, "VmSize:"), mapped(status, "VmData:")], [126_418_944.0, 10_240.0]);
        assert_eq!(mapped("", "VmSize:"), 0.0);
    }

    #[test]
    fn this_machine_has_memory_and_disk_space() {
        if cfg!(target_os = "linux") {
            assert!(memory_available().unwrap() > 1e6);
        }
        assert!(free_space(Path::new("no/such/folder/yet")).is_some_and(|bytes| bytes > 0.0));
    }
}
