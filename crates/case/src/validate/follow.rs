//! Whether the grid can follow a body: the ground must look the same from wherever it travels.

use crate::resolved::{Case, Follow, Ground, Motion, Wall};
use input::problem::Problems;

const AXES: [&str; 3] = ["x", "y", "z"];

/// Reports what keeps the grid from following a body.
pub(super) fn follow(case: &Case, problems: &mut Problems) {
    let Some(follow) = case.grid.follow else { return };
    if follow.body >= case.bodies.len() || follow.axes == [false; 3] {
        let message = "the grid follows a body that is not there, or along no axis";
        problems.add("grid.follow", message, "name one of the bodies, and one of the axes at least");
        return;
    }
    for axis in (0..3).filter(|axis| follow.axes[*axis]) {
        stands_still(case, follow, axis, problems);
        ends(case, axis, problems);
        ground(case, axis, problems);
    }
}

/// A grid that follows a body which does not move would only have open ends.
fn stands_still(case: &Case, follow: Follow, axis: usize, problems: &mut Problems) {
    let body = &case.bodies[follow.body];
    if body.guided().translation[axis] == Motion::Fixed {
        let message =
            format!("`{}` does not move along {}: there is nothing to follow", body.name, AXES[axis]);
        problems.add("grid.follow.axes", message, "leave this axis out");
    }
}

/// Soil enters and leaves at both ends: there can be no plane of symmetry, and no rough wall.
fn ends(case: &Case, axis: usize, problems: &mut Problems) {
    let domain = &case.domain;
    let plane = match axis {
        0 if domain.symmetric_x => Some("symmetric_x"),
        1 if domain.symmetric => Some("symmetric"),
        1 if domain.plane_strain => Some("plane_strain"),
        _ => None,
    };
    if let Some(plane) = plane {
        let message = format!("the grid cannot follow along {}: {plane} = true holds it", AXES[axis]);
        problems.add("grid.follow.axes", message, format!("leave this axis out, or remove {plane}"));
    }
    if axis < 2 && domain.walls[axis].contains(&Wall::Fixed) {
        let message = format!("there are no walls along {} in a grid that follows a body", AXES[axis]);
        problems.add(format!("domain.{}_walls", AXES[axis]), message, "remove it");
    }
}

fn ground(case: &Case, axis: usize, problems: &mut Problems) {
    let name = AXES[axis];
    if axis < 2 && matches!(case.ground, Ground::Column { .. }) {
        let message =
            format!("the ground is not the same everywhere along {name}, where the grid follows a body");
        problems.add("grid.follow", message, "remove grid.follow, or make the ground level");
    }
    if axis == 2 && case.top_of_ground() >= case.domain.high.z {
        let message = "the soil reaches up to the lid, which cannot follow a body";
        problems.add("grid.follow.axes", message, "leave z out, or raise the box above the soil");
    }
    if case.velocity[axis] != 0.0 {
        let message = format!("the soil moves along {name}, where the grid follows a body");
        problems.add("ground.velocity", message, "let the body move instead");
    }
}

#[cfg(test)]
mod tests {
    use crate::parse;
    use input::CaseError;

    fn refusal(overrides: &[&str]) -> Result<(), CaseError> {
        let text = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\nyoung_modulus = '5 MPa'\n\
                    [grid]\ncell = '12.5 mm'\nfollow = { body = 'disc', axes = 'x' }\n[body.disc]\nshape = 'disc'\ndiameter = '0.2 m'\n\
                    thickness = '50 mm'\nfriction = 0.3\nsinkage = '20 mm'\nforward = { speed = '0.2 m/s' }\n[run]\ntow_distance = '10 m'\n";
        let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
        parse(text, "tow.toml", &overrides).map(|_| ())
    }

    /// The paths and messages of what is wrong.
    fn problems(overrides: &[&str]) -> String {
        let located = refusal(overrides).unwrap_err().problems;
        located.into_iter().map(|p| format!("{} {}\n", p.path, p.message)).collect()
    }

    #[test]
    fn a_tow_of_any_length_fits_into_a_grid_that_follows() {
        refusal(&[]).unwrap();
        assert!(problems(&["grid.follow={ body='disc', axes='y' }"]).contains("does not move along y"));
    }

    #[test]
    fn what_keeps_the_grid_from_following_is_named() {
        for (overrides, expected) in [
            (&["grid.follow={ body='disk' }"][..], "grid.follow.body there is no body \"disk\""),
            (&["grid.follow='disc'"], "grid.follow grid.follow: expected a table"),
            (&["grid.follow={ axes='x' }"], "grid.follow grid.follow: `body` is missing"),
            (&["grid.follow={ body='disc', axis='x' }"], "grid.follow.axis"),
            (&["grid.follow={ body='disc', axes='q' }"], "grid.follow.axes"),
            (&["domain.x_walls=['fixed', 'smooth']"], "domain.x_walls there are no walls along x"),
            (&["ground.velocity=['0.1 m/s', '0 m/s', '0 m/s']"], "ground.velocity the soil moves along x"),
            (
                &["ground.x=['-0.2 m', '0.2 m']", "domain.x=['-0.5 m', '0.5 m']"],
                "the ground is not the same everywhere along x",
            ),
            (
                &[
                    "domain.symmetric=true",
                    "body.disc.lateral={ speed='0.1 m/s' }",
                    "grid.follow={ body='disc', axes='xy' }",
                ],
                "symmetric = true holds it",
            ),
        ] {
            let found = problems(overrides);
            assert!(found.contains(expected), "{overrides:?}: {found}");
        }
    }
}
