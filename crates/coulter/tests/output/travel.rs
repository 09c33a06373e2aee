//! The output of a grid that travels after a body: ground coordinates, no ghost layers, and the ground left
//! behind.

use super::finish;
use crate::vtk::{array, doubles, floats};
use coulter::case::model::model;
use coulter::case::{self, Case};
use coulter::history::SurfacePoint;
use coulter::output::Results;
use coulter::output::checkpoint::Checkpoint;
use coulter::output::folder::{Outcome, RunStatistics};
use coulter::output::tables::{HistoryNames, read_history};
use coulter::simulation::Simulation;
use glam::DVec3;
use solver::boundary::Boundary::{Inflow, Outflow};
use solver::grid::Grid;
use solver::initial::Filling;
use solver::model::{Follow, Ground, Model};
use solver::precision::{Precision, Scalar};
use std::fs;
use std::path::Path;

/// Cell size [m].
const CELL: f64 = 0.025;

/// The towed disc in a short box of equal cells, so deep in the soil [mm], for 0.15 m of travel.
fn tow(sinkage: &str) -> Case {
    let text = include_str!("../../../../cases/light_disc.toml");
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
        "run.tow_distance=\"0.15 m\"",
        "output.history_interval=\"5 ms\"",
        &format!("body.disc.sinkage={sinkage}"),
    ];
    case::parse(text, "case.toml", &overrides.map(str::to_owned)).unwrap()
}

/// The model of the case with a grid that follows its disc along x, raised so high above where the case has
/// it [m].
fn travelling(case: &Case, raised: f64) -> Model {
    let mut model = model(case, f64::LANES);
    model.boundaries.0[0] = [Outflow, Inflow];
    model.grid = Grid::with_open_faces(case.grid.faces.clone(), model.boundaries.open_faces(), f64::LANES);
    let top = DVec3::new(f64::INFINITY, f64::INFINITY, 0.0);
    model.ground = Ground {
        fillings: vec![Filling::between(DVec3::NEG_INFINITY, top)],
        overburden: case.overburden,
        ..Ground::default()
    };
    model.follow = Some(Follow { body: 0, axes: [true, false, false] });
    model.bodies[0].start.position.z += raised;
    model
}

fn to_the_end<R: Precision>(simulation: &mut Simulation<R>) {
    while !simulation.is_done() {
        simulation.advance().unwrap();
    }
}

/// Writes all results of a run that has reached its end.
fn write(dir: &Path, simulation: &Simulation) -> coulter::output::Summary {
    let Simulation { case, model, state, history, .. } = simulation;
    let mut results = Results::create(dir, case, false).unwrap();
    let statistics = RunStatistics { outcome: Outcome::Finished, ..RunStatistics::default() };
    finish(&mut results, (case, &model.grid), (state, history), &statistics)
}

/// The lines of the ground left behind.
fn lines<'a>(case: &Case, left: &'a [SurfacePoint]) -> Vec<&'a [SurfacePoint]> {
    left.chunks(case.grid.faces[1].len() - 1).collect()
}

#[test]
fn over_soil_at_rest_everything_stays_where_it_is_in_the_ground() {
    let case = tow("0 mm");
    // The first line lies within the grid at the start, at its low end.
    let mut simulation = Simulation::<f64>::of_model(&case, travelling(&case, 0.01));
    assert_eq!(lines(&case, &simulation.history.ground_left).len(), 1);
    to_the_end(&mut simulation);
    let travelled = simulation.state.grid_position.x;
    assert!(travelled > 0.14, "{travelled} m");
    let lines = lines(&case, &simulation.history.ground_left);
    assert_eq!(lines.len(), 1 + (travelled / (1.05 * CELL)) as usize, "{travelled} m");
    for (n, pair) in lines.windows(2).enumerate() {
        let apart = pair[1][0].x - pair[0][0].x;
        // The grid moves in steps of a tenth of a cell.
        assert!(apart > CELL * (1.0 - 1e-9) && apart < 1.1 * CELL, "line {n}: {apart} m");
    }
    assert!((lines[0][0].x - (case.domain.low.x + 0.5 * CELL)).abs() < 1e-12);
    for line in &lines {
        let rows: Vec<f64> = case.grid.faces[1].windows(2).map(|f| 0.5 * (f[0] + f[1])).collect();
        assert_eq!(line.iter().map(|point| point.y).collect::<Vec<_>>(), rows);
        assert!(line.iter().all(|point| point.x == line[0].x && point.column.z.abs() < 1e-12), "{line:?}");
    }
    let edges: f64 = simulation.history.boundaries.iter().map(|b| b.wall_area + b.lid_area).sum();
    assert_eq!(edges, 0.0, "the open faces are no walls");
}

#[test]
fn files_leave_out_the_ghost_layers_and_are_in_coordinates_of_the_ground() {
    let dir = tempfile::tempdir().unwrap();
    let case = tow("0 mm");
    let mut simulation = Simulation::<f64>::of_model(&case, travelling(&case, 0.01));
    to_the_end(&mut simulation);
    let summary = write(dir.path(), &simulation);
    let [nx, ny, nz] = case.grid.faces.each_ref().map(|faces| faces.len() - 1);
    let file = fs::read(dir.path().join("fields/soil_0000.vtr")).unwrap();
    assert!(String::from_utf8_lossy(&file).contains(&format!("WholeExtent=\"0 {nx} 0 {ny} 0 {nz}\"")));
    let evf = floats(&array(&file, "evf"));
    assert_eq!(evf.len(), nx * ny * nz);
    assert_eq!(summary.filled_cells, evf.iter().filter(|f| **f > 1e-6).count() as u64);
    let travelled = simulation.state.grid_position.x;
    let moved: Vec<f64> = case.grid.faces[0].iter().map(|x| x + travelled).collect();
    assert_eq!(doubles(&array(&file, "x")), moved);
    assert_eq!(doubles(&array(&file, "z")), case.grid.faces[2]);
    // The free surface begins where the tow did and ends where the grid does.
    let surface = fs::read(dir.path().join("fields/surface_0000.vtp")).unwrap();
    let points = doubles(&array(&surface, "Points"));
    let columns = points.len() / 3 / (2 * ny);
    assert_eq!(columns, nx + simulation.history.ground_left.len() / ny);
    let x: Vec<f64> = points.chunks(3).take(columns).map(|p| p[0]).collect();
    assert!(x.windows(2).all(|pair| pair[0] < pair[1]), "{x:?}");
    assert!((x[0] - case.domain.low.x - 0.5 * CELL).abs() < 0.1 * CELL, "{} m", x[0]);
    assert!((x[columns - 1] - (case.domain.high.x + travelled - 0.5 * CELL)).abs() < 1e-12);
    assert!(points.chunks(3).all(|p| p[2].abs() < 1e-12));
    assert!(summary.surface.rut_depth_m < 1e-12, "{:?}", summary.surface);
    for picture in ["rut_plan.png", "soil_speed.png", "profile.csv"] {
        assert!(dir.path().join("pictures").join(picture).is_file(), "{picture}");
    }
}

#[test]
fn the_rut_is_kept_through_a_restart() {
    let dir = tempfile::tempdir().unwrap();
    let case = tow("30 mm");
    let mut whole = Simulation::<f64>::of_model(&case, travelling(&case, 0.0));
    while whole.state.grid_position.x < 0.06 {
        whole.advance().unwrap();
    }
    let before = whole.history.ground_left.clone();
    assert!(lines(&case, &before).len() > 2);
    whole.checkpoint().write(dir.path()).unwrap();
    to_the_end(&mut whole);
    let checkpoint = Checkpoint::read(dir.path(), &whole.model.grid).unwrap().0;
    let mut resumed = Simulation::<f64>::resume_model(&case, travelling(&case, 0.0), checkpoint, 0.0);
    assert_eq!(resumed.history.ground_left, before);
    to_the_end(&mut resumed);
    assert!(resumed.history == whole.history, "the resumed run differs");
    assert!(lines(&case, &whole.history.ground_left).len() > lines(&case, &before).len());
    let results = dir.path().join("results");
    let summary = write(&results, &whole);
    assert!(summary.surface.rut_depth_m > 0.01, "{:?}", summary.surface);
    let back = read_history(&results, &HistoryNames::of(&whole.history), true).unwrap();
    assert_eq!(back.ground_left.len(), whole.history.ground_left.len());
    let near = |a: f64, b: f64| (a - b).abs() < 1e-8;
    let pairs = back.ground_left.iter().zip(&whole.history.ground_left);
    assert!(pairs.into_iter().all(|(a, b)| near(a.x, b.x) && near(a.y, b.y) && near(a.column.z, b.column.z)));
    let header = fs::read_to_string(results.join("ground_left.csv")).unwrap();
    assert!(header.starts_with("x [m],y [m],z [m],compaction [m],"));
}
