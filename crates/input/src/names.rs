//! Names that are reserved, and names that were probably meant.

/// Whether Windows reserves a name for a device: no file or folder there can have it.
fn is_device(name: &str) -> bool {
    let upper = name.to_ascii_uppercase();
    let numbered =
        |kind: &str| upper.strip_prefix(kind).is_some_and(|n| n.len() == 1 && ("1"..="9").contains(&n));
    ["CON", "PRN", "AUX", "NUL"].contains(&upper.as_str()) || numbered("COM") || numbered("LPT")
}

/// Largest number of letters in the name of a case.
const MAX_LETTERS: usize = 100;

/// Whether a letter may stand in the name of a file on every system.
fn is_plain(letter: char) -> bool {
    letter.is_ascii_alphanumeric() || letter == '-' || letter == '_'
}

/// Whether a case may have this name, which becomes that of a folder.
pub fn is_case_name(name: &str) -> bool {
    is_body_name(name) && name.len() <= MAX_LETTERS
}

/// Whether a body may have this name, which becomes that of files.
pub fn is_body_name(name: &str) -> bool {
    !name.is_empty() && name.chars().all(is_plain) && !is_device(name)
}

/// A name for a case, from that of its file.
pub fn case_name(source_name: &str) -> String {
    let stem = std::path::Path::new(source_name)
        .file_stem()
        .map_or_else(String::new, |s| s.to_string_lossy().into());
    let plain: String = stem.chars().map(|c| if is_plain(c) { c } else { '-' }).take(MAX_LETTERS).collect();
    let plain = if is_device(&plain) { format!("{plain}-case") } else { plain };
    if plain.is_empty() { "case".to_owned() } else { plain }
}

/// The candidate that is most similar to `typed`, if any is similar.
#[must_use]
pub fn nearest<'a>(typed: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let lower = typed.to_lowercase();
    candidates
        .map(|name| (strsim::jaro_winkler(&lower, &name.to_lowercase()), name))
        .filter(|(likeness, _)| *likeness > 0.7)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, name)| name)
}
