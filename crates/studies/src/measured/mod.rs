//! Measured curves from tables, and the records that measurements, runs and models have in common.
//!
//! A file is a table in any usual dialect ([`coulter::case::table_file`]) whose header names every column
//! with its unit, `sinkage [mm],vertical [N]`. Whatever is wrong is refused with its line, its column and a
//! cure; what is left out is a remark.

mod choice;
mod header;
mod quantity;
mod read;
mod record;
mod signs;

pub use choice::ColumnChoice;
pub use quantity::Quantity;
pub use read::{MAX_BYTES, parse, read};
pub use record::{Channel, Group, Record};
pub use signs::{settle_force, sign_of};

/// Refuses choices that speak of no column of any record that was read from a file.
///
/// # Errors
/// Which, and what the columns are called.
pub fn refuse_unused<'a>(
    choices: &[ColumnChoice],
    records: impl Iterator<Item = &'a Record> + Clone,
) -> Result<(), String> {
    for choice in choices {
        let mut titles = records.clone().flat_map(|record| &record.titles).enumerate();
        if !titles.any(|(_, title)| choice.is_titled(title)) && choice.column().parse::<usize>().is_err() {
            let all: Vec<String> = records
                .clone()
                .flat_map(|record| &record.titles)
                .map(|title| format!("\"{title}\""))
                .collect();
            return Err(format!(
                "--column {}: no measured file has such a column; their columns are {}",
                choice.column(),
                if all.is_empty() { "none".to_owned() } else { all.join(", ") }
            ));
        }
    }
    Ok(())
}
