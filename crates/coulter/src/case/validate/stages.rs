//! The stages of a run.

use super::body;
use crate::case::numbers::in_range;
use crate::case::problem::Problems;
use crate::case::resolved::{Case, MOTIONS, Motion};
use crate::case::rigid_body::planes_forbid;

/// Reports stages that name bodies which are not there, motions that a plane forbids, and numbers out of their range.
pub(super) fn stages(case: &Case, problems: &mut Problems) {
    let (across_y, across_x) = (case.domain.symmetric || case.domain.plane_strain, case.domain.symmetric_x);
    for stage in &case.stages {
        let path = format!("stage.{}", stage.name);
        in_range(&format!("{path}.duration"), stage.duration, problems);
        if let Some(until) = stage.until {
            is_there(case, until.body, &format!("{path}.until.body"), problems);
            if !until.value.is_finite() {
                let message = format!("the stage `{}` waits for what is not a finite number", stage.name);
                problems.add(format!("{path}.until"), message, "give a finite value");
            }
        }
        for change in &stage.changes {
            let known = is_there(case, change.body, &path, problems);
            let Some((name, key)) =
                known.then(|| &case.bodies[change.body].name).zip(MOTIONS.get(change.motion))
            else {
                continue;
            };
            let path = format!("{path}.{name}.{key}");
            body::motion(&path, &change.to, problems);
            if change.to != Motion::Fixed && planes_forbid(across_y, across_x, change.motion) {
                let message = format!("a plane of symmetry or of strain allows no `{key}`");
                problems.add(path, message, "leave it out, or model the whole");
            }
        }
    }
}

fn is_there(case: &Case, body: usize, path: &str, problems: &mut Problems) -> bool {
    let is_there = body < case.bodies.len();
    if !is_there {
        problems.add(path, "the stage names a body that is not there", "name one of the bodies");
    }
    is_there
}
