//! Bodies of other soil in the ground: their volume, their soil, heaps above the surface, and what is
//! refused.
use super::{SAND, complaints, fastest, read};
use coulter::simulation::Simulation;
use std::f64::consts::PI;

const CLAY: &str = "law = \"tresca\"\nshear_strength = \"5 kPa\"\nunit_weight = \"18 kN/m^3\"\nyoung_modulus = \"3 MPa\"\nk0 = 1\n";

fn text(bodies: &str, rest: &str) -> String {
    format!(
        "format = 2\ngravity = \"9.81 m/s^2\"\n[soil]\nyoung_modulus = \"5 MPa\"\n{SAND}{bodies}\
         [domain]\nx = [\"-0.1 m\", \"0.1 m\"]\ny = [\"-0.1 m\", \"0.1 m\"]\nz = [\"-0.15 m\", \"0.1 m\"]\n\
         [grid]\ncell = \"10 mm\"\n{rest}[run]\nduration = \"20 ms\"\n"
    )
}

fn body(shape: &str) -> String {
    format!("[soil_body.lens]\n{shape}\n{CLAY}")
}

/// Volumes of the soil as a whole and of the second material [m³].
fn volumes(simulation: &Simulation) -> [f64; 2] {
    let (soil, grid) = (&simulation.state.soil, &simulation.model.grid);
    let [nx, ny, nz] = grid.cells();
    let mut sums = [0.0; 2];
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let cell = grid.index(i, j, k);
                let volume = soil.fraction[cell] * grid.volume(i, j, k);
                sums[0] += volume;
                sums[1] += volume * soil.composition[0][cell];
            }
        }
    }
    sums
}

#[test]
fn a_soil_body_takes_its_volume_from_the_soil() {
    let whole = 0.2 * 0.2 * 0.15;
    for (shape, volume) in [
        (
            "shape = \"sphere\"\ndiameter = \"80 mm\"\nelevation = \"-71 mm\"\nx = \"3 mm\"",
            PI / 6.0 * 0.08_f64.powi(3),
        ),
        (
            "shape = \"block\"\nsize = [\"73 mm\", \"60 mm\", \"41 mm\"]\nelevation = \"-77 mm\"",
            0.073 * 0.060 * 0.041,
        ),
        (
            "shape = \"block\"\nsize = [\"73 mm\", \"60 mm\", \"41 mm\"]\nelevation = \"-77 mm\"\nyaw = \"30 deg\"\ntilt = \"20 deg\"\npitch = \"10 deg\"",
            0.073 * 0.060 * 0.041,
        ),
        (
            "shape = \"cylinder\"\naxis = \"y\"\ndiameter = \"60 mm\"\nlength = \"80 mm\"\nelevation = \"-74 mm\"",
            0.25 * PI * 0.06 * 0.06 * 0.08,
        ),
    ] {
        let simulation = Simulation::<f64>::new(&read(&text(&body(shape), "")).unwrap());
        let [all, own] = volumes(&simulation);
        println!("{shape}: {}, whole {}", own / volume, all / whole);
        assert!((own / volume - 1.0).abs() < 0.01, "{shape}: {}", own / volume);
        assert!((all / whole - 1.0).abs() < 1e-3, "{shape}: {}", all / whole);
    }
}

#[test]
fn a_heap_lies_on_the_ground() {
    // Half of a sphere that reaches above the surface.
    let heap = body("shape = \"sphere\"\ndiameter = \"80 mm\"\nelevation = \"0 mm\"");
    let simulation = Simulation::<f64>::new(&read(&text(&heap, "")).unwrap());
    let half = PI / 12.0 * 0.08_f64.powi(3);
    let [all, own] = volumes(&simulation);
    assert!((own / (2.0 * half) - 1.0).abs() < 0.01, "{}", own / (2.0 * half));
    assert!(((all - 0.2 * 0.2 * 0.15) / half - 1.0).abs() < 0.01, "{}", (all - 0.2 * 0.2 * 0.15) / half);
    // Below it the ground bears its weight, 40 mm of clay and 40 mm of it in the ground.
    let grid = &simulation.model.grid;
    let [nx, ny, _] = grid.cells();
    let at = grid.index(nx / 2, ny / 2, 0);
    let stress = simulation.state.soil.stress[2][at];
    let expected = -(0.08 * 18e3 + 0.105 * simulation.case.soil.unit_weight);
    assert!((stress / expected - 1.0).abs() < 0.03, "{stress}, not {expected} Pa");
}

#[test]
fn a_lens_of_equal_weight_rests() {
    // Of the same density and K₀ nothing changes but the law.
    let sand = read(&text("", "")).unwrap().soil;
    let lens = format!(
        "[soil_body.lens]\nshape = \"sphere\"\ndiameter = \"80 mm\"\nelevation = \"-70 mm\"\nlaw = \"mohr-coulomb\"\nfriction_angle = \"40 deg\"\n\
         young_modulus = \"8 MPa\"\ndensity = \"{} kg/m^3\"\nk0 = {}\n",
        sand.density, sand.k0
    );
    let simulation = super::run(&read(&text(&lens, "")).unwrap());
    assert!(fastest(&simulation) < 1e-9, "{} m/s", fastest(&simulation));
}

#[test]
fn the_first_of_two_soil_bodies_counts() {
    let ball = |name: &str, x: &str| {
        format!(
            "[soil_body.{name}]\nshape = \"sphere\"\ndiameter = \"80 mm\"\nelevation = \"-70 mm\"\nx = \"{x}\"\n{CLAY}"
        )
    };
    let simulation = Simulation::<f64>::new(
        &read(&text(&format!("{}{}", ball("b", "-10 mm"), ball("a", "10 mm")), "")).unwrap(),
    );
    let names: Vec<&str> = simulation.case.soil_bodies.iter().map(|body| &*body.name).collect();
    assert_eq!(names, ["b", "a"]);
    let (soil, grid) = (&simulation.state.soil, &simulation.model.grid);
    let [nx, ny, _] = grid.cells();
    let middle = grid.index(nx / 2, ny / 2, grid.faces[2].partition_point(|z| *z < -0.07) - 1);
    assert!(soil.composition[0][middle] > 0.99, "{}", soil.composition[0][middle]);
}

#[test]
fn what_cannot_lie_in_the_ground_is_refused() {
    let refused = |bodies: &str, rest: &str, expected: &str| {
        let error = complaints(&text(bodies, rest));
        assert!(error.contains(expected), "{bodies}{rest}: {error}");
    };
    let ball = "shape = \"sphere\"\ndiameter = \"80 mm\"\n";
    let placed = |elevation: &str| body(&format!("{ball}elevation = \"{elevation}\"\n"));
    refused(&body(ball), "", "`soil_body.lens.elevation` is missing");
    refused(&body("diameter = \"80 mm\"\nelevation = \"0 m\""), "", "`soil_body.lens.shape` is missing");
    refused(&body("shape = \"frame\"\nelevation = \"0 m\""), "", "no volume");
    refused(
        &body("shape = \"sphere\"\ndiameter = \"0 mm\"\nelevation = \"0 m\""),
        "",
        "soil_body.lens.diameter",
    );
    refused(
        &body("shape = \"sphere\"\nsize = [\"1 m\", \"1 m\", \"1 m\"]\nelevation = \"0 m\""),
        "",
        "does not apply",
    );
    refused(&placed("-1 m"), "", "outside the box");
    refused(&placed("80 mm"), "", "above the lid");
    refused(&placed("-50 mm").replace("elevation", "friction = 0.3\nelevation"), "", "friction");
    refused(&placed("-50 mm").replace("18 kN", "18 N"), "density = 3\n", "density");
    refused(&placed("-50 mm"), "[ground]\nx = [\"-0.1 m\", \"0 m\"]\n", "column or a bank");
    refused(
        &placed("-50 mm").replace("unit_weight", "density = \"1500 kg/m^3\"\nunit_weight"),
        "",
        "one gravity acts",
    );
    refused("[soil_body]\nshape = \"sphere\"\n", "", "[soil_body], which has no keys of its own");
    refused(&format!("{}{}", placed("-50 mm"), placed("-60 mm")), "", "duplicate key");
    refused(
        &body("shape = \"mesh\"\nfile = \"nowhere.stl\"\nunit = \"mm\"\nelevation = \"0 m\""),
        "",
        "nowhere.stl",
    );
    let many: String = (0..21).map(|n| placed("-50 mm").replace("lens", &format!("lens{n}"))).collect();
    refused(&many, "", "at most 20");
    let half = |more: &str| {
        let whole = text(&body(&format!("{ball}elevation = \"-50 mm\"\n{more}")), "");
        read(&whole.replace("y = [\"-0.1 m\"", "symmetric = true\ny = [\"0 m\"")).map(|_| ())
    };
    half("").unwrap();
    half("y = \"50 mm\"\n").unwrap();
    assert!(half("y = \"20 mm\"\n").unwrap_err().contains("its own mirror image"));
}
