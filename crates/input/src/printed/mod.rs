//! Text of others on its way to a terminal, a log, a page or a table: titles, names, cells and files may hold
//! characters that steer a terminal, change the order of what is read, or are computed by a spreadsheet.
//! Whatever is printed goes through [`plain`], and every cell of text that is written through [`text_cell`]
//! or [`no_formula`].

mod cell;
mod shown;

pub use cell::{no_formula, text_cell};
pub use shown::{is_hidden, masked, plain};
