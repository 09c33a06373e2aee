//! A chart with its name and what is said of it.

/// A chart of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedChart {
    /// Name of the file of the chart, without ending: letters, digits and underscores.
    pub name: String,
    /// Title, which stands above the picture.
    pub title: String,
    /// Caption below the chart; may contain subscripts: `F_H`.
    pub caption: String,
    /// The picture as SVG text.
    pub svg: String,
}

/// A name made of parts, fit for a file.
pub(super) fn file_name(parts: &[&str]) -> String {
    let fit = |letter: char| if letter.is_ascii_alphanumeric() { letter.to_ascii_lowercase() } else { '_' };
    let parts: Vec<String> =
        parts.iter().filter(|part| !part.is_empty()).map(|part| part.chars().map(fit).collect()).collect();
    parts.join("_")
}
