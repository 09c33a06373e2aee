//! What a key is: name, kind, default, range, usual range and meaning, and the place of its value.

pub(in crate::case) mod allowed_range;
mod declaration;
mod default_value;
mod key_of;
pub(in crate::case) mod usual_range;
pub mod words;

pub use allowed_range::{AllowedRange, Bound};
pub use declaration::{Key, KeyTable, Kind, key, section};
pub use default_value::DefaultValue;
pub(in crate::case) use key_of::{
    KeyOf, Numbers, Place, count, declared, in_ranges, joined, numbers, read, required,
};
pub use usual_range::UsualRange;
