//! Results that must not be used are marked everywhere: exit code, last message, summary and report.

use super::sandbox::{Reply, Sandbox};
use serde_json::Value;

/// The verdict, the same everywhere.
#[track_caller]
fn verdict(sandbox: &Sandbox, reply: &Reply) -> String {
    let verdict = sandbox.summary()["trust"]["verdict"].as_str().unwrap().to_owned();
    let html = sandbox.text("report.html");
    assert!(
        html.contains(&format!(
            "Can it be trusted? <span class=\"verdict light {verdict}\">{verdict}</span>"
        )),
        "the report says otherwise"
    );
    assert_eq!(reply.code, Some(i32::from(verdict == "broken")), "{verdict}: {}", reply.err);
    let is_done = reply.err.lines().any(|line| line.starts_with("done"));
    assert_eq!(is_done, verdict != "broken", "{}", reply.err);
    verdict
}

/// Whether the verdict is that of the worst check.
fn is_worst_check(sandbox: &Sandbox, verdict: &str) -> bool {
    let rank = |v: &Value| ["good", "doubtful", "broken"].iter().position(|name| v == name).unwrap();
    let summary = sandbox.summary();
    let checks = summary["trust"]["checks"].as_array().unwrap();
    checks.iter().map(|check| rank(&check["verdict"])).max() == Some(rank(&verdict.into()))
}

#[test]
fn a_disc_that_falls_out_of_the_box_is_a_breakdown() {
    let sandbox = Sandbox::new();
    let shipped = format!("{}/../../cases/light_disc.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::copy(shipped, sandbox.out("").with_file_name("case.toml")).unwrap();
    let reply =
        sandbox.run(&["--set", "grid.cell=25 mm", "--set", r#"body.disc.heave={ load = "-50000 N" }"#]);
    let reply =
        reply.is(1, &["body `disc` left the box below at t = ", "(step ", "near (", "failed.checkpoint"]);
    assert_eq!(verdict(&sandbox, &reply), "broken");
    assert!(is_worst_check(&sandbox, "broken") && sandbox.is_tidy());
    assert!(sandbox.text("report.html").contains("The run broke down: the body `disc` left the box below"));
}

#[test]
fn a_step_too_large_is_never_done_unless_its_energy_is_explained() {
    let sandbox = Sandbox::new();
    let reply = sandbox.run(&["--set", "numerics.courant=1"]);
    let verdict = verdict(&sandbox, &reply);
    assert!(is_worst_check(&sandbox, &verdict));
    if verdict != "broken" {
        let summary = sandbox.summary();
        let checks = summary["trust"]["checks"].as_array().unwrap();
        let balance = checks.iter().find(|check| check["name"] == "energy balance").unwrap();
        assert!(balance["value"].as_f64().unwrap() <= 5.0, "{balance}");
    }
    // A repeated request by a scheduler has the same result.
    let again = sandbox.run(&["--set", "numerics.courant=1", "--auto-resume"]);
    assert_eq!(again.code, reply.code, "{}", again.err);
}
