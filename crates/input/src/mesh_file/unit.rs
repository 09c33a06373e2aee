//! Units of length that a file states of itself: in a comment of OBJ or PLY, in the header of STL.

use super::problem::{MeshFileProblem, refuse};

/// A unit of length that a file states.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stated {
    /// The words, as they stand in the file.
    words: String,
    /// Where the words stand.
    place: String,
    /// The unit: its name in a case file and its length [m]; `None` where the word is not known.
    unit: Option<(&'static str, f64)>,
}

/// Units of length: how a case file writes them, their length [m], and other words for them (lower case).
const UNITS: [(&str, f64, &[&str]); 7] = [
    ("m", 1.0, &["m", "meter", "meters", "metre", "metres"]),
    ("cm", 0.01, &["cm", "centimeter", "centimeters", "centimetre", "centimetres"]),
    ("mm", 0.001, &["mm", "millimeter", "millimeters", "millimetre", "millimetres"]),
    ("in", 0.0254, &["in", "inch", "inches", "\""]),
    ("ft", 0.3048, &["ft", "foot", "feet", "'"]),
    (
        "um",
        1e-6,
        &["um", "µm", "μm", "micron", "microns", "micrometer", "micrometers", "micrometre", "micrometres"],
    ),
    ("yd", 0.9144, &["yd", "yard", "yards"]),
];
/// Words after `unit` that state none.
const NO_UNIT: [&str; 8] =
    ["none", "unknown", "unitless", "generic", "unspecified", "undefined", "normal", "normals"];
/// Words between `unit` and its word.
const BETWEEN: [&str; 8] = ["of", "measure", "measurement", "length", "are", "is", "used", "system"];

/// The unit that a comment states: `units: mm`, `UNITS=in`, `Unit of measure: inches`; `place` says where it
/// stands.
pub(super) fn stated(comment: &str, place: impl Fn() -> String) -> Option<Stated> {
    let lower = comment.to_lowercase();
    let starts = lower.match_indices("unit").map(|(at, _)| at);
    starts.filter(|at| !lower[..*at].ends_with(char::is_alphanumeric)).find_map(|at| {
        let rest = &lower[at + 4..];
        let rest = rest.strip_prefix('s').unwrap_or(rest);
        // Not `united`; but `unit_length` may state one.
        if rest.starts_with(char::is_alphanumeric) {
            return None;
        }
        let (word, assigned, end) = word_of(rest)?;
        // `Unit M` may be the name of a part.
        let unit = unit_of(word).filter(|_| assigned || word.len() > 1);
        let says = unit.is_some() || (assigned && !NO_UNIT.contains(&word));
        let end = lower.len() - rest.len() + end;
        says.then(|| Stated { words: lower[at..end].to_owned(), place: place(), unit })
    })
}

fn unit_of(word: &str) -> Option<(&'static str, f64)> {
    UNITS.iter().find(|(.., names)| names.contains(&word)).map(|(name, metres, _)| (*name, *metres))
}

/// The word that may be the unit, whether `:`, `=` or a bracket stands before it, and where it ends.
fn word_of(rest: &str) -> Option<(&str, bool, usize)> {
    let (mut assigned, mut from) = (false, 0);
    loop {
        let start = from + rest[from..].find(|c: char| c.is_alphanumeric() || c == '"' || c == '\'')?;
        assigned |= rest[from..start].contains([':', '=', '[', '(']);
        let word = &rest[start..];
        if word.starts_with(['"', '\'']) {
            // Alone they are inches and feet.
            if assigned && !word[1..].starts_with(char::is_alphabetic) {
                return Some((&word[..1], assigned, start + 1));
            }
            from = start + 1;
            continue;
        }
        let length = word.find(|c: char| !c.is_alphanumeric()).unwrap_or(word.len());
        let (word, end) = (&word[..length], start + length);
        let next = next_word(&rest[end..]);
        // `in` is the inch, but for `units are in feet`.
        let is_between = match word {
            "in" => next.is_some_and(|next| !assigned || unit_of(next).is_some()),
            _ => next.is_some() && BETWEEN.contains(&word),
        };
        if !is_between {
            return Some((word, assigned, end));
        }
        from = end;
    }
}

/// The word that follows, if one does.
fn next_word(rest: &str) -> Option<&str> {
    let rest = rest.trim_start_matches(|c: char| !c.is_alphanumeric());
    let length = rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len());
    Some(&rest[..length]).filter(|word| word.starts_with(char::is_alphabetic))
}

/// The unit of a file, by its name and length [m]: that of the case, which must be that of the file if that
/// states one.
pub(super) fn of_file(
    case: Option<(&str, f64)>,
    stated: Option<&Stated>,
) -> Result<(String, f64), MeshFileProblem> {
    match (case, stated) {
        (Some((name, metres)), Some(Stated { words, place, unit: Some((own, length)) }))
            if (metres / length - 1.0).abs() > 1e-9 =>
        {
            refuse(
                format!("it states its unit, `{words}` ({place}), but the case says unit = \"{name}\""),
                format!(
                    "write unit = \"{own}\", or remove `unit`; if the file is wrong about itself, correct it there"
                ),
            )
        }
        (Some((name, metres)), _) => Ok((name.to_owned(), metres)),
        (None, Some(Stated { unit: Some((own, length)), .. })) => Ok(((*own).to_owned(), *length)),
        (None, Some(Stated { words, place, unit: None })) => refuse(
            format!("it states a unit that is not known, `{words}` ({place}), and the case has no `unit`"),
            "add the unit of its coordinates:  unit = \"mm\"",
        ),
        (None, None) => refuse(
            "it does not state the unit of its coordinates, and `unit` is missing",
            "add  unit = \"mm\"  or whichever it was written in: m, cm, mm, in or ft",
        ),
    }
}

/// The name of a unit of so many metres.
pub(super) fn name_of(metres: f64) -> &'static str {
    let is_it = |length: f64| (metres / length - 1.0).abs() < 1e-9;
    UNITS.iter().find(|(_, length, _)| is_it(*length)).map_or("", |(name, ..)| name)
}

impl Stated {
    /// What is to be said of a unit that is not known, where the case gives another one.
    pub(super) fn remark(&self, unit: &str) -> Option<String> {
        let Self { words, place, .. } = self;
        self.unit.is_none().then(|| {
            format!("nothing of its unit: the file states `{words}` ({place}), which is not known; \"{unit}\" of the case is taken")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(comment: &str) -> Option<&'static str> {
        stated(comment, String::new).and_then(|stated| stated.unit).map(|(name, _)| name)
    }

    #[test]
    fn units_are_recognised_as_programs_write_them() {
        for (comment, unit) in [
            ("units: mm", "mm"),
            ("Units: inches", "in"),
            ("UNITS=in", "in"),
            ("UNITS = IN", "in"),
            ("STL exported, units=MM, COLOR=\u{fffd}\u{fffd}", "mm"),
            ("bracket units=mm", "mm"),
            ("unit mm", "mm"),
            ("UNITS=in COLOR=abcd", "in"),
            ("Unit: millimeter", "mm"),
            ("File units = meters", "m"),
            ("Unit of measure: inch", "in"),
            ("units are in feet", "ft"),
            ("model units (cm)", "cm"),
            ("\"units\": \"cm\"", "cm"),
            ("unit=µm", "um"),
            ("length unit [m]", "m"),
            ("unit_of_length ft", "ft"),
            ("units: \"", "in"),
        ] {
            assert_eq!(found(comment), Some(unit), "{comment}");
        }
        for comment in [
            "part",
            "12 units of it",
            "united states",
            "unit normals",
            "units: none",
            "subunits: mm",
            "unit_in_place",
            "Unit M",
            "",
            "unit",
            "units:",
        ] {
            assert_eq!(stated(comment, String::new), None, "{comment}");
        }
        let odd = stated("units: furlong", || "line 3".to_owned());
        assert!(odd.is_some_and(|odd| odd.unit.is_none() && odd.words == "units: furlong"));
    }
}
