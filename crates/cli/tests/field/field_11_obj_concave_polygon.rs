//! A legal polygon of OBJ or PLY, concave, is divided; one that crosses itself is refused by its line,
//! without the cure of a damaged file.

use crate::support::Desk;

const CASE: &str = "format = 2
soil = { law = 'mohr-coulomb', friction_angle = '32 deg', cohesion = '0.3 kPa', unit_weight = '15 kN/m^3', young_modulus = '1 MPa' }
grid = { cell = '5 mm' }
run = { tow_distance = '0.2 m' }
[body.tool]
shape = 'mesh'
file = 'shoe.obj'
unit = 'mm'
friction = 0.3
sinkage = '10 mm'
forward = { speed = '0.2 m/s' }
";

/// A flat track shoe with two notches.
const OUTLINE: [[i32; 2]; 12] = [
    [-60, -20],
    [-60, 20],
    [-30, 20],
    [-30, 8],
    [-10, 8],
    [-10, 20],
    [10, 20],
    [10, 8],
    [30, 8],
    [30, 20],
    [60, 20],
    [60, -20],
];

/// Its points and faces, numbered from 0; the ends are one polygon each.
fn shoe() -> (Vec<Vec<i32>>, Vec<Vec<usize>>) {
    let points = [-8, 8].iter().flat_map(|z| OUTLINE.map(|[x, y]| vec![x, y, *z])).collect();
    let sides = (0..12).map(|n| vec![n, 12 + n, 12 + (n + 1) % 12, (n + 1) % 12]);
    let ends = [(0..12).collect(), (12..24).rev().collect()];
    (points, ends.into_iter().chain(sides).collect())
}

fn lines<T: ToString>(lists: &[Vec<T>], head: impl Fn(usize) -> String) -> String {
    let line = |list: &Vec<T>| list.iter().map(T::to_string).collect::<Vec<_>>().join(" ");
    lists.iter().map(|list| format!("{} {}\n", head(list.len()), line(list))).collect()
}

fn obj(faces: &[Vec<usize>]) -> String {
    let faces: Vec<Vec<usize>> = faces.iter().map(|face| face.iter().map(|n| n + 1).collect()).collect();
    lines(&shoe().0, |_| "v".to_owned()) + &lines(&faces, |_| "f".to_owned())
}

#[test]
fn a_track_shoe_is_read() {
    let (points, faces) = shoe();
    let head = "ply\nformat ascii 1.0\nelement vertex 24\nproperty float x\nproperty float y\nproperty float z\nelement face 14\n\
                property list uchar int vertex_indices\nend_header\n";
    let ply = format!("{head}{}{}", lines(&points, |_| String::new()), lines(&faces, |n| n.to_string()));
    let desk = Desk::with(&[("case.toml", CASE), ("shoe.obj", &obj(&faces)), ("shoe.ply", &ply)]);
    // Twelve corners are ten triangles.
    let words = ["44 triangles", "surface closed", "V = 6.912e-5 m³"];
    desk.expect(0, &["check", "case.toml"]).says(&words);
    desk.expect(0, &["check", "case.toml", "--set", "body.tool.file=shoe.ply"]).says(&words);
}

#[test]
fn a_face_that_crosses_itself_is_refused_by_its_line() {
    let (_, mut faces) = shoe();
    faces[0].swap(2, 7);
    let desk = Desk::with(&[("case.toml", CASE), ("shoe.obj", &obj(&faces))]);
    let answer = desk.expect(2, &["check", "case.toml"]);
    answer.says(&["line 25: a face of 12 corners crosses itself", "mend the face"]);
    assert!(!answer.text().contains("damaged"), "{}", answer.text());
}
