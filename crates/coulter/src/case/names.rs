//! Names that are reserved, and names that were probably meant.

/// Whether Windows reserves a name for a device: no file or folder there can have it.
pub(super) fn is_device(name: &str) -> bool {
    let upper = name.to_ascii_uppercase();
    let numbered =
        |kind: &str| upper.strip_prefix(kind).is_some_and(|n| n.len() == 1 && ("1"..="9").contains(&n));
    ["CON", "PRN", "AUX", "NUL"].contains(&upper.as_str()) || numbered("COM") || numbered("LPT")
}

/// The candidate that is most similar to `typed`, if any is similar.
pub(super) fn nearest<'a>(typed: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let lower = typed.to_lowercase();
    candidates
        .map(|name| (strsim::jaro_winkler(&lower, &name.to_lowercase()), name))
        .filter(|(likeness, _)| *likeness > 0.7)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, name)| name)
}
