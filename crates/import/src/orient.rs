//! Which frame the case has: symmetry, plane strain and tow decide.

use crate::bodies::Body;
use crate::eulerian::Eulerian;
use crate::frame::Frame;
use crate::moves::{Dof, StepMoves};
use crate::walls::Held;

/// The frame, and what the box is.
pub(super) struct Setup {
    pub(super) frame: Frame,
    pub(super) is_plane_strain: bool,
    /// Whether y = 0 and x = 0 are planes of symmetry.
    pub(super) symmetric: [bool; 2],
}

/// Whether a face is a plane of symmetry: smooth, and a body lies in it or across it.
fn is_symmetric(mesh: &Eulerian, held: &Held, bodies: &[Body], axis: usize, side: usize) -> bool {
    let planes = &mesh.faces[axis];
    let plane = if side == 0 { planes[0] } else { planes[planes.len() - 1] };
    let near = 1e-3 * (planes[1] - planes[0]);
    let is_cut = |body: &Body| {
        let [low, high] = body.hull.bounds()[axis];
        (body.position[axis] - plane).abs() <= near && low <= plane + near && high >= plane - near
    };
    let [first, second] = [(axis + 1) % 3, (axis + 2) % 3];
    let own = held[axis][side];
    // Across a single cell every node of a face lies on an edge, and is held with the sides of the slab.
    let is_smooth = |other: usize| !own[other] || is_thin(mesh, held, other);
    own[axis] && is_smooth(first) && is_smooth(second) && !bodies.is_empty() && bodies.iter().all(is_cut)
}

/// Whether the mesh is one cell wide along an axis, between two smooth walls.
fn is_thin(mesh: &Eulerian, held: &Held, axis: usize) -> bool {
    mesh.faces[axis].len() == 2 && held[axis].iter().all(|side| side[axis])
}

/// How far a body is prescribed to go along an axis of the deck, in any unit: for comparison.
fn tow(moves: &[StepMoves], axis: usize) -> f64 {
    let size = |dof: &Dof| match dof {
        Dof::Velocity(value, _) | Dof::Displacement(value, _) => value.abs(),
        _ => 0.0,
    };
    moves.iter().flatten().map(|body| size(&body[axis].dof)).fold(0.0, f64::max)
}

/// The best of the four upright frames, its origin in the planes of symmetry.
pub(super) fn setup(
    mesh: &Eulerian,
    held: &Held,
    bodies: &[Body],
    moves: &[StepMoves],
    up: (usize, bool),
) -> Setup {
    let mut best: Option<(f64, Setup)> = None;
    let most = (0..3).filter(|axis| *axis != up.0).map(|axis| tow(moves, axis)).fold(0.0, f64::max);
    for (turns, frame) in Frame::upright(up).into_iter().enumerate() {
        let (along, across) = (frame.axes[0], frame.axes[1]);
        let low = |axis: (usize, bool)| usize::from(!axis.1);
        let plane_strain = |axis: (usize, bool)| is_thin(mesh, held, axis.0);
        let symmetric = [across, along]
            .map(|axis| !plane_strain(axis) && is_symmetric(mesh, held, bodies, axis.0, low(axis)));
        let is_plane_strain = plane_strain(across);
        let lost = [across, along]
            .into_iter()
            .filter(|axis| !plane_strain(*axis) && is_symmetric(mesh, held, bodies, axis.0, 1 - low(*axis)));
        let towed = if most > 0.0 { tow(moves, along.0) / most } else { 0.0 };
        let mut score =
            100.0 * f64::from(u8::from(is_plane_strain)) - 200.0 * f64::from(u8::from(plane_strain(along)));
        score += 10.0 * towed - turns as f64 - 50.0 * lost.count() as f64;
        score += if symmetric[0] { 20.0 } else { 0.0 } + if symmetric[1] { 15.0 } else { 0.0 };
        let setup = Setup { frame, is_plane_strain, symmetric };
        if best.as_ref().is_none_or(|(most, _)| score > *most) {
            best = Some((score, setup));
        }
    }
    let mut setup = best.map_or_else(
        || Setup { frame: Frame::upright(up)[0], is_plane_strain: false, symmetric: [false; 2] },
        |(_, setup)| setup,
    );
    for (n, number) in [1, 0].into_iter().enumerate() {
        if setup.symmetric[n] {
            let (axis, same) = setup.frame.axes[number];
            let planes = &mesh.faces[axis];
            setup.frame.origin[number] = if same { planes[0] } else { -planes[planes.len() - 1] };
        }
    }
    setup
}
