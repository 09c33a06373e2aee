//! The same case on coarser meshes, for a mesh study.

use super::load::parse;
use super::overrides::overridden;
use super::resolved::Case;
use input::error::CaseError;
use input::quantity::plain;
use std::ops::RangeInclusive;
use toml_edit::DocumentMut;

/// Ratio of the cell widths of one mesh and the next finer.
pub const RATIO: f64 = 1.5;
/// Numbers of meshes of a study; more would be too coarse to be of use.
pub const COUNTS: RangeInclusive<usize> = 2..=4;
/// Least ratio of the representative widths of neighbouring meshes (chosen: with less, the difference of two
/// figures is mostly scatter). It is 1.5 unless cells were fitted to flat faces.
pub const LEAST_RATIO: f64 = 1.2;

/// A case on a coarser mesh.
#[derive(Clone, Debug)]
pub struct CoarserMesh {
    /// The case.
    pub case: Case,
    /// Text of the case as a case file.
    pub typed: String,
    /// Name of its folder: its cell size.
    pub name: String,
}

/// Representative cell width of a case [m]: the geometric mean of the smallest widths along x, y and z, in
/// plane strain along x and z.
#[must_use]
pub fn representative_width(case: &Case) -> f64 {
    let finest =
        |axis: usize| case.grid.faces[axis].windows(2).map(|f| f[1] - f[0]).fold(f64::INFINITY, f64::min);
    if case.domain.plane_strain {
        (finest(0) * finest(2)).sqrt()
    } else {
        (finest(0) * finest(1) * finest(2)).cbrt()
    }
}

/// The coarser meshes of a study on `count` meshes, the coarsest first: `grid.cell` is [`RATIO`] times as
/// large on each as on the next finer, up to that of `case`, and everything else is as it was. `text` is the
/// text of the case, overrides included; what is derived from `grid.cell` where it is not typed, the box and
/// the slab of plane strain, is written into it.
///
/// # Errors
/// [`CaseError`] where one of the meshes cannot be had, and for a case without a body, of which there is
/// nothing to compare.
pub fn coarser(
    case: &Case,
    text: &str,
    source_name: &str,
    count: usize,
) -> Result<Vec<CoarserMesh>, CaseError> {
    let refuse = |message: String, cure: &str| Err(CaseError::unreadable(source_name, message, cure));
    if !COUNTS.contains(&count) {
        let (least, most) = (COUNTS.start(), COUNTS.end());
        return refuse(
            format!("a study on {count} meshes is not possible"),
            &format!("ask for {least} to {most}"),
        );
    }
    if case.touching().next().is_none() {
        let message = "a mesh study compares the figures of bodies, and the case has none".to_owned();
        return refuse(message, "leave out --meshes");
    }
    let mut meshes: Vec<CoarserMesh> = Vec::new();
    let mut finer = representative_width(case);
    for step in 1..count {
        let mesh = on_cells(case, text, source_name, RATIO.powi(i32::try_from(step).unwrap_or(i32::MAX)))
            .map_err(|error| explained(error, case, step, count))?;
        let width = representative_width(&mesh.case);
        if width < LEAST_RATIO * finer {
            let message = format!(
                "cells of grid.cell = {} m, fitted to the flat faces of the bodies, are only {:.2} times as wide as those of \
                 the next finer mesh",
                plain(mesh.case.grid.cell),
                width / finer
            );
            return refuse(
                message,
                "write grid.fit = false, or change grid.cell so that it divides the bodies",
            );
        }
        finer = width;
        meshes.push(mesh);
    }
    meshes.reverse();
    Ok(meshes)
}

/// The case on cells that are `factor` times as wide.
pub fn on_cells(case: &Case, text: &str, source_name: &str, factor: f64) -> Result<CoarserMesh, CaseError> {
    // Nine digits: not more than a reader would type.
    let cell = 1e3 * case.grid.cell * factor;
    let cell: f64 = format!("{cell:.8e}").parse().unwrap_or(cell);
    let mut overrides = vec![format!("grid.cell=\"{cell} mm\"")];
    let typed: Option<DocumentMut> = text.parse().ok();
    let (low, high) = (case.domain.low, case.domain.high);
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let domain = typed.as_ref().and_then(|document| document.get("domain"));
        if domain.is_none_or(|section| section.get(name).is_none()) {
            overrides.push(format!("domain.{name}=[\"{} m\", \"{} m\"]", low[axis], high[axis]));
        }
    }
    let (coarser, typed) = changed(case, text, source_name, &overrides)?;
    Ok(CoarserMesh { case: coarser, typed, name: format!("{cell}mm") })
}

/// The case with overrides, and its text with them.
pub fn changed(
    case: &Case,
    text: &str,
    source_name: &str,
    overrides: &[String],
) -> Result<(Case, String), CaseError> {
    let typed = overridden(text, source_name, overrides)?;
    let mut changed = parse(&typed, source_name, &[])?;
    // Threads may have been set by hand.
    changed.numerics.threads = case.numerics.threads;
    Ok((changed, typed))
}

/// The error of a coarser mesh, which says that it is one.
fn explained(mut error: CaseError, case: &Case, step: usize, count: usize) -> CaseError {
    let factor = RATIO.powi(i32::try_from(step).unwrap_or(i32::MAX));
    let cell = plain(1e3 * factor * case.grid.cell);
    error.name = format!("{} (mesh {} of {count}, with grid.cell = {cell} mm)", error.name, count - step);
    for problem in &mut error.problems {
        let fewer = match step {
            1 => "leave out --meshes".to_owned(),
            _ => format!("ask for --meshes {step}"),
        };
        problem.message = format!("mesh {} of {count}: {}", count - step, problem.message);
        problem.cure = format!(
            "{}; this mesh has cells {} times as wide as the case's own: make those of the case smaller by that factor, or {fewer}",
            problem.cure,
            plain(factor)
        );
    }
    error
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOWED_DISC: &str = include_str!("../../../cases/light_disc.toml");
    const FOOTING: &str = include_str!("../../../cases/strip_footing.toml");
    const COLUMN: &str = include_str!("../../../cases/column_collapse.toml");

    fn study(text: &str, overrides: &[&str], count: usize) -> Result<(Case, Vec<CoarserMesh>), CaseError> {
        let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
        let text = overridden(text, "case.toml", &overrides)?;
        let case = parse(&text, "case.toml", &[])?;
        let meshes = coarser(&case, &text, "case.toml", count)?;
        Ok((case, meshes))
    }

    #[test]
    fn cells_are_wider_and_everything_else_stays() {
        let (case, meshes) = study(TOWED_DISC, &["grid.cell=10 mm"], 3).unwrap();
        assert_eq!(meshes.iter().map(|m| m.name.as_str()).collect::<Vec<_>>(), ["22.5mm", "15mm"]);
        for (mesh, cell) in meshes.iter().zip([0.0225, 0.015]) {
            assert!((mesh.case.grid.cell - cell).abs() < 1e-15);
            let same = Case { grid: case.grid.clone(), ..mesh.case.clone() };
            assert_eq!(same, case);
            assert_eq!(parse(&mesh.typed, "case.toml", &[]).unwrap(), mesh.case);
        }
    }

    #[test]
    fn what_follows_from_the_cell_is_kept() {
        // A slab of one cell, and a lid two cells above the heap.
        let text: String = FOOTING
            .lines()
            .filter(|line| !["y =", "z ="].iter().any(|key| line.starts_with(key)))
            .map(|line| format!("{line}\n"))
            .collect();
        let (case, meshes) = study(&text, &["grid.fit=false"], 3).unwrap();
        assert!(case.domain.plane_strain && case.domain.high.y == case.grid.cell);
        for mesh in &meshes {
            assert_eq!((mesh.case.domain.low, mesh.case.domain.high), (case.domain.low, case.domain.high));
            assert_eq!(mesh.case.bodies, case.bodies);
        }
        assert!((representative_width(&case) - case.grid.cell).abs() < 1e-12);
        assert!((representative_width(&meshes[1].case) / case.grid.cell - 1.5).abs() < 1e-9);
    }

    #[test]
    fn what_cannot_be_had_is_refused_with_a_cure() {
        let message = |error: CaseError| {
            let problem = &error.problems[0];
            format!("{error}: {} {}", problem.message, problem.cure)
        };
        let thin = message(study(TOWED_DISC, &["body.disc.thickness=25 mm"], 3).unwrap_err());
        for words in ["mesh 1 of 3", "28.125 mm", "too few to resolve contact", "2.25 times", "--meshes 2"] {
            assert!(thin.contains(words), "`{words}` is not in: {thin}");
        }
        let bare = message(study(COLUMN, &[], 2).unwrap_err());
        assert!(bare.contains("has none") && bare.contains("leave out --meshes"), "{bare}");
        assert!(message(study(TOWED_DISC, &[], 9).unwrap_err()).contains("ask for 2 to 4"));
    }
}
