//! What is asked of element tests, and what cannot be tested.

use super::figures::figures;
use super::path::{Test, TestKind, Unsustained, run};
use super::remarks::remarks;
use super::shown::{decimals, stress};
use super::tested::{ElementTests, Tested};
use case::resolved::{Law, Soil};
use case::validate_soil;
use input::Problem;
use input::quantity::plain;

/// Which specimens are tested, and how far.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Kind of the test.
    pub kind: TestKind,
    /// Pressures at the start [Pa].
    pub pressures: Vec<f64>,
    /// Densities at the start [kg/m³].
    pub densities: Vec<f64>,
    /// Largest strain of tests that shear.
    pub largest_strain: f64,
    /// Largest pressure of compression tests [Pa].
    pub largest_pressure: f64,
}

/// Why soil cannot be tested so.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ElementError {
    /// The soil is linear elastic.
    #[error(
        "the soil is linear elastic: it has no strength, and its moduli are those of the case, E = {young} and ν = {poisson}; choose \
         another soil.law"
    )]
    Elastic {
        /// Young's modulus with its unit.
        young: String,
        /// Poisson's ratio.
        poisson: f64,
    },
    /// A number is out of range.
    #[error("{what} {value} is out of range: it must be {range}")]
    Range {
        /// Name of the number.
        what: &'static str,
        /// The number, with its unit.
        value: String,
        /// The range that is allowed.
        range: String,
    },
    /// The soil cannot have such a density.
    #[error("at a density of {density}: {}; {}", problem.message, problem.cure)]
    Density {
        /// The density, with its unit.
        density: String,
        /// What is wrong with the density.
        problem: Problem,
    },
    /// The specimen fails at the start.
    #[error("{0}; add  k0 = 1  to [soil] or --set soil.k0=1, or choose another pressure")]
    Unsustained(#[from] Unsustained),
}

/// Allowed pressures [Pa].
const PRESSURES: [f64; 2] = [1.0, 1e10];
/// Largest strains that are allowed: of the height, and in shear.
const STRAINS: [f64; 2] = [0.5, 5.0];

impl Plan {
    /// The usual plan for a soil: frictional soil is sheared at 1, 10 and 100 kPa and compressed from 1 to
    /// 100 kPa; soil whose strength does not depend on the pressure is sheared at a pressure of its shear
    /// strength, and compressed up to ten times that.
    #[must_use]
    pub fn usual(kind: TestKind, soil: &Soil) -> Self {
        let strength = soil.law.cohesion().filter(|_| soil.law.friction_angle().is_none());
        let pressures = match (strength, kind.shears()) {
            (Some(strength), true) => vec![strength],
            (Some(strength), false) => vec![0.1 * strength],
            (None, true) => vec![1e3, 1e4, 1e5],
            (None, false) => vec![1e3],
        };
        Self {
            kind,
            largest_pressure: 100.0 * pressures[0],
            pressures,
            densities: vec![soil.density],
            largest_strain: if kind == TestKind::Shear { 0.5 } else { 0.25 },
        }
    }

    /// Tests the soil of a case.
    ///
    /// # Errors
    /// When the soil is elastic, a number of the plan is out of range, or a specimen cannot be at its initial
    /// state.
    pub fn run(&self, case: &str, soil: &Soil) -> Result<ElementTests, ElementError> {
        if soil.law == Law::Elastic {
            let young = stress(soil.young_modulus);
            return Err(ElementError::Elastic { young, poisson: soil.poisson_ratio });
        }
        self.check()?;
        let mut tested = Vec::new();
        for density in &self.densities {
            let soil = soil.at_density(*density);
            if let Some(problem) = validate_soil(&soil).into_iter().next() {
                let density = format!("{} kg/m³", decimals(*density, 1));
                return Err(ElementError::Density { density, problem });
            }
            for pressure in &self.pressures {
                tested.push(self.tested(&soil, *pressure)?);
            }
        }
        let remarks = remarks(self.kind, soil, &tested);
        Ok(ElementTests { case: case.to_owned(), kind: self.kind, soil: soil.clone(), tested, remarks })
    }

    fn tested(&self, soil: &Soil, pressure: f64) -> Result<Tested, ElementError> {
        let test = Test {
            kind: self.kind,
            pressure,
            density: soil.density,
            largest_strain: self.largest_strain,
            largest_pressure: self.largest_pressure,
        };
        let course = run(&soil.material(), &test)?;
        let figures = figures(soil, &test, &course);
        Ok(Tested { test, relative_density: soil.relative_density(), course, figures })
    }

    fn check(&self) -> Result<(), ElementError> {
        let within = |what, value: f64, [low, high]: [f64; 2]| {
            let range = format!("from {} to {}", stress(low), stress(high));
            let is_within = value >= low && value <= high;
            if is_within { Ok(()) } else { Err(ElementError::Range { what, value: stress(value), range }) }
        };
        for pressure in &self.pressures {
            within("the pressure", *pressure, PRESSURES)?;
        }
        if self.kind.shears() {
            let most = STRAINS[usize::from(self.kind == TestKind::Shear)];
            if !(self.largest_strain > 0.0 && self.largest_strain <= most) {
                let range = format!("above 0 and at most {most}, as a number: 25 % is 0.25");
                let value = plain(self.largest_strain);
                return Err(ElementError::Range { what: "the largest strain", value, range });
            }
            return Ok(());
        }
        let start = self.pressures.iter().copied().fold(0.0, f64::max);
        if self.largest_pressure <= start {
            let range = format!("above the pressure at the start, {}", stress(start));
            let value = stress(self.largest_pressure);
            return Err(ElementError::Range { what: "the largest pressure", value, range });
        }
        within("the largest pressure", self.largest_pressure, PRESSURES)
    }
}
