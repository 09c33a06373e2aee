//! N1: negative control. A test that cannot fail proves nothing: the wrong friction angle must fail.

use crate::error::VerifyError;
use crate::options::SuiteOptions;
use crate::row::Row;
use crate::runner::Runner;
use crate::{column, wall};

/// A variant, its benchmark, the override that makes it wrong, and how the names of the quantities that must
/// then fail begin.
type Control = (&'static str, fn(&mut Runner) -> Result<(), VerifyError>, &'static str, &'static str);

const CONTROLS: [Control; 2] = [
    ("B5 with the wrong φ", wall::run, "soil.friction_angle=34 deg", "K_p"),
    ("C1 with the wrong φ", column::run, "soil.friction_angle=20 deg", "run-out"),
];

pub(crate) fn run(runner: &mut Runner) -> Result<(), VerifyError> {
    for (variant, work, wrong, quantity) in CONTROLS {
        let options = SuiteOptions {
            fast: true,
            overrides: vec![wrong.to_owned()],
            threads: runner.options.threads,
            only_list: runner.options.only_list,
            ..SuiteOptions::default()
        };
        let expectations = runner.expectations;
        // Rows and balances of the wrong sand stay with a runner of their own.
        let mut rows = Vec::new();
        let mut progress = |text: &str| runner.report_progress(&format!("N1: {text}"));
        let mut wrong_runner = Runner::new(expectations, &options, &mut progress);
        work(&mut wrong_runner)?;
        rows.append(&mut wrong_runner.rows);
        let verdicts: Vec<bool> =
            rows.iter().filter(|r| r.quantity.starts_with(quantity)).filter_map(Row::passes).collect();
        let seconds = rows.iter().map(|r| r.seconds).fold(0.0, f64::max);
        let passing = verdicts.iter().filter(|passes| **passes).count();
        // Without a single judged row nothing has been controlled.
        let passing = if verdicts.is_empty() { f64::NAN } else { passing as f64 };
        let judged = verdicts.len() as f64;
        let figures = [("rows that still pass", passing), ("rows that were judged", judged)];
        runner.put("N1", variant, seconds, &figures)?;
    }
    Ok(())
}
