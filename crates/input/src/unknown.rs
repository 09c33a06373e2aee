//! The complaint about a key that does not exist.

use super::names::nearest;
use super::problem::Problems;
use super::tree::{Entry, join};

/// Reports an unknown key of the section at `path`, with the nearest of the `known` ones.
pub fn unknown<'a>(entry: &Entry, path: &str, known: impl Iterator<Item = &'a str>, problems: &mut Problems) {
    let known: Vec<&str> = known.collect();
    let location = if path.is_empty() { "at the top of the file".to_owned() } else { format!("in [{path}]") };
    let cure = match nearest(&entry.key, known.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("known here: {}", known.join(", ")),
    };
    problems.add_to_name(join(path, &entry.key), format!("unknown key `{}` {location}", entry.key), cure);
}
