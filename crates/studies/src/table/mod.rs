//! A table of a study: named columns with units, of numbers or of words, each of which may be missing.

mod checks;
mod csv;
mod error;
mod header;
mod parquet;
#[cfg(test)]
mod samples;

pub use self::csv::{from_csv, to_csv};
pub use self::parquet::{from_parquet, to_parquet};
pub use error::TableError;

/// Role of a column in a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Name of a row: its number, its id.
    Key,
    /// A factor of the design, which was varied.
    Factor,
    /// A response: a result.
    Response,
    /// A remark on the row: its state, its grade, a reason.
    Remark,
}

/// The values of a column, one for each row.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Numbers in the unit of the column.
    Numbers(Vec<Option<f64>>),
    /// Words.
    Words(Vec<Option<String>>),
}

impl Values {
    /// The number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Numbers(list) => list.len(),
            Self::Words(list) => list.len(),
        }
    }

    /// Whether there are no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// A column.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name of the column in files, such as `drag` or `soil.friction_angle`.
    pub name: String,
    /// Unit of the column, such as `N` or `deg`; `-` for a plain number, empty for words.
    pub unit: String,
    /// Name of the column in charts, such as `drag F_H`.
    pub label: String,
    /// Role of the column.
    pub role: Role,
    /// Values of the column.
    pub values: Values,
}

impl Column {
    /// Header of the column in a CSV file: `drag [N]`, or the name alone for words.
    #[must_use]
    pub fn header(&self) -> String {
        if self.unit.is_empty() { self.name.clone() } else { format!("{} [{}]", self.name, self.unit) }
    }
}

/// Columns of equal length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The columns, in the order of the file.
    pub columns: Vec<Column>,
}

impl Table {
    /// The number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// The column of that name.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<&Column> {
        self.columns.iter().find(|column| column.name == name)
    }

    /// The numbers of the column of that name; `None` where there is none, or it holds words.
    #[must_use]
    pub fn numbers(&self, name: &str) -> Option<&[Option<f64>]> {
        match &self.column(name)?.values {
            Values::Numbers(list) => Some(list),
            Values::Words(_) => None,
        }
    }

    /// The words of the column of that name; `None` where there is none, or it holds numbers.
    #[must_use]
    pub fn words(&self, name: &str) -> Option<&[Option<String>]> {
        match &self.column(name)?.values {
            Values::Words(list) => Some(list),
            Values::Numbers(_) => None,
        }
    }

    /// Whether a row has the state `done`, or no column says. Figures of any other, such as those of a broken
    /// run, are shown and not used.
    #[must_use]
    pub fn is_done(&self, row: usize) -> bool {
        self.words("state").is_none_or(|states| states[row].as_deref() == Some(DONE))
    }

    /// The table without the responses of rows that are not done.
    #[must_use]
    pub(crate) fn without_unused(&self) -> Self {
        let done: Vec<bool> = (0..self.rows()).map(|row| self.is_done(row)).collect();
        let used = |column: &Column| match &column.values {
            Values::Numbers(list) if column.role == Role::Response => Column {
                values: Values::Numbers(
                    list.iter().zip(&done).map(|(value, done)| value.filter(|_| *done)).collect(),
                ),
                ..column.clone()
            },
            _ => column.clone(),
        };
        Self { columns: self.columns.iter().map(used).collect() }
    }
}

/// The state of a row whose figures may be used.
const DONE: &str = "done";
