//! Tables: in every dialect, as motions, as measured curves, and those of studies.
#![no_main]

use coulter::case::CaseError;
use coulter_fuzz::{file, seed, show};
use input::motion_table;
use input::table_file::TableFile;
use libfuzzer_sys::fuzz_target;
use studies::measured;
use studies::table::{Role, from_csv, from_parquet, to_parquet};

/// A Parquet file, to begin from.
fn parquet() {
    let text = include_str!("../../corpus/table/study.csv");
    let table = from_csv(text, |_| Role::Factor).expect("the table is sound");
    seed("study.parquet", &to_parquet(&table).expect("it can be written"));
}

fuzz_target!(init: { parquet() }, |data: &[u8]| {
    if let Ok(table) = TableFile::read(data.to_vec()) {
        let all: Vec<usize> = (0..table.columns().len()).collect();
        let numbers = table.numbers(&all, "give a number");
        if numbers.problems.is_empty() {
            assert!(numbers.columns.iter().all(|column| column.len() == numbers.lines.len()));
        } else {
            show(&CaseError::in_text("table.csv", table.text(), numbers.problems));
        }
        let _ = (table.comments().count(), table.titles(), all.iter().filter(|n| table.is_text(**n)).count());
    }
    let path = file("table.csv", data);
    // One motion of six for each input: they differ by their words alone.
    let _ = motion_table::read(&path, data.len() % 6, data.len().is_multiple_of(2));
    if let Err(error) = measured::read(&path, &[]) {
        show(&error);
    }
    let _ = std::str::from_utf8(data).map(|text| from_csv(text, |_| Role::Response));
    let _ = from_parquet(data.to_vec());
});
