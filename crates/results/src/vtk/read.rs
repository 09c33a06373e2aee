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

    /// The numbers of an array.
    pub fn numbers(&self, name: &str) -> Result<Vec<f64>, OutputError> {
        let wrong = || OutputError::content(&self.path, format!("cannot make sense of its array `{name}`"));
        let tag = self.head.lines().find(|line| {
            line.starts_with("<DataArray ")
                && attribute(line, "Name") == Some(name)
                && line.contains("appended")
        });
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
