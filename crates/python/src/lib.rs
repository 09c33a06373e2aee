//! `coulter._native`: what the Python package calls.
//!
//! Requests come as JSON and columns as bytes, so that names, defaults and checks of types stand once, in the
//! Python part of the package. Every call lets go of the interpreter's lock while it works, and honours
//! Ctrl-C.

mod attend;
mod check;
mod command;
mod failure;
mod follow;
mod forecast;
mod pool;
mod run;
mod session;
mod source;
mod sweep;

use pyo3::prelude::*;

/// The module.
#[pymodule]
fn _native(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("RESULTS_FORMAT", coulter::formats::RESULTS)?;
    module.add("Failure", module.py().get_type::<failure::NativeFailure>())?;
    module.add_class::<session::Session>()?;
    module.add_function(wrap_pyfunction!(check::check, module)?)?;
    module.add_function(wrap_pyfunction!(command::main, module)?)?;
    module.add_function(wrap_pyfunction!(follow::sample_columns, module)?)?;
    module.add_function(wrap_pyfunction!(forecast::forecast, module)?)?;
    module.add_function(wrap_pyfunction!(run::run, module)?)?;
    module.add_function(wrap_pyfunction!(sweep::sweep, module)?)?;
    Ok(())
}
