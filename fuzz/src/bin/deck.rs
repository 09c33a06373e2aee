//! Input decks of Abaqus, and the cases that are made of them.
#![no_main]

use coulter::case;
use coulter_fuzz::show;
use coulter_import::{Units, import};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let text = String::from_utf8_lossy(data);
    let read = deck::read_with(&text, "deck.inp", |_| Err("there is no such file".to_owned()));
    let units: Units = "m-kg-s".parse().expect("these are units");
    let units = (!data.len().is_multiple_of(4)).then_some(&units);
    let entries = match import(&read, units, "case") {
        Ok(made) => {
            // The files that it names are not there.
            if let Err(error) = case::parse(&made.case, "case.toml", &[]) {
                show(&error);
            }
            made.entries
        }
        Err(refused) => refused.entries,
    };
    assert_eq!(entries.len(), read.blocks.len(), "a keyword without an entry");
});
