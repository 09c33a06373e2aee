//! Which of the full friction angle, Davis' angle and 3D-RFT to believe when: scores beside measurements and
//! the solver.
//!
//! `scripts/forecast_score` prints the tables; they stand in docs/how-to/forecast.md, and this test fails
//! where they are not up to date (`COULTER_UPDATE=1` rewrites them). Parameters of the measured sand are
//! fixed before any row of the wheel: γ as measured; φ in two ways, the angle of repose and the angle that
//! fits the plate best; μ assumed.
#![allow(clippy::unwrap_used)] // clippy does not recognise test helpers

mod rows;

use analytic::forecast::{Candidate, Parameter, Prediction, Strength, predict};
use analytic::uncertainty::{Distribution, propagate_towing, sweep_table};
use analytic::{Forecast, Load, Towing, forecast};
use rows::{Class, FRICTIONS, PLATE_CURVE, Row, measured_sand, rows};
use std::fmt::Write;
use std::sync::OnceLock;

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

    /// Sum of the squared errors of the force on the measured plate at a friction angle [deg].
    fn misfit(self, degrees: f64) -> f64 {
        let plate = rows().into_iter().filter(|row| row.class == Class::Plate);
        let errors = plate.zip(PLATE_CURVE).map(|(row, (_, force))| {
            let case = Towing { soil: measured_sand(degrees), ..row.case };
            self.of(&case).unwrap().vertical - force
        });
        errors.map(|error| error * error).sum()
    }
}

/// The friction angle [deg] at which each answer fits the measured plate best, by least squares of the force
/// over 5 to 25 mm. Davis' angle is taken from the angle that the full one needs: a fit of its own would make
/// the two the same.
fn fitted_to_the_plate() -> [f64; 3] {
    static FITTED: OnceLock<[f64; 3]> = OnceLock::new();
    let fit = |answer: Answer| {
        let angles = (290..=350).map(|tenths| f64::from(tenths) / 10.0);
        let misfits = angles.map(|degrees| (answer.misfit(degrees), degrees));
        misfits.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap().1
    };
    *FITTED.get_or_init(|| {
        let [full, resistive] = [ANSWERS[0], ANSWERS[2]].map(fit);
        [full, full, resistive]
    })
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
    // A case without an answer counts as an error without limit, where there is such a figure at all.
    let of = |row: &Row, case: &Towing| match answer.of(case) {
        Some(found) => Some(error(row, &found)?.abs()),
        None => error(row, &ANSWERS[0].of(case)?).map(|_| f64::INFINITY),
    };
    let all = rows();
    let of_class = all.iter().filter(|row| row.class == class);
    let with_cases = of_class.flat_map(|row| cases(row, degrees).into_iter().map(move |case| (row, case)));
    median(with_cases.filter_map(|(row, case)| of(row, &case)).collect())
}

/// The cases of a row: one, or one for each friction of the measured wheel's rim.
fn cases(row: &Row, degrees: Option<f64>) -> Vec<Towing> {
    let mut case = case_at(row, degrees);
    if !row.class.is_towed_wheel() {
        return vec![case];
    }
    let with = |friction: f64| {
        case.soil.body_friction = friction;
        case.clone()
    };
    FRICTIONS.map(with).to_vec()
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
    let fitted = fitted_to_the_plate();
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

/// The recommended answer for a measured row, with its interval as the forecast gives it: `(value, low,
/// high)` by figure.
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

/// The table of the measured rows beside the recommended answer at friction angles [deg] for towed and for
/// pressed bodies; and how many figures lie in their interval.
fn table_of_intervals([towed, pressed]: [f64; 2]) -> (String, usize, usize) {
    let mut text = String::from(
        "| row | figure | measured | recommended | value | 5–95 % | measured inside |\n|---|---|--:|---|--:|--:|---|\n",
    );
    let (mut inside, mut all) = (0, 0);
    for row in rows().iter().filter(|row| row.class.is_measured()) {
        let degrees = if row.case.pressed { pressed } else { towed };
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
    let [full, _, resistive] = fitted_to_the_plate();
    let (intervals, inside, all) = table_of_intervals([full, resistive]);
    let (_, at_repose, _) = table_of_intervals([29.0; 2]);
    let text = format!(
        "{}\nThe measured rows beside the recommended model at the friction angle that fits the plate, μ = 0.4: {inside} of {all} figures lie in \
         their interval (at the angle of repose {at_repose}).\n\n{intervals}",
        table_of_scores()
    );
    println!("{text}");
    assert!(4 * inside.min(at_repose) >= 3 * all, "{inside} and {at_repose} of {all}");
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/how-to/forecast.md");
    let page = std::fs::read_to_string(path).unwrap();
    let (before, rest) = page.split_once(BEGIN).unwrap();
    let (shown, after) = rest.split_once(END).unwrap();
    if std::env::var_os("COULTER_UPDATE").is_some() {
        std::fs::write(path, format!("{before}{BEGIN}{text}{END}{after}")).unwrap();
    } else {
        assert_eq!(shown, text, "run COULTER_UPDATE=1 cargo test --release -p coulter-analytic --test score");
    }
}

/// The rule of docs/how-to/forecast.md: of the answers that reach over the whole class, the one with the
/// smallest median error is recommended.
#[test]
fn the_recommendation_follows_from_the_scores() {
    let best = |class: Class, angle: usize, answers: &[usize]| {
        let error: ErrorOf = if class == Class::SolverWalls { drag_error } else { depth_error };
        let (_, degrees) = angles(class).swap_remove(angle);
        let of = |n: usize| score(class, ANSWERS[n], degrees[n], error).unwrap_or(f64::INFINITY);
        answers.iter().copied().min_by(|a, b| of(*a).total_cmp(&of(*b))).unwrap()
    };
    const FULL: usize = 0;
    const DAVIS: usize = 1;
    const RESISTIVE: usize = 2;
    for angle in [0, 1] {
        for class in [Class::Plate, Class::PressedWheel] {
            assert_eq!(best(class, angle, &[FULL, DAVIS, RESISTIVE]), RESISTIVE, "{}", class.name());
        }
        // 3D-RFT has no answer for deep discs, strong sand, cohesion.
        for class in [Class::RollingWheel, Class::SlidingWheel] {
            assert_eq!(best(class, angle, &[FULL, DAVIS]), FULL, "{}", class.name());
        }
    }
    for class in [Class::SolverPressed, Class::SolverTowed, Class::SolverFootings] {
        assert_eq!(best(class, 0, &[FULL, DAVIS]), FULL, "{}", class.name());
    }
    assert_eq!(best(Class::SolverWalls, 0, &[FULL, DAVIS]), DAVIS);
}
