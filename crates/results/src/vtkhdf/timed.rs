//! A dataset over time as VTKHDF: points and cells that stay are stored once, and every time says where its
//! own numbers begin. It is always one part: readers of several want the same number at all times.

use crate::files::OutputError;
use hdf5_pure::{AttrValue, FileBuilder, GroupBuilder, H5Element};
use std::path::Path;

/// Version of VTKHDF that has all that is written here.
const VERSION: [i64; 2] = [2, 0];
/// Tuples in a compressed chunk, at most.
const CHUNK: u64 = 1 << 14;
/// Level of compression: the quickest.
const LEVEL: u32 = 1;
/// Number of a hexahedron among the cells of VTK.
const HEXAHEDRON: u8 = 12;

/// Cells: the corners of one after the other, and where each begins, the end last.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Cells {
    pub(super) corners: Vec<i64>,
    pub(super) ends: Vec<i64>,
}

impl Cells {
    /// Cells of so many corners each.
    pub(super) fn of(size: usize, corners: Vec<i64>) -> Self {
        let ends = (0..=corners.len() / size).map(|n| (n * size) as i64).collect();
        Self { corners, ends }
    }

    fn count(&self) -> usize {
        self.ends.len().saturating_sub(1)
    }
}

/// A quantity: section, name, components, numbers.
pub(super) struct Quantity {
    pub(super) section: &'static str,
    pub(super) name: String,
    pub(super) components: usize,
    pub(super) numbers: Vec<f32>,
}

/// A dataset at one time.
pub(super) struct Part {
    /// Coordinates of its points [m].
    pub(super) points: Vec<f64>,
    /// Its cells, by kind.
    pub(super) cells: Vec<Cells>,
    pub(super) quantities: Vec<Quantity>,
}

impl Part {
    /// This and another one with the same quantities, its points and cells after the own ones.
    pub(super) fn joined(mut self, other: Self) -> Self {
        let points = (self.points.len() / 3) as i64;
        self.points.extend(other.points);
        for (own, cells) in self.cells.iter_mut().zip(other.cells) {
            let corners = own.corners.len() as i64;
            own.corners.extend(cells.corners.iter().map(|corner| corner + points));
            own.ends.extend(cells.ends.iter().skip(1).map(|end| end + corners));
        }
        for (own, quantity) in self.quantities.iter_mut().zip(other.quantities) {
            own.numbers.extend(quantity.numbers);
        }
        self
    }
}

/// Where the numbers of a time begin.
#[derive(Clone, Default)]
struct Step {
    time: f64,
    part: usize,
    points: usize,
    /// Cells and their corners, by kind.
    cells: Vec<[usize; 2]>,
}

/// A quantity over time.
struct Array {
    kept: Quantity,
    begins: Vec<i64>,
}

/// A dataset over time.
pub(super) struct Timed {
    kind: &'static str,
    /// Groups of the kinds of cells.
    groups: &'static [&'static str],
    steps: Vec<Step>,
    points: Vec<f64>,
    point_counts: Vec<i64>,
    /// Cells, by kind; anew each time that they or the number of points change.
    cells: Vec<Vec<Cells>>,
    arrays: Vec<Array>,
}

impl Timed {
    /// Nothing yet, of a kind of VTK whose cells lie in these groups.
    pub(super) fn new(kind: &'static str, groups: &'static [&'static str]) -> Self {
        let cells = groups.iter().map(|_| Vec::new()).collect();
        let (steps, points, point_counts, arrays) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Self { kind, groups, steps, points, point_counts, cells, arrays }
    }

    /// Adds the part at a time [s].
    pub(super) fn add(&mut self, time: f64, part: Part) {
        let last = self.steps.last().cloned().unwrap_or_default();
        let mut step = Step { time, ..last };
        let point_count = (part.points.len() / 3) as i64;
        let cells_stay = self.point_counts.last() == Some(&point_count)
            && self.cells.iter().zip(&part.cells).all(|(known, cells)| known.last() == Some(cells));
        if !(cells_stay && self.points[3 * step.points..] == part.points) {
            step.points = self.points.len() / 3;
            self.points.extend(part.points);
        }
        if !cells_stay {
            step.part = self.point_counts.len();
            self.point_counts.push(point_count);
            let sum = |known: &Vec<Cells>| {
                [Cells::count, |cells: &Cells| cells.corners.len()].map(|n| known.iter().map(n).sum())
            };
            step.cells = self.cells.iter().map(sum).collect();
            for (known, cells) in self.cells.iter_mut().zip(part.cells) {
                known.push(cells);
            }
        }
        self.steps.push(step);
        for quantity in part.quantities {
            self.add_quantity(quantity);
        }
    }

    fn add_quantity(&mut self, quantity: Quantity) {
        let same =
            |array: &&mut Array| (array.kept.section, &array.kept.name) == (quantity.section, &quantity.name);
        let Some(array) = self.arrays.iter_mut().find(same) else {
            return self.arrays.push(Array { kept: quantity, begins: vec![0] });
        };
        array.begins.push((array.kept.numbers.len() / array.kept.components) as i64);
        array.kept.numbers.extend(quantity.numbers);
    }

    /// The content of the file of this path.
    pub(super) fn file(self, path: &Path) -> Result<Vec<u8>, OutputError> {
        let mut file = FileBuilder::new();
        let mut top = file.create_group("VTKHDF");
        top.set_attr("Version", AttrValue::I64Array(VERSION.to_vec()));
        top.set_attr("Type", AttrValue::AsciiString(self.kind.to_owned()));
        put(&mut top, "NumberOfPoints", 1, &self.point_counts);
        put(&mut top, "Points", 3, &self.points);
        for (name, parts) in self.groups.iter().zip(&self.cells) {
            if name.is_empty() {
                let count = parts.iter().map(Cells::count).sum();
                put(&mut top, "Types", 1, &vec![HEXAHEDRON; count]);
                put_cells(&mut top, parts);
            } else {
                let mut group = top.create_group(name);
                put_cells(&mut group, parts);
                top.add_group(group.finish());
            }
        }
        self.put_steps(&mut top);
        // Each array is let go of once it is in the file.
        let (points, cells): (Vec<_>, Vec<_>) =
            self.arrays.into_iter().map(|array| array.kept).partition(|kept| kept.section == "PointData");
        for (section, quantities) in [("PointData", points), ("CellData", cells)] {
            let mut group = top.create_group(section);
            for kept in quantities {
                put(&mut group, &kept.name, kept.components, &kept.numbers);
            }
            top.add_group(group.finish());
        }
        file.add_group(top.finish());
        file.finish().map_err(|error| OutputError::content(path, error))
    }

    fn put_steps(&self, top: &mut GroupBuilder) {
        let mut steps = top.create_group("Steps");
        steps.set_attr("NSteps", AttrValue::I64(self.steps.len() as i64));
        let times: Vec<f64> = self.steps.iter().map(|step| step.time).collect();
        put(&mut steps, "Values", 1, &times);
        let of = |number: fn(&Step) -> usize| -> Vec<i64> {
            self.steps.iter().map(|step| number(step) as i64).collect()
        };
        put(&mut steps, "PartOffsets", 1, &of(|step| step.part));
        put(&mut steps, "NumberOfParts", 1, &of(|_| 1));
        put(&mut steps, "PointOffsets", 1, &of(|step| step.points));
        for (n, name) in ["CellOffsets", "ConnectivityIdOffsets"].into_iter().enumerate() {
            let begins = self.steps.iter().flat_map(|step| step.cells.iter().map(move |all| all[n] as i64));
            put_table(&mut steps, name, self.groups.len(), &begins.collect::<Vec<_>>());
        }
        for section in ["PointData", "CellData"] {
            let mut group = steps.create_group(&format!("{section}Offsets"));
            for Array { kept, begins } in self.arrays.iter().filter(|array| array.kept.section == section) {
                put(&mut group, &kept.name, 1, begins);
            }
            steps.add_group(group.finish());
        }
        top.add_group(steps.finish());
    }
}

fn put_cells(group: &mut GroupBuilder, parts: &[Cells]) {
    let of = |number: fn(&Cells) -> usize| -> Vec<i64> { parts.iter().map(|p| number(p) as i64).collect() };
    let all =
        |numbers: fn(&Cells) -> &Vec<i64>| -> Vec<i64> { parts.iter().flat_map(numbers).copied().collect() };
    put(group, "NumberOfCells", 1, &of(Cells::count));
    put(group, "NumberOfConnectivityIds", 1, &of(|cells| cells.corners.len()));
    put(group, "Offsets", 1, &all(|cells| &cells.ends));
    put(group, "Connectivity", 1, &all(|cells| &cells.corners));
}

/// Tuples of numbers; a single component has one dimension.
fn put<T: H5Element>(group: &mut GroupBuilder, name: &str, components: usize, numbers: &[T]) {
    if components > 1 {
        return put_table(group, name, components, numbers);
    }
    let count = numbers.len() as u64;
    let dataset = group.create_dataset(name).with_data(numbers).with_shape(&[count]);
    if count > 0 {
        dataset.with_chunks(&[count.min(CHUNK)]).with_deflate(LEVEL);
    }
}

/// Tuples of numbers, in two dimensions.
fn put_table<T: H5Element>(group: &mut GroupBuilder, name: &str, components: usize, numbers: &[T]) {
    let shape = [(numbers.len() / components) as u64, components as u64];
    let dataset = group.create_dataset(name).with_data(numbers).with_shape(&shape);
    dataset.with_chunks(&[shape[0].clamp(1, CHUNK), shape[1]]).with_deflate(LEVEL);
}
