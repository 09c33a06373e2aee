//! The page of a study: one self-contained HTML text, for light and dark screens and paper.

mod gaps;
mod html;
mod shown;

pub use gaps::{Gap, gaps};
pub use html::{Page, PageError, PageFigure, page};
