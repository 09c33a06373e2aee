//! From the text of a study file to a study; everything that is wrong is reported at once, each with its
//! place.

use super::assignments::assignments;
use super::factor::numbers_of;
use super::keys::{self, table};
use super::measured_points::{self, Axes, Whence};
use super::model::{BaseCase, ChartWish, Part, Pool, Study, StudyStyle};
use super::{Design, Factor, Level, ModelKind};
use crate::expression::{self, Expression};
use coulter::case::form::{Entry, Form, Problems, Section, Value, accepts, find, join, nearest, section};
use coulter::case::{self, CaseError};
use coulter::output::figure::{FigureStyle, LegendPlace};
use std::path::Path;

/// Reads the study file at `path`, or the quick version that it describes.
///
/// # Errors
/// [`CaseError`] holds everything that is wrong with it, with its place in the file; or what is wrong with
/// the file of the case.
pub fn read(path: &Path, quick: bool) -> Result<Study, CaseError> {
    let stem = path.file_stem();
    let name = stem.map_or_else(|| "study".to_owned(), |stem| stem.to_string_lossy().into_owned());
    read_with(path, (&name, quick), None)
}

/// Reads a study that was expanded: the copy of its file, its name and whether it is the quick version, and
/// the cases that it varies.
///
/// # Errors
/// As [`read`].
pub fn read_expanded(path: &Path, version: (&str, bool), cases: Vec<BaseCase>) -> Result<Study, CaseError> {
    read_with(path, version, Some(cases))
}

fn read_with(
    path: &Path,
    (name, is_quick): (&str, bool),
    expanded: Option<Vec<BaseCase>>,
) -> Result<Study, CaseError> {
    let shown = path.display().to_string();
    let form = Form::read(&case::text(path)?, &shown)?;
    let has = |key: &str| find(&form.entries, key).is_some();
    if has("soil") && !has("case") && !has("factor") {
        let cure = format!("run it with  coulter run {shown},  or name it in a study:  case = \"CASE.toml\"");
        return Err(CaseError::unreadable(&shown, format!("{shown}: this is a case, not a study"), &cure));
    }
    let mut problems = Problems::default();
    let top = top(&form, &mut problems);
    let mut factors = Vec::new();
    for (name, entries) in named(&form, "factor", &mut problems) {
        let given = problems.len();
        let read = factor(&name, &entries, is_quick, &mut problems);
        factors.extend(read.filter(|_| problems.len() == given));
    }
    let names: Vec<String> =
        named(&form, "factor", &mut Problems::default()).into_iter().map(|(name, _)| name).collect();
    if names.is_empty() {
        problems.add("factor", "the study varies nothing", "add a factor: [factor.phi]");
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let whence = if expanded.is_some() { Whence::Copies(folder) } else { Whence::Named(folder) };
    let charts = charts(&form, whence, &factors, &mut problems);
    let style = style(&form, &mut problems);
    let pool = pool(&form, &mut problems);
    let mut paths = PathsOfCases::of(&top);
    let parts = parts(&form, &names, &mut paths, &mut problems);
    if is_quick && (!describes_quick(&form) || parts.iter().all(|part| !part.in_quick)) {
        let cure = "give a factor quick = [\"30 deg\"], or a part quick = false; or leave out --quick";
        problems.add("", "the study has no quick version", cure);
    }
    if !problems.is_empty() {
        return Err(form.error(problems));
    }
    let cases = match expanded {
        Some(cases) if cases.len() == paths.list.len() => cases,
        _ => paths.read(path, &form)?,
    };
    let study = Study {
        title: top.text("title").unwrap_or_else(|| name.to_owned()),
        name: name.to_owned(),
        is_quick,
        cases,
        responses: top.words("responses").unwrap_or_default(),
        all_closed_forms: top.text("closed_forms").as_deref() == Some("all"),
        factors,
        parts,
        charts,
        style,
        pool,
    };
    super::checks::check(&form, &study, &mut problems);
    if problems.is_empty() { Ok(study) } else { Err(form.error(problems)) }
}

/// Whether a factor or a part says what differs in the quick version.
fn describes_quick(form: &Form) -> bool {
    let sections = |kind: &str| named(form, kind, &mut Problems::default());
    let all = sections("factor").into_iter().chain(sections("part"));
    all.into_iter().any(|(_, entries)| find(&entries, "quick").is_some())
}

/// The files of the cases as typed, each once, with the place of the key that names it first.
struct PathsOfCases {
    list: Vec<[String; 2]>,
}

impl PathsOfCases {
    fn of(top: &Section) -> Self {
        Self { list: vec![[top.text("case").unwrap_or_default(), "case".to_owned()]] }
    }

    /// The number of a file, which is new where it was not named before.
    fn number(&mut self, typed: String, at: String) -> usize {
        let known = self.list.iter().position(|[known, _]| *known == typed);
        known.unwrap_or_else(|| {
            self.list.push([typed, at]);
            self.list.len() - 1
        })
    }

    /// The files, relative to the folder of the study.
    fn read(&self, study: &Path, form: &Form) -> Result<Vec<BaseCase>, CaseError> {
        let folder = study.parent().unwrap_or(Path::new(""));
        let mut problems = Problems::default();
        let mut cases = Vec::new();
        for [typed, at] in &self.list {
            let found = folder.join(typed);
            match case::text(&found) {
                Ok(text) => cases.push(BaseCase { path: found.display().to_string(), text }),
                Err(error) => {
                    let why = error.problems.first().map_or_else(|| error.to_string(), |p| p.message.clone());
                    problems.add(
                        at.clone(),
                        why,
                        "check the path, which is relative to the folder of the study",
                    );
                }
            }
        }
        if problems.is_empty() { Ok(cases) } else { Err(form.error(problems)) }
    }
}

/// The keys at the top: those of the file, and those of a part.
fn top(form: &Form, problems: &mut Problems) -> Section {
    let own: Vec<&str> = table("").keys.iter().map(|key| key.name).collect();
    let of_part: Vec<&str> = table("part").keys.iter().map(|key| key.name).collect();
    let sections: Vec<&str> = keys::SECTIONS.iter().map(|s| s.name).filter(|name| !name.is_empty()).collect();
    let read = section(&form.entries, &table(""), "", &[of_part, sections].concat(), problems);
    // Of a part, what stands at the top is only looked at for what is wrong with it.
    let part: Vec<Entry> = form.entries.iter().filter(|e| !own.contains(&e.key.as_str())).cloned().collect();
    let sections: Vec<&str> = keys::SECTIONS.iter().map(|s| s.name).collect();
    let _ = section(&part, &table("part"), "", &sections, problems);
    read
}

/// The sections `[kind.NAME]`.
fn named(form: &Form, kind: &str, problems: &mut Problems) -> Vec<(String, Vec<Entry>)> {
    let Some(value) = find(&form.entries, kind) else { return Vec::new() };
    let cure = format!("give every {kind} its own section: [{kind}.NAME]");
    let Value::Table(entries) = value else {
        problems.add(kind, format!("`{kind}` must be a table, not {}", value.kind()), cure);
        return Vec::new();
    };
    let mut found = Vec::new();
    for entry in entries {
        let path = join(kind, &entry.key);
        let plain = |c: char| c.is_ascii_alphanumeric() || "_-".contains(c);
        match &entry.value {
            Value::Table(_) if entry.key.is_empty() || !entry.key.chars().all(plain) => {
                let message = format!("`{}` is not a name of a {kind}", entry.key);
                problems.add_to_name(path, message, "use letters, digits, - and _ only");
            }
            Value::Table(inner) => found.push((entry.key.clone(), inner.clone())),
            other => {
                let message = format!("`{path}` must be a section, not {}", other.kind());
                problems.add_to_name(path, message, cure.clone());
            }
        }
    }
    found
}

/// A factor; `None` where it is wrong.
fn factor(name: &str, entries: &[Entry], is_quick: bool, problems: &mut Problems) -> Option<Factor> {
    let path = join("factor", name);
    let read = section(entries, &table("factor"), &path, &[], problems);
    let items = |key: &str| match read.as_typed(key) {
        Some(Value::List(items)) => items,
        _ => Vec::new(),
    };
    let (values, range, quick) = (items("values"), items("range"), items("quick"));
    let at = |key: &str| join(&path, key);
    if !read.has("values") && !read.has("range") {
        let cure = "give it values = [\"30 deg\", \"35 deg\"], or range = [\"30 deg\", \"45 deg\"]";
        problems.add_to_name(
            path.clone(),
            format!("the factor `{name}` has neither values nor a range"),
            cure,
        );
        return None;
    }
    if read.has("range") && range.len() != 2 {
        problems.add(
            at("range"),
            "a range has two values, low and high",
            "write range = [\"30 deg\", \"45 deg\"]",
        );
        return None;
    }
    let key = read.text("key");
    if let Some(key) = &key {
        accepted(key, &path, [("values", &values), ("range", &range), ("quick", &quick)], problems)?;
    }
    let all: Vec<Value> = values.iter().chain(&range).chain(&quick).cloned().collect();
    let (unit, numbers) = match numbers_of(&all) {
        Some((unit, numbers)) => (Some(unit), numbers),
        None => (None, Vec::new()),
    };
    let mut factor = Factor {
        name: name.to_owned(),
        key,
        label: read.text("label").unwrap_or_else(|| name.to_owned()),
        unit,
        levels: Vec::new(),
        range: None,
        logarithmic: read.text("scale").as_deref() == Some("logarithmic"),
    };
    let (of_values, others) = numbers.split_at(values.len().min(numbers.len()));
    let (of_range, of_quick) = others.split_at(range.len().min(others.len()));
    spread(&mut factor, &read, (&values, of_values, of_range), problems)?;
    if is_quick && read.has("quick") {
        factor.levels = levels(&quick, of_quick);
    }
    Some(factor)
}

/// Whether the key of a factor exists, and takes its values.
fn accepted(key: &str, path: &str, lists: [(&str, &[Value]); 3], problems: &mut Problems) -> Option<()> {
    let mut is_accepted = true;
    for (list, values) in lists {
        for (n, value) in values.iter().enumerate() {
            if let Err([message, cure]) = accepts(key, value) {
                let is_unknown = coulter::case::keys::at(key).is_none();
                let at = if is_unknown { join(path, "key") } else { format!("{path}.{list}[{n}]") };
                problems.add(at, message, cure);
                is_accepted = false;
            }
        }
    }
    is_accepted.then_some(())
}

/// Gives a factor its range and its levels.
fn spread(
    factor: &mut Factor,
    read: &Section,
    (values, of_values, of_range): (&[Value], &[f64], &[f64]),
    problems: &mut Problems,
) -> Option<()> {
    let at = |key: &str| read.at(key);
    let is_numeric = factor.unit.is_some();
    if (read.has("range") || read.has("levels")) && !is_numeric {
        let message = "the values are not numbers of one kind, between which there is nothing";
        problems.add(
            at("range"),
            message,
            "give values = […] without a range, or numbers with the same unit",
        );
        return None;
    }
    let numbers = if of_range.is_empty() { of_values } else { of_range };
    let (low, high) =
        numbers.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), n| (l.min(*n), h.max(*n)));
    if is_numeric {
        if read.has("range") && of_range[0] >= of_range[1] {
            problems.add(at("range"), "the low end is not below the high end", "write the lower value first");
            return None;
        }
        if factor.logarithmic && low <= 0.0 {
            problems.add(at("scale"), "a logarithmic scale needs values above 0", "write scale = \"linear\"");
            return None;
        }
        factor.range = Some([low, high]);
    }
    factor.levels = if read.has("values") {
        levels(values, of_values)
    } else {
        let count = read.number("levels").unwrap_or(0.0) as usize;
        let fraction = |n: usize| n as f64 / (count.max(2) - 1) as f64;
        (0..count).filter_map(|n| factor.at(fraction(n))).map(|number| factor.level(number)).collect()
    };
    Some(())
}

/// The levels of values as typed, with their numbers in the unit of the factor; none of words.
fn levels(values: &[Value], numbers: &[f64]) -> Vec<Level> {
    let number = |n: usize| numbers.get(n).copied();
    values.iter().enumerate().map(|(n, value)| Factor::level_of(value, number(n))).collect()
}

fn charts(form: &Form, whence: Whence<'_>, factors: &[Factor], problems: &mut Problems) -> Vec<ChartWish> {
    let mut all = Vec::new();
    for (name, entries) in named(form, "chart", problems) {
        let mut made = chart(&name, &entries, problems);
        let axes = Axes { chart: &name, columns: [&made.x, &made.y], is_history: made.history };
        made.measured = measured_points::read(&axes, &entries, whence, factors, problems);
        all.push(made);
    }
    all
}

fn chart(name: &str, entries: &[Entry], problems: &mut Problems) -> ChartWish {
    let read = section(entries, &table("chart"), &join("chart", name), &[], problems);
    let scale = read.text("scale").unwrap_or_default();
    ChartWish {
        name: name.to_owned(),
        x: read.text("x").unwrap_or_default(),
        y: read.text("y").unwrap_or_default(),
        family: read.text("family"),
        part: read.text("part"),
        logarithmic: scale == "logarithmic",
        logarithmic_x: scale == "logarithmic-x",
        collapse: read.flag("collapse").unwrap_or(false),
        history: read.flag("history").unwrap_or(false),
        measured: Vec::new(),
        columns: read.number("columns").unwrap_or(1.0) as usize,
        legend: LegendPlace::of_word(&read.text("legend").unwrap_or_default()),
        ranges: [("x_range", scale != "linear"), ("y_range", scale == "logarithmic")].map(|(key, is_log)| {
            let ends = <[f64; 2]>::try_from(read.list(key)?).ok()?;
            if ends[0] == ends[1] || (is_log && ends.iter().any(|end| *end <= 0.0)) {
                let cure = "give two numbers that differ, above 0 on a logarithmic axis: [0.1, 10]";
                problems.add(read.at(key), "an axis cannot have these ends", cure);
            }
            Some(ends)
        }),
        labels: ["x_label", "y_label"].map(|key| read.text(key)),
    }
}

/// A section that a file has at most once.
fn single(form: &Form, name: &str, problems: &mut Problems) -> Section {
    let entries = match find(&form.entries, name) {
        Some(Value::Table(entries)) => entries.clone(),
        Some(other) => {
            let message = format!("`{name}` must be a section, not {}", other.kind());
            problems.add(name, message, format!("write it as a heading: [{name}]"));
            Vec::new()
        }
        None => Vec::new(),
    };
    section(&entries, &table(name), name, &[], problems)
}

fn style(form: &Form, problems: &mut Problems) -> StudyStyle {
    let read = single(form, "style", problems);
    let usual = FigureStyle::default();
    let width = |key: &str, otherwise: f64| read.number(key).map_or(otherwise, |metres| 1e3 * metres);
    StudyStyle {
        widths: [width("width_one", 90.0), width("width_two", 190.0)],
        aspect: read.number("aspect"),
        figure: FigureStyle {
            font_size: read.number("font_size").unwrap_or(usual.font_size),
            line_width: read.number("line_width").unwrap_or(usual.line_width),
            mark_size: read.number("mark_size").unwrap_or(usual.mark_size),
            is_coloured: read.text("colour").as_deref() != Some("black"),
            ..usual
        },
    }
}

fn pool(form: &Form, problems: &mut Problems) -> Pool {
    let read = single(form, "pool", problems);
    Pool {
        workers: read.number("workers").map(|count| count as usize),
        threads: read.number("threads").map_or(1, |count| count as usize),
    }
}

/// The parts; without any section of them the study is one.
fn parts(form: &Form, names: &[String], cases: &mut PathsOfCases, problems: &mut Problems) -> Vec<Part> {
    let of_part = |entry: &&Entry| table("part").keys.iter().any(|key| key.name == entry.key);
    let shared: Vec<Entry> = form.entries.iter().filter(of_part).cloned().collect();
    let sections = named(form, "part", problems);
    if sections.is_empty() {
        return vec![part(("", ""), [&shared, &[]], (names, cases), problems)];
    }
    sections
        .iter()
        .map(|(name, own)| part((name, &join("part", name)), [own, &shared], (names, cases), problems))
        .collect()
}

/// A part, from its own keys and those that it shares with others.
fn part(
    (name, path): (&str, &str),
    [own, shared]: [&[Entry]; 2],
    (names, cases): (&[String], &mut PathsOfCases),
    problems: &mut Problems,
) -> Part {
    // What is shared was checked where it stands.
    let own_read = section(own, &table("part"), path, &[], problems);
    let shared_read = section(shared, &table("part"), "", &[], &mut Problems::default());
    let of = |key: &str| if own_read.has(key) { &own_read } else { &shared_read };
    let design = Design::of(&of("design").text("design").unwrap_or_default());
    let words = of("models").words("models").unwrap_or_else(|| vec!["closed-form".to_owned()]);
    let mut factors = Vec::new();
    for (n, typed) in of("factors").words("factors").unwrap_or_else(|| names.to_vec()).iter().enumerate() {
        match names.iter().position(|name| name == typed) {
            Some(number) if factors.contains(&number) => {
                let at = format!("{}[{n}]", of("factors").at("factors"));
                problems.add(at, format!("the factor `{typed}` is named twice"), "name every factor once");
            }
            Some(number) => factors.push(number),
            None => {
                let near = nearest(typed, names.iter().map(String::as_str));
                let known = || format!("known: {}", names.join(", "));
                let cure = near.map_or_else(known, |near| format!("did you mean `{near}`?"));
                let at = format!("{}[{n}]", of("factors").at("factors"));
                problems.add(at, format!("there is no factor `{typed}`"), cure);
            }
        }
    }
    let points = of("points").number("points");
    if design.fills_space() && points.is_none() && !of("points").has("points") {
        problems.add(
            join(path, "points"),
            "`points` is missing: how many points the design has",
            "add points = 64",
        );
    }
    let case = own_read.text("case").map_or(0, |typed| cases.number(typed, join(path, "case")));
    // What the top of the file sets and derives belongs to its own case.
    let with_keys: Vec<(&Section, &str)> = [(&shared_read, ""), (&own_read, path)]
        .into_iter()
        .filter(|(_, at)| case == 0 || !at.is_empty())
        .collect();
    Part {
        name: name.to_owned(),
        case,
        meshes: of("intervals")
            .flag("intervals")
            .filter(|is_wanted| *is_wanted)
            .map(|_| of("meshes").number("meshes").unwrap_or(3.0) as usize),
        in_quick: own_read.flag("quick").unwrap_or(true),
        models: ModelKind::all_of(&words),
        design,
        points: points.filter(|_| design.fills_space()).unwrap_or(0.0) as usize,
        seed: of("seed").number("seed").unwrap_or(1.0) as u64,
        factors,
        set: with_keys.iter().flat_map(|(read, at)| set(read, at, problems)).collect(),
        derived: with_keys.iter().flat_map(|(read, at)| derived(read, at, problems)).collect(),
    }
}

fn set(read: &Section, path: &str, problems: &mut Problems) -> Vec<(String, String)> {
    let mut list = Vec::new();
    for (key, value) in assignments(read.as_typed("set"), "") {
        match accepts(&key, &value) {
            Ok(()) => list.push((key, super::factor::toml_of(&value))),
            Err([message, cure]) => problems.add(format!("{}.{key}", join(path, "set")), message, cure),
        }
    }
    list
}

fn derived(read: &Section, path: &str, problems: &mut Problems) -> Vec<(String, Expression)> {
    let mut list = Vec::new();
    for (key, value) in assignments(read.as_typed("derived"), "") {
        let at = format!("{}.{key}", join(path, "derived"));
        const CURE: &str = "write a formula of factors and keys, such as \"t_bar * body.disc.diameter\"";
        let Value::Text(text) = &value else {
            problems.add(at, format!("expected a formula as text, found {}", value.kind()), CURE);
            continue;
        };
        if coulter::case::keys::at(&key).is_none() {
            problems.add(
                at,
                format!("there is no key `{key}` in a case"),
                "name a key such as body.disc.thickness",
            );
            continue;
        }
        match expression::parse(text) {
            Ok(read) => list.push((key, read)),
            Err(why) => problems.add(at, format!("`{text}` cannot be read: {why}"), CURE),
        }
    }
    list
}
