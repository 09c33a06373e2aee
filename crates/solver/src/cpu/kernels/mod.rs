//! The vectorised loops over cells and nodes: the only code that is compiled for each precision.
//!
//! Every file here is written for fields of the type `Real` and included twice, by [`double`] and by
//! [`single`].
// The same files on purpose; conversions that widen a number in single precision do nothing in double.
#![allow(clippy::duplicate_mod, clippy::useless_conversion)]

pub(crate) mod double;
pub(crate) mod single;
