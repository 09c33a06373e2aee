//! Versions of what Coulter writes and reads again, and what is said of another one. That of case files is
//! [`case::FORMAT`], that of checkpoints is theirs.

/// Version of results folders: of `run.json` and `summary.json`.
pub const RESULTS: u32 = 3;
/// Version of the documents in JSON: what `--json` prints, and what forecasts, comparisons and calibrations
/// leave in their folders.
pub const DOCUMENT: u32 = 1;

/// Whether something of the version `found` can be read by a program that reads `known`; `what` it is, in the
/// plural.
///
/// # Errors
/// What is wrong and what to do: `again` says it of an older version, or of none.
pub fn check(found: Option<u64>, known: u32, what: &str, again: &str) -> Result<(), String> {
    match found {
        Some(found) if found == u64::from(known) => Ok(()),
        Some(found) if found > u64::from(known) => Err(format!(
            "format {found} of {what} is newer than this version of Coulter, which reads format {known}; install a newer \
             version of Coulter"
        )),
        Some(found) => Err(format!(
            "format {found} of {what} is no longer read; this version of Coulter reads format {known}; {again}"
        )),
        None => Err(format!(
            "it does not say in which format it is; this version of Coulter reads format {known} of {what}; {again}"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_version_is_refused_with_what_to_do() {
        let refused = |found| check(found, 2, "results", "run the case again").unwrap_err();
        assert_eq!(check(Some(2), 2, "results", ""), Ok(()));
        assert!(refused(Some(3)).contains("newer than this version") && refused(Some(3)).contains("install"));
        assert!(
            refused(Some(1)).contains("no longer read") && refused(Some(1)).contains("run the case again")
        );
        assert!(refused(None).contains("does not say") && refused(None).contains("run the case again"));
    }
}
