//! `coulter verify`: the verification suite.

use super::Failure;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Which benchmarks, such as A4 B1 [default: all]
    #[arg(value_name = "ID")]
    ids: Vec<String>,
    /// Only what takes seconds
    #[arg(long)]
    fast: bool,
    /// Print one JSON document
    #[arg(long)]
    json: bool,
}

pub(super) fn verify(arguments: &Arguments) -> Result<(), Failure> {
    let _ = (&arguments.ids, arguments.fast, arguments.json);
    Err(Failure::Request("`coulter verify` is not built yet".into()))
}
