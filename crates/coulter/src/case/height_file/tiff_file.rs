//! Heights as the pixels of a TIFF image, which may say where it lies (GeoTIFF).

use super::placement::{Placement, Raster, require_size, turned};
use crate::case::data_file::{FileProblem, problem};
use std::io::Cursor;
use tiff::TiffError;
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;

/// Memory that the pixels may take [bytes].
const MOST_MEMORY: usize = 64 << 20;

type Image = Decoder<Cursor<Vec<u8>>>;

/// Reads an image.
pub(super) fn read(bytes: Vec<u8>, placement: &Placement) -> Result<Raster, FileProblem> {
    const WHY: &str = "this image does not say where it lies";
    Placement::no_effect(placement.heights.is_some(), "heights", "the pixels of a TIFF image are heights")?;
    let scale =
        Placement::needed(placement.unit, "unit", "a TIFF image does not name the unit of its heights")?;
    let mut limits = Limits::default();
    limits.decoding_buffer_size = MOST_MEMORY;
    let mut image = Decoder::new(Cursor::new(bytes)).map_err(broken)?.with_limits(limits);
    let (width, height) = image.dimensions().map_err(broken)?;
    let size = [width as usize, height as usize];
    require_size(size)?;
    let pixels = pixels(&mut image, size)?;
    let absent = absent(&mut image);
    let place =
        |n: usize| format!("the pixel in column {}, row {} from the top", n % size[0] + 1, n / size[0] + 1);
    let missing = |z: &f64| !z.is_finite() || absent == Some(*z);
    if let Some(n) = pixels.iter().position(missing) {
        let message = format!("{} has no height ({})", place(n), pixels[n]);
        return problem(message, "fill in what was not measured, or cut it off");
    }
    let heights: Vec<f64> = pixels.iter().map(|z| scale * z - placement.datum).collect();
    let lines = match geography(&mut image)? {
        Some(places) => {
            placement.knows_places()?;
            places.lines(size, placement.origin.unwrap_or_default())
        }
        None => placement.lines(size, WHY)?,
    };
    Ok(Raster { lines, heights: turned(&heights, size[0]) })
}

fn broken(error: TiffError) -> FileProblem {
    FileProblem {
        message: format!("not a whole TIFF image: {error}"),
        cure: "save the image again".to_owned(),
    }
}

/// The numbers of the pixels, row by row from the top.
fn pixels(image: &mut Image, [columns, rows]: [usize; 2]) -> Result<Vec<f64>, FileProblem> {
    fn all<T: Copy>(pixels: &[T], number: impl Fn(T) -> f64) -> Vec<f64> {
        pixels.iter().map(|pixel| number(*pixel)).collect()
    }
    let found = match image.read_image().map_err(broken)? {
        DecodingResult::U8(pixels) => all(&pixels, f64::from),
        DecodingResult::U16(pixels) => all(&pixels, f64::from),
        DecodingResult::U32(pixels) => all(&pixels, f64::from),
        DecodingResult::I8(pixels) => all(&pixels, f64::from),
        DecodingResult::I16(pixels) => all(&pixels, f64::from),
        DecodingResult::I32(pixels) => all(&pixels, f64::from),
        DecodingResult::F32(pixels) => all(&pixels, f64::from),
        DecodingResult::F64(pixels) => pixels,
        _ => {
            return problem(
                "its pixels are of a kind that is not read",
                "save it as floating-point numbers of 32 bits",
            );
        }
    };
    if found.len() != columns * rows {
        return problem(
            format!("it has {} numbers in {columns} × {rows} pixels", found.len()),
            "save it with one number per pixel: heights alone, without colours",
        );
    }
    Ok(found)
}

/// The number that stands for no height, as GDAL writes it.
fn absent(image: &mut Image) -> Option<f64> {
    image.get_tag_ascii_string(Tag::GdalNodata).ok()?.trim_end_matches('\0').trim().parse().ok()
}

/// Where an image says that it lies.
struct Geography {
    /// Position of the middle of the first pixel at the top [m].
    first: [f64; 2],
    /// Widths of a pixel [m].
    pixel: [f64; 2],
}

impl Geography {
    fn lines(&self, size: [usize; 2], origin: [f64; 2]) -> [Vec<f64>; 2] {
        let [x, y] = [self.first[0] - origin[0], self.first[1] - origin[1]];
        let across = (0..size[0]).map(|n| x + self.pixel[0] * n as f64).collect();
        let upwards = (0..size[1]).rev().map(|n| y - self.pixel[1] * n as f64).collect();
        [across, upwards]
    }
}

/// Where the image says that it lies, if it does.
fn geography(image: &mut Image) -> Result<Option<Geography>, FileProblem> {
    /// Keys of the directory: 1 of the kind of the model, which is 2 in degrees; that of the raster, which is 2 for points.
    const MODEL: u16 = 1024;
    const RASTER: u16 = 1025;
    let numbers = |image: &mut Image, tag| image.get_tag_f64_vec(tag).ok();
    let (scale, tie) = (numbers(image, Tag::ModelPixelScaleTag), numbers(image, Tag::ModelTiepointTag));
    let directory = image.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).unwrap_or_default();
    let key =
        |name: u16| directory.chunks_exact(4).skip(1).find(|entry| entry[0] == name).map(|entry| entry[3]);
    if key(MODEL) == Some(2) {
        return problem("its coordinates are degrees", "project it to metres, as of UTM");
    }
    let (Some(scale), Some(tie)) = (scale, tie) else {
        let is_turned = image.find_tag(Tag::ModelTransformationTag).is_ok_and(|tag| tag.is_some());
        if is_turned {
            return problem(
                "it is placed by a transformation (ModelTransformation)",
                "save it with ModelPixelScale and ModelTiepoint: north up",
            );
        }
        return Ok(None);
    };
    let ([dx, dy, ..], [i, j, _, x, y, ..]) = (&scale[..], &tie[..]) else {
        return problem("its ModelPixelScale or ModelTiepoint is incomplete", "save the image again");
    };
    if !(*dx > 0.0 && *dy > 0.0 && [dx, dy, i, j, x, y].iter().all(|number| number.is_finite())) {
        return problem("its pixels have no size (ModelPixelScale)", "save the image again");
    }
    let half = if key(RASTER) == Some(2) { 0.0 } else { 0.5 };
    Ok(Some(Geography { first: [x + (half - i) * dx, y - (half - j) * dy], pixel: [*dx, *dy] }))
}
