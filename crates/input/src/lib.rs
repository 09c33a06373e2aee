//! What a user wrote: text and its tree, quantities with units, keys, and the files that a case names
//! (tables, meshes, height maps), with problems at their places.

mod data_file;
pub mod error;
pub mod height_file;
pub mod hidden;
pub mod json_tree;
pub mod key;
pub mod mesh_file;
pub mod motion_table;
pub mod names;
pub mod places;
pub mod printed;
pub mod problem;
pub mod quantity;
pub mod readable;
pub mod table_file;
pub mod text;
pub mod toml_tree;
pub mod tree;
pub mod typed;
pub mod units;
pub mod unknown;

pub use data_file::FileProblem;
pub use error::{CaseError, LocatedProblem};
pub use problem::Problem;
