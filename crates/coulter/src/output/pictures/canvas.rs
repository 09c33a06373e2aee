//! An image to draw on, written as a PNG file. It is drawn at twice the size and scaled down, which smooths edges.

use crate::output::files::OutputError;
use crate::output::plots::Rgb;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontTransform, register_font};
use std::io::Write as _;
use std::path::Path;
use std::sync::OnceLock;

/// Supersampling: every pixel of the file is drawn as a square of this many pixels.
const SUPERSAMPLING: usize = 2;
const FONT: &[u8] = include_bytes!("../../../assets/DejaVuSans-subset.ttf");

/// How a text is aligned to its position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Left,
    Centre,
    Right,
    /// Rotated upwards, centred.
    Upwards,
}

/// An image being drawn. Positions are in pixels of the file, from the top left corner.
pub(super) struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<u8>,
}

impl Canvas {
    /// A white image.
    pub(super) fn new(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![255; 3 * width * height * SUPERSAMPLING * SUPERSAMPLING] }
    }

    /// Colours the pixels of a box by a function of the position; `None` leaves a pixel as it is.
    pub(super) fn paint(
        &mut self,
        [left, top, right, bottom]: [f64; 4],
        colour: impl Fn(f64, f64) -> Option<Rgb>,
    ) {
        let factor = SUPERSAMPLING as f64;
        let clip = |v: f64, most: usize| ((v * factor).round().max(0.0) as usize).min(most * SUPERSAMPLING);
        let row = self.width * SUPERSAMPLING;
        for y in clip(top, self.height)..clip(bottom, self.height) {
            for x in clip(left, self.width)..clip(right, self.width) {
                if let Some(rgb) = colour((x as f64 + 0.5) / factor, (y as f64 + 0.5) / factor) {
                    self.pixels[3 * (y * row + x)..][..3].copy_from_slice(&rgb);
                }
            }
        }
    }

    /// Draws a line through points.
    pub(super) fn line(&mut self, points: &[[f64; 2]], colour: Rgb, width: f64) {
        let factor = SUPERSAMPLING as f64;
        let path: Vec<(i32, i32)> = points
            .iter()
            .filter(|p| p[0].is_finite() && p[1].is_finite())
            .map(|p| ((p[0] * factor).round() as i32, (p[1] * factor).round() as i32))
            .collect();
        let style =
            RGBColor(colour[0], colour[1], colour[2]).stroke_width((width * factor).round().max(1.0) as u32);
        self.draw(|area| {
            // The backend clips what lies outside the image; nothing else can fail.
            let _ = area.draw(&PathElement::new(path, style));
        });
    }

    /// Draws a dashed horizontal line.
    pub(super) fn dashes(&mut self, [from, to]: [f64; 2], y: f64, colour: Rgb) {
        let mut x = from;
        while x < to {
            self.line(&[[x, y], [(x + 7.0).min(to), y]], colour, 1.0);
            x += 12.0;
        }
    }

    /// Writes a text of `size` pixels.
    pub(super) fn text(&mut self, text: &str, [x, y]: [f64; 2], size: f64, anchor: Anchor) {
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
        let style = TextStyle::from(font).color(&RGBColor(30, 30, 30)).pos(Pos::new(across, VPos::Center));
        let position = ((x * factor).round() as i32, (y * factor).round() as i32);
        self.draw(|area| {
            // A character that the font lacks is left out.
            let _ = area.draw_text(text, &style, position);
        });
    }

    fn draw(&mut self, action: impl FnOnce(&DrawingArea<BitMapBackend<'_>, plotters::coord::Shift>)) {
        let size = ((self.width * SUPERSAMPLING) as u32, (self.height * SUPERSAMPLING) as u32);
        let area = BitMapBackend::with_buffer(&mut self.pixels, size).into_drawing_area();
        action(&area);
    }

    /// Writes the image as a PNG file.
    pub(super) fn write(&self, path: &Path) -> Result<(), OutputError> {
        crate::output::files::write_whole(path, &self.png())
    }

    /// The image as the bytes of a PNG file.
    fn png(&self) -> Vec<u8> {
        let mut lines = Vec::with_capacity((3 * self.width + 1) * self.height);
        for y in 0..self.height {
            lines.push(0);
            for x in 0..self.width {
                lines.extend(self.mean(x, y));
            }
        }
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
    fn mean(&self, x: usize, y: usize) -> Rgb {
        let row = self.width * SUPERSAMPLING;
        std::array::from_fn(|channel| {
            let sample = |n: usize| {
                let (dx, dy) = (n % SUPERSAMPLING, n / SUPERSAMPLING);
                usize::from(
                    self.pixels[3 * ((y * SUPERSAMPLING + dy) * row + x * SUPERSAMPLING + dx) + channel],
                )
            };
            let count = SUPERSAMPLING * SUPERSAMPLING;
            (((0..count).map(sample).sum::<usize>() + count / 2) / count) as u8
        })
    }
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
