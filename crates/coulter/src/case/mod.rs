//! The case: what was typed (`schema`), what it means (`Case`, SI units), and whether it can be simulated (`validate`).
//!
//! A case is read from a file ([`load`]), from its text ([`parse`]) or from nested maps ([`from_json`]), and each of these
//! checks it. One that is made or changed by hand is checked by [`validate`].

mod advice;
mod at_rest;
mod cells_across;
mod closed_box;
pub mod cores;
mod data_file;
pub mod documentation;
mod error;
pub mod estimate;
pub mod form;
pub mod format;
mod ground_extent;
mod height_file;
mod hidden;
mod joint;
pub mod json_schema;
mod json_tree;
pub mod keys;
mod load;
pub mod machine;
pub mod mesh_file;
pub mod meshes;
mod missing;
pub mod model;
mod motion_table;
mod names;
mod numbers;
pub mod output_size;
pub(crate) mod overlap;
mod overrides;
mod own_weight;
mod path;
mod places;
mod problem;
pub mod quantity;
pub mod relief;
mod resolve;
pub mod resolved;
pub mod resources;
mod rigid_body;
mod schema;
pub mod shapes;
pub mod slope;
mod stage;
pub mod table_file;
mod thickness;
mod timed_motion;
mod told;
mod toml_tree;
pub mod tow;
mod tree;
mod typed;
mod uncertainty;
mod under_water;
mod units;
mod unknown;
mod unusual;
mod validate;
mod values;
pub mod variations;
mod water;

pub use advice::advice;
pub use closed_box::ClosedBox;
pub use data_file::FileProblem;
pub use error::{CaseError, LocatedProblem};
pub use format::FORMAT;
pub use height_file::HeightFile;
pub use load::{
    from_json, load, load_for_forecast, load_soil, parse, parse_for_forecast, parse_soil, require_valid, text,
};
pub use names::nearest;
pub use overrides::overridden;
pub(crate) use overrides::with_files;
pub(crate) use path::{fastest, travel};
pub use problem::Problem;
pub use resolved::{Case, case_text, case_text_with_forecast};
pub use told::{ToldMotion, told_of_body, told_of_stage};
pub use uncertainty::StandardDeviation;
pub use unusual::unusual;
pub use validate::{validate, validate_soil};
