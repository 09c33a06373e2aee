//! `coulter report` on runs that were killed, and on results that were damaged.

use super::sandbox::{Sandbox, TINY};
use std::fs;

fn rewrite(sandbox: &Sandbox, name: &str, change: impl Fn(&str) -> String) {
    fs::write(sandbox.out(name), change(&sandbox.text(name))).unwrap();
}

#[test]
fn a_killed_run_is_reported_from_what_there_is() {
    let sandbox = Sandbox::new();
    sandbox.killed(&[]);
    assert!(!sandbox.out("report.html").exists());
    for step in ["as it is", "cut off in the middle of a line", "fewer lines than the others", "header only"]
    {
        match step {
            "cut off in the middle of a line" => {
                rewrite(&sandbox, "forces.csv", |text| text[..text.len() - 20].to_owned());
            }
            "fewer lines than the others" => {
                rewrite(&sandbox, "energy.csv", |text| text.split_inclusive('\n').take(8).collect())
            }
            "header only" => {
                rewrite(&sandbox, "energy.csv", |text| text.split_inclusive('\n').take(1).collect())
            }
            _ => {}
        }
        sandbox.report().is(0, &[]);
        let html = sandbox.text("report.html");
        assert!(
            html.contains("The run has not reached its end.") && html.trim_end().ends_with("</html>"),
            "{step}"
        );
    }
    // The damage does not affect the resumed run.
    sandbox
        .start(&["--resume"])
        .wait_for("the run to continue", |p| p.text("run.log").contains("resumed at"));
}

#[test]
fn a_stopped_run_is_reported_as_one() {
    let sandbox = Sandbox::new();
    let mut run = sandbox.start_held(&[]);
    run.signal("TERM");
    run.end().is(143, &[]);
    sandbox.report().is(0, &[]);
    assert!(sandbox.text("report.html").contains("--resume continues it"));
}

/// Replaces a field of a line of a table, all numbered as in an editor.
fn with_field(text: &str, line: usize, field: usize, value: &str) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let mut fields: Vec<&str> = lines[line - 1].split(',').collect();
    fields[field - 1] = value;
    lines[line - 1] = fields.join(",");
    lines.join("\n") + "\n"
}

#[test]
fn damaged_results_are_refused_with_file_and_line() {
    let sandbox = Sandbox::new();
    sandbox.run(&TINY).is(0, &[]);
    let whole = sandbox.text("forces.csv");
    sandbox.report().is(0, &[]);
    let damages: [(&str, String, &[&str]); 5] = [
        ("not a number", with_field(&whole, 5, 4, "NaN"), &["forces.csv, line 5", "drag F_H [N]", "NaN"]),
        ("a time of before", with_field(&whole, 6, 1, "0.001"), &["forces.csv, line 6", "time [s]", "later"]),
        ("no time", with_field(&whole, 4, 1, ""), &["forces.csv, line 4", "time [s]"]),
        ("a header", whole.lines().next().unwrap().to_owned() + "\n", &["forces.csv has no line"]),
        ("half a line", whole[..whole.len() - 20].to_owned(), &["forces.csv: line", "fields, expected 32"]),
    ];
    for (what, text, words) in damages {
        fs::write(sandbox.out("forces.csv"), text).unwrap();
        let reply = sandbox.report().is(2, words);
        assert!(reply.out.is_empty(), "{what}: {}", reply.out);
    }
    fs::write(sandbox.out("forces.csv"), whole).unwrap();
    fs::remove_file(sandbox.out("summary.json")).unwrap();
    sandbox.report().is(2, &["cannot read", "summary.json", "No such file"]);
}
