//! The case: what was typed (`schema`), what it means (`Case`, SI units), and whether it can be simulated
//! (`validate`).
//!
//! A case is read from a file ([`load`]), from its text ([`parse`]) or from nested maps ([`from_json`]), and
//! each of these checks it. One that is made or changed by hand is checked by [`validate`].

mod advice;
mod body;
mod clearance;
pub mod closed_box;
mod context;
pub mod documentation;
mod domain;
mod edge_inset;
pub mod estimate;
pub mod form;
pub mod format;
mod grid;
mod ground;
mod ground_extent;
mod height_map;
mod joint;
pub mod json_schema;
mod key;
pub mod keys;
mod layer;
mod load;
mod measured;
pub mod meshes;
pub mod model;
mod names;
mod numerics;
mod output;
pub mod output_size;
pub mod overlap;
mod overrides;
mod own_weight;
pub mod path;
pub mod relief;
mod resolve;
pub mod resolved;
pub mod resources;
mod run;
mod schema;
pub mod shapes;
pub mod slope;
pub mod soil;
mod soil_body;
mod stage;
mod thickness;
mod timed_motion;
mod told;
mod top;
pub mod tow;
mod typed_case;
mod uncertainty;
mod under_water;
mod unusual;
mod validate;
mod values;
mod water;

pub use advice::advice;
pub use advice::inertia::{Inertia, inertia};
pub use closed_box::ClosedBox;
pub use format::FORMAT;
pub use input::height_file::HeightFile;
pub use input::names::nearest;
pub use input::{CaseError, FileProblem, LocatedProblem, Problem, mesh_file, quantity, table_file};
pub use load::{
    from_json, load, load_for_forecast, load_soil, parse, parse_for_forecast, parse_soil, require_valid, text,
};
pub use machine::{self, cores};
pub use overrides::{overridden, with_files};
pub use resolved::{Case, case_text, case_text_with_forecast};
pub use told::{ToldMotion, told_of_body, told_of_stage};
pub use uncertainty::StandardDeviation;
pub use unusual::unusual;
pub use validate::{validate, validate_soil};
