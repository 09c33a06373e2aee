//! A file in VTK's XML format, written as a stream: arrays appended raw, in blocks compressed with zlib,
//! 64-bit headers.
//!
//! No array is ever whole in memory. Tags say where their array begins, and an array begins with the sizes of
//! its compressed blocks; both are known only when it is written, and are filled in then.

use crate::files::{Inside, OutputError, write_whole, write_with};
use flate2::Compression;
use flate2::write::ZlibEncoder;
use glam::DVec3;
use std::fmt::Write as _;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};

/// Bytes per compressed block.
const BLOCK: usize = 1 << 16;
/// Width of an offset in a tag with its quotes, so that every offset fits in the place that is kept for it.
const OFFSET: usize = 22;

/// An array of a file: its tag, and where its numbers come from.
pub(super) struct DataArray<'a> {
    name: &'a str,
    components: usize,
    /// Number of numbers in the array.
    count: usize,
    numbers: Numbers<'a>,
}

enum Numbers<'a> {
    Singles(Box<dyn Iterator<Item = f64> + 'a>),
    Doubles(Box<dyn Iterator<Item = f64> + 'a>),
    Integers(Box<dyn Iterator<Item = i64> + 'a>),
}

impl<'a> DataArray<'a> {
    /// `tuples` times `components` numbers in single precision.
    pub(super) fn singles(
        name: &'a str,
        [tuples, components]: [usize; 2],
        numbers: impl Iterator<Item = f64> + 'a,
    ) -> Self {
        let numbers = Numbers::Singles(Box::new(numbers));
        Self { name, components, count: tuples * components, numbers }
    }

    /// `tuples` times `components` numbers in double precision.
    pub(super) fn doubles(
        name: &'a str,
        [tuples, components]: [usize; 2],
        numbers: impl Iterator<Item = f64> + 'a,
    ) -> Self {
        let numbers = Numbers::Doubles(Box::new(numbers));
        Self { name, components, count: tuples * components, numbers }
    }

    /// `count` whole numbers.
    pub(super) fn integers(name: &'a str, count: usize, numbers: impl Iterator<Item = i64> + 'a) -> Self {
        Self { name, components: 1, count, numbers: Numbers::Integers(Box::new(numbers)) }
    }

    /// Attributes of the array in its tag: kind, name, components.
    fn attributes(&self) -> String {
        let kind = match self.numbers {
            Numbers::Singles(_) => "Float32",
            Numbers::Doubles(_) => "Float64",
            Numbers::Integers(_) => "Int64",
        };
        let mut tag = format!(
            "DataArray type=\"{kind}\" Name=\"{}\" NumberOfComponents=\"{}\"",
            self.name, self.components
        );
        if self.components == 6 {
            // Components of a symmetric tensor in the order that VTK names them.
            for (n, component) in ["XX", "YY", "ZZ", "XY", "YZ", "XZ"].iter().enumerate() {
                // Writing to a string cannot fail.
                let _ = write!(tag, " ComponentName{n}=\"{component}\"");
            }
        }
        tag
    }

    /// Tag of the array, with the offset of its data behind the beginning of all data [bytes].
    fn tag(&self, offset: u64) -> String {
        let attributes = self.attributes();
        format!("<{attributes} format=\"appended\" offset={:OFFSET$}/>\n", format!("\"{offset}\""))
    }

    fn bytes(&self) -> usize {
        self.count
            * match self.numbers {
                Numbers::Singles(_) => size_of::<f32>(),
                Numbers::Doubles(_) => size_of::<f64>(),
                Numbers::Integers(_) => size_of::<i64>(),
            }
    }

    /// Writes header (number of blocks, block size, size of a last partial block, compressed sizes) and
    /// blocks; returns their size [bytes].
    fn write(&mut self, out: &mut (impl Write + Seek)) -> io::Result<u64> {
        let bytes = self.bytes();
        let count = bytes.div_ceil(BLOCK);
        let begin = out.stream_position()?;
        out.write_all(&vec![0; size_of::<u64>() * (3 + count)])?;
        let mut blocks = Blocks::new(out);
        match &mut self.numbers {
            Numbers::Singles(numbers) => {
                numbers.try_for_each(|number| blocks.push(&(number as f32).to_le_bytes()))
            }
            Numbers::Doubles(numbers) => numbers.try_for_each(|number| blocks.push(&number.to_le_bytes())),
            Numbers::Integers(numbers) => numbers.try_for_each(|number| blocks.push(&number.to_le_bytes())),
        }?;
        let (sizes, written) = blocks.finish()?;
        debug_assert_eq!(written, bytes, "{}", self.name);
        let end = out.stream_position()?;
        out.seek(SeekFrom::Start(begin))?;
        let header = [count as u64, BLOCK as u64, (bytes % BLOCK) as u64];
        for number in header.into_iter().chain(sizes) {
            out.write_all(&number.to_le_bytes())?;
        }
        out.seek(SeekFrom::Start(end))?;
        Ok(end - begin)
    }
}

/// Compresses bytes block by block.
struct Blocks<'w, W> {
    out: &'w mut W,
    raw: Vec<u8>,
    encoder: ZlibEncoder<Vec<u8>>,
    /// The buffer that the encoder does not have at the moment.
    packed: Vec<u8>,
    /// Compressed size of each block [bytes].
    sizes: Vec<u64>,
    taken: usize,
}

impl<'w, W: Write> Blocks<'w, W> {
    fn new(out: &'w mut W) -> Self {
        let encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
        Self { out, raw: Vec::with_capacity(BLOCK), encoder, packed: Vec::new(), sizes: Vec::new(), taken: 0 }
    }

    /// Takes the bytes of a number; a block is a whole number of numbers.
    fn push(&mut self, number: &[u8]) -> io::Result<()> {
        self.raw.extend_from_slice(number);
        if self.raw.len() == BLOCK { self.pack() } else { Ok(()) }
    }

    fn pack(&mut self) -> io::Result<()> {
        self.encoder.write_all(&self.raw)?;
        self.taken += self.raw.len();
        self.raw.clear();
        let mut packed = self.encoder.reset(std::mem::take(&mut self.packed))?;
        self.out.write_all(&packed)?;
        self.sizes.push(packed.len() as u64);
        packed.clear();
        self.packed = packed;
        Ok(())
    }

    /// The compressed size of each block, and the size of all before compression [bytes].
    fn finish(mut self) -> io::Result<(Vec<u64>, usize)> {
        if !self.raw.is_empty() {
            self.pack()?;
        }
        Ok((self.sizes, self.taken))
    }
}

/// The content of a file's main element.
pub(super) struct Dataset<'a> {
    /// The main element: `RectilinearGrid`, `PolyData`.
    pub(super) kind: &'static str,
    /// Attributes of the main element.
    pub(super) extent: String,
    /// Attributes of the only piece of the main element.
    pub(super) piece: String,
    /// Time [s].
    pub(super) time: f64,
    /// Vectors that belong to no point or cell.
    pub(super) facts: Vec<(&'static str, DVec3)>,
    /// The sections (`PointData`, `CellData`, `Points`, …) with their arrays.
    pub(super) sections: Vec<(&'static str, Vec<DataArray<'a>>)>,
}

impl Dataset<'_> {
    /// Writes a file that joins several of this kind, given by their extents and their names beside it, to a
    /// whole extent.
    pub(super) fn write_joined(
        &self,
        file: &Inside,
        whole: &str,
        pieces: &[(String, String)],
    ) -> Result<(), OutputError> {
        let mut content = String::new();
        // Writing to a string cannot fail.
        for (name, arrays) in &self.sections {
            let tags = arrays.iter().map(|array| format!("<P{}/>\n", array.attributes()));
            let _ = write!(content, "<P{name}>\n{}</P{name}>\n", tags.collect::<String>());
        }
        for (extent, source) in pieces {
            let _ = writeln!(content, "<Piece {extent} Source=\"{source}\"/>");
        }
        let kind = self.kind;
        let text = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"P{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<P{kind} Whole{whole} GhostLevel=\"0\">\n\
             {content}</P{kind}>\n</VTKFile>\n"
        );
        write_whole(file, text.as_bytes())
    }

    /// Writes the file.
    pub(super) fn write(mut self, file: &Inside) -> Result<(), OutputError> {
        write_with(file, |file| {
            let mut out = BufWriter::with_capacity(BLOCK, file);
            let count = self.sections.iter().map(|(_, arrays)| arrays.len()).sum();
            out.write_all(self.head(&vec![0; count]).as_bytes())?;
            let mut offsets = Vec::with_capacity(count);
            let mut end = 0;
            for array in self.sections.iter_mut().flat_map(|(_, arrays)| arrays) {
                offsets.push(end);
                end += array.write(&mut out)?;
            }
            out.write_all(b"\n</AppendedData>\n</VTKFile>\n")?;
            out.rewind()?;
            out.write_all(self.head(&offsets).as_bytes())?;
            out.flush()
        })
    }

    /// Everything before the data, of the same length whatever the offsets of the arrays.
    fn head(&self, offsets: &[u64]) -> String {
        let mut offsets = offsets.iter();
        let mut content = String::new();
        for (name, arrays) in &self.sections {
            let tags = arrays.iter().zip(&mut offsets).map(|(array, offset)| array.tag(*offset));
            // Writing to a string cannot fail.
            let _ = write!(content, "<{name}>\n{}</{name}>\n", tags.collect::<String>());
        }
        let fact = |(name, v): &(&str, DVec3)| {
            let tag = format!(
                "DataArray type=\"Float64\" Name=\"{name}\" NumberOfComponents=\"3\" NumberOfTuples=\"1\""
            );
            format!("<{tag} format=\"ascii\">{} {} {}</DataArray>\n", v.x, v.y, v.z)
        };
        let Self { kind, extent, piece, time, .. } = self;
        let facts: String = self.facts.iter().map(fact).collect();
        format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"{kind}\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<{kind}{extent}>\n<FieldData>\n\
             <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{time}</DataArray>\n\
             {facts}</FieldData>\n<Piece {piece}>\n{content}</Piece>\n</{kind}>\n<AppendedData encoding=\"raw\">\n_"
        )
    }
}
