//! Soil parameters of the closed-form models.

use crate::bearing::davis_friction_angle;
use crate::error::{ModelResult, non_negative, positive, within};

/// Rigid–perfectly plastic Mohr–Coulomb soil and its friction on the body; with φ = 0 undrained clay of
/// strength s_u = c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Soil {
    /// Friction angle φ [rad]; 0 for undrained clay.
    pub friction_angle: f64,
    /// Dilation angle ψ [rad]; equal to φ for associated flow.
    pub dilation_angle: f64,
    /// Cohesion c [Pa]; of undrained clay the undrained shear strength s_u.
    pub cohesion: f64,
    /// Unit weight γ [N/m³]; of submerged soil the buoyant one.
    pub unit_weight: f64,
    /// Coefficient of friction μ between soil and body; the wall friction angle is δ = atan μ.
    pub body_friction: f64,
    /// Adhesion factor α of undrained clay: its friction on the body is at most α s_u, 0 to 1; without effect
    /// in other soil.
    pub adhesion_factor: f64,
    /// Growth of the strength of undrained clay with depth k [Pa/m], from s_u = c at the surface; without
    /// effect in other soil.
    pub strength_gradient: f64,
}

impl Soil {
    /// Checks that the parameters lie in the range of the models.
    ///
    /// # Errors
    /// Unless 10° ≤ φ ≤ 50°, −φ ≤ ψ ≤ φ, c ≥ 0, γ > 0 and 0 ≤ μ ≤ 2; of undrained clay unless s_u > 0, γ ≥ 0,
    /// 0 ≤ μ ≤ 2.
    pub fn check(&self) -> ModelResult<()> {
        if self.is_undrained() {
            positive("undrained shear strength [Pa]", self.cohesion)?;
            non_negative("unit weight [N/m^3]", self.unit_weight)?;
            within("adhesion factor", self.adhesion_factor, 0.0, 1.0)?;
            non_negative("growth of the strength [Pa/m]", self.strength_gradient)?;
            return within("body friction", self.body_friction, 0.0, 2.0).map(|_| ());
        }
        let phi =
            within("friction angle [rad]", self.friction_angle, 10_f64.to_radians(), 50_f64.to_radians())?;
        within("dilation angle [rad]", self.dilation_angle, -phi, phi)?;
        non_negative("cohesion [Pa]", self.cohesion)?;
        positive("unit weight [N/m^3]", self.unit_weight)?;
        within("body friction", self.body_friction, 0.0, 2.0)?;
        Ok(())
    }

    /// The equivalent associated soil with Davis' operative friction angle φ* and cohesion c* in place of φ
    /// and c.
    ///
    /// tan φ*/tan φ = c*/c. Source: Davis (1968), see [`davis_friction_angle`].
    ///
    /// # Errors
    /// If φ or ψ is out of range.
    pub fn operative(&self) -> ModelResult<Self> {
        if self.is_undrained() {
            return Ok(*self);
        }
        let angle = davis_friction_angle(self.friction_angle, self.dilation_angle)?;
        let cohesion = self.cohesion * angle.tan() / self.friction_angle.tan();
        Ok(Self { friction_angle: angle, dilation_angle: angle, cohesion, ..*self })
    }

    /// How rough a base on undrained clay is, 0 to 1: its friction under the pressure of a strip over s_u, at
    /// most the adhesion factor.
    #[must_use]
    pub fn roughness_of_clay(&self) -> f64 {
        (self.body_friction * (2.0 + std::f64::consts::PI)).min(self.adhesion_factor)
    }

    /// Undrained shear strength [Pa] at a depth [m].
    #[must_use]
    pub fn strength_at(&self, depth: f64) -> f64 {
        self.cohesion + self.strength_gradient * depth
    }

    /// Whether the soil is undrained clay: φ = ψ = 0 and a shear strength s_u = c.
    #[must_use]
    pub fn is_undrained(&self) -> bool {
        self.friction_angle == 0.0 && self.dilation_angle == 0.0
    }

    /// Friction coefficient of the interface: μ, but at most tan φ, at which sand itself fails. That of clay,
    /// whose shear strength is the limit, depends on the pressure.
    #[must_use]
    pub fn interface_friction(&self) -> f64 {
        if self.is_undrained() {
            self.body_friction
        } else {
            self.body_friction.min(self.friction_angle.tan())
        }
    }
}
