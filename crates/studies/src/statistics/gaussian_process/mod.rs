//! A surrogate of a response: a Gaussian process with a linear trend, for computed (deterministic) and for
//! noisy responses.
//!
//! y(x) = h(x)ᵀβ + z(x) + e with h = (1, x), a process z of covariance σ² c(x, x') and a nugget e of variance
//! σ² λ. The correlation c is Matérn's of order 5/2 with a length for each factor. σ², β, lengths and λ
//! follow from the data (restricted likelihood, with weak priors). Source: Rasmussen & Williams (2006),
//! *Gaussian Processes for Machine Learning*, chapters 2, 4 and 5.

mod correlation;
mod fit;
mod hyperparameters;
mod process;
mod projection;
mod scaling;

pub use fit::fit;
pub use process::{GaussianProcess, LEAST_PREDICTIVITY, Predicted};
