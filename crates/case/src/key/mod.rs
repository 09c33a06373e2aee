//! What the keys of several sections share: ranges, words, and what their reading needs.

pub(crate) mod allowed;
mod reading;
pub(crate) mod usual;
pub mod words;

pub(crate) use reading::{all, checked, in_order, in_range, missing, range, required};

/// The place of a number that only one variant of a field has.
macro_rules! part {
    ($field:ident, $variant:path, $number:ident) => {
        input::key::Place::Part(|whole| match &mut whole.$field {
            $variant { $number, .. } => Some($number),
            _ => None,
        })
    };
}
pub(crate) use part;
