//! An image to draw on, and the PNG file it becomes. Drawn at twice the size and scaled down: smooth edges.

use super::colour::Rgb;
use super::error::OutputError;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontTransform, register_font};
use std::io::Write as _;
use std::path::Path;
use std::sync::OnceLock;

/// Every pixel of the file is drawn as a square of so many.
const FINER: usize = 2;
const FONT: &[u8] = include_bytes!("../../assets/DejaVuSans-subset.ttf");

/// Where a text is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Anchor {
    Left,
    Centre,
    Right,
    /// Turned upwards, centred.
    Upwards,
}

/// An image under work. Positions are in pixels of the file, from the top left corner.
pub(super) struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<u8>,
}

impl Canvas {
    /// A white image.
    pub(super) fn new(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![255; 3 * width * height * FINER * FINER] }
    }

    /// Colours the pixels of a box by a function of the position; `None` leaves a pixel as it is.
    pub(super) fn paint(
        &mut self,
        [left, top, right, bottom]: [f64; 4],
        colour: impl Fn(f64, f64) -> Option<Rgb>,
    ) {
        let finer = FINER as f64;
        let clip = |v: f64, most: usize| ((v * finer).round().max(0.0) as usize).min(most * FINER);
        let row = self.width * FINER;
        for y in clip(top, self.height)..clip(bottom, self.height) {
            for x in clip(left, self.width)..clip(right, self.width) {
                if let Some(rgb) = colour((x as f64 + 0.5) / finer, (y as f64 + 0.5) / finer) {
                    self.pixels[3 * (y * row + x)..][..3].copy_from_slice(&rgb);
                }
            }
        }
    }

    /// Draws a line through points.
    pub(super) fn line(&mut self, points: &[[f64; 2]], colour: Rgb, width: f64) {
        let finer = FINER as f64;
        let path: Vec<(i32, i32)> = points
            .iter()
            .filter(|p| p[0].is_finite() && p[1].is_finite())
            .map(|p| ((p[0] * finer).round() as i32, (p[1] * finer).round() as i32))
            .collect();
        let style =
            RGBColor(colour[0], colour[1], colour[2]).stroke_width((width * finer).round().max(1.0) as u32);
        self.draw(|area| {
            // What lies outside the image is cut off by the backend; there is nothing else that can fail.
            let _ = area.draw(&PathElement::new(path, style));
        });
    }

    /// Draws a dashed level line.
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
        let finer = FINER as f64;
        let (across, turn) = match anchor {
            Anchor::Left => (HPos::Left, FontTransform::None),
            Anchor::Centre => (HPos::Center, FontTransform::None),
            Anchor::Right => (HPos::Right, FontTransform::None),
            Anchor::Upwards => (HPos::Center, FontTransform::Rotate270),
        };
        let font = ("sans-serif", size * finer).into_font().transform(turn);
        let style = TextStyle::from(font).color(&RGBColor(30, 30, 30)).pos(Pos::new(across, VPos::Center));
        let place = ((x * finer).round() as i32, (y * finer).round() as i32);
        self.draw(|area| {
            // A letter that the font lacks is left out; the picture is worth more than the letter.
            let _ = area.draw_text(text, &style, place);
        });
    }

    fn draw(&mut self, action: impl FnOnce(&DrawingArea<BitMapBackend<'_>, plotters::coord::Shift>)) {
        let size = ((self.width * FINER) as u32, (self.height * FINER) as u32);
        let area = BitMapBackend::with_buffer(&mut self.pixels, size).into_drawing_area();
        action(&area);
    }

    /// Writes the image as a PNG file.
    pub(super) fn write(&self, path: &Path) -> Result<(), OutputError> {
        super::error::write_whole(path, &self.png())
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

    fn mean(&self, x: usize, y: usize) -> Rgb {
        let row = self.width * FINER;
        std::array::from_fn(|channel| {
            let part = |n: usize| {
                let (dx, dy) = (n % FINER, n / FINER);
                usize::from(self.pixels[3 * ((y * FINER + dy) * row + x * FINER + dx) + channel])
            };
            let count = FINER * FINER;
            (((0..count).map(part).sum::<usize>() + count / 2) / count) as u8
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
