//! Which variations a case has, in the order in which they are run, and why some do not apply.

use super::change::{Change, Original, Unnamed, reason};
use super::domain::larger_domain;
use super::source::ErrorSource;
use super::speed::half_speed;
use case::meshes::{CoarserMesh, LEAST_RATIO, RATIO, on_cells, representative_width};
use case::resolved::{Case, Precision};
use input::error::CaseError;
use input::quantity::plain;

/// A case that is varied in one respect.
#[derive(Clone, Debug)]
pub struct Variation {
    /// Name of its folder.
    pub name: String,
    /// What it examines.
    pub source: ErrorSource,
    /// What differs, in words.
    pub what: String,
    /// The case.
    pub case: Case,
    /// Text of the case as a case file.
    pub typed: String,
    /// How much longer everything takes that the case prescribes: 2 at half the speed.
    pub time_factor: f64,
}

/// A variation that is left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Name that its folder would have.
    pub name: String,
    /// What it would examine.
    pub source: ErrorSource,
    /// Why, in words.
    pub why: String,
}

/// The variations of a case in the order of their importance, and those that do not apply.
#[derive(Clone, Debug, Default)]
pub struct VariationPlan {
    /// Those that can be run.
    pub variations: Vec<Variation>,
    /// Those that cannot.
    pub left_out: Vec<LeftOut>,
}

/// The variations of a case. `text` is its text, overrides included; sources of `without` are not examined.
///
/// # Errors
/// [`CaseError`] for a case without a body, of which there is nothing to compare.
pub fn variations(
    case: &Case,
    text: &str,
    source_name: &str,
    without: &[ErrorSource],
) -> Result<VariationPlan, CaseError> {
    if case.touching().next().is_none() {
        let message = "confidence intervals are those of bodies, and the case has none".to_owned();
        return Err(CaseError::unreadable(source_name, message, "leave out --confidence"));
    }
    let original = Original { case, text, source_name };
    let mut plan = VariationPlan::default();
    for (name, result) in meshes(original) {
        plan.add(without, (&name, ErrorSource::Mesh), result);
    }
    let domain = || larger_domain(original).and_then(|change| original.varied(change));
    plan.add(without, ("larger_domain", ErrorSource::Domain), domain());
    let speed = || half_speed(original).and_then(|change| original.varied(change));
    plan.add(without, ("half_speed", ErrorSource::Speed), speed());
    let (name, change) = other_precision(case);
    plan.add(without, (name, ErrorSource::Precision), original.varied(change));
    Ok(plan)
}

impl VariationPlan {
    fn add(
        &mut self,
        without: &[ErrorSource],
        (name, source): (&str, ErrorSource),
        varied: Result<Unnamed, String>,
    ) {
        let name = name.to_owned();
        let varied = if without.contains(&source) { Err("left out on request".to_owned()) } else { varied };
        match varied {
            Ok((what, case, typed, time_factor)) => {
                self.variations.push(Variation { name, source, what, case, typed, time_factor });
            }
            Err(why) => self.left_out.push(LeftOut { name, source, why }),
        }
    }
}

/// By how much the cells of the two coarser meshes are wider, the usual factor first; the others where cells
/// of that width do not fill the domain (chosen: a domain that is a whole number of cells wide is so of one
/// of them).
const COARSER: [f64; 4] = [RATIO, 2.0, 4.0 / 3.0, 5.0 / 3.0];
const COARSEST: [f64; 4] = [RATIO * RATIO, 2.0, 2.5, 3.0];

/// The meshes: two coarser ones, the finer of them first; where none can be had, one finer.
fn meshes(original: Original) -> Vec<(String, Result<Unnamed, String>)> {
    let on = |factor: f64| {
        let Original { case, text, source_name } = original;
        on_cells(case, text, source_name, factor).map_err(|e| reason(&e))
    };
    // The reason is that of the usual factor.
    let first = |factors: [f64; 4], width: f64| {
        let mut tries = factors.into_iter().map(|factor| on(factor).and_then(|mesh| wider(mesh, width)));
        let usual = tries.next().unwrap_or_else(|| Err(String::new()));
        usual.or_else(|why| tries.find_map(Result::ok).ok_or(why))
    };
    let unnamed = |mesh: CoarserMesh| {
        let what = format!("cells of {} mm", plain(1e3 * mesh.case.grid.cell));
        (what, mesh.case, mesh.typed, 1.0)
    };
    let own = representative_width(original.case);
    let coarser = first(COARSER, own);
    let width = coarser.as_ref().map(|mesh| representative_width(&mesh.case));
    let coarsest = width.map_err(|_| "the coarser mesh cannot be had either".to_owned());
    let coarsest = coarsest.and_then(|width| first(COARSEST, width));
    let finer = coarser.is_err().then(|| on(1.0 / RATIO));
    [("coarser", Some(coarser)), ("coarsest", Some(coarsest)), ("finer", finer)]
        .into_iter()
        .filter_map(|(name, mesh)| Some((name.to_owned(), mesh?.map(unnamed))))
        .collect()
}

/// A mesh that is coarse enough beside one with cells of this width [m] for a difference to mean something.
fn wider(mesh: CoarserMesh, width: f64) -> Result<CoarserMesh, String> {
    let ratio = representative_width(&mesh.case) / width;
    if ratio >= LEAST_RATIO {
        return Ok(mesh);
    }
    Err(format!("its cells, fitted to flat faces (grid.fit), would be only {ratio:.2} times as wide"))
}

/// The other floating-point precision.
fn other_precision(case: &Case) -> (&'static str, Change) {
    let word = match case.numerics.precision {
        Precision::Double => "single",
        Precision::Single => "double",
    };
    let name = if word == "single" { "single_precision" } else { "double_precision" };
    let overrides = vec![format!("numerics.precision=\"{word}\"")];
    (name, Change { overrides, what: format!("{word} precision"), time_factor: 1.0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use case::{overridden, parse};

    const DISC: &str = include_str!("../../../../../cases/light_disc.toml");
    const STRIP: &str = include_str!("../../../../../validation/confidence/strip.toml");
    const WALL: &str = include_str!("../../../../../validation/confidence/wall.toml");
    const STAGES: &str = include_str!("../../../../../cases/press_and_tow.toml");
    const COLUMN: &str = include_str!("../../../../../cases/column_collapse.toml");
    const WATER: &str = include_str!("../../../../../cases/disc_under_water.toml");

    fn plan(text: &str, overrides: &[&str], without: &[ErrorSource]) -> (Case, VariationPlan) {
        let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
        let text = overridden(text, "case.toml", &overrides).unwrap();
        let case = parse(&text, "case.toml", &[]).unwrap();
        let plan = variations(&case, &text, "case.toml", without).unwrap();
        for variation in &plan.variations {
            assert_eq!(parse(&variation.typed, "case.toml", &[]).unwrap(), variation.case);
        }
        (case, plan)
    }

    fn named<'a>(plan: &'a VariationPlan, name: &str) -> &'a Variation {
        plan.variations
            .iter()
            .find(|v| v.name == name)
            .unwrap_or_else(|| panic!("no {name}: {:?}", plan.left_out))
    }

    #[test]
    fn a_case_has_its_variations_in_one_order() {
        let (case, plan) = plan(STRIP, &[], &[]);
        let names: Vec<&str> = plan.variations.iter().map(|v| v.name.as_str()).collect();
        assert_eq!(names, ["coarser", "coarsest", "larger_domain", "half_speed", "single_precision"]);
        assert_eq!(plan.left_out, []);
        let single = &named(&plan, "single_precision").case;
        assert_eq!(single.numerics.precision, Precision::Single);
        let same = Case { numerics: case.numerics.clone(), ..single.clone() };
        assert_eq!(same, case);
    }

    #[test]
    fn the_domain_grows_where_it_is_a_choice() {
        let (case, plan) = plan(STRIP, &[], &[]);
        let larger = &named(&plan, "larger_domain").case.domain;
        assert_eq!(larger.low.x, 0.0, "a plane of symmetry stays");
        let (before, after) = (case.domain.high.x - 0.5, larger.high.x - 0.5);
        assert!((after / before - 1.5).abs() < 0.05, "{after} and {before}");
        assert!(larger.low.z < -3.5 && larger.high.z > case.domain.high.z);
        assert_eq!((larger.low.y, larger.high.y), (case.domain.low.y, case.domain.high.y));
    }

    #[test]
    fn what_a_body_touches_and_the_floor_of_a_bank_stay_and_the_bank_grows() {
        let (case, plan) = plan(WALL, &[], &[]);
        let varied = named(&plan, "larger_domain");
        assert_eq!(varied.case.domain.low.z, case.domain.low.z);
        // Cells 2.25 times as wide do not fill it, cells twice as wide do.
        let cell = named(&plan, "coarsest").case.grid.cell;
        assert!((cell / case.grid.cell - 2.0).abs() < 1e-6, "{cell}");
        let case::resolved::Ground::Column { high, .. } = varied.case.ground else { panic!("no bank") };
        assert!(high.x > 5.9 && high.x == varied.case.domain.high.x);
        assert!(varied.what.contains("floor") && varied.what.contains("stays"), "{}", varied.what);
    }

    #[test]
    fn half_the_speed_takes_twice_the_time() {
        for text in [DISC, STRIP, STAGES] {
            let (case, plan) = plan(text, &[], &[]);
            let varied = named(&plan, "half_speed");
            assert!((varied.case.duration / case.duration - 2.0).abs() < 0.02, "{}", case.name);
            assert_eq!(varied.time_factor, 2.0);
            for (one, other) in case.bodies.iter().zip(&varied.case.bodies) {
                for (one, other) in one.motions().iter().zip(other.motions()) {
                    for time in [0.1, 0.5, 0.9].map(|part| part * case.duration) {
                        let (one, other) = (one.speed(time), other.speed(2.0 * time));
                        assert!((one - 2.0 * other).abs() < 1e-9, "{one} {other} {}", case.name);
                    }
                }
            }
        }
    }

    #[test]
    fn what_does_not_apply_is_left_out_with_a_reason() {
        let why = |text: &str, overrides: &[&str], without: &[ErrorSource], name: &str| {
            let plan = plan(text, overrides, without).1;
            let left_out = plan.left_out.iter().find(|l| l.name == name);
            left_out.map_or_else(|| panic!("{name} is not left out"), |l| l.why.clone())
        };
        assert!(why(STRIP, &[], &[ErrorSource::Speed], "half_speed").contains("on request"));
        let rate = ["soil.rate_strengthening=0.1"];
        assert!(why(STRIP, &rate, &[], "half_speed").contains("rate of shear"));
        assert!(why(WATER, &["water.pore_pressure=true"], &[], "half_speed").contains("pore"));
        let thin = ["body.disc.thickness=14 mm"];
        assert!(why(DISC, &thin, &[], "coarser").contains("too few"));
        let finer = plan(DISC, &thin, &[]).1;
        assert_eq!(named(&finer, "finer").source, ErrorSource::Mesh);
        let case = parse(COLUMN, "case.toml", &[]).unwrap();
        assert!(variations(&case, COLUMN, "case.toml", &[]).is_err());
    }
}
