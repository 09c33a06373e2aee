//! Stress and slip along the rim, in the results of short runs.

use super::finish;
use coulter::case::{self, Case};
use coulter::output::folder::{Outcome, RunStatistics};
use coulter::output::tables::Table;
use coulter::output::{Results, Summary, rebuild_report};
use coulter::simulation::Simulation;
use std::fs;
use std::path::Path;

/// The towed disc in a short box of equal cells, on its way through the soil at a fixed depth.
fn tow(changes: &[&str]) -> Case {
    tow_text(include_str!("../../../../cases/light_disc.toml"), changes)
}

fn tow_text(text: &str, changes: &[&str]) -> Case {
    let overrides = [
        "grid.cell=25 mm",
        "grid.growth=1",
        "domain.x=[\"-0.2 m\", \"0.3 m\"]",
        "domain.y=[\"0 m\", \"0.15 m\"]",
        "domain.z=[\"-0.15 m\", \"0.075 m\"]",
        "grid.fine_x=[\"-0.2 m\", \"0.3 m\"]",
        "grid.fine_z=[\"-0.15 m\", \"0.075 m\"]",
        "body.disc.forward={ speed = \"0.5 m/s\", ramp = \"0.02 s\" }",
        "body.disc.heave=\"fixed\"",
        "body.disc.sinkage=30 mm",
        "run.tow_distance=\"0.1 m\"",
        "output.history_interval=\"1 ms\"",
    ];
    let all = overrides.iter().chain(changes).map(|change| (*change).to_owned()).collect::<Vec<_>>();
    case::parse(text, "case.toml", &all).unwrap()
}

/// Both halves of the disc instead of one.
const WHOLE: [&str; 3] =
    ["domain.symmetric=false", "domain.y=[\"-0.15 m\", \"0.15 m\"]", "grid.fine_y=[\"-0.15 m\", \"0.15 m\"]"];

/// The summary of a run of a case, with its results in a folder.
fn run(case: &Case, dir: &Path) -> Summary {
    let mut simulation = Simulation::<f64>::checked(case).unwrap();
    while !simulation.is_done() {
        simulation.advance().unwrap();
    }
    let Simulation { case, model, state, history, .. } = &simulation;
    let mut results = Results::create(dir, case, false).unwrap();
    let statistics = RunStatistics { outcome: Outcome::Finished, ..RunStatistics::default() };
    finish(&mut results, (case, &model.grid), (state, history), &statistics)
}

fn sum(table: &Table, of: impl Fn(&dyn Fn(&str) -> f64) -> f64) -> f64 {
    (0..table.rows()).map(|row| of(&|name| table.column(name).unwrap()[row])).sum()
}

#[test]
fn the_rim_bears_what_the_body_bears() {
    let dir = tempfile::tempdir().unwrap();
    let changes: [&[&str]; 4] = [&[], &["numerics.contact=penalty"], &WHOLE, &["body.disc.spin=locked"]];
    for (n, changes) in changes.iter().enumerate() {
        let folder = dir.path().join(n.to_string());
        let summary = run(&tow(changes), &folder);
        let (rim, steady) = (&summary.bodies["disc"].rim, &summary.bodies["disc"].steady);
        let table = Table::read(&folder.join("rim.csv")).unwrap();
        let near = |a: f64, b: f64, tolerance: f64, what: &str| {
            assert!(
                (a - b).abs() < tolerance * steady.vertical.unwrap(),
                "{changes:?}, {what}: {a} and {b} N"
            );
        };
        let (drag, vertical) = (rim.drag.unwrap(), rim.vertical.unwrap());
        near(drag + rim.flank_drag.unwrap(), steady.drag.unwrap(), 1e-6, "drag");
        near(vertical + rim.flank_vertical.unwrap(), steady.vertical.unwrap(), 1e-6, "vertical force");
        near(sum(&table, |l| l("drag")), drag, 1e-6, "sum of the drag");
        near(sum(&table, |l| l("vertical")), vertical, 1e-6, "sum of the vertical force");
        let stress =
            |l: &dyn Fn(&str) -> f64| (l("normal stress"), l("shear stress along"), l("angle"), l("area"));
        let of_stress = sum(&table, |l| {
            let (normal, shear, angle, area) = stress(l);
            area * (normal * angle.sin() - shear * angle.cos())
        });
        near(of_stress, drag, 0.02, "drag of the stresses");
        let of_stress = sum(&table, |l| {
            let (normal, shear, angle, area) = stress(l);
            area * (normal * angle.cos() + shear * angle.sin())
        });
        near(of_stress, vertical, 0.02, "vertical force of the stresses");
        let mobilised = rim.mobilised_friction.unwrap();
        assert!(mobilised > 0.0 && mobilised <= 1.0 + 1e-9, "{mobilised}");
        let lateral = sum(&table, |l| l("shear stress lateral").abs());
        let outward = sum(&table, |l| l("shear stress outward").abs());
        assert!(lateral <= 0.05 * outward, "symmetric: {lateral} along the axle, {outward} outward");
    }
}

/// Over the first five millimetres, after which the noise of a force on two cells of half a width differs
/// between the two.
#[test]
fn half_a_model_has_the_rim_of_the_whole_one() {
    let dir = tempfile::tempdir().unwrap();
    let rim = |n: &str, changes: &[&str]| {
        let changes = [changes, &["run.tow_distance=\"5 mm\""]].concat();
        run(&tow(&changes), &dir.path().join(n)).bodies["disc"].rim.clone()
    };
    let (half, whole) = (rim("half", &[]), rim("whole", &WHOLE));
    let near = |a: Option<f64>, b: Option<f64>| (a.unwrap() / b.unwrap() - 1.0).abs() < 0.005;
    assert!(near(half.drag, whole.drag) && near(half.vertical, whole.vertical), "{half:?}, {whole:?}");
}

#[test]
fn a_locked_disc_slides_forwards_and_its_report_shows_it() {
    let dir = tempfile::tempdir().unwrap();
    let locked = run(&tow(&["body.disc.spin=locked"]), &dir.path().join("locked"));
    let table = Table::read(&dir.path().join("locked/rim.csv")).unwrap();
    let column = |name: &str| table.column(name).unwrap().to_vec();
    // Where the pressure is, the surface slides forwards and the soil holds it back.
    let (slip, shear, normal) =
        (column("slip velocity along"), column("shear stress along"), column("normal stress"));
    let most = normal.iter().fold(0.0_f64, |a, b| a.max(*b));
    for n in (0..table.rows()).filter(|n| normal[*n] > 0.3 * most) {
        assert!(slip[n] * shear[n] < 0.0, "line {n}: slip {}, shear {}", slip[n], shear[n]);
    }
    // If the sand climbs the rim, then in front.
    let rim = &locked.bodies["disc"].rim;
    assert!(rim.slip_reversals.iter().all(|r| r.from_rad > 0.2 && r.to_rad >= r.from_rad), "{rim:?}");
    assert!(rim.shear_reversals.iter().all(|r| r.angle_rad > 0.2), "{rim:?}");
    let report = fs::read_to_string(dir.path().join("locked/report.html")).unwrap();
    assert!(report.contains("Stress on the rim of disc") && report.contains("Mobilised friction"));
    // The report can be rebuilt from the files.
    rebuild_report(&dir.path().join("locked")).unwrap();
    assert_eq!(fs::read_to_string(dir.path().join("locked/report.html")).unwrap(), report);
}

#[test]
fn a_frictionless_disc_has_no_plot_of_mobilised_friction() {
    let dir = tempfile::tempdir().unwrap();
    run(&tow(&["body.disc.friction=0"]), dir.path());
    let report = fs::read_to_string(dir.path().join("report.html")).unwrap();
    assert!(report.contains("Stress on the rim of disc") && !report.contains("Mobilised friction"));
}

#[test]
fn the_faces_of_a_block_are_told_apart() {
    let dir = tempfile::tempdir().unwrap();
    // It sinks as it goes: sand under a block that keeps its depth slackens.
    let block = [
        "body.disc.shape=block",
        "body.disc.size=[\"0.1 m\", \"0.1 m\", \"0.1 m\"]",
        "body.disc.heave={ speed = \"-0.03 m/s\", ramp = \"0.02 s\" }",
    ];
    let text = include_str!("../../../../cases/light_disc.toml")
        .replace("diameter = \"0.2 m\"\n", "")
        .replace("thickness = \"0.05 m\"\n", "")
        .replace("spin = \"free\"\n", "");
    let summary = run(&tow_text(&text, &block), dir.path());
    let (rim, steady) = (&summary.bodies["disc"].rim, &summary.bodies["disc"].steady);
    let drag = rim.drag.unwrap() + rim.flank_drag.unwrap();
    assert!((drag / steady.drag.unwrap() - 1.0).abs() < 1e-6);
    let table = Table::read(&dir.path().join("rim.csv")).unwrap();
    let force = |is_there: &dyn Fn(f64, f64) -> bool, name: &str| {
        sum(&table, |l| if is_there(l("x"), l("z")) { l(name) } else { 0.0 })
    };
    // The front bears the drag but for friction below and at the sides, the bottom most of the vertical
    // force.
    let (front, below) = (force(&|x, _| x > 0.0499, "drag"), force(&|_, z| z < -0.0499, "vertical"));
    assert!(front > 0.25 * rim.drag.unwrap() && below > 0.5 * rim.vertical.unwrap(), "{front} {below}");
    assert_eq!(force(&|x, _| x < -0.0499, "normal stress"), 0.0, "nothing presses from behind");
    // Half a cell next to an edge has no contact points, but bears its share.
    let area = sum(&table, |l| if l("z") < -0.0499 { l("area") } else { 0.0 });
    assert!((area - 0.01).abs() < 1e-9, "{area} m² of a base of 0.01 m²");
    assert!(force(&|x, z| z < -0.0499 && x.abs() > 0.05 - 0.0125, "normal stress") > 0.0);
}

/// In plane strain the margins along the edges of a body lie beside the slab: what the points of the base
/// represent is the base, and a rough base that is dragged over clay bears α s_u of it.
#[test]
fn in_plane_strain_the_base_is_as_large_as_it_is() {
    let changes = [
        "grid.cell=\"125 mm\"",
        "body.footing.friction=\"rough\"",
        "body.footing.adhesion_factor=0.5",
        "body.footing.heave={ speed = \"-0.002 m/s\" }",
        "body.footing.forward={ speed = \"0.02 m/s\", ramp = \"0.2 s\" }",
        "run.duration=\"1 s\"",
    ];
    let dir = tempfile::tempdir().unwrap();
    let text = include_str!("../../../../cases/strip_footing.toml");
    let all = changes.map(str::to_owned);
    let summary = run(&case::parse(text, "case.toml", &all).unwrap(), dir.path());
    let drag = summary.bodies["footing"].steady.drag.unwrap();
    // A column of points of 28 at the rear edge may be free of soil.
    assert!((drag / 500.0 - 1.0).abs() < 0.05, "{drag} N of α s_u B = 500 N");
    let table = Table::read(&dir.path().join("rim.csv")).unwrap();
    let base = |l: &dyn Fn(&str) -> f64| if l("z") < -0.249 { l("area") } else { 0.0 };
    let area = sum(&table, base);
    assert!((area - 1.0).abs() < 1e-9, "{area} m² of 1 m²");
}

/// Prandtl (1920): a smooth strip on undrained soil bears (2 + π) s_u at every point. Contact points beside
/// each other bear 20 and 180 % of it; their nodes do not.
#[test]
fn a_footing_bears_the_same_at_every_point() {
    let dir = tempfile::tempdir().unwrap();
    let text = include_str!("../../../../cases/strip_footing.toml");
    run(&case::parse(text, "case.toml", &[]).unwrap(), dir.path());
    let table = Table::read(&dir.path().join("rim.csv")).unwrap();
    let [z, stress] = ["z", "normal stress"].map(|name| table.column(name).unwrap());
    let base: Vec<_> = z.iter().zip(stress).filter(|(z, _)| **z < -0.249).map(|(_, stress)| stress).collect();
    assert_eq!(base.len(), 32);
    let exact = 1e3 * (2.0 + std::f64::consts::PI);
    assert!(base.iter().all(|stress| (*stress / exact - 1.0).abs() < 0.2), "{base:?}, {exact} Pa");
}
