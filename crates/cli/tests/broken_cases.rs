//! No case file, however broken, may run or cause a panic: each is refused with line and cure, exit code 2.
//! Through the binary.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use assert_cmd::Command;

const TOWED_DISC: &str = include_str!("../../../cases/light_disc.toml");
const FOOTING: &str = include_str!("../../../cases/strip_footing.toml");
const WALL: &str = include_str!("../../../cases/passive_wall.toml");
const BAR: &str = include_str!("../../../validation/A10_taylor_bar/case.toml");

/// What `coulter check` prints to standard error for a file with this content, which it must refuse.
fn complaint_about(content: &[u8]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("broken.toml");
    std::fs::write(&path, content).unwrap();
    complaint(&["check", path.to_str().unwrap()])
}

fn complaint(arguments: &[&str]) -> String {
    let output = Command::cargo_bin("coulter").unwrap().args(arguments).output().unwrap();
    let text = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
    assert!(!text.contains("panicked"), "{text}");
    text
}

/// Replaces `old` by `new` in `case`, and expects a message about the line of `new` that contains all of
/// `words`.
#[track_caller]
fn refused(case: &str, old: &str, new: &str, words: &[&str]) {
    assert!(case.contains(old), "the case has no `{old}`");
    let broken = case.replacen(old, new, 1);
    let text = complaint_about(broken.as_bytes());
    let changed = case.find(old).unwrap() + new.rfind('\n').map_or(0, |n| n + 1);
    let line = broken[..changed].matches('\n').count() + 1;
    assert!(text.contains(&format!("broken.toml:{line}:")), "line {line} is not named: {text}");
    assert!(text.contains("help:"), "no cure: {text}");
    for word in words {
        assert!(text.contains(word), "`{word}` is not in: {text}");
    }
}

/// As [`refused`], where the message is about another line than the changed one.
#[track_caller]
fn refused_at(case: &str, old: &str, new: &str, location: &str, words: &[&str]) {
    assert!(case.contains(old), "the case has no `{old}`");
    let broken = case.replacen(old, new, 1);
    let text = complaint_about(broken.as_bytes());
    let line = broken[..broken.find(location).unwrap()].matches('\n').count() + 1;
    assert!(text.contains(&format!("broken.toml:{line}:")), "line {line} is not named: {text}");
    for word in words {
        assert!(text.contains(word), "`{word}` is not in: {text}");
    }
}

#[test]
fn impossible_friction_angle() {
    refused(TOWED_DISC, "\"35 deg\"", "\"90 deg\"", &["soil.friction_angle", "below 90 deg"]);
    refused(TOWED_DISC, "\"35 deg\"", "\"-1 deg\"", &["soil.friction_angle", "0 deg or more"]);
}

#[test]
fn dilation_beyond_friction() {
    refused(
        TOWED_DISC,
        "dilation_angle = \"0 deg\"",
        "dilation_angle = \"36 deg\"",
        &["ψ", "friction angle"],
    );
}

#[test]
fn impossible_poisson_ratio() {
    refused(TOWED_DISC, "poisson_ratio = 0.3", "poisson_ratio = 0.5", &["below 0.5"]);
    refused(TOWED_DISC, "poisson_ratio = 0.3", "poisson_ratio = -0.1", &["0 or more"]);
    refused(TOWED_DISC, "poisson_ratio = 0.3", "poisson_ratio = nan", &["finite"]);
    refused(TOWED_DISC, "poisson_ratio = 0.3", "poisson_ratio = \"0.3\"", &["expected a number, found text"]);
}

#[test]
fn impossible_stiffness_density_cohesion() {
    refused(TOWED_DISC, "\"5 MPa\"", "\"0 MPa\"", &["soil.young_modulus", "above 0"]);
    refused(FOOTING, "\"2000 kg/m^3\"", "\"-2000 kg/m^3\"", &["soil.density", "above 0"]);
    refused(TOWED_DISC, "cohesion = \"0 Pa\"", "cohesion = \"-1 Pa\"", &["soil.cohesion", "0 or more"]);
    refused(TOWED_DISC, "cohesion = \"0 Pa\"", "tension_cutoff = \"5 Pa\"", &["apex", "c cot φ"]);
    refused(TOWED_DISC, "\"5 MPa\"", "\"1e999 MPa\"", &["finite"]);
}

#[test]
fn weightless_soil_without_density() {
    refused_at(FOOTING, "density = \"2000 kg/m^3\"", "", "unit_weight =", &["density", "add"]);
}

#[test]
fn bare_number_where_a_unit_is_needed() {
    refused(TOWED_DISC, "weight = \"40 N\"", "weight = 40", &["bare number", "a force", "\"40 N\""]);
    refused(TOWED_DISC, "weight = \"40 N\"", "weight = \"40\"", &["no unit", "a force"]);
}

#[test]
fn wrong_dimension_and_unknown_unit() {
    refused(TOWED_DISC, "\"0.2 m\"", "\"0.2 MPa\"", &["is a stress, but a length is needed"]);
    refused(TOWED_DISC, "\"16 kN/m^3\"", "\"16 kN/m^2\"", &["is a stress, but a unit weight is needed"]);
    refused(TOWED_DISC, "\"16 kN/m^3\"", "\"16 Kn/m^3\"", &["unknown unit `Kn`", "did you mean `kN`"]);
    refused(TOWED_DISC, "\"12.5 mm\"", "\"12,5 mm\"", &["decimal point"]);
}

#[test]
fn wrong_type() {
    refused(TOWED_DISC, "symmetric = true", "symmetric = \"yes\"", &["true or false"]);
    refused(
        TOWED_DISC,
        "title = \"A light free disc towed over dry sand\"",
        "title = 3",
        &["expected text", "quotes"],
    );
    refused(TOWED_DISC, "x = [\"-0.35 m\", \"0.75 m\"]", "x = \"0.75 m\"", &["a list of 2"]);
    refused(TOWED_DISC, "x = [\"-0.35 m\", \"0.75 m\"]", "x = [\"0.75 m\"]", &["expected 2 values, found 1"]);
    refused(TOWED_DISC, "gravity = \"9.81 m/s^2\"", "gravity = 1979-05-27", &["found a date"]);
    refused(TOWED_DISC, "[output]", "[[output]]", &["must be a section"]);
}

#[test]
fn unknown_key_section_and_word() {
    refused(
        TOWED_DISC,
        "friction_angle",
        "frction_angle",
        &["unknown key", "did you mean `friction_angle`?"],
    );
    refused(TOWED_DISC, "[output]", "[outputs]", &["unknown key `outputs`", "did you mean `output`?"]);
    refused(
        TOWED_DISC,
        "\"mohr-coulomb\"",
        "\"mohr-colomb\"",
        &["did you mean \"mohr-coulomb\"?", "\"tresca\""],
    );
    refused(TOWED_DISC, "spin = \"free\"", "spin = \"fre\"", &["\"locked\", \"free\""]);
    refused(TOWED_DISC, "\"0.4 s\", ramp", "\"0.4 s\", rampe", &["did you mean `ramp`?"]);
}

#[test]
fn another_format_is_refused() {
    refused(TOWED_DISC, "format = 2", "format = 1", &["there is no format 1", "write  format = 2"]);
    refused(TOWED_DISC, "format = 2", "format = 3", &["newer than this version of Coulter"]);
    let without = TOWED_DISC
        .replace(
            "format = 2
",
            "",
        )
        .replace(
            "[output]",
            "[output]
steady = 0.5",
        );
    let text = complaint_about(without.as_bytes());
    for word in ["`format` is missing", "add  format = 2  at the top", "unknown key `steady`", "2 problems"] {
        assert!(text.contains(word), "`{word}` is not in: {text}");
    }
}

#[test]
fn a_key_of_another_law_or_shape() {
    refused(
        FOOTING,
        "shear_strength = \"1 kPa\"",
        "shear_strength = \"1 kPa\"\ncohesion = \"1 kPa\"",
        &["does not apply"],
    );
    refused(
        TOWED_DISC,
        "friction = 0.3",
        "size = [\"1 m\", \"1 m\", \"1 m\"]",
        &["does not apply to shape = \"disc\""],
    );
}

#[test]
fn metal_that_makes_no_sense() {
    refused(BAR, "\"400 MPa\"", "\"0 MPa\"", &["soil.yield_stress", "above 0"]);
    refused(BAR, "\"100 MPa\"", "\"-100 MPa\"", &["soil.hardening_modulus", "0 or more"]);
    refused(BAR, "yield_stress =", "shear_strength =", &["does not apply to law = \"von-mises\""]);
    refused_at(BAR, "yield_stress = \"400 MPa\"\n", "", "[soil]", &["`soil.yield_stress` is missing"]);
    refused(
        BAR,
        "law = \"von-mises\"\nyield_stress",
        "law = \"tresca\"\nyield_stress",
        &["does not apply to law"],
    );
}

#[test]
fn soil_that_cannot_move_so() {
    let still = "[\"0 m/s\", \"0 m/s\", \"-227 m/s\"]";
    refused(BAR, still, "[\"0 m/s\", \"1 m/s\", \"0 m/s\"]", &["through a plane of symmetry"]);
    refused(BAR, still, "[\"0 m/s\", \"1 m/s\"]", &["2 components", "along x, y and z"]);
    refused(BAR, still, "[\"0 m/s\", \"1 m\", \"0 m/s\"]", &["speed"]);
    refused(BAR, "\"3.2 mm\"", "\"0 mm\"", &["ground.radius", "above 0"]);
    let slab = FOOTING.replacen("[grid]", "[ground]\nradius = \"1 m\"\n[grid]", 1);
    refused(&slab, "radius = \"1 m\"", "radius = \"2 m\"", &["round column cannot be combined"]);
}

#[test]
fn flow_that_makes_no_sense() {
    let with = |line: &'static str| format!("cohesion = \"0 Pa\"\n{line}");
    let line = "cohesion = \"0 Pa\"";
    refused(TOWED_DISC, line, &with("meridional_eccentricity = 0.1"), &["only to the smooth potential"]);
    refused(
        TOWED_DISC,
        line,
        &with("flow_potential = \"menetrey-willam\"\ndeviatoric_eccentricity = 0.5"),
        &["above 0.5 and at most 1"],
    );
    refused(TOWED_DISC, line, &with("critical_density = \"1500 kg/m^3\""), &["does not dilate"]);
    refused(
        TOWED_DISC,
        "dilation_angle = \"0 deg\"",
        "dilation_angle = \"5 deg\"\ncritical_density = \"1700 kg/m^3\"",
        &["below its critical density", "1631"],
    );
}

#[test]
fn duplicate_key() {
    refused(
        TOWED_DISC,
        "weight = \"40 N\"",
        "weight = \"40 N\"\nweight = \"50 N\"",
        &["duplicate key", "set twice"],
    );
}

#[test]
fn missing_values() {
    refused_at(
        TOWED_DISC,
        "young_modulus = \"5 MPa\"",
        "",
        "soil]",
        &["`soil.young_modulus` is missing", "add"],
    );
    refused_at(TOWED_DISC, "weight = \"40 N\"", "", "body.disc]", &["its weight is not given", "mass ="]);
    refused_at(TOWED_DISC, "diameter = \"0.2 m\"", "", "body.disc]", &["`body.disc.diameter` is missing"]);
    refused_at(TOWED_DISC, "tow_distance = \"0.32 m\"", "", "run]", &["`run.duration` is missing"]);
}

#[test]
fn body_of_no_size_or_too_thin_for_the_grid() {
    refused(TOWED_DISC, "\"0.05 m\"", "\"0 m\"", &["body.disc.thickness", "above 0"]);
    refused(TOWED_DISC, "\"0.2 m\"", "\"-0.2 m\"", &["body.disc.diameter", "above 0"]);
    refused(TOWED_DISC, "\"0.05 m\"", "\"10 mm\"", &["0.80 cells across", "grid.cell at most 10.0000 mm"]);
    refused(FOOTING, "[\"1 m\", \"0.5 m\"]", "[\"1 m\", \"0 m\"]", &["must be above 0"]);
    refused(FOOTING, "[\"1 m\", \"0.5 m\"]", "[\"1 m\", \"1 m\", \"1 m\"]", &["plane strain"]);
}

#[test]
fn body_outside_the_box() {
    refused(TOWED_DISC, "sinkage = \"0 mm\"", "x = \"0.7 m\"", &["starts outside the box", "domain.x"]);
    refused(TOWED_DISC, "sinkage = \"0 mm\"", "sinkage = \"1 m\"", &["[body.disc] extends over z", "deeper"]);
    refused_at(TOWED_DISC, "\"0.32 m\"", "\"3.2 m\"", "forward", &["leaves the box on its path"]);
}

#[test]
fn weight_and_mass_disagree() {
    refused_at(
        TOWED_DISC,
        "weight = \"40 N\"",
        "weight = \"40 N\"\nmass = \"1 kg\"",
        "weight = \"40",
        &["contradict each other"],
    );
}

#[test]
fn impossible_times() {
    refused(TOWED_DISC, "\"0.32 m\"", "\"-0.32 m\"", &["run.tow_distance", "above 0"]);
    refused(TOWED_DISC, "tow_distance = \"0.32 m\"", "duration = \"0 s\"", &["run.duration", "above 0"]);
    refused(TOWED_DISC, "start = \"0.4 s\"", "start = \"-0.4 s\"", &["before the start of the run"]);
    refused(TOWED_DISC, "\"4 ms\"", "\"4 ns\"", &["history_interval", "longer"]);
}

#[test]
fn a_tow_that_goes_nowhere() {
    refused_at(TOWED_DISC, "speed = \"0.2 m/s\"", "speed = \"0 m/s\"", "tow_distance", &["other than 0"]);
    refused_at(
        TOWED_DISC,
        "start = \"0.4 s\"",
        "start = \"0.4 s\", end = \"0.6 s\"",
        "tow_distance",
        &["stops before"],
    );
    refused(TOWED_DISC, "tow_distance", "duration = \"1 s\"\ntow_distance", &["keep one of them"]);
}

#[test]
fn motions_that_contradict_themselves() {
    refused(
        TOWED_DISC,
        "load = \"0 N\"",
        "load = \"0 N\", speed = \"1 m/s\"",
        &["more than one of speed, load, displacement and table"],
    );
    refused(TOWED_DISC, "load = \"0 N\", ", "", &["none of speed, load, displacement and table"]);
}

#[test]
fn what_a_symmetric_case_cannot_be() {
    refused(TOWED_DISC, "sinkage = \"0 mm\"", "y = \"0.1 m\"", &["off the plane of symmetry"]);
    refused(TOWED_DISC, "lateral = \"fixed\"", "lateral = \"free\"", &["no lateral motion"]);
    refused(TOWED_DISC, "y = [\"0 m\", \"0.3 m\"]", "y = [\"-0.3 m\", \"0.3 m\"]", &["begin with \"0 m\""]);
    refused_at(
        TOWED_DISC,
        "symmetric = true",
        "symmetric = true\nplane_strain = true",
        "symmetric = true",
        &["remove `symmetric`"],
    );
}

#[test]
fn what_a_case_symmetric_about_x_cannot_be() {
    let half = FOOTING.replacen("x = [\"-3 m\"", "symmetric_x = true\nx = [\"0 m\"", 1);
    let half = half.replacen("fine_x = [\"-1.75 m\"", "fine_x = [\"0 m\"", 1);
    refused(&half, "x = [\"0 m\"", "x = [\"-1 m\"", &["begin with \"0 m\""]);
    refused(&half, "friction = 0", "friction = 0\nx = \"0.1 m\"", &["off the plane of symmetry"]);
    refused(&half, "friction = 0", "friction = 0\npitch = \"5 deg\"", &["not symmetric about x = 0"]);
    refused(
        &half,
        "friction = 0",
        "friction = 0\nmass = \"1 kg\"\nforward = \"free\"",
        &["allows no `forward`"],
    );
    let held = "x_walls = [\"fixed\", \"fixed\"]\nplane_strain = true";
    refused_at(&half, "plane_strain = true", held, "x_walls", &["a plane of symmetry is smooth"]);
}

#[test]
fn shapes_that_do_not_fit() {
    let sphere = "shape = \"sphere\"\ndiameter = \"1 m\"";
    let block = "shape = \"block\"\nsize = [\"1 m\", \"0.5 m\"]         # along x and z";
    refused_at(FOOTING, block, sphere, "shape = \"sphere\"", &["cannot be combined with plane_strain"]);
    let pile = "diameter = \"1 m\"\nshape = \"cylinder\"\naxis = \"z\"";
    refused(FOOTING, block, pile, &["lies across the slab"]);
    refused(
        FOOTING,
        block,
        "shape = \"cylinder\"\ndiameter = \"1 m\"\naxis = \"w\"",
        &["\"w\" is not one of"],
    );
    refused(
        FOOTING,
        block,
        "shape = \"cylinder\"\ndiameter = \"1 m\"\naxis = \"y\"\nlength = \"1 m\"",
        &["as long as the slab"],
    );
    refused(TOWED_DISC, "friction = 0.3", "axis = \"x\"", &["does not apply to shape"]);
}

#[test]
fn adhesion_and_overburden_that_mean_nothing() {
    refused(
        TOWED_DISC,
        "friction = 0.3",
        "friction = 0.3\nadhesion_factor = 1",
        &["undrained shear strength"],
    );
    refused(FOOTING, "friction = 0", "friction = \"rough\"\nadhesion_factor = 1.5", &["from 0 to 1"]);
    let lid = "[ground]\noverburden = \"50 kPa\"\n[grid]";
    refused_at(FOOTING, "[grid]", lid, "overburden =", &["needs a lid"]);
    let deep = FOOTING.replacen("\"-2.5 m\", \"0.5 m\"", "\"-2.5 m\", \"0 m\"", 1);
    assert_ne!(deep, FOOTING);
    refused_at(&deep, "[grid]", lid, "overburden =", &["cannot sustain this overburden"]);
}

#[test]
fn box_and_ground_that_do_not_fit() {
    refused(
        TOWED_DISC,
        "z = [\"-0.25 m\", \"0.075 m\"]",
        "z = [\"0.075 m\", \"-0.25 m\"]",
        &["lower value first"],
    );
    refused(WALL, "surface = \"0 m\"", "surface = \"2 m\"", &["not inside the box"]);
    refused(WALL, "x = [\"0 m\", \"4 m\"]", "x = [\"0 m\", \"5 m\"]", &["partly outside the box"]);
    refused(TOWED_DISC, "fine_x = [\"-0.2 m\"", "fine_x = [\"-2 m\"", &["fine zone is partly outside"]);
}

#[test]
fn absurd_resolution() {
    refused(TOWED_DISC, "\"12.5 mm\"", "\"12.5 nm\"", &["cells along one axis", "grid.cell"]);
    refused(TOWED_DISC, "\"12.5 mm\"", "\"0.02 mm\"", &["GB of memory", "make grid.cell larger"]);
    refused(TOWED_DISC, "\"12.5 mm\"", "\"0 mm\"", &["above 0"]);
    refused(TOWED_DISC, "growth = 1.15", "growth = 3", &["from 1 to 1.5"]);
}

#[test]
fn numbers_that_cannot_be_computed_with() {
    refused_at(TOWED_DISC, "\"5 MPa\"", "\"1e300 MPa\"", "young_modulus", &["time steps", "too many to run"]);
    refused_at(TOWED_DISC, "\"40 N\"", "\"1e-320 N\"", "body.disc]", &["outside the range"]);
}

#[test]
fn several_problems_are_reported_at_once() {
    let broken = TOWED_DISC.replace("\"35 deg\"", "\"95 deg\"").replace("weight = \"40 N\"", "wieght = 40");
    let broken = broken.replace("fine_x", "fine_xx").replace("spin = \"free\"", "spin = 3");
    let text = complaint_about(broken.as_bytes());
    for word in ["friction_angle", "`wieght`", "`weight`?", "`fine_xx`", "body.disc.spin", "problems in"] {
        assert!(text.contains(word), "`{word}` is not in: {text}");
    }
}

#[test]
fn uneven_ground() {
    let at = |new: &str, location: &str, words: &[&str]| {
        refused_at(FOOTING, "[grid]", &format!("{new}\n[grid]"), location, words);
    };
    let furrows = "[furrows]\nspacing = \"0.5 m\"\ndepth = \"20 mm\"\n";
    at(&furrows.replace("20 mm", "-20 mm"), "depth = \"-20", &["furrows.depth", "above 0", "help:"]);
    at(&furrows.replace("\"0.5 m\"", "0.5"), "spacing = 0.5", &["furrows.spacing", "unit", "help:"]);
    at(&furrows.replace("0.5 m", "5 s"), "spacing = \"5 s", &["a length is needed", "help:"]);
    at(&furrows.replace("0.5 m", "1 mm"), "spacing = \"1 mm", &["2 cells", "help:"]);
    at(&furrows.replace("depth", "width"), "width = ", &["`width`", "help:"]);
    at(&furrows.replace("20 mm", "90 m"), "[furrows]", &["not inside the box", "help:"]);
    at(&format!("{furrows}direction = \"0 deg\""), "[furrows]", &["across the slab", "help:"]);
    at("[furrows]\nspacing = nan\n", "spacing = nan", &["furrows.spacing", "help:"]);
    let ball = "[soil_body.ball]\nshape = \"block\"\nsize = [\"0.1 m\", \"0.1 m\"]\nelevation = \"-90 m\"\n\
                law = \"elastic\"\nyoung_modulus = \"9 MPa\"\nunit_weight = \"16 kN/m^3\"\n";
    at(ball, "elevation = \"-90 m", &["outside the box", "help:"]);
    at(&ball.replace("block", "frame"), "shape = \"frame\"", &["no volume", "help:"]);
    at(&ball.replace("ball", "a b"), "[soil_body.a b", &["not valid TOML"]);
    at("[soil_body]\nshape = \"block\"\n", "shape = \"block\"\n\n[grid]", &["has no keys of its own"]);
}

#[test]
fn files_of_heights() {
    let complaint_with = |name: &str, content: &[u8], more: &str| {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join(name), content).unwrap();
        let section = format!("[height_map]\nfile = \"{name}\"\n{more}\n[grid]");
        let path = folder.path().join("broken.toml");
        let case = FOOTING.replacen("[grid]", &section, 1);
        std::fs::write(&path, &case).unwrap();
        let line = case[..case.find("file =").unwrap()].matches('\n').count() + 1;
        let text = complaint(&["check", path.to_str().unwrap()]);
        assert!(text.contains(&format!("broken.toml:{line}:")), "line {line} is not named: {text}");
        assert!(text.contains("help:"), "no cure: {text}");
        // Long lines are broken.
        text.replace('│', " ").split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let placed = "unit = \"m\"\nx = [\"-9 m\", \"9 m\"]\ny = [\"-9 m\", \"9 m\"]";
    assert!(complaint_with("map.csv", b"", "").contains("empty"));
    assert!(complaint_with("map.csv", b"x,y,z\n0,0,0\n", "").contains("no unit of length"));
    assert!(complaint_with("map.csv", b"x [m],y [s],z [m]\n0,0,0\n", "").contains("no unit of length"));
    assert!(complaint_with("map.csv", b"1,2\n3,4\n", "").contains("unit is not given"));
    assert!(complaint_with("map.csv", b"1\n", placed).contains("1 × 1 points"));
    assert!(complaint_with("map.csv", b"0,0\n0,nan\n", placed).contains("line 2"));
    assert!(
        complaint_with("map.csv", b"0,0\n0,0\n", &placed.replace("\"9 m", "\"-8 m"))
            .contains("the map lies over")
    );
    assert!(complaint_with("map.tif", b"II*\0\x08\0\0\0", placed).contains("not a whole TIFF"));
    assert!(complaint_with("map.tif", b"", placed).contains("not a whole TIFF"));
    let heights = placed.replace("unit = \"m\"", "heights = [\"0 mm\", \"1 mm\"]");
    assert!(complaint_with("map.png", b"\x89PNG\r\n\x1a\n", &heights).contains("not a whole PNG"));
    assert!(complaint_with("map.bmp", b"BM", placed).contains("extension"));
}

#[test]
fn files_that_are_no_case() {
    assert!(complaint_about(b"").contains("the case is empty"));
    assert!(complaint_about(b"# nothing\n\n").contains("coulter new"));
    assert!(complaint_about(b"title = \"\xff\xfe\"\n").contains("line 1 is not UTF-8"));
    assert!(complaint_about(b"hello, world").contains("broken.toml:1:"));
    assert!(complaint_about(b"[soil\nlaw = 1").contains("not valid TOML"));
    assert!(complaint_about(b"title = \"an open string").contains("broken.toml:1:"));
    assert!(complaint_about("a=[".repeat(5000).as_bytes()).contains("not valid TOML"));
    assert!(complaint_about("[".repeat(100_000).as_bytes()).contains("not valid TOML"));
    assert!(
        complaint_about(b"format = 2\nsoil = 3\ngrid = 4\nrun = []\nbody = 5").contains("must be a section")
    );
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().to_str().unwrap();
    assert!(complaint(&["check", path]).contains("a directory"));
    assert!(complaint(&["check", &format!("{path}/none.toml")]).contains("cannot be read"));
}

#[test]
fn overrides_are_checked_like_the_file() {
    let case = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/light_disc.toml");
    let message = |set: &str| complaint(&["check", case, "--set", set]);
    assert!(message("soil.frction_angle=38 deg").contains("did you mean `friction_angle`?"));
    assert!(message("soil.frction_angle=38 deg").contains("--set soil.frction_angle:1:1"));
    assert!(message("soil.friction_angle=38").contains("--set soil.friction_angle:1:21"));
    assert!(message("soil.friction_angle=\"98 deg\"").contains("below 90 deg"));
    assert!(message("soil.friction_angle").contains("no `=`"));
    assert!(message("=3").contains("is not a key"));
    assert!(message("soil.law.x=3").contains("`law` is text"));
    assert!(message("a.b.c.d.e.f.g.h=1").contains("is not a key"));
}
