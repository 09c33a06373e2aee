//! Heights as the greys of a PNG image of 8 or 16 bits.

use super::placement::{Placement, Raster, require_size, turned};
use crate::data_file::{FileProblem, problem};
use png::{BitDepth, ColorType, Decoder, Limits};

/// Memory that a decoder may take [bytes].
const MOST_MEMORY: usize = 64 << 20;
const GREY: &str = "save it as greys of 8 or 16 bits, without colours and transparency";

/// Reads an image.
pub(super) fn read(bytes: &[u8], placement: &Placement) -> Result<Raster, FileProblem> {
    const WHY: &str = "an image does not say where it lies";
    Placement::no_effect(placement.unit.is_some(), "unit", "`heights` has units")?;
    Placement::no_effect(placement.datum != 0.0, "datum", "`heights` counts from ground.surface")?;
    let [black, white] = Placement::needed(
        placement.heights,
        "heights",
        "an image does not say how high black and white are",
    )?;
    let broken = |error: png::DecodingError| FileProblem {
        message: format!("not a whole PNG image: {error}"),
        cure: "save the image again".to_owned(),
    };
    let mut reader =
        Decoder::new_with_limits(bytes, Limits { bytes: MOST_MEMORY }).read_info().map_err(broken)?;
    let size = [reader.info().width as usize, reader.info().height as usize];
    require_size(size)?;
    let (colour, depth) = reader.output_color_type();
    let two_bytes = match (colour, depth) {
        (ColorType::Grayscale, BitDepth::Eight) => false,
        (ColorType::Grayscale, BitDepth::Sixteen) => true,
        _ => {
            return problem(
                format!("its pixels are {colour:?} of {depth:?} bits, not grey of 8 or 16"),
                GREY,
            );
        }
    };
    let mut pixels = vec![0; reader.output_buffer_size()];
    reader.next_frame(&mut pixels).map_err(broken)?;
    let greys: Vec<f64> = if two_bytes {
        pixels
            .chunks_exact(2)
            .map(|pair| f64::from(u16::from_be_bytes([pair[0], pair[1]])) / 65535.0)
            .collect()
    } else {
        pixels.iter().map(|grey| f64::from(*grey) / 255.0).collect()
    };
    let heights: Vec<f64> = greys.iter().map(|grey| black + (white - black) * grey).collect();
    Ok(Raster { lines: placement.lines(size, WHY)?, heights: turned(&heights, size[0]) })
}
