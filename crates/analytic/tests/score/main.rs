//! Which of the full friction angle, Davis' angle and 3D-RFT to believe when: scores beside measurements and the solver.
//!
//! `scripts/forecast_score` prints the tables; they stand in docs/forecast.md, and this test fails where they are not up to date
//! (`COULTER_UPDATE=1` rewrites them). Parameters of the measured sand are fixed before any row of the wheel: γ as measured; φ in two
//! ways, the angle of repose and the angle that fits the plate best; μ assumed.
#![allow(clippy::unwrap_used)] // clippy does not recognise test helpers

mod rows;

use analytic::forecast::{Candidate, Parameter, Prediction, Strength, predict};
use analytic::uncertainty::{Distribution, propagate_towing, sweep_table};
use analytic::{Forecast, Load, Towing, forecast};
use rows::{Class, PLATE_CURVE, Row, measured_sand, rows};
use std::fmt::Write;

/// An answer that is scored.
#[derive(Clone, Copy, PartialEq)]
enum Answer {
    Plasticity(Strength),
    Resistive,
}

const ANSWERS: [Answer; 3] =
    [Answer::Plasticity(Strength::Full), Answer::Plasticity(Strength::Davis), Answer::Resistive];

impl Answer {
    fn of(self, case: &Towing) -> Option<Prediction> {
        let model = match self {
            Self::Resistive => Candidate::SpatialResistive,
            Self::Plasticity(_) if case.pressed => Candidate::Footing,
            Self::Plasticity(_) if case.body.block().is_some_and(|b| b.plane_strain) => {
                Candidate::PlaneStrain
            }
            Self::Plasticity(_) if case.body.block().is_some() => Candidate::Wedge,
            Self::Plasticity(_) => Candidate::Governing,
        };
        let case = match self {
            Self::Plasticity(strength) => strength.applied(case).ok()?,
            Self::Resistive => case.clone(),
        };
        predict(model, &case, None).ok()
    }

    /// The friction angle [deg] at which it fits the measured plate best, by least squares of the force over 5 to 25 mm. Davis'
    /// angle is taken from the angle that the full one needs: a fit of its own would make the two the same.
    fn fitted_to_the_plate(self) -> f64 {
        let answer = if self == Self::Resistive { self } else { ANSWERS[0] };
        let misfit = |degrees: f64| -> f64 {
            let plate = rows().into_iter().filter(|row| row.class == Class::Plate);
            plate
                .zip(PLATE_CURVE)
                .map(|(row, (_, force))| {
                    let case = Towing { soil: measured_sand(degrees), ..row.case };
                    (answer.of(&case).unwrap().vertical - force).powi(2)
                })
                .sum()
        };
        let angles = (0..=120).map(|n| 28.0 + 0.05 * f64::from(n));
        angles.min_by(|a, b| misfit(*a).total_cmp(&misfit(*b))).unwrap()
    }
}

/// Error of a drag [N], relative to the measured drag or a tenth of the load, whichever is larger.
fn drag_error(row: &Row, found: &Prediction) -> Option<f64> {
    let drag = row.drag?;
    let load = row.vertical.unwrap_or(found.vertical);
    Some((found.drag - drag) / drag.abs().max(0.1 * load))
}

/// Relative error of the sinkage, or of the vertical force at a held sinkage.
fn depth_error(row: &Row, found: &Prediction) -> Option<f64> {
    match (row.sinkage, row.vertical) {
        (Some(z), _) => Some(found.sinkage? / z - 1.0),
        (None, Some(force)) => Some(found.vertical / force - 1.0),
        _ => None,
    }
}

fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let half = values.len() / 2;
    match values.len() {
        0 => None,
        n if n % 2 == 1 => Some(values[half]),
        _ => Some(0.5 * (values[half - 1] + values[half])),
    }
}

/// The row with the friction angle [deg], if one is given.
fn case_at(row: &Row, degrees: Option<f64>) -> Towing {
    let mut case = row.case.clone();
    if let Some(degrees) = degrees {
        case.soil = measured_sand(degrees);
    }
    case
}

type ErrorOf = fn(&Row, &Prediction) -> Option<f64>;

/// The median error of an answer over a class.
fn score(class: Class, answer: Answer, degrees: Option<f64>, error: ErrorOf) -> Option<f64> {
    let case = |row: &Row| case_at(row, degrees);
    // A row without an answer counts as an error without limit, where there is such a figure at all.
    let of = |row: &Row| match answer.of(&case(row)) {
        Some(found) => Some(error(row, &found)?.abs()),
        None => error(row, &ANSWERS[0].of(&case(row))?).map(|_| f64::INFINITY),
    };
    median(rows().iter().filter(|row| row.class == class).filter_map(of).collect())
}

/// The friction angles at which a class is scored, by answer, and what they are called.
fn angles(class: Class) -> Vec<(String, [Option<f64>; 3])> {
    if !class.is_measured() {
        let of_class = rows().into_iter().filter(|row| row.class == class);
        let mut degrees: Vec<i64> =
            of_class.map(|row| row.case.soil.friction_angle.to_degrees().round() as i64).collect();
        degrees.sort_unstable();
        degrees.dedup();
        let name: Vec<String> = degrees.iter().map(|angle| format!("{angle}°")).collect();
        return vec![(name.join(", "), [None; 3])];
    }
    let fitted = ANSWERS.map(Answer::fitted_to_the_plate);
    vec![
        ("29°, repose".into(), [Some(29.0); 3]),
        (format!("{:.1}° ({:.1}°), plate", fitted[0], fitted[2]), fitted.map(Some)),
    ]
}

fn percent(value: Option<f64>) -> String {
    match value {
        None => "–".into(),
        Some(x) if x.is_infinite() => "no answer".into(),
        Some(x) => format!("{:.0} %", 100.0 * x),
    }
}

/// The table of medians.
fn table_of_scores() -> String {
    let mut text = String::from(
        "| rows | φ (3D-RFT) | error of | full angle | Davis' angle | 3D-RFT |\n|---|---|---|--:|--:|--:|\n",
    );
    for class in Class::ALL {
        for (name, degrees) in angles(class) {
            for (what, error) in [("sinkage, vertical force", depth_error as ErrorOf), ("drag", drag_error)] {
                let medians = [0, 1, 2].map(|n| score(class, ANSWERS[n], degrees[n], error));
                if medians.iter().any(Option::is_some) {
                    let [full, davis, resistive] = medians.map(percent);
                    let class = class.name();
                    writeln!(text, "| {class} | {name} | {what} | {full} | {davis} | {resistive} |").unwrap();
                }
            }
        }
    }
    text
}

/// The recommended answer for a measured row, with its interval as the forecast gives it: `(value, low, high)` by figure.
fn recommended(case: &Towing) -> (Candidate, Vec<[f64; 3]>) {
    let Forecast { models, recommended, .. } = forecast(case).unwrap();
    let model = recommended.unwrap();
    let found = models.iter().find(|m| m.model == model).unwrap().prediction.unwrap();
    let normal = |mean: f64, deviation: f64| Distribution::Normal { mean, deviation };
    let mut inputs = vec![(Parameter::FrictionAngle, normal(case.soil.friction_angle, 2_f64.to_radians()))];
    if !case.pressed {
        inputs.push((Parameter::BodyFriction, normal(case.soil.body_friction, 0.1)));
    }
    let table = sweep_table(case, &inputs);
    let own = Distribution::LogNormal { median: 1.0, log_deviation: model.log_error(case) };
    inputs.push((Parameter::ResistanceFactor, own));
    let spread = propagate_towing(case, &inputs, model, 512, 1, table.as_ref()).unwrap();
    let ends = |value: f64, quantiles: [f64; 3]| [value, quantiles[0].min(value), quantiles[2].max(value)];
    let figures = match case.load {
        Load::Weight(_) => {
            let z = spread.sinkage.unwrap().quantiles;
            vec![ends(found.drag, spread.drag.quantiles), ends(found.sinkage.unwrap(), z)]
        }
        Load::Sinkage(_) => vec![ends(found.vertical, spread.vertical.quantiles)],
    };
    (model, figures)
}

/// The table of the measured rows beside the recommended answer; and how many figures lie in their interval.
fn table_of_intervals() -> (String, usize, usize) {
    let mut text = String::from(
        "| row | figure | measured | recommended | value | 5–95 % | measured inside |\n|---|---|--:|---|--:|--:|---|\n",
    );
    let (mut inside, mut all) = (0, 0);
    let full = ANSWERS[0].fitted_to_the_plate();
    for row in rows().iter().filter(|row| row.class.is_measured()) {
        let degrees = if row.case.pressed { ANSWERS[2].fitted_to_the_plate() } else { full };
        let (model, figures) = recommended(&case_at(row, Some(degrees)));
        let measured =
            [row.drag.map(|x| ("drag [N]", x, 1.0)), row.sinkage.map(|x| ("sinkage [mm]", x, 1e3))];
        let measured = measured.into_iter().chain([row.vertical.map(|x| ("vertical force [N]", x, 1.0))]);
        for ((what, found, size), [value, low, high]) in measured.flatten().zip(figures) {
            assert!(low <= value && value <= high);
            let is_inside = low <= found && found <= high;
            (inside, all) = (inside + usize::from(is_inside), all + 1);
            let shown = |x: f64| format!("{:.1}", size * x);
            writeln!(
                text,
                "| {} | {what} | {} | {} | {} | {} to {} | {} |",
                row.label,
                shown(found),
                model.name(),
                shown(value),
                shown(low),
                shown(high),
                if is_inside { "yes" } else { "**no**" }
            )
            .unwrap();
        }
    }
    (text, inside, all)
}

const BEGIN: &str = "<!-- score:begin -->\n";
const END: &str = "<!-- score:end -->";

#[test]
fn the_scores_are_those_of_the_documentation() {
    let (intervals, inside, all) = table_of_intervals();
    let text = format!(
        "{}\nThe measured rows beside the recommended model at the friction angle that fits the plate: {inside} of {all} figures lie \
         in their interval.\n\n{intervals}",
        table_of_scores()
    );
    println!("{text}");
    assert!(4 * inside >= 3 * all, "{inside} of {all}");
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/forecast.md");
    let page = std::fs::read_to_string(path).unwrap();
    let (before, rest) = page.split_once(BEGIN).unwrap();
    let (shown, after) = rest.split_once(END).unwrap();
    if std::env::var_os("COULTER_UPDATE").is_some() {
        std::fs::write(path, format!("{before}{BEGIN}{text}{END}{after}")).unwrap();
    } else {
        assert_eq!(shown, text, "run COULTER_UPDATE=1 cargo test --release -p coulter-analytic --test score");
    }
}

/// The rule of docs/forecast.md: what is recommended has the smallest median error of its class.
#[test]
fn the_recommendation_follows_from_the_scores() {
    let best = |class: Class, angle: usize, error: ErrorOf| {
        let (_, degrees) = angles(class).swap_remove(angle);
        let of = |n: usize| score(class, ANSWERS[n], degrees[n], error).unwrap_or(f64::INFINITY);
        (0..3).min_by(|a, b| of(*a).total_cmp(&of(*b))).unwrap()
    };
    for class in [Class::Plate, Class::PressedWheel] {
        assert_eq!([0, 1].map(|angle| best(class, angle, depth_error)), [2, 2], "{}", class.name());
    }
    assert_eq!([0, 1].map(|angle| best(Class::TowedWheel, angle, drag_error)), [0, 0]);
    assert_eq!(best(Class::SolverPressed, 0, depth_error), 0);
    assert_eq!(best(Class::SolverTowed, 0, depth_error), 0);
    assert_eq!(best(Class::SolverFootings, 0, depth_error), 0);
    assert_eq!(best(Class::SolverWalls, 0, drag_error), 1);
}
