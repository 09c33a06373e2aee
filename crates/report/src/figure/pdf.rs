//! A page as a PDF document: text stays text, in the faces that it brings along.

use super::drawing::{Drawing, Item, Pen};
use super::font::Face;
use super::segment::Segment;
use super::text::LaidText;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use pdf_writer::types::{CidFontType, FontFlags, SystemInfo, UnicodeCmap};
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref, Str};
use std::collections::BTreeMap;
use std::io::Write as _;

/// Letters of the glyphs of a face that occur.
type Used = BTreeMap<Face, BTreeMap<u16, char>>;

/// Objects of a face, and before them those of the document.
const OBJECTS: i32 = 5;
const FIRST_FACE: i32 = 10;

/// What the numbers of glyphs are: those of the face.
const IDENTITY: SystemInfo<'static> =
    SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };

/// The page as the bytes of a document. Nothing of it depends on when or where it was written.
pub(super) fn pdf(drawing: &Drawing) -> Vec<u8> {
    let [catalog, pages, page, content] = [1, 2, 3, 4].map(Ref::new);
    let used = used(drawing);
    let mut pdf = Pdf::new();
    pdf.catalog(catalog).pages(pages);
    pdf.pages(pages).kids([page]).count(1);
    let mut written = pdf.page(page);
    written.media_box(Rect::new(0.0, 0.0, drawing.size[0] as f32, drawing.size[1] as f32));
    written.parent(pages).contents(content);
    let mut resources = written.resources();
    let mut fonts = resources.fonts();
    for face in used.keys() {
        fonts.pair(Name(short(*face)), object(*face, 0));
    }
    fonts.finish();
    resources.finish();
    written.finish();
    let bytes = packed(&operators(drawing));
    pdf.stream(content, &bytes).filter(Filter::FlateDecode);
    for (face, letters) in &used {
        embed(&mut pdf, *face, letters);
    }
    pdf.finish()
}

/// Number of an object of a face.
fn object(face: Face, number: i32) -> Ref {
    Ref::new(FIRST_FACE + OBJECTS * face as i32 + number)
}

fn short(face: Face) -> &'static [u8] {
    match face {
        Face::Upright => b"F0",
        Face::Italic => b"F1",
    }
}

fn used(drawing: &Drawing) -> Used {
    let mut used = Used::new();
    for item in &drawing.items {
        let Item::Text { text, .. } = item else { continue };
        for glyph in &text.glyphs {
            used.entry(glyph.face).or_default().insert(glyph.glyph, glyph.letter);
        }
    }
    used
}

/// Compressed; the same bytes for the same content.
fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    // Memory does not fail to be written.
    let _ = encoder.write_all(bytes);
    encoder.finish().unwrap_or_default()
}

/// Brings along a face: its file, the widths of its letters, and which letters its glyphs are.
fn embed(pdf: &mut Pdf, face: Face, letters: &BTreeMap<u16, char>) {
    let [font, descendant, descriptor, unicode, file] = [0, 1, 2, 3, 4].map(|n| object(face, n));
    let name = Name(face.name().as_bytes());
    pdf.type0_font(font)
        .base_font(name)
        .encoding_predefined(Name(b"Identity-H"))
        .descendant_font(descendant)
        .to_unicode(unicode);
    let mut cid = pdf.cid_font(descendant);
    cid.subtype(CidFontType::Type2).base_font(name).system_info(IDENTITY).font_descriptor(descriptor);
    cid.default_width(0.0).cid_to_gid_map_predefined(Name(b"Identity"));
    let mut widths = cid.widths();
    for glyph in letters.keys() {
        widths.consecutive(*glyph, [1000.0 * face.advance(*glyph) as f32]);
    }
    widths.finish();
    cid.finish();
    let [ascent, descent, capitals, slant] = face.metrics();
    let [left, low, right, high] = face.extent().map(|em| 1000.0 * em as f32);
    let flags = FontFlags::NON_SYMBOLIC | if slant == 0.0 { FontFlags::empty() } else { FontFlags::ITALIC };
    pdf.font_descriptor(descriptor)
        .name(name)
        .flags(flags)
        .bbox(Rect::new(left, low, right, high))
        .italic_angle(slant as f32)
        .ascent(1000.0 * ascent as f32)
        .descent(1000.0 * descent as f32)
        .cap_height(1000.0 * capitals as f32)
        .stem_v(88.0)
        .font_file2(file);
    let mut map = UnicodeCmap::new(Name(b"Letters"), IDENTITY);
    for (glyph, letter) in letters {
        map.pair(*glyph, *letter);
    }
    pdf.cmap(unicode, &map.finish());
    let bytes = packed(face.bytes());
    let mut stream = pdf.stream(file, &bytes);
    stream.filter(Filter::FlateDecode);
    stream.pair(Name(b"Length1"), i32::try_from(face.bytes().len()).unwrap_or(i32::MAX));
}

/// The page in the operators of the format, whose y points upwards.
fn operators(drawing: &Drawing) -> Vec<u8> {
    let height = drawing.size[1];
    let mut content = Content::new();
    for item in &drawing.items {
        match item {
            Item::Path { segments, pen, fill, .. } => {
                if let Some(colour) = fill {
                    let [red, green, blue] = colour.map(|channel| f32::from(channel) / 255.0);
                    content.set_fill_rgb(red, green, blue);
                }
                if let Some(pen) = pen {
                    set_pen(&mut content, pen);
                }
                trace(&mut content, segments, height);
                match (pen, fill) {
                    (Some(_), Some(_)) => content.fill_nonzero_and_stroke(),
                    (Some(_), None) => content.stroke(),
                    (None, _) => content.fill_nonzero(),
                };
            }
            Item::Text { text, at, is_turned } => {
                content.set_fill_rgb(0.0, 0.0, 0.0);
                write(&mut content, text, [at[0], height - at[1]], *is_turned);
            }
        }
    }
    content.finish().into_vec()
}

fn set_pen(content: &mut Content, pen: &Pen) {
    let [red, green, blue] = pen.colour.map(|channel| f32::from(channel) / 255.0);
    content.set_stroke_rgb(red, green, blue).set_line_width(pen.width as f32);
    content.set_line_join(pdf_writer::types::LineJoinStyle::RoundJoin);
    content.set_dash_pattern(pen.dashes.iter().map(|length| *length as f32), 0.0);
}

fn trace(content: &mut Content, segments: &[Segment], height: f64) {
    let flipped = |[x, y]: [f64; 2]| [x as f32, (height - y) as f32];
    let mut last = [0.0; 2];
    for segment in segments {
        match *segment {
            Segment::Move(to) => {
                let [x, y] = flipped(to);
                content.move_to(x, y);
                last = to;
            }
            Segment::Line(to) => {
                let [x, y] = flipped(to);
                content.line_to(x, y);
                last = to;
            }
            Segment::Bend(by, to) => {
                // The same curve with two control points.
                let towards = |from: [f64; 2]| [0, 1].map(|k| from[k] + 2.0 / 3.0 * (by[k] - from[k]));
                let [[x1, y1], [x2, y2], [x, y]] = [towards(last), towards(to), to].map(flipped);
                content.cubic_to(x1, y1, x2, y2, x, y);
                last = to;
            }
            Segment::Curve(points) => {
                let [[x1, y1], [x2, y2], [x, y]] = points.map(flipped);
                content.cubic_to(x1, y1, x2, y2, x, y);
                last = points[2];
            }
            Segment::Close => {
                content.close_path();
            }
        }
    }
}

/// Writes a text: glyphs of one face, size and height at a time.
fn write(content: &mut Content, text: &LaidText, at: [f64; 2], is_turned: bool) {
    let turned = |[along, up]: [f64; 2]| match is_turned {
        false => [at[0] + along, at[1] + up],
        true => [at[0] - up, at[1] + along],
    };
    let matrix = if is_turned { [0.0, 1.0, -1.0, 0.0] } else { [1.0, 0.0, 0.0, 1.0] };
    for run in text.glyphs.chunk_by(|a, b| a.face == b.face && a.size == b.size && a.at[1] == b.at[1]) {
        let start = turned(run[0].at).map(|x| x as f32);
        let glyphs: Vec<u8> = run.iter().flat_map(|glyph| glyph.glyph.to_be_bytes()).collect();
        content.begin_text().set_font(Name(short(run[0].face)), run[0].size as f32);
        content.set_text_matrix([matrix[0], matrix[1], matrix[2], matrix[3], start[0], start[1]]);
        content.show(Str(&glyphs)).end_text();
    }
    for [left, low, right, high] in &text.bars {
        let corners = [[*left, *low], [*right, *low], [*right, *high], [*left, *high]].map(turned);
        let [[x, y], rest @ ..] = corners.map(|corner| corner.map(|x| x as f32));
        content.move_to(x, y);
        for [x, y] in rest {
            content.line_to(x, y);
        }
        content.close_path().fill_nonzero();
    }
}
