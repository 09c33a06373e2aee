//! The checks of a mesh study.

use super::figures::{BodyStudy, MeshInterval, MeshStudy};
use crate::history::quantities::{Figures, Scale};
use crate::trust::limits::{self, Limit};
use crate::trust::{BodySetting, Check, Verdict};

impl MeshStudy {
    /// Takes out intervals of a sinkage that is prescribed: it is known.
    pub fn leave_out_prescribed(&mut self, bodies: &[BodySetting]) {
        for body in bodies.iter().filter(|body| !body.heaves_freely) {
            if let Some(study) = self.bodies.get_mut(&body.name) {
                study.figures = Figures::on_meshes(|quantity| match quantity.figure.scale {
                    Some(Scale::Depth) => None,
                    _ => study.figures.get(quantity.figure.name),
                });
            }
        }
    }

    /// The checks of the study; a figure without an interval is doubtful. `is_towed` says which of the bodies
    /// are.
    #[must_use]
    pub fn checks(&self, bodies: &[BodySetting], is_towed: impl Fn(&str) -> bool) -> Vec<Check> {
        let mut checks = Vec::new();
        for body in bodies {
            if let Some(study) = self.bodies.get(&body.name) {
                checks.extend(of_body(body, study, is_towed(&body.name)));
            }
        }
        let coarser = self.meshes.split_last().map_or(&[][..], |(_, coarser)| coarser);
        let broken = coarser.iter().filter(|mesh| mesh.verdict == Verdict::Broken).count();
        checks.push(Check::of(&limits::COARSER_MESHES, None, broken as f64));
        checks
    }
}

/// The drag of a body that is towed; its sinkage where it is free to sink, otherwise its vertical force.
fn of_body(body: &BodySetting, study: &BodyStudy, is_towed: bool) -> Vec<Check> {
    let drag = (&limits::DRAG_INTERVAL, study.figures.get("drag"));
    let other = if body.heaves_freely {
        (&limits::SINKAGE_INTERVAL, study.figures.get("sinkage"))
    } else {
        (&limits::VERTICAL_INTERVAL, study.figures.get("vertical"))
    };
    let check = |(limit, figure): (&'static Limit, Option<MeshInterval>)| match (
        figure,
        &study.no_interval_because,
    ) {
        (Some(figure), _) => {
            Check::of(limit, Some(&body.name), 100.0 * figure.relative_half_width.unwrap_or(f64::INFINITY))
        }
        (None, Some(why)) => {
            Check::unavailable(limit, Some(&body.name), &format!("there is no interval: {why}"))
        }
        (None, None) => {
            Check::unavailable(limit, Some(&body.name), "there is no interval: the mean is not a number")
        }
    };
    is_towed.then_some(drag).into_iter().chain([other]).map(check).collect()
}
