//! Shapes of bodies: how they are read, described and placed, what is refused, and that solver and forecast
//! take them.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::model::model;
use coulter::case::{self, Case, CaseError};
use coulter::forecast::outlook;
use coulter::simulation::Simulation;
use glam::DVec3;

/// A small box of sand on coarse cells, with a body that is towed and sinks.
const BOX: &str = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
     [domain]\nx = ['-0.24 m', '0.24 m']\ny = ['-0.24 m', '0.24 m']\nz = ['-0.16 m', '0.24 m']\n[grid]\ncell = '20 mm'\ngrowth = 1\n\
     fine_x = ['-0.24 m', '0.24 m']\nfine_y = ['-0.24 m', '0.24 m']\nfine_z = ['-0.16 m', '0.24 m']\n[body.tool]\nfriction = 0.3\n\
     sinkage = '15 mm'\nheave = { speed = '-0.1 m/s', ramp = '2 ms' }\nforward = { speed = '0.3 m/s', ramp = '2 ms' }\n\
     [run]\nduration = '0.1 s'\n[output]\nhistory_interval = '1 ms'\n[numerics]\nthreads = 1\n";

/// A shape, its keys, and its description.
type Example = (&'static str, &'static [&'static str], &'static str);

const DISC: &[&str] = &["shape=disc", "diameter=0.2 m", "thickness=60 mm"];
const CONE: &[&str] = &["shape=cone", "diameter=80 mm", "cone_angle=60 deg", "length=0.2 m"];
const WHEEL: &[&str] = &[
    "shape=wheel",
    "diameter=0.2 m",
    "thickness=80 mm",
    "grousers=7",
    "grouser_height=40 mm",
    "grouser_thickness=40 mm",
];
const BLADE: &[&str] = &["shape=blade", "width=0.2 m", "height=0.15 m", "thickness=40 mm"];
const WEDGE: &[&str] = &["shape=wedge", "length=0.2 m", "width=0.2 m", "height=0.1 m"];

const EXAMPLES: &[(&[&str], Example)] = &[
    (DISC, ("disc", &[], "disc, d = 200 mm, t = 60 mm")),
    (DISC, ("disc", &["rim=rounded"], "disc, d = 200 mm, t = 60 mm, rim rounded to r = 30 mm")),
    (
        DISC,
        (
            "disc",
            &["rim=bevelled", "bevel_angle=35 deg", "edge_thickness=5 mm"],
            "disc, d = 200 mm, t = 60 mm, rim on both sides bevelled at 35° to an edge of 5 mm",
        ),
    ),
    (
        DISC,
        (
            "disc",
            &["rim=bevelled", "bevel_angle=45 deg", "bevel=right", "concavity=30 mm"],
            "disc, d = 200 mm, t = 60 mm, rim on the right bevelled at 45° to a knife edge, hollow by 30 mm on the left",
        ),
    ),
    (CONE, ("cone", &[], "cone of 60°, d = 80 mm, l = 200 mm")),
    (CONE, ("cone", &["shaft_diameter=60 mm"], "cone of 60°, d = 80 mm, shaft of d = 60 mm, l = 200 mm")),
    (WHEEL, ("wheel", &[], "wheel, d = 200 mm, t = 80 mm, 7 grousers of 40 mm × 40 mm")),
    (BLADE, ("blade", &[], "blade, 200 mm wide, 150 mm high, 40 mm thick")),
    (
        BLADE,
        (
            "blade",
            &["bevel_angle=30 deg", "pitch=-20 deg"],
            "blade, 200 mm wide, 150 mm high, 40 mm thick, at the back bevelled at 30° to a knife edge",
        ),
    ),
    (WEDGE, ("wedge", &[], "wedge, 200 mm long, 200 mm wide, 100 mm high")),
];

fn parse(keys: &[&[&str]], more: &[&str]) -> Result<Case, CaseError> {
    let of_body = keys.concat().into_iter().map(|set| format!("body.tool.{set}"));
    let sets: Vec<String> = of_body.chain(more.iter().map(|set| (*set).to_owned())).collect();
    case::parse(BOX, "tool.toml", &sets)
}

#[test]
fn every_shape_is_read_and_described_and_stands_at_its_sinkage() {
    for (keys, (kind, more, text)) in EXAMPLES {
        let case = parse(&[keys, more], &[]).unwrap();
        let body = &case.bodies[0];
        assert_eq!(body.shape.kind(), *kind);
        assert_eq!(body.shape.describe(&|length| format!("{:.0} mm", 1e3 * length)), *text);
        let lowest = body.position.z + body.bounds().0.z;
        assert!((lowest + 0.015).abs() < 1e-12, "{text}: {lowest}");
        let solid = body.solid();
        assert!(solid.signed_distance(solid.mass_properties().centroid) < 0.0, "{text}");
    }
}

#[test]
fn every_shape_moves_through_soil() {
    for (keys, (_, more, text)) in EXAMPLES {
        let case = parse(&[keys, more], &[]).unwrap();
        let mut simulation = Simulation::<f64>::new(&case);
        for _ in 0..8 {
            simulation.advance().unwrap();
        }
        let last = *simulation.history.bodies[0].last().unwrap();
        let force = last.drag.hypot(last.vertical);
        assert!(force > 1.0 && force < 5e3, "{text}: {last:?}");
        // Only what is not its own mirror image is pushed sideways.
        if case.bodies[0].shape.is_mirrored(1) {
            assert!(last.lateral.abs() < 1e-9 * force, "{text}: {last:?}");
        } else {
            assert!(last.lateral.abs() > 1e-3 * force, "{text}: {last:?}");
        }
    }
}

#[test]
fn every_shape_has_a_forecast() {
    for (keys, (kind, more, text)) in EXAMPLES {
        let case = parse(&[keys, more], &["body.tool.heave=fixed", "body.tool.sinkage=40 mm"]).unwrap();
        let outlook = outlook(&case).unwrap();
        let best = outlook.best().unwrap_or_else(|| panic!("{text}: no model"));
        let found = best.prediction.unwrap();
        assert!(found.drag > 1.0 && found.drag < 500.0, "{text}: {} {found:?}", best.name);
        let notes = outlook.input.remarks.join("\n");
        assert_eq!(notes.contains("rounded rim"), text.contains("rounded"), "{text}: {notes}");
        // What is no plain disc or block has resistive force theory only.
        let has_more = *more == ["rim=rounded"] || (more.is_empty() && (*kind == "disc" || *kind == "blade"));
        let applicable = outlook.forecast.models.iter().filter(|m| m.applicable).count();
        assert_eq!(applicable > 1, has_more, "{text}: {applicable} models");
    }
}

/// The reference point of a wedge that is tipped back lies nearly as high as its top, not at half its height.
#[test]
fn a_forecast_counts_the_sinkage_from_the_lowest_point() {
    let drag = |sinkage: &str| {
        let more = ["body.tool.heave=fixed", "body.tool.pitch=-30 deg", sinkage];
        let case = parse(&[WEDGE], &more).unwrap();
        outlook(&case).unwrap().best().unwrap().prediction.unwrap().drag
    };
    let ratio = drag("body.tool.sinkage=6 mm") / drag("body.tool.sinkage=60 mm");
    // The traction grows with the depth, the surface too: 1 %, but for the width of the facets and the corner
    // at the front.
    assert!((0.005..0.03).contains(&ratio), "{ratio}");
}

/// Keys, more keys, the key that is reported, and part of its message.
type Refusal = (&'static [&'static str], &'static [&'static str], &'static str, &'static str);

const REFUSALS: &[Refusal] = &[
    (DISC, &["rim=blunt"], "rim", "blunt"),
    (DISC, &["rim_radius=10 mm"], "rim_radius", "does not apply to rim = \"square\""),
    (DISC, &["rim=rounded", "rim_radius=31 mm"], "rim_radius", "larger than half the thickness"),
    (DISC, &["rim=rounded", "rim_radius=0 mm"], "rim_radius", "out of range"),
    (DISC, &["rim=rounded", "concavity=20 mm"], "rim", "no rounded rim"),
    (DISC, &["rim=bevelled"], "bevel_angle", "is missing"),
    (DISC, &["rim=bevelled", "bevel_angle=90 deg"], "bevel_angle", "out of range"),
    (DISC, &["rim=bevelled", "bevel_angle=5 deg"], "bevel_angle", "wider than the disc"),
    (
        DISC,
        &["rim=bevelled", "bevel_angle=45 deg", "edge_thickness=60 mm"],
        "edge_thickness",
        "as thick as the disc",
    ),
    (DISC, &["rim=bevelled", "bevel_angle=45 deg", "edge_thickness=-1 mm"], "edge_thickness", "out of range"),
    (DISC, &["rim=bevelled", "bevel_angle=45 deg", "bevel=front"], "bevel", "does not apply"),
    (DISC, &["hollow=right"], "hollow", "dished disc only"),
    (DISC, &["concavity=0.1 m"], "concavity", "hemisphere"),
    (DISC, &["grousers=8"], "grousers", "does not apply to shape"),
    (CONE, &["cone_angle=180 deg"], "cone_angle", "out of range"),
    (CONE, &["cone_angle=20 deg"], "length", "as long as cone and shaft"),
    (CONE, &["shaft_diameter=90 mm"], "shaft_diameter", "wider than the base"),
    (CONE, &["spin={ speed = '1 rad/s' , slip = 0.1 }"], "spin", "slip"),
    (WHEEL, &["grousers=0"], "grousers", "out of range"),
    (WHEEL, &["grousers=2.5"], "grousers", "whole number"),
    (WHEEL, &["grousers=16"], "grouser_thickness", "do not fit"),
    (WHEEL, &["grouser_thickness=5 mm"], "grouser_thickness", "cells across"),
    (BLADE, &["bevel=back"], "bevel", "blade with a bevel only"),
    (BLADE, &["bevel_angle=10 deg"], "bevel_angle", "as high as the blade"),
    (BLADE, &["bevel_angle=30 deg", "bevel=left"], "bevel", "does not apply"),
    (BLADE, &["bevel_angle=30 deg", "edge_thickness=40 mm"], "edge_thickness", "as thick as the blade"),
    (WEDGE, &["height=0 m"], "height", "out of range"),
    (WEDGE, &["thickness=60 mm"], "thickness", "does not apply to shape"),
];

#[test]
fn what_makes_no_shape_is_refused_at_its_key() {
    for (keys, more, key, message) in REFUSALS {
        let error = parse(&[keys, more], &[]).unwrap_err();
        let path = format!("body.tool.{key}");
        let found = error
            .problems
            .iter()
            .any(|p| p.path.starts_with(&path) && p.message.contains(message) && !p.cure.is_empty());
        assert!(found, "{more:?}: {error:#?}");
    }
}

#[test]
fn a_plane_of_symmetry_needs_a_mirror_image() {
    let half: [(&str, &[&str]); 2] = [
        ("y", &["domain.symmetric=true", "domain.y=['0 m', '0.24 m']", "grid.fine_y=['0 m', '0.24 m']"]),
        (
            "x",
            &[
                "domain.symmetric_x=true",
                "domain.x=['0 m', '0.24 m']",
                "grid.fine_x=['0 m', '0.24 m']",
                "body.tool.forward=fixed",
            ],
        ),
    ];
    for (keys, (_, more, text)) in
        EXAMPLES.iter().filter(|(_, (_, more, _))| !more.contains(&"pitch=-20 deg"))
    {
        for (axis, (plane, set)) in half.iter().enumerate() {
            let result = parse(&[keys, more], set);
            let is_mirrored = if axis == 0 { !text.contains("hollow") } else { !text.contains("wedge") };
            assert_eq!(result.is_ok(), is_mirrored, "{text}, {plane}: {result:?}");
            if let Err(error) = result {
                assert!(
                    error.problems.iter().any(|p| p.message.contains("mirror image")),
                    "{text}: {error:#?}"
                );
            }
        }
    }
}

#[test]
fn a_slice_in_plane_strain_is_as_wide_as_the_slab() {
    let slab = ["domain.plane_strain=true", "domain.y=['0 m', '20 mm']", "grid.fine_y=['0 m', '20 mm']"];
    for keys in [&WHEEL[..2], &WHEEL[..0]] {
        assert!(parse(&[keys], &slab).is_err());
    }
    let without = |keys: &[&'static str], width: &str| -> Vec<&'static str> {
        keys.iter().copied().filter(|set| !set.starts_with(width)).collect()
    };
    for (keys, width) in [(DISC, "thickness"), (WHEEL, "thickness"), (BLADE, "width"), (WEDGE, "width")] {
        let case = parse(&[&without(keys, width)], &slab).unwrap();
        let size = case.bodies[0].size();
        assert!(size.y >= 0.02, "{keys:?}: {size}");
        assert!(parse(&[keys], &slab).is_err(), "{keys:?}");
    }
    let refused = |keys: &[&[&str]], key: &str| {
        let error = parse(keys, &slab).unwrap_err();
        assert!(error.problems.iter().any(|p| p.path == format!("body.tool.{key}")), "{error:#?}");
    };
    refused(&[CONE], "shape");
    refused(&[&without(DISC, "thickness"), &["concavity=30 mm"]], "concavity");
    refused(&[&without(DISC, "thickness"), &["rim=bevelled", "bevel_angle=45 deg"]], "rim");
}

#[test]
fn a_wheel_rolls_on_its_rim() {
    let case = parse(&[WHEEL], &["body.tool.spin={ slip = 0 }"]).unwrap();
    assert_eq!(case.bodies[0].rolling_diameter(), Some(0.2));
    match case.bodies[0].spin() {
        mechanics::Motion::Prescribed { speed, .. } => assert!((speed - 3.0).abs() < 1e-12, "{speed}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_thin_rim_keeps_most_of_its_contact_points() {
    let rim = |thickness: &str, set: &[&str]| {
        let keys = ["shape=disc", "diameter=0.2 m", thickness];
        let case = parse(&[&keys], set).unwrap();
        let body = &model(&case, 1).bodies[0];
        let cell = case.grid.cell;
        let points = body.shape.surface_points(DVec3::splat(0.25 * cell), body.edge_inset * cell);
        let area: f64 = points.iter().filter(|p| p.normal.y == 0.0).map(|p| p.area).sum();
        (body.edge_inset.y, area / (std::f64::consts::PI * 0.2 * case.grid.cell))
    };
    let close = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).abs() < 1e-9 && (a.1 - b.1).abs() < 1e-9;
    // Cells of 20 mm.
    assert!(close(rim("thickness=20 mm", &[]), (0.1, 0.8)));
    assert!(close(rim("thickness=40 mm", &[]), (0.2, 1.6)));
    assert!(close(rim("thickness=60 mm", &["numerics.edge_inset=1.2"]), (1.2, 0.6)));
    let refused = parse(&[&["shape=disc", "diameter=0.2 m", "thickness=19 mm"]], &[]).unwrap_err();
    assert!(refused.problems.iter().any(|p| p.message.contains("0.95 cells across")), "{refused:#?}");
}
