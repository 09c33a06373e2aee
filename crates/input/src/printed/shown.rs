//! Characters that act on a terminal or on the direction of text, made visible.

use std::borrow::Cow;

/// Whether a character acts on a terminal or on the direction of text instead of being shown: controls, C1
/// included, but for line feed and tab, and the marks, embeddings, overrides and isolates of the
/// bidirectional algorithm (Unicode Standard Annex 9).
#[must_use]
pub fn is_hidden(c: char) -> bool {
    match c {
        '\n' | '\t' => false,
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => true,
        _ => c.is_control(),
    }
}

/// The text with such characters shown as `\u001b`, as JSON and TOML write them: a JSON document says the
/// same as before.
#[must_use]
pub fn plain(text: &str) -> Cow<'_, str> {
    if !text.contains(is_hidden) {
        return text.into();
    }
    let mut shown = String::with_capacity(text.len() + 16);
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        // A line of Windows ends as ours do.
        if !is_hidden(c) || c == '\r' && rest.peek() == Some(&'\n') {
            shown.push(c);
        } else {
            shown.push_str(&format!("\\u{:04x}", u32::from(c)));
        }
    }
    shown.into()
}

/// The text with such characters replaced by others of as many bytes, so that places in it stay.
#[must_use]
pub fn masked(text: &str) -> String {
    let mask = |c: char| match (is_hidden(c) && c != '\r', c.len_utf8()) {
        (false, _) => c,
        (true, 1) => '?',
        (true, 2) => '¿',
        (true, _) => '\u{fffd}',
    };
    text.chars().map(mask).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn what_acts_on_a_terminal_is_shown() {
        assert_eq!(plain("\u{1b}[31mRED\u{7}\u{9b}x\u{202e}y"), "\\u001b[31mRED\\u0007\\u009bx\\u202ey");
        assert_eq!(plain("a\r\nb\tc"), "a\r\nb\tc");
        assert_eq!(plain("over\rwritten"), "over\\u000dwritten");
        assert!(matches!(plain("größe Ж 砂 שלום"), Cow::Borrowed(_)));
        assert_eq!(masked("\u{1b}\u{9b}\u{202e}é"), "?¿\u{fffd}é");
    }

    proptest! {
        #[test]
        fn nothing_hidden_comes_through(text in "[\\x00-\\x{a0}\\x{600}-\\x{620}\\x{2000}-\\x{2070}a-z]{0,40}") {
            let shown = plain(&text);
            prop_assert!(!shown.replace("\r\n", "").contains(is_hidden));
            prop_assert_eq!(&plain(&shown), &shown);
            let same = masked(&text);
            prop_assert_eq!(same.len(), text.len());
            prop_assert!(!same.replace('\r', "").contains(is_hidden));
            let quoted = serde_json::to_string(&text).unwrap();
            prop_assert_eq!(serde_json::from_str::<String>(&plain(&quoted)).unwrap(), text);
        }
    }
}
