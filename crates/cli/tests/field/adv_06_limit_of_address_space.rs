//! Limits of address space and of data (`ulimit -v`, `ulimit -d`, batch systems): a run that cannot fit is
//! refused, and nothing aborts.

use super::strangers::{CASE, sh};
use super::support::Desk;

/// Code and error of `coulter ARGUMENTS` under a limit [kB].
fn under(desk: &Desk, limit: &str, arguments: &str) -> (i32, String) {
    let coulter = assert_cmd::cargo::cargo_bin("coulter");
    let done = sh(desk, &format!("ulimit {limit}; exec '{}' {arguments}", coulter.display()));
    (done.status.code().unwrap_or(-1), String::from_utf8_lossy(&done.stderr).replace('\n', " "))
}

#[test]
fn what_does_not_fit_is_refused_with_the_limit() {
    let big = CASE.replace("plane_strain = true", "").replace("\"30 mm\"", "\"2 mm\"");
    let desk = Desk::with(&[("big.toml", &big.replace("\"0.12 m\"]", "\"0.12 m\", \"0.12 m\"]"))]);
    for (limit, name) in [("-v 307200", "ulimit -v"), ("-d 307200", "ulimit -d")] {
        for command in ["run big.toml -o o --threads 2", "check big.toml"] {
            let (code, error) = under(&desk, limit, command);
            assert_eq!(code, 2, "{limit}, {command}: {error}");
            assert!(error.contains("of memory") && error.contains(name), "{limit}, {command}: {error}");
        }
        assert!(!desk.path().join("o").exists());
    }
}

/// Whatever the limit is, the command ends as it promises: run to its end, or with 2 and a reason.
#[test]
fn no_limit_makes_it_abort() {
    let desk = Desk::with(&[("c.toml", CASE)]);
    let limits = [
        "-v 28000",
        "-v 36000",
        "-v 44000",
        "-v 60000",
        "-v 90000",
        "-v 110000",
        "-d 4000",
        "-d 20000",
        "-d 60000",
    ];
    for limit in limits {
        // Where not even the program fits the system ends it.
        if under(&desk, limit, "--version").0 == 0 {
            let (code, error) = under(&desk, limit, "run c.toml -o o --force --threads 3");
            let is_refused = code == 2 && error.contains("memory");
            assert!(code == 0 || code == 1 || is_refused, "{limit}: {code} {error}");
            assert!(!error.contains("panicked") && !error.contains("backtrace"), "{limit}: {error}");
        }
    }
}
