//! A GeoTIFF, a mesh: units that a file states of itself are used, or contradicted with the cure; none is
//! ignored.

use crate::support::Desk;

/// A TIFF of 30 × 20 pixels of 0.05 units, rising by 0.1, of numbers of 32 bits, with these keys and numbers
/// of GeoTIFF.
fn geotiff(keys: &[[u16; 4]], numbers: &[f64]) -> Vec<u8> {
    const SIZE: [u32; 2] = [30, 20];
    let heights = (0..SIZE[0] * SIZE[1]).map(|n| 0.1 * 0.05 * (n % SIZE[0]) as f32);
    let data: Vec<u8> = heights.flat_map(f32::to_le_bytes).collect();
    let doubles = |numbers: &[f64]| numbers.iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<u8>>();
    let head = [[1, 1, 0, keys.len() as u16]];
    let directory: Vec<u8> = head.iter().chain(keys).flatten().flat_map(|n| n.to_le_bytes()).collect();
    let (mut extra, mut tags) = (Vec::new(), Vec::new());
    for (tag, value) in [(256, SIZE[0]), (257, SIZE[1]), (273, 8), (278, SIZE[1]), (279, data.len() as u32)] {
        tags.push((tag, 4, 1, value));
    }
    for (tag, value) in [(258, 32), (259, 1), (262, 1), (277, 1), (339, 3)] {
        tags.push((tag, 3, 1, value));
    }
    let parts = [
        (33550_u16, 12_u16, 3_u32, doubles(&[0.05, 0.05, 0.0])),
        (33922, 12, 6, doubles(&[0.0, 0.0, 0.0, 0.0, 1.0, 0.0])),
        (34735, 3, directory.len() as u32 / 2, directory),
        (34736, 12, numbers.len() as u32, doubles(numbers)),
    ];
    let at = |extra: &[u8]| 8 + (data.len() + extra.len()) as u32;
    for (tag, kind, count, bytes) in parts.into_iter().filter(|(_, _, count, _)| *count > 0) {
        tags.push((tag, kind, count, at(&extra)));
        extra.extend(bytes);
    }
    tags.sort_unstable();
    let mut file = [&b"II*\0"[..], &at(&extra).to_le_bytes(), &data, &extra].concat();
    file.extend((tags.len() as u16).to_le_bytes());
    for (tag, kind, count, value) in tags {
        file.extend([tag.to_le_bytes(), kind.to_le_bytes()].concat());
        file.extend([count.to_le_bytes(), value.to_le_bytes()].concat());
    }
    file.extend([0; 4]);
    file
}

/// A small box, whose ground lies over x = 0.4 to 1.0 m of the map.
const CASE: &str = "format = 2
soil = { law = 'elastic', unit_weight = '15 kN/m^3', young_modulus = '1 MPa' }
domain = { x = ['-0.3 m', '0.3 m'], y = ['-0.2 m', '0.2 m'], z = ['-0.2 m', '0.2 m'] }
grid = { cell = '20 mm' }
run = { duration = '1 ms' }
[height_map]
file = 'ramp.tif'
unit = 'm'
origin = ['0.7 m', '0.5 m']
datum = '0.07 m'
[body.ball]
shape = 'sphere'
diameter = '0.08 m'
friction = 0.1
elevation = '0.15 m'
";

const PROJECTED: [u16; 4] = [1024, 0, 1, 1];

fn unit(code: u16) -> [u16; 4] {
    [3076, 0, 1, code]
}

fn system(code: u16) -> [u16; 4] {
    [3072, 0, 1, code]
}

#[test]
fn feet_are_feet() {
    let desk = Desk::with(&[("case.toml", CASE)]);
    for keys in [
        &[PROJECTED, system(2229), unit(9003)][..],
        &[PROJECTED, unit(9003)],
        &[PROJECTED, unit(9002)],
        &[PROJECTED, system(2229)],
    ] {
        // 30 pixels of 0.05 ft end at 0.457 m: 0.243 m before the origin of the case.
        desk.write("ramp.tif", &geotiff(keys, &[]));
        desk.expect(2, &["check", "case.toml"]).says(&["ramp.tif", "-0.25"]);
    }
    let own = [PROJECTED, system(32767), unit(32767), [3077, 34736, 1, 1]];
    desk.write("ramp.tif", &geotiff(&own, &[7.0, 0.3]));
    desk.expect(2, &["check", "case.toml"]).says(&["ramp.tif", "-0.2575"]);
    desk.write("ramp.tif", &geotiff(&[PROJECTED, unit(9001)], &[]));
    let metres = desk.expect(0, &["check", "case.toml"]);
    assert!(!metres.text().contains("taken as metres"), "{}", metres.text());
    desk.write("ramp.tif", &geotiff(&[PROJECTED, system(7777)], &[]));
    desk.expect(0, &["check", "case.toml"]).says(&[
        "does not state the unit",
        "EPSG:7777",
        "taken as metres",
    ]);
}

#[test]
fn units_that_are_no_lengths_or_contradict_the_case_are_refused() {
    let desk = Desk::with(&[("case.toml", CASE)]);
    let refused = |keys: &[[u16; 4]], words: &[&str]| {
        desk.write("ramp.tif", &geotiff(keys, &[]));
        desk.expect(2, &["check", "case.toml"]).says(words);
    };
    refused(&[PROJECTED, unit(9102)], &["ProjLinearUnits 9102"]);
    refused(&[PROJECTED, unit(32767)], &["length it does not say"]);
    refused(&[PROJECTED, system(32633), unit(9003)], &["EPSG:32633", "metre"]);
    refused(&[[2048, 0, 1, 4326]], &["degrees"]);
    let vertical = |code: u16| [PROJECTED, unit(9001), [4099, 0, 1, code]];
    refused(&vertical(9003), &["US survey foot", "height_map.unit", "remove `unit`"]);
    refused(&[PROJECTED, unit(9001), [4096, 0, 1, 6360]], &["US survey foot"]);
    // Without `unit` it is that of the file.
    desk.write("ramp.tif", &geotiff(&vertical(9001), &[]));
    desk.expect(0, &["check", "case.toml"]);
    desk.write("case.toml", CASE.replace("unit = 'm'\n", "").as_bytes());
    desk.expect(0, &["check", "case.toml"]);
}

#[test]
fn a_mesh_says_its_unit() {
    let case = "format = 2\nsoil = { law = 'tresca', shear_strength = '5 kPa', unit_weight = '16 kN/m^3', young_modulus = '1 MPa' }\n\
                grid = { cell = '20 mm' }\nrun = { duration = '1 ms' }\n[body.plate]\nshape = 'mesh'\nfile = 'plate.obj'\n\
                friction = 0.3\nsinkage = '10 mm'\n";
    let corners = (0..8).map(|n| format!("v {} {} {}\n", 8 * (n & 1), 8 * (n >> 1 & 1), 4 * (n >> 2)));
    let faces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
    let obj = format!("# Units: inches\n{}{faces}", corners.collect::<String>());
    let desk = Desk::with(&[("case.toml", case), ("plate.obj", &obj)]);
    desk.expect(0, &["check", "case.toml"]).says(&["0.2032 m × 0.2032 m × 0.1016 m"]);
    desk.expect(2, &["check", "case.toml", "--set", "body.plate.unit=mm"])
        .says(&["`units: inches` (line 1)", "write unit = \"in\""]);
}
