//! The version of the case-file format, and the names that have changed since the version before.

use input::problem::Problems;
use input::tree::Value;

/// Version of the case-file format that this program reads and writes.
pub const FORMAT: u32 = 2;

/// A key that has a new name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RenamedKey {
    /// Section of the renamed key: `soil`, or `body` for `[body.NAME]`.
    pub section: &'static str,
    /// Old name of the key.
    pub old: &'static str,
    /// Name of the key today.
    pub new: &'static str,
}

/// A word that has been replaced as the value of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RenamedValue {
    /// Section of the key.
    pub section: &'static str,
    /// The key.
    pub key: &'static str,
    /// Word in format 1.
    pub old: &'static str,
    /// Word in format 2.
    pub new: &'static str,
}

const fn key(section: &'static str, old: &'static str, new: &'static str) -> RenamedKey {
    RenamedKey { section, old, new }
}

/// Every key that has a new name since format 1, or since format 2 was begun.
pub const RENAMED_KEYS: [RenamedKey; 10] = [
    key("soil", "rest_pressure_ratio", "k0"),
    key("soil", "tension_limit", "tension_cutoff"),
    key("output", "steady_share", "steady_fraction"),
    key("forecast", "plate", "terrain"),
    key("forecast", "plate_exponent", "sinkage_exponent"),
    key("forecast", "plate_cohesive", "cohesive_modulus"),
    key("forecast", "plate_frictional", "frictional_modulus"),
    key("forecast", "shear_displacement", "shear_deformation_modulus"),
    key("forecast", "heap", "bow_wave"),
    key("body", "orientation", "pitch"),
];

/// Every word that has been replaced since format 1.
pub const RENAMED_VALUES: [RenamedValue; 1] =
    [RenamedValue { section: "body", key: "shape", old: "ball", new: "sphere" }];

/// The new name of a key of the section at `path` (`soil`, `body.disc`), if it was renamed.
pub(super) fn new_key(path: &str, old: &str) -> Option<&'static str> {
    let section = path.split('.').next().unwrap_or_default();
    RENAMED_KEYS.iter().find(|r| r.section == section && r.old == old).map(|r| r.new)
}

/// The new word for a value of the key at `path` (`body.disc.shape`), if it was replaced.
pub(super) fn new_value(path: &str, old: &str) -> Option<&'static str> {
    let (section, key) = (path.split('.').next()?, path.rsplit('.').next()?);
    RENAMED_VALUES.iter().find(|r| r.section == section && r.key == key && r.old == old).map(|r| r.new)
}

/// The new name of a key as typed on the command line, with or without its section, if it was renamed.
pub fn new_name(typed: &str) -> Option<String> {
    let (section, old) = typed.rsplit_once('.').unwrap_or(("", typed));
    let found = RENAMED_KEYS.iter().find(|r| r.old == old && (section.is_empty() || r.section == section))?;
    Some(if section.is_empty() { found.new.to_owned() } else { format!("{section}.{}", found.new) })
}

/// Reports a file that does not say in which format it is written; studies are written in that of their
/// cases.
pub(super) fn missing(problems: &mut Problems) {
    problems.add(
        "format",
        "`format` is missing: the file does not say in which version of the case-file format it is written",
        format!("add  format = {FORMAT}  at the top of the file, before the first section"),
    );
}

/// Reports a format that this program does not read.
pub(super) fn check(node: &Value, problems: &mut Problems) {
    let (message, cure) = match *node {
        Value::Integer(version) if version == i64::from(FORMAT) => return,
        Value::Integer(version) if version > i64::from(FORMAT) => (
            format!("format = {version} is newer than this version of Coulter, which reads format {FORMAT}"),
            "install a newer version of Coulter".to_owned(),
        ),
        Value::Integer(1) => (
            format!("format = 1 is no longer read; this version of Coulter reads format {FORMAT}"),
            format!("write  format = {FORMAT}  and rename the keys that are reported besides, if any"),
        ),
        Value::Integer(version) => (
            format!("there is no format {version}; this version of Coulter reads format {FORMAT}"),
            format!("write  format = {FORMAT}"),
        ),
        _ => (
            format!("format: expected a whole number, found {}", node.kind()),
            format!("write  format = {FORMAT}"),
        ),
    };
    problems.add("format", message, cure);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{keys, parse};
    use input::CaseError;

    const TOWED_DISC: &str = include_str!("../../../cases/light_disc.toml");

    /// What is wrong with the towed disc when `old` is replaced by `new`.
    fn refused(old: &str, new: &str, overrides: &[String]) -> CaseError {
        assert!(TOWED_DISC.contains(old), "the case does not contain `{old}`");
        parse(&TOWED_DISC.replacen(old, new, 1), "case.toml", overrides).unwrap_err()
    }

    /// The problem whose message and cure contain these words.
    #[track_caller]
    fn problem_line(error: &CaseError, message: &[&str], cure: &str) -> usize {
        let fits = |p: &&input::LocatedProblem| {
            message.iter().all(|word| p.message.contains(word)) && p.cure.contains(cure)
        };
        error.problems.iter().find(fits).unwrap_or_else(|| panic!("{error:?}")).line
    }

    fn line_of(text: &str, part: &str) -> usize {
        text[..text.find(part).unwrap()].matches('\n').count() + 1
    }

    #[test]
    fn every_renamed_key_is_refused_with_its_new_name_and_line() {
        for RenamedKey { section, old, new } in RENAMED_KEYS {
            let path = if section == "body" { "body.disc" } else { section };
            let (heading, known) = (format!("[{path}]"), keys::find(section).unwrap().keys);
            assert!(known.iter().any(|k| k.name == new) && !known.iter().any(|k| k.name == old), "{new}");
            let text = if TOWED_DISC.contains(&heading) {
                TOWED_DISC.replacen(&heading, &format!("{heading}\n{old} = 1"), 1)
            } else {
                format!("{TOWED_DISC}\n{heading}\n{old} = 1\n")
            };
            let error = parse(&text, "case.toml", &[]).unwrap_err();
            let line = problem_line(&error, &[&format!("`{path}.{old}`"), &format!("`{path}.{new}`")], new);
            assert_eq!(line, line_of(&text, &format!("{old} = 1")), "{old}");
            // The constants of `[forecast]` belong together: the others are missing then.
            assert!(
                error.problems.len() == 1 || section == "forecast",
                "{old}: nothing else is wrong: {error:?}"
            );
            let set = parse(TOWED_DISC, "case.toml", &[format!("{path}.{old}=1")]).unwrap_err();
            problem_line(&set, &[&format!("`{path}.{new}`")], new);
            assert_eq!(new_name(old).as_deref(), Some(new));
            assert_eq!(new_name(&format!("{section}.{old}")), Some(format!("{section}.{new}")));
        }
        assert_eq!((new_name("soil.cohesion"), new_name("output.plate")), (None, None));
    }

    #[test]
    fn every_replaced_word_is_refused_with_the_new_one_and_line() {
        for RenamedValue { section, key, old, new } in RENAMED_VALUES {
            let path = if section == "body" { "body.disc" } else { section };
            let set = parse(TOWED_DISC, "case.toml", &[format!("{path}.{key}={old}")]).unwrap_err();
            problem_line(
                &set,
                &[&format!("{path}.{key}"), &format!("\"{old}\""), &format!("\"{new}\"")],
                new,
            );
        }
        let error = refused("shape = \"disc\"", "shape = \"ball\"", &[]);
        assert_eq!(
            problem_line(&error, &["\"ball\"", "\"sphere\""], "sphere"),
            line_of(TOWED_DISC, "shape =")
        );
    }

    #[test]
    fn a_file_without_its_format_is_refused_with_the_line_to_add() {
        let error = refused("format = 2\n", "", &[]);
        assert_eq!(problem_line(&error, &["`format` is missing"], "format = 2"), 1);
        assert_eq!(error.problems.len(), 1);
        let old =
            TOWED_DISC.replace("format = 2\n", "").replacen("[soil]", "[soil]\ntension_limit = \"0 Pa\"", 1);
        let error = parse(&old, "case.toml", &[]).unwrap_err();
        problem_line(&error, &["`format` is missing"], "format = 2");
        problem_line(&error, &["`soil.tension_limit`", "`soil.tension_cutoff`"], "tension_cutoff");
    }

    #[test]
    fn another_format_is_refused_with_this_one() {
        let line = line_of(TOWED_DISC, "format =");
        for (typed, words, cure) in [
            ("1", "no longer read", "rename the keys"),
            ("3", "newer than this version", "newer version of Coulter"),
            ("0", "there is no format 0", "format = 2"),
            ("-2", "there is no format -2", "format = 2"),
            ("2.0", "expected a whole number, found a number", "format = 2"),
            ("\"2\"", "expected a whole number, found text", "format = 2"),
        ] {
            let error = refused("format = 2", &format!("format = {typed}"), &[]);
            assert_eq!(problem_line(&error, &[words], cure), line, "{typed}");
        }
        let set = refused("format = 2", "format = 2", &["format=3".to_owned()]);
        problem_line(&set, &["newer than this version"], "newer version of Coulter");
    }
}
