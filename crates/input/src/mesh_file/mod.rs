//! Files with the surface of a body: STL (binary and text), OBJ, PLY (text and binary). A file is read line
//! by line or triangle by triangle, so that a large or broken one is refused before it takes up memory, and
//! every refusal says where in the file it is.

mod explain;
mod limits;
mod lines;
mod obj;
mod ply;
mod polygon;
mod problem;
mod report;
mod stl;
mod surface;
mod unit;

pub use limits::MOST_TRIANGLES;
pub use problem::MeshFileProblem;
pub use report::MeshReport;

use geometry::{Mesh, Polyhedron, Repaired, repaired};
use glam::DVec3;
use limits::TOO_MANY;
use problem::refuse;
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;
use surface::Surface;
use xxhash_rust::xxh3::Xxh3;

/// Largest file [bytes]: as much as so many triangles take up as text.
const MOST_BYTES: u64 = 640 << 20;
/// Smallest and largest side of a body's box that are believed [m].
const SIZES: [f64; 2] = [1e-3, 100.0];

/// What a file holds.
#[derive(Clone, Debug)]
pub struct MeshFile {
    /// The solid [m].
    pub solid: Polyhedron,
    /// Unit of the coordinates in the file [m].
    pub unit: f64,
    /// Properties of the surface, and what was repaired.
    pub report: MeshReport,
    /// Hash of the content of the file.
    pub hash: String,
}

/// Reads a file whose unit of length has this name and is so many metres, or the one that the file states.
///
/// # Errors
/// [`MeshFileProblem`] says what is wrong with it, where, and what to do.
pub fn read(path: &Path, unit: Option<(&str, f64)>) -> Result<MeshFile, MeshFileProblem> {
    let format = Format::of(path)?;
    let bytes = size_of(path)?;
    let mut surface = format.read(path, bytes)?;
    if surface.mesh.triangles.is_empty() {
        return refuse("it holds no triangles", "export a solid body; the file may be of another kind");
    }
    if let Some(n) = surface.mesh.points.iter().position(|x| !x.is_finite()) {
        let message = format!("the coordinates of point {} are not finite numbers", n + 1);
        return refuse(message, "export the body again");
    }
    let (unit, metres) = unit::of_file(unit, surface.unit.as_ref())?;
    surface.mesh.points.iter_mut().for_each(|x| *x *= metres);
    require_plausible_size(&surface.mesh, &unit)?;
    let found =
        repaired(&surface.mesh).map_err(|defect| explain::explain(&defect, &surface, (&unit, metres)))?;
    let report = MeshReport::of(&found, &surface, (&unit, metres));
    let Repaired { solid, .. } = found;
    let hash = hash_of(path).map_err(|error| unreadable(&error))?;
    Ok(MeshFile { solid, unit: metres, report, hash })
}

/// A place [m] in coordinates whose unit is so many metres, in words.
pub fn place_in_file(place: DVec3, metres: f64) -> String {
    explain::place_in_file(place, (unit::name_of(metres), metres))
}

/// Hash of the content of a file.
///
/// # Errors
/// What the operating system says.
pub fn hash_of(path: &Path) -> std::io::Result<String> {
    let mut file = File::open(path)?;
    let mut hasher = Xxh3::new();
    let mut block = vec![0; 1 << 16];
    loop {
        match file.read(&mut block)? {
            0 => return Ok(format!("{:032x}", hasher.digest128())),
            count => hasher.update(&block[..count]),
        }
    }
}

/// A format, by the extension of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Stl,
    Obj,
    Ply,
}

impl Format {
    fn of(path: &Path) -> Result<Self, MeshFileProblem> {
        let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
        match extension.as_str() {
            "stl" => Ok(Self::Stl),
            "obj" => Ok(Self::Obj),
            "ply" => Ok(Self::Ply),
            _ => {
                let message =
                    format!("its extension is `{extension}`, which is not that of a format that can be read");
                refuse(message, "export the body as STL, OBJ or PLY, with the extension .stl, .obj or .ply")
            }
        }
    }

    fn read(self, path: &Path, bytes: u64) -> Result<Surface, MeshFileProblem> {
        let open = || File::open(path).map_err(|error| unreadable(&error));
        let mut start = [0; 512];
        let mut length = 0;
        let mut head = open()?.take(start.len() as u64);
        while let Some(count) =
            Some(head.read(&mut start[length..]).map_err(|e| unreadable(&e))?).filter(|n| *n > 0)
        {
            length += count;
        }
        let start = &start[..length];
        let is_ply = start.starts_with(b"ply\n") || start.starts_with(b"ply\r\n");
        if is_ply != (self == Self::Ply) {
            let [found, other] = if is_ply { ["is", "another one"] } else { ["is not", "PLY"] };
            let message = format!("it {found} a PLY file, but its extension is that of {other}");
            return refuse(message, "give the file the extension of its format");
        }
        let file = BufReader::with_capacity(1 << 16, open()?);
        match self {
            Self::Stl => stl::read(file, start, bytes),
            Self::Obj => obj::read(file),
            Self::Ply => ply::read(file),
        }
    }
}

/// Size of an ordinary file that is not too large [bytes]. A pipe or a device could be endless.
fn size_of(path: &Path) -> Result<u64, MeshFileProblem> {
    let about = std::fs::metadata(path).map_err(|error| unreadable(&error))?;
    if !about.is_file() {
        let what = if about.is_dir() { "a folder" } else { "a pipe or a device" };
        return refuse(format!("it is {what}, not a file"), "name an STL, OBJ or PLY file");
    }
    match about.len() {
        0 => refuse("it is empty", "export the body again"),
        bytes if bytes > MOST_BYTES => {
            let message =
                format!("it is too large: {} MB, at most {} MB are read", bytes >> 20, MOST_BYTES >> 20);
            refuse(message, TOO_MANY)
        }
        bytes => Ok(bytes),
    }
}

fn unreadable(error: &std::io::Error) -> MeshFileProblem {
    let cure = match error.kind() {
        std::io::ErrorKind::NotFound => "check the path: it is relative to the folder of the case file",
        _ => "check that the file can be read",
    };
    MeshFileProblem::new(format!("it cannot be read: {error}"), cure)
}

fn require_plausible_size(surface: &Mesh, unit: &str) -> Result<(), MeshFileProblem> {
    let used = || surface.triangles.iter().flatten().filter_map(|n| surface.points.get(*n as usize));
    let low = used().fold(DVec3::INFINITY, |a, b| a.min(*b));
    let high = used().fold(DVec3::NEG_INFINITY, |a, b| a.max(*b));
    let largest = (high - low).max_element();
    if (SIZES[0]..=SIZES[1]).contains(&largest) {
        return Ok(());
    }
    let message =
        format!("with unit = \"{unit}\" the body is {largest:.3e} m large: the unit is probably wrong");
    refuse(
        message,
        "give the unit in which the file was written: m, cm, mm, in or ft; a body is 1 mm to 100 m large",
    )
}
