//! The soil of a case: what every soil has, and its law.

pub(crate) mod at_rest;
pub(crate) mod law;
mod read;

pub use law::{
    ClaySoftening, Initial, Law, MohrCoulomb, Potential, Sand, SoilLaw, Strength, Tresca, VonMises,
};

pub(crate) use read::{Conditions, soil};

use crate::key::allowed::{BELOW_HALF, NOT_NEGATIVE, POSITIVE};
use crate::key::usual::{AT_REST, DENSITY as USUAL_DENSITY, POISSON, STIFFNESS, WEIGHT};
use DefaultValue::{Number, Required};
use input::key::{
    DefaultValue, Key, KeyOf, Kind, Numbers, Place, count, declared, in_ranges, joined, key, numbers,
};
use input::problem::Problems;
use input::quantity::{DENSITY, STRESS, UNIT_WEIGHT};
use physics::elastic::Elastic;
use serde::Serialize;
use solver::material::{DensityProfile, Material};

/// Path of the section of the soil, of ground in layers of the uppermost.
pub(crate) const SOIL: &str = "soil";

/// Parameters of the soil.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Soil {
    /// Yield law.
    pub law: Law,
    /// Inertial density ρ [kg/m³] (γ/g unless given); under water the dry density.
    pub density: f64,
    /// Unit weight γ [N/m³], under water the submerged one γ′; 0 for weightless soil.
    pub unit_weight: f64,
    /// Young's modulus E [Pa].
    pub young_modulus: f64,
    /// Poisson's ratio ν, 0 ≤ ν < 0.5.
    pub poisson_ratio: f64,
    /// Coefficient of earth pressure at rest K₀: horizontal over vertical stress at the start.
    pub k0: f64,
}

const LAW: [Key; 1] = [key(
    "law",
    Kind::Choice(law::WORDS),
    Required,
    "Yield law: frictional with constant angles, sand whose strength follows its density, undrained, metal \
     plasticity, or none (elastic).",
)];

type Field = KeyOf<Soil>;

/// Keys of every soil, whatever its law.
pub(crate) const COMMON: &[Field] = &[
    Field::new("unit_weight", Kind::Quantity(UNIT_WEIGHT), Place::Derived(|s| Some(&mut s.unit_weight)))
        .derived("density × gravity")
        .within(NOT_NEGATIVE)
        .usually(WEIGHT)
        .means("Unit weight γ, with `[water]` the submerged one γ′; 0 for weightless soil."),
    Field::new("density", Kind::Quantity(DENSITY), Place::Derived(|soil| Some(&mut soil.density)))
        .derived("unit_weight / gravity")
        .within(POSITIVE)
        .usually(USUAL_DENSITY)
        .means("Density ρ, which gives the soil its inertia; with `[water]` the dry density."),
    Field::new("young_modulus", Kind::Quantity(STRESS), Place::Number(|soil| &mut soil.young_modulus))
        .within(POSITIVE)
        .usually(STIFFNESS)
        .means("Young's modulus E; of sand that at a mean pressure of 100 kPa, for unloading and reloading."),
    Field::new("poisson_ratio", Kind::Number, Place::Number(|soil| &mut soil.poisson_ratio))
        .default(Number(0.3))
        .within(BELOW_HALF)
        .usually(POISSON)
        .means("Poisson's ratio ν."),
    Field::new("k0", Kind::Number, Place::Derived(|soil| Some(&mut soil.k0)))
        .derived(
            "1 − sin φ (Jaky 1944), φ_cv of sand; else ν/(1 − ν); on a slope as much more as the soil needs \
             to rest, 1 without friction",
        )
        .within(NOT_NEGATIVE)
        .usually(AT_REST)
        .means("Coefficient of earth pressure at rest K₀: horizontal over vertical stress at the start."),
];

const LISTS: &[&[Key]] = &[&LAW, law::KEYS, &declared::<_, { COMMON.len() }>(COMMON)];

/// All keys of a soil.
pub(crate) const KEYS: &[Key] = &joined::<{ count(LISTS) }>(LISTS);

impl Soil {
    /// The numbers of the soil and of its law, each with its key.
    pub(crate) fn numbers(&self) -> Numbers {
        numbers(COMMON, self).into_iter().chain(self.law.numbers()).collect()
    }

    /// Reports what is wrong with the soil of the section at a path.
    pub(crate) fn check(&self, path: &str, problems: &mut Problems) {
        in_ranges(path, &numbers(COMMON, self), problems);
        self.law.check(path, problems);
        self.law.check_at(self.density, path, problems);
    }

    /// Largest Young's modulus of the soil [Pa].
    #[must_use]
    pub fn stiffest_modulus(&self) -> f64 {
        self.young_modulus * self.law.stiffening()
    }

    /// What the law has to know of the soil at the start.
    pub(crate) fn initial(&self) -> Initial {
        let elastic = Elastic::new(self.stiffest_modulus(), self.poisson_ratio);
        Initial { density: self.density, elastic }
    }

    /// The soil at another density [kg/m³], under the same gravity.
    #[must_use]
    pub fn at_density(&self, density: f64) -> Self {
        Self { density, unit_weight: self.unit_weight * (density / self.density), ..self.clone() }
    }

    /// Density [kg/m³] at a relative density, of sand.
    #[must_use]
    pub fn density_at(&self, relative_density: f64) -> Option<f64> {
        self.law.density_at(relative_density)
    }

    /// Growth of the relative density with depth [1/m].
    #[must_use]
    pub fn density_gradient(&self) -> f64 {
        self.law.sand().map_or(0.0, |sand| sand.density_gradient)
    }

    /// The soil as it is at a depth below its top [m].
    #[must_use]
    pub fn at_depth(&self, depth: f64) -> Self {
        let soil = Self { law: self.law.at_depth(depth), ..self.clone() };
        let relative = self.relative_density().map(|relative| relative + self.density_gradient() * depth);
        let density = relative.filter(|_| self.density_gradient() > 0.0).and_then(|r| self.density_at(r));
        density.map_or_else(|| soil.clone(), |density| soil.at_density(density))
    }

    /// Relative density at the start, of sand: (e_max − e)/(e_max − e_min).
    #[must_use]
    pub fn relative_density(&self) -> Option<f64> {
        self.law.sand().map(|sand| sand.relative_density(self.density))
    }

    /// Volume strain ε from the start to the critical state at low pressure, positive for soil that dilates:
    /// (n_max − n)/(1 − n_max), which is ρ/ρ_crit − 1. `None` for soil whose law does not say it, 0 for
    /// undrained soil.
    #[must_use]
    pub fn volume_strain(&self) -> Option<f64> {
        self.law.volume_strain(&self.initial())
    }

    /// Law and parameters in a line, for the top of a report.
    #[must_use]
    pub fn summary(&self) -> String {
        self.law.summary(self.density)
    }

    /// Law and every parameter of it, as `coulter check` says them.
    #[must_use]
    pub fn spelled_out(&self) -> String {
        self.law.spelled_out(self.density)
    }

    /// The soil as the closed forms see it, with remarks on what that neglects.
    ///
    /// # Errors
    /// In words, where there are none for it.
    pub fn for_closed_forms(&self, remarks: &mut Vec<String>) -> Result<Strength, String> {
        self.law.for_closed_forms(&self.initial(), remarks)
    }

    /// The solver's material. Strength and density that grow with depth begin at height 0.
    #[must_use]
    pub fn material(&self) -> Material {
        let Initial { density, elastic } = self.initial();
        let mut material = Material {
            elastic,
            yield_law: self.law.yield_law(elastic),
            critical_density: None,
            density,
            characteristic_length: None,
            k0: self.k0,
            preconsolidation: 0.0,
            strength: None,
            density_profile: None,
        };
        self.law.complete(&mut material);
        material
    }

    /// The growth of density with depth below a height [m]; `None` for soil that is equally dense everywhere.
    pub(crate) fn density_profile(&self, top: f64) -> Option<DensityProfile> {
        let sand = self.law.sand().filter(|sand| sand.density_gradient > 0.0)?;
        let limits = [sand.minimum_density, sand.maximum_density];
        let at_top = sand.relative_density(self.density);
        Some(DensityProfile { top, at_top, gradient: sand.density_gradient, limits })
    }
}
