//! What a run says in three plain sentences: what happened, whether it can be trusted, and how far it may be
//! off; and its main figures.
//!
//! ± is only said of intervals that were computed, from variations of the case. Without them the
//! scatter over the steady window is given and called so: it says nothing of mesh, domain and speed.

use super::rows::NONE;
use super::summary::{BodySummary, Summary};
use input::readable::{Unit, digits};
use results::confidence::{BodyConfidence, Status};
use results::folder::RunRecord;
use results::history::blocks::{STUDENT_90, block_averages, standard_error};
use results::history::quantities::{NO_DRAG, Quantity};
use results::history::reference::Reference;
use results::history::steady::SteadyWindow;
use results::history::{BodySample, History};
use results::trust::{Check, Verdict};
use serde::Serialize;

/// Distance of an interval's middle from the value, over its half-width, up to which the value is written
/// with ±.
const LOPSIDED: f64 = 0.15;
/// Turn ratios from here on are those of a driven body.
const DRIVEN: f64 = 1.0;

/// Power of the axle over that of the tow above which the body is driven, not free to turn (chosen).
const NOTICEABLE: f64 = 0.05;

/// A main figure of a body.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Tile {
    name: &'static str,
    value: String,
    /// Interval or scatter; empty for neither.
    spread: String,
}

/// A steady mean, and what is known of how far it may be off.
#[derive(Clone, Copy, Debug, Default)]
struct Figure {
    value: f64,
    interval: Option<[f64; 2]>,
    /// Half of the interval (90 %) of the mean from averages over blocks of the steady window.
    scatter: Option<f64>,
}

/// A body with its history.
struct View<'a> {
    reference: &'a Reference,
    summary: &'a BodySummary,
    /// Intervals from variations of the case.
    confidence: Option<&'a BodyConfidence>,
    samples: &'a [BodySample],
    /// Whether the steady window is at the end of the run.
    ends_run: bool,
}

impl View<'_> {
    /// A quantity by its name.
    fn figure(&self, name: &str) -> Option<Figure> {
        let quantity = Quantity::named(name)?;
        let steady = &self.summary.steady;
        let interval =
            self.confidence.and_then(|body| body.figures.get(&quantity.key())).map(|it| it.interval);
        // Of a body that is pressed down, force and sinkage are meant to change.
        let samples = if self.reference.towed { self.samples } else { &[] };
        let values: Vec<f64> = samples.iter().map(|s| quantity.column.value(s, self.reference)).collect();
        let scatter = block_averages(&values).map(|blocks| STUDENT_90 * standard_error(&blocks));
        let scatter = scatter.filter(|scatter| scatter.is_finite());
        Some(Figure { value: quantity.mean(steady)?, interval, scatter })
    }

    /// What happened to the body.
    fn sentence(&self) -> Option<String> {
        let name = self.reference.name.replace('_', " ");
        let sinkage = self.figure("sinkage").map(|figure| text(&figure, Unit::length));
        if !self.reference.towed {
            let force = self.figure("vertical")?;
            let force = if force.value < 0.0 {
                format!("weighs on the {name} with {}", text(&force.negative(), Unit::force))
            } else {
                format!("bears the {name} with {}", text(&force, Unit::force))
            };
            let seconds =
                |time: Option<f64>| text(&Figure::exact(time.unwrap_or(f64::NAN)), |_| Unit::of("s", 1.0));
            let [from_s, to_s] = [self.summary.steady.from_s, self.summary.steady.to_s];
            let when = match self.ends_run {
                true => "at the end".to_owned(),
                false => format!("from {} to {}", seconds(from_s), seconds(to_s)),
            };
            let deepest = self.summary.peak.sinkage.map(|z| text(&Figure::exact(z), Unit::length));
            let depth = deepest.map_or(String::new(), |z| format!("; it is at most {z} deep"));
            return Some(format!("The soil {force} {when}{depth}."));
        }
        let drag = self.figure("drag")?;
        let force = if drag.value < 0.0 {
            format!("pulls with {}", text(&drag.negative(), Unit::force))
        } else {
            format!("resists the tow with {}", text(&drag, Unit::force))
        };
        let depth = sinkage.map_or(String::new(), |z| format!(" at a sinkage of {z}"));
        let slope = on_slope(-drag.value, self.reference.weight_along.unwrap_or(0.0));
        Some(format!("The {name} {force}{slope}{depth}{}.", self.rolling()))
    }

    /// How the body rolls, as the end of a sentence.
    fn rolling(&self) -> String {
        let Some(ratio) = self.figure("turn_ratio").filter(|_| self.reference.turns) else {
            return String::new();
        };
        if ratio.value > DRIVEN {
            let slip = self
                .summary
                .steady
                .slip
                .map_or(String::new(), |slip| format!(" with a slip of {}", digits(slip)));
            return format!(", and is driven{slip}");
        }
        format!(", and turns at {} of the rate of free rolling", text(&ratio, |size| Unit::of("-", size)))
    }

    fn tiles(&self) -> Vec<Tile> {
        let tile = |name, figure: Option<Figure>, unit: fn(f64) -> Unit| {
            figure.map(|figure| Tile { name, value: value(&figure, unit), spread: spread(&figure, unit) })
        };
        let bears = self.summary.steady.vertical.map_or(0.0, f64::abs);
        let drag =
            self.figure("drag").filter(|drag| self.reference.towed || drag.value.abs() > NO_DRAG * bears);
        let pull = drag.filter(|figure| figure.value < 0.0).map(|figure| figure.negative());
        let towed = self.reference.towed;
        let power = self.summary.steady.traction;
        let towing = power.tow_power.map_or(0.0, f64::abs);
        let watts =
            |name, power: Option<f64>| tile(name, power.map(Figure::exact), |size| Unit::of("W", size));
        [
            if pull.is_some() {
                let is_level = self.reference.weight_along.is_none();
                tile(if is_level { "Drawbar pull" } else { "Traction" }, pull, Unit::force)
            } else {
                tile("Drag", drag, Unit::force)
            },
            tile("Vertical force", self.figure("vertical"), Unit::force),
            tile("Sinkage", self.figure("sinkage"), Unit::length),
            tile("Turn ratio", self.figure("turn_ratio").filter(|_| self.reference.turns), |size| {
                Unit::of("-", size)
            }),
            watts("Tow power", power.tow_power.filter(|p| towed && *p > 0.0)),
            watts("Axle power", power.axle_power.filter(|p| *p > NOTICEABLE * towing)),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

/// Part of the weight along a slope within which a pull is as large (chosen: that of a wheel that climbs
/// freely is within 0.3 %).
const BALANCED: f64 = 0.02;

/// What of the force of the soil [N] goes into carrying a body up a slope, whose weight draws it down with
/// `weight` [N].
fn on_slope(pull: f64, weight: f64) -> String {
    let shown = text(&Figure::exact(weight.abs()), Unit::force);
    match () {
        () if weight == 0.0 => String::new(),
        () if weight < 0.0 => format!(" (its weight draws it forwards with {shown})"),
        () if (pull - weight).abs() <= BALANCED * weight => {
            " (as much as its weight draws it down the slope)".to_owned()
        }
        () if pull > weight => format!(" (of which {shown} carry its weight up the slope)"),
        () => format!(" (while its weight draws it down the slope with {shown}, and it has to be held)"),
    }
}

impl Figure {
    fn exact(value: f64) -> Self {
        Self { value, ..Self::default() }
    }

    fn negative(&self) -> Self {
        Self { value: -self.value, interval: self.interval.map(|[low, high]| [-high, -low]), ..*self }
    }
}

/// The steady window's samples of each body that touches the soil.
fn views<'a>(record: &'a RunRecord, summary: &'a Summary, history: &'a History) -> Vec<View<'a>> {
    let bodies = record.steady_windows(history).filter(|window| window.reference.has_surface());
    let view = |window: SteadyWindow<'a>| {
        let (reference, samples) = (window.reference, window.inside());
        let confidence = summary.confidence.as_ref().and_then(|all| all.bodies.get(&reference.name));
        let ends_run = window.range.end == window.samples.len();
        Some(View { reference, summary: summary.bodies.get(&reference.name)?, confidence, samples, ends_run })
    };
    bodies.filter_map(view).collect()
}

/// The main figures of a body.
pub(super) fn tiles(record: &RunRecord, summary: &Summary, history: &History, body: &str) -> Vec<Tile> {
    let views = views(record, summary, history);
    views.iter().find(|view| view.reference.name == body).map_or(Vec::new(), View::tiles)
}

/// The sentences: what happened, whether it can be trusted, how far it may be off.
pub(super) fn sentences(record: &RunRecord, summary: &Summary, history: &History) -> Vec<String> {
    let views = views(record, summary, history);
    let all = [happened(record, summary, &views), Some(trusted(summary)), uncertain(summary, &views)];
    // A number and its per cent sign stay on one line.
    all.into_iter().flatten().map(|sentence| sentence.replace(" %", "\u{a0}%")).collect()
}

fn happened(record: &RunRecord, summary: &Summary, views: &[View<'_>]) -> Option<String> {
    let is_moved = |view: &&View<'_>| record.moved_bodies().any(|body| body.name == view.reference.name);
    let moved: Vec<&View<'_>> = views.iter().filter(is_moved).collect();
    match &moved[..] {
        [] => None,
        [view] => view.sentence(),
        _ => {
            let all = summary.all_bodies.as_ref()?;
            let force =
                |force: Option<f64>| force.map_or(NONE.into(), |f| text(&Figure::exact(f), Unit::force));
            let (drag, vertical) = (force(all.get("drag")), force(all.get("vertical")));
            Some(format!(
                "The {} bodies together resist the tow with {drag}; the soil bears them with {vertical}.",
                moved.len()
            ))
        }
    }
}

fn trusted(summary: &Summary) -> String {
    let count = summary.trust.checks.len();
    let concerns = summary.trust.concerns();
    let worst = |check: &&Check| {
        let of = check.body.as_ref().map_or(String::new(), |body| format!(" of {body}"));
        let value = check
            .value
            .map_or(String::new(), |v| format!(" ({} {})", digits(v), check.unit).replace(" )", ")"));
        format!("above all {}{of}{value}", check.name)
    };
    let above = concerns.first().map(worst).unwrap_or_default();
    match summary.trust.verdict {
        Verdict::Good => format!(
            "The result is good: all {count} checks are within the limits that an experienced user would set."
        ),
        Verdict::Doubtful => {
            format!("The result is doubtful: {} of {count} checks limit its use, {above}.", concerns.len())
        }
        Verdict::Broken => format!(
            "The result is broken and must not be used: {} of {count} checks fail or limit it, {above}.",
            concerns.len()
        ),
    }
}

/// The largest relative half-width of an interval: of which figure, and where it mostly comes from.
fn largest_interval(summary: &Summary) -> Option<(String, f64, &'static str)> {
    let mut found: Vec<(String, f64, &'static str)> = Vec::new();
    if let Some(confidence) = &summary.confidence {
        for (key, figure) in confidence.bodies.values().flat_map(|body| &body.figures) {
            let source = figure.dominated_by.map_or("", |source| source.word());
            let name = Quantity::keyed(key).map_or(key.as_str(), |quantity| quantity.figure.words);
            found.extend(figure.relative_half_width.map(|width| (name.to_owned(), width, source)));
        }
    }
    found.into_iter().max_by(|a, b| a.1.total_cmp(&b.1))
}

/// The sources that were not asked for, in words: `domain and speed were`.
fn not_asked_for(summary: &Summary) -> String {
    let variations = summary.confidence.iter().flat_map(|confidence| &confidence.variations);
    let words: Vec<&str> =
        variations.filter(|v| v.status == Status::NotAskedFor).map(|v| v.source.word()).collect();
    match &words[..] {
        [] => String::new(),
        [one] => format!("{one} was"),
        [others @ .., last] => format!("{} and {last} were", others.join(", ")),
    }
}

fn uncertain(summary: &Summary, views: &[View<'_>]) -> Option<String> {
    if let Some((name, width, source)) = largest_interval(summary) {
        let source = if source.is_empty() { String::new() } else { format!(", mostly due to the {source}") };
        let left_out = not_asked_for(summary);
        let examined = if left_out.is_empty() { String::new() } else { format!("; {left_out} not examined") };
        let name = name.to_lowercase();
        return Some(format!(
            "The largest uncertainty is that of the {name}, ± {} % (90 %){source}{examined}.",
            digits(100.0 * width)
        ));
    }
    let view = views.first()?;
    let (name, figure) = if view.reference.towed {
        ("drag", view.figure("drag")?)
    } else {
        ("vertical force", view.figure("vertical")?)
    };
    let scatter = figure.scatter.map_or(String::new(), |half| {
        let unit = Unit::force(figure.value.abs());
        format!(
            "Over the steady window the mean {name} scatters by ± {} {} (90 %); ",
            error(half / unit.size),
            unit.name
        )
    });
    let rest =
        "how far mesh, domain and speed shift the result was not examined (coulter run --confidence does)";
    let text = format!("{scatter}{rest}.");
    // Without a scatter the sentence begins with the rest.
    Some(text.replacen("how", if scatter.is_empty() { "How" } else { "how" }, 1))
}

/// Value and interval in a sentence.
fn text(figure: &Figure, unit: impl Fn(f64) -> Unit + Copy) -> String {
    match figure.interval {
        None => value(figure, unit),
        Some([low, high]) if is_even(figure.value, [low, high]) => {
            format!("{} {}", value(figure, unit), spread(figure, unit))
        }
        Some(_) => format!("{} ({})", value(figure, unit), spread(figure, unit)),
    }
}

fn is_even(value: f64, [low, high]: [f64; 2]) -> bool {
    (0.5 * (low + high) - value).abs() <= LOPSIDED * 0.5 * (high - low)
}

fn value(figure: &Figure, unit: impl Fn(f64) -> Unit) -> String {
    let unit = unit(figure.value.abs());
    let half = figure.interval.map(|[low, high]| 0.5 * (high - low) / unit.size);
    format!("{} {}", rounded(figure.value / unit.size, half), unit.name).trim_end().to_owned()
}

/// Interval or scatter, in the unit of the value.
fn spread(figure: &Figure, unit: impl Fn(f64) -> Unit) -> String {
    let unit = unit(figure.value.abs());
    let shown = |number: String| format!("{number} {}", unit.name).trim_end().to_owned();
    match (figure.interval, figure.scatter) {
        (Some([low, high]), _) => {
            let half = 0.5 * (high - low) / unit.size;
            let number = |v: f64| rounded(v / unit.size, Some(half));
            if is_even(figure.value, [low, high]) {
                shown(format!("± {}", error(half)))
            } else {
                shown(format!("{} … {}", number(low), number(high)))
            }
        }
        (None, Some(scatter)) => shown(format!("scatter ± {}", error(scatter / unit.size))),
        (None, None) => String::new(),
    }
}

/// An uncertainty with the digits that have a meaning.
fn error(half: f64) -> String {
    rounded(half, Some(half))
}

/// A number with as many decimals as its uncertainty leaves a meaning: one digit of that, two where the first
/// is 1.
fn rounded(number: f64, half: Option<f64>) -> String {
    let Some(half) = half.filter(|half| *half > 0.0 && half.is_finite()) else { return digits(number) };
    let decade = half.log10().floor();
    let leading = half / 10f64.powf(decade);
    let decimals = (-decade + if leading < 2.0 { 1.0 } else { 0.0 }).clamp(0.0, 4.0) as usize;
    format!("{:.decimals$}", number + 0.0).replace('-', "\u{2212}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use results::confidence::{Confidence, ConfidenceInterval};
    use results::history::quantities::Steady;
    use results::trust::Trust;

    fn disc() -> (RunRecord, Summary, History) {
        let reference = Reference {
            name: "disc".into(),
            kind: "disc".into(),
            length: 0.2,
            radius: Some(0.1),
            towed: true,
            turns: true,
            ..Reference::default()
        };
        let sample = |n: u32| BodySample {
            time: f64::from(n),
            displacement: f64::from(n),
            drag: 14.0 + 0.8 * f64::from(n % 2),
            vertical: 100.0,
            sinkage: 0.011,
            ..BodySample::default()
        };
        let steady = Steady {
            drag: Some(14.4),
            vertical: Some(100.0),
            sinkage: Some(0.011),
            turn_ratio: Some(0.667),
            ..Steady::default()
        };
        let record = RunRecord { bodies: vec![reference], steady_fraction: 1.0, ..RunRecord::default() };
        let body = BodySummary { steady, ..BodySummary::default() };
        let summary = Summary { bodies: [("disc".to_owned(), body)].into(), ..Summary::default() };
        let history = History { bodies: vec![(0..99).map(sample).collect()], ..History::default() };
        (record, summary, history)
    }

    #[test]
    fn without_intervals_there_is_scatter_and_no_accuracy() {
        let (record, summary, history) = disc();
        let [what, trust, how_far] = &sentences(&record, &summary, &history)[..] else { panic!() };
        let expected = "The disc resists the tow with 14.4 N at a sinkage of 11.0 mm, and turns at 0.667 of the rate of free rolling.";
        assert_eq!(what, expected);
        assert!(trust.starts_with("The result is good"), "{trust}");
        assert!(how_far.contains("scatters by ±") && how_far.contains("was not examined"), "{how_far}");
        assert!(tiles(&record, &summary, &history, "disc")[0].spread.starts_with("scatter"));
    }

    #[test]
    fn an_obstacle_is_not_towed_and_soil_may_weigh_on_a_body() {
        let (mut record, mut summary, mut history) = disc();
        let alone = sentences(&record, &summary, &history)[0].clone();
        let stone =
            Reference { name: "stone".into(), kind: "sphere".into(), still: true, ..Reference::default() };
        record.bodies.push(stone);
        summary.bodies.insert("stone".to_owned(), summary.bodies["disc"].clone());
        history.bodies.push(history.bodies[0].clone());
        assert_eq!(sentences(&record, &summary, &history)[0], alone);
        record.bodies[0].towed = false;
        summary.bodies.get_mut("disc").unwrap().steady.vertical = Some(-100.0);
        let what = &sentences(&record, &summary, &history)[0];
        assert!(what.starts_with("The soil weighs on the disc with 100 N at the end"), "{what}");
    }

    #[test]
    fn intervals_become_plus_minus_and_lopsided_ones_ranges() {
        let (record, mut summary, history) = disc();
        let figure = |interval| ConfidenceInterval { interval, ..ConfidenceInterval::default() };
        let figures = [("drag_N", [13.6, 15.2]), ("sinkage_m", [0.0105, 0.0135])];
        let figures = figures.map(|(key, interval)| (key.to_owned(), figure(interval))).into();
        let body = BodyConfidence { figures, ..BodyConfidence::default() };
        let bodies = [("disc".to_owned(), body)].into();
        summary.confidence = Some(Confidence { bodies, ..Confidence::default() });
        let what = &sentences(&record, &summary, &history)[0];
        let expected =
            "The disc resists the tow with 14.4 N ± 0.8 N at a sinkage of 11.0 mm (10.5 … 13.5 mm)";
        assert!(what.starts_with(expected), "{what}");
    }

    #[test]
    fn a_body_that_pulls_says_so_and_a_broken_run_names_its_worst_check() {
        let (record, mut summary, history) = disc();
        let steady = &mut summary.bodies.get_mut("disc").unwrap().steady;
        (steady.drag, steady.turn_ratio, steady.slip) = (Some(-7.0), Some(1.4), Some(0.286));
        let check = Check {
            name: "energy balance".into(),
            value: Some(-371.0),
            unit: "%".into(),
            verdict: Verdict::Broken,
            ..Check::default()
        };
        summary.trust = Trust { verdict: Verdict::Broken, checks: vec![check] };
        let all = sentences(&record, &summary, &history);
        assert!(
            all[0].starts_with("The disc pulls with 7.00 N") && all[0].contains("slip of 0.286"),
            "{all:?}"
        );
        assert!(
            all[1].contains("must not be used") && all[1].contains("energy balance (−371\u{a0}%)"),
            "{all:?}"
        );
    }

    #[test]
    fn on_a_slope_a_pull_is_measured_by_the_weight_that_it_carries() {
        let (mut record, mut summary, history) = disc();
        let steady = &mut summary.bodies.get_mut("disc").unwrap().steady;
        (steady.drag, steady.turn_ratio) = (Some(-43.0), Some(1.4));
        for (weight, words) in [
            (
                52.0,
                "pulls with 43.0 N (while its weight draws it down the slope with 52.0 N, and it has to be held)",
            ),
            (43.1, "pulls with 43.0 N (as much as its weight draws it down the slope)"),
            (20.0, "pulls with 43.0 N (of which 20.0 N carry its weight up the slope)"),
            (-20.0, "pulls with 43.0 N (its weight draws it forwards with 20.0 N)"),
        ] {
            record.bodies[0].weight_along = Some(weight);
            let said = &sentences(&record, &summary, &history)[0];
            assert!(said.contains(words), "{said}");
            let names: Vec<_> = tiles(&record, &summary, &history, "disc").iter().map(|t| t.name).collect();
            assert_eq!(names[0], "Traction");
        }
    }

    #[test]
    fn numbers_have_the_digits_that_their_uncertainty_leaves() {
        let pairs = [(14.44, 0.83), (53.108, 0.012), (123.4, 25.0), (2.0, 1.4)];
        assert_eq!(pairs.map(|(number, half)| rounded(number, Some(half))), ["14.4", "53.108", "123", "2.0"]);
        assert_eq!(rounded(14.44, None), "14.4");
    }
}
