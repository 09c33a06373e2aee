//! Studies, and the cases that they name.
#![no_main]

use coulter::case::form::Form;
use coulter_fuzz::{file, show};
use libfuzzer_sys::fuzz_target;
use studies::study::{Design, Part, Study, points, read};

/// More points are possible, and take their time.
const MOST: usize = 1000;

fn is_small(study: &Study, part: &Part) -> bool {
    let levels = part.factors.iter().map(|n| study.factors[*n].levels.len());
    match part.design {
        Design::LatinHypercube | Design::Sobol => part.points <= MOST,
        _ => levels.fold(1_usize, usize::saturating_mul) <= MOST,
    }
}

fuzz_target!(|data: &[u8]| {
    let path = file("study.toml", data);
    for quick in [false, true] {
        match read(&path, quick) {
            Ok(study) => {
                for part in study.parts.iter().filter(|part| is_small(&study, part)) {
                    let case = study.case_of(part);
                    let _ =
                        Form::read(&case.text, &case.path).map(|tree| points(&study, part, &tree.entries));
                }
            }
            Err(error) => show(&error),
        }
    }
});
