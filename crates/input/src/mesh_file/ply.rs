//! PLY (Turk 1994): a header that says which elements follow, and with which properties; then these, as text
//! or binary.

use super::limits::{MOST_TRIANGLES, TOO_MANY, require_few};
use super::lines::{Lines, shown};
use super::polygon;
use super::problem::{DAMAGED, MEND_FACE, MeshFileProblem, refuse};
use super::surface::Surface;
use super::unit::{self, Stated};
use glam::DVec3;
use std::io::BufRead;

/// Most lines of a header.
const MOST_LINES: usize = 1000;

/// Type of a number.
#[derive(Clone, Copy, Debug)]
struct Number {
    bytes: usize,
    is_signed: bool,
    is_float: bool,
}

impl Number {
    fn of(word: &str) -> Option<Self> {
        let (bytes, is_signed, is_float) = match word {
            "char" | "int8" => (1, true, false),
            "uchar" | "uint8" => (1, false, false),
            "short" | "int16" => (2, true, false),
            "ushort" | "uint16" => (2, false, false),
            "int" | "int32" => (4, true, false),
            "uint" | "uint32" => (4, false, false),
            "float" | "float32" => (4, true, true),
            "double" | "float64" => (8, true, true),
            _ => return None,
        };
        Some(Self { bytes, is_signed, is_float })
    }

    /// The number of these bytes, the lowest first.
    fn value(self, low_first: [u8; 8]) -> f64 {
        let bits = u64::from_le_bytes(low_first);
        match (self.is_float, self.bytes) {
            (true, 8) => f64::from_bits(bits),
            (true, _) => f64::from(f32::from_bits(bits as u32)),
            (false, bytes) if self.is_signed => {
                let unused = 64 - 8 * bytes as u32;
                ((bits << unused).cast_signed() >> unused) as f64
            }
            (false, _) => bits as f64,
        }
    }
}

#[derive(Clone, Debug)]
struct PropertyOf {
    name: String,
    /// Type of the length of a list; `None` for a single number.
    length: Option<Number>,
    number: Number,
}

#[derive(Clone, Debug)]
struct Element {
    name: String,
    count: u64,
    properties: Vec<PropertyOf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Encoding {
    Text,
    LowFirst,
    HighFirst,
}

pub(super) fn read(reader: impl BufRead) -> Result<Surface, MeshFileProblem> {
    let mut lines = Lines::new(reader);
    let Header { encoding, elements, unit } = header(&mut lines)?;
    let mut source = match encoding {
        Encoding::Text => Source::Text { lines, words: Vec::new() },
        _ => Source::Binary { reader: lines.into_rest(), is_high_first: encoding == Encoding::HighFirst },
    };
    let mut surface = Surface::counting("face");
    surface.unit = unit;
    for element in &elements {
        match element.name.as_str() {
            "vertex" => points(element, &mut source, &mut surface)?,
            "face" => faces(element, &mut source, &mut surface)?,
            "tristrips" => return refuse("it holds strips of triangles", "export the body with faces"),
            _ => passed_over(element, &mut source)?,
        }
    }
    Ok(surface)
}

/// What a header says.
struct Header {
    encoding: Encoding,
    elements: Vec<Element>,
    unit: Option<Stated>,
}

fn header<R: BufRead>(lines: &mut Lines<R>) -> Result<Header, MeshFileProblem> {
    let (mut encoding, mut unit) = (None, None);
    let mut elements: Vec<Element> = Vec::new();
    for n in 0..MOST_LINES {
        let Some(line) = lines.next()? else { return lines.wrong("the header has no end") };
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            ["ply"] if n == 0 => {}
            ["comment" | "obj_info", ..] => {
                unit = unit.or_else(|| unit::stated(&line, || format!("line {}", lines.number())));
            }
            [] => {}
            ["format", kind, _] => {
                encoding = match kind {
                    "ascii" => Some(Encoding::Text),
                    "binary_little_endian" => Some(Encoding::LowFirst),
                    "binary_big_endian" => Some(Encoding::HighFirst),
                    _ => return lines.wrong(format!("the format {} is not known", shown(kind))),
                };
            }
            ["element", name, count] => {
                let Ok(count) = count.parse() else {
                    return lines.wrong(format!("{} is not a number of elements", shown(count)));
                };
                require_possible(name, count)?;
                elements.push(Element { name: name.to_owned(), count, properties: Vec::new() });
            }
            ["property", ref typed @ .., name] => match (property(typed, name), elements.last_mut()) {
                (Some(property), Some(element)) => element.properties.push(property),
                _ => return lines.wrong(format!("the property {} cannot be read", shown(name))),
            },
            ["end_header"] => {
                return match encoding {
                    Some(encoding) => Ok(Header { encoding, elements, unit }),
                    None => lines.wrong("the header does not say the format"),
                };
            }
            _ => return lines.wrong(format!("{} is not expected in a header", shown(&line))),
        }
    }
    lines.wrong("the header has no end")
}

/// Refuses numbers of points and faces that a body cannot have, before any is read.
fn require_possible(name: &str, count: u64) -> Result<(), MeshFileProblem> {
    match name {
        "face" => require_few(count, "its header declares"),
        "vertex" if count > 3 * MOST_TRIANGLES as u64 => {
            require_few(count / 3, &format!("its header declares {count} points, enough for"))
        }
        _ => Ok(()),
    }
}

fn property(typed: &[&str], name: &str) -> Option<PropertyOf> {
    let (length, number) = match *typed {
        [number] => (None, Number::of(number)?),
        ["list", length, number] => {
            (Some(Number::of(length).filter(|length| !length.is_float)?), Number::of(number)?)
        }
        _ => return None,
    };
    Some(PropertyOf { name: name.to_owned(), length, number })
}

/// Numbers, one after the other.
enum Source<R> {
    Text {
        lines: Lines<R>,
        /// Numbers left in the present line, in reverse.
        words: Vec<f64>,
    },
    Binary {
        reader: R,
        is_high_first: bool,
    },
}

impl<R: BufRead> Source<R> {
    /// Goes on to the next element; `place` says which one it is.
    fn begin(&mut self, place: impl Fn() -> String) -> Result<(), MeshFileProblem> {
        let Self::Text { lines, words } = self else { return Ok(()) };
        let line = loop {
            match lines.next()? {
                None => return refuse(format!("it ends before {}", place()), DAMAGED),
                Some(line) if line.is_empty() => {}
                Some(line) => break line,
            }
        };
        words.clear();
        for word in line.split_whitespace().rev() {
            match word.parse() {
                Ok(number) => words.push(number),
                Err(_) => return lines.wrong(format!("{} is not a number", shown(word))),
            }
        }
        Ok(())
    }

    /// The next number; `None` at the end of the file, and where something else stands.
    fn next(&mut self, number: Number) -> Option<f64> {
        match self {
            Self::Text { words, .. } => words.pop(),
            Self::Binary { reader, is_high_first } => {
                let mut bytes = [0; 8];
                reader.read_exact(&mut bytes[..number.bytes]).ok()?;
                if *is_high_first {
                    bytes[..number.bytes].reverse();
                }
                Some(number.value(bytes))
            }
        }
    }

    /// Refuses what is left of a line.
    fn end(&self) -> Result<(), MeshFileProblem> {
        match self {
            Self::Text { lines, words } if !words.is_empty() => {
                lines.wrong("there are more numbers than the header says")
            }
            _ => Ok(()),
        }
    }
}

/// What is wrong with an element, and the cure.
type Wrong = (String, &'static str);

fn damaged<T>(why: impl Into<String>) -> Result<T, Wrong> {
    Err((why.into(), DAMAGED))
}

/// Calls `each(property, number)` for the numbers of every element; of lists also for each of their numbers.
fn walk<R: BufRead>(
    element: &Element,
    source: &mut Source<R>,
    mut each: impl FnMut(u64, Option<(usize, f64)>) -> Result<(), Wrong>,
) -> Result<(), MeshFileProblem> {
    if element.properties.is_empty() {
        return if element.count == 0 {
            Ok(())
        } else {
            refuse(format!("`{}` has no properties", element.name), DAMAGED)
        };
    }
    for n in 0..element.count {
        let place = || format!("{} {}", element.name, n + 1);
        source.begin(place)?;
        let ends = || MeshFileProblem::new(format!("{} is not complete", place()), DAMAGED);
        let wrong = |(why, cure): Wrong| MeshFileProblem::new(format!("{}: {why}", place()), cure);
        for (which, property) in element.properties.iter().enumerate() {
            let count = match property.length {
                None => 1,
                Some(length) => {
                    let count = source.next(length).ok_or_else(ends)?;
                    if !(0.0..=f64::from(u32::MAX)).contains(&count) || count.fract() != 0.0 {
                        return Err(wrong((format!("a list cannot have {count} numbers"), DAMAGED)));
                    }
                    count as u64
                }
            };
            for _ in 0..count {
                let number = source.next(property.number).ok_or_else(ends)?;
                each(n, Some((which, number))).map_err(wrong)?;
            }
        }
        source.end()?;
        each(n, None).map_err(wrong)?;
    }
    Ok(())
}

fn passed_over<R: BufRead>(element: &Element, source: &mut Source<R>) -> Result<(), MeshFileProblem> {
    walk(element, source, |_, _| Ok(()))
}

fn points<R: BufRead>(
    element: &Element,
    source: &mut Source<R>,
    surface: &mut Surface,
) -> Result<(), MeshFileProblem> {
    let place = |axis: &str| element.properties.iter().position(|p| p.name == axis && p.length.is_none());
    let [Some(x), Some(y), Some(z)] = ["x", "y", "z"].map(place) else {
        return refuse("its points have no properties x, y and z", DAMAGED);
    };
    let mut point = DVec3::ZERO;
    walk(element, source, |_, found| {
        match found {
            Some((which, number)) if which == x => point.x = number,
            Some((which, number)) if which == y => point.y = number,
            Some((which, number)) if which == z => point.z = number,
            Some(_) => {}
            None if point.is_finite() => surface.mesh.points.push(point),
            None => return damaged("a coordinate is not a finite number"),
        }
        Ok(())
    })
}

fn faces<R: BufRead>(
    element: &Element,
    source: &mut Source<R>,
    surface: &mut Surface,
) -> Result<(), MeshFileProblem> {
    let is_list =
        |p: &PropertyOf| ["vertex_indices", "vertex_index"].contains(&p.name.as_str()) && p.length.is_some();
    let Some(list) = element.properties.iter().position(is_list) else {
        return refuse("its faces have no list vertex_indices", DAMAGED);
    };
    let mut corners: Vec<u32> = Vec::new();
    walk(element, source, |number_of_face, found| {
        let count = surface.mesh.points.len();
        match found {
            Some((which, number)) if which == list => {
                if number.fract() != 0.0 || !(0.0..count as f64).contains(&number) {
                    return damaged(format!("{number} is not one of the {count} points before it"));
                }
                if corners.len() >= polygon::MOST_CORNERS {
                    return Err((format!("a face has at most {} corners", polygon::MOST_CORNERS), MEND_FACE));
                }
                corners.push(number as u32);
            }
            Some(_) => {}
            None => {
                if corners.len() < 3 {
                    return damaged("a face has at least 3 corners");
                }
                let face = polygon::divided(&corners, &surface.mesh.points)
                    .map_err(|why| (format!("a face of {} corners {why}", corners.len()), MEND_FACE))?;
                surface.add(face, number_of_face + 1);
                corners.clear();
                let triangles = surface.mesh.triangles.len() as u64;
                require_few(triangles, "it holds at least").map_err(|problem| (problem.message, TOO_MANY))?;
            }
        }
        Ok(())
    })
}
