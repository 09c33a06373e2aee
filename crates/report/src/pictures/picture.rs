//! The pictures of a run: slices along the body's mid-plane, the rut from above, and its cross-section.

use super::rut::{plan, profiles};
use super::scene::Scene;
use case::resolved::Case;
use results::domain::PlacedDomain;
use results::fields::HeightMap;
use results::files::{Inside, OutputError, make_folder};
use solver::grid::Grid;
use solver::precision::Precision;
use solver::state::State;

/// A picture: the name of its file in `pictures/`, and what to look for in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Caption {
    /// Name of the file.
    pub file: &'static str,
    /// Heading.
    pub title: &'static str,
    /// What to look for.
    pub text: &'static str,
}

/// The pictures in the order of the report.
pub const PICTURES: [Caption; 8] = [
    Caption {
        file: "soil_plastic_strain.png",
        title: "Where the soil has yielded",
        text: "Equivalent plastic strain in the vertical mid-plane, logarithmic colours. Look for the slip surface that \
               rises from the body's toe to the free surface ahead of it, and for the disturbed layer behind it.",
    },
    Caption {
        file: "soil_speed.png",
        title: "Velocity",
        text: "Speed of the soil. Colours end at the 99.9th percentile. The moving wedge ahead of the body should be bounded \
               and lie well inside the fine zone of the grid.",
    },
    Caption {
        file: "soil_pressure.png",
        title: "Pressure",
        text: "Mean pressure, compression positive. Colours end at the 99.9th percentile. Speckle is numerical noise; pressure that \
               extends to the walls of the box means that the box is too small.",
    },
    Caption {
        file: "soil_pore_pressure.png",
        title: "Excess pore pressure",
        text: "Pressure of the pore water beyond the hydrostatic one: red where it bears load, blue where soil that loosens sucks it in. \
               Colours end at the 99.9th percentile. It should fade well inside the box.",
    },
    Caption {
        file: "soil_fraction.png",
        title: "Where the soil is",
        text: "Eulerian volume fraction of every cell: 1 full, 0 void. A sharp free surface is one partial cell thick; soil \
               inside the body would be leakage.",
    },
    Caption {
        file: "rut_plan.png",
        title: "The surface from above",
        text: "Height of the free surface against the undisturbed one: blue is below (rut), brown above (berm); for soil \
               heaped on a floor, the height above the floor. The outline is the body.",
    },
    Caption {
        file: "profile.svg",
        title: "Profile along the tow",
        text: "Height of the free surface in the mid-plane, heights exaggerated: the bow wave ahead of the body, the rut behind it.",
    },
    Caption {
        file: "rut_section.svg",
        title: "Cross-section of the rut",
        text: "Mean height of the free surface across the tow, behind the body (one reference length behind its middle, over \
               half a length). True scale.",
    },
];

/// Draws all pictures of a state, with the map of its free surface, into the folder `dir`, each for light and
/// for dark screens.
///
/// # Errors
/// When a file cannot be written.
pub fn write_pictures(
    dir: &Inside,
    case: &Case,
    grid: &Grid,
    state: &State<impl Precision>,
    map: &HeightMap,
) -> Result<(), OutputError> {
    make_folder(dir)?;
    let domain = PlacedDomain::of(grid, state.grid_position);
    let scene = Scene::new(case, &domain, state);
    scene.fraction().write(&dir.join("soil_fraction.png"))?;
    scene.plastic_strain().write(&dir.join("soil_plastic_strain.png"))?;
    scene.pressure().write(&dir.join("soil_pressure.png"))?;
    if let Some(pore_pressure) = scene.pore_pressure() {
        pore_pressure.write(&dir.join("soil_pore_pressure.png"))?;
    }
    scene.speed().write(&dir.join("soil_speed.png"))?;
    if !case.domain.plane_strain {
        plan(&scene, map).canvas.write(&dir.join("rut_plan.png"))?;
    }
    for profile in profiles(&scene, map) {
        profile.write(dir)?;
    }
    Ok(())
}
