//! Benchmarks that take a second or less, run for real: every figure that is judged passes.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use verification::options::SuiteOptions;
use verification::{find, verify};

const QUICK: &[&str] = &["A1", "A5"];

#[test]
fn quick_benchmarks_pass() {
    for id in QUICK {
        let options = SuiteOptions { threads: 1, ..SuiteOptions::default() };
        let found = verify(&[find(id).unwrap()], &options, &mut |_| {});
        assert!(found.broken.is_empty(), "{:?}", found.broken);
        assert!(found.rows.iter().any(|row| row.passes() == Some(true)), "{id} judges nothing");
        assert!(found.rows.iter().all(|row| row.passes() != Some(false)), "{:#?}", found.rows);
    }
}
