//! Cones and thin discs on few cells broke by leak, and with it went the force.

use super::support::Desk;

const CONE: &str = include_str!("../../../../validation/C6_bodies_on_few_cells/cone.toml");
const DISC: &str = include_str!("../../../../validation/C6_bodies_on_few_cells/disc.toml");

/// Runs a case on cells of a size; a force on a body in the steady part [N]. The leak must not break it.
fn force(desk: &Desk, cell: &str, [body, component]: [&str; 2]) -> f64 {
    desk.expect(0, &["run", "case.toml", "-o", "out", "--force", "--set", &format!("grid.cell={cell}")]);
    let (leak, verdict) = desk.graded("out", "leak").unwrap();
    assert!(verdict != "broken", "{cell}: leak {leak:?} %");
    let summary: serde_json::Value = serde_json::from_str(&desk.read("out/summary.json")).unwrap();
    summary["bodies"][body]["steady"][component].as_f64().unwrap()
}

/// 2.2 and 1.2 % of leak, and 110.6 and 106.4 N, beside 117.5 N on 13 cells.
#[test]
fn a_cone_on_five_cells_meets_the_force_on_thirteen() {
    let desk = Desk::with(&[("case.toml", CONE)]);
    for cell in ["17.8 mm", "10.4 mm"] {
        let force = force(&desk, cell, ["cone", "vertical_N"]);
        assert!((force / 121.0 - 1.0).abs() < 0.05, "{cell}: {force} N");
    }
}

/// 5 % of leak and 4.2 N, beside 11 N on four cells.
#[test]
fn a_disc_of_one_cell_has_its_drag_on_four() {
    let drag = force(&Desk::with(&[("case.toml", DISC)]), "12.5 mm", ["disc", "drag_N"]);
    assert!((drag / 11.0 - 1.0).abs() < 0.15, "{drag} N");
}
