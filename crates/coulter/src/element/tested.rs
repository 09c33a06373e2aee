//! Specimens that were tested, and all tests of a case together.

use super::figures::KeyFigures;
use super::path::{Course, Test, TestKind};
use case::resolved::Soil;

/// A specimen that was tested.
#[derive(Clone, Debug, PartialEq)]
pub struct Tested {
    /// The test.
    pub test: Test,
    /// Relative density at the start, of sand.
    pub relative_density: Option<f64>,
    /// The curve.
    pub course: Course,
    /// Key figures of the test.
    pub figures: KeyFigures,
}

/// Element tests of the soil of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementTests {
    /// Name of the case.
    pub case: String,
    /// Kind of the test.
    pub kind: TestKind,
    /// The soil.
    pub soil: Soil,
    /// Every specimen: for each density all pressures.
    pub tested: Vec<Tested>,
    /// What a reader should know about the tests.
    pub remarks: Vec<String>,
}
