//! The disc and its contact arc.

use crate::error::{ModelResult, positive, undefined, within};

/// A flat cylinder with its axle perpendicular to the tow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Diameter d [m].
    pub diameter: f64,
    /// Thickness t along the axle [m].
    pub thickness: f64,
}

/// The arc of a disc's rim in contact with the soil in front of the axle, and its chord.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Depth z of the lowest point below the ground (or bow wave) at the leading contact point [m].
    pub depth: f64,
    /// Contact angle θ_f [rad]: cos θ_f = 1 − 2z/d.
    pub angle: f64,
    /// Chord from the lowest point to the leading contact point L = √(z d) [m].
    pub chord: f64,
    /// Inclination of the chord to the horizontal α = θ_f/2 [rad]: sin²α = z/d.
    pub inclination: f64,
}

impl Disc {
    /// Checks the dimensions.
    ///
    /// # Errors
    /// Unless d > 0 and t > 0.
    pub fn check(&self) -> ModelResult<()> {
        positive("disc diameter [m]", self.diameter)?;
        positive("disc thickness [m]", self.thickness)?;
        Ok(())
    }

    /// The contact arc at sinkage z [m], 0 < z ≤ 0.95 d, with a bow wave of height `bow_wave` [m] at the
    /// leading contact point.
    ///
    /// # Errors
    /// If a dimension is not positive, or sinkage and bow wave together exceed that depth.
    pub fn contact(&self, sinkage: f64, bow_wave: f64) -> ModelResult<Contact> {
        self.check()?;
        let depth = within("sinkage [m]", sinkage, f64::MIN_POSITIVE, 0.95 * self.diameter)?
            + within("bow wave height [m]", bow_wave, 0.0, self.diameter)?;
        let relative = depth / self.diameter;
        if !(relative > 0.0 && relative <= 0.95 + 1e-9) {
            return undefined(
                "the contact arc",
                "sinkage and bow wave together are deeper than 0.95 of the diameter",
            );
        }
        let inclination = relative.sqrt().asin();
        Ok(Contact { depth, angle: 2.0 * inclination, chord: (depth * self.diameter).sqrt(), inclination })
    }

    /// Force scale γ t d² [N] of dimensionless forces, for the unit weight γ [N/m³].
    #[must_use]
    pub fn force_scale(&self, unit_weight: f64) -> f64 {
        unit_weight * self.thickness * self.diameter * self.diameter
    }
}
