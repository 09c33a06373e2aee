//! Ground that is not level: furrows and height maps rest, are no ruts, enter a grid that travels, and are
//! refused where they cannot be.
use super::{SAND, complaints, fastest, read, run};
use coulter::case::{self, Case};
use coulter::output::fields::HeightMap;
use coulter::simulation::Simulation;
use solver::halo::Halo;
use solver::initial::undisturbed_fractions;

const ROCK: &str = "law = \"mohr-coulomb\"\nfriction_angle = \"35 deg\"\nunit_weight = \"16 kN/m^3\"\n";
const FURROWS: &str = "[furrows]\nspacing = \"0.2 m\"\ndepth = \"20 mm\"\n";

fn text(soil: &str, rest: &str) -> String {
    format!(
        "format = 2\n[soil]\nyoung_modulus = \"5 MPa\"\n{soil}[domain]\nx = [\"-0.2 m\", \"0.2 m\"]\ny = [\"-0.04 m\", \"0.04 m\"]\n\
         z = [\"-0.1 m\", \"0.06 m\"]\n[grid]\ncell = \"8 mm\"\n{rest}"
    )
}

/// A case beside a map.
fn with_map(text: &str, map: &str) -> Result<Case, String> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("map.csv"), map).unwrap();
    let name = folder.path().join("case.toml");
    case::parse(text, name.to_str().unwrap(), &[]).map_err(|error| error.to_string())
}

/// A map over ±3 m whose height in mm is a function of x and y.
fn map(height: impl Fn(f64, f64) -> f64) -> String {
    let mut text = "x [m],y [m],z [mm]\n".to_owned();
    for n in 0..=120 {
        for m in [-3.0, -0.02, 0.02, 3.0] {
            let x = -3.0 + 0.05 * f64::from(n);
            text += &format!("{x},{m},{}\n", height(x, m));
        }
    }
    text
}

/// Mass of the soil, kinetic energy at its largest and largest change of the height of a column in a run [kg,
/// J, m].
fn settled(case: &Case) -> [f64; 3] {
    let mut simulation = Simulation::new(case);
    let grid = simulation.model.grid.clone();
    let heights = |simulation: &Simulation| {
        HeightMap::of(case, (&grid, &Halo::whole()), &simulation.state, &[]).unwrap()
    };
    let mass: f64 = simulation.state.soil.mass.iter().sum();
    let (mut kinetic, mut moved) = (0.0_f64, 0.0_f64);
    while !simulation.is_done() {
        simulation.advance().unwrap();
        kinetic = kinetic.max(simulation.history.energy.last().unwrap().kinetic);
    }
    let map = heights(&simulation);
    for j in 0..map.centres[1].len() {
        for i in 0..map.centres[0].len() {
            moved = moved.max(map.rise(i, j).abs());
        }
    }
    [mass, kinetic, moved]
}

#[test]
fn furrows_settle_by_a_fraction_of_a_cell() {
    for (name, soil) in [("sand", SAND), ("mohr-coulomb", ROCK)] {
        let case = read(&text(soil, &format!("{FURROWS}[run]\nduration = \"0.3 s\"\n"))).unwrap();
        let [mass, kinetic, moved] = settled(&case);
        println!("{name}: {mass:.3} kg, at most {kinetic:.3e} J, surface moved by {:.4} mm", 1e3 * moved);
        // The weight of the soil times a height through which it could fall.
        let height = kinetic / (mass * 9.81);
        assert!(height < 1e-6, "{name}: {height} m");
        assert!(moved < 0.8e-3, "{name}: {moved} m, a tenth of a cell");
    }
}

#[test]
fn a_level_map_is_level_ground() {
    let rest = "[run]\nduration = \"0.02 s\"\n";
    let level = run(&read(&text(SAND, rest)).unwrap());
    let mapped = text(SAND, &format!("[height_map]\nfile = \"map.csv\"\n{rest}"));
    let mapped = run(&with_map(&mapped, &map(|_, _| 0.0)).unwrap());
    assert!(fastest(&mapped) < 1e-12, "{} m/s", fastest(&mapped));
    let stresses = |simulation: &Simulation| simulation.state.soil.stress[2].clone();
    for (a, b) in stresses(&level).iter().zip(&stresses(&mapped)) {
        assert!((a - b).abs() < 1e-9 * 1600.0, "{a}, not {b} Pa");
    }
}

#[test]
fn the_volume_below_an_uneven_surface_is_that_of_its_integral() {
    let rest = "[run]\nduration = \"1 ms\"\n";
    let volume = |case: &Case| {
        let simulation = Simulation::<f64>::new(case);
        simulation.state.energy_balance.volume_start
    };
    let plain = 0.4 * 0.08 * 0.1;
    // Two whole furrows, in either section: their mean is the level surface. Along x they run straight
    // through.
    for more in [
        "",
        "section = \"triangular\"\n",
        "direction = \"0 deg\"\nspacing = \"0.08 m\"\noffset = \"0.02 m\"\n",
    ] {
        let furrows = if more.contains("spacing") {
            FURROWS.replace("spacing = \"0.2 m\"\n", "")
        } else {
            FURROWS.to_owned()
        };
        let case = read(&text(SAND, &format!("{furrows}{more}{rest}"))).unwrap();
        assert!((volume(&case) / plain - 1.0).abs() < 1e-3, "{more}: {}", volume(&case) / plain);
    }
    // A plane, and furrows on top of it.
    let inclined = map(|x, _| 20.0 * x + 5.0);
    for furrows in ["", FURROWS] {
        let case = text(SAND, &format!("[height_map]\nfile = \"map.csv\"\n{furrows}{rest}"));
        let expected = plain + 0.4 * 0.08 * 0.005;
        let found = volume(&with_map(&case, &inclined).unwrap());
        assert!((found / expected - 1.0).abs() < 1e-3, "{}", found / expected);
    }
}

/// A block towed across furrows that run at right angles to the tow, or along it.
fn towed(direction: &str, more: &str) -> String {
    format!(
        "format = 2\n[soil]\nyoung_modulus = \"5 MPa\"\n{}[domain]\nx = [\"-0.25 m\", \"0.25 m\"]\ny = [\"-0.12 m\", \"0.12 m\"]\n\
         z = [\"-0.1 m\", \"0.08 m\"]\n[grid]\ncell = \"10 mm\"\n{more}{FURROWS}{direction}[body.block]\nshape = \"block\"\n\
         size = [\"40 mm\", \"40 mm\", \"80 mm\"]\nfriction = 0.3\nsinkage = \"20 mm\"\nx = \"-0.1 m\"\n\
         forward = {{ speed = \"1 m/s\", ramp = \"10 ms\" }}\n[run]\nduration = \"0.2 s\"\n",
        SAND.replace("0.5", "0.1")
    )
}

#[test]
fn the_books_of_a_rut_across_furrows_close() {
    for direction in ["", "direction = \"0 deg\"\noffset = \"0.1 m\"\n"] {
        let case = read(&towed(direction, "")).unwrap();
        let simulation = run(&case);
        let map =
            HeightMap::of(&case, (&simulation.model.grid, &Halo::whole()), &simulation.state, &[]).unwrap();
        let taken_out = simulation.history.bodies[0][0].embedded_volume;
        let figures = map.figures(taken_out);
        println!("{direction}: {figures:?}, taken out {taken_out}");
        assert!(figures.rut_volume_m3 > 1e-4 && figures.berm_volume_m3 > 0.0, "{figures:?}");
        assert!(figures.unexplained.abs() < 0.005, "{} of the rut", figures.unexplained);
        // Far beside the tow the furrows are as they were.
        let beside = (0..map.centres[0].len()).map(|i| map.rise(i, 0).abs()).fold(0.0, f64::max);
        assert!(beside < 1e-3, "{beside} m");
        let rut = coulter::output::fields::ruts(&case, &map, &simulation.state, &simulation.history.bodies);
        assert!(rut[0].sections.first().unwrap().area < 1e-4, "{:?}", rut[0].sections.first());
    }
}

#[test]
fn the_ground_that_enters_a_grid_is_that_of_its_place() {
    let follow = "follow = { body = \"block\" }\n";
    let lens = "[soil_body.lens]\nshape = \"sphere\"\ndiameter = \"60 mm\"\nx = \"0.3 m\"\nelevation = \"-50 mm\"\nyoung_modulus = \"5 MPa\"\n\
                law = \"mohr-coulomb\"\nfriction_angle = \"40 deg\"\nunit_weight = \"18 kN/m^3\"\n";
    let case = towed("direction = \"70 deg\"\n", &format!("growth = 1\n{follow}")).replace("0.2 s", "0.25 s");
    let case = read(&format!("{lens}{case}").replacen(lens, "", 1).replace("[run]", &format!("{lens}[run]")))
        .unwrap();
    let simulation = run(&case);
    let (state, model) = (&simulation.state, &simulation.model);
    assert!(state.grid_position.x > 0.2, "{}", state.grid_position.x);
    let faces = [0, 1, 2].map(|axis| {
        let inside = model.grid.inside(axis);
        let shift = state.grid_position[axis];
        model.grid.faces[axis][inside.start..=inside.end].iter().map(|x| x + shift).collect::<Vec<_>>()
    });
    let there = solver::grid::Grid::new(faces);
    let expected = undisturbed_fractions(&there, &model.ground);
    let [columns, rows, layers] = there.cells();
    let (mut most, mut sum, mut count, mut of_lens) = (0.0_f64, 0.0, 0.0, 0.0_f64);
    for k in 0..layers {
        for j in 0..rows {
            // Half of what is in front of the block has entered; it is not yet near.
            for i in columns - 8..columns {
                let cell = model.grid.index(i + model.grid.inside(0).start, j, k);
                let off = (state.soil.fraction[cell] - expected[there.index(i, j, k)]).abs();
                (most, sum, count) = (most.max(off), sum + off, count + 1.0);
            }
            for i in columns - 24..columns {
                let cell = model.grid.index(i + model.grid.inside(0).start, j, k);
                of_lens +=
                    state.soil.composition[0][cell] * state.soil.fraction[cell] * model.grid.volume_of(cell);
            }
        }
    }
    println!("fractions off by {most} at most, {} in the mean; volume of the lens {of_lens} m³", sum / count);
    assert!(most < 0.1 && sum / count < 0.002, "{most}, {}", sum / count);
    let ball = std::f64::consts::PI / 6.0 * 0.06_f64.powi(3);
    assert!((of_lens / ball - 1.0).abs() < 0.03, "{}", of_lens / ball);
    let last = simulation.history.energy.last().unwrap();
    assert!(last.overdense == 0.0, "{}", last.overdense);
}

#[test]
fn uneven_ground_that_cannot_be_is_refused() {
    let run = "[run]\nduration = \"1 ms\"\n";
    let refused = |rest: &str, expected: &str| {
        let error = complaints(&text(SAND, &format!("{rest}{run}")));
        assert!(error.contains(expected), "{rest}: {error}");
    };
    refused("[furrows]\ndepth = \"20 mm\"\n", "`furrows.spacing` is missing");
    refused("[furrows]\nspacing = \"0.2 m\"\ndepth = \"0 mm\"\n", "furrows.depth");
    refused("[furrows]\nspacing = \"0.2\"\ndepth = \"20 mm\"\n", "unit");
    refused("[furrows]\nspacing = \"15 mm\"\ndepth = \"2 mm\"\n", "2 cells");
    refused("[furrows]\nspacing = \"0.2 m\"\ndepth = \"0.3 m\"\n", "not inside the box");
    refused(&format!("{FURROWS}section = \"square\"\n"), "furrows.section");
    refused(&format!("{FURROWS}[ground]\nx = [\"-0.1 m\", \"0.1 m\"]\n"), "column or a bank");
    refused(&format!("{FURROWS}[ground]\noverburden = \"1 kPa\"\nsurface = \"60 mm\"\n"), "lid");
    refused("[height_map]\nunit = \"m\"\n", "`height_map.file` is missing");
    refused("[height_map]\nfile = \"nowhere.csv\"\n", "cannot be read");
    refused(
        "[height_map]\nfile = \"nowhere.csv\"\norigin = [\"0 m\", \"0 m\", \"0 m\"]\n",
        "a point of 3 coordinates",
    );
    refused("[height_map]\nfile = 3\n", "text");
    refused("furrows = 3\n", "furrows");
    let half = |direction: &str, plane: &str| {
        let text = text(SAND, &format!("{FURROWS}{direction}{run}"))
            .replace("[domain]\n", &format!("[domain]\n{plane}"));
        let narrow = text.replace("[\"-0.04 m\"", "[\"0 m\"").replace("[\"-0.2 m\"", "[\"0 m\"");
        read(&narrow).map(|_| ())
    };
    half("", "symmetric = true\nsymmetric_x = true\n").unwrap();
    half("offset = \"0.1 m\"\n", "symmetric_x = true\n").unwrap();
    assert!(half("offset = \"20 mm\"\n", "symmetric_x = true\n").unwrap_err().contains("mirror image"));
    assert!(half("direction = \"60 deg\"\n", "symmetric = true\n").unwrap_err().contains("mirror image"));
    assert!(half("direction = \"0 deg\"\n", "plane_strain = true\n").unwrap_err().contains("plane strain"));
}

#[test]
fn a_map_must_know_the_ground_wherever_the_grid_goes() {
    let mapped = |origin: &str, more: &str| {
        let section = format!("{more}[height_map]\nfile = \"map.csv\"\n{origin}");
        let case = towed("", "").replace(FURROWS, &section);
        with_map(&case, &map(|x, _| x)).map(|_| ())
    };
    mapped("", "").unwrap();
    let error = mapped("origin = [\"2.9 m\", \"0 m\"]\n", "").unwrap_err();
    assert!(error.contains("the map lies over x = -5.9 to 0.1"), "{error}");
    let follow = "follow = { body = \"block\" }\n";
    mapped("origin = [\"2.4 m\", \"0 m\"]\n", follow).unwrap();
    let error = mapped("origin = [\"2.6 m\", \"0 m\"]\n", follow).unwrap_err();
    assert!(error.contains("ghost layers"), "{error}");
    let free = towed("", follow).replace(FURROWS, "[height_map]\nfile = \"map.csv\"\n");
    let free =
        free.replace("{ speed = \"1 m/s\", ramp = \"10 ms\" }", "{ load = \"5 N\" }\nweight = \"20 N\"");
    let error = with_map(&free, &map(|_, _| 0.0)).unwrap_err();
    assert!(error.contains("a height map has an end"), "{error}");
}

#[test]
fn the_map_that_a_run_leaves_is_ground_for_the_next() {
    let case = read(&towed("", "")).unwrap();
    let simulation = Simulation::<f64>::new(&case);
    let map = HeightMap::of(&case, (&simulation.model.grid, &Halo::whole()), &simulation.state, &[]).unwrap();
    let mut table = "x [m],y [m],z [m]\n".to_owned();
    for (j, y) in map.centres[1].iter().enumerate() {
        for (i, x) in map.centres[0].iter().enumerate() {
            table += &format!("{x:e},{y:e},{:e}\n", map.at(i, j));
        }
    }
    let next = text(SAND, "[height_map]\nfile = \"map.csv\"\n[run]\nduration = \"1 ms\"\n");
    with_map(&next, &table).unwrap();
}

#[test]
fn steep_slopes_and_buried_bodies_are_mentioned() {
    let notes = |text: &str| case::advice(&read(text).unwrap()).join("\n");
    let gentle = notes(&towed("", ""));
    assert!(!gentle.contains("steep"), "{gentle}");
    let steep = notes(
        &towed("", "")
            .replace("\"20 mm\"\n[body", "\"60 mm\"\n[body")
            .replace("sinkage = \"20 mm\"", "sinkage = \"0 mm\""),
    );
    assert!(steep.contains("43.3° steep, the friction angle 32.0°"), "{steep}");
    assert!(steep.contains("block: starts up to"), "{steep}");
    let coarse = notes(&towed("", "").replace("spacing = \"0.2 m\"", "spacing = \"60 mm\""));
    assert!(coarse.contains("6.0 cells from crest to crest"), "{coarse}");
}
