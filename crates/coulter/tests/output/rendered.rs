//! Pictures in space and animations.

use super::synthetic::{Kind, case, history, state};
use coulter::output::vtk::FieldSeries;
use coulter::output::{Colouring, OutputError, RenderOptions, Results, Viewpoint, render};
use solver::halo::Halo;
use std::fs;
use std::path::{Path, PathBuf};

fn options(files: Vec<PathBuf>) -> RenderOptions {
    RenderOptions {
        files,
        viewpoint: None,
        colouring: Colouring::Height,
        size: [160, 90],
        dark: false,
        labelled: true,
        time: None,
        duration: 1.0,
    }
}

/// A run with field files of three times.
fn recorded(dir: &Path, kind: Kind) {
    let case = case(kind, 0.03);
    let history = history(&case, 40);
    let mut results = Results::create(dir, &case, true).unwrap();
    let mut fields = FieldSeries::create(dir).unwrap();
    let halo = Halo::whole();
    for time in [0.0, 0.5, 1.0] {
        let (grid, state) = state(&case, kind, time * case.duration);
        fields.write(&case, (&grid, &halo), &state, &history).unwrap();
    }
    let (grid, state) = state(&case, kind, case.duration);
    super::finish(&mut results, (&case, &grid), (&state, &history), &super::statistics());
}

#[test]
fn pictures_and_animations_are_drawn_without_a_display() {
    for kind in [Kind::Disc, Kind::Two, Kind::Column] {
        let dir = tempfile::tempdir().unwrap();
        recorded(dir.path(), kind);
        let files = ["new/view.png", "view.gif", "view.apng"].map(|name| dir.path().join(name)).to_vec();
        let (mut last, mut most) = (0, 0);
        render(dir.path(), &options(files.clone()), &mut |done, all| (last, most) = (done, all)).unwrap();
        assert_eq!((last, most), (7, 7));
        let picture = png::Decoder::new(fs::File::open(&files[0]).unwrap()).read_info().unwrap();
        assert_eq!((picture.info().width, picture.info().height), (160, 90));
        let film = png::Decoder::new(fs::File::open(&files[2]).unwrap()).read_info().unwrap();
        assert_eq!(film.info().animation_control().unwrap().num_frames, 3);
        let mut film = gif::DecodeOptions::new().read_info(fs::File::open(&files[1]).unwrap()).unwrap();
        let mut frames = 0;
        while film.read_next_frame().unwrap().is_some() {
            frames += 1;
        }
        assert_eq!((film.width(), film.height(), frames), (160, 90, 3));
    }
}

#[test]
fn the_viewpoint_the_colours_and_the_ground_change_the_picture() {
    let dir = tempfile::tempdir().unwrap();
    recorded(dir.path(), Kind::Disc);
    let file = dir.path().join("one.png");
    let drawn = |options: RenderOptions| {
        render(dir.path(), &options, &mut |_, _| ()).unwrap();
        fs::read(&file).unwrap()
    };
    let usual = options(vec![file.clone()]);
    let all = [
        usual.clone(),
        RenderOptions { viewpoint: Some(Viewpoint::FRONT), ..usual.clone() },
        RenderOptions { viewpoint: Some(Viewpoint { follow: true, ..Viewpoint::ABOVE }), ..usual.clone() },
        RenderOptions { colouring: Colouring::Plain, ..usual.clone() },
        RenderOptions { dark: true, ..usual.clone() },
        RenderOptions { labelled: false, ..usual.clone() },
        RenderOptions { time: Some(0.0), ..usual.clone() },
    ];
    let pictures = all.map(&drawn);
    assert!(pictures[0] == drawn(usual), "the same again");
    for n in 0..pictures.len() {
        assert!(pictures[n + 1..].iter().all(|other| *other != pictures[n]), "{n}");
    }
}

#[test]
fn without_field_files_it_is_said_why_nothing_is_drawn() {
    let dir = tempfile::tempdir().unwrap();
    recorded(dir.path(), Kind::Disc);
    fs::remove_file(dir.path().join("surface.pvd")).unwrap();
    let options = options(vec![dir.path().join("view.png")]);
    let error = render(dir.path(), &options, &mut |_, _| ()).unwrap_err();
    assert!(error.to_string().contains("no field files"), "{error}");
    let empty = tempfile::tempdir().unwrap();
    assert!(matches!(render(empty.path(), &options, &mut |_, _| ()), Err(OutputError::NoResult { .. })));
}
