//! A case is checked however it was made: from a file, from nested maps, or by hand.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::resolved::{
    Body, Case, Ground, Law, MohrCoulomb, Potential, Sand, Tresca, VonMises, Wall,
};
use coulter::case::shapes::{Cylinder, Shape, Sphere};
use coulter::case::{self, CaseError, Problem, keys, validate};
use coulter::interrupts::Interrupts;
use coulter::run::{RunError, RunOptions, Start, run};
use coulter::simulation::Simulation;
use geometry::DiscRim;
use glam::DVec3;
use mechanics::Motion;
use proptest::prelude::*;
use serde_json::json;

const TOWED_DISC: &str = include_str!("../../../cases/light_disc.toml");
const UNDER_WATER: &str = include_str!("../../../cases/disc_under_water.toml");
const FURROWED: &str = include_str!("../../../cases/furrowed_field.toml");
const FOOTING: &str = include_str!("../../../cases/strip_footing.toml");
const COLUMN: &str = include_str!("../../../cases/column_collapse.toml");
const BAR: &str = include_str!("../../../validation/A10_taylor_bar/case.toml");

fn parsed(text: &str, overrides: &[&str]) -> Result<Case, CaseError> {
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    case::parse(text, "case.toml", &overrides)
}

/// A change by hand.
type Change = fn(&mut Case);
/// A fault: how to type it, and how to make it by hand.
type Fault = (&'static str, &'static [&'static str], Change);

/// Faults that a case file and a case made by hand can have alike.
const FAULTS: &[Fault] = &[
    (TOWED_DISC, &["soil.friction_angle=95 deg"], |c| *mohr_coulomb(c)[0] = 95.0_f64.to_radians()),
    (TOWED_DISC, &["soil.dilation_angle=36 deg"], |c| *mohr_coulomb(c)[1] = 36.0_f64.to_radians()),
    (TOWED_DISC, &["soil.cohesion=-1 Pa"], |c| *mohr_coulomb(c)[2] = -1.0),
    (TOWED_DISC, &["soil.tension_cutoff=5 Pa"], |c| *mohr_coulomb(c)[3] = 5.0),
    (TOWED_DISC, &["soil.young_modulus=0 Pa"], |c| c.soil.young_modulus = 0.0),
    (TOWED_DISC, &["soil.poisson_ratio=0.5"], |c| c.soil.poisson_ratio = 0.5),
    (TOWED_DISC, &["soil.k0=-1"], |c| c.soil.k0 = -1.0),
    (TOWED_DISC, &["gravity=-9.81 m/s^2"], |c| c.gravity = -9.81),
    (TOWED_DISC, &["name=a b"], |c| c.name = "a b".into()),
    (TOWED_DISC, &["body.disc.diameter=0 m"], |c| c.bodies[0].shape = disc(0.0, 0.05)),
    (TOWED_DISC, &["body.disc.thickness=10 mm"], |c| c.bodies[0].shape = disc(0.2, 0.01)),
    (TOWED_DISC, &["body.disc.friction=-0.1"], |c| c.bodies[0].friction = -0.1),
    (TOWED_DISC, &["body.disc.axle_inertia=-1 kg*m^2"], |c| c.bodies[0].axle_inertia = -1.0),
    (TOWED_DISC, &["body.disc.x=0.7 m"], |c| c.bodies[0].position.x = 0.7),
    (TOWED_DISC, &["body.disc.y=0.1 m"], |c| c.bodies[0].position.y = 0.1),
    (TOWED_DISC, &["body.disc.lateral=free"], |c| c.bodies[0].translation[1] = free(0.0)),
    (TOWED_DISC, &["body.disc.spin={ load = '0 N*m', start = '-1 s' }"], |c| {
        c.bodies[0].rotation[2] = free(-1.0)
    }),
    (TOWED_DISC, &["domain.y=['-0.3 m', '0.3 m']"], |c| c.domain.low.y = -0.3),
    (TOWED_DISC, &["domain.y_walls=['fixed', 'smooth']"], |c| c.domain.walls[1][0] = Wall::Fixed),
    (TOWED_DISC, &["domain.z=['0.1 m', '0 m']"], |c| (c.domain.low.z, c.domain.high.z) = (0.1, 0.0)),
    (TOWED_DISC, &["ground.velocity=['0 m/s', '1 m/s', '0 m/s']"], |c| c.velocity.y = 1.0),
    (TOWED_DISC, &["ground.overburden=1 kPa"], |c| c.overburden = 1e3),
    (TOWED_DISC, &["ground.overburden=-1 kPa"], |c| c.overburden = -1e3),
    (TOWED_DISC, &["grid.growth=3"], |c| c.grid.growth = 3.0),
    (TOWED_DISC, &["numerics.courant=0"], |c| c.numerics.courant = 0.0),
    (TOWED_DISC, &["numerics.threads=4097"], |c| c.numerics.threads = 4097),
    (TOWED_DISC, &["numerics.edge_inset=3"], |c| c.numerics.edge_inset = 3.0),
    (TOWED_DISC, &["output.steady_fraction=1.5"], |c| c.output.steady_fraction = 1.5),
    (TOWED_DISC, &["output.history_interval=4 ns"], |c| c.output.history_interval = 4e-9),
    (TOWED_DISC, &["forecast.bow_wave=2"], |c| c.forecast.bow_wave = 2.0),
    (TOWED_DISC, &["soil.young_modulus=1e300 MPa"], |c| c.soil.young_modulus = 1e306),
    (FOOTING, &["soil.shear_strength=0 Pa"], |c| c.soil.law = Law::Tresca(Tresca::default())),
    (FOOTING, &["domain.y_walls=['fixed', 'fixed']"], |c| c.domain.walls[1] = [Wall::Fixed; 2]),
    (COLUMN, &["ground.surface=-9 m"], |c| match &mut c.ground {
        Ground::Level { surface } => *surface = -9.0,
        Ground::Column { high, .. } => high.z = -9.0,
    }),
    (BAR, &["soil.hardening_modulus=-1 MPa"], |c| match &mut c.soil.law {
        Law::VonMises(metal) => metal.hardening_modulus = -1e6,
        _ => panic!("no metal"),
    }),
    (BAR, &["ground.radius=0 mm"], |c| match &mut c.ground {
        Ground::Column { radius, .. } => *radius = Some(0.0),
        Ground::Level { .. } => panic!("no bar"),
    }),
];

fn mohr_coulomb(case: &mut Case) -> [&mut f64; 4] {
    match &mut case.soil.law {
        Law::MohrCoulomb(MohrCoulomb {
            friction_angle, dilation_angle, cohesion, tension_cutoff, ..
        }) => [friction_angle, dilation_angle, cohesion, tension_cutoff],
        _ => panic!("no sand"),
    }
}

fn disc(diameter: f64, thickness: f64) -> Shape {
    Shape::Disc(case::shapes::Disc { diameter, thickness, rim: DiscRim::Square, dish: None })
}

fn free(start: f64) -> Motion {
    Motion::Free { load: 0.0, support: 0.0, start, ramp: 0.1 }
}

/// Whether a path is that of a key or of a section.
fn exists(path: &str) -> bool {
    let section = path.split('.').next().unwrap_or_default();
    keys::at(path).is_some() || keys::find(section).is_some() && path.split('.').count() <= 2
}

#[test]
fn a_fault_made_by_hand_is_found_like_a_typed_one() {
    for (text, typed, by_hand) in FAULTS {
        let error = parsed(text, typed).unwrap_err();
        let mut case = parsed(text, &[]).unwrap();
        assert_eq!(validate(&case), [], "{typed:?}: the case is wrong without the fault");
        by_hand(&mut case);
        let found = validate(&case);
        let is_same = |p: &Problem| {
            error.problems.iter().any(|q| (&q.path, &q.message, &q.cure) == (&p.path, &p.message, &p.cure))
        };
        assert!(found.iter().any(is_same), "{typed:?}:\ntyped {error:#?}\nby hand {found:#?}");
        for problem in found {
            assert!(exists(&problem.path), "{typed:?}: {problem:?}");
            assert!(!problem.cure.is_empty(), "{problem:?}");
        }
    }
}

#[test]
fn what_no_file_can_say_is_found_too() {
    let faults: [(&str, Change); 13] = [
        ("body.disc.sinkage", |c| c.bodies[0].position.z = f64::NAN),
        ("body.disc.adhesion_factor", |c| c.bodies[0].adhesion_factor = -1.0),
        ("body.disc.heave", |c| {
            c.bodies[0].translation[2] = Motion::Free { load: 0.0, support: f64::NAN, start: 0.0, ramp: 0.1 };
        }),
        ("body.disc", |c| c.bodies.push(c.bodies[0].clone())),
        ("body.a b", |c| c.bodies[0].name = "a b".into()),
        ("body", |c| c.bodies = vec![c.bodies[0].clone(); 501]),
        ("grid.cell", |c| c.grid.faces[0].reverse()),
        ("grid.cell", |c| c.grid.faces[1].clear()),
        ("grid.cell", |c| c.grid.faces[2].truncate(5)),
        ("domain.symmetric", |c| c.domain.plane_strain = true),
        ("body.disc.shape", |c| {
            (c.domain.symmetric, c.domain.plane_strain) = (false, true);
            c.bodies[0].shape = Shape::Sphere(Sphere { diameter: 0.2 });
        }),
        ("body.disc.axis", |c| {
            (c.domain.symmetric, c.domain.plane_strain) = (false, true);
            let axis = geometry::Axis::X;
            c.bodies[0].shape = Shape::Cylinder(Cylinder { diameter: 0.2, length: 0.2, axis });
        }),
        ("ground.surface", |c| {
            let (low, high) = (c.domain.low, c.domain.high);
            c.ground = Ground::Column { low: low.with_z(0.01), high: high.with_z(0.0), radius: None };
        }),
    ];
    for (path, fault) in faults {
        let mut case = parsed(TOWED_DISC, &[]).unwrap();
        fault(&mut case);
        let found = validate(&case);
        assert!(found.iter().any(|p| p.path == path), "{path}: {found:#?}");
        assert!(found.iter().all(|p| exists(&p.path)), "{found:#?}");
    }
}

#[test]
fn a_case_that_is_not_valid_cannot_be_run() {
    let mut case = parsed(TOWED_DISC, &[]).unwrap();
    case.grid.faces[0].clear();
    let error = Simulation::<f64>::checked(&case).unwrap_err();
    assert_eq!(error.problems[0].path, "grid.cell");
    let folder = tempfile::tempdir().unwrap();
    let (results, interrupts) = (folder.path().join("results"), Interrupts::default());
    let options = RunOptions::quiet(&results, Start::Anew, "", "case.toml", &interrupts);
    assert!(matches!(run(&case, &options), Err(RunError::Case(_))));
    assert!(!results.exists(), "nothing may be written");
}

#[test]
fn nested_maps_make_the_same_case_as_a_file() {
    for text in [TOWED_DISC, FOOTING, COLUMN, BAR] {
        let maps: serde_json::Value = toml::from_str(text).unwrap();
        assert_eq!(case::from_json(&maps, "case.toml").unwrap(), parsed(text, &[]).unwrap());
    }
}

#[test]
fn problems_of_nested_maps_have_paths_and_the_messages_of_a_file() {
    let maps: serde_json::Value = toml::from_str(TOWED_DISC).unwrap();
    let typed = ["soil.cohesion=2", "grid.growht=1.2", "body.disc.forward.ramp=-1 s", "domain.x=['0 m', 3]"];
    let expected = parsed(TOWED_DISC, &typed).unwrap_err();
    let mut broken = maps;
    broken["soil"]["cohesion"] = json!(2);
    broken["grid"]["growht"] = json!(1.2);
    broken["body"]["disc"]["forward"]["ramp"] = json!("-1 s");
    broken["domain"]["x"] = json!(["0 m", 3]);
    let found = case::from_json(&broken, "case").unwrap_err();
    let of = |error: &CaseError| {
        let mut all: Vec<_> =
            error.problems.iter().map(|p| (p.path.clone(), p.message.clone(), p.cure.clone())).collect();
        all.sort();
        all
    };
    assert_eq!(of(&found), of(&expected));
    let paths: Vec<String> = of(&found).into_iter().map(|(path, ..)| path).collect();
    assert_eq!(paths, ["body.disc.forward.ramp", "domain.x[1]", "grid.growht", "soil.cohesion"]);
    assert!(found.problems.iter().all(|p| p.line == 0) && expected.problems.iter().all(|p| p.line == 1));
}

#[test]
fn what_is_no_map_of_sections_is_refused() {
    let refused = |value| case::from_json(&value, "case").unwrap_err().to_string();
    assert!(refused(json!(null)).contains("not null"));
    assert!(refused(json!([1])).contains("not a list"));
    assert!(refused(json!({})).contains("the case is empty"));
    assert!(refused(json!({ "format": 2, "soil": null })).contains("problems"));
    assert!(refused(json!({ "format": 2.0 })).contains("problems"));
    assert!(refused(json!({ "format": 2, "numerics": { "courant": u64::MAX } })).contains("problems"));
}

/// Every number of a body.
fn numbers_of_body(body: &mut Body) -> Vec<&mut f64> {
    let mut all = Vec::from(components(&mut body.position));
    all.extend([&mut body.mass, &mut body.axle_inertia, &mut body.friction, &mut body.adhesion_factor]);
    all.extend(match &mut body.shape {
        Shape::Disc(disc) => {
            let rim = match &mut disc.rim {
                DiscRim::Square => vec![],
                DiscRim::Rounded { radius } => vec![radius],
                DiscRim::Bevelled { angle, edge, .. } => vec![angle, edge],
            };
            let dish = disc.dish.iter_mut().map(|dish| &mut dish.depth);
            [&mut disc.diameter, &mut disc.thickness].into_iter().chain(rim).chain(dish).collect()
        }
        Shape::Cylinder(cylinder) => vec![&mut cylinder.diameter, &mut cylinder.length],
        Shape::Sphere(sphere) => vec![&mut sphere.diameter],
        // The lengths of a mesh are in its file, a frame has none.
        Shape::MeshBody(_) | Shape::Frame(_) => vec![],
        Shape::Block(block) => components(&mut block.size).into_iter().collect(),
        Shape::Cone(cone) => vec![&mut cone.diameter, &mut cone.apex, &mut cone.shaft, &mut cone.length],
        Shape::Wheel(wheel) => {
            let grousers = &mut wheel.grousers;
            vec![&mut wheel.diameter, &mut wheel.thickness, &mut grousers.height, &mut grousers.thickness]
        }
        Shape::Blade(blade) => {
            let edge = blade.cutting_edge.iter_mut().flat_map(|edge| [&mut edge.angle, &mut edge.thickness]);
            components(&mut blade.size).into_iter().chain(edge).collect()
        }
        Shape::Wedge(wedge) => components(&mut wedge.size).into_iter().collect(),
    });
    all.extend([&mut body.attitude.yaw, &mut body.attitude.tilt, &mut body.attitude.pitch]);
    for motion in body.translation.iter_mut().chain(&mut body.rotation) {
        match motion {
            Motion::Fixed => {}
            Motion::Free { load, support, start, ramp } => all.extend([load, support, start, ramp]),
            Motion::Prescribed { before, speed, start, ramp, end } => {
                all.extend([before, speed, start, ramp, end]);
            }
            // Its numbers are checked where it is made.
            Motion::Course(_) => {}
        }
    }
    all
}

fn numbers_of_law(law: &mut Law) -> Vec<&mut f64> {
    match law {
        Law::Tresca(Tresca { shear_strength, gradient, softening }) => {
            let mut all = vec![shear_strength, gradient];
            if let Some(softening) = softening {
                all.extend([&mut softening.sensitivity, &mut softening.remoulding_strain]);
                all.extend([&mut softening.rate_strengthening, &mut softening.reference_rate]);
            }
            all
        }
        Law::VonMises(VonMises { yield_stress, hardening_modulus }) => vec![yield_stress, hardening_modulus],
        Law::Sand(Sand {
            critical_friction_angle,
            minimum_density,
            maximum_density,
            preconsolidation,
            stiffness_limit,
            characteristic_length,
            density_gradient,
            ..
        }) => {
            let mut all = vec![critical_friction_angle, minimum_density, maximum_density, stiffness_limit];
            all.extend([preconsolidation, density_gradient]);
            all.extend(characteristic_length);
            all
        }
        Law::MohrCoulomb(MohrCoulomb {
            friction_angle,
            dilation_angle,
            cohesion,
            tension_cutoff,
            potential,
            ..
        }) => {
            let mut all = vec![friction_angle, dilation_angle, cohesion, tension_cutoff];
            if let Potential::MenetreyWillam { meridional, deviatoric } = potential {
                all.extend([meridional, deviatoric]);
            }
            all
        }
        _ => Vec::new(),
    }
}

/// Every number of a case.
fn numbers(case: &mut Case) -> Vec<&mut f64> {
    let mut all = vec![&mut case.gravity, &mut case.overburden, &mut case.duration];
    let soil = &mut case.soil;
    all.extend([&mut soil.density, &mut soil.unit_weight, &mut soil.young_modulus]);
    all.extend([&mut soil.poisson_ratio, &mut soil.k0]);
    all.extend(numbers_of_law(&mut soil.law));
    match &mut case.ground {
        Ground::Level { surface } => all.push(surface),
        Ground::Column { low, high, radius } => {
            all.extend(components(low).into_iter().chain(components(high)).chain(radius));
        }
    }
    let (domain, grid) = (&mut case.domain, &mut case.grid);
    let corners = [
        &mut case.velocity,
        &mut domain.low,
        &mut domain.high,
        &mut grid.fine_low,
        &mut grid.fine_high,
        &mut grid.aspect,
    ];
    all.extend(corners.into_iter().flat_map(components));
    all.extend([&mut grid.cell, &mut grid.growth]);
    all.extend(grid.faces.iter_mut().filter_map(|faces| faces.last_mut()));
    let (output, numerics) = (&mut case.output, &mut case.numerics);
    all.extend([&mut output.history_interval, &mut output.field_interval]);
    all.extend([&mut output.checkpoint_interval, &mut output.steady_fraction, &mut output.filter_cutoff]);
    all.extend([&mut numerics.courant, &mut numerics.remap_displacement, &mut numerics.hourglass]);
    all.extend([&mut numerics.hourglass_yielding, &mut numerics.bulk_viscosity_linear]);
    all.extend([
        &mut numerics.bulk_viscosity_quadratic,
        &mut numerics.edge_inset,
        &mut numerics.point_spacing,
    ]);
    all.extend(case.bodies.iter_mut().flat_map(numbers_of_body));
    if let Some(furrows) = &mut case.relief.furrows {
        all.extend([&mut furrows.spacing, &mut furrows.depth, &mut furrows.direction, &mut furrows.offset]);
    }
    for body in &mut case.soil_bodies {
        all.extend(components(&mut body.position));
        all.extend([&mut body.attitude.yaw, &mut body.attitude.tilt, &mut body.attitude.pitch]);
        all.extend([&mut body.soil.density, &mut body.soil.unit_weight, &mut body.soil.young_modulus]);
        if let Shape::Sphere(sphere) = &mut body.shape {
            all.push(&mut sphere.diameter);
        }
    }
    if let Some(water) = &mut case.water {
        all.extend([
            &mut water.level,
            &mut water.density,
            &mut water.grain_density,
            &mut water.drag_coefficient,
        ]);
        all.extend(water.permeability.iter_mut().chain(&mut water.volume_strain));
    }
    all
}

fn components(vector: &mut DVec3) -> [&mut f64; 3] {
    let DVec3 { x, y, z } = vector;
    [x, y, z]
}

/// Another value for a number.
fn changed(value: f64, how: usize, factor: f64) -> f64 {
    match how {
        0 => f64::NAN,
        1 => f64::INFINITY,
        2 => f64::NEG_INFINITY,
        3 => 0.0,
        4 => -value,
        5 => 1e300,
        6 => 1e-300,
        7 => value * 1e6,
        8 => f64::MIN_POSITIVE,
        _ => value * factor,
    }
}

/// A ball of other soil in the ground.
const LENS: [&str; 8] = [
    "grid.aspect=[1, 1, 1]",
    "soil_body.lens.shape=sphere",
    "soil_body.lens.diameter=80 mm",
    "soil_body.lens.elevation=-90 mm",
    "soil_body.lens.law=tresca",
    "soil_body.lens.shear_strength=5 kPa",
    "soil_body.lens.density=1500 kg/m^3",
    "soil_body.lens.young_modulus=3 MPa",
];

fn perturbed() -> impl Strategy<Value = Case> {
    let change = (any::<prop::sample::Index>(), 0usize..14, 0.5f64..2.0);
    let coarse: [(&str, &str, &[&str]); 9] = [
        (TOWED_DISC, "grid.cell=25 mm", &[]),
        (FOOTING, "grid.cell=0.25 m", &[]),
        (COLUMN, "grid.cell=25 mm", &[]),
        (BAR, "grid.cell=0.4 mm", &[]),
        (UNDER_WATER, "grid.cell=12.5 mm", &[]),
        (FURROWED, "grid.cell=16 mm", &LENS),
        (TOWED_DISC, "grid.cell=25 mm", &["body.disc.rim=rounded"]),
        (TOWED_DISC, "grid.cell=25 mm", &["body.disc.rim=bevelled", "body.disc.bevel_angle=40 deg"]),
        (
            TOWED_DISC,
            "grid.cell=25 mm",
            &["body.disc.concavity=20 mm", "domain.symmetric=false", "domain.y=['-0.3 m', '0.3 m']"],
        ),
    ];
    let valid: Vec<Case> = coarse
        .iter()
        .map(|(text, cell, more)| parsed(text, &[&[*cell, "numerics.threads=1"], *more].concat()).unwrap())
        .collect();
    (prop::sample::select(valid), prop::collection::vec(change, 1..4)).prop_map(|(mut case, changes)| {
        for (which, how, factor) in changes {
            let mut all = numbers(&mut case);
            let n = which.index(all.len());
            *all[n] = changed(*all[n], how, factor);
        }
        case
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]
    #[test]
    fn no_numbers_cause_a_panic(case in perturbed()) {
        let found = validate(&case);
        prop_assert!(found.iter().all(|problem| exists(&problem.path)), "{found:?}");
        if found.is_empty() {
            let _ = case::advice(&case);
            let mut simulation = Simulation::<f64>::new(&case);
            // What happens then is physics: it may break down, but not panic.
            let _ = simulation.steps(2);
        }
    }
}
