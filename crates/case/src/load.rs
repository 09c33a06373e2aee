//! From the text of a case file, and overrides, or from nested maps, to a case that has been checked.

use super::resolved::{Case, Soil};
use super::uncertainty::{self, StandardDeviation};
use super::validate::{validate, whole};
use super::{resolve, schema};
use input::error::CaseError;
use input::hidden;
use input::json_tree;
use input::problem::{Problem, Problems};
use input::toml_tree::{self, TomlTree};
use input::tree::{Entry, Value};
use std::path::Path;

/// Reads the case file at `path`, with overrides such as `soil.friction_angle=38 deg`.
///
/// # Errors
/// [`CaseError`] holds everything that is wrong, with its location in the file.
pub fn load(path: &Path, overrides: &[String]) -> Result<Case, CaseError> {
    parse(&text(path)?, &path.display().to_string(), overrides)
}

/// Loads a case as [`load`] does, for the closed-form models: with the standard deviations that the file
/// states, such as `"35 ± 2 deg"`, the case holding the means; and with any resolution of the grid and any
/// cost of a run, which do not matter to them.
///
/// # Errors
/// [`CaseError`] holds everything else that is wrong, with its location in the file.
pub fn load_for_forecast(
    path: &Path,
    overrides: &[String],
) -> Result<(Case, Vec<StandardDeviation>), CaseError> {
    let name = path.display().to_string();
    parse_with_deviations(&text(path)?, &name, overrides, Problems::without_resolution())
}

/// Loads a case as [`load_for_forecast`] does, from the text of a case file; `source_name` is what to call it
/// in messages.
///
/// # Errors
/// As [`load_for_forecast`].
pub fn parse_for_forecast(
    text: &str,
    source_name: &str,
    overrides: &[String],
) -> Result<(Case, Vec<StandardDeviation>), CaseError> {
    parse_with_deviations(text, source_name, overrides, Problems::without_resolution())
}

/// Reads the soil of the case file at `path`, and the name of the case. It needs no other section than
/// `[soil]`; those that it has are checked for their form only.
///
/// # Errors
/// As [`load`].
pub fn load_soil(path: &Path, overrides: &[String]) -> Result<(String, Soil), CaseError> {
    parse_soil(&text(path)?, &path.display().to_string(), overrides)
}

/// Loads a soil as [`load_soil`] does, from the text of a case file; `source_name` is what to call it in
/// messages.
///
/// # Errors
/// As [`load`].
pub fn parse_soil(text: &str, source_name: &str, overrides: &[String]) -> Result<(String, Soil), CaseError> {
    read_tree(text, source_name, overrides, build_soil)
}

/// The text of a case file, as typed.
///
/// # Errors
/// [`CaseError`] where it cannot be read or is not text.
pub fn text(path: &Path) -> Result<String, CaseError> {
    let name = path.display().to_string();
    let bytes = read(path).map_err(|error| unreadable(path, &name, &error))??;
    String::from_utf8(bytes).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = valid.iter().filter(|b| **b == b'\n').count() + 1;
        let message = format!("{name}: not a text file: line {line} is not UTF-8");
        CaseError::unreadable(&name, message, "save the file as UTF-8 text")
    })
}

/// Largest case file that is read [bytes]; the shipped ones have some 2 kB, 500 bodies some 150 kB.
const MAX_BYTES: u64 = 1 << 20;

/// The content of a case file. Anything but an ordinary file (a pipe, a device) could be endless and is
/// refused.
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

/// Reads a case from its text; `source_name` is what to call it in messages. Files that it names are looked
/// for in the folder of `source_name`, in the current one if that is not a path.
///
/// # Errors
/// [`CaseError`] holds everything that is wrong, with its location in the text.
pub fn parse(text: &str, source_name: &str, overrides: &[String]) -> Result<Case, CaseError> {
    parse_with_deviations(text, source_name, overrides, Problems::default()).map(|(case, _)| case)
}

/// Reads a case from nested maps, with the keys of a case file and the values as they are typed there:
/// `{"soil": {"cohesion": "2 kPa"}, …}`. Bodies are in the order of the map. `name` is what to call the case
/// in messages, and its name if it gives itself none; where it is a path, files that the case names are
/// looked for in its folder.
///
/// # Errors
/// [`CaseError`] holds everything that is wrong, each with the path of its key; there are no lines.
pub fn from_json(value: &serde_json::Value, name: &str) -> Result<Case, CaseError> {
    let tree = match json_tree::tree(value) {
        Value::Table(entries) => entries,
        other => {
            let message = format!("a case must be a table, not {}", other.kind());
            return Err(CaseError::unreadable(name, message, "give a map of its sections"));
        }
    };
    refuse_other(&tree, name)?;
    let hidden: Vec<Problem> = hidden::problems(&tree).into_iter().map(|(_, problem)| problem).collect();
    if !hidden.is_empty() {
        return Err(CaseError::new(name, hidden));
    }
    let (case, _) = build(tree, name, Problems::default())
        .map_err(|problems| CaseError::new(name, problems.into_list()))?;
    Ok(case)
}

pub(super) fn parse_with_deviations(
    text: &str,
    source_name: &str,
    overrides: &[String],
    collected: Problems,
) -> Result<(Case, Vec<StandardDeviation>), CaseError> {
    read_tree(text, source_name, overrides, |tree, name| build(tree, name, collected))
}

/// What `build` makes of the tree of a text; its problems get their places in the text.
fn read_tree<T>(
    text: &str,
    source_name: &str,
    overrides: &[String],
    build: impl FnOnce(Vec<Entry>, &str) -> Result<T, Problems>,
) -> Result<T, CaseError> {
    let TomlTree { tree, places, problems } = toml_tree::read(source_name, text, overrides);
    if !problems.is_empty() {
        return Err(places.error_at(problems));
    }
    refuse_other(&tree, source_name)?;
    build(tree, source_name).map_err(|problems| places.error(problems.into_aimed()))
}

/// Refuses a case that cannot be simulated, however it was made.
///
/// # Errors
/// [`CaseError`] holds everything that [`validate`] finds wrong with it.
pub fn require_valid(case: &Case) -> Result<(), CaseError> {
    let problems = validate(case);
    if problems.is_empty() { Ok(()) } else { Err(CaseError::new(&case.name, problems)) }
}

/// Refuses what is no case at all, before everything that it lacks.
fn refuse_other(tree: &[Entry], name: &str) -> Result<(), CaseError> {
    if tree.is_empty() {
        let message = format!("{name}: the case is empty");
        let cure = "`coulter new towed-disc` writes one to start from";
        return Err(CaseError::unreadable(name, message, cure));
    }
    let has = |key: &str| tree.iter().any(|entry| entry.key == key);
    if has("factor") && !has("soil") {
        let cure = format!("run it with  coulter sweep {name}");
        return Err(CaseError::unreadable(name, format!("{name}: this is a study, not a case"), &cure));
    }
    Ok(())
}

/// A case that has been checked, from its tree, whatever the tree was read from.
fn build(
    mut tree: Vec<Entry>,
    name: &str,
    mut problems: Problems,
) -> Result<(Case, Vec<StandardDeviation>), Problems> {
    let deviations = uncertainty::separate(&mut tree, &mut problems);
    let mut schema = schema::read(&tree, &mut problems);
    schema.lie_in(Path::new(name).parent().unwrap_or(Path::new("")));
    let case = resolve::resolve(&schema, name, &mut problems);
    if let Some(case) = &case {
        whole(case, &mut problems);
    }
    match case {
        Some(case) if problems.is_empty() => Ok((case, deviations)),
        _ => Err(problems),
    }
}

/// The name of a case and its soil, from its tree.
fn build_soil(mut tree: Vec<Entry>, name: &str) -> Result<(String, Soil), Problems> {
    let mut problems = Problems::default();
    uncertainty::separate(&mut tree, &mut problems);
    let schema = schema::read(&tree, &mut problems);
    match resolve::soil_alone(&schema, name, &mut problems) {
        Some(found) if problems.is_empty() => Ok(found),
        _ => Err(problems),
    }
}
