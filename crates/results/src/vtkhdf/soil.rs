//! The soil at a time: its field file, or those of the blocks that make it up.

use super::timed::{Cells, Part, Quantity};
use crate::files::{Inside, OutputError, read_text};
use crate::vtk::VtkFile;

/// Names of field files and, where they differ, of Abaqus.
const NAMES: [(&str, &str); 7] = [
    ("evf", "EVF"),
    ("stress", "S"),
    ("pressure", "PRESS"),
    ("mises", "MISES"),
    ("density", "DENSITY"),
    ("plastic_strain", "PEEQ"),
    ("velocity", "V"),
];

/// What is in a `.vtr`, or in the files that a `.pvtr` joins.
pub(super) fn read(file: &Inside) -> Result<Part, OutputError> {
    if file.path().extension().is_some_and(|ending| ending == "vtr") {
        return part(file);
    }
    let text = read_text(file)?;
    let sources = text.split("Source=\"").skip(1).filter_map(|rest| rest.split('"').next());
    let blocks = sources.map(|source| part(&file.beside(source))).collect::<Result<Vec<_>, _>>()?;
    let whole = blocks.into_iter().reduce(Part::joined);
    whole.ok_or_else(|| OutputError::content(&file.path(), "it joins no files"))
}

fn part(from: &Inside) -> Result<Part, OutputError> {
    let file = VtkFile::read(from)?;
    let [x, y, z] = ["x", "y", "z"].map(|axis| file.numbers_in("Coordinates", axis));
    let (x, y, z) = (x?, y?, z?);
    let points = z.iter().flat_map(|z| y.iter().flat_map(|y| x.iter().flat_map(|x| [*x, *y, *z])));
    let (nodes, between) = ([x.len(), y.len(), z.len()], |n: usize| n.saturating_sub(1));
    let counts = [nodes, nodes.map(between)].map(|[i, j, k]| i.saturating_mul(j).saturating_mul(k));
    let mut quantities = Vec::new();
    // What lies on nodes in Abaqus is not given for the cells again.
    for (section, count) in ["PointData", "CellData"].into_iter().zip(counts) {
        let is_wanted = |name: &str| section == "PointData" || name != "velocity";
        for (name, components) in file.arrays(section).filter(|(name, _)| is_wanted(name)) {
            let numbers: Vec<f32> =
                file.numbers_in(section, name)?.into_iter().map(|number| number as f32).collect();
            if components == 0 || numbers.len() != count.saturating_mul(components) {
                return Err(OutputError::content(&from.path(), format!("`{name}` does not fit its grid")));
            }
            let name = NAMES.iter().find(|(own, _)| *own == name).map_or(name, |(_, other)| other).to_owned();
            quantities.push(Quantity { section, name, components, numbers });
        }
    }
    let cells = vec![Cells::of(8, hexahedra(nodes))];
    Ok(Part { points: points.collect(), cells, quantities })
}

/// The corners of the cells between so many planes along x, y, z.
fn hexahedra([x, y, z]: [usize; 3]) -> Vec<i64> {
    let (row, layer) = (x, x * y);
    let ends = |n: usize| 0..n.saturating_sub(1);
    let firsts =
        ends(z).flat_map(|k| ends(y).flat_map(move |j| ends(x).map(move |i| i + row * j + layer * k)));
    let face = [0, 1, 1 + row, row];
    firsts
        .flat_map(|n| face.map(|m| n + m).into_iter().chain(face.map(|m| n + m + layer)))
        .map(|n| n as i64)
        .collect()
}
