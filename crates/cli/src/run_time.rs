//! Estimates the run time of a case on this machine, from trial steps of it, or of a region of a large one,
//! in which the bodies move at full speed at the depth that they are expected to reach: contact, remap and
//! yielding make steps up to five times as dear as the first ones of a run.

use coulter::case::estimate::{Cost, Estimate, expected_sinkage, most_contact_points};
use coulter::case::path::travel;
use coulter::case::resolved::{Case, Ground, Motion, Precision};
use coulter::simulation::Simulation;
use glam::DVec3;
use std::time::Duration;

/// Most cells of a case that is tried as a whole, which takes little time; of a larger one it is a region.
const MOST_CELLS: f64 = 2e5;
/// Cells along each axis of the trial region.
const MAX_CELLS: usize = 40;
/// Time until bodies that start at full speed have set the soil in motion; number and duration of the trials
/// after it, of which the median counts; in processor time, so that other programs do not matter much.
const WARM_UP: Duration = Duration::from_millis(500);
const TRIALS: usize = 9;
const TRIAL_TIME: Duration = Duration::from_millis(100);
/// Most contact points of the body in it; what they cost is little beside the soil.
const MOST_POINTS: f64 = 2e5;
/// Cost of the steps of a run over that of the trial with moving bodies: a run begins gently. Chosen after a
/// look at the times of the shipped cases (`scripts/speed/run_times.py`).
const STEPS_OF_A_RUN: f64 = 0.95;
/// Processor time over wall-clock time and threads: for two threads it was 1.5 to 1.9 over 2 in the shipped
/// cases, the least where contact takes most.
const EFFICIENCY: f64 = 0.83;
/// Time for the report [s], between 0.6 and 1.5 on two machines, and per cell of a field file [s]; measured.
const WRITING: [f64; 2] = [1.2, 1.3e-6];

/// Wall-clock time of a run of the case on this machine [s]; `None` if the first step fails.
pub(super) fn estimate(case: &Case, cost: &Cost) -> Option<f64> {
    let Estimate { cells, filled_cells, steps, .. } = cost.estimate;
    let writing = WRITING[0] + WRITING[1] * cells * cost.output.frames;
    let moving = in_motion(case).and_then(|case| measured(&case, cells));
    let rate = moving.map(|rate| rate / STEPS_OF_A_RUN).or_else(|| measured(case, cells))?;
    Some(writing + steps * filled_cells / rate).filter(|seconds| seconds.is_finite())
}

/// The case with its bodies at full speed and as deep as they are expected to sink, or half as deep as they
/// are moved; `None` without a body that could touch the soil.
fn in_motion(case: &Case) -> Option<Case> {
    case.touching().next()?;
    let mut moving = Case { stages: Vec::new(), ..case.clone() };
    let mut lowered: f64 = 0.0;
    for body in &mut moving.bodies {
        if let Some(staged) = body.staged.take() {
            let [x, y, z, yaw, tilt, spin] = staged.motions;
            (body.translation, body.rotation) = ([x, y, z], [yaw, tilt, spin]);
        }
        let heave = &body.translation[2];
        let sunk =
            if heave.is_free() { -expected_sinkage(case, body) } else { 0.5 * travel(heave, case.duration) };
        lowered = lowered.min(sunk);
        for motion in body.translation.iter_mut().chain(&mut body.rotation) {
            *motion = at_full_speed(motion, case.duration);
        }
    }
    // All alike, since joints may connect them.
    moving.bodies.iter_mut().for_each(|body| body.position.z += lowered);
    Some(moving)
}

/// A motion without its ramps.
fn at_full_speed(motion: &Motion, duration: f64) -> Motion {
    match motion {
        Motion::Fixed => Motion::Fixed,
        Motion::Prescribed { before, speed, .. } => {
            Motion::prescribed(if speed.abs() > before.abs() { *speed } else { *before })
        }
        Motion::Course(course) => Motion::prescribed(course.displacement(duration) / duration),
        Motion::Free { load, .. } => Motion::loaded(*load),
    }
}

/// Cell-steps per second over the cells with soil, from the first steps of the case or of a region of it;
/// `None` where they fail, and where there is hardly any soil.
fn measured(case: &Case, cells: f64) -> Option<f64> {
    let mut region = if cells <= MOST_CELLS { case.clone() } else { around_the_first_body(case) };
    // Points are laid out on the whole body, however small the region: of a large one fewer.
    let points = most_contact_points(&region).map_or(0.0, |(_, points)| points);
    region.numerics.point_spacing *= (points / MOST_POINTS).sqrt().max(1.0);
    let rate = match case.numerics.precision {
        Precision::Double => typical_speed(Simulation::<f64>::new(&region)),
        Precision::Single => typical_speed(Simulation::<f32>::new(&region)),
    };
    rate.filter(|rate| *rate > 0.0)
}

/// Cell-steps per second of all threads together, on a machine that has nothing else to do.
fn typical_speed<R: solver::precision::Precision>(mut simulation: Simulation<R>) -> Option<f64> {
    simulation.speed(WARM_UP)?;
    let mut speeds: Vec<f64> = (0..TRIALS).filter_map(|_| simulation.speed(TRIAL_TIME)).collect();
    speeds.sort_by(f64::total_cmp);
    let median = speeds.get(speeds.len() / 2)?;
    let threads = simulation.threads() as f64;
    Some(median * if threads > 1.0 { EFFICIENCY * threads } else { 1.0 })
}

/// The case in a box of a few cells round its first body, or round the edge of its soil.
fn around_the_first_body(case: &Case) -> Case {
    let mut region = case.clone();
    region.joints.clear();
    let first = region.touching().next().map(|(n, _)| n);
    region.bodies = first.map(|n| region.bodies.swap_remove(n)).into_iter().collect();
    region.grid.follow = None;
    let middle = middle(case);
    for axis in 0..3 {
        let faces = window(&case.grid.faces[axis], middle[axis]);
        region.domain.low[axis] = faces[0];
        region.domain.high[axis] = faces[faces.len() - 1];
        region.grid.faces[axis] = faces.to_vec();
    }
    region
}

/// The centre of the trial region [m].
fn middle(case: &Case) -> DVec3 {
    let surface = case.ground.surface();
    match (case.touching().next(), case.ground) {
        (Some((_, body)), _) => body.position.with_z(body.position.z.min(surface)),
        (None, Ground::Column { low, high, .. }) => {
            DVec3::new(high.x, 0.5 * (low.y + high.y), 0.5 * (low.z + high.z))
        }
        (None, Ground::Level { .. }) => (0.5 * (case.domain.low + case.domain.high)).with_z(surface),
    }
}

/// The faces of at most [`MAX_CELLS`] cells round a point.
fn window(faces: &[f64], middle: f64) -> &[f64] {
    let cells = faces.len() - 1;
    let kept = cells.min(MAX_CELLS);
    let at = faces.partition_point(|face| *face <= middle);
    let first = at.saturating_sub(kept / 2 + 1).min(cells - kept);
    &faces[first..=first + kept]
}

#[cfg(test)]
mod tests {
    use super::*;
    use coulter::case;

    #[test]
    fn a_part_holds_the_body_and_the_surface() {
        let text = include_str!("../../../cases/light_disc.toml");
        let case = case::parse(text, "case.toml", &["grid.cell=5 mm".to_owned()]).unwrap();
        let region = around_the_first_body(&case);
        for axis in 0..3 {
            assert_eq!(region.grid.faces[axis].len(), MAX_CELLS + 1, "axis {axis}");
            assert!(case.grid.faces[axis].contains(&region.domain.low[axis]));
        }
        assert!(region.domain.low.x < 0.0 && region.domain.high.x > 0.0);
        assert!(region.domain.low.y == 0.0, "the plane of symmetry stays");
        assert!(region.domain.low.z < 0.0 && region.domain.high.z > 0.0);
    }

    #[test]
    fn the_bodies_of_the_trial_move_at_once() {
        let text = include_str!("../../../cases/light_disc.toml");
        let case = case::parse(text, "case.toml", &[]).unwrap();
        let moving = in_motion(&case).unwrap();
        let (before, now) = (&case.bodies[0], &moving.bodies[0]);
        let sunk = before.position.z - now.position.z;
        // Its runs sink by 13.6 mm.
        assert!((0.005..0.03).contains(&sunk), "{sunk}");
        assert_eq!(now.translation[0].speed(0.0), before.translation[0].speed(case.duration));
        assert_eq!(now.translation[2].load(0.0), before.translation[2].load(case.duration));
    }

    #[test]
    fn a_window_stays_inside() {
        let faces: Vec<f64> = (0..=100).map(f64::from).collect();
        for (middle, first) in [(-5.0, 0.0), (3.0, 0.0), (50.5, 30.0), (99.0, 60.0), (200.0, 60.0)] {
            let kept = window(&faces, middle);
            assert_eq!((kept[0], kept.len()), (first, MAX_CELLS + 1), "{middle}");
        }
        assert_eq!(window(&faces[..11], 3.0), &faces[..11]);
    }
}
