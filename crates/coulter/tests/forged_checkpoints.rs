//! A checkpoint from anybody, whole and with a hash that is right, whose contents are not those of its case:
//! it is refused, and nothing is written.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::model::model;
use coulter::case::{self, Case};
use coulter::history::{History, StageStart};
use coulter::interrupts::Interrupts;
use coulter::output::checkpoint::{self, Checkpoint, CheckpointView};
use coulter::run::{End, Follower, RunError, RunOptions, Start, run_followed};
use coulter::simulation::Next;
use solver::grid::{Grid, LANES};
use solver::halo::Halo;
use std::fs;
use std::path::Path;

/// A block that is pressed into a few cells of soil.
const CASE: &str = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\n\
    young_modulus = '5 MPa'\n[domain]\nx = ['-0.1 m', '0.1 m']\ny = ['-0.1 m', '0.1 m']\nz = ['-0.1 m', '0.1 m']\n\
    [grid]\ncell = '50 mm'\n[body.block]\nshape = 'block'\nsize = ['0.1 m', '0.1 m', '0.05 m']\nfriction = 0.3\n\
    heave = { speed = '-0.2 m/s', ramp = '1 ms' }\n[run]\nduration = '3 ms'\n[output]\nhistory_interval = '1 ms'\n";

/// Stops a run at its first sample.
struct Stopping;

impl Follower for Stopping {
    fn sampled(&mut self, _: &History) -> Next {
        Next::Stop("for the test".into())
    }
}

fn run(case: &Case, folder: &Path, start: Start) -> Result<End, RunError> {
    let interrupts = Interrupts::default();
    let options = RunOptions::quiet(folder, start, CASE, "case.toml", &interrupts);
    run_followed(case, &options, &mut Stopping)
}

fn write(folder: &Path, checkpoint: &Checkpoint, grid: &Grid) {
    let Checkpoint { case, state, history, last_sample, .. } = checkpoint;
    let (case, block) = (case.clone(), (grid, &Halo::whole()));
    let view = CheckpointView { precision: "double", case, state, block, history, last_sample };
    view.write(folder).unwrap();
    checkpoint::forget_previous(folder).unwrap();
}

/// What is changed in the contents, and how.
type Forgery = (&'static str, fn(&mut Checkpoint));

const FORGERIES: [Forgery; 22] = [
    ("short array of cells", |c| c.state.soil.fraction.truncate(1)),
    ("long array of nodes", |c| c.state.nodes.mass.push(1.0)),
    ("no history variable", |c| c.state.soil.history[0].clear()),
    ("another soil", |c| c.state.soil.composition.push(c.state.soil.mass.clone())),
    ("soils without cells", |c| c.state.soil.composition = vec![Vec::new(); 1 << 20]),
    ("no body", |c| c.state.bodies.clear()),
    ("a body without a pose", |c| c.state.mechanism.bodies.clear()),
    ("a joint", |c| c.state.mechanism.joints.push(Default::default())),
    ("no rim", |c| c.state.bodies[0].rim.clear()),
    ("a part", |c| c.state.bodies[0].parts.push(Default::default())),
    ("contact of no body", |c| c.state.contacts[0].body = 1),
    ("contact of no point", |c| c.state.contacts[0].point = u32::MAX),
    ("contact in no cell", |c| c.state.contacts[0].cell[2] = u32::MAX),
    ("contact in no octant", |c| c.state.contacts[0].octant = 8),
    ("contact with no soil", |c| c.state.contacts[0].material = 1),
    ("contacts in disorder", |c| c.state.contacts.reverse()),
    ("before the start", |c| c.state.time = -1.0),
    ("too many steps", |c| c.state.step = u64::MAX),
    ("no samples of a body", |c| c.history.bodies.clear()),
    ("no stride", |c| c.history.rims[0].stride = 0),
    ("no last impulses", |c| c.last_sample.impulses.clear()),
    ("a stage", |c| c.history.stages.push(StageStart { time: 0.0, motions: Vec::new() })),
];

#[test]
fn a_checkpoint_that_is_not_of_its_case_is_refused() {
    let (case, folder) = (case::parse(CASE, "small.toml", &[]).unwrap(), tempfile::tempdir().unwrap());
    let folder = folder.path();
    assert!(matches!(run(&case, folder, Start::Anew), Ok(End::Stopped(..))));
    let grid = model(&case, LANES).grid;
    let sound = Checkpoint::read_last(folder, &grid).unwrap();
    assert!(sound.state.contacts.len() > 1);
    let log = fs::read(folder.join("run.log")).unwrap();
    for (name, forge) in FORGERIES {
        let mut forged = sound.clone();
        forge(&mut forged);
        write(folder, &forged, &grid);
        let ended = run(&case, folder, Start::Resume);
        assert!(matches!(ended, Err(RunError::Unusable { .. })), "{name}: {ended:?}");
        assert_eq!(fs::read(folder.join("run.log")).unwrap(), log, "{name}");
    }
    write(folder, &sound, &grid);
    assert!(matches!(run(&case, folder, Start::Resume), Ok(End::Stopped(..))));
}
