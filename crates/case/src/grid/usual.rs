//! The cells of a case that does not say how large they are: as many across each body, over its sinkage and
//! over its contact as a run needs to end good.

use super::Cells;
use crate::body::Body;
use crate::clearance::{SoilConditions, chord, deepest};
use crate::context::Context;
use crate::path::{body_length, displacement};
use crate::soil::Soil;
use analytic::bearing::{Footing, Method};
use analytic::capacity::ultimate_pressure;
use glam::DVec3;
use input::quantity::plain;
use mechanics::Motion;

/// Cells over the length of a body, its width across the tow and its height.
const ACROSS: DVec3 = DVec3::new(8.0, 4.0, 4.0);
/// Cells over the contact of what rolls or is pressed; runs are graded good from five on, and the sinkage is
/// not known yet.
const OVER_CONTACT: f64 = 8.0;
/// Cells over the sinkage of a free body, which is graded good from four on, and of one that is held or
/// moved, whose vertical force is from eight on. Six for the former gave the shipped cases grids that took
/// up to ten times as long (chosen after a look at these).
const OVER_SINKAGE: [f64; 2] = [5.0, 8.0];
/// Cells over the longest body, beyond which they are not made smaller (the shipped cases have some 20 to
/// 40): a thin or light body would need a grid on which a run takes too long.
const AT_MOST: f64 = 40.0;
/// Largest ratio of the widths of the cells; the shipped disc has it.
const FLATTEST: f64 = 2.0;
/// Lengths to which a width is rounded down, over powers of ten.
const ROUND: [f64; 15] = [1.0, 1.2, 1.5, 1.8, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0, 6.0, 7.5, 9.0, 10.0];

/// The cells for these bodies, and a sentence that says so; `None` without a body that could touch the soil.
/// The shape is the one given, if there is one.
pub(crate) fn usual(
    bodies: &[Body],
    aspect: Option<DVec3>,
    soil: &Soil,
    context: &Context,
    duration: f64,
) -> Option<(Cells, String)> {
    let bodies: Vec<_> = bodies.iter().flat_map(Body::surfaces).filter(Body::has_surface).collect();
    let needed = bodies.iter().map(|body| widest(body, soil, context, duration)).reduce(DVec3::min)?;
    let thinnest = bodies.iter().map(size).reduce(DVec3::min)?;
    let limits = needed.max(DVec3::splat(body_length(&bodies) / AT_MOST)).min(thinnest);
    // In plane strain a single cell lies across the slab.
    let limits = if context.slab.is_some() { limits.with_y(limits.x.min(limits.z)) } else { limits };
    let aspect = aspect.unwrap_or_else(|| shape(limits));
    let cell = rounded_down((limits / aspect).min_element());
    let [x, y, z] = (cell * aspect * 1e3).to_array().map(plain);
    let why =
        format!("grid.cell is not given: cells of {x} × {y} × {z} mm, for the bodies and their sinkage");
    (cell.is_finite() && cell > 0.0).then_some((Cells { size: cell, aspect }, why))
}

/// Lengths of a body along x, y, z, of a dished disc its thickness across [m].
fn size(body: &Body) -> DVec3 {
    let size = body.size();
    size.with_y(size.y.min(body.thickness()))
}

/// The largest widths of the cells along x, y, z that resolve a body [m].
fn widest(body: &Body, soil: &Soil, context: &Context, duration: f64) -> DVec3 {
    let size = size(body);
    let across = size / ACROSS;
    let conditions = SoilConditions::before_the_box(context);
    let is_free = body.guided().translation[2].is_free();
    let is_towed = is_towed(body, duration);
    let bears = !body.is_connected() && context.slab.is_none();
    let depth = if is_free && bears { rest(body, is_towed, soil, context.gravity) } else { None };
    let depth = depth.unwrap_or_else(|| deepest(body, &conditions, duration)).min(size.z);
    if depth <= 0.0 {
        return across;
    }
    let over = OVER_SINKAGE[usize::from(!is_free)];
    match body.wheel_diameter() {
        Some(diameter) => {
            let chord = chord(diameter, depth) / OVER_CONTACT;
            across.min(DVec3::new(chord, f64::INFINITY, depth / over))
        }
        None if is_towed => across.with_z(across.z.min(depth / over)),
        None => across.min(DVec3::new(size.x / OVER_CONTACT, size.y / OVER_CONTACT, f64::INFINITY)),
    }
}

pub(crate) fn is_towed(body: &Body, duration: f64) -> bool {
    let moved = displacement(body, duration);
    moved.x != 0.0 || moved.y != 0.0 || body.guided().translation[..2].iter().any(Motion::is_free)
}

/// Sinkage [m] at which the soil bears a free body as a strip footing as wide as the narrower side of its
/// contact, that of one that is towed on the front half of it; `None` where that is not known.
///
/// That half was chosen after a look: with it the shipped disc comes out at 42 mm (its runs: 44), with the
/// whole contact at 20 mm.
pub(crate) fn rest(body: &Body, is_towed: bool, soil: &Soil, gravity: f64) -> Option<f64> {
    let force = body.pressing_force(body.whole_mass() * gravity).filter(|force| *force > 0.0)?;
    let angle = soil.law.friction_angle().unwrap_or(0.0);
    let soil = analytic::Soil {
        friction_angle: angle,
        dilation_angle: angle,
        cohesion: soil.law.cohesion().unwrap_or(0.0),
        unit_weight: soil.unit_weight,
        body_friction: body.friction,
        adhesion_factor: 1.0,
        strength_gradient: 0.0,
    };
    let size = body.size();
    let borne = |sinkage: f64| {
        let length = body.wheel_diameter().map_or(size.x, |diameter| chord(diameter, sinkage));
        let length = if is_towed { 0.5 * length } else { length };
        let width = length.min(size.y);
        let strip = Footing { width, length: f64::MAX, depth: 0.0, load_inclination: 0.0 };
        let pressure = ultimate_pressure(&soil, &strip, Method::Meyerhof).ok()?.at(sinkage);
        Some(pressure * length * size.y)
    };
    let (mut low, mut high) = (0.0, size.z);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if borne(middle)? < force { low = middle } else { high = middle }
    }
    Some(high)
}

/// The shape of cells that need not be wider than this along x, y, z [m]: cubes, or flat ones.
fn shape(limits: DVec3) -> DVec3 {
    let least = limits.min_element();
    let of = |limit: f64| {
        if limit < 1.5 * least {
            1.0
        } else if limit < FLATTEST * least {
            1.5
        } else {
            FLATTEST
        }
    };
    // Those that are tall would hold the contact of a level face badly.
    if limits.z > least { DVec3::ONE } else { DVec3::new(of(limits.x), of(limits.y), 1.0) }
}

/// A round length that is no longer [m].
fn rounded_down(length: f64) -> f64 {
    let power = 10.0_f64.powf(length.log10().floor());
    let round = ROUND.iter().rev().find(|round| **round <= length / power * (1.0 + 1e-9));
    // Divided, since a tenth cannot be written exactly: 6/1000 is the number that "6 mm" is.
    let round = round.copied().unwrap_or(1.0);
    if power < 1.0 { round / (1.0 / power).round() } else { round * power }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Case, advice, parse};

    #[test]
    fn the_documented_numbers_of_cells_are_these() {
        let documented = crate::keys::at("grid.cell").unwrap().meaning;
        let [free, held] = OVER_SINKAGE;
        for said in [
            format!("{} over a body's length, {} over its width and height", ACROSS.x, ACROSS.y),
            format!("{free} over the sinkage of a free body, {held} over that of one that is held"),
            format!("{OVER_CONTACT} over the contact"),
            format!("longest body over {AT_MOST}"),
        ] {
            assert!(documented.contains(&said), "{said}");
        }
        assert_eq!(ACROSS.y, ACROSS.z);
    }

    #[test]
    fn lengths_are_rounded_down() {
        for (length, round) in
            [(0.0064, 0.006), (0.0125, 0.012), (0.006, 0.006), (0.00999, 0.009), (1.3, 1.2)]
        {
            assert_eq!(rounded_down(length), round, "{length}");
        }
    }

    fn case(cells: &str, body: &str) -> Case {
        let text = format!(
            "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '32 deg'\nunit_weight = '16 kN/m^3'\n\
             young_modulus = '5 MPa'\n[domain]\nsymmetric = true\n{cells}\n{body}\n[run]\nduration = '1 s'\n"
        );
        parse(&text, "case.toml", &[]).unwrap_or_else(|error| panic!("{error}"))
    }

    const DISC: &str = "[body.disc]\nshape = 'disc'\ndiameter = '0.2 m'\nthickness = '50 mm'\nfriction = 0.3\n\
                        weight = '100 N'\nsinkage = '0 mm'\nheave = 'free'\nspin = 'free'\n\
                        forward = { speed = '0.2 m/s' }";
    const PLATE: &str = "[body.plate]\nshape = 'block'\nsize = ['0.2 m', '0.1 m', '0.1 m']\nfriction = 0.3\n\
                         sinkage = '40 mm'\nforward = { speed = '0.2 m/s' }";

    #[test]
    fn a_body_and_its_sinkage_determine_the_cells_that_are_not_given() {
        let disc = case("", DISC);
        // The disc of the README sinks 44 mm, as a footing on the front half of its contact 42 mm: 5 cells
        // over that, 4 across its width.
        assert_eq!((disc.grid.cell, disc.grid.aspect), (0.0075, DVec3::new(2.0, 1.0, 1.0)));
        assert!(disc.remarks[0].contains("15 × 7.5 × 7.5 mm"), "{:?}", disc.remarks);
        let plate = case("", PLATE);
        assert_eq!((plate.grid.cell, plate.grid.aspect), (0.005, DVec3::new(2.0, 2.0, 1.0)));
        for case in [disc, plate] {
            let notes = advice(&case).join("\n");
            assert!(!notes.contains("cells across") && !notes.contains("cells over"), "{notes}");
        }
    }

    #[test]
    fn cells_are_no_smaller_than_a_fortieth_of_a_body_but_no_wider_than_it_is_thin() {
        let light = case("", &DISC.replace("100 N", "5 N"));
        assert_eq!(light.grid.cell, 0.005);
        let thin = case("", &PLATE.replace("'0.1 m', '0.1 m'", "'4 mm', '0.1 m'").replace("40 mm", "90 mm"));
        assert_eq!((thin.grid.cell, thin.grid.aspect), (0.004, DVec3::ONE));
    }

    #[test]
    fn what_is_given_of_them_holds() {
        let cubes = case("[grid]\naspect = [1, 1, 1]", DISC);
        assert_eq!((cubes.grid.cell, cubes.grid.aspect), (0.0075, DVec3::ONE));
        let given = case("[grid]\ncell = '10 mm'", DISC);
        assert_eq!((given.grid.cell, given.remarks.len()), (0.01, 0));
    }
}
