//! The file of an FMU: description, library, and the case with the files that it names.

use crate::description::{IDENTIFIER, description};
use crate::fmu::{Fmu, FmuError};
use crate::variables::Steered;
use coulter::output::{OutputError, write_case_file};
use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

/// Place of the case in the resources.
const CASE: &str = "case.toml";
/// Place in the resources of how bodies are steered.
const STEERED: &str = "steered.json";

/// What the library of an FMU holds, as a program that writes FMUs knows it.
#[used]
pub static MARK: &str = concat!("library of functional mock-up units of Coulter ", env!("CARGO_PKG_VERSION"));

/// Why an FMU could not be written.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// The case.
    #[error(transparent)]
    Fmu(#[from] FmuError),
    /// A file of the case.
    #[error(transparent)]
    Case(#[from] OutputError),
    /// The library is another.
    #[error("{}: not the library of FMUs of this program", .0.display())]
    Library(PathBuf),
    /// A file cannot be read or written.
    #[error("{}: {why}", .path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        why: io::Error,
    },
}

/// File name of the library on this system.
#[must_use]
pub fn library_name() -> String {
    format!("{}coulter_fmu{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX)
}

/// The name that the standard gives to this system.
fn platform() -> String {
    let system = if cfg!(target_os = "macos") { "darwin" } else { std::env::consts::OS };
    format!("{}-{system}", std::env::consts::ARCH)
}

/// Writes an FMU with this library to a file, which it replaces.
///
/// # Errors
/// [`ExportError`]; the file is as before then.
pub fn export(fmu: &Fmu, library: &Path, to: &Path) -> Result<(), ExportError> {
    let at = |path: &Path| {
        let path = path.to_path_buf();
        move |why: io::Error| ExportError::File { path, why }
    };
    let code = fs::read(library).map_err(at(library))?;
    if !code.windows(MARK.len()).any(|window| window == MARK.as_bytes()) {
        return Err(ExportError::Library(library.to_path_buf()));
    }
    let resources = tempfile::tempdir().map_err(at(&std::env::temp_dir()))?;
    write_case_file(resources.path(), &fmu.case, &fmu.typed)?;
    let steered = serde_json::to_vec(&fmu.steered_by_name()).unwrap_or_default();
    let place = resources.path().join(STEERED);
    fs::write(&place, steered).map_err(at(&place))?;
    // Of the FMU as its library will read it.
    let description = description(&Fmu::in_resources(resources.path())?)?;
    let beside = to.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut part = tempfile::NamedTempFile::new_in(beside).map_err(at(to))?;
    let written = (|| {
        let mut archive = ZipWriter::new(part.as_file_mut());
        let suffix = std::env::consts::DLL_SUFFIX;
        put(&mut archive, "modelDescription.xml", description.as_bytes())?;
        put(&mut archive, &format!("binaries/{}/{IDENTIFIER}{suffix}", platform()), &code)?;
        put_folder(&mut archive, "resources", resources.path())?;
        archive.finish()?.flush()
    })();
    written.map_err(at(to))?;
    part.persist(to).map_err(|error| at(to)(error.error))?;
    Ok(())
}

fn put<W: Write + io::Seek>(archive: &mut ZipWriter<W>, name: &str, content: &[u8]) -> io::Result<()> {
    archive.start_file(name, SimpleFileOptions::default())?;
    archive.write_all(content)
}

/// Puts the files of a folder and of those in it under a name.
fn put_folder<W: Write + io::Seek>(archive: &mut ZipWriter<W>, name: &str, folder: &Path) -> io::Result<()> {
    let mut entries = fs::read_dir(folder)?.collect::<io::Result<Vec<_>>>()?;
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let name = format!("{name}/{}", entry.file_name().to_string_lossy());
        if entry.file_type()?.is_dir() {
            put_folder(archive, &name, &entry.path())?;
        } else {
            put(archive, &name, &fs::read(entry.path())?)?;
        }
    }
    Ok(())
}

impl Fmu {
    /// The FMU whose resources an importer has unpacked into a folder.
    ///
    /// # Errors
    /// Resources that are missing or wrong.
    pub fn in_resources(folder: &Path) -> Result<Self, ExportError> {
        let path = folder.join(STEERED);
        let wrong = |why: io::Error| ExportError::File { path: path.clone(), why };
        let text = fs::read(&path).map_err(wrong)?;
        let steered: BTreeMap<String, Steered> =
            serde_json::from_slice(&text).map_err(|error| wrong(error.into()))?;
        Ok(Self::of_file(&folder.join(CASE), &[], &steered)?)
    }
}
