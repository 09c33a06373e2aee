//! Displacements over time, and when they come in the run.

use super::resolved::{Body, Case, MOTIONS, Motion};

/// A displacement over time in a case.
pub(super) struct TimedMotion {
    /// Path of the key of the motion.
    pub(super) path: String,
    /// Times of the first and the last point of the motion [s].
    pub(super) span: [f64; 2],
    /// How long the run goes on after the moment from which times of the motion count [s].
    pub(super) remaining: f64,
    /// Last speed of the motion [m/s or rad/s].
    pub(super) last_speed: f64,
}

impl Case {
    /// Every displacement over time, of bodies and of stages.
    pub(super) fn timed_motions(&self) -> Vec<TimedMotion> {
        let timed = |path: String, motion: &Motion, remaining: f64| {
            let Motion::Course(course) = motion else { return None };
            let span = course.span();
            Some(TimedMotion { path, span, remaining, last_speed: course.speed(span[1]) })
        };
        let of_body = |body: &Body| {
            let motions = body.motions();
            let name = body.name.clone();
            let one = move |(motion, key): (&Motion, &str)| {
                timed(format!("body.{name}.{key}"), motion, self.duration)
            };
            motions.iter().zip(MOTIONS).filter_map(one).collect::<Vec<_>>()
        };
        let mut all: Vec<TimedMotion> = self.bodies.iter().flat_map(of_body).collect();
        let mut remaining = self.duration;
        for stage in &self.stages {
            for change in &stage.changes {
                let body = self.bodies.get(change.body).map_or("", |body| body.name.as_str());
                let key = MOTIONS.get(change.motion).copied().unwrap_or_default();
                all.extend(timed(format!("stage.{}.{body}.{key}", stage.name), &change.to, remaining));
            }
            remaining -= stage.duration;
        }
        all
    }
}
