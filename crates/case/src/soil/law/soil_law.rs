//! What each yield law has to say of itself.

use input::key::Numbers;
use input::problem::Problems;
use physics::elastic::Elastic as Moduli;
use physics::law::Law as ConstitutiveLaw;
use solver::material::Material;

/// Soil at the start, apart from its law.
#[derive(Clone, Copy, Debug)]
pub struct Initial {
    /// Density [kg/m³]; under water the dry one.
    pub density: f64,
    /// Elastic moduli at the point where they are largest.
    pub elastic: Moduli,
}

/// What a law says of itself. Angles are in rad, stresses in Pa.
pub trait SoilLaw {
    /// Parameters of the law, each with its key.
    fn numbers(&self) -> Numbers;

    /// What soil of this law is called in messages.
    fn kind(&self) -> &'static str;

    /// Reports parameters in range that contradict each other.
    fn contradictions(&self, _path: &str, _problems: &mut Problems) {}

    /// Reports what contradicts the density of the soil at the start [kg/m³].
    fn check_at(&self, _density: f64, _path: &str, _problems: &mut Problems) {}

    /// Friction angle φ, of sand that of the critical state; `None` for a strength that does not depend on
    /// the pressure.
    fn friction_angle(&self) -> Option<f64> {
        None
    }

    /// Dilation angle ψ; 0 for isochoric flow.
    fn dilation_angle(&self) -> f64 {
        0.0
    }

    /// Shear strength without normal stress: c, s_u, or about half of σ_y; `None` for soil that does not
    /// fail.
    fn cohesion(&self) -> Option<f64>;

    /// Whether soil of this law sustains these principal stresses, compression positive, the largest first.
    fn sustains(&self, principal: [f64; 3]) -> bool;

    /// Coefficient of earth pressure at rest under level ground: Jaky's (1944), or that of elastic soil that
    /// cannot expand sideways.
    fn level_k0(&self, poisson_ratio: f64) -> f64 {
        self.friction_angle().map_or(poisson_ratio / (1.0 - poisson_ratio), |angle| 1.0 - angle.sin())
    }

    /// Whether the stress of the law is that of the grains, beside which water in the pores has a pressure of
    /// its own.
    fn bears_effective_stress(&self) -> bool {
        self.friction_angle().is_some()
    }

    /// Whether the soil may lose, and take up, volume as it is sheared, without limit on the way.
    fn changes_volume(&self) -> [bool; 2] {
        [false, self.dilation_angle() > 0.0]
    }

    /// Volume strain of a soil from the start to failure, positive where it dilates; `None` where it does not
    /// follow from the law.
    fn volume_strain(&self, _soil: &Initial) -> Option<f64> {
        Some(0.0)
    }

    /// The largest Young's modulus over that of the soil.
    fn stiffening(&self) -> f64 {
        1.0
    }

    /// The law of the solver, for elastic moduli.
    fn yield_law(&self, elastic: Moduli) -> Option<ConstitutiveLaw>;

    /// Enters into the solver's material what is not in its law; elastic moduli, density and K₀ are there
    /// already.
    fn complete(&self, _material: &mut Material) {}

    /// Law and strength of soil of a density [kg/m³] in a few words, with three digits, for the top of a
    /// report.
    fn summary(&self, density: f64) -> String;

    /// Law and all parameters of soil of a density [kg/m³], with four digits.
    fn spelled_out(&self, density: f64) -> String;

    /// The soil as the closed forms see it, with remarks on what that neglects.
    ///
    /// # Errors
    /// In words, where there are none for it.
    fn for_closed_forms(&self, _soil: &Initial, _remarks: &mut Vec<String>) -> Result<Strength, String> {
        Err(format!(
            "the soil is {}; the closed forms are for sand, Mohr-Coulomb soil and undrained clay",
            self.kind()
        ))
    }
}

/// Strength of a soil in closed forms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Strength {
    /// Friction angle φ [rad]; 0 for undrained soil.
    pub friction_angle: f64,
    /// Dilation angle ψ [rad].
    pub dilation_angle: f64,
    /// Cohesion, or undrained shear strength at the top of the soil [Pa].
    pub cohesion: f64,
    /// Growth of the undrained shear strength with depth [Pa/m].
    pub gradient: f64,
}
