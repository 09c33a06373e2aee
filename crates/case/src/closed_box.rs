//! Soil that fills its box up to the lid: walls, floor and lid do not yield, and what enters compresses all
//! of it.

use super::path::range;
use super::resolved::{Body, Case, Ground, Soil};
use super::water::of_width;
use glam::DVec3;

/// Cohesion times this is what soil bears round a body at depth: bearing factors of cones and bars in clay
/// are 9 to 13.
const BEARING_FACTOR: f64 = 10.0;

/// A closed box of soil.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClosedBox {
    /// Rise of the mean pressure per volume of a body that enters, K/V of the whole box [Pa/m³]. The volume
    /// is that of the whole body, of which planes of symmetry may cut off parts, in plane strain that of a
    /// metre.
    pub stiffness: f64,
    /// Pressure that the soil bears round the bodies [Pa]: overburden, its weight, and ten times its
    /// strength.
    pub bearable: f64,
}

impl ClosedBox {
    /// Rise of the pressure that does no harm, over what the soil bears [%]; chosen: a cone in clay read 4 %
    /// low at 18 %.
    pub const HARMLESS: f64 = 10.0;

    /// The closed box of a case; `None` where soil can rise or leave, through a face at constant stress too.
    #[must_use]
    pub fn of(case: &Case) -> Option<Self> {
        let Ground::Level { surface } = case.ground else { return None };
        let size = case.domain.high - case.domain.low;
        let is_full = case.domain.high.z - surface <= 1e-9 * size.z;
        if !is_full
            || case.domain.yields()
            || case.grid.follow.is_some()
            || !case.relief.is_level()
            || case.bodies.is_empty()
        {
            return None;
        }
        // Layers yield together: their compliances add up.
        let tops: Vec<f64> = std::iter::once(0.0).chain(case.layers.iter().map(|layer| layer.top)).collect();
        let bases = tops.iter().skip(1).copied().chain([size.z]);
        let soils = case.layered_soils().map(|(_, soil)| soil);
        let each = soils.zip(tops.iter().zip(bases));
        let compliance: f64 =
            each.map(|(soil, (top, base))| (base - top).max(0.0) / bulk_modulus(soil)).sum();
        let half = |is_cut: bool| if is_cut { 0.5 } else { 1.0 };
        let domain = &case.domain;
        let modelled = half(domain.symmetric) * half(domain.symmetric_x) * domain.modelled_width();
        let touching = || case.touching().map(|(_, body)| body);
        let lowest =
            touching().map(|body| (body.position + body.bounds().0).z + range(body, case.duration)[0].z);
        let depth = (surface - lowest.fold(surface, f64::min)).min(size.z);
        let strength = case.soil.law.at_depth(depth).cohesion().unwrap_or(0.0);
        Some(Self {
            stiffness: modelled / (compliance * size.x * size.y),
            bearable: case.overburden + case.soil.unit_weight * depth + BEARING_FACTOR * strength,
        })
    }
}

/// Elastic bulk modulus [Pa].
fn bulk_modulus(soil: &Soil) -> f64 {
    soil.stiffest_modulus() / (3.0 * (1.0 - 2.0 * soil.poisson_ratio))
}

/// Volume of a body that a prescribed motion takes below the surface [m³], at most.
pub(super) fn entering_volume(case: &Case, body: &Body) -> f64 {
    let surface = case.ground.surface() - body.position.z;
    let deepest = range(body, case.duration)[0].z;
    (volume_below(case, body, surface - deepest) - volume_below(case, body, surface)).max(0.0)
}

/// Volume of a body below a level that is this high over its reference point [m³]: the flux of (z − level)
/// through its surface.
fn volume_below(case: &Case, body: &Body, level: f64) -> f64 {
    let solid = body.solid();
    let (mesh, axle) = (solid.mesh(), body.attitude.of_axle());
    let points: Vec<DVec3> = mesh.points.iter().map(|point| axle * *point).collect();
    let corner = |n: u32| points[n as usize];
    let all = mesh.triangles.iter().map(|corners| below(corners.map(corner), level)).sum::<f64>();
    all * of_width(solid.as_ref(), case.domain.plane_strain)
}

/// The part of a triangle below a level: the integral of (z − level) over its area as seen along z [m³].
fn below(corners: [DVec3; 3], level: f64) -> f64 {
    let mut cut: Vec<DVec3> = Vec::with_capacity(4);
    for n in 0..3 {
        let (a, b) = (corners[n], corners[(n + 1) % 3]);
        if a.z <= level {
            cut.push(a);
        }
        if (a.z - level) * (b.z - level) < 0.0 {
            cut.push(a + (b - a) * ((level - a.z) / (b.z - a.z)));
        }
    }
    let fan = (2..cut.len()).map(|n| [cut[0], cut[n - 1], cut[n]]);
    fan.map(|[a, b, c]| 0.5 * (b - a).cross(c - a).z * ((a.z + b.z + c.z) / 3.0 - level)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse;

    /// The cone of 40 mm in a quarter of a box of clay that its user had.
    fn cone(more: &[&str]) -> Case {
        let text = "format = 2\nsoil = { law = 'tresca', shear_strength = '20 kPa', unit_weight = '0 N/m^3', density = '1700 kg/m^3', \
                    young_modulus = '5.96 MPa', poisson_ratio = 0.49, k0 = 1 }\nground = { overburden = '70 kPa' }\n\
                    domain = { x = ['0 m', '0.2 m'], y = ['0 m', '0.2 m'], z = ['-0.32 m', '0 m'], symmetric = true, symmetric_x = true }\n\
                    grid = { cell = '8 mm', growth = 1.3 }\nrun = { duration = '0.22 s' }\n[body.cone]\nshape = 'cone'\ndiameter = '40 mm'\n\
                    cone_angle = '60 deg'\nlength = '0.24 m'\nfriction = 0\nsinkage = '50 mm'\nheave = { speed = '-0.6 m/s', ramp = '0.02 s' }\n";
        parse(text, "case.toml", &more.iter().map(|set| (*set).to_owned()).collect::<Vec<_>>()).unwrap()
    }

    #[test]
    fn a_cone_pumps_a_box_up_by_its_volume() {
        let case = cone(&[]);
        let entering = entering_volume(&case, &case.bodies[0]);
        let exact = 0.25 * std::f64::consts::PI * 0.04 * 0.04 * 0.126;
        assert!((entering / exact - 1.0).abs() < 0.01, "{entering} {exact}");
        let closed = ClosedBox::of(&case).unwrap();
        // K ΔV/V of the user's table: 307 kPa.
        assert!((closed.stiffness * entering / 307e3 - 1.0).abs() < 0.02, "{}", closed.stiffness * entering);
        assert_eq!(closed.bearable, 270e3);
        let half = cone(&["domain.symmetric_x=false", "domain.x=['-0.2 m', '0.2 m']"]);
        assert!((ClosedBox::of(&half).unwrap().stiffness / closed.stiffness - 1.0).abs() < 1e-12);
    }

    #[test]
    fn soil_with_a_free_surface_and_a_body_that_moves_inside_are_not_pumped_up() {
        let open = cone(&["ground.overburden=0 Pa", "domain.z=['-0.32 m', '0.1 m']"]);
        assert_eq!(ClosedBox::of(&open), None);
        let deep = include_str!("../../../validation/B8_deep_flow/case.toml");
        let deep = parse(deep, "case.toml", &[]).unwrap();
        assert!(ClosedBox::of(&deep).is_some());
        assert!(entering_volume(&deep, &deep.bodies[0]) < 1e-12);
    }
}
