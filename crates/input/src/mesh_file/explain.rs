//! What is wrong with a surface, in the coordinates of the file and with the lines or numbers of its
//! triangles.

use super::problem::MeshFileProblem;
use super::surface::Surface;
use crate::quantity::plain;
use geometry::Defect;
use glam::DVec3;

const SOLID: &str = "repair the surface in the program that it comes from, and export it as one solid";
const WELD: &str =
    "merge its points over that distance in the program that it comes from (\"weld\", \"stitch\")";
const UNITE: &str = "unite the parts into one solid (a Boolean union) and export it again";

/// What is wrong with a surface that was read in this unit [m].
pub(super) fn explain(defect: &Defect, surface: &Surface, (unit, metres): (&str, f64)) -> MeshFileProblem {
    let at = |place: &DVec3| format!("{}{}", place_in_file(*place, (unit, metres)), surface.named(*place));
    let problem = |message: String, cure: &str| MeshFileProblem::new(message, cure);
    match defect {
        Defect::Empty => problem("none of its triangles has an area".to_owned(), SOLID),
        Defect::NotFinite { point } => {
            problem(format!("the coordinates of point {} are not finite", point + 1), SOLID)
        }
        Defect::NoSuchPoint { triangle } => {
            problem(format!("triangle {} refers to a point that is not there", triangle + 1), SOLID)
        }
        Defect::Open { edges, place } => {
            let message =
                format!("{edges} edges have a triangle on one side only, one of them at {}", at(place));
            problem(format!("the surface is not closed: {message}"), SOLID)
        }
        Defect::Seam { edges, width, place } => {
            let apart = format!("{:.4} {unit} apart, at {}", width / metres, at(place));
            let message = format!(
                "the surface is not closed: it has a seam of {edges} edges, whose sides are up to {apart}"
            );
            problem(message, WELD)
        }
        Defect::Sheet { triangles, place } => {
            let message = format!(
                "{triangles} triangles hang on the body as a sheet without thickness, at {}",
                at(place)
            );
            problem(message, "give it a thickness of a cell at least, or remove it")
        }
        Defect::NotManifold { edges, triangles, place } => {
            let there = format!("{triangles} of them at {}", at(place));
            problem(format!("more than two triangles meet at {edges} edges, {there}"), UNITE)
        }
        Defect::OneSided { place } => problem(
            format!("the surface has no inside: its two sides are one, as seen at {}", at(place)),
            SOLID,
        ),
        Defect::Overlap { place } => {
            problem(format!("two parts overlap: one goes through the other at {}", at(place)), UNITE)
        }
        Defect::Crossing { place } => {
            problem(format!("the surface goes through itself at {}", at(place)), UNITE)
        }
        Defect::Nested { place } => {
            let message =
                format!("a part lies inside another one at {}, and faces outwards like it", at(place));
            problem(message, "remove it, or unite the parts; a cavity faces inwards")
        }
        Defect::Scattered { shells } => {
            problem(format!("it consists of {shells} separate parts, at most 2000 are possible"), UNITE)
        }
        Defect::NoVolume => problem("the surface encloses no volume".to_owned(), SOLID),
    }
}

/// A place [m] in the coordinates of the file.
pub(super) fn place_in_file(place: DVec3, (unit, metres): (&str, f64)) -> String {
    // Without the sign of a zero.
    let [x, y, z] = (place / metres).to_array().map(|x| x + 0.0);
    format!("({}, {}, {}) {unit}", plain(x), plain(y), plain(z))
}
