//! Checkpoints: files, and records with a head and a hash that are right, from which a run goes on to its
//! next sample.
#![no_main]

use coulter::case::{self, model::model};
use coulter::output::checkpoint::Checkpoint;
use coulter::run::Start;
use coulter_fuzz::{CASE, Files, files, folder, lay, run_small, seed};
use libfuzzer_sys::fuzz_target;
use solver::grid::{Grid, LANES};
use solver::portion::Portion;
use solver::state::State;
use std::sync::OnceLock;
use xxhash_rust::xxh3::xxh3_64;

/// The checkpoint in the folder of a run.
const LAST: &str = "checkpoints/last.checkpoint";
/// Bytes of magic word, version and layout, and of the hash at the end.
const ENDS: [usize; 2] = [16, 8];

/// The folder of a run that was stopped, its grid and a block of it, and its state.
struct Stopped {
    files: Files,
    grids: [Grid; 2],
    state: State,
}

fn stopped() -> &'static Stopped {
    static STOPPED: OnceLock<Stopped> = OnceLock::new();
    STOPPED.get_or_init(|| {
        let top = folder().join("run");
        run_small(&top, Start::Anew, true).expect("it runs");
        let mut files = files(&top);
        files.remove("checkpoints/previous.checkpoint");
        let case = case::parse(CASE, "small.toml", &[]).expect("the case is valid");
        let grid = model(&case, LANES).grid;
        let state = Checkpoint::read_last(&top, &grid).expect("it can be read").state;
        let [x, y, z] = grid.domain.clone();
        let part = y.start..y.start + 4;
        let portion = state.portion(&grid, [x.clone(), part.clone(), z.clone()]);
        let record = &files[LAST][ENDS[0]..files[LAST].len() - ENDS[1]];
        seed("file", &files[LAST]);
        seed("record", &zstd::decode_all(record).expect("it can be unpacked"));
        seed("portion", &postcard::to_stdvec(&portion).expect("it can be written"));
        let block = grid.block([x, part, z]);
        Stopped { files, grids: [grid, block], state }
    })
}

fuzz_target!(init: { stopped(); }, |data: &[u8]| {
    let Stopped { files, grids, state } = stopped();
    let top = folder().join("run");
    let packed = zstd::encode_all(data, 1).expect("it can be packed");
    let head = &files[LAST][..ENDS[0]];
    let record = [head, &packed, &xxh3_64(&packed).to_le_bytes()].concat();
    for content in [data, &record] {
        lay(&top, files, (LAST, content));
        let _ = Checkpoint::<f64>::read_last(&top, &grids[1]);
        let _ = run_small(&top, Start::Resume, true);
    }
    if let Ok(portion) = postcard::from_bytes::<Portion<f64>>(data)
        && portion.is_of(state, &grids[0])
    {
        state.clone().put(&grids[0], &portion);
    }
});
