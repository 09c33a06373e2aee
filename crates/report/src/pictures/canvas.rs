//! An image to draw on, written as a PNG file, and as another one for dark screens. It is drawn at twice the
//! size and scaled down, which smooths edges.

use crate::plots::Rgb;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontTransform, register_font};
use results::files::{Inside, OutputError, write_whole};
use std::io::Write as _;
use std::sync::OnceLock;

/// A colour on paper and light screens, and on dark ones.
pub(crate) type Tone = [Rgb; 2];
/// The ground of a picture; that of the page on dark screens.
const PAPER: Tone = [[255, 255, 255], [22, 25, 29]];
/// Axes and text.
pub(super) const INK: Tone = [[30, 30, 30], [214, 218, 222]];

/// Supersampling: every pixel of the file is drawn as a square of this many pixels. A fuzzer, which looks at
/// no picture, has four times the runs with one.
pub(crate) const SUPERSAMPLING: usize = if cfg!(fuzzing) { 1 } else { 2 };
const FONT: &[u8] = include_bytes!("../../assets/DejaVuSans-subset.ttf");

/// How a text is aligned to its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Anchor {
    Left,
    Centre,
    Right,
    /// Rotated upwards, centred.
    Upwards,
}

/// An image being drawn. Positions are in pixels of the file, from the top left corner.
pub(crate) struct Canvas {
    width: usize,
    height: usize,
    /// Pixels on paper, and on a dark screen.
    pixels: [Vec<u8>; 2],
}

impl Canvas {
    /// An empty image.
    pub(crate) fn new(width: usize, height: usize) -> Self {
        let count = width * height * SUPERSAMPLING * SUPERSAMPLING;
        Self { width, height, pixels: PAPER.map(|paper| paper.repeat(count)) }
    }

    /// Colours the pixels of a box by a function of the position; `None` leaves a pixel as it is.
    pub(crate) fn paint(
        &mut self,
        [left, top, right, bottom]: [f64; 4],
        colour: impl Fn(f64, f64) -> Option<Tone>,
    ) {
        let factor = SUPERSAMPLING as f64;
        let clip = |v: f64, most: usize| ((v * factor).round().max(0.0) as usize).min(most * SUPERSAMPLING);
        let row = self.width * SUPERSAMPLING;
        for y in clip(top, self.height)..clip(bottom, self.height) {
            for x in clip(left, self.width)..clip(right, self.width) {
                let Some(tone) = colour((x as f64 + 0.5) / factor, (y as f64 + 0.5) / factor) else {
                    continue;
                };
                for (pixels, rgb) in self.pixels.iter_mut().zip(tone) {
                    pixels[3 * (y * row + x)..][..3].copy_from_slice(&rgb);
                }
            }
        }
    }

    /// Draws a line through points.
    pub(super) fn line(&mut self, points: &[[f64; 2]], tone: Tone, width: f64) {
        let factor = SUPERSAMPLING as f64;
        let path: Vec<(i32, i32)> = points
            .iter()
            .filter(|p| p[0].is_finite() && p[1].is_finite())
            .map(|p| ((p[0] * factor).round() as i32, (p[1] * factor).round() as i32))
            .collect();
        let width = (width * factor).round().max(1.0) as u32;
        self.draw(tone, |area, colour| {
            // The backend clips what lies outside the image; nothing else can fail.
            let _ = area.draw(&PathElement::new(path.clone(), colour.stroke_width(width)));
        });
    }

    /// Draws a dashed horizontal line.
    pub(super) fn dashes(&mut self, [from, to]: [f64; 2], y: f64, tone: Tone) {
        let mut x = from;
        while x < to {
            self.line(&[[x, y], [(x + 7.0).min(to), y]], tone, 1.0);
            x += 12.0;
        }
    }

    /// Writes a text of `size` pixels.
    pub(crate) fn text(&mut self, text: &str, [x, y]: [f64; 2], size: f64, anchor: Anchor) {
        static READY: OnceLock<bool> = OnceLock::new();
        if !READY.get_or_init(|| register_font("sans-serif", FontStyle::Normal, FONT).is_ok()) {
            return;
        }
        let factor = SUPERSAMPLING as f64;
        let (across, rotation) = match anchor {
            Anchor::Left => (HPos::Left, FontTransform::None),
            Anchor::Centre => (HPos::Center, FontTransform::None),
            Anchor::Right => (HPos::Right, FontTransform::None),
            Anchor::Upwards => (HPos::Center, FontTransform::Rotate270),
        };
        let font = ("sans-serif", size * factor).into_font().transform(rotation);
        let style = TextStyle::from(font).pos(Pos::new(across, VPos::Center));
        let position = ((x * factor).round() as i32, (y * factor).round() as i32);
        self.draw(INK, |area, colour| {
            // A character that the font lacks is left out.
            let _ = area.draw_text(text, &style.color(&colour), position);
        });
    }

    fn draw(
        &mut self,
        tone: Tone,
        action: impl Fn(&DrawingArea<BitMapBackend<'_>, plotters::coord::Shift>, RGBColor),
    ) {
        let size = ((self.width * SUPERSAMPLING) as u32, (self.height * SUPERSAMPLING) as u32);
        for (pixels, [red, green, blue]) in self.pixels.iter_mut().zip(tone) {
            let area = BitMapBackend::with_buffer(pixels, size).into_drawing_area();
            action(&area, RGBColor(red, green, blue));
        }
    }

    /// Writes the image as a PNG file, and the one for dark screens beside it.
    pub(super) fn write(&self, file: &Inside) -> Result<(), OutputError> {
        for (dark, file) in [(false, file), (true, &dark_variant(file))] {
            write_whole(file, &self.png(dark))?;
        }
        Ok(())
    }

    /// Red, green and blue of every pixel, of the image on paper or on a dark screen.
    pub(crate) fn rgb(&self, dark: bool) -> Vec<u8> {
        let pixels = &self.pixels[usize::from(dark)];
        let row = |y: usize| (0..self.width).flat_map(move |x| self.mean(pixels, x, y));
        (0..self.height).flat_map(row).collect()
    }

    /// The image as the bytes of a PNG file.
    pub(crate) fn png(&self, dark: bool) -> Vec<u8> {
        let rgb = self.rgb(dark);
        // Before every line stands how it was filtered: not at all.
        let lines: Vec<u8> = rgb
            .chunks_exact(3 * self.width)
            .flat_map(|line| [0].into_iter().chain(line.iter().copied()))
            .collect();
        let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
        // Writing to memory cannot fail.
        let _ = encoder.write_all(&lines);
        let mut header = Vec::new();
        header.extend((self.width as u32).to_be_bytes());
        header.extend((self.height as u32).to_be_bytes());
        // Eight bits, true colour, no interlacing.
        header.extend([8, 2, 0, 0, 0]);
        let mut png = b"\x89PNG\r\n\x1a\n".to_vec();
        push_chunk(&mut png, b"IHDR", &header);
        push_chunk(&mut png, b"IDAT", &encoder.finish().unwrap_or_default());
        push_chunk(&mut png, b"IEND", &[]);
        png
    }

    /// Mean colour of the drawn pixels that form one pixel of the file.
    fn mean(&self, pixels: &[u8], x: usize, y: usize) -> Rgb {
        let row = self.width * SUPERSAMPLING;
        std::array::from_fn(|channel| {
            let sample = |n: usize| {
                let (dx, dy) = (n % SUPERSAMPLING, n / SUPERSAMPLING);
                usize::from(pixels[3 * ((y * SUPERSAMPLING + dy) * row + x * SUPERSAMPLING + dx) + channel])
            };
            let count = SUPERSAMPLING * SUPERSAMPLING;
            (((0..count).map(sample).sum::<usize>() + count / 2) / count) as u8
        })
    }
}

/// The file of a picture for dark screens.
pub(crate) fn dark_variant(file: &Inside) -> Inside {
    file.beside(format!("{}.dark.png", file.stem()))
}

fn push_chunk(png: &mut Vec<u8>, name: &[u8; 4], data: &[u8]) {
    let mut check = flate2::Crc::new();
    check.update(name);
    check.update(data);
    png.extend((data.len() as u32).to_be_bytes());
    png.extend(name);
    png.extend(data);
    png.extend(check.sum().to_be_bytes());
}
