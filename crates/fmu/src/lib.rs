//! Cases as functional mock-up units (FMUs) for co-simulation by FMI 3.0: one file that any importer of the
//! standard drives, with the forces of the soil as its outputs (Modelica Association, *Functional Mock-up
//! Interface Specification 3.0*, 2022).
//!
//! [`export`] writes one; the functions of [`c_api`] are what an importer calls.

pub mod c_api;
mod description;
mod fmu;
mod instance;
mod package;
mod variables;

pub use fmu::{Fmu, FmuError};
pub use instance::{Instance, Refusal, Saved, Severity};
pub use package::{ExportError, MARK, export, library_name};
pub use variables::{Steered, UnknownSteering};
