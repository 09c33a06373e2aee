//! What is said on the command line about a column: `--column "qc [MPa]"=pressure`.

use super::quantity::{Quantity, split_deviation};
use coulter::case::nearest;
use coulter::case::table_file::{TableColumn, plain_name};

/// What a column is, whatever its header says.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnChoice {
    /// The column: its title, its name without the unit, or its number.
    column: String,
    /// Meaning of the column; `None` to leave it out.
    pub(super) meaning: Option<ChosenMeaning>,
}

/// What a column was said to be.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ChosenMeaning {
    pub(super) quantity: Quantity,
    pub(super) is_deviation: bool,
    /// Unit of the column, where it is not that of the header.
    pub(super) unit: Option<String>,
    /// −1 of a column that counts the other way.
    pub(super) sign: f64,
}

const FORM: &str = "write it such as \"qc [MPa]\"=pressure, \"Fz\"=\"-vertical [N]\" of the other sign, or comment=- to leave the column out";

impl ColumnChoice {
    /// Reads `COLUMN=QUANTITY`, `COLUMN="QUANTITY [UNIT]"`, with a minus before the quantity for the other
    /// sign, or `COLUMN=-`.
    ///
    /// # Errors
    /// What is wrong, and what to write instead.
    pub fn parse(typed: &str) -> Result<Self, String> {
        let wrong = |why: String| format!("--column {typed}: {why}; {FORM}");
        let (column, meaning) = typed.rsplit_once('=').ok_or_else(|| wrong("no `=`".to_owned()))?;
        let [column, meaning] = [column, meaning].map(|part| part.trim().trim_matches('"').trim());
        if column.is_empty() || meaning.is_empty() {
            return Err(wrong("a name and a quantity are needed".to_owned()));
        }
        if matches!(meaning, "-" | "−" | "–") {
            return Ok(Self { column: column.to_owned(), meaning: None });
        }
        let (sign, rest) = match meaning.strip_prefix(['-', '−']) {
            Some(rest) => (-1.0, rest.trim()),
            None => (1.0, meaning),
        };
        let (name, unit) = match rest.split_once('[') {
            Some((name, unit)) => (name.trim(), unit.strip_suffix(']').map(str::trim)),
            None => (rest, None),
        };
        if rest.contains('[') && unit.is_none() {
            return Err(wrong("the bracket of the unit is open".to_owned()));
        }
        let (base, is_deviation) = split_deviation(name);
        let Some(quantity) = Quantity::named(base) else {
            let hint = match nearest(base, Quantity::names()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => format!(
                    "known are {}",
                    Quantity::all().map(Quantity::name).collect::<Vec<_>>().join(", ")
                ),
            };
            return Err(wrong(format!("`{base}` is not a quantity: {hint}")));
        };
        if let Some(unit) = unit {
            quantity.factor(unit).map_err(wrong)?;
        }
        let meaning = ChosenMeaning { quantity, is_deviation, unit: unit.map(str::to_owned), sign };
        Ok(Self { column: column.to_owned(), meaning: Some(meaning) })
    }

    /// Whether the choice speaks of a column, the `n`-th of its file.
    pub(super) fn is_of(&self, column: &TableColumn, n: usize) -> bool {
        self.is_titled(&column.title) || self.column == (n + 1).to_string()
    }

    /// Whether the choice speaks of a column of this title, with or without its unit.
    pub(super) fn is_titled(&self, title: &str) -> bool {
        let bare = title.split(['[', '(']).next().unwrap_or_default();
        let is = |name: &str| plain_name(name) == plain_name(&self.column) && !plain_name(name).is_empty();
        self.column == title || is(title) || is(bare)
    }

    /// The column as typed.
    #[must_use]
    pub fn column(&self) -> &str {
        &self.column
    }
}
