//! The version of the case-file format.

use input::problem::Problems;
use input::tree::Value;

/// Version of the case-file format that this program reads and writes.
pub const FORMAT: u32 = 2;

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

    use crate::parse;
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
    fn a_file_without_its_format_is_refused_with_the_line_to_add() {
        let error = refused("format = 2\n", "", &[]);
        assert_eq!(problem_line(&error, &["`format` is missing"], "format = 2"), 1);
        assert_eq!(error.problems.len(), 1);
    }

    #[test]
    fn another_format_is_refused_with_this_one() {
        let line = line_of(TOWED_DISC, "format =");
        for (typed, words, cure) in [
            ("1", "there is no format 1", "format = 2"),
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
