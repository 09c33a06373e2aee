//! The files of element tests.

use super::plots::plots;
use crate::element::{ElementTests, columns, document};
use results::files::{Inside, OutputError, SUMMARY, make_folder, write_json, write_whole};
use results::tables::push_line;
use std::path::{Path, PathBuf};

/// Name of the file of the curves.
const CURVES: &str = "curves.csv";

/// Writes the files into `dir` and returns their paths. Existing files are replaced only with `force`.
///
/// # Errors
/// When one of the files exists already or cannot be written.
pub fn write_element_tests(
    dir: &Path,
    tests: &ElementTests,
    force: bool,
) -> Result<Vec<PathBuf>, OutputError> {
    let plots = plots(tests);
    let names = [CURVES, SUMMARY].into_iter().chain(plots.iter().map(|(name, _)| *name));
    let paths: Vec<PathBuf> = names.map(|name| dir.join(name)).collect();
    if !force && paths.iter().any(|path| Inside::at(path).exists()) {
        return Err(OutputError::Exists { path: dir.to_path_buf() });
    }
    make_folder(&Inside::of(dir, ""))?;
    write_whole(&Inside::of(dir, CURVES), curves(tests).as_bytes())?;
    write_json(&Inside::of(dir, SUMMARY), &document(tests))?;
    for (name, svg) in &plots {
        write_whole(&Inside::of(dir, name), svg.as_bytes())?;
    }
    Ok(paths)
}

/// A line for every point, specimen after specimen.
fn curves(tests: &ElementTests) -> String {
    let columns = columns(tests.kind);
    let names: Vec<&str> = columns.iter().map(|(name, _)| *name).collect();
    let mut text = format!("specimen [-],{}\n", names.join(","));
    for (number, tested) in tests.tested.iter().enumerate() {
        for point in &tested.course.points {
            let mut line = vec![(number + 1) as f64];
            line.extend(columns.iter().map(|(_, value)| value(tested, point)));
            push_line(&mut text, &line);
        }
    }
    text
}
