//! Ground on a slope: the axes of the case lie in its surface, and gravity is tilted.

use crate::key::allowed::SLOPE;
use glam::DVec3;
use input::key::DefaultValue::Quantity;
use input::key::{Key, KeyOf, Kind, Place, declared, in_ranges, numbers, read};
use input::problem::Problems;
use input::quantity::ANGLE;
use input::typed::Section;
use serde::Serialize;

/// Slope of the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Slope {
    /// Angle of the slope along x, uphill positive [rad].
    pub along: f64,
    /// Angle of the slope along y, uphill positive [rad].
    pub across: f64,
}

/// Keys of a slope, and where their values lie.
type Field = KeyOf<Slope>;

const FIELDS: &[Field] = &[
    Field::new("slope", Kind::Quantity(ANGLE), Place::Number(|slope| &mut slope.along))
        .default(Quantity("0 deg"))
        .within(SLOPE)
        .means("Angle of the slope along x, uphill positive: x and y lie in the surface, z is normal to it, and gravity is tilted."),
    Field::new("cross_slope", Kind::Quantity(ANGLE), Place::Number(|slope| &mut slope.across))
        .default(Quantity("0 deg"))
        .within(SLOPE)
        .means("The same along y."),
];

impl Slope {
    pub(crate) const KEYS: &[Key] = &declared::<_, { FIELDS.len() }>(FIELDS);

    /// The slope that the section of the ground says.
    pub(crate) fn typed(ground: &Section, problems: &mut Problems) -> Option<Self> {
        read(FIELDS, Self::default(), ground, problems)
    }

    /// Reports angles that are out of range.
    pub(crate) fn check(&self, problems: &mut Problems) {
        in_ranges("ground", &numbers(FIELDS, self), problems);
    }

    /// Whether the ground is level.
    #[must_use]
    pub fn is_level(&self) -> bool {
        *self == Self::default()
    }

    /// Angles of the slope along x and y [rad].
    #[must_use]
    pub fn angles(&self) -> [f64; 2] {
        [self.along, self.across]
    }

    /// Unit vector along which gravity acts.
    #[must_use]
    pub fn down(&self) -> DVec3 {
        if self.is_level() {
            return DVec3::NEG_Z;
        }
        let [along, across] = self.angles().map(|angle| if angle == 0.0 { 0.0 } else { -angle.tan() });
        DVec3::new(along, across, -1.0).normalize()
    }

    /// Cosine of the steepest angle of the slope: the part of gravity that acts normal to the surface.
    #[must_use]
    pub fn cosine(&self) -> f64 {
        -self.down().z
    }

    /// Tangent of the steepest angle of the slope: shear over normal stress on planes parallel to the surface
    /// of soil at rest.
    #[must_use]
    pub fn tangent(&self) -> f64 {
        let down = self.down();
        down.truncate().length() / -down.z
    }

    /// Principal stresses of soil at rest, compression positive, over the stress normal to the surface.
    #[must_use]
    pub fn principal_stresses(&self, k0: f64) -> [f64; 3] {
        let radius = (0.5 * (1.0 - k0)).hypot(self.tangent());
        let middle = 0.5 * (1.0 + k0);
        [middle + radius, k0, middle - radius]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gravity_pulls_down_the_slope() {
        let slope = Slope { along: 0.3, across: 0.0 };
        assert!((slope.down() - DVec3::new(-0.3_f64.sin(), 0.0, -0.3_f64.cos())).length() < 1e-15);
        assert!((slope.tangent() - 0.3_f64.tan()).abs() < 1e-15);
        assert_eq!(Slope::default().down(), DVec3::NEG_Z);
        // Two slopes: the surface rises by the tangents of both.
        let both = Slope { along: 0.2, across: -0.1 };
        assert!((both.tangent() - 0.2_f64.tan().hypot(0.1_f64.tan())).abs() < 1e-15);
        assert!(both.down().x < 0.0 && both.down().y > 0.0);
    }
}
