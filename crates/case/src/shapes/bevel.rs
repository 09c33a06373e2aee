//! The bevel of a rim or an edge.

use geometry::Bevel;
use input::problem::Problems;
use input::typed::Section;

/// Words for the sides of a bevel.
pub(super) struct Sides {
    /// The side at the low end.
    pub(super) low: &'static str,
    /// The side at the high end.
    pub(super) high: &'static str,
    /// What applies if the key is not given.
    pub(super) usual: Bevel,
}

/// The faces from which the edge is cut.
pub(super) fn read(section: &Section, sides: &Sides, problems: &mut Problems) -> Option<Bevel> {
    if !section.has("bevel") {
        return Some(sides.usual);
    }
    let word = section.text("bevel")?;
    match word.as_str() {
        "both" => Some(Bevel::Both),
        word if word == sides.low => Some(Bevel::Low),
        word if word == sides.high => Some(Bevel::High),
        word => {
            let message = format!("bevel = \"{word}\" does not apply to this shape");
            let cure = format!("write \"both\", \"{}\" or \"{}\"", sides.low, sides.high);
            problems.add(section.at("bevel"), message, cure);
            None
        }
    }
}

/// The bevel in words: `bevelled at 20° to an edge of 2 mm`.
pub(super) fn describe(angle: f64, edge: f64, length: &dyn Fn(f64) -> String) -> String {
    let edge = if edge > 0.0 { format!("an edge of {}", length(edge)) } else { "a knife edge".to_owned() };
    format!("bevelled at {}° to {edge}", (10.0 * angle.to_degrees()).round() / 10.0)
}
