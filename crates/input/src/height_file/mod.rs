//! Files with heights of the ground: tables of points or a grid, ESRI grids, TIFF and PNG.

mod esri;
mod geo_keys;
mod marks;
mod placement;
mod png_file;
mod scattered;
mod table;
mod tiff_file;

pub use placement::Placement;

use super::data_file::{self, FileProblem, problem};
use super::mesh_file::hash_of;
use geometry::relief::HeightField;
use placement::{Raster, TOO_MANY};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use xxhash_rust::xxh3::Xxh3;

/// Largest file [bytes].
const MAX_BYTES: u64 = 128 << 20;

/// Heights of the ground that were read from a file. Copies share them.
#[derive(Clone, Debug, Serialize)]
pub struct HeightFile {
    /// The file, as typed.
    pub file: String,
    /// Hash of the heights and their places.
    pub hash: String,
    #[serde(skip)]
    content: Arc<FileContent>,
}

#[derive(Debug)]
struct FileContent {
    path: PathBuf,
    /// Hash of the file itself.
    hash: String,
    heights: Arc<HeightField>,
    remarks: Vec<String>,
}

impl PartialEq for HeightFile {
    /// The hash stands for the content.
    fn eq(&self, other: &Self) -> bool {
        (&self.file, &self.hash) == (&other.file, &other.hash)
    }
}

impl HeightFile {
    /// The heights in a file in a folder, placed as the case says.
    ///
    /// # Errors
    /// [`FileProblem`] says what is wrong with the file, where, and what to do.
    pub fn load(folder: &Path, file: &str, placement: &Placement) -> Result<Self, FileProblem> {
        let path = folder.join(file);
        let bytes = data_file::bytes(&path, MAX_BYTES, TOO_MANY)?;
        let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
        let (raster, remarks) = match extension.as_str() {
            "csv" | "txt" | "tsv" | "dat" | "asc" => table::read(bytes, false, placement)?,
            "xyz" => table::read(bytes, true, placement)?,
            "tif" | "tiff" => tiff_file::read(bytes, placement)?,
            "png" => (png_file::read(&bytes, placement)?, Vec::new()),
            _ => {
                let message =
                    format!("its extension is `{extension}`, which is not that of a format that can be read");
                let cure = "save the heights as CSV, ESRI grid, points, TIFF or PNG, with the extension .csv, .asc, .xyz, .tif or .png";
                return problem(message, cure);
            }
        };
        marks::none_in(&raster, placement.datum)?;
        let Raster { lines, heights } = raster;
        let mut hasher = Xxh3::new();
        let numbers = lines.iter().flatten().chain(&heights);
        numbers.for_each(|number| hasher.update(&number.to_le_bytes()));
        let unreadable = |error: std::io::Error| FileProblem {
            message: format!("cannot be read: {error}"),
            cure: "check that the file can be read".to_owned(),
        };
        let Some(heights) = HeightField::new(lines, heights) else {
            return problem("its heights do not lie on a grid", "give it two lines or more along x and y");
        };
        let content =
            FileContent { hash: hash_of(&path).map_err(unreadable)?, path, heights: heights.into(), remarks };
        Ok(Self {
            file: file.to_owned(),
            hash: format!("{:032x}", hasher.digest128()),
            content: Arc::new(content),
        })
    }

    /// Where the file is that was read.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.content.path
    }

    /// Hash of the file itself.
    #[must_use]
    pub fn file_hash(&self) -> &str {
        &self.content.hash
    }

    /// Remarks on the file, such as what it leaves open.
    #[must_use]
    pub fn remarks(&self) -> &[String] {
        &self.content.remarks
    }

    /// Heights of the file, in the axes of the case.
    #[must_use]
    pub fn heights(&self) -> &Arc<HeightField> {
        &self.content.heights
    }
}

#[cfg(test)]
mod tests;
