//! Words of others, such as names of folders, in scripts: the only place that quotes them.

use std::fmt::Write as _;

/// A word of the POSIX shell.
pub(super) fn for_shell(text: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "/._-+:@%".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        text.to_owned()
    } else {
        format!("'{}'", text.replace('\'', r"'\''"))
    }
}

/// Text of a shell command of Snakemake, in which braces stand for names.
pub(super) fn for_snakemake(text: &str) -> String {
    text.replace('{', "{{").replace('}', "}}")
}

/// A string of Python.
pub(super) fn for_python(text: &str) -> String {
    let mut literal = String::from("\"");
    for c in text.chars() {
        // Writing to a string cannot fail.
        let _ = match c {
            '"' | '\\' => write!(literal, "\\{c}"),
            ' '..='~' => write!(literal, "{c}"),
            _ => write!(literal, "\\U{:08x}", u32::from(c)),
        };
    }
    literal + "\""
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn braces_and_strings_are_taken_as_they_are() {
        assert_eq!(for_snakemake("a {x} {{y"), "a {{x}} {{{{y");
        assert_eq!(for_python("a\"\\\n{é}"), r#""a\"\\\U0000000a{\U000000e9}""#);
        assert_eq!([for_shell("/a/b-1"), for_shell(""), for_shell("it's")], ["/a/b-1", "''", r"'it'\''s'"]);
    }

    #[cfg(unix)]
    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        /// A shell gives every word back as it was.
        #[test]
        fn a_shell_gets_the_word(words in proptest::collection::vec("[^\\x00]{0,12}|[$`'\"\\\\ \n;&|<>(){}*?~!#-]{0,12}", 1..6)) {
            let line = words.iter().map(|word| for_shell(word)).collect::<Vec<_>>().join(" ");
            let done = std::process::Command::new("sh").arg("-c").arg(format!("printf '%s\\0' {line}")).output().unwrap();
            let got = String::from_utf8(done.stdout).unwrap();
            let expected: String = words.iter().map(|word| format!("{word}\0")).collect();
            prop_assert_eq!(got, expected);
        }
    }
}
