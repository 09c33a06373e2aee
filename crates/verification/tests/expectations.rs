//! What is expected and what is read: every figure of the suite has an entry in an `expected.toml`, and every
//! entry a figure. Nothing is run: the benchmarks only list their rows.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use verification::expectation::{Suite, matches};
use verification::options::SuiteOptions;
use verification::row::Row;
use verification::{expectations, refine, verify};

fn options(suite: Suite) -> SuiteOptions {
    SuiteOptions { fast: suite == Suite::Fast, threads: 1, only_list: true, ..SuiteOptions::default() }
}

/// The rows of a part of the suite, without figures. A figure that nothing is expected of breaks its
/// benchmark down.
fn listed(suite: Suite) -> Vec<Row> {
    let mut silent = |_: &str| {};
    let all = match suite {
        // Only C1 enters rows on its finest meshes.
        Suite::Refine => {
            let few = refine::refine(&[], 3, &options(suite), &mut silent);
            vec![few, refine::refine(&["C1"], 5, &options(suite), &mut silent)]
        }
        _ => vec![verify(&[], &options(suite), &mut silent)],
    };
    let broken: Vec<_> = all.iter().flat_map(|found| &found.broken).collect();
    assert!(broken.is_empty(), "{broken:#?}");
    all.into_iter().flat_map(|found| found.rows).collect()
}

/// Entries of a part of the suite without a figure; those on the balances of other runs are left out, because
/// they need runs.
fn unused(suite: Suite) -> Vec<String> {
    let rows = listed(suite);
    let mut unused = Vec::new();
    for known in expectations().unwrap() {
        for entry in &known.row {
            for case in entry.cases(suite).iter().filter(|case| *case != "*") {
                let is_read = |row: &Row| {
                    row.id == known.id && row.quantity == entry.quantity && matches(case, &row.case)
                };
                if !rows.iter().any(is_read) {
                    unused.push(format!("{}: {case}: {}", known.id, entry.quantity));
                }
            }
        }
    }
    unused
}

#[test]
fn the_full_suite_reads_what_is_expected() {
    assert_eq!(unused(Suite::Full), [""; 0]);
}

#[test]
fn the_fast_suite_reads_what_is_expected() {
    assert_eq!(unused(Suite::Fast), [""; 0]);
}

#[test]
fn the_studies_of_convergence_read_what_is_expected() {
    assert_eq!(unused(Suite::Refine), [""; 0]);
}
