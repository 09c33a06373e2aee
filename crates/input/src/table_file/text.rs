//! From the bytes of a file to its text, whatever program wrote it.

use crate::data_file::{FileProblem, problem};

/// The text of a file, each line ended by a line feed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TableText {
    /// The text.
    pub text: String,
    /// How the text was read, where that was not plain.
    pub remark: Option<String>,
}

/// What Windows-1252 has in place of the control characters of Latin-1, 0x80 to 0x9F; `\u{fffd}` is nothing.
const WINDOWS: [char; 32] = [
    '€', '\u{fffd}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{fffd}', 'Ž', '\u{fffd}',
    '\u{fffd}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{fffd}', 'ž', 'Ÿ',
];

const AS_CSV: &str = "save it as CSV, in UTF-8";

impl TableText {
    /// The text in these bytes: UTF-8, UTF-16 with its mark of byte order, otherwise Windows-1252, which has
    /// the letters of Latin-1.
    ///
    /// # Errors
    /// [`FileProblem`] where it is no text.
    pub fn decode(bytes: Vec<u8>) -> Result<Self, FileProblem> {
        let (text, remark) = match &bytes[..] {
            [b'P', b'K', 3, 4, ..] | [0xd0, 0xcf, 0x11, 0xe0, ..] => {
                return problem("a spreadsheet, not a text file", AS_CSV);
            }
            [0xff, 0xfe, rest @ ..] => (wide(rest, u16::from_le_bytes), None),
            [0xfe, 0xff, rest @ ..] => (wide(rest, u16::from_be_bytes), None),
            [0xef, 0xbb, 0xbf, rest @ ..] => (String::from_utf8(rest.to_vec()).ok(), None),
            all if all.contains(&0) => (None, None),
            _ => match String::from_utf8(bytes) {
                Ok(text) => (Some(text), None),
                Err(error) => {
                    let valid = error.utf8_error().valid_up_to();
                    let bytes = error.into_bytes();
                    let line =
                        unix(String::from_utf8_lossy(&bytes[..valid]).into_owned()).matches('\n').count() + 1;
                    let remark = format!("read as Windows-1252 (Latin-1), since line {line} is not UTF-8");
                    (windows(&bytes), Some(remark))
                }
            },
        };
        match text {
            Some(text) => Ok(Self { text: harmless(unix(text)), remark }),
            None => problem("not a text file", AS_CSV),
        }
    }
}

impl From<&str> for TableText {
    fn from(text: &str) -> Self {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        Self { text: harmless(unix(text.to_owned())), remark: None }
    }
}

fn wide(bytes: &[u8], pair: fn([u8; 2]) -> u16) -> Option<String> {
    let units: Vec<u16> = bytes.chunks_exact(2).map(|two| pair([two[0], two[1]])).collect();
    if bytes.len().is_multiple_of(2) { String::from_utf16(&units).ok() } else { None }
}

fn windows(bytes: &[u8]) -> Option<String> {
    let letter = |byte: &u8| match byte {
        0x80..=0x9f => Some(WINDOWS[usize::from(byte - 0x80)]).filter(|letter| *letter != '\u{fffd}'),
        _ => Some(char::from(*byte)),
    };
    bytes.iter().map(letter).collect()
}

/// CR LF and a lone CR become LF.
fn unix(text: String) -> String {
    if text.contains('\r') { text.replace("\r\n", "\n").replace('\r', "\n") } else { text }
}

/// Characters that would steer a terminal, or turn the direction of a line, are replaced: names of columns
/// are quoted in messages.
fn harmless(text: String) -> String {
    let steers = |c: char| {
        (c.is_control() && c != '\n' && c != '\t')
            || matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{61c}')
    };
    if text.contains(steers) { text.replace(steers, "\u{fffd}") } else { text }
}
