//! The page of a study, in which a style meant for screen readers hid the text of every cell.
//! `scripts/report/browser.py` looks at the pages; here, that no class of a cell has a style that hides, and
//! that charts are read without colour.

use crate::support::Desk;
use std::collections::BTreeSet;

const DISC: &str = r#"
format = 2
soil = { law = "mohr-coulomb", friction_angle = "35 deg", unit_weight = "16 kN/m^3", young_modulus = "1 MPa" }
domain = { symmetric = true }
grid = { cell = "12.5 mm", aspect = [2, 2, 1], growth = 1.35, follow = { body = "disc", axes = "x" } }
run = { tow_distance = "0.3 m" }
[body.disc]
shape = "disc"
diameter = "0.2 m"
thickness = "50 mm"
friction = 0.3
weight = "100 N"
heave = { load = "0 N" }
spin = "free"
forward = { speed = "0.3 m/s", start = "0.2 s" }
"#;

const STUDY: &str = r#"
format = 2
case = "disc.toml"
title = "Analytical curves"
responses = ["F_H_bar", "Z"]
closed_forms = "all"
[derived]
"body.disc.weight" = "W_bar * soil.unit_weight * body.disc.thickness * body.disc.diameter^2"
[factor.phi]
key = "soil.friction_angle"
values = ["30 deg", "35 deg", "40 deg"]
label = "friction angle φ"
[factor.W_bar]
range = [0.5, 6]
levels = 4
label = "weight W/(γtd²)"
[part.phi]
factors = ["phi", "W_bar"]
[chart.drag]
part = "phi"
x = "Z"
y = "F_H_bar"
family = "phi"
"#;

/// The words of every attribute `class` of these elements.
fn classes(html: &str, elements: &[&str]) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for tag in html.split('<').filter(|tag| elements.iter().any(|name| tag.starts_with(&format!("{name} "))))
    {
        let tag = tag.split('>').next().unwrap_or_default();
        if let Some(list) = tag.split("class=\"").nth(1) {
            found.extend(list.split('"').next().unwrap_or_default().split_whitespace().map(str::to_owned));
        }
    }
    found
}

/// The rules of a style sheet on screens that hide what they are for: their selectors. Those of paper and of
/// narrow screens are nested.
fn hiding(html: &str) -> Vec<String> {
    let style: String =
        html.split("<style>").skip(1).filter_map(|part| part.split("</style>").next()).collect();
    let style = style.split("@media print").next().unwrap_or_default().to_owned();
    let hides = |body: &str| {
        let body = body.replace(' ', "");
        ["clip-path", "display:none", "visibility:hidden", "width:1px", "opacity:0;"]
            .iter()
            .any(|word| body.contains(word))
    };
    let rules = style.split('}').filter_map(|rule| rule.rsplit_once('{'));
    let last = |selector: &str| selector.rsplit(['{', '/']).next().unwrap_or_default().trim().to_owned();
    rules.filter(|(_, body)| hides(body)).map(|(selector, _)| last(selector)).collect()
}

#[test]
fn no_class_of_a_cell_hides_its_text() {
    let desk = Desk::with(&[("disc.toml", DISC), ("study.toml", STUDY)]);
    desk.expect(0, &["sweep", "study.toml", "-o", "out"]);
    let html = desk.read("out/report.html");
    let hiding = hiding(&html);
    assert!(hiding.iter().any(|selector| selector == "span.spoken"), "{hiding:?}");
    let used = classes(&html, &["td", "th", "tr", "table"]);
    assert!(used.contains("number") && used.contains("text"), "{used:?}");
    for selector in hiding.iter().filter(|selector| !selector.contains(".stack")) {
        for class in &used {
            let is_named = |part: &str| part.split(['.', ' ', ':', ',', '>']).any(|word| word == class);
            assert!(!is_named(selector), "the class {class} of cells is hidden by {selector}");
        }
    }
    // Every row has a cell for every head.
    for table in html.split("<table").skip(1) {
        let heads = table.split("</thead>").next().unwrap_or_default().matches("<th").count() - 1;
        for row in table.split("</table>").next().unwrap_or_default().split("<tr").skip(2) {
            assert_eq!(row.matches("<td").count(), heads, "{row}");
        }
    }
    // The points themselves, with their figures in digits that people read.
    assert!(html.contains("<h2>Points</h2>") && html.contains(">2.333<"), "no level 2.333");
}

#[test]
fn a_figure_of_many_series_is_read_without_colour() {
    let black = format!("{STUDY}legend = \"none\"\n[style]\ncolour = \"black\"\n");
    let desk = Desk::with(&[("disc.toml", DISC), ("study.toml", &black)]);
    desk.expect(0, &["sweep", "study.toml", "-o", "out"]);
    let svg = desk.read("out/figures/drag.svg");
    let mut looks = BTreeSet::new();
    let mut count = 0;
    for line in svg.lines().filter(|line| line.contains("class=\"curve\"")) {
        let (_, look) = line.split_once("fill=\"none\"").unwrap();
        assert!(look.contains("stroke=\"#000000\""), "{look}");
        count += 1;
        assert!(looks.insert(look.to_owned()), "{line} looks like another");
    }
    assert!(count > 7, "only {count} series");
    // The page shows the same, beside its files.
    let page = desk.read("out/report.html");
    assert!(page.contains("href=\"figures/drag.pdf\"") && page.contains("class=\"curve\""));
    let csv = desk.read("out/figures/drag.csv");
    assert!(csv.starts_with("kind,level,source,Z [-],Z_low [-],Z_high [-],F_H_bar [-],"), "{csv}");
}

#[test]
fn a_study_of_one_factor_ranks_nothing() {
    let one = STUDY
        .replace("factors = [\"phi\", \"W_bar\"]", "factors = [\"W_bar\"]")
        .replace("family = \"phi\"\n", "");
    let one = one
        .replace("values = [\"30 deg\", \"35 deg\", \"40 deg\"]", "values = [\"35 deg\"]")
        .replace("levels = 4", "levels = 12");
    let desk = Desk::with(&[("disc.toml", DISC), ("study.toml", &one)]);
    desk.expect(0, &["sweep", "study.toml", "-o", "out"]);
    let html = desk.read("out/report.html");
    for word in ["tornado", "Sobol index", "Sobol indices are not"] {
        assert!(!html.contains(word), "{word}");
    }
}
