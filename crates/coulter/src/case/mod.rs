//! The case: what was typed (`schema`), and what it means (`Case`, SI units).

mod advice;
pub mod documentation;
pub mod estimate;
pub mod format;
pub mod json_schema;
pub mod keys;
mod load;
pub mod machine;
pub mod model;
mod names;
pub mod output_size;
mod overrides;
mod path;
mod problem;
pub mod quantity;
mod ranges;
mod resolve;
pub mod resolved;
pub mod resources;
mod schema;
pub mod shapes;
mod tree;
mod typed;
mod uncertainty;
mod units;
mod unknown;
mod values;

pub use advice::advice;
pub use format::FORMAT;
pub use load::{load, load_with_deviations, parse};
pub use overrides::overridden;
pub(crate) use path::travel;
pub use problem::{CaseError, Problem};
pub use resolved::{Case, case_text};
pub use uncertainty::StandardDeviation;
