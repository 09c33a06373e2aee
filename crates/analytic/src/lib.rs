//! What the textbooks predict, in closed form.
//!
//! This crate shares nothing with the solver but parameters: their agreement is a scientific claim only because of that.
