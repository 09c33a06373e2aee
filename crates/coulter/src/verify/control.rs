//! N1: a test that cannot fail proves nothing. The wrong friction angle must fail.

use super::bench::Bench;
use super::error::VerifyError;
use super::options::Wish;
use super::row::Row;
use super::{column, wall};

const SOURCE: &str = "a test that cannot fail proves nothing";

/// What it is about.
pub(super) const ABOUT: &str = "Two benchmarks once more, coarse, with sand that is deliberately not the one they expect: the passive \
    wall (B5) with φ = 34° for 30°, and the column (C1) with φ = 20° for 37°. The run-out of the column and every K_p that is \
    judged must fall short; the number of those that pass all the same must be 0.";

/// A benchmark, what its sand is given, and the quantities that must then fall short begin with.
type Control = (&'static str, fn(&mut Bench) -> Result<(), VerifyError>, &'static str, &'static str);

const CONTROLS: [Control; 2] = [
    ("B5 with the wrong φ", wall::run, "soil.friction_angle=34 deg", "K_p"),
    ("C1 with the wrong φ", column::run, "soil.friction_angle=20 deg", "run-out"),
];

pub(super) fn run(bench: &mut Bench) -> Result<(), VerifyError> {
    for (variant, work, wrong, quantity) in CONTROLS {
        let wish = Wish {
            fast: true,
            overrides: vec![wrong.to_owned()],
            threads: bench.wish.threads,
            ..Wish::default()
        };
        // Rows and ledgers of the wrong sand stay with this bench.
        let mut rows = Vec::new();
        let mut tell = |text: &str| bench.tell(&format!("N1: {text}"));
        let mut wrong_bench = Bench::new(&wish, &mut tell);
        work(&mut wrong_bench)?;
        rows.append(&mut wrong_bench.rows);
        let verdicts: Vec<bool> =
            rows.iter().filter(|r| r.quantity.starts_with(quantity)).filter_map(Row::passes).collect();
        let seconds = rows.iter().map(|r| r.seconds).fold(0.0, f64::max);
        let passing = verdicts.iter().filter(|passes| **passes).count();
        // Without a single verdict nothing has been controlled.
        let passing = if verdicts.is_empty() { f64::NAN } else { passing as f64 };
        let note = |quantity, value| Row::note("N1", variant, quantity, value).took(seconds);
        bench.rows.push(note("rows that pass all the same", passing).at_most(0.0, SOURCE));
        bench.rows.push(note("rows that were judged", verdicts.len() as f64));
    }
    Ok(())
}
