//! A case under water: weights of its bodies, the drag of the water, and whether water can follow as the soil
//! changes its volume.

use super::resolved::{Body, Case};
use super::tow::TowDirection;
use super::water::of_width;
use geometry::Mesh;
use glam::DVec3;
use mechanics::{Fluid, Motion};

impl Case {
    /// Volume strain of the uppermost soil as it fails, given or from its law.
    #[must_use]
    pub fn volume_strain(&self) -> Option<f64> {
        self.water.and_then(|water| water.volume_strain).or_else(|| self.soil.volume_strain())
    }

    /// Drainage number per speed [s/m]: N_s/v = (γ_w/γ′) |ε|/k, the speed of the shearing over that at which
    /// water can follow. `None` without water, without a permeability, and for soil without friction or
    /// weight.
    #[must_use]
    pub fn drainage_per_speed(&self) -> Option<f64> {
        let water = self.water?;
        self.soil.law.friction_angle()?;
        let relative_weight = water.unit_weight(self.gravity) / self.soil.unit_weight;
        let number = relative_weight * self.volume_strain()?.abs() / water.permeability?;
        number.is_finite().then_some(number)
    }

    /// Whether the pore pressure is computed; otherwise soil under water is drained.
    #[must_use]
    pub fn computes_pore_pressure(&self) -> bool {
        self.water.is_some_and(|water| water.pore_pressure)
    }

    /// Drainage number at the largest speed at which a body is driven.
    #[must_use]
    pub fn drainage_number(&self) -> Option<f64> {
        Some(self.drainage_per_speed()? * self.largest_speed())
    }

    /// Largest speed at which a body is driven [m/s].
    #[must_use]
    pub fn largest_speed(&self) -> f64 {
        let in_stages = self.stages.iter().flat_map(|stage| &stage.changes);
        let staged = in_stages.filter(|change| change.motion < 3).map(|change| &change.to);
        let bodies = self.bodies.iter().flat_map(|body| &body.translation);
        bodies.chain(staged).map(|motion| fastest(motion, self.duration)).fold(0.0, f64::max)
    }

    /// What the water does to a body.
    #[must_use]
    pub fn fluid(&self, body: &Body) -> Fluid {
        let Some(water) = self.water else { return Fluid::NONE };
        let (displaced, centre) = body.displaced(&water, self.domain.plane_strain);
        let area = of_width(body.solid().as_ref(), self.domain.plane_strain)
            * frontal_area(body, TowDirection::of(self, body).in_space(DVec3::X));
        Fluid { displaced, centre, drag: 0.5 * water.density * water.drag_coefficient * area }
    }

    /// Weight of a whole body less its buoyancy [N].
    #[must_use]
    pub fn weight(&self, body: &Body) -> f64 {
        let displaced = self.water.map_or(0.0, |water| body.displaced(&water, self.domain.plane_strain).0);
        self.gravity * (body.whole_mass() - displaced)
    }

    /// The component of that normal to the surface of the ground [N].
    #[must_use]
    pub fn normal_weight(&self, body: &Body) -> f64 {
        self.weight(body) * self.slope.cosine()
    }
}

/// Largest speed of a motion that is prescribed [m/s].
fn fastest(motion: &Motion, duration: f64) -> f64 {
    const INTERVALS: u32 = 1000;
    match motion {
        Motion::Prescribed { before, speed, .. } => before.abs().max(speed.abs()),
        Motion::Course(course) => {
            let interval = duration / f64::from(INTERVALS);
            let at = |n: u32| course.displacement(f64::from(n) * interval);
            (0..INTERVALS).map(|n| (at(n + 1) - at(n)).abs() / interval).fold(0.0, f64::max)
        }
        Motion::Fixed | Motion::Free { .. } => 0.0,
    }
}

/// Area of a body with its parts at the start, projected along a direction [m²]; one part does not hide
/// another.
fn frontal_area(body: &Body, direction: DVec3) -> f64 {
    let frame = body.attitude.of_axle().inverse();
    let of = |mesh: Mesh, direction: DVec3| {
        // Each face in front has one behind it.
        let both = mesh.triangles.iter().map(|corners| {
            let [a, b, c] = corners.map(|n| mesh.points[n as usize]);
            0.5 * (b - a).cross(c - a).dot(direction).abs()
        });
        0.5 * both.sum::<f64>()
    };
    let own = of(body.own_solid().mesh(), frame * direction);
    let parts =
        body.parts.iter().map(|part| of(part.solid().mesh(), part.rotation.inverse() * (frame * direction)));
    parts.fold(own, |sum, area| sum + area)
}
