//! Designs of experiments and what is read off them: surrogates, Sobol indices, effects.

pub mod collapse;
mod data;
pub mod design;
pub mod effects;
mod error;
pub mod gaussian_process;
pub mod regression;
pub mod sobol_indices;
pub mod tornado;

pub use error::StatisticsError;
