//! A case on other cells.

use super::load::parse;
use super::overrides::overridden;
use super::resolved::Case;
use input::error::CaseError;
use input::quantity::plain;
use toml_edit::DocumentMut;

/// A case on other cells.
#[derive(Clone, Debug)]
pub struct OtherCells {
    /// The case.
    pub case: Case,
    /// Text of the case as a case file.
    pub typed: String,
    /// Name of the folder of the mesh: its cell size, to four digits.
    pub name: String,
}

/// Representative cell width of a case [m]: the geometric mean of the smallest widths along x, y and z, in
/// plane strain along x and z.
#[must_use]
pub fn representative_width(case: &Case) -> f64 {
    let [x, y, z] = finest_widths(case);
    if case.domain.plane_strain { (x * z).sqrt() } else { (x * y * z).cbrt() }
}

/// The smallest widths of cells along x, y and z [m].
#[must_use]
pub fn finest_widths(case: &Case) -> [f64; 3] {
    let finest = |faces: &Vec<f64>| faces.windows(2).map(|f| f[1] - f[0]).fold(f64::INFINITY, f64::min);
    case.grid.faces.each_ref().map(finest)
}

/// The case on cells that are `factor` times as wide.
pub fn on_cells(case: &Case, text: &str, source_name: &str, factor: f64) -> Result<OtherCells, CaseError> {
    // Nine digits: not more than a reader would type.
    let cell = 1e3 * case.grid.cell * factor;
    let cell: f64 = format!("{cell:.8e}").parse().unwrap_or(cell);
    let mut overrides = vec![format!("grid.cell=\"{cell} mm\"")];
    let typed: Option<DocumentMut> = text.parse().ok();
    let is_given = |section: &str, key: &str| {
        typed.as_ref().and_then(|document| document.get(section)?.get(key)).is_some()
    };
    // Where neither is given the cells of the case have a shape of their own.
    if !is_given("grid", "cell") && !is_given("grid", "aspect") {
        let [x, y, z] = case.grid.aspect.to_array();
        overrides.push(format!("grid.aspect=[{x}, {y}, {z}]"));
    }
    let (low, high) = (case.domain.low, case.domain.high);
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        if !is_given("domain", name) {
            overrides.push(format!("domain.{name}=[\"{} m\", \"{} m\"]", low[axis], high[axis]));
        }
    }
    let (coarser, typed) = changed(case, text, source_name, &overrides)?;
    let name = format!("{}mm", plain(format!("{cell:.3e}").parse().unwrap_or(cell)));
    Ok(OtherCells { case: coarser, typed, name })
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

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    const TOWED_DISC: &str = include_str!("../../../cases/light_disc.toml");
    const FOOTING: &str = include_str!("../../../cases/strip_footing.toml");

    #[test]
    fn cells_that_are_not_given_keep_their_shape() {
        let text =
            TOWED_DISC.replace("cell = \"12.5 mm\"", "").replace("sinkage = \"0 mm\"", "sinkage = \"40 mm\"");
        let text = text.replace("heave = {", "# heave = {");
        let case = parse(&text, "case.toml", &[]).unwrap();
        let mesh = on_cells(&case, &text, "case.toml", 1.5).unwrap();
        assert_ne!(case.grid.aspect, DVec3::ONE);
        assert_eq!(mesh.case.grid.aspect, case.grid.aspect);
        assert!((mesh.case.grid.cell - 1.5 * case.grid.cell).abs() < 1e-12);
    }

    #[test]
    fn cells_are_wider_and_everything_else_stays() {
        let text = overridden(TOWED_DISC, "case.toml", &["grid.cell=10 mm".to_owned()]).unwrap();
        let case = parse(&text, "case.toml", &[]).unwrap();
        let mesh = on_cells(&case, &text, "case.toml", 1.5).unwrap();
        assert!(mesh.name == "15mm" && (mesh.case.grid.cell - 0.015).abs() < 1e-15);
        let same = Case { grid: case.grid.clone(), ..mesh.case.clone() };
        assert_eq!(same, case);
        assert_eq!(parse(&mesh.typed, "case.toml", &[]).unwrap(), mesh.case);
    }

    #[test]
    fn what_follows_from_the_cell_is_kept() {
        // A slab of one cell, and a lid two cells above the heap.
        let text: String = FOOTING
            .lines()
            .filter(|line| !["y =", "z ="].iter().any(|key| line.starts_with(key)))
            .map(|line| format!("{line}\n"))
            .collect();
        let text = overridden(&text, "case.toml", &["grid.fit=false".to_owned()]).unwrap();
        let case = parse(&text, "case.toml", &[]).unwrap();
        assert!(case.domain.plane_strain && case.domain.high.y == case.grid.cell);
        for factor in [1.5, 2.25] {
            let mesh = on_cells(&case, &text, "case.toml", factor).unwrap().case;
            assert_eq!((mesh.domain.low, mesh.domain.high), (case.domain.low, case.domain.high));
            assert_eq!(mesh.bodies, case.bodies);
            assert!((representative_width(&mesh) / case.grid.cell - factor).abs() < 1e-9);
        }
    }
}
