//! A body from the file of its surface.

use super::keys::{KEYS, field};
use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Conflict, Size};
use crate::key::missing;
use geometry::{self, Thin, ThinSearch};
use glam::DVec3;
use input::key::{KeyOf, Place};
use input::mesh_file::{self, MeshFile, MeshFileProblem, MeshReport};
use input::problem::Problems;
use input::quantity::{self, LENGTH};
use input::typed::Section;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// A solid whose surface is in a file. Copies share what was read of it.
#[derive(Clone, Debug, Serialize)]
pub struct MeshBody {
    /// The file, as typed.
    pub file: String,
    /// Unit of the coordinates in the file [m].
    pub unit: f64,
    /// Hash of the content of the file.
    pub hash: String,
    #[serde(skip)]
    content: Arc<Content>,
}

#[derive(Debug)]
struct Content {
    /// Where the file is.
    path: PathBuf,
    solid: geometry::Polyhedron,
    report: MeshReport,
    /// Whether the surface is its own mirror image in the planes across the axes, once that was asked.
    mirrored: [OnceLock<bool>; 3],
}

impl PartialEq for MeshBody {
    /// The hash stands for the content.
    fn eq(&self, other: &Self) -> bool {
        (&self.file, self.unit, &self.hash) == (&other.file, other.unit, &other.hash)
    }
}

impl MeshBody {
    pub(super) const FIELDS: &[KeyOf<Self>] =
        &[field("file", Place::Elsewhere), field("unit", Place::Elsewhere)];

    /// The solid in a file in a folder, whose unit of length is written like that of a length: `mm`. Without
    /// one it is that which the file states.
    ///
    /// # Errors
    /// [`MeshFileProblem`] says what is wrong with the file, where, and what to do.
    pub fn load<'a>(
        folder: &Path,
        file: &str,
        unit: impl Into<Option<&'a str>>,
    ) -> Result<Self, MeshFileProblem> {
        let metres = |unit: &'a str| match quantity::parse(&format!("1 {unit}"), &LENGTH) {
            Ok(metres) => Ok((unit, metres)),
            Err(error) => Err(MeshFileProblem {
                message: error.to_string(),
                cure: "write a unit of length, such as \"mm\"".to_owned(),
            }),
        };
        let given = unit.into().map(metres).transpose()?;
        let path = folder.join(file);
        let MeshFile { solid, unit, report, hash } = mesh_file::read(&path, given)?;
        let content = Arc::new(Content { path, solid, report, mirrored: Default::default() });
        Ok(Self { file: file.to_owned(), unit, hash, content })
    }

    pub(super) fn read(section: &Section, _slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
        missing(KEYS, section, "file", problems);
        let file = section.text("file")?;
        let unit = if section.has("unit") { Some(section.text("unit")?) } else { None };
        Self::load(&section.folder, &file, unit.as_deref())
            .map_err(|MeshFileProblem { message, cure }| {
                problems.add(section.at("file"), format!("{file}: {message}"), cure);
            })
            .ok()
    }

    /// A place of the surface [m] in the coordinates of the file, in words.
    pub(crate) fn place_in_file(&self, place: DVec3) -> String {
        mesh_file::place_in_file(place, self.unit)
    }

    /// Where the file is that was read.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.content.path
    }

    /// What the surface is like, and what was repaired.
    #[must_use]
    pub fn report(&self) -> &MeshReport {
        &self.content.report
    }
}

impl CaseShape for MeshBody {
    fn solid(&self) -> Box<dyn geometry::Shape> {
        Box::new(self.content.solid.clone())
    }

    /// The edges of the bounding box of the mesh.
    fn sizes(&self) -> Vec<Size> {
        (0..3).map(|axis| Size::along("file", self.report().size[axis], axis)).collect()
    }

    fn plane_strain_conflict(&self) -> Option<Conflict> {
        Some(Conflict {
            key: "shape",
            message: "shape = \"mesh\" cannot be combined with plane_strain = true",
            cure: "remove plane_strain, or choose a block, a cylinder or a disc",
        })
    }

    /// Height of the mesh.
    fn reference_length(&self) -> f64 {
        self.report().size.z
    }

    fn reference_width(&self) -> f64 {
        self.report().size.y
    }

    fn has_flat_sides(&self, _axis: usize) -> bool {
        false
    }

    fn is_mirrored(&self, axis: usize) -> bool {
        let Content { solid, mirrored, .. } = &*self.content;
        let tolerance = MIRRORED * self.report().size.max_element();
        *mirrored[axis].get_or_init(|| solid.is_mirrored(axis, tolerance))
    }

    fn thinnest(&self, search: &ThinSearch) -> Option<Thin> {
        self.content.solid.thinnest(search)
    }

    fn mesh_report(&self) -> Option<&MeshReport> {
        Some(self.report())
    }

    fn describe(&self, length: &dyn Fn(f64) -> String) -> String {
        let [x, y, z] = self.report().size.to_array().map(length);
        format!("mesh {}, {x} × {y} × {z}, {} triangles", self.file, self.report().triangles)
    }

    fn closed_form(&self) -> ClosedForm {
        let size = self.report().size;
        ClosedForm::Facets { length: size.x, width: size.y }
    }
}

/// Distance over the size of a body up to which it may differ from its mirror image: more than the rounding
/// of STL.
const MIRRORED: f64 = 1e-5;
