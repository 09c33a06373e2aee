//! The disc and the arc of it that touches the soil.

use crate::error::{Answer, none, positive, within};

/// A flat cylinder with its axle across the tow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Diameter d [m].
    pub diameter: f64,
    /// Thickness t along the axle [m].
    pub thickness: f64,
}

/// The arc of a disc's rim that touches the soil in front of the axle, and its chord.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Depth of the lowest point below the ground (or heap) at the leading contact z [m].
    pub depth: f64,
    /// Contact angle θ_f [rad]: cos θ_f = 1 − 2z/d.
    pub angle: f64,
    /// Chord from the lowest point to the leading contact L = √(z d) [m].
    pub chord: f64,
    /// Inclination of the chord to the horizontal α = θ_f/2 [rad]: sin²α = z/d.
    pub inclination: f64,
}

impl Disc {
    /// Refuses a disc without size.
    ///
    /// # Errors
    /// Unless d > 0 and t > 0.
    pub fn check(&self) -> Answer<()> {
        positive("disc diameter [m]", self.diameter)?;
        positive("disc thickness [m]", self.thickness)?;
        Ok(())
    }

    /// The contact arc at sinkage z [m], 0 < z ≤ 0.95 d, in ground that has heaped up by `heap` [m] at the contact.
    ///
    /// # Errors
    /// If the disc has no size, or sinkage and heap bury it deeper than that.
    pub fn contact(&self, sinkage: f64, heap: f64) -> Answer<Contact> {
        self.check()?;
        let depth = within("sinkage [m]", sinkage, f64::MIN_POSITIVE, 0.95 * self.diameter)?
            + within("heap height [m]", heap, 0.0, self.diameter)?;
        let relative = depth / self.diameter;
        if !(relative > 0.0 && relative <= 0.95 + 1e-9) {
            return none(
                "the contact arc",
                "sinkage and heap together bury the disc deeper than 0.95 of its diameter",
            );
        }
        let inclination = relative.sqrt().asin();
        Ok(Contact { depth, angle: 2.0 * inclination, chord: (depth * self.diameter).sqrt(), inclination })
    }

    /// The force that makes every force of this disc dimensionless: γ t d² [N].
    #[must_use]
    pub fn force_scale(&self, unit_weight: f64) -> f64 {
        unit_weight * self.thickness * self.diameter * self.diameter
    }
}
