//! The reference lengths and force that make a body's results dimensionless, and its rolling radius.

use super::BodySample;
use crate::case::resolved::{Body, Case, Motion};
use serde::{Deserialize, Serialize};

/// Speeds below this [m/s] count as rest, where the turn ratio is not defined.
const REST: f64 = 1e-6;

/// The reference quantities of a body.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reference {
    /// Name of the body.
    pub name: String,
    /// Its kind: "disc", "block", "cylinder", "sphere", "frame".
    pub kind: String,
    /// Reference length d [m]: the diameter, a block's height; 0 of a frame, which has no surface.
    pub length: f64,
    /// Reference width t [m]: a disc's thickness, a block's width, the length of a cylinder along y, otherwise the diameter; in
    /// plane strain the width of the slab.
    pub width: f64,
    /// Width of all its surfaces across the tow at the start, along y [m]; in plane strain that of the slab.
    #[serde(default)]
    pub across: f64,
    /// Unit weight γ of the soil [N/m³]; 0 when it is weightless.
    pub unit_weight: f64,
    /// Rolling radius r [m]; `None` for a body that cannot roll.
    pub radius: Option<f64>,
    /// Whether it moves along x, prescribed or free.
    pub towed: bool,
    /// Whether it rotates about its axle.
    pub turns: bool,
}

impl Reference {
    /// The reference of one body of a case.
    #[must_use]
    pub fn of(case: &Case, body: &Body) -> Self {
        let slab = case.domain.high.y - case.domain.low.y;
        Self {
            name: body.name.clone(),
            kind: body.main_shape().kind().to_owned(),
            length: body.main_shape().reference_length(),
            width: if case.domain.plane_strain { slab } else { body.main_shape().reference_width() },
            across: if case.domain.plane_strain {
                slab
            } else {
                body.surfaces().iter().map(|surface| surface.size().y).sum()
            },
            unit_weight: case.soil.unit_weight,
            radius: body.wheel_diameter().map(|diameter| 0.5 * diameter),
            towed: !matches!(body.guided().translation[0], Motion::Fixed),
            turns: !matches!(body.spin(), Motion::Fixed),
        }
    }

    /// The references of all bodies of a case, in its order.
    #[must_use]
    pub fn all(case: &Case) -> Vec<Self> {
        case.bodies.iter().map(|body| Self::of(case, body)).collect()
    }

    /// Whether the body has a surface that the soil can touch.
    #[must_use]
    pub fn has_surface(&self) -> bool {
        self.length > 0.0
    }

    /// Reference force γ t d² [N]; `None` for weightless soil.
    #[must_use]
    pub fn force(&self) -> Option<f64> {
        let force = self.unit_weight * self.width * self.length * self.length;
        (force > 0.0 && force.is_finite()).then_some(force)
    }

    /// A force [N] over the reference force.
    #[must_use]
    pub fn force_group(&self, force: f64) -> Option<f64> {
        self.force().map(|reference| force / reference)
    }

    /// A length [m] over the reference length.
    #[must_use]
    pub fn length_group(&self, length: f64) -> Option<f64> {
        (self.length > 0.0).then(|| length / self.length)
    }

    /// Turn ratio ω r / v with v in the direction in which the body rolls: 1 rolls without slip, 0 slides without rotation; `None`
    /// at rest or without a radius.
    #[must_use]
    pub fn turn_ratio(&self, spin: f64, speed: f64) -> Option<f64> {
        self.radius.filter(|_| speed.abs() > REST).map(|radius| spin * radius / speed)
    }

    /// Turn ratio of one line of the history.
    #[must_use]
    pub fn turn_ratio_of(&self, sample: &BodySample) -> Option<f64> {
        self.turn_ratio(sample.spin, sample.rolling_speed)
    }
}
