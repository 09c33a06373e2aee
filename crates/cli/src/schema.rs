//! `coulter schema`: the JSON schema of case files and of study files.

use crate::common::say;
use crate::failure::Failure;
use coulter::case::json_schema;
use studies::study::schema as of_study;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The schema of study files
    #[arg(long)]
    study: bool,
}

pub(super) fn schema(arguments: &Arguments) -> Result<(), Failure> {
    say(&if arguments.study { of_study::text() } else { json_schema::text() })
}
