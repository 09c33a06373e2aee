//! The cases of a study: expanded, run by whatever engine, and collected.
//!
//! A study has a folder. `cases.jsonl` lists its cases; each has an id, the hash of what it is, and an
//! outcome in a file of its own that appears whole or not at all. So cases may be run by several engines at
//! once, killed and run again.

mod assembly;
pub mod collect;
pub mod evaluate;
pub mod expand;
mod figures;
pub mod id;
pub mod line;
pub mod outcome;
mod part_rows;
pub mod pool;
mod quote;
pub mod report;
pub mod script;
pub mod store;
