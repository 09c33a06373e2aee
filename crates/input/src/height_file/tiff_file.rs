//! Heights as the pixels of a TIFF image, which may say where it lies (GeoTIFF).

use super::geo_keys::GeoKeys;
use super::placement::{Placement, Raster, require_size, turned};
use crate::data_file::{FileProblem, problem};
use std::io::Cursor;
use tiff::TiffError;
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;

/// Memory that the pixels may take [bytes].
const MOST_MEMORY: usize = 64 << 20;

type Image = Decoder<Cursor<Vec<u8>>>;

/// Reads an image; with what is to be said of it.
pub(super) fn read(bytes: Vec<u8>, placement: &Placement) -> Result<(Raster, Vec<String>), FileProblem> {
    const WHY: &str = "this image does not say where it lies";
    Placement::no_effect(placement.heights.is_some(), "heights", "the pixels of a TIFF image are heights")?;
    let mut limits = Limits::default();
    limits.decoding_buffer_size = MOST_MEMORY;
    let mut image = Decoder::new(Cursor::new(bytes)).map_err(broken)?.with_limits(limits);
    let keys = GeoKeys::of(&mut image);
    let scale = unit_of_heights(placement, &keys)?;
    let [factor, summand] = keys.scaling()?;
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
    let heights: Vec<f64> = pixels.iter().map(|z| scale * (factor * z + summand) - placement.datum).collect();
    let (lines, remark) = match geography(&mut image, &keys)? {
        Some((places, remark)) => {
            placement.knows_places()?;
            (places.lines(size, placement.origin.unwrap_or_default()), remark)
        }
        None => (placement.lines(size, WHY)?, None),
    };
    Ok((Raster { lines, heights: turned(&heights, size[0]) }, remark.into_iter().collect()))
}

/// The unit of the heights [m]: that of the case, which must be that of the file if this states one.
fn unit_of_heights(placement: &Placement, keys: &GeoKeys) -> Result<f64, FileProblem> {
    // A foot and one of the US survey count as the same.
    const SAME: f64 = 1e-5;
    match (placement.unit, keys.vertical_unit()?) {
        (Some(unit), Some(own)) if (unit / own.metres - 1.0).abs() > SAME => problem(
            format!("the unit of its heights is {}, that of height_map.unit is {unit} m", own.name),
            "remove `unit`; if the file is wrong about itself, correct it there",
        ),
        (_, Some(own)) => Ok(own.metres),
        (unit, None) => Placement::needed(unit, "unit", "the image does not name the unit of its heights"),
    }
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

/// Where the image says that it lies, if it does, and what is to be said of that.
fn geography(image: &mut Image, keys: &GeoKeys) -> Result<Option<(Geography, Option<String>)>, FileProblem> {
    let numbers = |image: &mut Image, tag| image.get_tag_f64_vec(tag).ok();
    let (scale, tie) = (numbers(image, Tag::ModelPixelScaleTag), numbers(image, Tag::ModelTiepointTag));
    keys.require_projected()?;
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
    let half = if keys.places_are_middles() { 0.0 } else { 0.5 };
    let (unit, remark) = keys.unit()?;
    let metres = |lengths: [f64; 2]| lengths.map(|length| unit.metres * length);
    let first = metres([x + (half - i) * dx, y - (half - j) * dy]);
    Ok(Some((Geography { first, pixel: metres([*dx, *dy]) }, remark)))
}
