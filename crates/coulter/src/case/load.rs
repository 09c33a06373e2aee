//! From the text of a case file, and overrides, to a case.

use super::problem::{CaseError, Problems, Source};
use super::resolved::Case;
use super::uncertainty::{self, StandardDeviation};
use super::{resolve, schema, tree};
use std::path::Path;

/// Reads the case file at `path`, with overrides such as `soil.friction_angle=38 deg`.
///
/// # Errors
/// [`CaseError`] holds everything that is wrong, with its location in the file.
pub fn load(path: &Path, overrides: &[String]) -> Result<Case, CaseError> {
    load_with_deviations(path, overrides).map(|(case, _)| case)
}

/// As [`load`], with the standard deviations that the file states, such as `"35 ± 2 deg"`; the case holds the means.
///
/// # Errors
/// As [`load`].
pub fn load_with_deviations(
    path: &Path,
    overrides: &[String],
) -> Result<(Case, Vec<StandardDeviation>), CaseError> {
    let name = path.display().to_string();
    let bytes = read(path).map_err(|error| unreadable(path, &name, &error))??;
    let text = String::from_utf8(bytes).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = valid.iter().filter(|b| **b == b'\n').count() + 1;
        let message = format!("{name}: not a text file: line {line} is not UTF-8");
        CaseError::unreadable(&name, message, "save the file as UTF-8 text")
    })?;
    parse_with_deviations(&text, &name, overrides)
}

/// Largest case file that is read [bytes]; the shipped ones have some 2 kB, 500 bodies some 150 kB.
const MAX_BYTES: u64 = 1 << 20;

/// The content of a case file. Anything but an ordinary file (a pipe, a device) could be endless and is refused.
fn read(path: &Path) -> std::io::Result<Result<Vec<u8>, CaseError>> {
    let (name, about) = (path.display().to_string(), std::fs::metadata(path)?);
    if !about.is_file() && !about.is_dir() {
        let message = format!("{name}: a pipe or a device, not a case file");
        return Ok(Err(CaseError::unreadable(&name, message, "write the case into an ordinary file")));
    }
    if about.is_file() && about.len() > MAX_BYTES {
        let message = format!(
            "{name}: too large for a case file: {} bytes, at most {MAX_BYTES} are allowed",
            about.len()
        );
        return Ok(Err(CaseError::unreadable(&name, message, "check the path: this may be another file")));
    }
    std::fs::read(path).map(Ok)
}

fn unreadable(path: &Path, name: &str, error: &std::io::Error) -> CaseError {
    if path.is_dir() {
        let cure = "name the case file in it, such as cases/towed_disc.toml";
        return CaseError::unreadable(name, format!("{name}: a directory, not a case file"), cure);
    }
    let cure = match error.kind() {
        std::io::ErrorKind::NotFound => {
            "check the path; `coulter new towed-disc` writes a case file to start from"
        }
        _ => "check that the file can be read",
    };
    CaseError::unreadable(name, format!("{name}: cannot be read: {error}"), cure)
}

/// Reads a case from its text; `source_name` is what to call it in messages.
///
/// # Errors
/// [`CaseError`] holds everything that is wrong, with its location in the text.
pub fn parse(text: &str, source_name: &str, overrides: &[String]) -> Result<Case, CaseError> {
    parse_with_deviations(text, source_name, overrides).map(|(case, _)| case)
}

pub(super) fn parse_with_deviations(
    text: &str,
    source_name: &str,
    overrides: &[String],
) -> Result<(Case, Vec<StandardDeviation>), CaseError> {
    let mut problems = Problems::new(Source { name: source_name.to_owned(), text: text.to_owned() });
    let mut root = tree::read(&mut problems, overrides);
    if !problems.is_empty() {
        return Err(problems.into_error());
    }
    if root.is_empty() {
        let message = format!("{source_name}: the case is empty");
        return Err(CaseError::unreadable(
            source_name,
            message,
            "`coulter new towed-disc` writes one to start from",
        ));
    }
    let deviations = uncertainty::separate(&mut root, &mut problems);
    let schema = schema::read(&root, &mut problems);
    match resolve::resolve(&schema, source_name, &mut problems) {
        Some(case) if problems.is_empty() => Ok((case, deviations)),
        _ => Err(problems.into_error()),
    }
}
