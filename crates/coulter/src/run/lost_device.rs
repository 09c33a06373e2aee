//! Runs whose device is lost: interrupted, and resumed to the bits of an undisturbed run.

use super::*;
use crate::interrupts::Interrupts;
use crate::simulation::Next;
use results::Inside;
use results::history::History;
use solver::device::replay::Replay;
use solver::device::{Address, Driver, Launch};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

const COLUMN: &str = include_str!("../../../../cases/column_collapse.toml");

/// More bytes than sums and contact nodes: a field.
const FIELD: usize = 4000;

/// A stand-in that gives back no more than a number of fields.
#[derive(Debug)]
struct Losing {
    device: Replay,
    /// Fields that were given back.
    read: Arc<AtomicU64>,
    most: u64,
}

impl Driver for Losing {
    fn allocate(&mut self, bytes: usize) -> Result<Address, DeviceError> {
        self.device.allocate(bytes)
    }

    fn free(&mut self, address: Address) {
        self.device.free(address);
    }

    fn clear(&mut self, at: Address, bytes: usize) -> Result<(), DeviceError> {
        self.device.clear(at, bytes)
    }

    fn write(&mut self, to: Address, bytes: &[u8]) -> Result<(), DeviceError> {
        self.device.write(to, bytes)
    }

    fn read(&mut self, from: Address, bytes: &mut [u8]) -> Result<(), DeviceError> {
        if bytes.len() > FIELD && self.read.fetch_add(1, Ordering::Relaxed) >= self.most {
            return Err(DeviceError("the device is lost".to_owned()));
        }
        self.device.read(from, bytes)
    }

    fn begin_read(&mut self, from: Address, bytes: usize) -> Result<(), DeviceError> {
        self.device.begin_read(from, bytes)
    }

    fn end_read(&mut self, bytes: &mut [u8]) -> Result<(), DeviceError> {
        self.device.end_read(bytes)
    }

    fn launch(&mut self, launch: Launch) -> Result<(), DeviceError> {
        self.device.launch(launch)
    }

    fn crossed(&self) -> u64 {
        self.device.crossed()
    }

    fn name(&self) -> &str {
        self.device.name()
    }

    fn free_memory(&self) -> Option<f64> {
        self.device.free_memory()
    }
}

/// Stops a run after a number of samples.
struct Stopping(usize);

impl Follower for Stopping {
    fn sampled(&mut self, history: &History) -> Next {
        if history.energy.len() > self.0 { Next::Stop("enough".to_owned()) } else { Next::Continue }
    }
}

/// A column that collapses, in folders of its own.
struct Runs {
    case: Case,
    root: tempfile::TempDir,
    interrupts: Interrupts,
}

impl Runs {
    fn new() -> Self {
        let coarse = ["grid.cell=30 mm", "run.duration=0.15 s", "output.history_interval=10 ms"];
        let case = case::parse(COLUMN, "case.toml", &coarse.map(str::to_owned)).unwrap();
        Self { case, root: tempfile::tempdir().unwrap(), interrupts: Interrupts::default() }
    }

    fn checkpoint(&self, name: &str) -> Vec<u8> {
        Inside::at(&checkpoint::path(&self.root.path().join(name))).read(1 << 30).unwrap()
    }

    /// Begins a run, or goes on with it, on a device of the caller.
    fn run(&self, name: &str, driver: Box<dyn Driver>, leader: Leader) -> Result<End, RunError> {
        let folder = self.root.path().join(name);
        let options = RunOptions::quiet(&folder, Start::AutoResume, COLUMN, "case.toml", &self.interrupts);
        let _lock = lock(&self.case, &options).unwrap();
        let mut opened = open::<f64>(&self.case, &options).unwrap();
        opened.simulation.use_device(driver).unwrap();
        run_opened(opened, Instant::now(), &options, &Part::default(), leader)
    }

    /// Starts or resumes a run as a scheduler does.
    fn auto_resume(&self, name: &str) -> Result<End, RunError> {
        let folder = self.root.path().join(name);
        let quiet = RunOptions::quiet(&folder, Start::AutoResume, COLUMN, "case.toml", &self.interrupts);
        run(&self.case, &RunOptions { device: Device::StandIn, ..quiet })
    }

    /// Loses a device of a run that was stopped on the way, and has a scheduler take it up again.
    fn lose(&self, name: &str, device: Box<dyn Driver>) {
        let stopped = self.run(name, Box::new(Replay::default()), Leader::Case(&mut Stopping(4)));
        assert!(matches!(stopped, Ok(End::Stopped(..))), "{name}: {stopped:?}");
        let before = self.checkpoint(name);
        let lost = self.run(name, device, Leader::Case(&mut NoFollower));
        assert!(matches!(lost, Err(RunError::Lost(_))), "{name}: {lost:?}");
        assert!(self.checkpoint(name) == before, "{name}: the last good checkpoint is unchanged");
        let folder = self.root.path().join(name);
        assert!(!checkpoint::failed_path(&folder).exists(), "{name}: half a state is none");
        let resumed = self.auto_resume(name);
        assert!(matches!(resumed, Ok(End::Finished(_))), "{name}: {resumed:?}");
    }
}

#[test]
fn a_run_whose_device_is_lost_is_resumed_to_the_same_bits() {
    let runs = Runs::new();
    let read = Arc::<AtomicU64>::default();
    let counting = Losing { device: Replay::default(), read: read.clone(), most: u64::MAX };
    let ended = runs.run("whole", Box::new(counting), Leader::Case(&mut NoFollower));
    assert!(matches!(ended, Ok(End::Finished(_))), "{ended:?}");
    let whole = runs.checkpoint("whole");
    let mut launches = Replay::default();
    launches.lost_after = Some(300);
    runs.lose("a launch", Box::new(launches));
    assert!(runs.checkpoint("a launch") == whole);
    // In a remap or at a sample, and with the state of the end.
    for most in [40, 41, read.load(Ordering::Relaxed) / 2] {
        let device = Losing { device: Replay::default(), read: Arc::default(), most };
        let name = format!("field {most}");
        runs.lose(&name, Box::new(device));
        assert!(runs.checkpoint(&name) == whole, "{most}");
    }
    let most = read.load(Ordering::Relaxed) - 1;
    let device = Losing { device: Replay::default(), read: Arc::default(), most };
    let lost = runs.run("the last field", Box::new(device), Leader::Case(&mut NoFollower));
    assert!(matches!(lost, Err(RunError::Lost(_))), "{lost:?}");
    assert!(runs.auto_resume("the last field").is_ok());
    assert!(runs.checkpoint("the last field") == whole);
}
