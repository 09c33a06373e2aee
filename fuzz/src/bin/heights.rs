//! Files of heights, each read as every format, placed in every way that it may need.
#![no_main]

use coulter_fuzz::{file, folder};
use input::height_file::{HeightFile, Placement};
use libfuzzer_sys::fuzz_target;

const ENDS: [Option<[f64; 2]>; 2] = [Some([-1.0, 1.0]); 2];

fuzz_target!(|data: &[u8]| {
    let none = Placement::default();
    let over = Placement { unit: Some(1e-3), ends: ENDS, ..none };
    let grey = Placement { ends: ENDS, heights: Some([-0.1, 0.1]), ..none };
    let ways = [("csv", none), ("csv", over), ("xyz", none), ("tif", none), ("tif", over), ("png", grey)];
    for (extension, placement) in ways {
        let name = format!("heights.{extension}");
        file(&name, data);
        match HeightFile::load(folder(), &name, &placement) {
            Ok(found) => assert!((0..2).all(|axis| found.heights().ends(axis).iter().all(|x| x.is_finite()))),
            Err(problem) => assert!(!problem.message.is_empty() && !problem.cure.is_empty()),
        }
    }
});
