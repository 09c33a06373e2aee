//! Heights as surveys and GIS deliver them: scattered points are triangulated, ESRI grids and points are
//! read, and a mark of no height is named with its place.

use crate::field_09_decimal_comma_other_readers::GROUND;
use crate::support::Desk;

fn height(x: f64) -> f64 {
    0.02 * (6.0 * x).sin()
}

fn grid(mark: &str) -> String {
    let header = format!(
        "ncols 13\nnrows 11\nxllcorner -0.65\nyllcorner -0.55\ncellsize 0.1\nNODATA_value -9999\n{mark}"
    );
    let row: String = (0..13).map(|n| format!("{:.3} ", height(0.1 * f64::from(n - 6)))).collect();
    header + &format!("{row}\n").repeat(11)
}

fn points(separator: &str, hole: &str) -> String {
    let point = |n: i32| {
        let (x, y) = (f64::from(n % 13 - 6) / 10.0, f64::from(n / 13 - 5) / 10.0);
        let z = if n == 70 { hole.to_owned() } else { format!("{:.3}", height(x)) };
        [format!("{x:.1}"), format!("{y:.1}"), z].join(separator) + "\n"
    };
    (0..143).map(point).collect()
}

fn survey(count: u32) -> String {
    let point = |n: u32| {
        let place = |step: f64| (f64::from(n) * step).fract();
        let (x, y) = (1.2 * place(0.754_877_666) - 0.6, place(0.569_840_290) - 0.5);
        format!("{x:.4},{y:.4},{:.4}\n", height(x))
    };
    format!("x [m],y [m],z [m]\n{}", (0..count).map(point).collect::<String>())
}

fn check(name: &str, content: &str, code: i32, words: &[&str]) {
    let desk = Desk::with(&[("ground.toml", &GROUND.replace("ground.csv", "grid.asc")), (name, content)]);
    desk.expect(code, &["check", "ground.toml", "--set", &format!("height_map.file={name}")]).says(words);
}

#[test]
fn scattered_points_become_a_grid_and_that_is_said() {
    check("scatter.csv", &survey(2500), 0, &["its 2500 points lie on no grid: triangulated (Delaunay)"]);
    check("scatter.csv", &survey(1500), 0, &["its 1500 points lie on no grid"]);
    // They must surround the domain.
    let half: String =
        survey(2500).lines().filter(|line| !line.starts_with('-')).map(|line| format!("{line}\n")).collect();
    check("scatter.csv", &half, 2, &["the map lies over x = 0"]);
}

#[test]
fn esri_grids_and_points_are_read() {
    check("grid.asc", &grid(""), 0, &["taken as metres"]);
    check("map.xyz", &points(" ", "0.019"), 0, &["taken as metres"]);
    check("map.xyz", &points(",", "0.019"), 0, &["taken as metres"]);
    // Point clouds have this extension, too.
    check("cloud.asc", &format!("x [m] y [m] z [m]\n{}", points(" ", "0.019")), 0, &[]);
}

#[test]
fn a_mark_of_no_height_is_named_with_its_place() {
    let header = "x [m],y [m],z [m]\n";
    check(
        "hole.csv",
        &(header.to_owned() + &points(",", "-9999")),
        2,
        &["line 72: is -9999 a mark for no height?", "cut it off"],
    );
    check(
        "hole.csv",
        &(header.to_owned() + &points(",", "nan")),
        2,
        &["line 72: \"nan\" is not a finite number", "fill in"],
    );
    check("hole.csv", &(header.to_owned() + &points(",", "-32768")), 2, &["is -32768 a mark for no height?"]);
    check("hole.csv", &(header.to_owned() + &points(",", "-4321")), 2, &["is -4321", "x = -0.1 m, y = 0 m"]);
    check("map.xyz", &points(" ", "-32767"), 2, &["line 71: is -32767 a mark for no height?"]);
    let holed = grid("").replacen("0.009", "-9999", 1);
    check("grid.asc", &holed, 2, &["line 7: column 1, row 1 from the top: no height (NODATA_value -9999)"]);
    check(
        "grid.asc",
        &holed.replace("NODATA_value -9999\n", ""),
        2,
        &["column 1, row 1 from the top: is -9999 a mark"],
    );
}
