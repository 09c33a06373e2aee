//! Element tests of the soil of a case: a uniformly strained specimen, no grid.

mod columns;
mod document;
mod figures;
mod path;
mod plan;
mod remarks;
mod shown;
mod specimen;
mod table;
mod tested;

pub use columns::{CurveColumn, columns};
pub use document::document;
pub use figures::{FigureUnit, KeyFigure, KeyFigures, SecantModulus, figures};
pub use path::{Course, Ending, PathPoint, Test, TestKind, Unsustained, run};
pub use plan::{ElementError, Plan};
pub use specimen::{Held, Specimen};
pub use table::table;
pub use tested::{ElementTests, Tested};
