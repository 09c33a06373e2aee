//! Runs that are stopped, killed, damaged or out of disk space, through the binary: nothing is lost, and
//! messages are right.
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

mod checkpoints;
mod confidence;
mod full_disk;
mod leftovers;
mod locks;
mod meshes;
mod reports;
mod sandbox;
mod signals;
mod verdicts;
