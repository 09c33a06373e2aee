//! The check at the end of a step: whether the state can still be trusted.

use crate::cpu::stage_sums::RowSums;
use crate::error::{Breakdown, Location};
use crate::halo::Halo;
use crate::kernels::Kernels;
use crate::model::Model;
use crate::state::State;
use glam::DVec3;

/// Fields must be finite, no displacement may approach a cell before it is remapped, and bodies must stay in
/// the box.
///
/// # Errors
/// [`Breakdown`] for the first condition that is violated.
pub(crate) fn check<R: Kernels>(
    model: &Model,
    state: &State<R>,
    sums: &RowSums,
    halo: &Halo,
) -> Result<(), Breakdown> {
    let (time, step, dt) = (state.time, state.step, model.time_step());
    for (n, (fixed, body)) in model.bodies.iter().zip(&state.bodies).enumerate() {
        let (pose, twist) = (state.pose(n), state.twist(n));
        let is_finite = pose.position.is_finite() && pose.rotation.is_finite();
        if !(is_finite && twist.linear.is_finite() && twist.angular.is_finite()) {
            let field = format!("the motion of the body `{}`", fixed.name);
            let location = Location::at(body.searched_at.position);
            return Err(Breakdown::NotANumber { field, time, step, location });
        }
    }
    if !(sums.kinetic.is_finite() && sums.plastic.is_finite()) {
        let location = offending_node(model, state, halo, |v| !v.is_finite());
        return Err(Breakdown::NotANumber { field: "the velocity of the soil".into(), time, step, location });
    }
    let cells = sums.displacement.max(sums.displacement_light) / model.grid.finest();
    if cells > 0.9 {
        let location = offending_node(model, state, halo, |v| v.abs() * dt > 0.3 * model.grid.finest());
        return Err(Breakdown::Runaway { cells, time, step, location });
    }
    stays_inside(model, state)
}

/// No body may leave the box along an axis of free motion, or where another program leads it.
fn stays_inside<R>(model: &Model, state: &State<R>) -> Result<(), Breakdown> {
    const SIDES: [[&str; 2]; 3] =
        [["behind", "ahead"], ["at its low y side", "at its high y side"], ["below", "above"]];
    let touching = model.bodies.iter().enumerate().filter(|(_, body)| body.shape.has_surface());
    for (n, fixed) in touching {
        let (position, (low, high)) = (state.pose(n).position, fixed.bounds(state.pose(n)));
        let is_led = state.mechanism.bodies[n].is_elsewhere();
        let may_leave = |axis: &usize| {
            let motion = &fixed.motion[*axis];
            motion.is_free() || is_led && !motion.is_fixed()
        };
        for axis in (0..3).filter(may_leave) {
            let ends = model.grid.ends(axis).map(|end| end + state.grid_position[axis]);
            let at = [low[axis], high[axis]];
            // Most bodies reach above the lid from the start: upwards, only a body wholly above it has left
            // the box.
            let has_left = [at[0] < ends[0], if axis == 2 { at[0] > ends[1] } else { at[1] > ends[1] }];
            if let Some(end) = has_left.iter().position(|left| *left) {
                let (time, step, location) = (state.time, state.step, Location::at(position));
                let (body, side) = (fixed.name.clone(), SIDES[axis][end]);
                return Err(Breakdown::LeftTheBox { body, side, time, step, location });
            }
        }
    }
    Ok(())
}

/// Offending node of all blocks: of those with a velocity component that `is_bad`, or of all where there is
/// none, the one that has moved farthest since the last remap.
fn offending_node<R: Kernels>(
    model: &Model,
    state: &State<R>,
    halo: &Halo,
    is_bad: impl Fn(f64) -> bool,
) -> Location {
    let bad = |n: &usize| state.nodes.velocity.iter().any(|v| is_bad(v[*n].to_f64()));
    let moved = |n: usize| state.nodes.displacement.iter().map(|u| u[n].to_f64().abs()).fold(0.0, f64::max);
    let [_, row, plane] = model.grid.stride;
    // Ghosts have no position.
    let nodes = || (plane..model.grid.entries).filter(|n| n % row > 0 && n % plane >= row);
    let farther = |a: usize, b: usize| if moved(b) > moved(a) { b } else { a };
    let own = nodes().filter(bad).reduce(farther).or_else(|| nodes().reduce(farther));
    let found = own.map_or([-1.0; 5], |n| {
        let layers = model.grid.layers_of(n);
        let [x, y, z] = std::array::from_fn(|axis| {
            model.grid.faces[axis].get(layers[axis]).copied().unwrap_or(f64::NAN) + state.grid_position[axis]
        });
        [f64::from(u8::from(bad(&n))), moved(n), x, y, z]
    });
    let all = halo.gather(found.to_vec());
    let worse = |a: &[f64], b: &[f64]| (a[0], a[1]) < (b[0], b[1]);
    let worst = all.chunks_exact(5).reduce(|a, b| if worse(a, b) { b } else { a });
    Location::at(worst.map_or(DVec3::NAN, |found| DVec3::from_slice(&found[2..])))
}
