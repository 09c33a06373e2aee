//! Study files: what is understood of them, and that every broken one is refused with its place and a cure.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::CaseError;
use std::path::Path;
use studies::study::{Study, read};
use studies::sweep::expand::expand;
use studies::sweep::line::CaseLine;

const CASE: &str = include_str!("../../../cases/light_disc.toml");

const SAND: &str = include_str!("../../../cases/towed_disc.toml");

/// Parts with a case of their own, and a quick version.
const VERSIONS: &str = r#"format = 2
case = "disc.toml"
models = ["closed-form", "solver"]
set = { "soil.friction_angle" = "33 deg" }

[factor.weight]
key = "body.disc.weight"
values = ["20 N", "40 N", "80 N"]
quick = ["30 N"]

[factor.cells]
values = [20]
quick = [10]

[part.textbook]
factors = ["weight"]
intervals = true
derived = { "grid.cell" = "body.disc.diameter / cells" }

[part.sand]
case = "sand.toml"
factors = ["weight"]
quick = false

[part.alone]
case = "sand.toml"
factors = []
"#;

const STUDY: &str = r#"format = 2
case = "disc.toml"

[set]
"grid.cell" = "25 mm"

[derived]
"body.disc.thickness" = "t_bar * body.disc.diameter"

[factor.phi]
key = "soil.friction_angle"
values = ["30 deg", "35 deg"]
range = ["30 deg", "40 deg"]

[factor.weight]
key = "body.disc.weight"
range = ["20 N", "0.1 kN"]
levels = 3

[factor.t_bar]
values = [0.25, 0.5]
range = [0.2, 0.6]

[part.grid]

[part.filled]
design = "sobol"
points = 8
factors = ["phi", "weight", "t_bar"]

[chart.drag]
x = "phi"
y = "drag"
family = "weight"
part = "grid"
"#;

fn study(text: &str) -> Result<Study, CaseError> {
    version(text, false)
}

fn version(text: &str, quick: bool) -> Result<Study, CaseError> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("disc.toml"), CASE).unwrap();
    std::fs::write(folder.path().join("sand.toml"), SAND).unwrap();
    std::fs::write(folder.path().join("wheel.toml"), SAND.replace("body.disc", "body.wheel")).unwrap();
    let path = folder.path().join("study.toml");
    std::fs::write(&path, text).unwrap();
    read(&path, quick)
}

#[test]
fn a_case_is_no_study_and_a_study_no_case() {
    let said = |error: CaseError| {
        assert_eq!(error.problems.len(), 1);
        format!("{error}: {}; {}", error.problems[0].message, error.problems[0].cure)
    };
    let of_case = said(study(CASE).unwrap_err());
    assert!(of_case.contains("is a case, not a study") && of_case.contains("coulter run"), "{of_case}");
    let of_study = said(coulter::case::parse(STUDY, "study.toml", &[]).unwrap_err());
    assert!(of_study.contains("is a study, not a case") && of_study.contains("coulter sweep study.toml"));
}

#[test]
fn a_study_is_expanded() {
    let study = study(STUDY).unwrap();
    let lines = expand(&study).unwrap();
    assert_eq!(lines.len(), 2 * 3 * 2 + 8);
    assert!(lines.iter().all(|line| line.refused.is_empty()), "{lines:?}");
    // The unit of the first value is that of the factor.
    let weights: Vec<f64> = lines[..6].iter().map(|line| line.factors[1].number.unwrap()).collect();
    assert_eq!(weights, [20.0, 20.0, 60.0, 60.0, 100.0, 100.0]);
    assert!(lines[0].set.contains(&"body.disc.thickness=\"0.05 m\"".to_owned()), "{:?}", lines[0].set);
    let inside = |line: &&CaseLine| {
        let [phi, weight, t_bar] = [0, 1, 2].map(|n| line.factors[n].number.unwrap());
        (30.0..=40.0).contains(&phi) && (20.0..=100.0).contains(&weight) && (0.2..=0.6).contains(&t_bar)
    };
    assert!(lines[12..].iter().all(|line| inside(&line)));
    let mut ids: Vec<&str> = lines.iter().map(|line| line.id.as_str()).collect();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), lines.len());
}

#[test]
fn parts_vary_cases_of_their_own_and_a_quick_version_less() {
    let [full, quick] =
        [false, true].map(|quick| version(VERSIONS, quick).map(|study| expand(&study).unwrap()).unwrap());
    let parts = |lines: &[CaseLine]| lines.iter().map(|line| line.part.clone()).collect::<Vec<_>>();
    assert_eq!(full.len(), 2 * (3 + 3 + 1), "{:?}", parts(&full));
    assert_eq!(parts(&quick), ["textbook", "textbook", "alone", "alone"]);
    assert!(full.iter().chain(&quick).all(|line| line.refused.is_empty()), "{full:?}");
    // What the top sets belongs to its case, and a factor is where it is varied or used.
    assert_eq!([full[0].case, full[6].case, full[12].case], [0, 1, 1]);
    assert_eq!(full[0].set[0], "soil.friction_angle=\"33 deg\"");
    assert!(full[6..].iter().all(|line| !line.set.iter().any(|set| set.contains("friction_angle"))));
    let factors = |line: &CaseLine| {
        let named = line.factors.iter().map(|level| (level.name.clone(), level.is_varied));
        named.collect::<Vec<_>>()
    };
    assert_eq!(factors(&full[0]), [("weight".to_owned(), true), ("cells".to_owned(), false)]);
    assert_eq!(factors(&full[12]), [("weight".to_owned(), false)]);
    assert!(quick[0].set.contains(&"body.disc.weight=\"30 N\"".to_owned()), "{:?}", quick[0].set);
    assert!(quick[0].set.iter().any(|set| set.starts_with("grid.cell=\"0.0")), "{:?}", quick[0].set);
    // With and without intervals are two cases.
    let without = expand(&study(&VERSIONS.replace("intervals = true\n", "")).unwrap()).unwrap();
    assert!(full[..6].iter().zip(&without).all(|(a, b)| a.id != b.id && b.meshes.is_none()));
    assert!(full[6..].iter().zip(&without[6..]).all(|(a, b)| a.id == b.id));
    assert_eq!(full[0].meshes, Some(3));
}

#[test]
fn a_study_without_a_quick_version_says_so() {
    let error = version(STUDY, true).unwrap_err();
    assert!(error.problems[0].message.contains("no quick version"), "{:?}", error.problems);
    let none = version(
        &VERSIONS
            .replace("factors = []", "factors = []\nquick = false")
            .replace("intervals = true", "quick = false"),
        true,
    );
    assert!(none.unwrap_err().problems[0].message.contains("no quick version"));
}

#[test]
fn a_key_is_looked_for_in_every_case_that_it_varies() {
    let other = VERSIONS.replace(
        "case = \"sand.toml\"\nfactors = [\"weight\"]",
        "case = \"wheel.toml\"\nfactors = [\"weight\"]",
    );
    let error = version(&other, false).unwrap_err();
    let problem = &error.problems[0];
    assert!(problem.message.contains("no section [body.disc]"), "{problem:?}");
}

#[test]
fn a_part_without_its_case_says_where() {
    let error = version(&VERSIONS.replace("\"sand.toml\"", "\"sant.toml\""), false).unwrap_err();
    let problem = &error.problems[0];
    assert!(problem.message.contains("sant.toml") && problem.cure.contains("relative"), "{problem:?}");
    assert_eq!(error.problems.len(), 1);
}

#[test]
fn points_that_are_the_same_case_have_one_id() {
    let twice = STUDY.replace("values = [\"30 deg\", \"35 deg\"]", "values = [\"30 deg\", \"30.0 deg\"]");
    let lines = expand(&study(&twice).unwrap()).unwrap();
    assert_eq!(lines[0].id, lines[6].id);
}

#[test]
fn a_point_that_is_no_valid_case_is_listed_with_its_reason() {
    let with_dilation = STUDY.replace("\"grid.cell\" = \"25 mm\"", "\"soil.dilation_angle\" = \"32 deg\"");
    let lines = expand(&study(&with_dilation).unwrap()).unwrap();
    let refused: Vec<&str> =
        lines[..12].iter().map(|line| line.refused.as_str()).filter(|why| !why.is_empty()).collect();
    assert_eq!(refused.len(), 6);
    assert!(refused[0].contains("dilation"), "{refused:?}");
}

/// Replaces `old` by `new` and expects a message about the line of `new`, or about the heading of its
/// section, that contains all of `words`.
#[track_caller]
fn refused(old: &str, new: &str, words: &[&str]) {
    assert!(STUDY.contains(old), "the study has no `{old}`");
    let broken = STUDY.replacen(old, new, 1);
    let error = study(&broken).unwrap_err();
    let at = STUDY.find(old).unwrap();
    let lines = |upto: usize| broken[..upto].matches('\n').count() + 1;
    let heading = broken[..at].rfind("\n[").map_or(0, |n| n + 1);
    let (first, last) = (lines(at), lines(at + new.len()));
    let fits = |p: &&coulter::case::LocatedProblem| {
        ((first..=last).contains(&p.line) || p.line == lines(heading))
            && !p.cure.is_empty()
            && words.iter().all(|word| p.message.contains(word) || p.cure.contains(word))
    };
    assert!(error.problems.iter().any(|p| fits(&p)), "{first}..{last} {words:?}: {:#?}", error.problems);
}

#[test]
fn broken_studies_are_refused_with_place_and_cure() {
    refused("format = 2", "format = 3", &["newer than this version"]);
    refused("format = 2", "format = 1", &["there is no format 1", "format = 2"]);
    refused("format = 2\n", "", &["`format` is missing", "format = 2"]);
    refused("case = \"disc.toml\"", "case = \"dics.toml\"", &["dics.toml", "relative to the folder"]);
    refused("case = \"disc.toml\"", "case = 3", &["expected text"]);
    refused("[factor.phi]", "[factors.phi]", &["expected a list of names, found a table"]);
    refused("[chart.drag]", "[charts.drag]", &["unknown key `charts`", "did you mean `chart`?"]);
    refused("[factor.phi]", "[factor.\"p h i\"]", &["is not a name of a factor"]);
    refused(
        "key = \"soil.friction_angle\"",
        "key = \"soil.frictionangle\"",
        &["no key `soil.frictionangle`"],
    );
    refused(
        "key = \"body.disc.weight\"",
        "key = \"body.disk.weight\"",
        &["no section [body.disk]", "body.disc"],
    );
    refused("\"35 deg\"]", "\"35 m\"]", &["an angle is needed"]);
    refused("\"35 deg\"]", "35]", &["a bare number has no unit"]);
    refused("\"35 deg\"]", "\"95 deg\"]", &["out of range"]);
    refused("values = [\"30 deg\", \"35 deg\"]", "values = []", &["the list is empty"]);
    refused("values = [\"30 deg\", \"35 deg\"]", "values = \"30 deg\"", &["expected a list"]);
    refused("range = [\"20 N\", \"0.1 kN\"]", "range = [\"20 N\"]", &["a range has two values"]);
    refused("range = [\"20 N\", \"0.1 kN\"]", "range = [\"20 N\", \"0.01 kN\"]", &["not below the high end"]);
    refused(
        "range = [\"20 N\", \"0.1 kN\"]\nlevels = 3",
        "scale = \"linear\"",
        &["neither values nor a range"],
    );
    refused("levels = 3", "levels = 1", &["out of range", "from 2"]);
    refused("levels = 3", "levls = 3", &["unknown key `levls`", "did you mean `levels`?"]);
    refused("range = [0.2, 0.6]", "range = [0, 0.6]\nscale = \"logarithmic\"", &["needs values above 0"]);
    refused("design = \"sobol\"", "design = \"sobel\"", &["did you mean \"sobol\"?"]);
    refused("points = 8", "points = 1", &["out of range"]);
    refused("design = \"sobol\"\npoints = 8", "design = \"sobol\"", &["`points` is missing"]);
    refused("\"t_bar\"]", "\"tbar\"]", &["no factor `tbar`", "did you mean `t_bar`?"]);
    refused("\"t_bar\"]", "\"phi\"]", &["named twice"]);
    refused("[part.grid]", "[part.grid]\ndesign = \"list\"", &["as many levels of every factor"]);
    refused("[part.grid]", "[part.grid]\nmodels = [\"solver\", \"solver\"]", &["each once"]);
    refused("\"grid.cell\" = \"25 mm\"", "\"grid.cel\" = \"25 mm\"", &["no key `grid.cel`"]);
    refused("\"grid.cell\" = \"25 mm\"", "\"grid.cell\" = \"25 N\"", &["a length is needed"]);
    refused(
        "\"t_bar * body.disc.diameter\"",
        "\"t_bar * body.disc.diamter\"",
        &["`body.disc.diamter` is neither"],
    );
    refused("\"t_bar * body.disc.diameter\"", "\"t_bar * (2\"", &["cannot be read", "not closed"]);
    refused("\"t_bar * body.disc.diameter\"", "3", &["expected a formula as text"]);
    refused("y = \"drag\"", "y = \"darg\"", &["no column `darg`", "did you mean `drag`?"]);
    refused("family = \"weight\"", "family = \"wieght\"", &["no factor `wieght`"]);
    refused("part = \"grid\"", "part = \"gird\"", &["no part `gird`"]);
    refused("x = \"phi\"", "z = \"phi\"", &["unknown key `z`"]);
}

#[test]
fn broken_figures_are_refused_with_place_and_cure() {
    let part = "part = \"grid\"\n";
    let with = |line: &str, words: &[&str]| refused(part, &format!("{part}{line}\n"), words);
    with("columns = 3", &["out of range", "from 1 to 2"]);
    with("legend = \"top lift\"", &["did you mean \"top left\"?"]);
    with("x_range = [1, 1]", &["cannot have these ends"]);
    with("scale = \"logarithmic\"\ny_range = [0, 1]", &["cannot have these ends", "above 0"]);
    with("x_range = [\"1 m\", \"2 m\"]", &["expected a number, found text"]);
    with("measured = [\"none.csv\"]", &["none.csv", "relative to the folder"]);
    with("measured = [\"disc.toml\"]", &["no column `phi` and `drag`", "name its columns"]);
    with("measured = [\"disc.toml\"]\nmeasured_labels = [\"a\", \"b\"]", &["2 labels of 1 measured"]);
    with("history = true", &["no run is part of the chart", "solver"]);
    refused("x = \"phi\"", "history = true\nx = \"tim\"", &["no column `tim`", "did you mean `time`?"]);
    refused("[chart.drag]", "[style]\nwidth_one = \"2 m\"\n[chart.drag]", &["out of range"]);
    refused("[chart.drag]", "[style]\nwidth_one = 90\n[chart.drag]", &["a bare number has no unit"]);
    refused("[chart.drag]", "[style]\ncolor = \"black\"\n[chart.drag]", &["did you mean `colour`?"]);
}

#[test]
fn the_style_of_figures_is_read() {
    let style = study(STUDY).unwrap().style;
    assert_eq!([style.of(1).width, style.of(2).width], [90.0, 190.0]);
    assert_eq!([style.of(1).aspect, style.of(2).aspect], [0.75, 0.45]);
    let own =
        "[style]\nwidth_one = \"8.5 cm\"\naspect = 0.8\nfont_size = 9\ncolour = \"black\"\n[chart.drag]";
    let style = study(&STUDY.replace("[chart.drag]", own)).unwrap().style.of(1);
    assert!((style.width - 85.0).abs() < 1e-9 && !style.is_coloured);
    assert_eq!([style.aspect, style.font_size], [0.8, 9.0]);
}

#[test]
fn a_study_that_varies_nothing_or_is_empty_is_refused() {
    let error = study("format = 2\ncase = \"disc.toml\"\n").unwrap_err();
    assert!(error.problems.iter().any(|p| p.message.contains("varies nothing")), "{error:?}");
    let error = study("").unwrap_err();
    assert!(error.problems.iter().any(|p| p.message.contains("`case` is missing")), "{error:?}");
    assert!(study("case = [").is_err());
    assert!(read(Path::new("/no/such/study.toml"), true).is_err());
}

#[test]
fn too_many_points_are_refused() {
    let levels = "levels = 1000";
    let many = STUDY
        .replace("levels = 3", levels)
        .replace("values = [\"30 deg\", \"35 deg\"]", levels)
        .replace("values = [0.25, 0.5]", levels);
    let error = study(&many).unwrap_err();
    assert!(error.problems.iter().any(|p| p.message.contains("1000000000 points")), "{error:?}");
}

/// No study file, however garbled, causes a panic.
#[test]
fn garbled_studies_never_panic() {
    let mut state = 7_u64;
    let mut random = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    for _ in 0..400 {
        let mut text = STUDY.as_bytes().to_vec();
        for _ in 0..=random(3) {
            let at = random(text.len());
            match random(3) {
                0 => text[at] = b"0\"[]{}=.,-ae\n*/^(#"[random(18)],
                1 => drop(text.drain(at..(at + random(20)).min(text.len()))),
                _ => {
                    let from = random(text.len());
                    let piece = text[from..(from + random(30)).min(text.len())].to_vec();
                    text.splice(at..at, piece);
                }
            }
        }
        let Ok(text) = String::from_utf8(text) else { continue };
        if let Ok(study) = study(&text) {
            let _ = expand(&study);
        }
    }
}
