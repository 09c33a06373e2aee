//! Headers of columns in files: `drag [N]`.

/// Name and unit of a header.
pub(super) fn split(header: &str) -> (&str, &str) {
    let parts = header.strip_suffix(']').and_then(|rest| rest.rsplit_once(" ["));
    parts.filter(|(_, unit)| !unit.is_empty()).unwrap_or((header, ""))
}
