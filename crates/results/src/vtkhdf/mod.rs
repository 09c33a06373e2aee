//! The fields of a run under the names of Abaqus, as VTKHDF: one file for the soil and one for each body, all
//! times in it. They are made of the field files and histories of a results folder, once asked for.

mod body;
mod soil;
mod timed;

use crate::files::{FIELDS, Inside, LISTS, OutputError, file_safe, write_whole};
use crate::folder::RunRecord;
use crate::vtk::read_time_list;
use std::path::{Path, PathBuf};
use timed::Timed;

/// Writes `fields/soil.vtkhdf` and `fields/body_NAME.vtkhdf` into a results folder; returns their paths.
///
/// Soil: an unstructured grid of hexahedra; per cell EVF, S [Pa] (XX, YY, ZZ, XY, YZ, XZ; tension positive),
/// PRESS [Pa] (compression positive), MISES [Pa], DENSITY [kg/m³], PEEQ (equivalent plastic strain), the
/// others under their own names; per node V [m/s]. Body: its surface and, last, its reference point; at each
/// U [m], UR [rad], V [m/s], VR [rad/s], and at the reference point alone, otherwise 0, RF [N] and RM [N m]:
/// force and moment of the soil on the whole body with the other sign, averaged over an interval of the
/// history.
///
/// # Errors
/// When the folder holds no result, no field files or such of another version, or a file cannot be read or
/// written.
pub fn write_vtkhdf(dir: &Path) -> Result<Vec<PathBuf>, OutputError> {
    let record = RunRecord::read(dir)?;
    let [soils, _, bodies] = LISTS.map(|name| read_time_list(&Inside::of(dir, name)));
    let (soils, bodies) = (soils?, bodies?);
    if soils.is_empty() {
        return Err(OutputError::content(&dir.join(LISTS[0]), "it lists no fields"));
    }
    let mut written = Vec::new();
    let mut write = |name: &str, timed: Timed| {
        let to = Inside::of(dir, format!("{FIELDS}/{name}.vtkhdf"));
        write_whole(&to, &timed.file(&to.path())?)?;
        written.push(to.path());
        Ok::<_, OutputError>(())
    };
    let mut soil = Timed::new("UnstructuredGrid", &[""]);
    for frame in &soils {
        soil.add(frame.time, soil::read(&Inside::of(dir, &frame.file))?);
    }
    write("soil", soil)?;
    let history = record.history(dir, record.statistics.outcome.is_end())?;
    for (number, (reference, samples)) in record.bodies.iter().zip(&history.bodies).enumerate() {
        let frames: Vec<_> = bodies.iter().filter(|frame| frame.part == number).collect();
        let Some(first) = frames.first() else { continue };
        let start = body::Placed::read(&Inside::of(dir, &first.file))?;
        let mut timed = Timed::new("PolyData", &["Vertices", "Lines", "Polygons", "Strips"]);
        for frame in frames {
            let now = body::Placed::read(&Inside::of(dir, &frame.file))?;
            let sample = body::sample_at(samples, frame.time);
            timed.add(frame.time, now.part(&start, &sample, reference.tow));
        }
        write(&format!("body_{}", file_safe(&reference.name)), timed)?;
    }
    Ok(written)
}
