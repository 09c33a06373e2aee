//! Cells of text in files that spreadsheets open.

use std::borrow::Cow;

/// The text, which no spreadsheet computes: one that begins like a formula (`=`, `+`, `-`, `@`, a tab, a
/// carriage return) and is no number gets an apostrophe before it (the rule of OWASP, CSV Injection).
#[must_use]
pub fn no_formula(text: &str) -> Cow<'_, str> {
    if text.starts_with(['=', '+', '-', '@', '\t', '\r']) && text.parse::<f64>().is_err() {
        format!("'{text}").into()
    } else {
        text.into()
    }
}

/// The text as a cell of a CSV file (RFC 4180), and no formula.
#[must_use]
pub fn text_cell(text: &str) -> String {
    let text = no_formula(text);
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn formulas_are_text_and_numbers_stay() {
        for text in ["=HYPERLINK(1)", "+1+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1", "\r=1", "-5 deg"] {
            assert_eq!(no_formula(text), format!("'{text}"));
        }
        for text in ["-5", "+1e-3", "", "a=b", "towed-disc", "5 deg", "'=1"] {
            assert_eq!(no_formula(text), text);
        }
        assert_eq!(text_cell("=a,\"b\""), "\"'=a,\"\"b\"\"\"");
    }

    proptest! {
        #[test]
        fn a_cell_is_read_as_one(text in "[=+@,\"\n\r\ta-c1 -]{0,12}") {
            let line = format!("{},end\n", text_cell(&text));
            let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(line.as_bytes());
            let cells = reader.records().next().unwrap().unwrap();
            let expected = no_formula(&text);
            prop_assert_eq!(&cells[0], &*expected);
            prop_assert_eq!(cells.len(), 2);
        }
    }
}
