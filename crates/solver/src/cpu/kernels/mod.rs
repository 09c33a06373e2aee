//! The loops over cells and nodes that vectorise: the only code that is compiled for each precision.
//!
//! Every file here is written for fields of the type `Real` and taken in twice, by [`double`] and by [`single`].
// The same files on purpose; what widens a number in single precision does nothing in double.
#![allow(clippy::duplicate_mod, clippy::useless_conversion)]

pub(crate) mod double;
pub(crate) mod single;
