//! Sand without cohesion hung over an empty slot behind the README's disc, and later filled its inside.

use super::support::Desk;

const README: &str = include_str!("../../../../README.md");

/// What stands between two marks of the README.
fn between(start: &str, end: &str) -> &'static str {
    README.split_once(start).and_then(|(_, rest)| rest.split_once(end)).unwrap().0
}

#[test]
fn the_disc_of_the_readme_answers_as_it_says_there() {
    let desk = Desk::with(&[("disc.toml", between("```toml\n", "```"))]);
    desk.expect(0, &["run", "disc.toml", "-o", "towed"]);
    for check in ["void under soil", "leak"] {
        let (value, verdict) = desk.graded("towed", check).unwrap();
        assert!(verdict == "good", "{check}: {value:?} {verdict}");
    }
    let summary: serde_json::Value = serde_json::from_str(&desk.read("towed/summary.json")).unwrap();
    assert_eq!(summary["trust"]["verdict"], between("and the grade \"", "\""));
    let stated = [
        ("drag_N", 1.0, between("coulter run disc.toml` gives ", " N of drag")),
        ("sinkage_m", 1e3, between(" N of drag, ", " mm of sinkage")),
        ("turn_ratio", 1.0, between("a turn ratio of ", " ")),
    ];
    // The turn scatters by 3 % from version to version.
    for (quantity, scale, stated) in stated {
        let value = scale * summary["bodies"]["disc"]["steady"][quantity].as_f64().unwrap();
        let ratio = value / stated.parse::<f64>().unwrap();
        assert!((ratio - 1.0).abs() < 0.04, "{quantity}: {value}, {stated} is stated");
    }
}
