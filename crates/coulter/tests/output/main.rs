//! The output of a run, from made-up data.

#![allow(clippy::unwrap_used)]

mod columns;
mod rendered;
mod rim;
mod synthetic;
mod travel;
mod vtk;
mod vtkhdf;

use coulter::case::Case;
use coulter::history::History;
use coulter::history::columns::{BOUNDARIES, ENERGY, FORCES, header};
use coulter::output::folder::{Outcome, RunStatistics};
use coulter::output::pictures::Shown;
use coulter::output::tables::{HistoryNames, Table, read_history};
use coulter::output::vtk::FieldSeries;
use coulter::output::{OutputError, Results, Summary, rebuild_report};
use coulter::output::{Overlay, PlotKind};
use solver::grid::Grid;
use solver::halo::Halo;
use solver::precision::Precision;
use solver::state::State;
use std::fs;
use std::path::Path;
use synthetic::{Kind, case, history, state, statistics};

/// Writes the last fields of a run, and all that its end leaves.
pub(crate) fn finish<R: Precision>(
    results: &mut Results,
    (case, grid): (&Case, &Grid),
    (state, history): (&State<R>, &History),
    statistics: &RunStatistics,
) -> Summary {
    let block = (grid, &Halo::whole());
    FieldSeries::resume(results.dir(), state.time).unwrap().write(case, block, state, history).unwrap();
    let shown = Shown::of(case, block, state, &history.ground_left).unwrap();
    results.finish(case, &shown, history, statistics).unwrap()
}

/// Writes a whole results folder and returns its summary.
fn write(dir: &Path, kind: Kind, cell: f64, count: usize) -> Summary {
    let case = case(kind, cell);
    let (grid, state) = state(&case, kind, case.duration);
    let history = history(&case, count);
    let mut results = Results::create(dir, &case, true).unwrap();
    results.log.line("started").unwrap();
    let overlay = |plot, points| Overlay {
        name: "forecast: passive pressure".into(),
        plot,
        body: None,
        measured: false,
        points,
    };
    results
        .overlay(vec![
            overlay(PlotKind::ForceSinkage, vec![[0.0, 0.0], [0.01, 6.0], [0.02, 14.0], [0.045, 40.0]]),
            overlay(PlotKind::ForceDisplacement, vec![[0.0, 36.5]]),
        ])
        .unwrap();
    coulter::output::write_case_file(results.dir(), &case, "name = \"synthetic\"\n").unwrap();
    finish(&mut results, (&case, &grid), (&state, &history), &statistics())
}

#[test]
#[ignore = "writes a report to look at into /tmp/coulter_synthetic"]
fn write_synthetic_reports() {
    let root = std::env::temp_dir().join("coulter_synthetic");
    for (name, kind) in [("disc", Kind::Disc), ("two", Kind::Two), ("column", Kind::Column)] {
        write(&root.join(name), kind, 0.005, 6000);
    }
}

#[test]
fn a_disc_leaves_all_its_files() {
    let dir = tempfile::tempdir().unwrap();
    let root = dir.path().join("deep/er");
    let summary = write(&root, Kind::Disc, 0.02, 400);
    for file in [
        "report.html",
        "summary.json",
        "run.json",
        "run.log",
        "case.toml",
        "resolved.toml",
        "forces.csv",
        "energy.csv",
        "soil.pvd",
        "surface.pvd",
        "body.pvd",
        "fields/soil_0000.vtr",
        "fields/surface_0000.vtp",
        "fields/body_disc_0000.vtp",
        "pictures/soil_fraction.png",
        "pictures/rut_plan.png",
        "pictures/rut_section.svg",
        "plots/disc_forces.svg",
        "plots/energy.svg",
    ] {
        let size = fs::metadata(root.join(file)).map(|m| m.len()).unwrap_or(0);
        assert!(size > 0, "{file} is missing or empty");
    }
    assert!(fs::read_to_string(root.join("resolved.toml")).unwrap().contains("\nformat = 2\n"));
    let steady = &summary.bodies["disc"].steady;
    assert!((steady.drag.unwrap() - 38.0).abs() < 1.0);
    assert!((steady.turn_ratio.unwrap() - 0.85).abs() < 0.01);
    assert!((summary.surface.rut_depth_m - 0.038).abs() < 0.01);
    let back = Summary::read(&root).unwrap();
    // Reading JSON may move the last bit of a number.
    assert!((back.bodies["disc"].steady.drag_noise.unwrap() - steady.drag_noise.unwrap()).abs() < 1e-14);
    assert_eq!(
        (back.case, back.filled_cells, back.steps),
        (summary.case, summary.filled_cells, summary.steps)
    );
}

#[test]
fn the_summary_keeps_its_names() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), Kind::Disc, 0.03, 100);
    let json: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(dir.path().join("summary.json")).unwrap()).unwrap();
    assert_eq!(json["format"], coulter::case::FORMAT);
    for pointer in [
        "/case",
        "/version",
        "/cells",
        "/filled_cells",
        "/steps",
        "/wall_s",
        "/soil/volume_ratio",
        "/soil/leaked_m3",
        "/energy/external_J",
        "/energy/kinetic_J",
        "/energy/elastic_J",
        "/energy/plastic_J",
        "/energy/friction_J",
        "/energy/viscous_J",
        "/energy/hourglass_J",
        "/energy/seepage_J",
        "/energy/remap_loss_J",
        "/energy/closure",
        "/bodies/disc/steady/from_m",
        "/bodies/disc/steady/to_m",
        "/bodies/disc/steady/drag_N",
        "/bodies/disc/steady/vertical_N",
        "/bodies/disc/steady/sinkage_m",
        "/bodies/disc/steady/turn_ratio",
        "/bodies/disc/steady/axle_torque_Nm",
        "/bodies/disc/steady/drag_noise",
        "/bodies/disc/peak/drag_N",
    ] {
        assert!(json.pointer(pointer).is_some_and(|v| !v.is_null()), "{pointer} in {json:#}");
    }
}

#[test]
fn csv_headers_are_a_contract() {
    assert_eq!(
        header(FORCES),
        "time [s],displacement u [m],sinkage z [m],drag F_H [N],vertical F_V [N],lateral [N],axle torque [N m],\
         rotation [rad],spin [rad/s],turn ratio [-],normal drag [N],friction drag [N],normal vertical [N],\
         friction vertical [N],leak [m^3],embedded [m^3],speed v [m/s],heave speed [m/s],rolling speed [m/s],\
         lateral displacement [m],yaw [rad],tilt [rad],moment x [N m],moment y [N m],moment z [N m],water drag [N],pore pressure drag [N],pore pressure vertical [N],Z [-],u_bar [-],F_H_bar [-],\
         F_V_bar [-]"
    );
    assert_eq!(
        header(ENERGY),
        "time [s],external [J],kinetic [J],elastic [J],plastic [J],friction [J],contact method [J],viscous [J],hourglass [J],seepage [J],\
         remap loss [J],closure [-],volume ratio [-],elastic compression [-],overdense mass [-],void under soil [-]"
    );
    assert_eq!(
        header(BOUNDARIES),
        "time [s],lid area [m^2],lid force [N],bare wall area [m^2],stress rise [Pa]"
    );
}

#[test]
fn histories_grow_during_the_run_and_read_back() {
    let dir = tempfile::tempdir().unwrap();
    let case = case(Kind::Two, 0.04);
    let full = history(&case, 50);
    let mut results = Results::create(dir.path(), &case, false).unwrap();
    let mut part = full.clone();
    part.bodies.iter_mut().for_each(|samples| samples.truncate(20));
    part.energy.truncate(3);
    results.tables.append(&part).unwrap();
    assert_eq!(Table::read(&dir.path().join("forces_disc.csv")).unwrap().rows(), 20);
    results.tables.append(&full).unwrap();
    results.tables.append(&full).unwrap();
    let back = read_history(dir.path(), &HistoryNames::of(&full), true).unwrap();
    assert_eq!(back.bodies[1].len(), 50);
    assert!((back.bodies[1][30].drag - full.bodies[1][30].drag).abs() < 1e-6);
    let disc = Table::read(&dir.path().join("forces_disc.csv")).unwrap();
    // F over γ t d²; the block's reference lengths are its height and width.
    let reference = [16e3 * 0.04 * 0.04, 16e3 * 0.08 * 0.01];
    let block = Table::read(&dir.path().join("forces_scraper.csv")).unwrap();
    for (table, force) in [(&disc, reference[0]), (&block, reference[1])] {
        let (drag, bar) = (table.column("drag F_H").unwrap()[40], table.column("F_H_bar").unwrap()[40]);
        assert!((bar - drag / force).abs() < 1e-7 * bar.abs());
    }
    assert!(block.column("turn ratio").unwrap().iter().all(|v| v.is_nan()));
    assert!(disc.column("turn ratio").unwrap().iter().skip(10).all(|v| v.is_finite()));
}

#[test]
fn weightless_soil_has_no_force_groups() {
    let dir = tempfile::tempdir().unwrap();
    let mut case = case(Kind::Disc, 0.04);
    case.soil.unit_weight = 0.0;
    Results::create(dir.path(), &case, false).unwrap().tables.append(&history(&case, 10)).unwrap();
    let table = Table::read(&dir.path().join("forces.csv")).unwrap();
    assert!(table.column("F_H_bar").unwrap().iter().all(|v| v.is_nan()));
    assert!(table.column("Z").unwrap().iter().all(|v| v.is_finite()));
}

#[test]
fn results_are_never_overwritten_unasked() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), Kind::Two, 0.04, 20);
    let case = case(Kind::Disc, 0.04);
    assert!(matches!(Results::create(dir.path(), &case, false), Err(OutputError::Exists { .. })));
    fs::write(dir.path().join("notes.txt"), "mine").unwrap();
    fs::write(dir.path().join("fields/mine.txt"), "mine").unwrap();
    Results::create(dir.path(), &case, true).unwrap();
    assert!(!dir.path().join("forces_disc.csv").exists(), "the old run's files are gone");
    assert!(!dir.path().join("fields/soil_0000.vtr").exists() && !dir.path().join("report.html").exists());
    assert!(dir.path().join("notes.txt").exists() && dir.path().join("fields/mine.txt").exists());
    let foreign = tempfile::tempdir().unwrap();
    fs::write(foreign.path().join("thesis.tex"), "mine").unwrap();
    for force in [false, true] {
        assert!(matches!(Results::create(foreign.path(), &case, force), Err(OutputError::Foreign { .. })));
    }
}

#[test]
fn a_resumed_run_goes_on_where_the_checkpoint_was() {
    let dir = tempfile::tempdir().unwrap();
    let case = case(Kind::Disc, 0.04);
    let full = history(&case, 60);
    let mut results = Results::create(dir.path(), &case, false).unwrap();
    let mut fields = FieldSeries::create(dir.path()).unwrap();
    let halo = Halo::whole();
    for time in [0.0, 1.0, 2.0] {
        let (grid, state) = state(&case, Kind::Disc, time);
        fields.write(&case, (&grid, &halo), &state, &full).unwrap();
        fields.write(&case, (&grid, &halo), &state, &full).unwrap();
    }
    results.tables.append(&full).unwrap();
    drop(results);
    let mut early = full.clone();
    early.bodies[0].truncate(25);
    let mut results = Results::resume(dir.path(), &case, &early).unwrap();
    let mut fields = FieldSeries::resume(dir.path(), 1.5).unwrap();
    assert_eq!(Table::read(&dir.path().join("forces.csv")).unwrap().rows(), 25);
    let (grid, later) = state(&case, Kind::Disc, 1.75);
    fields.write(&case, (&grid, &halo), &later, &early).unwrap();
    let list = fs::read_to_string(dir.path().join("soil.pvd")).unwrap();
    let times: Vec<&str> = list.split("timestep=\"").skip(1).filter_map(|t| t.split('"').next()).collect();
    assert_eq!(times, ["0", "1", "1.75"]);
    assert!(list.contains("fields/soil_0002.vtr") && !list.contains("soil_0003"));
    results.tables.append(&full).unwrap();
    assert_eq!(Table::read(&dir.path().join("forces.csv")).unwrap().rows(), 60);
}

#[test]
fn a_report_is_rebuilt_from_the_files() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), Kind::Two, 0.03, 300);
    let first = fs::read_to_string(dir.path().join("report.html")).unwrap();
    fs::remove_file(dir.path().join("report.html")).unwrap();
    let path = rebuild_report(dir.path()).unwrap();
    let second = fs::read_to_string(path).unwrap();
    assert!(first == second);
    let empty = tempfile::tempdir().unwrap();
    assert!(matches!(rebuild_report(empty.path()), Err(OutputError::NoResult { .. })));
}

#[test]
fn a_report_needs_nothing_from_outside() {
    let dir = tempfile::tempdir().unwrap();
    write(dir.path(), Kind::Disc, 0.03, 5000);
    let html = fs::read_to_string(dir.path().join("report.html")).unwrap();
    for outside in ["src=\"http", "href=", "<script src", "@import", "fetch(", "XMLHttpRequest", "import("] {
        assert!(!html.contains(outside), "{outside}");
    }
    // Parts of the page itself.
    assert!(html.split("url(").skip(1).all(|rest| rest.starts_with('#')));
    assert!(html.contains("data:image/png;base64,") && html.contains("<svg"));
    // What the page shows; its scripts may speak of NaN.
    let shown: String = html
        .split("<script")
        .enumerate()
        .map(|(n, part)| if n == 0 { part } else { part.split_once("</script>").unwrap().1 })
        .collect();
    assert!(!shown.contains("NaN"));
    // Long histories are reduced in the plots.
    let svg = fs::metadata(dir.path().join("plots/disc_forces.svg")).unwrap().len();
    assert!(svg < 200_000, "{svg} bytes");
}

#[test]
fn strange_runs_are_reported_too() {
    let statistics =
        RunStatistics { outcome: Outcome::BrokeDown("cell <3,4,5> & more".into()), ..Default::default() };
    for kind in [Kind::Disc, Kind::Two, Kind::Column] {
        let case = case(kind, 0.04);
        let (grid, mut state) = state(&case, kind, 0.0);
        let mut broken = history(&case, 30);
        for samples in &mut broken.bodies {
            samples[7].drag = f64::NAN;
            samples[29].displacement = f64::NAN;
        }
        state.soil.history[solver::fields::PLASTIC_STRAIN].fill(f64::NAN);
        state.soil.stress[2].fill(f64::INFINITY);
        if let Some(body) = state.mechanism.bodies.first_mut() {
            body.pose.position = glam::DVec3::new(1e30, f64::NAN, f64::NEG_INFINITY);
            body.pose.rotation = glam::DQuat::NAN;
        }
        let empty = coulter::history::History { energy: vec![], ..history(&case, 0) };
        let constant = history(&case, 1);
        for history in [&broken, &empty, &constant] {
            let dir = tempfile::tempdir().unwrap();
            let mut results = Results::create(dir.path(), &case, false).unwrap();
            finish(&mut results, (&case, &grid), (&state, history), &statistics);
            let html = fs::read_to_string(dir.path().join("report.html")).unwrap();
            assert!(html.contains("broke down: cell &lt;3,4,5&gt; &amp; more"), "{kind:?}");
            let drawn = html.split("<h2>The case</h2>").next().unwrap();
            assert!(
                !drawn.contains("NaN") && !drawn.contains("inf\"") && !drawn.contains("inf "),
                "{kind:?}"
            );
            rebuild_report(dir.path()).unwrap();
        }
    }
}

#[test]
fn a_body_that_is_only_pushed_down_is_plotted_over_time() {
    let dir = tempfile::tempdir().unwrap();
    let case = case(Kind::Disc, 0.04);
    let (grid, state) = state(&case, Kind::Disc, case.duration);
    let mut pushed = history(&case, 500);
    for sample in &mut pushed.bodies[0] {
        (sample.displacement, sample.speed, sample.drag, sample.spin) = (0.0, 0.0, 1e-9, 0.0);
        sample.rolling_speed = 0.0;
    }
    let mut results = Results::create(dir.path(), &case, false).unwrap();
    let summary = finish(&mut results, (&case, &grid), (&state, &pushed), &statistics());
    let steady = &summary.bodies["disc"].steady;
    assert_eq!((steady.turn_ratio, steady.drag_noise), (None, None));
    assert!((steady.from_s.unwrap() - 0.7 * 6.0).abs() < 0.05);
    let html = fs::read_to_string(dir.path().join("report.html")).unwrap();
    assert!(html.contains("Steady means over t = "));
}

#[test]
fn progress_is_shown_without_a_terminal_and_without_history() {
    let case = case(Kind::Two, 0.04);
    let empty = coulter::history::History::default();
    for quiet in [false, true] {
        let mut progress = coulter::output::Progress::start(&case, 0.0, quiet);
        for history in [&empty, &history(&case, 0), &history(&case, 40)] {
            progress.update(3.0, history);
            progress.update(f64::NAN, history);
        }
        progress.finish("done");
        progress.finish("done");
    }
}
