//! The solver's model of a case.

use super::resolved::Case;
use super::resolved::{self, Follow, Motion};
use geometry::Shape;
use glam::{DMat3, DVec3};
use mechanics::{Inertia, Pair, Pose};
use physics::sand::Sand;
use solver::boundary::{Boundaries, Boundary};
use solver::grid::Grid;
use solver::material::Material;
use solver::model::{BodyModel, ContactMethod, Filling, Ground, Method, Model, PoreWater};
use std::sync::Arc;

/// The model that a case means, its grid laid out for vectors of `lanes` numbers.
#[must_use]
pub fn model(case: &Case, lanes: usize) -> Model {
    let boundaries = boundaries(case);
    let bodies: Vec<BodyModel> = case.bodies.iter().map(|own| body(case, own)).collect();
    let pairs = case.joints.iter().filter_map(|joint| joint.touching(&bodies));
    Model {
        pairs: pairs.map(|pair| Arc::new(pair) as Arc<dyn Pair>).collect(),
        grid: Grid::with_open_faces(case.grid.faces.clone(), boundaries.open_faces(), lanes)
            .with_aspect(case.grid.aspect),
        materials: materials(case),
        gravity: case.gravity,
        down: case.slope.down(),
        soil_gravity: if case.soil.unit_weight > 0.0 {
            case.soil.unit_weight / case.soil.density
        } else {
            0.0
        },
        surface: case.ground.surface(),
        ground: ground(case),
        pore_water: pore_water(case),
        boundaries,
        follow: case.grid.follow,
        modelled_width: case.domain.modelled_width(),
        bodies,
        joints: case.joints.iter().filter_map(|joint| joint.mechanical(&case.bodies)).collect(),
        method: Method {
            courant: case.numerics.courant,
            remap_displacement: case.numerics.remap_displacement,
            hourglass: case.numerics.hourglass,
            hourglass_yielding: case.numerics.hourglass_yielding,
            bulk_viscosity: [case.numerics.bulk_viscosity_linear, case.numerics.bulk_viscosity_quadratic],
            contact: match case.numerics.contact {
                resolved::Contact::Penalty => ContactMethod::Penalty,
                resolved::Contact::Impulse => ContactMethod::Impulse,
            },
            point_spacing: case.numerics.point_spacing,
        },
    }
}

/// The water in the pores, where its pressure is computed.
fn pore_water(case: &Case) -> Option<PoreWater> {
    let water = case.water.filter(|water| water.pore_pressure)?;
    let unit_weight = water.unit_weight(case.gravity);
    Some(PoreWater { permeability: water.permeability?, unit_weight, level: water.level })
}

/// The undisturbed ground that a case means.
pub fn ground(case: &Case) -> Ground {
    let first = 1 + case.layers.len();
    let bodies = case.soil_bodies.iter().enumerate().map(|(n, body)| body.solver_body(first + n));
    Ground {
        fillings: fillings(case),
        overburden: case.overburden,
        relief: case.relief.of_solver(),
        bodies: bodies.collect(),
    }
}

/// The materials of the soils from the top down and of the soil bodies, each with its strength and density
/// from its top.
pub fn materials(case: &Case) -> Vec<Material> {
    let depths = std::iter::once(0.0).chain(case.layers.iter().map(|layer| layer.top));
    let heaps = case.soil_bodies.iter().map(|body| body.solver_body(0).bounds[1].z);
    let tops = depths.map(|top| case.ground.surface() - top).chain(heaps);
    let each = case.soils().zip(tops).map(|((_, soil), top)| {
        let mut own = soil.material();
        if let Some(profile) = &mut own.strength {
            profile.top = top;
        }
        own.density_profile = soil.density_profile(top);
        own
    });
    each.collect()
}

/// The law of sand, and its dilatancy index at the start, at low pressure; `None` for other soil.
#[must_use]
pub fn sand(soil: &resolved::Soil) -> Option<(Sand, f64)> {
    soil.law.sand().map(|sand| sand.at_start(&soil.initial()))
}

/// Walls, planes of symmetry at the low ends along x and y, and open ends where the grid follows a body.
fn boundaries(case: &Case) -> Boundaries {
    let domain = &case.domain;
    let mut boundaries = domain.walls.map(|pair| {
        pair.map(|wall| match wall {
            resolved::Wall::Smooth => Boundary::SmoothWall,
            resolved::Wall::Fixed => Boundary::RoughWall,
            resolved::Wall::Pressure => Boundary::ConstantStress,
        })
    });
    for (axis, is_plane) in [(0, domain.symmetric_x), (1, domain.symmetric)] {
        if is_plane {
            boundaries[axis][0] = Boundary::Symmetry;
        }
    }
    if let Some(Follow { body, axes }) = case.grid.follow {
        for axis in (0..3).filter(|axis| axes[*axis]) {
            boundaries[axis] = open_ends(case.bodies.get(body), axis, case.duration);
        }
    }
    Boundaries(boundaries)
}

/// The ends of a grid that follows a body along an axis: undisturbed ground enters in front, and what is
/// behind leaves as it is. Above and below the ground is undisturbed.
fn open_ends(body: Option<&resolved::Body>, axis: usize, duration: f64) -> [Boundary; 2] {
    let sign = |motion: &Motion| match motion {
        Motion::Prescribed { speed, .. } => *speed,
        Motion::Course(course) => course.displacement(duration),
        Motion::Free { load, .. } => *load,
        Motion::Fixed => 0.0,
    };
    let along = body.map_or(0.0, |body| sign(&body.guided().translation[axis]));
    // A body that drives itself goes where it rolls.
    let along = if along == 0.0 { body.map_or(0.0, |body| sign(body.spin())) } else { along };
    match (axis, along < 0.0) {
        (2, _) => [Boundary::Inflow; 2],
        (_, true) => [Boundary::Inflow, Boundary::Outflow],
        (_, false) => [Boundary::Outflow, Boundary::Inflow],
    }
}

fn body(case: &Case, body: &resolved::Body) -> BodyModel {
    BodyModel {
        name: body.name.clone(),
        shape: body.solid(),
        start: Pose { position: body.position, rotation: body.attitude.of_axle() },
        inertia: inertia(body),
        friction: body.friction,
        adhesion_factor: body.adhesion_factor,
        edge_inset: case.edge_inset(body),
        fluid: case.fluid(body),
        motion: body.motions(),
    }
}

/// Mass properties of a body with its parts.
fn inertia(body: &resolved::Body) -> Inertia {
    let own = one_inertia(body.own_solid().as_ref(), body.mass, body.axle_inertia);
    if body.parts.is_empty() {
        return own;
    }
    let parts = body.parts.iter().map(|part| {
        let rotation = DMat3::from_quat(part.rotation);
        let Inertia { mass, centre, tensor } =
            one_inertia(part.solid().as_ref(), part.mass, part.axle_inertia);
        Inertia {
            mass,
            centre: part.offset + rotation * centre,
            tensor: rotation * tensor * rotation.transpose(),
        }
    });
    let all: Vec<Inertia> = std::iter::once(own).chain(parts).collect();
    let mass = all.iter().map(|one| one.mass).sum::<f64>();
    let centre = all.iter().map(|one| one.mass * one.centre).sum::<DVec3>() / mass;
    // Steiner's theorem.
    let about = |one: &Inertia| {
        let arm = one.centre - centre;
        let outer = DMat3::from_cols(arm * arm.x, arm * arm.y, arm * arm.z);
        one.tensor + (DMat3::IDENTITY * arm.length_squared() - outer) * one.mass
    };
    Inertia { mass, centre, tensor: all.iter().map(about).fold(DMat3::ZERO, |sum, one| sum + one) }
}

/// Mass properties of a homogeneous solid, its tensor scaled so that it has this moment of inertia about the
/// axle [kg m²]; of a frame, which has no volume, the same moment about every axis.
fn one_inertia(solid: &dyn Shape, mass: f64, axle_inertia: f64) -> Inertia {
    if !solid.has_surface() {
        let tensor = DMat3::from_diagonal(DVec3::splat(axle_inertia));
        return Inertia { mass, centre: DVec3::ZERO, tensor };
    }
    let solid = solid.mass_properties();
    let scale = axle_inertia / solid.about_axle();
    Inertia { mass, centre: solid.centroid, tensor: solid.inertia * scale }
}

/// Where the soils of a case are at the start.
fn fillings(case: &Case) -> Vec<Filling> {
    const FAR: f64 = f64::INFINITY;
    match case.ground {
        resolved::Ground::Level { surface } => {
            let tops = || case.layers.iter().map(|layer| surface - layer.top);
            // Through a lid that yields more of the same enters.
            let top = if case.domain.lid() == resolved::Wall::Pressure { FAR } else { surface };
            let bases = tops().chain([-FAR]);
            let layer = |(material, (top, base))| Filling {
                material,
                ..Filling::between(DVec3::new(-FAR, -FAR, base), DVec3::new(FAR, FAR, top))
            };
            std::iter::once(top).chain(tops()).zip(bases).enumerate().map(layer).collect()
        }
        resolved::Ground::Column { low, high, radius } => vec![Filling { low, high, radius, material: 0 }],
    }
}
