//! Whether a drawing that is read from a folder is one: it becomes part of the page, where anything else
//! could act.

/// The elements of our charts.
const ELEMENTS: [&str; 7] = ["svg", "g", "path", "rect", "circle", "text", "tspan"];

/// Whether an SVG text holds elements and attributes of charts only: nothing that a browser runs, fetches or
/// lays over the page.
pub(super) fn is_drawing(svg: &str) -> bool {
    let mut tags = svg.split('<');
    tags.next().is_some_and(|before| before.trim().is_empty()) && tags.all(is_element)
}

/// Whether what follows a `<` is the tag of an element, and text.
fn is_element(tag: &str) -> bool {
    let name_end = tag.find(|c: char| !c.is_ascii_alphabetic() && c != '/').unwrap_or(tag.len());
    let (name, mut rest) = tag.split_at(name_end);
    if !ELEMENTS.contains(&name.trim_start_matches('/')) {
        return false;
    }
    loop {
        rest = rest.trim_start();
        if rest.starts_with('>') || rest.starts_with("/>") {
            return true;
        }
        let Some((attribute, value)) = rest.split_once("=\"") else { return false };
        let Some((_, after)) = value.split_once('"') else { return false };
        if !is_harmless(attribute) {
            return false;
        }
        rest = after;
    }
}

/// Whether an attribute neither runs nor fetches anything.
fn is_harmless(name: &str) -> bool {
    let is_name = !name.is_empty() && name.chars().all(|c| c.is_ascii_alphabetic() || c == '-');
    is_name && !name.to_ascii_lowercase().starts_with("on") && !matches!(name, "style" | "href" | "src")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plots::{Chart, Curve, Level, Stroke};

    #[test]
    fn charts_are_drawings_and_nothing_else_is() {
        let chart = Chart {
            title: "Drag F_H < \"1\" & more".into(),
            x_label: "x [mm]".into(),
            y_label: "height [mm]".into(),
            curves: vec![
                Curve::solid("a \"b\" <c>", 1, vec![[0.0, 1.0], [1.0, 2.0]]),
                Curve { name: "p".into(), points: vec![[0.5, 1.5]], colour: 2, stroke: Stroke::Dots },
            ],
            levels: vec![Level { label: "mean".into(), value: 1.5, from: 0.0, to: 1.0, colour: 1 }],
            ..Chart::default()
        };
        let svg = chart.svg();
        assert!(is_drawing(&svg), "{svg}");
        let with = |more: &str| svg.replacen("<g class", &format!("{more}<g class"), 1);
        for bad in [
            "<script>alert(1)</script>",
            "<SCRIPT>x</SCRIPT>",
            "<foreignObject>",
            "<a href=\"javascript:x\">",
            "<image href=\"http://x\"/>",
            "<style>*{}</style>",
            "<rect onload=\"x\"/>",
            "<rect ONload=\"x\"/>",
            "<rect style=\"background:url(http://x)\"/>",
            "<rect x='1' onload='x'/>",
            "<!-- -->",
            "<!DOCTYPE x [<!ENTITY a \"b\">]>",
            "<rect x=\"1\"onload=x>",
            "<g/onload=x>",
            "<rect",
        ] {
            assert!(!is_drawing(&with(bad)), "{bad}");
        }
        assert!(!is_drawing("<script>") && !is_drawing("x<svg>"));
    }
}
