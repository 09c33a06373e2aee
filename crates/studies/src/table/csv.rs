//! Tables as CSV text (RFC 4180): a header of names with units, `drag [N]`, then a line for each row. A
//! missing value is an empty cell.
//!
//! Numbers have as many digits as bring back the same 64-bit number. Words that a spreadsheet would compute
//! have an apostrophe before them. Words have a header without a unit; a word of no letters is read back as
//! missing. Roles and labels are not written.

use super::checks::check;
use super::error::TableError;
use super::header::split;
use super::{Column, Role, Table, Values};
use coulter::printed::no_formula;

/// The table as CSV text; lines end with a line feed.
///
/// # Errors
/// [`TableError`] for columns of one name or of different length.
pub fn to_csv(table: &Table) -> Result<String, TableError> {
    check(table)?;
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(table.columns.iter().map(|column| no_formula(&column.header()).into_owned()))?;
    for row in 0..table.rows() {
        writer.write_record(table.columns.iter().map(|column| cell(&column.values, row)))?;
    }
    let bytes = writer.into_inner().map_err(|error| csv::Error::from(error.into_error()))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The table of a CSV text: columns with a unit hold numbers, all others words; labels are the names. `role`
/// says what a column of a name is.
///
/// # Errors
/// [`TableError`] for text that is not CSV, lines of different length, a cell under a unit that is not a
/// number, two columns of one name.
pub fn from_csv(text: &str, role: impl Fn(&str) -> Role) -> Result<Table, TableError> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let empty = |header: &str| {
        let (name, unit) = split(header);
        let values = if unit.is_empty() { Values::Words(Vec::new()) } else { Values::Numbers(Vec::new()) };
        Column { name: name.into(), unit: unit.into(), label: name.into(), role: role(name), values }
    };
    let mut table = Table { columns: reader.headers()?.iter().map(empty).collect() };
    for record in reader.records() {
        let record = record?;
        let line = record.position().map_or(0, |position| position.line() as usize);
        for (column, text) in table.columns.iter_mut().zip(&record) {
            let missing = text.is_empty();
            match &mut column.values {
                Values::Words(list) => list.push((!missing).then(|| text.to_owned())),
                Values::Numbers(list) if missing => list.push(None),
                Values::Numbers(list) => match text.trim().parse() {
                    Ok(number) => list.push(Some(number)),
                    Err(_) => {
                        let (column, text) = (column.header(), text.to_owned());
                        return Err(TableError::Number { line, column, text });
                    }
                },
            }
        }
    }
    check(&table)?;
    Ok(table)
}

fn cell(values: &Values, row: usize) -> String {
    match values {
        Values::Words(list) => {
            list[row].as_deref().map_or_else(String::new, |word| no_formula(word).into_owned())
        }
        Values::Numbers(list) => list[row].map(number).unwrap_or_default(),
    }
}

/// A number in the fewest digits that bring it back.
fn number(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || !value.is_finite() || (1e-5..1e16).contains(&size) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::table;
    use super::*;

    #[test]
    fn a_table_is_read_back_to_the_bit() {
        let table = table();
        let text = to_csv(&table).unwrap();
        assert!(
            text.starts_with("point [-],id,soil.friction_angle [deg],drag [N],state\n1,a,25,0.1,done\n"),
            "{text}"
        );
        let role = |name: &str| table.column(name).unwrap().role;
        let mut back = from_csv(&text, role).unwrap();
        for (column, original) in back.columns.iter_mut().zip(&table.columns) {
            column.label.clone_from(&original.label);
        }
        assert_eq!(back, table);
        assert_eq!(from_csv("a,b\n", |_| Role::Key).unwrap().rows(), 0);
    }

    #[test]
    fn damage_is_named() {
        let read = |text: &str| from_csv(text, |_| Role::Response).unwrap_err().to_string();
        assert!(read("a [N]\n1\nmany\n").contains("line 3, column `a [N]`: `many`"));
        assert!(read("a,b\n1\n").contains("CSV"));
        assert!(read("a,a\n1,2\n").contains("`a`"));
        let mut uneven = table();
        uneven.columns[2].values = Values::Numbers(vec![]);
        assert!(matches!(to_csv(&uneven), Err(TableError::Length(_))));
    }
}
