//! From the runs on several meshes to the intervals of their figures.

use super::convergence::{Convergence, OnMesh};
use super::figures::{BodyOnMesh, BodyStudy, MeshInterval, MeshResult, MeshStudy};
use crate::history::blocks::{STUDENT_90, block_averages, standard_error};
use crate::history::quantities::{Figures, Quantity, Scale};
use crate::history::reference::Reference;
use crate::history::steady::{SteadyPart, SteadyWindow};
use crate::history::{BodySample, History};
use crate::trust::steadiness::Trend;
use crate::trust::{Trust, Verdict, limits};
use std::collections::BTreeMap;

/// A run of the case on one mesh that has come to its end.
#[derive(Clone, Copy, Debug)]
pub struct MeshRun<'a> {
    /// Folder, mesh, steps, time and grade; the bodies are filled in.
    pub result: &'a MeshResult,
    /// Its grade.
    pub trust: &'a Trust,
    /// Its history.
    pub history: &'a History,
}

/// Evaluates the runs of a case on meshes from coarse to fine. `fraction` is that of the steady window.
#[must_use]
pub fn evaluate(runs: &[MeshRun], references: &[Reference], part: impl Into<SteadyPart>) -> MeshStudy {
    let part = part.into();
    let mut study =
        MeshStudy { meshes: runs.iter().map(|run| run.result.clone()).collect(), bodies: BTreeMap::new() };
    for (body, reference) in references.iter().enumerate() {
        let bodies: Vec<BodyRun> = body_runs(runs, (body, reference), part);
        for (mesh, run) in study.meshes.iter_mut().zip(&bodies) {
            let means = Figures::on_meshes(|quantity| quantity.mean(&run.window.steady));
            let on_mesh = BodyOnMesh { means, drag_noise: run.window.steady.drag_noise };
            mesh.bodies.insert(reference.name.clone(), on_mesh);
        }
        study.bodies.insert(reference.name.clone(), body_study(&bodies));
    }
    study
}

/// A body's part of a run.
struct BodyRun<'a> {
    run: MeshRun<'a>,
    /// The window of the finest mesh; empty where the body has not come that far.
    window: SteadyWindow<'a>,
}

fn body_runs<'a>(
    runs: &[MeshRun<'a>],
    (body, reference): (usize, &'a Reference),
    part: SteadyPart,
) -> Vec<BodyRun<'a>> {
    let samples = |run: &MeshRun<'a>| run.history.bodies.get(body).map_or(&[][..], Vec::as_slice);
    let Some(finest) = runs.last().map(samples) else { return Vec::new() };
    let own = SteadyWindow::of(finest, reference, part);
    let body_run = |(n, run): (usize, &MeshRun<'a>)| {
        let window = if n + 1 == runs.len() {
            own.clone()
        } else {
            let samples = samples(run);
            SteadyWindow::same(samples, reference, &own.steady)
                .unwrap_or_else(|| SteadyWindow::over(samples, reference, 0..0))
        };
        BodyRun { run: *run, window }
    };
    runs.iter().enumerate().map(body_run).collect()
}

fn body_study(bodies: &[BodyRun]) -> BodyStudy {
    if let Some(why) = bodies.iter().find_map(BodyRun::objection) {
        return BodyStudy { no_interval_because: Some(why), figures: Figures::default() };
    }
    BodyStudy {
        no_interval_because: None,
        figures: Figures::on_meshes(|quantity| interval(bodies, quantity)),
    }
}

/// The interval of a quantity.
fn interval(bodies: &[BodyRun], quantity: Quantity) -> Option<MeshInterval> {
    let finest = bodies.last()?;
    let on_mesh = |body: &BodyRun| {
        Some(OnMesh { width: body.run.result.width_m, value: quantity.mean(&body.window.steady)? })
    };
    let meshes: Vec<OnMesh> = bodies.iter().map(on_mesh).collect::<Option<_>>()?;
    let convergence = Convergence::of(&meshes)?;
    let blocks = quantity.blocks(finest.window.inside(), finest.window.reference)?;
    let statistical_half_width = STUDENT_90 * standard_error(&blocks);
    let half_width = convergence.mesh_half_width.hypot(statistical_half_width);
    let value = meshes.last()?.value;
    let scale = match quantity.figure.scale? {
        Scale::Drag => finest.window.steady.drag_scale(finest.window.reference),
        Scale::Force => finest.window.steady.scale(Some(value)),
        // A sinkage of less than a cell is compared with that.
        Scale::Depth => value.abs().max(finest.run.result.cell_m),
        Scale::One => 1.0,
    };
    let relative = |part: f64| {
        let ratio = if part == 0.0 { 0.0 } else { part / scale };
        ratio.is_finite().then_some(ratio)
    };
    Some(MeshInterval {
        interval: [value - half_width, value + half_width],
        half_width,
        statistical_half_width,
        convergence,
        index: relative(convergence.mesh_half_width),
        relative_half_width: relative(half_width),
    })
}

impl BodyRun<'_> {
    /// Why this run allows no interval, if it does not.
    fn objection(&self) -> Option<String> {
        let mesh = format!("the run on cells of {} mm", millimetres(self.run.result.cell_m));
        if self.run.result.verdict == Verdict::Broken {
            let broken = self.run.trust.checks.iter().find(|c| c.verdict == Verdict::Broken);
            let why = broken.map_or(String::new(), |check| format!(": {}", check.line()));
            return Some(format!("{mesh} is broken{why}"));
        }
        if self.window.inside().is_empty() {
            return Some(format!("{mesh} does not reach the steady window of the finest mesh"));
        }
        if block_averages(&self.of(|s| s.time)).is_none() {
            return Some(format!(
                "{mesh} has too few samples in the steady window for eight averages: use a shorter output.history_interval \
                 or a longer tow"
            ));
        }
        let is_steady = self.run.trust.is_steady(&self.window.reference.name);
        (!is_steady.unwrap_or_else(|| self.is_level())).then(|| format!("{mesh} is not steady"))
    }

    /// Whether the vertical force of a body that is not towed changes over the window by less than that of
    /// one that is may.
    fn is_level(&self) -> bool {
        debug_assert!(!self.window.is_towed());
        let scale = self.window.steady.scale(self.window.steady.vertical);
        Trend::of(&self.of(|s| s.vertical))
            .is_some_and(|trend| 100.0 * trend.change.abs() <= limits::STEADY_DRAG.good * scale)
    }

    fn of(&self, value: fn(&BodySample) -> f64) -> Vec<f64> {
        self.window.inside().iter().map(value).collect()
    }
}

/// A length in millimetres with at most five digits: 28.125.
pub fn millimetres(metres: f64) -> f64 {
    format!("{:.4e}", 1e3 * metres).parse().unwrap_or(1e3 * metres)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trust::{BodySetting, Check};

    fn disc() -> Reference {
        Reference {
            name: "disc".into(),
            kind: "disc".into(),
            length: 0.2,
            width: 0.05,
            across: 0.05,
            unit_weight: 16e3,
            radius: Some(0.1),
            towed: true,
            turns: true,
            ..Reference::default()
        }
    }

    /// A tow on cells of `cell`: an error of first order in drag and sinkage, and noise of the given size.
    fn history(cell: f64, noise: f64) -> History {
        let mut state = 9_u32;
        let body = (0..1000).map(|n| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let random = f64::from(state >> 8) / 2.0_f64.powi(24) - 0.5;
            let time = 0.004 * f64::from(n);
            BodySample {
                time,
                displacement: 0.2 * time,
                sinkage: 0.02 + 0.4 * cell,
                drag: 14.0 + 100.0 * cell + noise * random,
                vertical: 40.0,
                speed: 0.2,
                rolling_speed: 0.2,
                spin: 1.8,
                ..BodySample::default()
            }
        });
        History { names: vec!["disc".into()], bodies: vec![body.collect()], ..History::default() }
    }

    /// The study of runs with these cells and grades.
    fn study(cells: &[f64], grade: impl Fn(usize) -> Trust, history: impl Fn(f64) -> History) -> MeshStudy {
        let histories: Vec<History> = cells.iter().map(|cell| history(*cell)).collect();
        let grades: Vec<Trust> = (0..cells.len()).map(grade).collect();
        let result = |(cell, trust): (&f64, &Trust)| MeshResult {
            cell_m: *cell,
            width_m: *cell,
            verdict: trust.verdict,
            ..MeshResult::default()
        };
        let results: Vec<MeshResult> = cells.iter().zip(&grades).map(result).collect();
        let runs: Vec<MeshRun> = results
            .iter()
            .zip(&grades)
            .zip(&histories)
            .map(|((result, trust), history)| MeshRun { result, trust, history })
            .collect();
        evaluate(&runs, &[disc()], 0.3)
    }

    /// A grade with the steadiness of the disc.
    fn steady_or_not(is_steady: bool) -> Trust {
        let verdict = if is_steady { Verdict::Good } else { Verdict::Doubtful };
        let name = limits::STEADY_DRAG.name.to_owned();
        let check = Check { name, body: Some("disc".into()), verdict, ..Check::default() };
        Trust { verdict, checks: vec![check] }
    }

    const CELLS: [f64; 3] = [0.0225, 0.015, 0.01];

    #[test]
    fn intervals_hold_the_limit_and_the_noise() {
        let study = study(&CELLS, |_| steady_or_not(true), |cell| history(cell, 2.0));
        let BodyStudy { no_interval_because, figures } = &study.bodies["disc"];
        assert_eq!(*no_interval_because, None);
        let (drag, sinkage) = (figures.get("drag").unwrap(), figures.get("sinkage").unwrap());
        assert!(drag.interval[0] < 14.0 && drag.interval[1] > 15.0, "{drag:?}");
        assert!(drag.statistical_half_width > 0.0 && drag.half_width > drag.convergence.mesh_half_width);
        let square = drag.statistical_half_width.powi(2) + drag.convergence.mesh_half_width.powi(2);
        assert!((drag.half_width.powi(2) / square - 1.0).abs() < 1e-12);
        // Smooth: the error of 4 mm at order 1, times 1.25, on 24 mm.
        assert!((sinkage.index.unwrap() - 1.25 * 0.004 / 0.024).abs() < 1e-9, "{sinkage:?}");
        assert!((sinkage.convergence.observed_order.unwrap() - 1.0).abs() < 1e-6);
        let (vertical, turn_ratio) = (figures.get("vertical").unwrap(), figures.get("turn_ratio").unwrap());
        assert!(vertical.interval.iter().all(|v| (v - 40.0).abs() < 1e-9), "{vertical:?}");
        assert!(turn_ratio.half_width < 1e-9, "{turn_ratio:?}");
        let coarsest = &study.meshes[0].bodies["disc"];
        assert!((coarsest.means.get("sinkage").unwrap() - 0.029).abs() < 1e-12);
    }

    #[test]
    fn a_prescribed_sinkage_has_no_interval() {
        let mut study = study(&CELLS, |_| steady_or_not(true), |cell| history(cell, 2.0));
        let disc =
            |heaves_freely| [BodySetting { name: "disc".into(), heaves_freely, ..BodySetting::default() }];
        study.leave_out_prescribed(&disc(true));
        assert!(study.bodies["disc"].figures.get("sinkage").is_some());
        study.leave_out_prescribed(&disc(false));
        let figures = &study.bodies["disc"].figures;
        assert!(figures.get("sinkage").is_none() && figures.get("drag").is_some());
    }

    #[test]
    fn a_run_that_is_not_steady_or_broken_allows_no_interval() {
        let because = |study: MeshStudy| {
            let body = &study.bodies["disc"];
            assert_eq!((body.figures.get("drag"), body.figures.get("sinkage")), (None, None));
            body.no_interval_because.clone().unwrap()
        };
        for mesh in 0..3 {
            let why = because(study(&CELLS, |n| steady_or_not(n != mesh), |cell| history(cell, 0.0)));
            assert_eq!(why, format!("the run on cells of {} mm is not steady", [22.5, 15.0, 10.0][mesh]));
        }
        let broken = |n| Trust {
            verdict: if n == 1 { Verdict::Broken } else { Verdict::Good },
            ..steady_or_not(true)
        };
        assert!(because(study(&CELLS, broken, |cell| history(cell, 0.0))).contains("15 mm is broken"));
        let short = |cell: f64| {
            let mut history = history(cell, 0.0);
            if cell > 0.02 {
                history.bodies[0].truncate(700);
            }
            history
        };
        let why = because(study(&CELLS, |_| steady_or_not(true), short));
        assert!(why.contains("does not reach the steady window"), "{why}");
        let rare = |cell: f64| {
            let mut history = history(cell, 0.0);
            history.bodies[0] = history.bodies[0].iter().step_by(20).copied().collect();
            history
        };
        assert!(because(study(&CELLS, |_| steady_or_not(true), rare)).contains("too few samples"));
    }
}
