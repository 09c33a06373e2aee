//! Whether a case can be computed: its contact points, its time steps, the memory that it takes.

use crate::estimate::{self, Estimate};
use crate::keys;
use crate::resolved::Case;
use crate::resources::format_bytes;
use input::problem::Problems;

/// Largest number of time steps.
const MAX_STEPS: f64 = 1e12;
/// Least number: in a single step nothing that moves can meet soil that gives way.
const MIN_STEPS: f64 = 2.0;
/// Wave speeds [m/s] and densities [kg/m³] between which no stiffness and no density is at fault: those of
/// mud and of steel, and wide limits round them (chosen).
const WAVE_SPEEDS: [f64; 2] = [1.0, 1e4];
const DENSITIES: [f64; 2] = [10.0, 1e5];
/// Cell width below which cells are at fault [m]; chosen: less than a grain of silt.
const SMALL_CELL: f64 = 1e-6;

/// Reports a case that cannot be computed; its numbers must make sense.
pub(super) fn cost(case: &Case, problems: &mut Problems) {
    let before = problems.len();
    contact_points_remain(case, problems);
    can_be_computed(case, problems);
    // What cannot be computed has no contact points that could be counted, and no memory.
    if problems.len() == before {
        contact_points_are_not_too_many(case, problems);
        fits_into_memory(case, problems);
    }
}

const EDGE_INSET: &str = "numerics.edge_inset";

/// Refuses an inset that leaves no contact points: no force could act on the body.
fn contact_points_remain(case: &Case, problems: &mut Problems) {
    let mut cells = case.grid.fine_cell();
    if case.domain.plane_strain {
        // The slab is one cell, of any width.
        cells.y = case.domain.high.y - case.domain.low.y;
    }
    for (_, body) in case.touching() {
        let (low, high) = body.solid().bounds();
        let left = high - low - 2.0 * case.edge_inset(body) * cells;
        if left.cmplt(1e-6 * cells).any() {
            let message = format!("the inset leaves no contact points on body `{}`", body.name);
            let default = keys::at(EDGE_INSET).map_or_else(String::new, |key| key.default.text());
            problems.add(EDGE_INSET, message, format!("reduce it; {default} is the default"));
        }
    }
}

/// Refuses numbers that are too large or too small to compute with, and runs that would take too many steps,
/// or one.
fn can_be_computed(case: &Case, problems: &mut Problems) {
    let cost = estimate::estimate(case);
    let is_computable = cost.time_step_s > 0.0 && cost.time_step_s.is_finite();
    let message = if !is_computable || cost.steps > MAX_STEPS {
        format!("{:.1e} time steps of {:.1e} s are too many to run", cost.steps, cost.time_step_s)
    } else if cost.steps < MIN_STEPS {
        format!(
            "a run of {:.1e} s would be over in one time step, of {:.1e} s",
            case.duration, cost.time_step_s
        )
    } else {
        return;
    };
    let (path, cure) = at_fault(case, &cost);
    problems.add(path, message, cure);
}

/// The key that makes a time step or the number of steps impossible, and its cure.
fn at_fault(case: &Case, cost: &Estimate) -> (String, String) {
    let outside = |value: f64, [low, high]: [f64; 2]| !(low..=high).contains(&value);
    let soils = || case.soils().map(|(path, soil)| (path, soil.density, soil.material().wave_speed()));
    // The fastest waves set the step.
    let fastest = soils().max_by(|a, b| a.2.total_cmp(&b.2));
    match fastest {
        Some((path, density, _)) if outside(density, DENSITIES) => (
            format!("{path}.density"),
            format!("waves take their speed from it; it is {density:e} kg/m³, that of soil some 1500"),
        ),
        Some((path, _, speed)) if outside(speed, WAVE_SPEEDS) => {
            let cure = format!(
                "waves would travel at {speed:.1e} m/s; in soil it is some 20 to 500. Check the unit: 1 MPa is 1e6 Pa, 1 mPa is 0.001 Pa"
            );
            (format!("{path}.young_modulus"), cure)
        }
        _ if cost.smallest_cell_m < SMALL_CELL => (
            "grid.cell".into(),
            format!("its smallest cell is {:.1e} m; make it larger", cost.smallest_cell_m),
        ),
        _ if case.stages.is_empty() => (
            "run".into(),
            format!("the run lasts {:.1e} s; check its duration or tow_distance", case.duration),
        ),
        _ => (
            "stage".into(),
            format!("the stages last {:.1e} s together; check their durations", case.duration),
        ),
    }
}

/// Largest number of contact points of one body: generating them takes some 2 GB.
const MAX_POINTS: f64 = 1e7;

/// Refuses bodies with too many contact points.
fn contact_points_are_not_too_many(case: &Case, problems: &mut Problems) {
    let Some((name, points)) = estimate::most_contact_points(case) else { return };
    if points <= MAX_POINTS {
        return;
    }
    let message =
        format!("body `{name}` would have {points:.1e} contact points; at most {MAX_POINTS:.0e} are allowed");
    let cure = "make grid.cell or numerics.point_spacing larger, or the body smaller";
    problems.add("grid.cell", message, cure);
}

/// Refuses a case that needs more memory than this machine has; nothing of that size has been allocated yet.
fn fits_into_memory(case: &Case, problems: &mut Problems) {
    let cost = estimate::cost(case);
    let Some(left) = machine::memory_left() else { return };
    if cost.memory_bytes <= left.bytes {
        return;
    }
    let message = format!(
        "the grid of {:.3e} cells needs {} of memory, the contact points {}, writing {}; {} are free{}",
        cost.estimate.cells,
        format_bytes(cost.memory.grid_bytes),
        format_bytes(cost.memory.contact_bytes),
        format_bytes(cost.memory.outputs_bytes),
        format_bytes(left.bytes),
        left.of
    );
    let cure = "make grid.cell larger, or the box or the fine zone smaller";
    problems.add("grid.cell", message, cure);
}
