//! Tables of numbers as text: comma-separated, a header with units, nothing where there is no number.
//!
//! The histories of a run follow the columns of `history::columns`. Whole lines are flushed as they come, so
//! that a killed run leaves whole lines; what is read back is checked.

mod csv;
mod table;
mod validate;

pub(crate) use csv::{BOUNDARIES_FILE, ENERGY_FILE, GROUND_LEFT_FILE, HEIGHT_MAP_FILE, rut_name};
pub use csv::{
    HistoryFiles, HistoryNames, filtered_name, forces_name, joint_name, part_name, read_history, rim_name,
};
pub use csv::{read_rims, write_filtered, write_ground, write_rims};
pub use table::Table;
pub use table::push_line;
pub use validate::validate_history;
