//! Soil and contact parameters from measured curves: posterior distributions by closed-form models, or by the
//! solver through a surrogate of its curves.

mod calibrate;
mod closed;
mod data;
mod design_file;
mod document;
mod emulated;
mod fit;
mod interruptible;
mod likelihood;
mod page;
mod posterior;
mod prior;
mod runs;
mod sampler;
mod solver_stage;
mod space;
mod stage;
mod surrogate;

pub use calibrate::{Calibration, CalibrationError, ModelChoice, Request, calibrate};
pub use closed::{ClosedResponse, NoClosedForm};
pub use data::{Judge, MeasuredCurve, Selection, Taken};
pub use design_file::read_design;
pub use document::{correlations, document, parameters, runs_csv, samples_csv, text};
pub use likelihood::{Likelihood, Noise, Response, Seen};
pub use page::page;
pub use posterior::{Advice, Marginal, Posterior};
pub use prior::Prior;
pub use runs::{RunOutcome, Solver, SolverError, SolverPoint};
pub use sampler::Chains;
pub use solver_stage::{Plan, SolverStage, calibrate_solver, least_budget};
pub use space::{Link, Space, Unknown, rounded};
pub use stage::{Band, Effort, Stage, calibrate_response};
pub use surrogate::Surrogate;
