//! Cases: their text, and nested maps.
#![no_main]

use coulter::case::{self, Case, CaseError};
use coulter_fuzz::{file, folder, show};
use libfuzzer_sys::fuzz_target;

fn look(found: Result<Case, CaseError>) {
    match found {
        Ok(case) => {
            let _ = (case::advice(&case), case::case_text(&case));
            assert!(case::estimate::estimate(&case).cells >= 1.0, "a grid without cells");
        }
        Err(error) => show(&error),
    }
}

fuzz_target!(|data: &[u8]| {
    let path = file("case.toml", data);
    look(case::load(&path, &[]));
    if data.len().is_multiple_of(8) {
        // The same but for what they do not ask for.
        look(case::load_for_forecast(&path, &[]).map(|(case, _)| case));
        let _ = case::load_soil(&path, &[]);
    }
    if let Ok(maps) = serde_json::from_slice(data) {
        look(case::from_json(&maps, &folder().join("case").to_string_lossy()));
    }
});
