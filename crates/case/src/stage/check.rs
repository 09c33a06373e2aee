//! Stages by themselves: the bodies that they name, and their numbers.

use super::Stage;
use super::keys::FIELDS;
use crate::body::{Body, MOTIONS, check_motion, planes_forbid};
use crate::domain::Domain;
use input::key::{in_ranges, numbers};
use input::problem::Problems;
use mechanics::Motion;

/// Reports stages that name bodies which are not there, motions that a plane forbids, and numbers out of
/// their range.
pub(crate) fn check(stages: &[Stage], bodies: &[Body], domain: &Domain, problems: &mut Problems) {
    let (across_y, across_x) = (domain.symmetric || domain.plane_strain, domain.symmetric_x);
    for second in stages.iter().filter(|stage| stage.steady).skip(1) {
        let message = "another stage is the one over which averages are taken";
        problems.add(format!("stage.{}.steady", second.name), message, "leave it out of all but one stage");
    }
    for stage in stages {
        let path = format!("stage.{}", stage.name);
        in_ranges(&path, &numbers(FIELDS, stage), problems);
        if let Some(until) = stage.until {
            is_there(bodies, until.body, &format!("{path}.until.body"), problems);
            if !until.value.is_finite() {
                let message = format!("the stage `{}` waits for what is not a finite number", stage.name);
                problems.add(format!("{path}.until"), message, "give a finite value");
            }
        }
        for change in &stage.changes {
            let known = is_there(bodies, change.body, &path, problems);
            let Some((name, key)) = known.then(|| &bodies[change.body].name).zip(MOTIONS.get(change.motion))
            else {
                continue;
            };
            let path = format!("{path}.{name}.{key}");
            check_motion(&path, &change.to, problems);
            if change.to != Motion::Fixed && planes_forbid(across_y, across_x, change.motion) {
                let message = format!("a plane of symmetry or of strain allows no `{key}`");
                problems.add(path, message, "leave it out, or model the whole");
            }
        }
    }
}

fn is_there(bodies: &[Body], body: usize, path: &str, problems: &mut Problems) -> bool {
    let is_there = body < bodies.len();
    if !is_there {
        problems.add(path, "the stage names a body that is not there", "name one of the bodies");
    }
    is_there
}
