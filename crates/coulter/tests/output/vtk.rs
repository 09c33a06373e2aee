//! The field files, parsed again: every array has the position and length that its tag says.

use crate::synthetic::{Kind, case, state};
use coulter::history::History;
use coulter::output::vtk::FieldSeries;
use flate2::read::ZlibDecoder;
use solver::fields::HISTORY;
use solver::halo::Halo;
use std::fs;
use std::io::Read;
use std::path::Path;

/// The bytes of one array of a file with appended compressed data.
pub(crate) fn array(file: &[u8], name: &str) -> Vec<u8> {
    let marker = b"<AppendedData encoding=\"raw\">\n_";
    let start = file.windows(marker.len()).position(|w| w == marker).unwrap() + marker.len();
    let text = String::from_utf8_lossy(&file[..start]);
    let tag = text.lines().rfind(|l| l.contains(&format!("Name=\"{name}\""))).unwrap();
    let offset: usize = tag.split("offset=\"").nth(1).unwrap().split('"').next().unwrap().parse().unwrap();
    let data = &file[start + offset..];
    let number = |n: usize| u64::from_le_bytes(data[8 * n..8 * n + 8].try_into().unwrap()) as usize;
    let (blocks, block, partial) = (number(0), number(1), number(2));
    let mut raw = Vec::new();
    let mut place = 8 * (3 + blocks);
    for n in 0..blocks {
        let mut piece = Vec::new();
        ZlibDecoder::new(&data[place..place + number(3 + n)]).read_to_end(&mut piece).unwrap();
        let last = n + 1 == blocks && partial > 0;
        assert_eq!(piece.len(), if last { partial } else { block });
        raw.extend(piece);
        place += number(3 + n);
    }
    raw
}

pub(crate) fn floats(raw: &[u8]) -> Vec<f64> {
    raw.chunks(4).map(|b| f64::from(f32::from_le_bytes(b.try_into().unwrap()))).collect()
}

pub(crate) fn doubles(raw: &[u8]) -> Vec<f64> {
    raw.chunks(8).map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect()
}

fn written(dir: &Path, kind: Kind) -> (coulter::case::Case, solver::grid::Grid, solver::state::State) {
    let case = case(kind, 0.02);
    let (grid, state) = state(&case, kind, 1.5);
    let mut fields = FieldSeries::create(dir).unwrap();
    fields.write(&case, (&grid, &Halo::whole()), &state, &History::default()).unwrap();
    (case, grid, state)
}

#[test]
fn soil_files_hold_every_cell_in_its_place() {
    let dir = tempfile::tempdir().unwrap();
    let (_, grid, state) = written(dir.path(), Kind::Disc);
    let file = fs::read(dir.path().join("fields/soil_0000.vtr")).unwrap();
    let [nx, ny, nz] = grid.cells();
    let text = String::from_utf8_lossy(&file);
    assert!(text.contains(&format!("WholeExtent=\"0 {nx} 0 {ny} 0 {nz}\"")));
    assert!(text.contains("Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">1.5<"));
    let (evf, stress) = (floats(&array(&file, "evf")), floats(&array(&file, "stress")));
    let pressure = floats(&array(&file, "pressure"));
    assert_eq!((evf.len(), stress.len()), (nx * ny * nz, 6 * nx * ny * nz));
    for (i, j, k) in [(0, 0, 0), (nx / 2, ny / 3, nz / 2), (nx - 1, ny - 1, 1)] {
        let (place, n) = (i + nx * (j + ny * k), grid.index(i, j, k));
        assert!((evf[place] - state.soil.fraction[n]).abs() < 1e-6);
        assert!((stress[6 * place + 2] - state.soil.stress[2][n]).abs() < 1e-2);
        assert!((stress[6 * place + 5] - state.soil.stress[5][n]).abs() < 1e-2);
        assert!(pressure[place] >= 0.0);
    }
    for (variable, field) in HISTORY.iter().zip(&state.soil.history).filter(|(_, field)| !field.is_empty()) {
        let values = floats(&array(&file, variable.name));
        for (i, j, k) in (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| (i, j, k)))) {
            let (place, n) = (i + nx * (j + ny * k), grid.index(i, j, k));
            let expected = if state.soil.fraction[n] < 1e-6 { 0.0 } else { field[n] };
            assert!((values[place] - expected).abs() <= 1e-6 * expected.abs() + 1e-30, "{}", variable.name);
        }
    }
    assert_eq!(floats(&array(&file, "velocity")).len(), 3 * nx * ny * nz, "the last velocity is the cells'");
    assert_eq!(doubles(&array(&file, "z")), grid.faces[2]);
}

#[test]
fn stress_that_alternates_from_cell_to_cell_is_not_shown() {
    let case = case(Kind::Disc, 0.02);
    let (grid, mut state) = state(&case, Kind::Disc, 1.5);
    let written = |state: &solver::state::State| {
        let dir = tempfile::tempdir().unwrap();
        let mut fields = FieldSeries::create(dir.path()).unwrap();
        fields.write(&case, (&grid, &Halo::whole()), state, &History::default()).unwrap();
        floats(&array(&fs::read(dir.path().join("fields/soil_0000.vtr")).unwrap(), "stress"))
    };
    let before = written(&state);
    let [nx, ny, nz] = grid.cells();
    let places = || (0..nz).flat_map(move |k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k])));
    for [i, j, k] in places() {
        let n = grid.index(i, j, k);
        let sign = |m: usize| if m.is_multiple_of(2) { 1e3 } else { -1e3 };
        state.soil.stress[0][n] += sign(i + k);
        state.soil.stress[1][n] += sign(i + j + k);
        state.soil.stress[2][n] += 50.0 * i as f64;
    }
    let after = written(&state);
    let well_filled = |[i, j, k]: [usize; 3]| state.soil.fraction[grid.index(i, j, k)] >= 0.5;
    let mut inside = 0;
    for at @ [i, j, k] in
        places().filter(|[i, j, k]| i % nx > 0 && i + 1 < nx && *j > 0 && j + 1 < ny && *k > 0)
    {
        let around = |n: usize| [i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1];
        if !(0..27).all(|n| around(n)[2] < nz && well_filled(around(n))) {
            continue;
        }
        let place = i + nx * (j + ny * k);
        let change = |c: usize| after[6 * place + c] - before[6 * place + c];
        assert!(change(0).abs() < 0.01 && change(1).abs() < 0.01, "{at:?}: {} {}", change(0), change(1));
        assert!((change(2) - 50.0 * i as f64).abs() < 0.01, "{at:?}: {}", change(2));
        inside += 1;
    }
    assert!(inside > 100, "{inside}");
}

#[test]
fn bodies_are_drawn_where_they_are() {
    let dir = tempfile::tempdir().unwrap();
    let (_, _, state) = written(dir.path(), Kind::Two);
    let body = &state.mechanism.bodies[0];
    let file = fs::read(dir.path().join("fields/body_disc_0000.vtp")).unwrap();
    let points = doubles(&array(&file, "Points"));
    let velocity = floats(&array(&file, "velocity"));
    let lowest = points.chunks(3).map(|p| p[2]).fold(f64::INFINITY, f64::min);
    assert!((lowest - (body.pose.position.z - 0.1)).abs() < 1e-4);
    // Rolling forward: the lowest point moves backwards against the middle, by spin times radius.
    let n = points.chunks(3).position(|p| p[2] == lowest).unwrap();
    assert!((velocity[3 * n] - (body.twist.linear.x - 0.1 * body.twist.angular.y)).abs() < 1e-3);
    let offsets = array(&file, "offsets");
    assert_eq!(
        i64::from_le_bytes(offsets[offsets.len() - 8..].try_into().unwrap()) as usize * 8,
        array(&file, "connectivity").len()
    );
    let list = fs::read_to_string(dir.path().join("body.pvd")).unwrap();
    assert!(list.contains("part=\"1\" file=\"fields/body_scraper_0000.vtp\""));
}

#[test]
fn the_surface_is_whole_also_when_half_is_modelled() {
    let dir = tempfile::tempdir().unwrap();
    let (_, grid, _) = written(dir.path(), Kind::Disc);
    let file = fs::read(dir.path().join("fields/surface_0000.vtp")).unwrap();
    let points = doubles(&array(&file, "Points"));
    assert_eq!(points.len(), 3 * 2 * grid.cells()[0] * grid.cells()[1]);
    let mean: f64 = points.chunks(3).map(|p| p[1]).sum();
    assert!(mean.abs() < 1e-9, "mirrored about y = 0");
    let rise = floats(&array(&file, "rise"));
    let deepest = rise.iter().copied().fold(0.0, f64::min);
    assert!((deepest + 0.038).abs() < 0.005, "{deepest}");
}
