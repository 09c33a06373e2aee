//! From a label such as `dimensionless drag F̄_H`, `speed v [m/s]` or `φ = 30 deg` to pieces of text: symbols
//! are slanted, indices lowered, exponents raised, mean values and dimensionless groups have a bar above.

/// Height of a piece of text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Script {
    /// On the line.
    #[default]
    Line,
    /// An index.
    Low,
    /// An exponent.
    High,
}

/// A piece of text in one face.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Piece {
    pub(super) text: String,
    pub(super) is_italic: bool,
    pub(super) script: Script,
    pub(super) has_bar: bool,
}

/// Marks that put a bar above the letter before them.
const BARS: [char; 2] = ['\u{304}', '\u{305}'];
/// Letters that have their bar already, and the letters below it.
const BARRED: [(char, char); 10] = [
    ('Ē', 'E'),
    ('ē', 'e'),
    ('ū', 'u'),
    ('Ū', 'U'),
    ('ā', 'a'),
    ('Ā', 'A'),
    ('ō', 'o'),
    ('Ō', 'O'),
    ('ī', 'i'),
    ('ȳ', 'y'),
];

/// Text without symbols, such as the name of a file.
pub(super) fn plain(text: &str) -> Vec<Piece> {
    vec![Piece { text: text.to_owned(), ..Piece::default() }]
}

/// The pieces of a label; a unit in square brackets at its end is set in round ones, and left out of plain
/// numbers.
pub(super) fn pieces(label: &str) -> Vec<Piece> {
    let (words, unit) = match label.strip_suffix(']').and_then(|rest| rest.rsplit_once('[')) {
        Some((words, unit)) => (words.trim_end(), unit),
        None => (label.trim(), ""),
    };
    let mut found = Line::default();
    let words: Vec<&str> = words.split(' ').filter(|word| !word.is_empty()).collect();
    for (n, word) in words.iter().enumerate() {
        let follows_number = n > 0 && is_number(words[n - 1]);
        if let Some(rest) = word.strip_prefix("deg").filter(|rest| follows_number && rest.len() < 2) {
            found.letters("°", false);
            found.letters(rest, false);
            continue;
        }
        if n > 0 {
            found.letters(" ", false);
        }
        if follows_number {
            found.unit(word);
        } else if is_symbol(word, n + 1 == words.len()) {
            found.symbol(word);
        } else {
            found.letters(word, false);
        }
    }
    match unit {
        "" | "-" | "–" => {}
        "deg" => found.letters(" (°)", false),
        unit => {
            found.letters(" (", false);
            found.unit(unit);
            found.letters(")", false);
        }
    }
    found.pieces
}

/// A label with a capital at its start, where that is a word.
pub(super) fn capitalised(label: &str) -> String {
    let is_word = label.split(' ').next().is_some_and(|word| {
        word.chars().count() > 2 && word.chars().all(|c| c.is_lowercase() || "-'’".contains(c))
    });
    let mut letters = label.chars();
    match letters.next() {
        Some(first) if is_word => first.to_uppercase().chain(letters).collect(),
        _ => label.to_owned(),
    }
}

fn is_number(word: &str) -> bool {
    let mut letters = word.trim_start_matches(['-', '\u{2212}', '≤', '≥', '<', '>']).chars();
    letters.next().is_some_and(|c| c.is_ascii_digit())
        && word.chars().all(|c| c.is_ascii_digit() || ".,e-\u{2212}<>≤≥".contains(c))
}

fn is_greek(letter: char) -> bool {
    ('\u{370}'..='\u{3ff}').contains(&letter)
}

fn is_symbol(word: &str, is_last: bool) -> bool {
    let letters = word.chars().filter(|c| c.is_alphabetic()).count();
    let is_short = |part: &str| (1..=2).contains(&part.chars().filter(|c| c.is_alphabetic()).count());
    let is_quotient = word.split_once('/').is_some_and(|(above, below)| is_short(above) && is_short(below));
    word.contains('_')
        || word.chars().any(|c| is_greek(c) || BARS.contains(&c))
        || (letters == 1 && !word.ends_with(['.', ')']) && (is_last || !["a", "A", "I"].contains(&word)))
        || is_quotient
}

/// Pieces that grow.
#[derive(Default)]
struct Line {
    pieces: Vec<Piece>,
}

impl Line {
    fn add(&mut self, text: &str, is_italic: bool, script: Script) {
        match self.pieces.last_mut() {
            Some(last) if last.is_italic == is_italic && last.script == script && !last.has_bar => {
                last.text.push_str(text);
            }
            _ => self.pieces.push(Piece { text: text.to_owned(), is_italic, script, has_bar: false }),
        }
    }

    fn letters(&mut self, text: &str, is_italic: bool) {
        self.add(text, is_italic, Script::Line);
    }

    /// A unit: its exponents are raised.
    fn unit(&mut self, unit: &str) {
        let mut parts = unit.split('^');
        self.letters(parts.next().unwrap_or_default(), false);
        for part in parts {
            let end = part.find(|c: char| !c.is_ascii_digit() && c != '-').unwrap_or(part.len());
            self.add(&part[..end].replace('-', "\u{2212}"), false, Script::High);
            self.letters(&part[end..], false);
        }
    }

    /// A symbol or a formula of symbols.
    fn symbol(&mut self, word: &str) {
        let letters: Vec<char> = word.chars().collect();
        let mut n = 0;
        while n < letters.len() {
            let letter = letters[n];
            let script = match letter {
                '_' => Script::Low,
                '^' => Script::High,
                _ => Script::Line,
            };
            if script != Script::Line {
                let end = letters[n + 1..].iter().take_while(|c| c.is_alphanumeric()).count() + n + 1;
                for letter in &letters[n + 1..end] {
                    self.add(&letter.to_string(), is_greek(*letter), script);
                }
                n = end;
            } else if BARS.contains(&letter) {
                self.bar();
                n += 1;
            } else if letter.is_ascii_alphabetic() {
                let end = letters[n..].iter().take_while(|c| c.is_ascii_alphabetic()).count() + n;
                // tan, sin: the names of functions stand upright.
                self.letters(&letters[n..end].iter().collect::<String>(), end - n < 3);
                n = end;
            } else {
                match BARRED.iter().find(|(barred, _)| *barred == letter) {
                    Some((_, below)) => {
                        self.letters(&below.to_string(), true);
                        self.bar();
                    }
                    None => self.letters(&letter.to_string(), is_greek(letter)),
                }
                n += 1;
            }
        }
    }

    /// Puts a bar above the last letter.
    fn bar(&mut self) {
        let Some(last) = self.pieces.last_mut() else { return };
        let Some(letter) = last.text.pop() else { return };
        let piece = Piece { text: letter.to_string(), has_bar: true, ..last.clone() };
        if last.text.is_empty() {
            self.pieces.pop();
        }
        self.pieces.push(piece);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pieces in a notation: *slanted*, _low, ^high, a bar as |.
    fn shown(label: &str) -> String {
        let one = |piece: &Piece| {
            let mark = ["", "_", "^"][piece.script as usize];
            let bar = if piece.has_bar { "|" } else { "" };
            let star = if piece.is_italic { "*" } else { "" };
            format!("{mark}{star}{}{bar}{star}", piece.text)
        };
        pieces(label).iter().map(one).collect()
    }

    #[test]
    fn symbols_are_slanted_and_units_are_not() {
        for (label, expected) in [
            ("dimensionless drag F̄_H", "dimensionless drag *F|*_H"),
            ("drag F_H [N]", "drag *F*_H (N)"),
            ("unit weight γ [kN/m^3]", "unit weight *γ* (kN/m^3)"),
            ("friction angle φ [deg]", "friction angle *φ* (°)"),
            ("slip s [–]", "slip *s*"),
            ("φ = 32.5 deg", "*φ* = 32.5°"),
            ("d = 0.2 m", "*d* = 0.2 m"),
            ("φ = 30 deg, W = 20 N (doubtful)", "*φ* = 30°, *W* = 20 N (doubtful)"),
            ("weight W/(γtd²)", "weight *W*/(*γtd*²)"),
            ("thickness t/d", "thickness *t*/*d*"),
            ("Ē = 20", "*E|* = 20"),
            ("scatter of a drag", "scatter of a drag"),
            ("N_γ tanφ", "*N*_*γ* tan*φ*"),
        ] {
            assert_eq!(shown(label), expected, "{label}");
        }
        assert_eq!(capitalised("drag F_H"), "Drag F_H");
        assert_eq!(capitalised("φ"), "φ");
    }

    #[test]
    fn odd_labels_do_no_harm() {
        for label in ["", "_", "^", "[", "]", "[]", "\u{304}", "_\u{304}", "a_", "x [", "F__H", "  "] {
            let _ = pieces(label);
        }
    }
}
