//! Ground that is not level: whether its slopes stand, its furrows are resolved, and bodies start above them.

use crate::path::Paths;
use crate::resolved::{Body, Case, Law, Tresca};

/// Cells from crest to crest below which furrows are mentioned (chosen: a crest and a trough of four cells
/// each).
const CELLS_A_FURROW: f64 = 8.0;
/// Height of a steep slope of undrained soil over s_u/γ at which it fails (Taylor 1937, a vertical one).
const STABLE_HEIGHT: f64 = 3.83;

/// Warns of slopes that do not stand, furrows and soil bodies of few cells, and bodies that start inside
/// ridges.
pub(super) fn uneven(case: &Case, notes: &mut Vec<String>) {
    small(case, notes);
    if case.relief.is_level() {
        return;
    }
    slopes(case, notes);
    resolution(case, notes);
    for (_, body) in case.touching() {
        buried(case, body, notes);
    }
}

/// Furrows of few cells: in the fine zone, or where they enter a grid that travels.
fn resolution(case: &Case, notes: &mut Vec<String>) {
    let Some(furrows) = case.relief.furrows else { return };
    let across = furrows.across();
    let cells_of = |width: [f64; 2]| furrows.spacing / (across[0] * width[0]).hypot(across[1] * width[1]);
    let fine = case.grid.fine_cell();
    let cells = cells_of([fine.x, fine.y]);
    if cells < CELLS_A_FURROW {
        notes.push(format!(
            "{cells:.1} cells from crest to crest of the furrows; {CELLS_A_FURROW} or more are advisable."
        ));
        return;
    }
    let follows = |axis: usize| case.grid.follow.is_some_and(|follow| follow.axes[axis]);
    let [back, ahead] = Paths::of(case).of_grid();
    let widest = [0, 1].map(|axis| {
        // Ground that has passed the fine zone does not matter any more.
        let enters = |f: &&[f64]| {
            if ahead[axis] >= -back[axis] {
                f[1] > case.grid.fine_low[axis]
            } else {
                f[0] < case.grid.fine_high[axis]
            }
        };
        let faces = case.grid.faces[axis].windows(2).filter(enters);
        if follows(axis) { faces.map(|f| f[1] - f[0]).fold(0.0, f64::max) } else { fine[axis] }
    });
    let cells = cells_of(widest);
    if cells < CELLS_A_FURROW {
        notes.push(format!(
            "Furrows enter through cells that are {cells:.1} to a furrow, which flatten them; {CELLS_A_FURROW} or more are advisable: extend \
             grid.fine_x and grid.fine_y to where the ground enters, or make grid.growth smaller."
        ));
    }
}

/// Slopes steeper than the soil bears.
fn slopes(case: &Case, notes: &mut Vec<String>) {
    let relief = case.relief.of_solver();
    let steepest = relief.steepest(case.area()).atan() + case.slope.tangent().atan();
    let [lowest, highest] = relief.extremes(case.area());
    let angle = steepest.to_degrees();
    match case.soil.law {
        Law::Tresca(Tresca { shear_strength, .. }) => {
            if case.soil.unit_weight * (highest - lowest) > STABLE_HEIGHT * shear_strength {
                notes.push(format!(
                    "The surface rises by {:.3} m: where it is steep, clay of this strength slides at once beyond {:.3} m.",
                    highest - lowest,
                    STABLE_HEIGHT * shear_strength / case.soil.unit_weight
                ));
            }
        }
        law => {
            let loose = law.cohesion() == Some(0.0) && case.soil.unit_weight > 0.0;
            if let Some(friction) = law.friction_angle().filter(|friction| loose && steepest > *friction) {
                notes.push(format!(
                    "The surface is up to {angle:.1}° steep, the friction angle {:.1}°: such slopes slide at once.",
                    friction.to_degrees()
                ));
            }
        }
    }
}

/// Soil bodies of which a cell holds a good part.
fn small(case: &Case, notes: &mut Vec<String>) {
    for body in &case.soil_bodies {
        let [low, high] = body.solver_body(0).bounds;
        let mut cells = (high - low) / case.grid.fine_cell();
        if case.domain.plane_strain {
            cells.y = f64::INFINITY;
        }
        if cells.min_element() < 2.0 {
            notes.push(format!(
                "soil body {}: {:.1} cells across; most cells hold a mixture of it and the soil round it, and obey the law of whichever \
                 they hold more of.",
                body.name,
                cells.min_element()
            ));
        }
    }
}

/// A body that is meant to start above the ground, and starts in a ridge.
fn buried(case: &Case, body: &Body, notes: &mut Vec<String>) {
    let (low, high) = (body.position + body.bounds().0, body.position + body.bounds().1);
    let below = [[low.x, high.x], [low.y, high.y]];
    let highest = case.ground.surface() + case.relief.of_solver().extremes(below)[1];
    if low.z >= case.ground.surface() && low.z < highest - 1e-9 {
        notes.push(format!(
            "{}: starts up to {:.4} m below the surface of the ground, whose soil is taken out there; raise it (a negative sinkage).",
            body.name,
            highest - low.z
        ));
    }
}
