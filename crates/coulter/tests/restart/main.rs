//! Runs that are stopped, killed, damaged or short of room, through the binary: nothing is lost, and what is said is so.
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod checkpoints;
mod full_disk;
mod leftovers;
mod locks;
mod place;
mod reports;
mod signals;
mod verdicts;
