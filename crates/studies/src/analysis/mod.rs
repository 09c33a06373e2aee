//! What a study says: main effects, tornado and Sobol indices of its responses, the charts that it asks for,
//! and tables of all numbers in them. What cannot be computed is said.

mod analyse;
mod effects;
mod factors;
mod indices;
mod named;
mod request;
mod response;
mod sample;
mod space;

pub use analyse::{Analysis, USUAL_RESPONSES, analyse};
pub use named::NamedTable;
pub use request::AnalysisRequest;
