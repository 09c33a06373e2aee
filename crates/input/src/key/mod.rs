//! What a key is: name, kind, default, range, usual range and meaning, and the place of its value.

mod allowed_range;
mod declaration;
mod default_value;
mod key_of;
mod usual_range;

pub use allowed_range::{AllowedRange, Bound, from};
pub use declaration::{Key, KeyTable, Kind, key, section};
pub use default_value::DefaultValue;
pub use key_of::{KeyOf, Numbers, Place, count, declared, in_ranges, joined, numbers, read, required};
pub use usual_range::{UsualRange, usual};
