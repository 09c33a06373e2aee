//! The fields under the names of Abaqus, read back: the numbers of each time stand where its step says.

use crate::synthetic::{Kind, case, history, state};
use crate::vtk::{array, doubles, floats};
use coulter::output::vtk::FieldSeries;
use coulter::output::vtkhdf::write_vtkhdf;
use hdf5_pure::File;
use solver::halo::Halo;
use std::fs;
use std::path::Path;

/// A results folder with fields at two times, the disc's history, and what is exported of them.
fn exported(dir: &Path) -> Vec<File> {
    crate::write(dir, Kind::Two, 0.04, 300);
    fs::remove_file(dir.join("soil.pvd")).unwrap();
    let case = case(Kind::Two, 0.04);
    let mut fields = FieldSeries::create(dir).unwrap();
    for time in [1.0, 2.0] {
        let (grid, state) = state(&case, Kind::Two, time);
        fields.write(&case, (&grid, &Halo::whole()), &state, &history(&case, 300)).unwrap();
    }
    let paths = write_vtkhdf(dir).unwrap();
    let names: Vec<_> = paths.iter().map(|path| path.file_name().unwrap().to_owned()).collect();
    assert_eq!(names, ["soil.vtkhdf", "body_disc.vtkhdf", "body_scraper.vtkhdf"]);
    paths.iter().map(|path| File::open(path).unwrap()).collect()
}

fn numbers(file: &File, name: &str) -> Vec<f64> {
    file.dataset(&format!("VTKHDF/{name}")).unwrap().read_f64().unwrap()
}

#[test]
fn the_soil_has_the_numbers_of_its_field_files() {
    let dir = tempfile::tempdir().unwrap();
    let soil = &exported(dir.path())[0];
    assert_eq!(numbers(soil, "Steps/Values"), [1.0, 2.0]);
    assert_eq!(numbers(soil, "Steps/PointOffsets"), [0.0, 0.0], "the grid is stored once");
    let cells = numbers(soil, "NumberOfCells")[0];
    for name in ["EVF", "S", "PRESS", "MISES", "PEEQ", "DENSITY"] {
        assert_eq!(numbers(soil, &format!("Steps/CellDataOffsets/{name}")), [0.0, cells], "{name}");
    }
    let later = fs::read(dir.path().join("fields/soil_0001.vtr")).unwrap();
    for (name, own, components) in [("EVF", "evf", 1), ("S", "stress", 6), ("PEEQ", "plastic_strain", 1)] {
        let values = numbers(soil, &format!("CellData/{name}"));
        assert_eq!(values[components * cells as usize..], floats(&array(&later, own)), "{name}");
    }
    // A hexahedron has the corners of its cell: that of the first cell, in the order of VTK.
    let (points, corners) = (numbers(soil, "Points"), numbers(soil, "Connectivity"));
    let [x, y, z] = ["x", "y", "z"].map(|axis| doubles(&array(&later, axis)));
    let place = |n: usize| points[3 * corners[n] as usize..][..3].to_vec();
    let expected = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
    for (n, [i, j, k]) in expected.into_iter().enumerate() {
        assert_eq!(place(n), [x[i], y[j], z[k]]);
    }
}

#[test]
fn a_body_has_its_displacement_and_the_reaction() {
    let dir = tempfile::tempdir().unwrap();
    let disc = &exported(dir.path())[1];
    let count = numbers(disc, "NumberOfPoints")[0] as usize;
    let of = |name: &str, time: usize, point: usize| -> Vec<f64> {
        numbers(disc, &format!("PointData/{name}"))[3 * (time * count + point)..][..3].to_vec()
    };
    let case = case(Kind::Two, 0.04);
    let place = |time| state(&case, Kind::Two, time).1.mechanism.bodies[0].pose.position;
    let moved = place(2.0) - place(1.0);
    for (n, expected) in moved.to_array().into_iter().enumerate() {
        assert!((of("U", 1, count - 1)[n] - expected).abs() < 1e-6);
    }
    let samples = &history(&case, 300).bodies[0];
    let sample = samples.iter().find(|sample| sample.time >= 2.0 - 1e-9).unwrap();
    let expected = [sample.drag, -sample.lateral, -sample.vertical];
    for (n, expected) in expected.into_iter().enumerate() {
        assert!((of("RF", 1, count - 1)[n] - expected).abs() < 1e-4 * sample.force());
    }
    assert_eq!(of("RF", 1, 0), [0.0; 3], "forces act at the reference point alone");
    // The disc rolls forward about y, by more than one turn or less: the vector counts them.
    let turned = of("UR", 1, count - 1)[1];
    let spun = state(&case, Kind::Two, 2.0).1.mechanism.bodies[0].pose.rotation.to_scaled_axis().y
        - state(&case, Kind::Two, 1.0).1.mechanism.bodies[0].pose.rotation.to_scaled_axis().y;
    let turns = (turned - spun) / std::f64::consts::TAU;
    assert!((turns - turns.round()).abs() < 1e-5, "{turned} {spun}");
}

#[test]
fn blocks_are_joined_and_a_changed_grid_is_added() {
    let dir = tempfile::tempdir().unwrap();
    drop(exported(dir.path()));
    let piece = "<Piece Extent=\"0 1 0 1 0 1\" Source=\"soil_0001.vtr\"/>\n";
    fs::write(dir.path().join("fields/soil_0002.pvtr"), piece.repeat(2)).unwrap();
    let list = dir.path().join("soil.pvd");
    let text = fs::read_to_string(&list).unwrap();
    let third =
        "<DataSet timestep=\"3\" group=\"\" part=\"0\" file=\"fields/soil_0002.pvtr\"/>\n</Collection>";
    fs::write(&list, text.replace("</Collection>", third)).unwrap();
    let soil = File::open(&write_vtkhdf(dir.path()).unwrap()[0]).unwrap();
    let ([cells, points], corners) = (
        ["NumberOfCells", "NumberOfPoints"].map(|name| numbers(&soil, name)),
        numbers(&soil, "Connectivity"),
    );
    assert_eq!(cells, [cells[0], 2.0 * cells[0]]);
    assert_eq!(numbers(&soil, "Steps/PartOffsets"), [0.0, 0.0, 1.0]);
    assert_eq!(numbers(&soil, "Steps/CellOffsets"), [0.0, 0.0, cells[0]]);
    assert_eq!(numbers(&soil, "Steps/PointOffsets"), [0.0, 0.0, points[0]]);
    assert_eq!(numbers(&soil, "CellData/EVF").len(), 4 * cells[0] as usize);
    let [first, second] = [1, 2].map(|n| corners[n * corners.len() / 3]);
    assert_eq!(second - first, points[0], "corners of the second block are its own points");
    assert_eq!(numbers(&soil, "Offsets").last(), Some(&(16.0 * cells[0])));
}

#[test]
fn a_folder_without_fields_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    assert!(write_vtkhdf(dir.path()).is_err());
    crate::write(dir.path(), Kind::Disc, 0.04, 300);
    fs::remove_file(dir.path().join("soil.pvd")).unwrap();
    assert!(write_vtkhdf(dir.path()).unwrap_err().to_string().contains("lists no fields"));
}
