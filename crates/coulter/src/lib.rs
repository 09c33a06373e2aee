//! From case file to report: the public API of the library.

pub mod bench;
pub mod blocks;
pub mod case;
pub mod confidence;
mod domain;
pub mod element;
pub mod forecast;
pub mod formats;
mod ground_column;
pub mod history;
pub mod interrupts;
pub mod mesh_study;
pub mod output;
pub mod printed;
mod readable;
pub mod run;
pub mod simulation;
mod stages;
mod text;
pub mod trust;
