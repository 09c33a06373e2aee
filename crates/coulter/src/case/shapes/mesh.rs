//! A body from the file of its surface.

use super::slab::Slab;
use super::traits::{CaseShape, ClosedForm, Conflict, Size};
use crate::case::mesh_file::{self, MeshFile, MeshFileProblem, MeshReport};
use crate::case::missing::missing;
use crate::case::problem::Problems;
use crate::case::quantity::{self, LENGTH};
use crate::case::typed::Section;
use physics::shape;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A solid whose surface is in a file. Copies share what was read of it.
#[derive(Clone, Debug, Serialize)]
pub struct MeshBody {
    /// The file, as typed.
    pub file: String,
    /// Unit of its coordinates [m].
    pub unit: f64,
    /// Hash of its content.
    pub hash: String,
    #[serde(skip)]
    content: Arc<Content>,
}

#[derive(Debug)]
struct Content {
    /// Where the file is.
    path: PathBuf,
    solid: shape::Polyhedron,
    report: MeshReport,
}

impl PartialEq for MeshBody {
    /// The hash stands for the content.
    fn eq(&self, other: &Self) -> bool {
        (&self.file, self.unit, &self.hash) == (&other.file, other.unit, &other.hash)
    }
}

impl MeshBody {
    pub(super) const KEYS: &[&str] = &["file", "unit"];

    /// The solid in a file in a folder, whose unit of length is written like that of a length: `mm`.
    ///
    /// # Errors
    /// [`MeshFileProblem`] says what is wrong with the file, where, and what to do.
    pub fn load(folder: &Path, file: &str, unit: &str) -> Result<Self, MeshFileProblem> {
        let metres = quantity::parse(&format!("1 {unit}"), &LENGTH).map_err(|error| MeshFileProblem {
            message: error.to_string(),
            cure: "write a unit of length, such as \"mm\"".to_owned(),
        })?;
        let path = folder.join(file);
        let MeshFile { solid, report, hash } = mesh_file::read(&path, (unit, metres))?;
        let content = Arc::new(Content { path, solid, report });
        Ok(Self { file: file.to_owned(), unit: metres, hash, content })
    }

    pub(super) fn read(section: &Section, _slab: Option<Slab>, problems: &mut Problems) -> Option<Self> {
        for key in Self::KEYS.iter().filter(|key| !section.has(key)) {
            missing(section, key, problems);
        }
        let (file, unit) = (section.text("file")?, section.text("unit")?);
        Self::load(&section.folder, &file, &unit)
            .map_err(|MeshFileProblem { message, cure }| {
                problems.add(section.at("file"), format!("{file}: {message}"), cure);
            })
            .ok()
    }

    /// Where the file is that was read.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.content.path
    }

    /// What its surface is like, and what was repaired.
    #[must_use]
    pub fn report(&self) -> &MeshReport {
        &self.content.report
    }
}

impl CaseShape for MeshBody {
    fn solid(&self) -> Box<dyn shape::Shape> {
        Box::new(self.content.solid.clone())
    }

    /// The edges of its box.
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

    /// Its height.
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
        self.content.solid.is_mirrored(axis, MIRRORED * self.report().size.max_element())
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

/// Distance over its size up to which a body may differ from its mirror image: more than the rounding of STL.
const MIRRORED: f64 = 1e-5;
