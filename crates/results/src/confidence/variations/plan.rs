//! Which variations a case has, in the order in which they are run, and why some do not apply.

use super::change::{Change, Original, Unnamed, reason};
use super::domain::larger_domain;
use super::source::ErrorSource;
use super::speed::half_speed;
use case::meshes::{OtherCells, finest_widths, on_cells, representative_width};
use case::resolved::{Attitude, Case, Precision};
use input::error::CaseError;
use input::quantity::plain;
use std::ops::RangeInclusive;

/// A case that is varied in one respect.
#[derive(Clone, Debug)]
pub struct Variation {
    /// Name of the folder of the variation.
    pub name: String,
    /// Source of uncertainty that the variation examines.
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
    /// Name that the folder of the variation would have.
    pub name: String,
    /// Source of uncertainty that the variation would examine.
    pub source: ErrorSource,
    /// Whether the variation was asked for, and does not apply.
    pub is_asked_for: bool,
    /// Why, in words.
    pub why: String,
}

/// The variations of a case in the order of their importance, and those that do not apply.
#[derive(Clone, Debug, Default)]
pub struct VariationPlan {
    /// Variations that can be run.
    pub variations: Vec<Variation>,
    /// Variations that cannot be run.
    pub left_out: Vec<LeftOut>,
}

/// What is to be examined.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Asked {
    /// Number of meshes, the case's own among them, of [`MESHES`].
    pub meshes: usize,
    /// Sources that are not examined.
    pub without: Vec<ErrorSource>,
}

/// Numbers of meshes that can be asked for.
pub const MESHES: RangeInclusive<usize> = 2..=6;

impl Default for Asked {
    /// Every source, on four meshes, from which on trend and scatter can be told apart.
    fn default() -> Self {
        Self { meshes: 4, without: Vec::new() }
    }
}

impl Asked {
    /// A wish for this number of meshes, and nothing else.
    #[must_use]
    pub fn meshes_alone(meshes: usize) -> Self {
        Self { meshes, without: vec![ErrorSource::Domain, ErrorSource::Speed, ErrorSource::Precision] }
    }
}

/// The variations of a case. `text` is its text, overrides included.
///
/// # Errors
/// [`CaseError`] for a case without a body, of which there is nothing to compare.
pub fn variations(
    case: &Case,
    text: &str,
    source_name: &str,
    asked: &Asked,
) -> Result<VariationPlan, CaseError> {
    if case.touching().next().is_none() {
        let message = "intervals are those of the figures of bodies, and the case has none".to_owned();
        return Err(CaseError::unreadable(source_name, message, "leave out --confidence and --meshes"));
    }
    let original = Original { case, text, source_name };
    let mut plan = VariationPlan::default();
    if asked.without.contains(&ErrorSource::Mesh) {
        plan.leave_out("other_cells", ErrorSource::Mesh);
    } else {
        for (name, result) in meshes(original, asked.meshes) {
            plan.add(name, ErrorSource::Mesh, result);
        }
    }
    let (name, precision) = other_precision(case);
    plan.examine(asked, ("larger_domain", ErrorSource::Domain), || original.varied(larger_domain(original)?));
    plan.examine(asked, ("half_speed", ErrorSource::Speed), || original.varied(half_speed(original)?));
    plan.examine(asked, (name, ErrorSource::Precision), || original.varied(precision));
    Ok(plan)
}

impl VariationPlan {
    fn add(&mut self, name: String, source: ErrorSource, varied: Result<Unnamed, String>) {
        match varied {
            Ok((what, case, typed, time_factor)) => {
                self.variations.push(Variation { name, source, what, case, typed, time_factor });
            }
            Err(why) => self.left_out.push(LeftOut { name, source, is_asked_for: true, why }),
        }
    }

    /// Adds the variation for a source that is not left out.
    fn examine(
        &mut self,
        asked: &Asked,
        (name, source): (&str, ErrorSource),
        varied: impl FnOnce() -> Result<Unnamed, String>,
    ) {
        if asked.without.contains(&source) {
            self.leave_out(name, source);
        } else {
            self.add(name.to_owned(), source, varied());
        }
    }

    fn leave_out(&mut self, name: &str, source: ErrorSource) {
        let (name, why) = (name.to_owned(), "nobody asked for it".to_owned());
        self.left_out.push(LeftOut { name, source, is_asked_for: false, why });
    }
}

/// The widest cells of a study over the case's own, of more than two meshes (chosen: within a factor of two
/// the coarser ones cost less together than the case's own run, and several of them tell a trend from
/// scatter).
const SPREAD: f64 = 2.0;
/// The wider cells of two meshes over the finer ones.
const OF_TWO: f64 = 1.5;
/// Widths that are tried where cells of the wanted one do not fill the domain: one of them divides a domain
/// that is a whole number of cells wide.
const TRIED: [f64; 16] = [
    1.1,
    9.0 / 8.0,
    8.0 / 7.0,
    7.0 / 6.0,
    1.2,
    1.25,
    4.0 / 3.0,
    1.4,
    1.5,
    1.6,
    5.0 / 3.0,
    1.75,
    1.8,
    2.0,
    2.25,
    2.5,
];
/// Ratio by which the width of the cells may be off the wanted one.
const NEAR: f64 = 1.3;
/// Least ratio of the representative widths of two meshes (chosen: with less, a run says nothing new).
const LEAST_RATIO: f64 = 1.08;

/// The meshes: coarser ones, the finest of them first; where none can be had, one finer.
fn meshes(original: Original, count: usize) -> Vec<(String, Result<Unnamed, String>)> {
    let spread = if count > 2 { SPREAD } else { OF_TWO };
    let mut taken = vec![representative_width(original.case)];
    let mut found = Vec::new();
    for n in 1..count {
        let wanted = spread.powf(n as f64 / (count - 1) as f64);
        found.push(match on_cells_near(original, wanted, &taken, f64::INFINITY) {
            Ok(mesh) => {
                taken.push(representative_width(&mesh.case));
                named(mesh)
            }
            Err(why) => (format!("cells_{wanted:.2}_times_as_wide"), Err(why)),
        });
    }
    if taken.len() == 1 {
        let finer = on_cells_near(original, 1.0 / OF_TWO, &taken, f64::INFINITY);
        found.push(finer.map_or_else(|why| ("finer_cells".to_owned(), Err(why)), named));
    }
    found
}

fn named(mesh: OtherCells) -> (String, Result<Unnamed, String>) {
    let what = format!("cells of {} mm", plain(1e3 * mesh.case.grid.cell));
    (format!("cells_{}", mesh.name), Ok((what, mesh.case, mesh.typed, 1.0)))
}

/// How much more a grid may be stretched along one axis than along another for it to be similar to the case's
/// own, and by how much of a cell, above 1, flat faces of bodies may lie elsewhere in their cells (chosen).
const SIMILAR: f64 = 1.01;

/// The case on cells about `wanted` times as wide, which differ from those of the widths that are taken and
/// are at most `widest` [m]. Of those near enough the nearest whose grid is similar to the case's own, since
/// cells that are fitted to flat faces (`grid.fit`) change their shape otherwise; where none is, the one that
/// is the most similar.
fn on_cells_near(original: Original, wanted: f64, taken: &[f64], widest: f64) -> Result<OtherCells, String> {
    let Original { case, text, source_name } = original;
    let on = |factor: f64| {
        let mesh = on_cells(case, text, source_name, factor).map_err(|error| reason(&error))?;
        let width = representative_width(&mesh.case);
        let ratio = |other: &f64| (width / other).max(other / width);
        let least = taken.iter().map(ratio).fold(f64::INFINITY, f64::min);
        if least >= LEAST_RATIO && width <= widest {
            return Ok(mesh);
        }
        Err(format!(
            "its cells, fitted to flat faces (grid.fit), would be only {least:.2} times as wide as others"
        ))
    };
    // As one would type it; the reason is that of the wanted width.
    let cell = case.grid.cell * wanted;
    let typed = format!("{cell:.2e}").parse::<f64>().unwrap_or(cell) / case.grid.cell;
    let distance = |factor: &f64| (factor / wanted).ln().abs();
    let mut others: Vec<f64> = TRIED.into_iter().filter(|factor| distance(factor) <= NEAR.ln()).collect();
    others.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
    let (mut best, mut why) = (None, None);
    for factor in std::iter::once(typed).chain(others) {
        let mesh = match on(factor) {
            Ok(mesh) => mesh,
            Err(other) => {
                why = why.or(Some(other));
                continue;
            }
        };
        let change = change_of_shape(case, &mesh.case);
        if change <= SIMILAR {
            return Ok(mesh);
        }
        if best.as_ref().is_none_or(|(least, _)| change < *least) {
            best = Some((change, mesh));
        }
    }
    best.map(|(_, mesh)| mesh).ok_or_else(|| why.unwrap_or_default())
}

/// How much more the finest cells of another case are stretched along one axis than along another, beside
/// those of the case, in plane strain along x and z; or 1 and by how much of a cell flat faces lie elsewhere
/// in their cells, if that is more.
fn change_of_shape(case: &Case, other: &Case) -> f64 {
    let axes: &[usize] = if case.domain.plane_strain { &[0, 2] } else { &[0, 1, 2] };
    let (cell, finest) = (finest_widths(case), finest_widths(other));
    let ratios = || axes.iter().map(|axis| finest[*axis] / cell[*axis]);
    let stretch = ratios().fold(0.0, f64::max) / ratios().fold(f64::INFINITY, f64::min);
    let places = face_places(case, axes).into_iter().zip(face_places(other, axes));
    places.fold(stretch, |most, (one, other)| most.max(1.0 + (one - other).abs()))
}

/// How far each flat face of a body that stands upright is from the nearest grid line at the start, in cells.
fn face_places(case: &Case, axes: &[usize]) -> Vec<f64> {
    let mut places = Vec::new();
    for (_, body) in case.touching().filter(|(_, body)| body.attitude == Attitude::default()) {
        let (low, high) = body.bounds();
        for axis in axes.iter().copied().filter(|axis| body.shape.has_flat_sides(*axis)) {
            let lines = &case.grid.faces[axis];
            let faces = [low, high].map(|end| body.position[axis] + end[axis]);
            // Of half a model the other one lies outside.
            let is_inside = |face: &f64| *face >= lines[0] && *face <= lines[lines.len() - 1];
            for face in faces.into_iter().filter(is_inside) {
                let above = lines.partition_point(|line| *line < face).clamp(1, lines.len() - 1);
                let [below, above] = [lines[above - 1], lines[above]];
                places.push((face - below).abs().min((above - face).abs()) / (above - below));
            }
        }
    }
    places
}

/// The case on cells that are 2^(step/4) times as wide, or near that, and finer than those of the cases in
/// `taken`.
///
/// # Errors
/// Why there are none.
pub fn on_step(
    (case, text, source_name): (&Case, &str, &str),
    step: i32,
    taken: &[&Case],
) -> Result<Variation, CaseError> {
    let taken: Vec<f64> = taken.iter().map(|case| representative_width(case)).collect();
    let original = Original { case, text, source_name };
    let widest = taken.iter().copied().fold(f64::INFINITY, f64::min);
    match on_cells_near(original, 2_f64.powf(0.25 * f64::from(step)), &taken, widest) {
        Ok(mesh) => {
            let what = format!("cells of {} mm", plain(1e3 * mesh.case.grid.cell));
            let OtherCells { case, typed, name } = mesh;
            let name = format!("cells_{name}");
            Ok(Variation { name, source: ErrorSource::Mesh, what, case, typed, time_factor: 1.0 })
        }
        Err(why) => Err(CaseError::unreadable(source_name, why, "choose another grid.cell")),
    }
}

/// A mesh that takes the place of one whose run is broken: its cells lie in the widest gap between those of
/// the case and the meshes in `usable`, or the broken one. `used` are all that there are; `None` where there
/// is no room for another one.
#[must_use]
pub fn in_place_of(
    broken: &Variation,
    (usable, used): (&[&Case], &[&Case]),
    (case, text, source_name): (&Case, &str, &str),
) -> Option<Variation> {
    let (own, end) = (representative_width(case), representative_width(&broken.case));
    let mut widths: Vec<f64> = usable.iter().map(|case| representative_width(case)).collect();
    widths.retain(|width| *width < end);
    widths.extend([own, end]);
    widths.sort_by(f64::total_cmp);
    let gap = widths.windows(2).max_by(|a, b| (a[1] / a[0]).total_cmp(&(b[1] / b[0])))?;
    let taken: Vec<f64> = used.iter().map(|case| representative_width(case)).chain([own]).collect();
    let original = Original { case, text, source_name };
    let mesh = on_cells_near(original, (gap[0] * gap[1]).sqrt() / own, &taken, end).ok()?;
    let mut plan = VariationPlan::default();
    let (name, varied) = named(mesh);
    plan.add(name, ErrorSource::Mesh, varied);
    plan.variations.pop()
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
        let asked = Asked { without: without.to_vec(), ..Asked::default() };
        let plan = variations(&case, &text, "case.toml", &asked).unwrap();
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
        let cells: Vec<f64> =
            plan.variations[..3].iter().map(|v| v.case.grid.cell / case.grid.cell).collect();
        assert!(
            cells.windows(2).all(|pair| pair[1] > 1.1 * pair[0]) && cells[0] > 1.1 && cells[2] < 2.6,
            "{cells:?}"
        );
        assert!(names[..3].iter().all(|name| name.starts_with("cells_")), "{names:?}");
        assert_eq!(names[3..], ["larger_domain", "half_speed", "single_precision"]);
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
    fn a_mesh_takes_the_place_of_a_broken_one_in_the_widest_gap() {
        let (case, plan) = plan(DISC, &[], &[]);
        let meshes: Vec<&Case> = plan.variations[..3].iter().map(|variation| &variation.case).collect();
        let own = (&case, DISC, "case.toml");
        let other = in_place_of(&plan.variations[2], (&meshes[..2], &meshes), own).unwrap();
        let width = |case: &Case| representative_width(case);
        assert!(width(&case) < width(&other.case) && width(&other.case) < width(meshes[2]));
        assert!(meshes.iter().all(|mesh| (width(mesh) / width(&other.case)).ln().abs() > 0.05));
        assert_eq!(parse(&other.typed, "case.toml", &[]).unwrap(), other.case);
    }

    #[test]
    fn what_does_not_apply_is_left_out_with_a_reason() {
        let why = |text: &str, overrides: &[&str], without: &[ErrorSource], name: &str| {
            let plan = plan(text, overrides, without).1;
            let left_out = plan.left_out.iter().find(|l| l.name == name);
            left_out.map_or_else(|| panic!("{name} is not left out"), |l| l.why.clone())
        };
        assert!(why(STRIP, &[], &[ErrorSource::Speed], "half_speed").contains("nobody asked"));
        let rate = ["soil.rate_strengthening=0.1"];
        assert!(why(STRIP, &rate, &[], "half_speed").contains("rate of shear"));
        assert!(why(WATER, &["water.pore_pressure=true"], &[], "half_speed").contains("pore"));
        let thin = ["body.disc.thickness=12.6 mm"];
        let (case, finer) = plan(DISC, &thin, &[]);
        assert!(
            finer.left_out.iter().any(|left_out| left_out.why.contains("too few")),
            "{:?}",
            finer.left_out
        );
        assert!(finer.variations[0].case.grid.cell < case.grid.cell, "no coarser mesh, but a finer one");
        let case = parse(COLUMN, "case.toml", &[]).unwrap();
        assert!(variations(&case, COLUMN, "case.toml", &Asked::default()).is_err());
    }
}
