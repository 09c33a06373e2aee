//! `coulter schema`: the JSON schema of case files.

use super::common::say;
use super::failure::Failure;
use crate::case::json_schema;

pub(super) fn schema() -> Result<(), Failure> {
    say(&json_schema::text())
}
