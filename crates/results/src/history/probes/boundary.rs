//! What the soil does at the faces of the box: whether it presses on the lid, has come to a side wall that
//! was bare, and how far the stress at walls and floor has risen above that at rest.

use crate::domain::PlacedDomain;
use crate::history::BoundarySample;
use case::Case;
use case::resolved::Ground;
use glam::DVec3;
use solver::exact_sum::{ExactSum, over_blocks};
use solver::halo::Halo;
use solver::model::Model;
use solver::precision::Precision;
use solver::state::State;

/// A cell with so much soil touches the face that it lies at.
const TOUCHES: f64 = 0.5;

/// A face of the box: the axis across it, and whether it is the high one.
type Face = (usize, bool);

/// The soil at the faces of the domain; forces and areas are those of the whole, not of the modelled portion.
#[must_use]
pub(super) fn sample<R: Precision>(
    case: &Case,
    model: &Model,
    state: &State<R>,
    halo: &Halo,
) -> BoundarySample {
    let whole = 1.0 / model.modelled_fraction();
    let domain = PlacedDomain::of(&model.grid, state.grid_position);
    let [mut lid_area, mut lid_force, mut wall_area] = [ExactSum::default(); 3];
    let mut stress_rise = [0.0_f64];
    if !is_covered(case) {
        over((2, true), &domain, |cell| {
            if cell.fraction(state) >= TOUCHES {
                lid_area.add(cell.area * whole);
                lid_force.add(cell.normal_pressure(state).max(0.0) * cell.area * whole);
            }
        });
    }
    for face in walls(case, model) {
        over(face, &domain, |cell| {
            if cell.fraction(state) < TOUCHES {
                return;
            }
            if face.0 != 2 && !held_soil(case, model, cell.centre) {
                wall_area.add(cell.area * whole);
            }
            let rise = cell.normal_pressure(state) - pressure_at_rest(case, model, &cell);
            stress_rise[0] = stress_rise[0].max(rise);
        });
    }
    let [lid_area, lid_force, wall_area] = over_blocks(halo, [lid_area, lid_force, wall_area]);
    halo.largest(&mut stress_rise);
    BoundarySample { time: state.time, lid_area, lid_force, wall_area, stress_rise: stress_rise[0] }
}

/// Middle of the lid's cell that bears the highest pressure [m].
#[must_use]
pub fn most_pressed_lid_cell<R: Precision>(model: &Model, state: &State<R>, halo: &Halo) -> DVec3 {
    let (mut most, mut position) = (f64::NEG_INFINITY, DVec3::NAN);
    let domain = PlacedDomain::of(&model.grid, state.grid_position);
    over((2, true), &domain, |cell| {
        if cell.fraction(state) >= TOUCHES && cell.normal_pressure(state) > most {
            (most, position) = (cell.normal_pressure(state), cell.centre);
        }
    });
    let all = halo.gather([[most].as_slice(), &position.to_array()].concat());
    let higher = |a: &[f64], b: &[f64]| a[0] < b[0];
    let found = all.chunks_exact(4).reduce(|a, b| if higher(a, b) { b } else { a });
    found.map_or(position, |found| DVec3::from_slice(&found[1..]))
}

/// Whether the soil reaches up to the lid from the start: then the lid is part of the case.
fn is_covered(case: &Case) -> bool {
    case.top_of_ground() >= case.domain.high.z - 1e-9 * case.grid.cell
}

/// Floor and side walls; planes of symmetry and of plane strain and faces through which soil flows are not
/// among them.
fn walls(case: &Case, model: &Model) -> Vec<Face> {
    let domain = &case.domain;
    let mut faces = vec![(2, false), (0, true)];
    if !domain.symmetric_x {
        faces.push((0, false));
    }
    if !domain.plane_strain {
        faces.push((1, true));
        if !domain.symmetric {
            faces.push((1, false));
        }
    }
    faces.retain(|&(axis, is_high)| !model.boundaries.0[axis][usize::from(is_high)].is_open());
    faces
}

/// Whether there was soil at this position at the start.
fn held_soil(case: &Case, model: &Model, x: DVec3) -> bool {
    match case.ground {
        Ground::Level { .. } if model.ground.bodies.iter().any(|body| body.distance(x) < 0.0) => true,
        Ground::Level { .. } => x.z <= local_surface(model, x) + settling(case),
        Ground::Column { low, high, radius } => {
            x.cmpge(low).all()
                && x.cmple(high).all()
                && radius.is_none_or(|r| x.truncate().length_squared() <= r * r)
        }
    }
}

/// Pressure on the cell's face at the start [Pa].
fn pressure_at_rest(case: &Case, model: &Model, cell: &FaceCell) -> f64 {
    if !held_soil(case, model, cell.centre) {
        return 0.0;
    }
    let surface = local_surface(model, cell.centre);
    let depth = (surface - cell.centre.z).max(0.0);
    let vertical =
        model.material().density_at(surface - 0.5 * depth) * model.soil_gravity * -model.down.z * depth
            + case.overburden;
    if cell.axis == 2 { vertical } else { model.material().k0 * vertical }
}

/// Height over which an uneven surface settles, and is smeared as a grid travels over it [m]: a cell.
fn settling(case: &Case) -> f64 {
    if case.relief.is_level() { 0.0 } else { case.grid.fine_cell().z }
}

/// Height of the undisturbed surface over a point [m], without heaps of other soil.
fn local_surface(model: &Model, x: DVec3) -> f64 {
    if model.ground.relief.is_level() {
        return model.surface;
    }
    model.surface + model.ground.relief.at([x.x, x.y])
}

/// A cell at a face of the box.
struct FaceCell {
    index: usize,
    axis: usize,
    /// Area of the face of the cell [m²].
    area: f64,
    /// Middle of the cell [m].
    centre: DVec3,
}

impl FaceCell {
    fn fraction<R: Precision>(&self, state: &State<R>) -> f64 {
        state.soil.fraction[self.index].into()
    }

    /// Pressure on the face [Pa].
    fn normal_pressure<R: Precision>(&self, state: &State<R>) -> f64 {
        -state.soil.stress[self.axis][self.index].into()
    }
}

fn over((axis, is_high): Face, domain: &PlacedDomain, mut each: impl FnMut(FaceCell)) {
    if !domain.reaches(axis, usize::from(is_high)) {
        return;
    }
    let cells = domain.cells();
    let layer = if is_high { cells[axis] - 1 } else { 0 };
    let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
    for n in 0..cells[b] {
        for m in 0..cells[a] {
            let mut at = [0; 3];
            (at[axis], at[a], at[b]) = (layer, m, n);
            each(FaceCell {
                index: domain.index(at),
                axis,
                area: domain.width(a, m) * domain.width(b, n),
                centre: DVec3::from_array(std::array::from_fn(|d| domain.centre(d, at[d]))),
            });
        }
    }
}
