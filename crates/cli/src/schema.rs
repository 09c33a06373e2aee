//! `coulter schema`: the JSON schema of case files.

use crate::common::say;
use crate::failure::Failure;
use coulter::case::json_schema;

pub(super) fn schema() -> Result<(), Failure> {
    say(&json_schema::text())
}
