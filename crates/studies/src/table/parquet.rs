//! Tables as Parquet data: a column of optional 64-bit numbers or of words for each column, named by its CSV
//! header.
//!
//! The key-value entry `coulter.columns` of the file says of each column its name, unit, label and role, as
//! JSON. Without it columns are read as those of a CSV file are. The same table gives the same bytes.

use super::checks::check;
use super::error::TableError;
use super::header::split;
use super::{Column, Role, Table, Values};
use bytes::Bytes;
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::column::reader::ColumnReader;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{Type, TypePtr};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Key of the description of the columns.
const DESCRIPTION: &str = "coulter.columns";

/// What the file says of a column besides its values.
#[derive(Debug, Deserialize, Serialize)]
struct Described {
    name: String,
    unit: String,
    label: String,
    role: String,
}

/// The table as the bytes of a Parquet file, with Snappy compression.
///
/// # Errors
/// [`TableError`] for columns of one name or of different length.
pub fn to_parquet(table: &Table) -> Result<Vec<u8>, TableError> {
    check(table)?;
    let fields = table.columns.iter().map(field).collect::<Result<Vec<TypePtr>, _>>()?;
    let schema = Type::group_type_builder("study").with_fields(fields).build()?;
    let description = table.columns.iter().map(described).collect::<Vec<_>>();
    let entry = KeyValue::new(DESCRIPTION.to_owned(), serde_json::to_string(&description)?);
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_created_by("coulter".to_owned())
        .set_key_value_metadata(Some(vec![entry]));
    let mut bytes = Vec::new();
    let mut writer = SerializedFileWriter::new(&mut bytes, Arc::new(schema), Arc::new(properties.build()))?;
    let mut rows = writer.next_row_group()?;
    for column in &table.columns {
        let Some(mut place) = rows.next_column()? else { break };
        match &column.values {
            Values::Numbers(list) => {
                let (levels, present) = levels(list);
                place.typed::<DoubleType>().write_batch(&present, Some(&levels), None)?;
            }
            Values::Words(list) => {
                let (levels, present) = levels(list);
                let present: Vec<ByteArray> =
                    present.iter().map(|word| ByteArray::from(word.as_str())).collect();
                place.typed::<ByteArrayType>().write_batch(&present, Some(&levels), None)?;
            }
        }
        place.close()?;
    }
    rows.close()?;
    writer.close()?;
    Ok(bytes)
}

/// The table of the bytes of a Parquet file.
///
/// # Errors
/// [`TableError`] for damaged data, and for columns that are neither 64-bit numbers nor words, or nested.
pub fn from_parquet(bytes: Vec<u8>) -> Result<Table, TableError> {
    let reader = SerializedFileReader::new(Bytes::from(bytes))?;
    let file = reader.metadata().file_metadata();
    let entries = file.key_value_metadata().into_iter().flatten();
    let mut description = Vec::new();
    if let Some(text) =
        entries.filter(|entry| entry.key == DESCRIPTION).find_map(|entry| entry.value.as_ref())
    {
        description = serde_json::from_str::<Vec<Described>>(text)?;
    }
    let headers: Vec<String> =
        file.schema().get_fields().iter().map(|field| field.name().to_owned()).collect();
    let mut table = Table::default();
    for (n, header) in headers.iter().enumerate() {
        let mut values = None;
        for group in 0..reader.num_row_groups() {
            let group = reader.get_row_group(group)?;
            let rows = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
            let more = read(group.get_column_reader(n)?, rows, header)?;
            values = Some(values.map_or(more.clone(), |before| joined(before, more)));
        }
        let is_words = file.schema_descr().column(n).physical_type() == Physical::BYTE_ARRAY;
        let none = if is_words { Values::Words(Vec::new()) } else { Values::Numbers(Vec::new()) };
        table.columns.push(named(header, description.get(n), values.unwrap_or(none)));
    }
    check(&table)?;
    Ok(table)
}

/// The field of a column: an optional number, or an optional word in UTF-8.
fn field(column: &Column) -> Result<TypePtr, TableError> {
    let header = column.header();
    let field = match &column.values {
        Values::Numbers(_) => Type::primitive_type_builder(&header, Physical::DOUBLE),
        Values::Words(_) => Type::primitive_type_builder(&header, Physical::BYTE_ARRAY)
            .with_logical_type(Some(LogicalType::String)),
    };
    Ok(Arc::new(field.with_repetition(Repetition::OPTIONAL).build()?))
}

/// 1 for each value that is present and 0 for each that is missing; and those that are present.
fn levels<T: Clone>(list: &[Option<T>]) -> (Vec<i16>, Vec<T>) {
    let levels = list.iter().map(|value| i16::from(value.is_some())).collect();
    (levels, list.iter().flatten().cloned().collect())
}

/// The values of a column of a group of rows.
fn read(reader: ColumnReader, rows: usize, header: &str) -> Result<Values, TableError> {
    let mut levels = Vec::new();
    match reader {
        ColumnReader::DoubleColumnReader(mut reader) => {
            let mut present = Vec::new();
            reader.read_records(rows, Some(&mut levels), None, &mut present)?;
            Ok(Values::Numbers(spread(&levels, present, rows)))
        }
        ColumnReader::ByteArrayColumnReader(mut reader) => {
            let mut present = Vec::new();
            reader.read_records(rows, Some(&mut levels), None, &mut present)?;
            let word = |bytes: &ByteArray| String::from_utf8_lossy(bytes.data()).into_owned();
            Ok(Values::Words(spread(&levels, present.iter().map(word).collect(), rows)))
        }
        _ => Err(TableError::Kind(header.to_owned())),
    }
}

/// Values with gaps where the level is zero; without levels none is missing.
fn spread<T>(levels: &[i16], present: Vec<T>, rows: usize) -> Vec<Option<T>> {
    if levels.is_empty() {
        return present.into_iter().map(Some).take(rows).collect();
    }
    let mut present = present.into_iter();
    levels.iter().map(|level| if *level > 0 { present.next() } else { None }).collect()
}

fn joined(before: Values, more: Values) -> Values {
    match (before, more) {
        (Values::Numbers(a), Values::Numbers(b)) => Values::Numbers([a, b].concat()),
        (Values::Words(a), Values::Words(b)) => Values::Words([a, b].concat()),
        // A column is of one kind throughout the file.
        (before, _) => before,
    }
}

fn described(column: &Column) -> Described {
    let role = match column.role {
        Role::Key => "key",
        Role::Factor => "factor",
        Role::Response => "response",
        Role::Remark => "remark",
    };
    let (name, unit, label) = (column.name.clone(), column.unit.clone(), column.label.clone());
    Described { name, unit, label, role: role.to_owned() }
}

/// A column as it is described, or as its header says.
fn named(header: &str, described: Option<&Described>, values: Values) -> Column {
    let role = match described.map(|described| described.role.as_str()) {
        Some("key") => Role::Key,
        Some("factor") => Role::Factor,
        Some("response") => Role::Response,
        _ => Role::Remark,
    };
    let (name, unit) = split(header);
    let text = |part: fn(&Described) -> &String, else_: &str| described.map_or(else_, |d| part(d)).to_owned();
    Column {
        name: text(|d| &d.name, name),
        unit: text(|d| &d.unit, unit),
        label: text(|d| &d.label, name),
        role,
        values,
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::table;
    use super::*;

    #[test]
    fn a_table_is_read_back_and_its_bytes_are_always_the_same() {
        let table = table();
        let bytes = to_parquet(&table).unwrap();
        assert_eq!(bytes, to_parquet(&table).unwrap());
        assert_eq!(from_parquet(bytes).unwrap(), table);
    }

    #[test]
    fn long_and_empty_tables_are_read_back() {
        let column = |name: &str, values| Column { name: name.into(), values, ..table().columns[3].clone() };
        let many: Vec<Option<f64>> = (0..5000).map(|n| (n % 7 > 0).then_some(f64::from(n).sqrt())).collect();
        let none = vec![None; 5000];
        let long =
            Table { columns: vec![column("a", Values::Numbers(many)), column("b", Values::Numbers(none))] };
        assert_eq!(from_parquet(to_parquet(&long).unwrap()).unwrap(), long);
        let empty = Table { columns: vec![column("a", Values::Numbers(vec![]))] };
        assert_eq!(from_parquet(to_parquet(&empty).unwrap()).unwrap(), empty);
        assert!(from_parquet(to_parquet(&Table::default()).unwrap()).unwrap().columns.is_empty());
    }

    #[test]
    fn damaged_data_are_refused() {
        let mut bytes = to_parquet(&table()).unwrap();
        bytes.truncate(bytes.len() / 2);
        assert!(from_parquet(bytes).is_err() && from_parquet(Vec::new()).is_err());
        let mut twice = table();
        twice.columns.push(twice.columns[0].clone());
        assert!(matches!(to_parquet(&twice), Err(TableError::SameName(_))));
    }
}
