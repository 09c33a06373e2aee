//! The checks of one body: its motion, its forces, and how well the grid resolves it.

use super::check::Check;
use super::contact;
use super::limits::{self, Limit};
use super::setting::{BodySetting, Setting};
use super::steadiness::Trend;
use super::verdict::Verdict;
use crate::history::quantities::Steady;
use crate::history::reference::Reference;
use crate::history::steady::{SteadyPart, SteadyWindow, is_tow};
use crate::history::{BodySample, History, largest};
use case::resolved::Output;
use serde::{Deserialize, Serialize};

/// A body with everything that its checks need.
pub(super) struct BodyChecks<'a> {
    pub(super) setting: &'a Setting,
    pub(super) body: &'a BodySetting,
    /// Whether another program has moved the body.
    pub(super) is_steered: bool,
    pub(super) reference: &'a Reference,
    pub(super) samples: &'a [BodySample],
    pub(super) history: &'a History,
    pub(super) part: SteadyPart,
}

impl BodyChecks<'_> {
    pub(super) fn checks(&self) -> Vec<Check> {
        let window = SteadyWindow::of(self.samples, self.reference, self.part);
        let (inside, is_towed, steady) = (window.inside(), window.is_towed(), &window.steady);
        if !self.reference.has_surface() || self.hangs_clear(&window) {
            return Vec::new();
        }
        let mut checks = vec![self.check(&limits::LEAK, self.leak(inside))];
        checks.extend(contact::of_body(self.setting, self.body, self.samples, inside));
        checks.extend(self.resolution(&window));
        // Said where it keeps others from being made.
        checks.extend(
            (inside.len() < Output::FEWEST_SAMPLES)
                .then(|| self.check(&limits::SAMPLES, inside.len() as f64)),
        );
        if is_towed {
            checks.extend(self.trends(inside, steady));
            checks.extend(steady.drag_noise.map(|noise| self.check(&limits::NOISE, 100.0 * noise)));
            checks.extend(self.inertia(inside, steady));
            checks.extend(self.free_wheel(inside, steady));
        }
        checks.extend(self.forces(inside, steady, is_towed));
        checks.extend(self.drainage(inside));
        checks.extend(self.heave(steady));
        checks
    }

    pub(super) fn check(&self, limit: &'static Limit, value: f64) -> Check {
        Check::of(limit, Some(&self.body.name), value)
    }

    /// Soil inside the body over the volume of the body that soil surrounds [%], its mean over the window, as
    /// of forces, or at the end where that is more; 0 for a body that hardly touches the soil. That of a body
    /// that was never below the surface, as of a tray that carries soil, is the most of the run over its
    /// whole volume: what has passed through its floor has left it at the end.
    fn leak(&self, inside: &[BodySample]) -> f64 {
        let cell: f64 = self.body.cell.iter().product();
        let relative = |leaked: f64, volume: f64| {
            if leaked <= 1e-3 * cell { 0.0 } else { 100.0 * leaked / volume.max(1e-3 * cell) }
        };
        let was_below = self.samples.iter().any(|s| s.embedded_volume > 0.0);
        if !was_below && self.body.volume > 0.0 {
            return relative(largest(self.samples.iter().map(|s| s.leaked_volume)), self.body.volume);
        }
        // The fit of soil and body is known to a layer of one cell over its base at best.
        let layer = |s: &BodySample| (base(self.body, s.sinkage) * self.body.cell[2]).min(self.body.volume);
        let of_sample = |s: &BodySample| relative(s.leaked_volume, s.embedded_volume.max(layer(s)));
        let mean = inside.iter().map(of_sample).sum::<f64>() / inside.len().max(1) as f64;
        largest([mean].into_iter().chain(self.samples.last().map(of_sample)))
    }

    /// Cells over sinkage, contact chord and width, where the force depends on them.
    fn resolution(&self, window: &SteadyWindow<'_>) -> Vec<Check> {
        let mesh = Mesh::of(self.body, window);
        let mut checks = Vec::new();
        checks.extend(mesh.cells_over_sinkage.map(|n| self.check(&limits::SINKAGE_CELLS, n)));
        checks.extend(mesh.cells_over_chord.map(|n| self.check(&limits::CHORD_CELLS, n)));
        if window.is_towed() && self.shows_vertical(&window.steady) {
            checks.extend(mesh.cells_over_sinkage.map(|n| self.check(&limits::VERTICAL_CELLS, n)));
        }
        let width = self.body.thickness.or(self.body.extent[1]);
        checks.extend(width.map(|y| self.check(&limits::WIDTH_CELLS, y / self.body.cell[1])));
        checks
    }

    fn trends(&self, inside: &[BodySample], steady: &Steady) -> Vec<Check> {
        let trend = |value: fn(&BodySample) -> f64| Trend::of(&inside.iter().map(value).collect::<Vec<_>>());
        let drag = steady.drag_scale(self.reference).max(self.setting.least_force());
        let mut checks = Vec::from_iter(self.trend(&limits::STEADY_DRAG, trend(|s| s.drag), drag));
        if self.body.heaves_freely {
            let depth = steady.sinkage.unwrap_or(0.0).abs().max(self.body.cell[2]);
            checks.extend(self.trend(&limits::STEADY_SINKAGE, trend(|s| s.sinkage), depth));
        }
        checks
    }

    /// The change of a quantity over the window relative to its size; `None` where the window has too few
    /// samples.
    pub(super) fn trend(&self, limit: &'static Limit, trend: Option<Trend>, scale: f64) -> Option<Check> {
        let change = |trend: Trend| if scale > 0.0 { 100.0 * trend.change.abs() / scale } else { 0.0 };
        trend.map(|trend| self.check(limit, change(trend)))
    }

    /// Contribution of the soil's momentum to the force: dynamic pressure on the embedded portion of the
    /// front.
    fn inertia(&self, inside: &[BodySample], steady: &Steady) -> Option<Check> {
        let depth = steady.sinkage.filter(|z| *z > 0.0)?;
        let force = steady.drag?.hypot(steady.vertical?);
        let speed = inside.iter().map(|s| s.speed.abs()).sum::<f64>() / inside.len().max(1) as f64;
        let added = analytic::inertia_pressure(self.setting.density, speed) * depth * self.reference.across;
        // Where no force acts, the check of contact speaks.
        (force > self.setting.least_force()).then(|| self.check(&limits::INERTIA, 100.0 * added / force))
    }

    /// The drainage number at the mean speed over the window.
    fn drainage(&self, inside: &[BodySample]) -> Option<Check> {
        let per_speed = self.setting.drainage_per_speed?;
        let ways = inside.windows(2).map(|pair| {
            let [a, b] = [&pair[0], &pair[1]];
            let level =
                (b.displacement - a.displacement).hypot(b.lateral_displacement - a.lateral_displacement);
            level.hypot(b.sinkage - a.sinkage)
        });
        let way: f64 = ways.sum();
        let duration = inside.last()?.time - inside.first()?.time;
        let check =
            self.check(&limits::DRAINAGE, if duration > 0.0 { per_speed * way / duration } else { 0.0 });
        let is_accepted = self.setting.accepts_drained && check.verdict == Verdict::Broken;
        Some(if is_accepted { Check { verdict: Verdict::Doubtful, ..check } } else { check })
    }

    /// How far the turn ratio of a wheel without torque lies outside its physical range, unless the wheel
    /// stands.
    fn free_wheel(&self, inside: &[BodySample], steady: &Steady) -> Option<Check> {
        let is_free = self.body.turns_freely && !self.is_steered;
        let ratio = steady.turn_ratio.filter(|_| is_free && is_tow(inside, self.reference))?;
        Some(self.check(&limits::FREE_WHEEL, (-ratio).max(ratio - 1.0).max(0.0)))
    }

    /// A body that moves vertically stays in the ground, and above the floor.
    fn heave(&self, steady: &Steady) -> Vec<Check> {
        let mut checks = Vec::new();
        if self.body.heaves_freely
            && self.has_touched()
            && !self.is_above_ground()
            && !self.is_beside_one_that_sinks()
            && let (Some(sinkage), Some(height)) = (steady.sinkage, self.body.extent[2])
        {
            checks.push(self.check(&limits::RIDING_HEIGHT, (-100.0 * sinkage / height).max(0.0)));
        }
        if self.body.heaves {
            let deepest = self.samples.iter().map(|s| s.sinkage).fold(f64::NEG_INFINITY, f64::max);
            let distance = (self.setting.floor_depth - deepest) / self.body.cell[2];
            checks.push(self.check(&limits::BODY_IN_BOX, distance));
        }
        checks
    }

    /// Whether the body has been above the ground all the time, where it may have met a soil body.
    fn is_above_ground(&self) -> bool {
        self.setting.heaped && self.samples.iter().all(|s| s.sinkage <= 0.0)
    }

    /// Whether the body hangs clear of the soil in the window beside others of its gear, as a spacer between
    /// discs: it bears next to nothing beside one of them.
    fn hangs_clear(&self, window: &SteadyWindow<'_>) -> bool {
        let mean = |samples: &[BodySample]| {
            samples.iter().map(BodySample::force).sum::<f64>() / samples.len().max(1) as f64
        };
        let of_body = |samples: &Vec<BodySample>| samples.get(window.range.clone()).map_or(0.0, mean);
        let most = largest(self.others_of_gear().map(of_body));
        most >= self.setting.least_force() && mean(window.inside()) < CLEAR * most
    }

    /// Whether another body of the gear has sunk into the ground: the height of this one is its.
    fn is_beside_one_that_sinks(&self) -> bool {
        self.others_of_gear().any(|samples| samples.last().is_some_and(|s| s.sinkage > 0.0))
    }

    /// The samples of the other bodies of the gear that this one is part of.
    fn others_of_gear(&self) -> impl Iterator<Item = &Vec<BodySample>> {
        let bodies = self.setting.bodies.iter().zip(&self.history.bodies);
        let is_of_gear = |body: &BodySetting| body.gear.is_some() && body.gear == self.body.gear;
        bodies
            .filter(move |(body, _)| is_of_gear(body) && body.name != self.body.name)
            .map(|(_, samples)| samples)
    }

    /// Whether the body has been in the soil.
    fn has_touched(&self) -> bool {
        !self.history.boundaries.is_empty()
            && self.samples.iter().any(|s| s.sinkage > 0.0 || s.vertical > 0.0)
    }
}

/// Part of the force on another body below which a body of the same gear bears next to nothing (chosen).
const CLEAR: f64 = 0.01;

/// Area of a body's base at a sinkage of at least a cell [m²]; of a round body its chord times its width.
pub(super) fn base(body: &BodySetting, sinkage: f64) -> f64 {
    let [length, width, height] = [0, 1, 2].map(|axis| body.extent[axis].unwrap_or(body.cell[axis]));
    let depth = sinkage.min(height).max(body.cell[2]);
    let chord = |d: f64| 2.0 * (depth.min(0.5 * d) * (d - depth.min(0.5 * d))).sqrt();
    body.diameter.map_or(length, chord) * width
}

/// How well the grid resolves a body's contact with the ground; `null` in JSON where it does not matter.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Mesh {
    /// Sinkage in the steady window over the cell height; `None` where the force does not depend on it.
    pub cells_over_sinkage: Option<f64>,
    /// Length of the contact along the tow over the cell width.
    pub cells_over_chord: Option<f64>,
}

impl Mesh {
    /// The sinkage matters for a towed body and for a round one, not for a flat base that is pressed down;
    /// the chord for all but a towed body with a flat front. Neither is defined for a body that is above the
    /// ground all the time, nor for one that is held above it in the window, as one that has been lifted out.
    #[must_use]
    pub fn of(body: &BodySetting, window: &SteadyWindow<'_>) -> Self {
        let above =
            |samples: &[BodySample]| samples.iter().all(|s| s.sinkage <= 0.0 && s.embedded_volume <= 0.0);
        if above(window.samples) || !body.heaves_freely && above(window.inside()) {
            return Self::default();
        }
        let depth = window.steady.sinkage.map(|z| z.max(0.0));
        let is_towed = window.is_towed();
        let matters = is_towed || body.diameter.is_some();
        let chord = match (body.diameter, depth) {
            (Some(d), Some(z)) if z < 0.5 * d => Some(2.0 * (z * (d - z)).sqrt()),
            (Some(d), _) => Some(d),
            (None, _) if is_towed => None,
            (None, _) => body.extent[0],
        };
        Self {
            cells_over_sinkage: depth.filter(|_| matters).map(|z| z / body.cell[2]),
            cells_over_chord: chord.map(|c| c / body.cell[0]),
        }
    }
}
