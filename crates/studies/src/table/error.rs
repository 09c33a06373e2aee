//! What keeps a table from being written or read.

/// Why a table cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum TableError {
    /// A CSV text that is damaged.
    #[error("the table is not CSV as it should be: {0}")]
    Csv(#[from] csv::Error),
    /// A cell that should be a number.
    #[error(
        "line {line}, column `{column}`: `{text}` is not a number; leave the cell empty where a value is missing"
    )]
    Number {
        /// Line of the file, from 1.
        line: usize,
        /// Header of the column.
        column: String,
        /// The text of the cell.
        text: String,
    },
    /// Two columns of one name.
    #[error("two columns are called `{0}`: each needs a name of its own")]
    SameName(String),
    /// Columns of different length.
    #[error("column `{0}` has another number of rows than the first")]
    Length(String),
    /// Parquet data that are damaged.
    #[error("the Parquet data cannot be written or read: {0}")]
    Parquet(#[from] parquet::errors::ParquetError),
    /// Parquet data with a column of another kind than numbers and words.
    #[error("column `{0}` of the Parquet data holds neither 64-bit numbers nor words")]
    Kind(String),
    /// The description of the columns in Parquet data is damaged.
    #[error("what the Parquet data say of their columns is damaged: {0}")]
    Description(#[from] serde_json::Error),
}
