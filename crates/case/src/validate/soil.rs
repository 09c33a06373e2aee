//! The soils of a case: whether they rest under their own weight, and fit each other and the box.

use crate::ground::sustained;
use crate::own_weight::compression;
use crate::resolved::{Case, Domain, Ground, Law, Soil, Wall};
use crate::slope::Slope;
use crate::soil::at_rest;
use input::problem::Problems;
use input::quantity::plain;

/// Reports a slope on which the soil does not rest, or that its boundaries contradict.
pub(super) fn slope(case: &Case, problems: &mut Problems) {
    let slope = case.slope;
    if slope.is_level() {
        return;
    }
    let Domain { symmetric, symmetric_x, plane_strain, walls, .. } = case.domain;
    let planes = [(SLOPE, symmetric_x), (CROSS_SLOPE, symmetric || plane_strain)];
    let opened = |axis: usize| case.grid.follow.is_some_and(|follow| follow.axes[axis]);
    for (axis, ((key, is_plane), angle)) in planes.into_iter().zip(slope.angles()).enumerate() {
        if angle == 0.0 {
            continue;
        }
        if is_plane {
            let message = "gravity acts across a plane of symmetry or of plane strain";
            problems.add(key, message, "model the whole width, or remove the slope");
        } else if walls[axis].contains(&Wall::Smooth) && !opened(axis) {
            let path = ["domain.x_walls", "domain.y_walls"][axis];
            let message = "a smooth wall across a slope cannot bear the shear stress of the soil beside it";
            problems.add(path, message, "remove it: walls across a slope are fixed");
        }
    }
    if case.soil.unit_weight == 0.0 || !matches!(case.ground, Ground::Level { .. }) {
        return;
    }
    for (n, (path, soil)) in case.layered_soils().enumerate() {
        let rests = |(law, stress): (Law, f64)| {
            at_rest::sustains(&law, slope.principal_stresses(soil.k0).map(|ratio| ratio * stress))
        };
        if !ends(case, n).into_iter().all(rests) {
            let angle = steepest(&slope);
            let message = format!(
                "the soil of [{path}] does not rest on a slope of {angle:.1}°: it would slide at once"
            );
            let cure = "make the slope gentler than the friction angle, or, with cohesion or undrained strength, the soil less deep";
            problems.add(if slope.along == 0.0 { CROSS_SLOPE } else { SLOPE }, message, cure);
        }
    }
}

/// Reports clay on level ground whose strength grows with depth, but more slowly than the stresses at rest.
pub(super) fn growing_strength(case: &Case, problems: &mut Problems) {
    if !case.slope.is_level() || case.soil.unit_weight == 0.0 {
        return;
    }
    for (n, (path, soil)) in case.layered_soils().enumerate() {
        let rests = |(law, stress): (Law, f64)| {
            at_rest::sustains(&law, [1.0, soil.k0, soil.k0].map(|ratio| ratio * stress))
        };
        if matches!(soil.law, Law::Tresca(clay) if clay.gradient > 0.0)
            && !ends(case, n).into_iter().all(rests)
        {
            let message = format!(
                "the soil of [{path}] does not bear its own weight with K₀ = {:.3}: it would fail at once",
                soil.k0
            );
            problems.add(format!("{path}.strength_gradient"), message, format!("add  k0 = 1  to [{path}]"));
        }
    }
}

/// Laws at top and base of a soil, by its number from the top down, each with the stress normal to the
/// surface there [Pa].
fn ends(case: &Case, number: usize) -> [(Law, f64); 2] {
    let law = case.layered_soils().nth(number).map_or(case.soil.law, |(_, soil)| soil.law);
    let above = number.checked_sub(1).map_or(case.overburden, |above| stress_at_base(case, above));
    let depth = case.ground.surface() - case.domain.low.z;
    let tops: Vec<f64> = case.layers.iter().map(|layer| layer.top.min(depth)).chain([depth]).collect();
    let top = number.checked_sub(1).map_or(0.0, |above| tops[above]);
    [(law, above), (law.at_depth(tops[number] - top), stress_at_base(case, number))]
}

/// Stress normal to the surface at the base of a soil [Pa], by its number from the top down.
fn stress_at_base(case: &Case, number: usize) -> f64 {
    let depth = case.ground.surface() - case.domain.low.z;
    let tops = || case.layers.iter().map(|layer| layer.top.min(depth));
    let bases = tops().chain([depth]);
    let thicknesses = std::iter::once(0.0).chain(tops()).zip(bases).map(|(top, base)| base - top);
    let cosine = case.slope.cosine();
    let weight = |soil: &Soil, thickness: f64| {
        let mean = if soil.density_gradient() > 0.0 {
            soil.at_depth(0.5 * thickness).unit_weight
        } else {
            soil.unit_weight
        };
        mean * cosine * thickness
    };
    let each = case.layered_soils().zip(thicknesses).take(number + 1);
    case.overburden + each.map(|((_, soil), thickness)| weight(soil, thickness)).sum::<f64>()
}

/// Largest difference between the weights over the masses of the soils, over either: one gravity acts on all
/// of them.
const SAME_GRAVITY: f64 = 1e-6;

/// Reports layers that lie in the wrong place, or that cannot lie in one case.
pub(super) fn layers(case: &Case, problems: &mut Problems) {
    if !case.layers.is_empty() && !matches!(case.ground, Ground::Level { .. }) {
        let message = "layers of a column or a bank are not modelled";
        problems.add(
            case.layers[0].path(),
            message,
            "remove ground.x, ground.y and ground.radius, or the layers",
        );
    }
    let depth = case.ground.surface() - case.domain.low.z;
    let of = |soil: &Soil| soil.unit_weight / soil.density;
    for (n, layer) in case.layers.iter().enumerate() {
        sustained(&layer.path(), &layer.soil, case.overburden, problems);
        let top = format!("{}.top", layer.path());
        if layer.top >= depth {
            let message =
                format!("the layer begins below the floor of the box, {} m under the surface", plain(depth));
            problems.add(&*top, message, "deepen domain.z, or remove the layer");
        }
        let above = case.layers[..n].last().map_or(0.0, |above| above.top);
        if layer.top <= above {
            let message = "two layers begin at this depth, or they are not in the order of their depth";
            problems.add(&*top, message, "give every layer a depth of its own");
        }
    }
    for (path, soil) in case.soils().skip(1) {
        if (of(soil) - of(&case.soil)).abs() > SAME_GRAVITY * of(&case.soil).max(of(soil)) {
            let message =
                "unit_weight over density of this soil is not that of [soil]: one gravity acts on all soil";
            problems.add(
                format!("{path}.unit_weight"),
                message,
                "give one of the two and let the other follow",
            );
        }
    }
    let averaged = |(_, soil): &(String, &Soil)| {
        soil.law.sand().is_some_and(|sand| sand.characteristic_length.is_some())
    };
    for (path, _) in case.soils().filter(averaged).skip(1) {
        let message = "only one soil of a case may have a characteristic length";
        problems.add(
            format!("{path}.characteristic_length"),
            message,
            "remove it here or in the layer above",
        );
    }
}

/// Reports soil that its own weight would flatten: its stiffness would bear less than its weight.
pub(super) fn flattened(case: &Case, problems: &mut Problems) {
    for (path, soil) in case.soils() {
        let strain = compression(case, soil);
        if strain > 0.5 {
            let message = format!(
                "the soil would be flattened by its own weight: with E = {} Pa by {strain:.1e} times its height",
                plain(soil.young_modulus)
            );
            let cure = "check the unit: soil has some 1 to 100 MPa; 1 MPa is 1e6 Pa, 1 mPa is 0.001 Pa";
            problems.add(format!("{path}.young_modulus"), message, cure);
        }
    }
}

/// Reports sand whose density grows beyond its densest state, or without end as the grid goes down.
pub(super) fn density(case: &Case, problems: &mut Problems) {
    let floor = case.domain.low.z;
    let surface = case.ground.surface();
    let tops =
        || std::iter::once(0.0).chain(case.layers.iter().map(|layer| layer.top)).map(|top| surface - top);
    let bases = tops().skip(1).chain([floor]);
    let layers = tops().zip(bases);
    let bodies = case.soil_bodies.iter().map(|body| body.solver_body(0).bounds.map(|corner| corner.z));
    let ends = layers.chain(bodies.map(|[low, high]| (high, low.max(floor))));
    for ((path, soil), (top, base)) in case.soils().zip(ends) {
        let gradient = soil.density_gradient();
        let Some(start) = soil.relative_density().filter(|_| gradient > 0.0) else { continue };
        let at = format!("{path}.relative_density_gradient");
        if case.grid.follow.is_some_and(|follow| follow.axes[2]) {
            let message = "the density grows with depth, and the grid follows a body along z";
            problems.add(&*at, message, "leave z out of grid.follow.axes");
        }
        let deepest = start + gradient * (top - base);
        if deepest > 1.0 + 1e-9 {
            let message = format!(
                "the relative density reaches 1, the densest state, at a depth of {:.4} m below the top of this soil, and {deepest:.3} at \
                 its base, {:.4} m deep",
                ((1.0 - start) / gradient).max(0.0),
                top - base
            );
            problems.add(
                at,
                message,
                "make it smaller, or begin a layer of the densest sand there, [layer.NAME]",
            );
        }
    }
}

fn steepest(slope: &Slope) -> f64 {
    slope.tangent().atan().to_degrees()
}

const SLOPE: &str = "ground.slope";
const CROSS_SLOPE: &str = "ground.cross_slope";
