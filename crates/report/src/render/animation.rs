//! Animated files: frames one after the other.

use gif::{DisposalMethod, Encoder, Repeat};
use results::files::{Inside, OutputError, write_with};
use std::collections::HashMap;
use std::io;

/// Colours of a palette; one more is for pixels that stay as they were.
const COLOURS: usize = 255;
/// One of so many pixels is looked at for the palette: 1 is best, 30 fastest.
const SAMPLING: i32 = 10;

/// The frames of a animation: `count` of them, each made as it is needed, as red, green and blue of every
/// pixel.
pub(super) struct Animation<'a> {
    pub(super) size: [usize; 2],
    pub(super) count: usize,
    /// How long each frame is shown [s].
    pub(super) pause: f64,
    pub(super) frame: &'a mut dyn FnMut(usize) -> Vec<u8>,
}

impl Animation<'_> {
    /// Writes a GIF: 255 colours for all frames, and of every frame only what has changed.
    pub(super) fn write_gif(self, file: &Inside) -> Result<(), OutputError> {
        let ends = [self.count - 1, 0].map(|n| (self.frame)(n));
        let mut palette = Palette::of(&ends.concat());
        let [width, height] = self.size.map(|n| n as u16);
        // Hundredths of a second; players slow down what is faster than two.
        let delay = ((100.0 * self.pause).round() as u16).max(2);
        write_with(file, |file| {
            let mut encoder = Encoder::new(io::BufWriter::new(file), width, height, &palette.colours)
                .map_err(io::Error::other)?;
            encoder.set_repeat(Repeat::Infinite).map_err(io::Error::other)?;
            let mut before: Option<Vec<u8>> = None;
            for n in 0..self.count {
                let now = palette.numbers(&(self.frame)(n));
                let mut change = changed(before.as_deref(), &now, self.size[0]);
                // The end is looked at for a while.
                change.delay = if n + 1 == self.count { delay.max(150) } else { delay };
                encoder.write_frame(&change).map_err(io::Error::other)?;
                before = Some(now);
            }
            Ok(())
        })
    }

    /// Writes an animated PNG, in full colour.
    pub(super) fn write_apng(self, file: &Inside) -> Result<(), OutputError> {
        let [width, height] = self.size.map(|n| n as u32);
        write_with(file, |file| {
            let mut encoder = png::Encoder::new(io::BufWriter::new(file), width, height);
            encoder.set_color(png::ColorType::Rgb);
            encoder.set_animated(self.count as u32, 0)?;
            encoder.set_frame_delay((1e3 * self.pause).round().clamp(10.0, 6e4) as u16, 1000)?;
            let mut writer = encoder.write_header()?;
            for n in 0..self.count {
                writer.write_image_data(&(self.frame)(n))?;
            }
            writer.finish()?;
            Ok(())
        })
    }
}

/// What has changed of a frame: the smallest box around it, in which pixels that stay are transparent.
fn changed(before: Option<&[u8]>, now: &[u8], width: usize) -> gif::Frame<'static> {
    let stays = |n: usize| before.is_some_and(|before| before[n] == now[n]);
    let (mut left, mut right, mut top, mut bottom) = (width, 0, now.len() / width, 0);
    for n in (0..now.len()).filter(|n| !stays(*n)) {
        (left, right) = (left.min(n % width), right.max(n % width));
        (top, bottom) = (top.min(n / width), bottom.max(n / width));
    }
    if left > right {
        (left, right, top, bottom) = (0, 0, 0, 0);
    }
    let pixels = (top..=bottom).flat_map(|y| (left..=right).map(move |x| y * width + x));
    let buffer: Vec<u8> = pixels.map(|n| if stays(n) { COLOURS as u8 } else { now[n] }).collect();
    gif::Frame {
        left: left as u16,
        top: top as u16,
        width: (right - left + 1) as u16,
        height: (bottom - top + 1) as u16,
        transparent: Some(COLOURS as u8),
        dispose: DisposalMethod::Keep,
        buffer: buffer.into(),
        ..gif::Frame::default()
    }
}

/// The colours of a animation, and those of its pixels that are known already.
struct Palette {
    network: color_quant::NeuQuant,
    colours: Vec<u8>,
    known: HashMap<[u8; 3], u8>,
}

impl Palette {
    fn of(pixels: &[u8]) -> Self {
        let opaque: Vec<u8> = pixels.chunks_exact(3).flat_map(|p| [p[0], p[1], p[2], 255]).collect();
        let network = color_quant::NeuQuant::new(SAMPLING, COLOURS, &opaque);
        let mut colours = network.color_map_rgb();
        colours.extend([0, 0, 0]);
        Self { network, colours, known: HashMap::new() }
    }

    /// The number of the colour of every pixel.
    fn numbers(&mut self, pixels: &[u8]) -> Vec<u8> {
        pixels
            .chunks_exact(3)
            .map(|p| {
                let colour = [p[0], p[1], p[2]];
                *self
                    .known
                    .entry(colour)
                    .or_insert_with(|| self.network.index_of(&[colour[0], colour[1], colour[2], 255]) as u8)
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_has_changed_is_kept() {
        let before = [0, 0, 0, 0, 0, 0, 0, 0, 0];
        let now = [0, 0, 0, 0, 1, 0, 0, 0, 2];
        let frame = changed(Some(&before), &now, 3);
        assert_eq!((frame.left, frame.top, frame.width, frame.height), (1, 1, 2, 2));
        assert_eq!(*frame.buffer, [1, 255, 255, 2]);
        assert_eq!(changed(Some(&before), &before, 3).buffer.len(), 1);
        assert_eq!(*changed(None, &now, 3).buffer, now);
    }
}
