//! Results that are not to be used are called so everywhere: exit code, last words, summary and report.

use super::place::{Place, Told};
use serde_json::Value;

/// The verdict, the same in all places.
#[track_caller]
fn verdict(place: &Place, told: &Told) -> String {
    let verdict = place.summary()["trust"]["verdict"].as_str().unwrap().to_owned();
    let html = place.text("report.html");
    assert!(html.contains(&format!("<section class=\"trust {verdict}\">")), "the report says otherwise");
    assert_eq!(told.code, Some(i32::from(verdict == "broken")), "{verdict}: {}", told.err);
    let is_done = told.err.lines().any(|line| line.starts_with("done"));
    assert_eq!(is_done, verdict != "broken", "{}", told.err);
    verdict
}

/// Whether no check is worse than the verdict, and one as bad.
fn is_worst_check(place: &Place, verdict: &str) -> bool {
    let rank = |v: &Value| ["good", "doubtful", "broken"].iter().position(|name| v == name).unwrap();
    let summary = place.summary();
    let checks = summary["trust"]["checks"].as_array().unwrap();
    checks.iter().map(|check| rank(&check["verdict"])).max() == Some(rank(&verdict.into()))
}

#[test]
fn a_disc_that_falls_out_of_the_box_is_a_breakdown() {
    let place = Place::new();
    let shipped = format!("{}/../../cases/towed_disc.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::copy(shipped, place.out("").with_file_name("case.toml")).unwrap();
    let told = place.run(&["--set", "grid.cell=25 mm", "--set", r#"body.disc.heave={ load = "-5000 N" }"#]);
    let told =
        told.is(1, &["body `disc` left the box below at t = ", "(step ", "near (", "failed.checkpoint"]);
    assert_eq!(verdict(&place, &told), "broken");
    assert!(is_worst_check(&place, "broken") && place.is_tidy());
    assert!(place.text("report.html").contains("The run broke down: the body `disc` left the box below"));
}

#[test]
fn a_step_too_large_is_never_done_unless_its_energy_is_explained() {
    let place = Place::new();
    let told = place.run(&["--set", "numerics.courant=1"]);
    let verdict = verdict(&place, &told);
    assert!(is_worst_check(&place, &verdict));
    if verdict != "broken" {
        let summary = place.summary();
        let checks = summary["trust"]["checks"].as_array().unwrap();
        let balance = checks.iter().find(|check| check["name"] == "energy balance").unwrap();
        assert!(balance["value"].as_f64().unwrap() <= 5.0, "{balance}");
    }
    // Asked again, a scheduler hears the same.
    let again = place.run(&["--set", "numerics.courant=1", "--auto-resume"]);
    assert_eq!(again.code, told.code, "{}", again.err);
}
