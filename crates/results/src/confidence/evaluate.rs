//! From the runs of a case and of its variations to intervals.

use super::combine::{REACH_DOMAIN, REACH_SPEED, bias, combined, scatter};
use super::convergence::{Convergence, OnMesh};
use super::figures::{BodyConfidence, Confidence, Contribution, Status, VariationResult};
use super::statistics::{of_press, of_tow};
use crate::confidence::variations::ErrorSource;
use crate::history::History;
use crate::history::quantities::{LEAST_SCALE, Quantity, Scale, Steady};
use crate::history::reference::Reference;
use crate::history::steady::{SteadyPart, SteadyWindow};
use crate::trust::steadiness::Trend;
use crate::trust::{BodySetting, Verdict};
use std::collections::BTreeMap;

/// A run: the case's own, or that of a variation that has finished.
#[derive(Clone, Copy, Debug)]
pub struct VariedRun<'a> {
    /// What is known of the variation; the figures are filled in.
    pub result: &'a VariationResult,
    /// History of the run; `None` where there is none.
    pub history: Option<&'a History>,
}

/// Evaluates the variations of a run with this history and this verdict, which is on cells of
/// `confidence.width_m`. `part` is that over which steady means are taken.
#[must_use]
pub fn evaluate(
    mut confidence: Confidence,
    own: (&History, Verdict),
    runs: &[VariedRun],
    (references, settings): (&[Reference], &[BodySetting]),
    part: impl Into<SteadyPart>,
) -> Confidence {
    let part = part.into();
    confidence.variations = runs.iter().map(|run| run.result.clone()).collect();
    for (number, reference) in references.iter().enumerate().filter(|(_, r)| r.has_surface()) {
        let Some(samples) = own.0.bodies.get(number) else { continue };
        let window = SteadyWindow::of(samples, reference, part);
        let body = OwnBody { window, setting: settings.get(number), width: confidence.width_m };
        let varied: Vec<VariedBody> = runs.iter().map(|run| body.varied(run, number)).collect();
        for (result, varied) in confidence.variations.iter_mut().zip(&varied) {
            result.bodies.extend(varied.values().map(|values| (reference.name.clone(), values)));
        }
        confidence.bodies.insert(reference.name.clone(), body.evaluated(own.1, &varied));
    }
    confidence
}

/// A body of the case's own run.
struct OwnBody<'a> {
    window: SteadyWindow<'a>,
    setting: Option<&'a BodySetting>,
    /// Representative cell width [m].
    width: f64,
}

/// A body of the case's own run in a variation, averaged over the same window.
struct VariedBody<'a> {
    result: &'a VariationResult,
    status: Status,
    because: Option<String>,
    steady: Option<Steady>,
}

impl VariedBody<'_> {
    fn values(&self) -> Option<BTreeMap<String, f64>> {
        let steady = self.steady.as_ref()?;
        let known = Quantity::all().into_iter().filter(|quantity| quantity.figure.scale.is_some());
        Some(known.filter_map(|quantity| Some((quantity.key(), quantity.mean(steady)?))).collect())
    }
}

impl OwnBody<'_> {
    fn varied<'a>(&self, run: &VariedRun<'a>, number: usize) -> VariedBody<'a> {
        let result = run.result;
        let of = |status, because, steady| VariedBody { result, status, because, steady };
        let samples = run.history.and_then(|history| history.bodies.get(number));
        let (Status::Examined, Some(samples)) = (result.status, samples) else {
            return of(result.status, result.because.clone(), None);
        };
        let stretched = |time: Option<f64>| time.map(|time| time * result.time_factor);
        let (from_s, to_s) = (stretched(self.window.steady.from_s), stretched(self.window.steady.to_s));
        let own = Steady { from_s, to_s, ..self.window.steady.clone() };
        match SteadyWindow::same(samples, self.window.reference, &own) {
            Some(window) => of(Status::Examined, None, Some(window.steady)),
            None => {
                let why = "it does not reach the steady window of the case's own run".to_owned();
                of(Status::NotComparable, Some(why), None)
            }
        }
    }

    fn evaluated(&self, verdict: Verdict, varied: &[VariedBody]) -> BodyConfidence {
        let none = |why: &str| BodyConfidence {
            no_interval_because: Some(why.to_owned()),
            ..BodyConfidence::default()
        };
        if verdict == Verdict::Broken {
            return none("the run is broken");
        }
        let interval = |quantity: Quantity| {
            let value = quantity.mean(&self.window.steady)?;
            let scale = scale(quantity, &self.window.steady, self.setting)?;
            let parts = ErrorSource::ALL.map(|source| self.contribution((&quantity, scale), source, varied));
            Some((quantity.key(), combined(value, scale, parts.into())))
        };
        let figures: BTreeMap<_, _> = Quantity::all().into_iter().filter_map(interval).collect();
        if figures.is_empty() {
            return none("no force acts on it in the steady window");
        }
        BodyConfidence { no_interval_because: None, force_change: self.force_change(), figures }
    }

    /// Change of the force over its mean: of a body that is towed, of the drag since the stretch before the
    /// window, of the same length; of one that is pressed, of the vertical force over the window.
    fn force_change(&self) -> Option<f64> {
        let change = if self.window.is_towed() {
            let now = self.window.steady.drag?;
            (now - self.earlier()?.drag?) / self.window.steady.drag_scale(self.window.reference)
        } else {
            self.setting.filter(|setting| setting.heaves && !setting.heaves_freely)?;
            let vertical: Vec<f64> = self.window.inside().iter().map(|s| s.vertical).collect();
            let trend = Trend::of(&vertical)?;
            trend.change / self.window.steady.scale(Some(trend.mean))
        };
        change.is_finite().then_some(change.abs())
    }

    /// The means over the stretch before the window, of the same length; `None` where the tow is not that
    /// long.
    fn earlier(&self) -> Option<Steady> {
        let (from, to) = (self.window.steady.from_m?, self.window.steady.to_m?);
        let earlier = Steady { from_m: Some(from - (to - from)), to_m: Some(from), ..Steady::default() };
        let window = SteadyWindow::same(self.window.samples, self.window.reference, &earlier)?;
        Some(window.steady)
    }

    fn contribution(
        &self,
        (quantity, scale): (&Quantity, f64),
        source: ErrorSource,
        varied: &[VariedBody],
    ) -> Contribution {
        let examined = Contribution { source, status: Status::Examined, ..Contribution::default() };
        match source {
            ErrorSource::Statistics => {
                let blocks = quantity.blocks(self.window.inside(), self.window.reference);
                let part = blocks.map(|b| if self.window.is_towed() { of_tow(&b) } else { of_press(&b) });
                match part.filter(|part| part.is_finite()) {
                    Some(part) => Contribution { below: part, above: part, ..examined },
                    None => missing(
                        source,
                        Status::NotComparable,
                        "there are too few samples in the steady window for eight averages: use a shorter \
                         output.history_interval or a longer run",
                    ),
                }
            }
            ErrorSource::Mesh => self.of_mesh(quantity, varied, (examined, scale)),
            ErrorSource::Domain | ErrorSource::Speed | ErrorSource::Precision => {
                let change = |run: &VariedBody| {
                    Some(quantity.mean(run.steady.as_ref()?)? - quantity.mean(self.base_of(run, varied))?)
                };
                let of_source: Vec<&VariedBody> =
                    varied.iter().filter(|v| v.result.source == source).collect();
                let Some(change) = of_source.iter().find_map(|v| change(v)).filter(|c| c.is_finite()) else {
                    return first_missing(source, &of_source);
                };
                let [below, above] = match source {
                    ErrorSource::Domain => bias(change, REACH_DOMAIN),
                    ErrorSource::Speed => bias(change, REACH_SPEED),
                    _ => scatter(change),
                };
                Contribution { change: Some(change), below, above, ..examined }
            }
        }
    }

    /// The means from which those of a variation differ: of the one beside which it was run, or of the case's
    /// own run.
    fn base_of<'a>(&'a self, run: &VariedBody, varied: &'a [VariedBody]) -> &'a Steady {
        let base = varied.iter().find(|other| run.result.beside.as_ref() == Some(&other.result.name));
        base.and_then(|base| base.steady.as_ref()).unwrap_or(&self.window.steady)
    }

    /// What infinitely small cells would give, from as many meshes as there are.
    fn of_mesh(
        &self,
        quantity: &Quantity,
        varied: &[VariedBody],
        (examined, scale): (Contribution, f64),
    ) -> Contribution {
        let of_source: Vec<&VariedBody> =
            varied.iter().filter(|v| v.result.source == ErrorSource::Mesh).collect();
        let on = |v: &&VariedBody| {
            Some(OnMesh { width: v.result.width_m, value: quantity.mean(v.steady.as_ref()?)? })
        };
        let mut meshes: Vec<OnMesh> = of_source.iter().filter_map(on).collect();
        let Some(value) = quantity.mean(&self.window.steady).filter(|_| !meshes.is_empty()) else {
            return first_missing(ErrorSource::Mesh, &of_source);
        };
        meshes.push(OnMesh { width: self.width, value });
        meshes.sort_by(|a, b| b.width.total_cmp(&a.width));
        let Some(convergence) = Convergence::of(&meshes, scale) else {
            return missing(ErrorSource::Mesh, Status::NotComparable, "its figures are not numbers");
        };
        let Convergence { extrapolated, half_width, .. } = convergence;
        let below = (value - (extrapolated - half_width)).max(0.0);
        let above = (extrapolated + half_width - value).max(0.0);
        Contribution { below, above, convergence: Some(convergence), ..examined }
    }
}

fn missing(source: ErrorSource, status: Status, why: &str) -> Contribution {
    Contribution { source, status, because: Some(why.to_owned()), ..Contribution::default() }
}

/// A source without a variation that counts: what became of the first that should have been run, or else of
/// the first.
fn first_missing(source: ErrorSource, varied: &[&VariedBody]) -> Contribution {
    let first = varied.iter().find(|v| v.status.is_missing()).or(varied.first());
    let why = first.and_then(|v| v.because.clone());
    let status = first.map_or(Status::NotExamined, |v| match v.status {
        // Examined, but its figure is not a number.
        Status::Examined => Status::NotComparable,
        other => other,
    });
    missing(source, status, &why.unwrap_or_default())
}

/// Part of the whole force on a body below which a component is not worth an interval (chosen).
const MEANINGFUL: f64 = 0.01;

/// What half-widths of a quantity are compared with, in its unit; `None` where it has no interval, or no
/// meaning for this body.
fn scale(quantity: Quantity, steady: &Steady, setting: Option<&BodySetting>) -> Option<f64> {
    let size = quantity.mean(steady)?.abs();
    match quantity.figure.scale? {
        Scale::Drag | Scale::Force => {
            let whole = steady.whole_force();
            (size > MEANINGFUL * whole).then(|| size.max(LEAST_SCALE * whole))
        }
        // Where it is prescribed, it is known.
        Scale::Depth => setting.filter(|setting| setting.heaves_freely).map(|_| size),
        Scale::One => Some(1.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::history::BodySample;

    fn footing() -> (Reference, BodySetting) {
        let reference = Reference {
            name: "footing".into(),
            kind: "block".into(),
            length: 0.5,
            width: 1.0,
            across: 1.0,
            ..Reference::default()
        };
        let setting = BodySetting { name: "footing".into(), heaves: true, ..BodySetting::default() };
        (reference, setting)
    }

    /// A footing that is pressed for a time [s] and carries this load [N], more by a part of it towards the
    /// end.
    fn pressed(duration: f64, load: f64, rise: f64) -> History {
        let body = (0..=400).map(|n| {
            let part = f64::from(n) / 400.0;
            let vertical = load * (1.0 + rise * part);
            BodySample { time: part * duration, sinkage: 0.01 * part, vertical, ..BodySample::default() }
        });
        History { names: vec!["footing".into()], bodies: vec![body.collect()], ..History::default() }
    }

    fn result(name: &str, source: ErrorSource, width_m: f64) -> VariationResult {
        let status = Status::Examined;
        let time_factor = if source == ErrorSource::Speed { 2.0 } else { 1.0 };
        VariationResult {
            name: name.into(),
            source,
            width_m,
            status,
            time_factor,
            ..VariationResult::default()
        }
    }

    fn study(own: &History, runs: &[(VariationResult, Option<History>)]) -> BodyConfidence {
        let varied: Vec<VariedRun> =
            runs.iter().map(|(result, history)| VariedRun { result, history: history.as_ref() }).collect();
        let (reference, setting) = footing();
        let confidence = Confidence { width_m: 0.1, ..Confidence::default() };
        let bodies = (&[reference][..], &[setting][..]);
        let study = evaluate(confidence, (own, Verdict::Good), &varied, bodies, 0.3);
        study.bodies["footing"].clone()
    }

    #[test]
    fn a_footing_has_the_interval_of_its_variations() {
        let runs = [
            (result("coarser", ErrorSource::Mesh, 0.15), Some(pressed(1.0, 105.0, 0.0))),
            (result("coarsest", ErrorSource::Mesh, 0.225), Some(pressed(1.0, 112.5, 0.0))),
            (result("larger_domain", ErrorSource::Domain, 0.1), Some(pressed(1.0, 99.0, 0.0))),
            (result("half_speed", ErrorSource::Speed, 0.1), Some(pressed(2.0, 100.5, 0.0))),
            (result("single_precision", ErrorSource::Precision, 0.1), Some(pressed(1.0, 100.0, 0.0))),
        ];
        let body = study(&pressed(1.0, 100.0, 0.0), &runs);
        assert_eq!(body.figures.keys().collect::<Vec<_>>(), ["vertical_N"], "what is prescribed is known");
        let figure = &body.figures["vertical_N"];
        let part = |source: ErrorSource| {
            let part = figure.contributions.iter().find(|c| c.source == source).unwrap();
            [part.below, part.above]
        };
        let near = |pair: [f64; 2], other: [f64; 2]| {
            assert!(
                (pair[0] - other[0]).abs() < 1e-6 && (pair[1] - other[1]).abs() < 1e-6,
                "{pair:?} {other:?}"
            );
        };
        // Order 1: the limit is 90.
        let [below, above] = part(ErrorSource::Mesh);
        assert!(below > 10.0 && below < 18.0 && above < 5.0, "{below} {above}");
        near(part(ErrorSource::Domain), [3.0, 1.0]);
        near(part(ErrorSource::Speed), [0.5, 1.0]);
        near(part(ErrorSource::Precision), [0.0, 0.0]);
        near(part(ErrorSource::Statistics), [0.0, 0.0]);
        assert!(figure.is_complete && figure.dominated_by == Some(ErrorSource::Mesh));
        assert!(figure.interval[0] < 90.0 && figure.interval[1] > 100.0);
        assert!(body.force_change.unwrap() < 1e-9);
    }

    #[test]
    fn a_variation_of_another_mesh_differs_from_that() {
        let beside = VariationResult {
            beside: Some("coarser".into()),
            ..result("larger_domain", ErrorSource::Domain, 0.15)
        };
        let runs = [
            (result("coarser", ErrorSource::Mesh, 0.15), Some(pressed(1.0, 105.0, 0.0))),
            (beside, Some(pressed(1.0, 104.0, 0.0))),
        ];
        let body = study(&pressed(1.0, 100.0, 0.0), &runs);
        let parts = &body.figures["vertical_N"].contributions;
        let domain = parts.iter().find(|part| part.source == ErrorSource::Domain).unwrap();
        assert!((domain.change.unwrap() + 1.0).abs() < 1e-9, "{domain:?}");
    }

    #[test]
    fn what_is_missing_is_named_and_the_rest_counts() {
        let broken = VariationResult {
            status: Status::Broken,
            because: Some("its run broke down".into()),
            ..result("larger_domain", ErrorSource::Domain, 0.1)
        };
        let unpaid =
            VariationResult { status: Status::NotExamined, ..result("half_speed", ErrorSource::Speed, 0.1) };
        let short = (result("single_precision", ErrorSource::Precision, 0.1), Some(pressed(0.5, 100.0, 0.0)));
        let coarser = (result("coarser", ErrorSource::Mesh, 0.15), Some(pressed(1.0, 101.0, 0.0)));
        let own = pressed(1.0, 100.0, 0.0);
        let body = study(&own, &[coarser, (broken, None), (unpaid, None), short]);
        let figure = &body.figures["vertical_N"];
        let status: Vec<Status> = figure.contributions.iter().map(|c| c.status).collect();
        let expected =
            [Status::Examined, Status::Broken, Status::NotExamined, Status::NotComparable, Status::Examined];
        assert_eq!(status, expected);
        assert!(!figure.is_complete);
        // What the first and the second order extrapolate to: 98 and 99.2.
        assert!(figure.interval[0] < 98.0 && figure.interval[1] > 100.0, "two meshes: {figure:?}");
        assert_eq!(figure.contributions[1].because.as_deref(), Some("its run broke down"));
    }

    #[test]
    fn a_finer_mesh_alone_shows_how_far_off_the_own_one_is() {
        let finer = (result("finer", ErrorSource::Mesh, 0.1 / 1.5), Some(pressed(1.0, 99.0, 0.0)));
        let body = study(&pressed(1.0, 100.0, 0.0), &[finer]);
        let figure = &body.figures["vertical_N"];
        // What the first order extrapolates to from 100 and 99: 97.
        assert!(figure.interval[0] < 97.0 && figure.interval[1] > 99.2, "{figure:?}");
    }

    #[test]
    fn without_statistics_the_other_sources_still_count() {
        let thinned = |load: f64| {
            let mut history = pressed(1.0, load, 0.0);
            history.bodies[0] = history.bodies[0].iter().step_by(20).copied().collect();
            history
        };
        let larger = (result("larger_domain", ErrorSource::Domain, 0.1), Some(thinned(90.0)));
        let figure = study(&thinned(100.0), &[larger]).figures["vertical_N"].clone();
        assert!((figure.contributions[1].below - 30.0).abs() < 1e-9 && !figure.is_complete);
        let statistics = &figure.contributions[4];
        assert!(statistics.because.as_ref().unwrap().contains("too few samples"), "{statistics:?}");
    }

    #[test]
    fn a_tow_that_has_only_begun_is_told() {
        let drag = |part: f64| if part < 0.7 { 10.0 } else { 20.0 };
        let body = (0..=400).map(|n| {
            let part = f64::from(n) / 400.0;
            BodySample { time: part, displacement: part, drag: drag(part), ..BodySample::default() }
        });
        let own =
            History { names: vec!["footing".into()], bodies: vec![body.collect()], ..History::default() };
        let change = study(&own, &[]).force_change.unwrap();
        assert!((change - 0.5).abs() < 0.02, "{change}");
    }

    #[test]
    fn a_force_that_still_rises_is_told() {
        let body = study(&pressed(1.0, 100.0, 1.0), &[]);
        // From 170 to 200 over the window.
        assert!((body.force_change.unwrap() - 30.0 / 185.0).abs() < 0.01, "{body:?}");
        let (reference, setting) = footing();
        let own = pressed(1.0, 100.0, 0.0);
        let bodies = (&[reference][..], &[setting][..]);
        let broken = evaluate(Confidence::default(), (&own, Verdict::Broken), &[], bodies, 0.3);
        assert!(broken.bodies["footing"].no_interval_because.as_deref() == Some("the run is broken"));
        let lost = study(&pressed(1.0, 0.0, 0.0), &[]);
        assert!(lost.no_interval_because.unwrap().contains("no force acts on it"));
    }
}
