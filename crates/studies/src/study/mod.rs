//! A study: which cases it consists of, as its file says.

mod assignments;
mod checks;
mod design;
mod factor;
pub mod keys;
mod measured_points;
mod model;
mod points;
mod read;
pub mod schema;

pub use design::{Design, ModelKind};
pub use factor::{Factor, Level};
pub use measured_points::{MeasuredPoints, copy_name};
pub use model::{BaseCase, ChartWish, Part, Pool, Study, StudyStyle};
pub use points::{Point, points};
pub use read::{read, read_expanded};
