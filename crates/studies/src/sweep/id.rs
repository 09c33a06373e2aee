//! The id of a case, which names its files and stands in scripts.

use serde::{Deserialize, Serialize};
use std::fmt;

/// The letter of what is evaluated, and a hash in sixteen hexadecimal digits. Nothing else is one, wherever
/// it is read from: it is safe in names of files and in scripts.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct CaseId(String);

/// Letters: a closed form, a run, a case that is not valid.
const LETTERS: [u8; 3] = *b"frx";

impl CaseId {
    /// The id of a closed form with this hash.
    pub(super) fn of_closed_form(hash: u64) -> Self {
        Self(format!("f{hash:016x}"))
    }

    /// The id of a run with this hash.
    pub(super) fn of_run(hash: u64) -> Self {
        Self(format!("r{hash:016x}"))
    }

    /// The id of a case that is not valid.
    pub(super) fn of_refused(hash: u64) -> Self {
        Self(format!("x{hash:016x}"))
    }

    /// Text of the id.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl TryFrom<String> for CaseId {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let is_digit = |c: &u8| matches!(c, b'0'..=b'9' | b'a'..=b'f');
        match text.as_bytes() {
            [letter, digits @ ..]
                if LETTERS.contains(letter) && digits.len() == 16 && digits.iter().all(is_digit) =>
            {
                Ok(Self(text))
            }
            _ => Err(format!("{text:?} is no id of a case (a letter and sixteen hexadecimal digits)")),
        }
    }
}

impl From<CaseId> for String {
    fn from(id: CaseId) -> Self {
        id.0
    }
}

impl fmt::Display for CaseId {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn only_what_this_makes_is_an_id() {
        for id in [CaseId::of_closed_form(0), CaseId::of_run(u64::MAX), CaseId::of_refused(7)] {
            assert_eq!(CaseId::try_from(id.to_string()), Ok(id));
        }
        let good = CaseId::of_run(1).to_string();
        let bad =
            ["", "../../evil", "/elsewhere", "x\nIDS\ntouch PWN", "a0000000000000001", "r000000000000000A"];
        let longer = ["", "0", "\n", "/", "\0"].map(|more| format!("{good}0{more}"));
        for text in bad.map(str::to_owned).into_iter().chain(longer) {
            assert!(CaseId::try_from(text.clone()).is_err(), "{text:?}");
            assert!(serde_json::from_value::<CaseId>(text.into()).is_err());
        }
    }

    proptest! {
        #[test]
        fn no_other_text_is_one(text in "\\PC{0,20}|[a-z0-9./\\n$'\"`{} -]{17}") {
            if let Ok(id) = CaseId::try_from(text.clone()) {
                prop_assert_eq!(id.as_str().len(), 17);
                prop_assert!(id.as_str().bytes().all(|c| c.is_ascii_digit() || c.is_ascii_lowercase()));
            }
        }
    }
}
