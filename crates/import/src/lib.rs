//! From an input deck of Abaqus to a case: the text of the case, the files that it names, and an account of
//! every keyword of the deck.
//!
//! [`import`] touches no file. What a case cannot represent is refused with line and reason; what it
//! represents by something else is said, and so is what is left out.

mod amplitude;
mod bodies;
mod body_keys;
mod box_keys;
mod case_text;
mod closed;
mod compose;
mod connectors;
mod contact;
mod eulerian;
mod facts;
mod fill;
mod frame;
mod gear;
mod gravity;
mod ground_keys;
mod hull;
mod joint_keys;
mod masses;
mod motion;
mod moves;
mod notes;
mod orient;
mod others;
mod parameters;
mod report;
mod rest;
mod shape;
mod soil;
mod springs;
mod stl;
mod units;
mod walls;
mod written_body;
mod zones;

pub use compose::import;
pub use report::{Imported, Refused};
pub use units::{Units, UnknownUnits};
