//! VTK's XML files: data appended raw, in blocks compressed with zlib, 64-bit headers. ParaView and PyVista read them.

use super::error::{Named, OutputError, write_whole};
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;

/// Bytes per compressed block.
const BLOCK: usize = 1 << 16;

/// The data section of a file and the tags that point into it.
#[derive(Debug, Default)]
pub(super) struct Appended {
    bytes: Vec<u8>,
}

impl Appended {
    /// Adds an array of single-precision numbers; returns its tag.
    pub(super) fn floats(
        &mut self,
        name: &str,
        components: usize,
        values: impl Iterator<Item = f64>,
    ) -> String {
        let raw: Vec<u8> = values.flat_map(|v| (v as f32).to_le_bytes()).collect();
        self.array("Float32", name, components, &raw)
    }

    /// Adds an array of double-precision numbers; returns its tag.
    pub(super) fn doubles(
        &mut self,
        name: &str,
        components: usize,
        values: impl Iterator<Item = f64>,
    ) -> String {
        let raw: Vec<u8> = values.flat_map(f64::to_le_bytes).collect();
        self.array("Float64", name, components, &raw)
    }

    /// Adds an array of whole numbers; returns its tag.
    pub(super) fn integers(&mut self, name: &str, values: impl Iterator<Item = i64>) -> String {
        let raw: Vec<u8> = values.flat_map(i64::to_le_bytes).collect();
        self.array("Int64", name, 1, &raw)
    }

    fn array(&mut self, kind: &str, name: &str, components: usize, raw: &[u8]) -> String {
        let offset = self.bytes.len();
        self.push_blocks(raw);
        // Components of a symmetric tensor in the order that VTK names them.
        let names = match components {
            6 => ["XX", "YY", "ZZ", "XY", "YZ", "XZ"]
                .iter()
                .enumerate()
                .fold(String::new(), |text, (n, c)| format!("{text} ComponentName{n}=\"{c}\"")),
            _ => String::new(),
        };
        format!(
            "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\"{names} \
             format=\"appended\" offset=\"{offset}\"/>\n"
        )
    }

    /// Header (number of blocks, block size, size of a last partial block, compressed sizes), then the blocks.
    fn push_blocks(&mut self, raw: &[u8]) {
        let blocks: Vec<Vec<u8>> = raw.chunks(BLOCK).map(compress).collect();
        let header = [blocks.len(), BLOCK, raw.len() % BLOCK];
        let sizes = blocks.iter().map(Vec::len);
        for number in header.into_iter().chain(sizes) {
            self.bytes.extend((number as u64).to_le_bytes());
        }
        for block in &blocks {
            self.bytes.extend(block);
        }
    }

    /// Puts the file together and writes it.
    pub(super) fn write(
        self,
        path: &Path,
        kind: &str,
        time: f64,
        dataset: &Dataset,
    ) -> Result<(), OutputError> {
        let mut file = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<{kind}{extent}>\n<FieldData>\n\
             <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{time}</DataArray>\n\
             </FieldData>\n<Piece {piece}>\n{content}</Piece>\n</{kind}>\n<AppendedData encoding=\"raw\">\n_",
            extent = dataset.extent,
            piece = dataset.piece,
            content = dataset.content,
        )
        .into_bytes();
        file.extend(self.bytes);
        file.extend(b"\n</AppendedData>\n</VTKFile>\n");
        write_whole(path, &file)
    }
}

/// What is inside a file's main element.
#[derive(Debug, Default)]
pub(super) struct Dataset {
    /// Attributes of the main element.
    pub(super) extent: String,
    /// Attributes of its only piece.
    pub(super) piece: String,
    /// The arrays' tags in their sections.
    pub(super) content: String,
}

impl Dataset {
    /// Adds a section (`PointData`, `CellData`, `Points`, …) with the tags of its arrays.
    pub(super) fn section(&mut self, name: &str, tags: &[String]) {
        // Writing to a string cannot fail.
        let _ = write!(self.content, "<{name}>\n{}</{name}>\n", tags.concat());
    }
}

fn compress(block: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    // Writing to memory cannot fail.
    let _ = encoder.write_all(block);
    encoder.finish().unwrap_or_default()
}

/// One line of a time list: when, which part, which file (relative to the list).
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Frame {
    /// Time [s].
    pub(super) time: f64,
    /// Number of the part (body).
    pub(super) part: usize,
    /// File, relative to the list.
    pub(super) file: String,
}

/// Writes a `.pvd`: the list of files by time that ParaView opens.
pub(super) fn write_time_list(path: &Path, frames: &[Frame]) -> Result<(), OutputError> {
    let mut text = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n",
    );
    for Frame { time, part, file } in frames {
        let _ = writeln!(text, "<DataSet timestep=\"{time}\" group=\"\" part=\"{part}\" file=\"{file}\"/>");
    }
    text.push_str("</Collection>\n</VTKFile>\n");
    write_whole(path, text.as_bytes())
}

/// Reads back a list that [`write_time_list`] wrote; none when there is no such file.
pub(super) fn read_time_list(path: &Path) -> Result<Vec<Frame>, OutputError> {
    if !path.is_file() {
        return Ok(Vec::new());
    }
    let text = std::fs::read_to_string(path).named("read", path)?;
    let lines = text.lines().filter(|line| line.starts_with("<DataSet "));
    lines
        .map(|line| {
            let attribute = |name: &str| {
                let start = line.find(&format!("{name}=\""))? + name.len() + 2;
                line[start..].split('"').next()
            };
            let parse = || {
                Some(Frame {
                    time: attribute("timestep")?.parse().ok()?,
                    part: attribute("part")?.parse().ok()?,
                    file: attribute("file")?.to_owned(),
                })
            };
            parse().ok_or_else(|| OutputError::content(path, format!("cannot make sense of `{line}`")))
        })
        .collect()
}
