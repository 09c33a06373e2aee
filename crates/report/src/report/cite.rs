//! How to cite a run: what computed it, and which case.

use super::summary::Summary;
use results::folder::RunRecord;
use serde::Serialize;

/// Year of this version, as in the licence.
const YEAR: &str = "2026";

/// A citation in words and for BibTeX.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Citation {
    text: String,
    bibtex: String,
}

/// The citation of a run.
pub(super) fn citation(record: &RunRecord, summary: &Summary) -> Citation {
    let (authors, version, case) = (env!("CARGO_PKG_AUTHORS"), &summary.version, &record.case);
    let title = "Coulter: rigid bodies towed through soil by the coupled Eulerian–Lagrangian method";
    let hash = &record.case_hash;
    // A key has no blanks, commas or braces.
    let key: String = case.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '_' || *c == '-').collect();
    Citation {
        text: format!("{authors} ({YEAR}): {title}, version {version}; case {case}, hash {hash}."),
        bibtex: format!(
            "@software{{coulter_{key},\n  author  = {{{{{authors}}}}},\n  title   = {{{{{title}}}}},\n  version = {{{version}}},\n  \
             year    = {{{YEAR}}},\n  note    = {{Case {}, hash {hash}}}\n}}\n",
            case.replace('_', "\\_")
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_citation_names_version_case_and_hash_and_agrees_with_the_file() {
        let record =
            RunRecord { case: "towed_disc".into(), case_hash: "00ff".into(), ..RunRecord::default() };
        let made =
            citation(&record, &Summary { version: env!("CARGO_PKG_VERSION").into(), ..Summary::default() });
        assert!(
            made.bibtex.starts_with("@software{coulter_towed_disc,\n  author  = {{The Coulter developers}},")
        );
        assert_eq!(made.bibtex.matches('{').count(), made.bibtex.matches('}').count());
        assert!(made.text.contains("case towed_disc, hash 00ff"));
        let file = include_str!("../../../../CITATION.cff");
        for text in [
            format!("version: {}", env!("CARGO_PKG_VERSION")),
            format!("name: {}", env!("CARGO_PKG_AUTHORS")),
        ] {
            assert!(file.contains(&text), "CITATION.cff lacks {text}");
        }
        assert!(include_str!("../../../../LICENSE-MIT").contains(&format!("(c) {YEAR}")));
    }
}
