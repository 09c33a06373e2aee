//! Reads back arrays of the files that this module writes.

use crate::files::{Inside, Named, OutputError};
use flate2::read::ZlibDecoder;
use std::io::Read as _;
use std::path::PathBuf;

/// Bytes of a number in a header of an array.
const WORD: usize = size_of::<u64>();
/// What stands before the data.
const BEGIN: &[u8] = b"<AppendedData encoding=\"raw\">\n_";
/// Largest array that is read [bytes]: a file that is damaged must not fill the memory.
const MOST_BYTES: usize = 1 << 30;

/// Largest file that is read [bytes].
const MOST_FILE: u64 = 8 << 30;

/// A file with its arrays.
pub struct VtkFile {
    path: PathBuf,
    head: String,
    data: Vec<u8>,
}

impl VtkFile {
    /// Reads a file.
    pub fn read(from: &Inside) -> Result<Self, OutputError> {
        let path = from.path();
        let bytes = from.read(MOST_FILE).named("read", &path)?;
        let begin = bytes.windows(BEGIN.len()).position(|window| window == BEGIN);
        let begin = begin.ok_or_else(|| OutputError::content(&path, "it has no data"))?;
        let head = String::from_utf8_lossy(&bytes[..begin]).into_owned();
        Ok(Self { path, head, data: bytes[begin + BEGIN.len()..].to_vec() })
    }

    /// The numbers of the first array of this name.
    pub fn numbers(&self, name: &str) -> Result<Vec<f64>, OutputError> {
        self.unpack(name, self.tags().find(|tag| attribute(tag, "Name") == Some(name)))
    }

    /// The numbers of an array of a section, such as `CellData`.
    pub fn numbers_in(&self, section: &str, name: &str) -> Result<Vec<f64>, OutputError> {
        self.unpack(name, self.section(section).find(|tag| attribute(tag, "Name") == Some(name)))
    }

    /// Name and number of components of the arrays of a section.
    pub fn arrays(&self, section: &str) -> impl Iterator<Item = (&str, usize)> {
        let components = |tag| attribute(tag, "NumberOfComponents").and_then(|text| text.parse().ok());
        self.section(section).filter_map(move |tag| Some((attribute(tag, "Name")?, components(tag)?)))
    }

    /// A vector that belongs to no point or cell.
    pub fn fact(&self, name: &str) -> Result<[f64; 3], OutputError> {
        let line = self.head.lines().find(|line| {
            line.starts_with("<DataArray ") && attribute(line, "Name") == Some(name) && line.contains("ascii")
        });
        let text = line.and_then(|line| line.split('>').nth(1)?.split('<').next());
        let numbers: Option<Vec<f64>> =
            text.and_then(|text| text.split(' ').map(|number| number.parse().ok()).collect());
        numbers.and_then(|numbers| numbers.try_into().ok()).ok_or_else(|| {
            OutputError::content(&self.path, format!("it has no `{name}`; run the case again"))
        })
    }

    /// Tags of the arrays.
    fn tags(&self) -> impl Iterator<Item = &str> {
        let is_array = |line: &&str| line.starts_with("<DataArray ") && line.contains("appended");
        self.head.lines().filter(is_array)
    }

    /// Tags of the arrays of a section.
    fn section(&self, name: &str) -> impl Iterator<Item = &str> {
        let from = self.head.find(&format!("<{name}>")).unwrap_or(self.head.len());
        let to = self.head.find(&format!("</{name}>")).unwrap_or(self.head.len()).max(from);
        self.head[from..to].lines().filter(|line| line.starts_with("<DataArray "))
    }

    fn unpack(&self, name: &str, tag: Option<&str>) -> Result<Vec<f64>, OutputError> {
        let wrong = || OutputError::content(&self.path, format!("cannot make sense of its array `{name}`"));
        let tag = tag.ok_or_else(wrong)?;
        let offset = attribute(tag, "offset").and_then(|text| text.parse().ok()).ok_or_else(wrong)?;
        let bytes = self.unpacked(offset).ok_or_else(wrong)?;
        let words = bytes.chunks_exact(WORD).map(|word| <[u8; WORD]>::try_from(word).unwrap_or_default());
        match attribute(tag, "type") {
            Some("Float64") => Ok(words.map(f64::from_le_bytes).collect()),
            Some("Int64") => Ok(words.map(|word| i64::from_le_bytes(word) as f64).collect()),
            Some("Float32") => {
                let singles = bytes.chunks_exact(4).map(|word| <[u8; 4]>::try_from(word).unwrap_or_default());
                Ok(singles.map(|word| f64::from(f32::from_le_bytes(word))).collect())
            }
            _ => Err(wrong()),
        }
    }

    /// The bytes of the array at an offset; `None` where they are not what its header says.
    fn unpacked(&self, offset: usize) -> Option<Vec<u8>> {
        let mut at = offset;
        let mut word = || {
            let bytes = self.data.get(at..at.checked_add(WORD)?)?;
            at += WORD;
            usize::try_from(u64::from_le_bytes(bytes.try_into().ok()?)).ok()
        };
        let (count, block, last) = (word()?, word()?, word()?);
        if count.checked_mul(block)? > MOST_BYTES || count > self.data.len() {
            return None;
        }
        let sizes = (0..count).map(|_| word()).collect::<Option<Vec<usize>>>()?;
        let mut all = Vec::new();
        for size in sizes {
            let packed = self.data.get(at..at.checked_add(size)?)?;
            at += size;
            ZlibDecoder::new(packed).take(block as u64).read_to_end(&mut all).ok()?;
        }
        let missing = if last > 0 { block - last.min(block) } else { 0 };
        (all.len() + missing == count * block).then_some(all)
    }
}

/// The value of an attribute of a tag.
fn attribute<'a>(tag: &'a str, name: &str) -> Option<&'a str> {
    let begin = tag.find(&format!(" {name}=\""))? + name.len() + 3;
    tag[begin..].split('"').next()
}
