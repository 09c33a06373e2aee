//! The fine zone and the faces of the cells.

use super::check::{aspect, fine_zone};
use super::fitting::fit;
use super::grading::{self, AxisGrading};
use super::keys::KEYS;
use super::{Follow, Grid};
use crate::body::Body;
use crate::clearance::{SoilConditions, clearance};
use crate::context::Context;
use crate::domain::Domain;
use crate::ground::Ground;
use crate::key::{checked, range};
use crate::path::{Extent, Paths, body_length};
use glam::DVec3;
use input::problem::Problems;
use input::typed::Section;

/// Fine zone round the path of the bodies, above it excepted [body lengths].
const FINE_AROUND: DVec3 = DVec3::new(0.5, 0.25, 0.5);
/// Least height of the fine zone above the soil, and its height limit where a heap is expected [body
/// lengths]; chosen: the foot of the heap matters, its top carries little.
const FINE_ABOVE: [f64; 2] = [0.25, 0.5];

/// Size and shape of the cells as far as they are given, each `None` where it is not; `None` where one of
/// them was given wrongly.
pub(crate) fn cells(section: &Section, problems: &mut Problems) -> Option<(Option<f64>, Option<DVec3>)> {
    let cell = if section.has("cell") { Some(section.number("cell")?) } else { None };
    if !section.has("aspect") {
        return Some((cell, None));
    }
    let widths = section.list("aspect").filter(|widths| widths.len() == 3)?;
    let widths = DVec3::from_slice(&widths);
    Some((cell, Some(checked(widths, problems, |widths, problems| aspect(*widths, problems))?)))
}

/// The default fine zone: round the path of the bodies, or everywhere without any.
fn default_fine_zone(context: &Context, domain: &Domain, paths: &Paths) -> Extent {
    let Some(path) = paths.all() else {
        return Extent { low: domain.low, high: domain.high };
    };
    let length = body_length(paths.bodies);
    let low = path.low - length * FINE_AROUND;
    let high = path.high + length * FINE_AROUND.with_z(0.0);
    let heap = |body: &Body| clearance(body, &SoilConditions::before_the_box(context), paths.duration).above;
    let heap = paths.bodies.iter().map(heap).fold(0.0, f64::max);
    let [min, max] = FINE_ABOVE.map(|lengths| lengths * length);
    let high = high.with_z(context.between[1] + heap.clamp(min, max));
    Extent { low: low.max(domain.low), high: high.min(domain.high) }
}

/// What the grid is said to follow, if anything; the outer `None` where that was given wrongly.
#[allow(clippy::option_option)]
pub(crate) fn follow(section: &Section, bodies: &[Body], problems: &mut Problems) -> Option<Option<Follow>> {
    if !section.has("follow") {
        return Some(None);
    }
    let [name, axes] = section.follow("follow")?;
    let Some(body) = bodies.iter().position(|body| body.name == name) else {
        let path = section.at("follow.body");
        let known = bodies.iter().map(|body| format!("\"{}\"", body.name)).collect::<Vec<_>>().join(", ");
        problems.add(
            path,
            format!("there is no body \"{name}\""),
            format!("name one of the bodies: {known}"),
        );
        return None;
    };
    Some(Some(Follow { body, axes: ["x", "y", "z"].map(|axis| axes.contains(axis)) }))
}

/// The grid.
pub(crate) fn grid(
    section: &Section,
    context: &Context,
    domain: &Domain,
    ground: &Ground,
    paths: &Paths,
    problems: &mut Problems,
) -> Option<Grid> {
    let usual = default_fine_zone(context, domain, paths);
    let growth = section.number("growth")?;
    let anchors = anchors(ground, domain);
    let fits = section.flag("fit")?;
    let axis = |axis: usize| {
        let ends = [domain.low[axis], domain.high[axis]];
        let fine = [usual.low[axis], usual.high[axis]];
        let cell = context.fine_cell()[axis];
        let plain = AxisGrading { ends, fine, anchor: anchors[axis], cell, growth };
        let fixed = required_face(ground, domain, axis);
        let fitted = fit(paths.bodies, domain, axis, &plain, fixed).filter(|_| fits);
        [fitted.map_or(plain, |[cell, anchor]| AxisGrading { anchor, cell, ..plain }), plain]
    };
    let x = faces(section, "fine_x", axis(0), problems);
    // In plane strain the slab is one cell.
    let y = match context.slab {
        Some(_) => Some((vec![domain.low.y, domain.high.y], [domain.low.y, domain.high.y])),
        None => faces(section, "fine_y", axis(1), problems),
    };
    let z = faces(section, "fine_z", axis(2), problems);
    let ((x, fine_x), (y, fine_y), (z, fine_z)) = (x?, y?, z?);
    Some(Grid {
        cell: context.cell,
        aspect: context.aspect,
        fine_low: DVec3::new(fine_x[0], fine_y[0], fine_z[0]),
        fine_high: DVec3::new(fine_x[1], fine_y[1], fine_z[1]),
        growth,
        follow: paths.follow,
        faces: [x, y, z],
    })
}

/// The faces along one axis, and the ends of the fine zone among them [m].
fn faces(
    section: &Section,
    key: &str,
    [mut axis, unfitted]: [AxisGrading; 2],
    problems: &mut Problems,
) -> Option<(Vec<f64>, [f64; 2])> {
    axis.fine = range(KEYS, section, key, Some(axis.fine), problems)?;
    let unfitted = AxisGrading { fine: axis.fine, ..unfitted };
    if !fine_zone(key, axis.fine, axis.ends, problems) {
        return None;
    }
    // Where fitted cells cannot fill the box, unchanged ones may.
    grading::faces(&axis)
        .or_else(|_| grading::faces(&unfitted))
        .map_err(|message| {
            let cure =
                "change grid.cell, grid.aspect, grid.growth or the box; a whole number of cells always fits";
            problems.add(section.at("cell"), format!("{key}: {message}"), cure);
        })
        .ok()
}

/// Required position of a face along an axis [m], if there is one.
fn required_face(ground: &Ground, domain: &Domain, axis: usize) -> Option<f64> {
    let anchor = anchors(ground, domain)[axis];
    let is_level = matches!(ground, Ground::Level { .. });
    (axis == 2 || axis == 1 && domain.symmetric || !is_level && anchor != 0.0).then_some(anchor)
}

/// Preferred positions of faces [m]: at the soil's surface, at y = 0, and at the side of a bank.
fn anchors(ground: &Ground, domain: &Domain) -> [f64; 3] {
    match *ground {
        Ground::Level { surface } => [0.0, 0.0, surface],
        Ground::Column { low, high, .. } => {
            let side = |axis: usize| {
                if low[axis] > domain.low[axis] {
                    low[axis]
                } else if high[axis] < domain.high[axis] {
                    high[axis]
                } else {
                    0.0
                }
            };
            [side(0), side(1), high.z]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::estimate::estimate;
    use crate::model::model;
    use crate::{Case, keys, parse};
    use input::CaseError;

    fn flat(aspect: &str, more: &[&str]) -> Result<Case, CaseError> {
        let text = format!(
            "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
             [domain]\nsymmetric = true\n[grid]\ncell = '5 mm'\naspect = {aspect}\n[body.disc]\nshape = 'disc'\ndiameter = '0.2 m'\n\
             thickness = '50 mm'\nfriction = 0.3\nsinkage = '20 mm'\nforward = {{ speed = '0.2 m/s' }}\n[run]\ntow_distance = '0.1 m'\n"
        );
        let more: Vec<String> = more.iter().map(|key| (*key).to_owned()).collect();
        parse(&text, "case.toml", &more)
    }

    #[test]
    fn flat_cells_have_their_widths_along_each_axis() {
        let narrowest = |case: &Case| {
            case.grid
                .faces
                .each_ref()
                .map(|f| f.windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min))
        };
        let close = |widths: [f64; 3], expected: [f64; 3]| {
            assert!(
                widths.iter().zip(expected).all(|(w, e)| (w - e).abs() < 1e-9),
                "{widths:?}, not {expected:?}"
            );
        };
        let case = flat("[3, 2, 1]", &[]).unwrap();
        // Along y fitted to the disc's half thickness of 25 mm.
        close(narrowest(&case), [0.015, 0.025 / 3.0, 0.005]);
        assert!(case.grid.faces[2].iter().any(|z| z.abs() < 1e-12), "a face at the surface");
        let (estimated, taken) = (estimate(&case).time_step_s, model(&case, 8).time_step());
        assert!((estimated / taken - 1.0).abs() < 1e-12, "{estimated} s, {taken} s");
    }

    #[test]
    fn other_shapes_of_cells_are_refused_with_a_cure() {
        for (aspect, said) in [
            ("[2, 2, 2]", "divide them by 2, and multiply grid.cell by it"),
            ("[0.5, 1, 1]", "grid.aspect[0]"),
            ("[5, 5, 1]", "from 1 to 4"),
            ("[3, 1]", "expected 3 numbers, found 2"),
            ("['3', 1, 1]", "expected a number, found text"),
            ("3", "expected a list of 3 numbers"),
        ] {
            let error = format!("{:?}", flat(aspect, &[]).unwrap_err());
            assert!(error.contains(said), "{aspect}: {error}");
        }
    }

    #[test]
    fn the_documented_fine_zone_is_the_derived_one() {
        let documented = |path| keys::at(path).unwrap().default.text();
        for (path, lengths) in [("grid.fine_x", FINE_AROUND.x), ("grid.fine_y", FINE_AROUND.y)] {
            assert!(documented(path).contains(&format!("± {lengths} body lengths")), "{path}");
        }
        let (z, [least, most]) = (documented("grid.fine_z"), FINE_ABOVE);
        let expected = format!("{} body lengths below the bodies' path; {least} above", FINE_AROUND.z);
        assert!(z.contains(&expected) && z.contains(&format!("up to {most}")), "{z}");
    }
}
