//! What a benchmark expects of its figures: the file `expected.toml` in its folder below `validation/`.

use crate::error::VerifyError;
use crate::expectation::{Expectation, Suite};
use serde::Deserialize;

/// What a benchmark expects.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expectations {
    /// Id of the benchmark: "B1".
    pub id: String,
    /// A short title.
    pub title: String,
    /// A few sentences for the documentation.
    pub about: String,
    /// What is expected of each figure.
    pub row: Vec<Expectation>,
}

impl Expectations {
    /// Reads a file; `name` is its path for messages.
    ///
    /// # Errors
    /// The path, the line, and what was expected there.
    pub fn read(name: &str, text: &str) -> Result<Self, String> {
        toml::from_str(text).map_err(|error| format!("{name}: {}", error.to_string().trim_end()))
    }

    /// What is expected of a quantity in a variant.
    ///
    /// # Errors
    /// [`VerifyError::Expectation`] if there is no such entry, or several.
    pub fn find(&self, case: &str, quantity: &str, suite: Suite) -> Result<&Expectation, VerifyError> {
        let mut found = self.row.iter().filter(|row| row.quantity == quantity && row.is_about(case, suite));
        match (found.next(), found.next()) {
            (Some(row), None) => Ok(row),
            (first, _) => {
                let count = if first.is_some() { "several entries" } else { "no entry" };
                Err(VerifyError::Expectation(format!(
                    "expected.toml of {} has {count} for `{case}`, `{quantity}` in the suite {suite:?}",
                    self.id
                )))
            }
        }
    }

    /// Whether a part of the suite contains a variant.
    #[must_use]
    pub fn contains(&self, case: &str, suite: Suite) -> bool {
        self.row.iter().any(|row| row.is_about(case, suite))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expectation::Target;
    use crate::row::Expected;

    fn row(lines: &str) -> Result<Expectations, String> {
        let head = "id = 'X'\ntitle = ''\nabout = ''\n[[row]]\ncases = ['a']\nquantity = 'q'\n";
        Expectations::read("validation/X/expected.toml", &format!("{head}{lines}"))
    }

    #[test]
    fn every_kind_of_expectation_is_read() {
        let target = |lines: &str| row(lines).unwrap().row.remove(0).target;
        assert_eq!(target("value = 2.0\nrelative = 0.1\nsource = 's'"), Target::Number(Expected::Value(2.0)));
        assert_eq!(
            target("at_least = 2.0\nabsolute = 0.0\nsource = 's'"),
            Target::Number(Expected::AtLeast(2.0))
        );
        assert_eq!(target("range = [1.0, 2.0]"), Target::Number(Expected::Between(1.0, 2.0)));
        assert_eq!(target("same_as = 'b'\nrelative = 0.1\nsource = 's'"), Target::SameAs("b".into()));
        assert_eq!(target(""), Target::Number(Expected::Nothing));
    }

    #[test]
    fn a_row_belongs_to_the_suites_that_list_its_case() {
        let read = row("fast = true\nrefine = ['b = *']").unwrap();
        assert!(read.find("a", "q", Suite::Full).is_ok() && read.find("a", "q", Suite::Fast).is_ok());
        assert!(read.contains("b = 8", Suite::Refine) && !read.contains("b = 8", Suite::Full));
        let why = read.find("c", "q", Suite::Full).unwrap_err().to_string();
        assert!(why.contains("expected.toml of X has no entry for `c`, `q`"), "{why}");
        assert!(row("fast = ['b']").unwrap().find("a", "q", Suite::Fast).is_err());
    }

    #[test]
    fn what_is_wrong_is_refused_with_file_line_and_what_was_expected() {
        for (lines, expected) in [
            ("value = 2.0", "`relative` or `absolute`"),
            ("relative = 0.1", "beside a tolerance"),
            ("value = 2.0\nrange = [1.0, 2.0]\nrelative = 0.1", "one of `value`"),
            ("value = 2.0\nrelative = 0.1\nabsolute = 0.1", "not both"),
            ("value = 2.0\nrelative = -0.1\nsource = 's'", "0 or more"),
            ("value = inf\nrelative = 0.1\nsource = 's'", "finite"),
            ("value = 2.0\nrelative = 0.1", "`source`"),
            ("range = [2.0, 1.0]", "lower end"),
            ("valu = 2.0", "unknown field `valu`"),
            ("fast = 1", "true or a list of cases"),
        ] {
            let why = row(lines).unwrap_err();
            assert!(why.starts_with("validation/X/expected.toml: ") && why.contains("line "), "{why}");
            assert!(why.contains(expected), "{why}");
        }
    }
}
