//! A page as SVG text: letters are outlines, so that it looks the same wherever it is opened.

use super::drawing::{Colour, Drawing, Item, Pen};
use super::segment::Segment;
use super::text::LaidText;
use input::printed::plain;
use std::fmt::Write as _;

/// Points of a millimetre.
pub(super) const POINTS: f64 = 72.0 / 25.4;

/// The page as SVG text.
pub(super) fn svg(drawing: &Drawing, about: &str) -> String {
    let [width, height] = drawing.size;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n",
        number(width / POINTS),
        number(height / POINTS),
        number(width),
        number(height),
        escaped(about)
    );
    for item in &drawing.items {
        match item {
            Item::Path { class, segments, pen, fill } => {
                let _ = writeln!(
                    text,
                    "<path class=\"{class}\" d=\"{}\" fill=\"{}\"{}/>",
                    data(segments),
                    fill.map_or_else(|| "none".to_owned(), colour),
                    pen.as_ref().map_or_else(String::new, stroke)
                );
            }
            Item::Text { text: laid, at, is_turned } => {
                let path = data(&outlines(laid, *at, *is_turned));
                let words = escaped(&laid.words());
                let _ = writeln!(text, "<path class=\"text\" aria-label=\"{words}\" d=\"{path}\"/>");
            }
        }
    }
    text.push_str("</svg>\n");
    text
}

/// The outlines of a text at its place on the page.
fn outlines(laid: &LaidText, at: [f64; 2], is_turned: bool) -> Vec<Segment> {
    let place = |[along, up]: [f64; 2]| match is_turned {
        false => [at[0] + along, at[1] - up],
        true => [at[0] - up, at[1] - along],
    };
    let mut all = Vec::new();
    for glyph in &laid.glyphs {
        let here = |[x, y]: [f64; 2]| place([glyph.at[0] + glyph.size * x, glyph.at[1] + glyph.size * y]);
        all.extend(glyph.face.outline(glyph.glyph).into_iter().map(|segment| match segment {
            Segment::Move(to) => Segment::Move(here(to)),
            Segment::Line(to) => Segment::Line(here(to)),
            Segment::Bend(by, to) => Segment::Bend(here(by), here(to)),
            Segment::Curve(points) => Segment::Curve(points.map(here)),
            Segment::Close => Segment::Close,
        }));
    }
    for [left, low, right, high] in &laid.bars {
        let corners = [[*left, *low], [*right, *low], [*right, *high], [*left, *high]].map(place);
        all.push(Segment::Move(corners[0]));
        all.extend(corners[1..].iter().map(|corner| Segment::Line(*corner)));
        all.push(Segment::Close);
    }
    all
}

fn data(segments: &[Segment]) -> String {
    let mut text = String::new();
    let mut add = |letter: char, points: &[[f64; 2]]| {
        text.push(letter);
        for (n, [x, y]) in points.iter().enumerate() {
            let gap = if n > 0 { " " } else { "" };
            let _ = write!(text, "{gap}{} {}", number(*x), number(*y));
        }
    };
    for segment in segments {
        match segment {
            Segment::Move(to) => add('M', &[*to]),
            Segment::Line(to) => add('L', &[*to]),
            Segment::Bend(by, to) => add('Q', &[*by, *to]),
            Segment::Curve(points) => add('C', points),
            Segment::Close => add('Z', &[]),
        }
    }
    text
}

fn stroke(pen: &Pen) -> String {
    let dashes: Vec<String> = pen.dashes.iter().map(|length| number(*length)).collect();
    let dashes =
        if dashes.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{}\"", dashes.join(" ")) };
    format!(
        " stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{dashes}",
        colour(pen.colour),
        number(pen.width)
    )
}

fn colour([red, green, blue]: Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// A number with as many decimals as print shows.
fn number(value: f64) -> String {
    let text = format!("{:.2}", value + 0.0);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn escaped(text: &str) -> String {
    let text = plain(text);
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
