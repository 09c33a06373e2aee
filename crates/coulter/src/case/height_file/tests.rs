//! Every format gives the heights that were written into it, and says what is wrong with a broken file.

use super::*;
use solver::relief::Relief;
use std::io::Cursor;
use tiff::encoder::{TiffEncoder, colortype};
use tiff::tags::Tag;

fn load(name: &str, content: &[u8], placement: Placement) -> Result<HeightFile, FileProblem> {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(name), content).unwrap();
    HeightFile::load(folder.path(), name, &placement)
}

fn refused(name: &str, content: &[u8], placement: Placement, expected: &str) {
    let found = load(name, content, placement).unwrap_err();
    assert!(found.message.contains(expected), "{name}: {found:?}, not {expected}");
    assert!(!found.cure.is_empty());
}

fn height(file: &HeightFile, place: [f64; 2]) -> f64 {
    Relief { map: Some(file.heights().clone()), furrows: None }.at(place)
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-9, "{a}, not {b}");
}

const OVER_A_METRE: Placement = Placement {
    unit: Some(1.0),
    ends: [Some([0.0, 1.0]), Some([0.0, 1.0])],
    heights: None,
    origin: None,
    datum: 0.0,
};

#[test]
fn columns_of_points_in_any_order() {
    let text = "# surveyed\ny [cm]; z [mm]; x [m]\n0; 10; 2\n0; 0; 1\n50; 30; 2\n50; 20; 1\n";
    let placement = Placement { origin: Some([1.0, 0.0]), datum: 0.005, ..Placement::default() };
    let file = load("map.csv", text.as_bytes(), placement).unwrap();
    assert_eq!(file.heights().ends(0), [0.0, 1.0]);
    close(height(&file, [0.5, 0.25]), 0.015 - 0.005);
    close(height(&file, [1.0, 0.0]), 0.010 - 0.005);
}

#[test]
fn a_grid_begins_with_the_largest_y() {
    let file = load("map.csv", b"3,4\n1,2\n", Placement { unit: Some(1e-3), ..OVER_A_METRE }).unwrap();
    close(height(&file, [0.0, 0.0]), 0.001);
    close(height(&file, [1.0, 1.0]), 0.004);
}

#[test]
fn what_is_wrong_with_a_table_is_said_with_its_line() {
    let none = Placement::default();
    for (text, expected) in [
        ("", "empty"),
        ("# nothing\n\n", "empty"),
        ("x [m],y [m]\n0,0\n", "names no column z"),
        ("x,y,z\n0,0,0\n", "names no unit of length"),
        ("x [m],y [m],z [kg]\n0,0,0\n", "names no unit of length"),
        ("x [m],y [m],z [m]\n", "0 × 0 points"),
        ("x [m],y [m],z [m]\n0,0,0\n", "1 × 1 points"),
        ("x [m],y [m],z [m]\n0,0,0\n0,1,0\n", "1 × 2 points"),
        ("x [m],y [m],z [m]\n0,0,0\n0,1,0\n1,0,nan\n1,1,0\n", "line 4: \"nan\""),
        ("x [m],y [m],z [m]\n0,0,0\n0,1,0\n1,0,\n1,1,0\n", "line 4: \"\""),
        ("x [m],y [m],z [m]\n0,0,0\n0,1\n", "line"),
        ("x [m],y [m],z [m]\n0,0,0\n0,1,0\n1,0,0\n", "x = 1.000000 m, y = 1.000000 m"),
        ("x [m],y [m],z [m]\n0,0,0\n0,1,0\n1,0,0\n1,1,0\n1,1,0\n", "line 6: a second height"),
    ] {
        refused("map.csv", text.as_bytes(), none, expected);
    }
    refused("map.csv", b"1,2\n3,4\n", none, "height_map.unit is not given");
    refused("map.csv", b"1,2\n3,4\n", Placement { unit: Some(1.0), ..none }, "height_map.x is not given");
    refused("map.csv", b"1,2\n3\n", OVER_A_METRE, "fields");
    refused("map.csv", b"1\n", OVER_A_METRE, "1 × 1 points");
    refused("map.csv", b"x [m],y [m],z [m]\n0,0,0\n", OVER_A_METRE, "height_map.x has no effect");
    refused("map.csv", &[0xff, 0xfe, 0x00], none, "not a text file");
    refused("map.xyz", b"1,2\n", none, "extension");
    let found = HeightFile::load(Path::new("/nowhere"), "map.csv", &none).unwrap_err();
    assert!(found.message.contains("cannot be read"), "{found:?}");
}

fn png(colour: png::ColorType, depth: png::BitDepth, [columns, rows]: [u32; 2], pixels: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, columns, rows);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    encoder.write_header().unwrap().write_image_data(pixels).unwrap();
    bytes
}

#[test]
fn greys_of_an_image() {
    use png::{BitDepth, ColorType};
    let placement = Placement { unit: None, heights: Some([-0.1, 0.1]), ..OVER_A_METRE };
    let eight = png(ColorType::Grayscale, BitDepth::Eight, [2, 2], &[255, 0, 0, 51]);
    let file = load("map.png", &eight, placement).unwrap();
    close(height(&file, [0.0, 1.0]), 0.1);
    close(height(&file, [1.0, 0.0]), -0.06);
    let sixteen = png(ColorType::Grayscale, BitDepth::Sixteen, [2, 2], &[0, 0, 0, 0, 0xff, 0xff, 0x33, 0x33]);
    let file = load("map.png", &sixteen, placement).unwrap();
    close(height(&file, [0.0, 0.0]), 0.1);
    close(height(&file, [1.0, 0.0]), -0.06);
    refused("map.png", &png(ColorType::Rgb, BitDepth::Eight, [2, 2], &[0; 12]), placement, "not grey");
    refused("map.png", &png(ColorType::Grayscale, BitDepth::Eight, [1, 1], &[0]), placement, "1 × 1 points");
    refused("map.png", &eight[..eight.len() / 2], placement, "not a whole PNG");
    refused("map.png", b"", placement, "not a whole PNG");
    refused("map.png", &eight, OVER_A_METRE, "height_map.unit has no effect");
    refused("map.png", &eight, Placement { heights: None, ..placement }, "height_map.heights is not given");
    refused("map.png", &eight, Placement { ends: [None; 2], ..placement }, "height_map.x is not given");
    // A header that promises more pixels than are allowed.
    let mut huge = eight;
    huge[16..24].copy_from_slice(&[0x7f, 0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff]);
    assert!(load("map.png", &huge, placement).is_err());
}

/// An image of 3 × 2 pixels of a kind, with tags.
fn tiff<C: colortype::ColorType>(pixels: &[C::Inner], tags: &[(Tag, &[f64])], model: u16) -> Vec<u8>
where
    [C::Inner]: tiff::encoder::TiffValue,
{
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut bytes).unwrap();
    let mut image = encoder.new_image::<C>(3, 2).unwrap();
    for (tag, numbers) in tags {
        image.encoder().write_tag(*tag, *numbers).unwrap();
    }
    let directory: [u16; 8] = [1, 1, 0, 1, 1024, 0, 1, model];
    image.encoder().write_tag(Tag::GeoKeyDirectoryTag, &directory[..]).unwrap();
    image.write_data(pixels).unwrap();
    bytes.into_inner()
}

#[test]
fn heights_of_a_geotiff_lie_where_it_says() {
    let scale: (Tag, &[f64]) = (Tag::ModelPixelScaleTag, &[0.5, 0.25, 0.0]);
    let tie: (Tag, &[f64]) = (Tag::ModelTiepointTag, &[0.0, 0.0, 0.0, 500_000.0, 6_000_000.0, 0.0]);
    let pixels = [4.0_f32, 5.0, 6.0, 1.0, 2.0, 3.0];
    let image = tiff::<colortype::Gray32Float>(&pixels, &[scale, tie], 1);
    let placement = Placement {
        unit: Some(1e-3),
        ends: [None; 2],
        origin: Some([500_000.25, 5_999_999.625]),
        datum: 1e-3,
        ..OVER_A_METRE
    };
    let file = load("map.tif", &image, placement).unwrap();
    // The middle of the first pixel lies half a pixel from its corner.
    assert_eq!(file.heights().ends(0), [0.0, 1.0]);
    assert_eq!(file.heights().ends(1), [0.0, 0.25]);
    close(height(&file, [0.0, 0.0]), 0.0);
    close(height(&file, [1.0, 0.25]), 0.005);
    let whole = tiff::<colortype::Gray16>(&[40, 50, 60, 10, 20, 30], &[], 1);
    let file = load("map.tiff", &whole, Placement { unit: Some(1e-3), ..OVER_A_METRE }).unwrap();
    close(height(&file, [0.0, 0.0]), 0.010);
    close(height(&file, [1.0, 1.0]), 0.060);

    refused("map.tif", &image, OVER_A_METRE, "height_map.x has no effect");
    refused("map.tif", &image, Placement { unit: None, ..placement }, "height_map.unit is not given");
    refused("map.tif", &whole, Placement { ends: [None; 2], ..OVER_A_METRE }, "height_map.x is not given");
    let degrees = tiff::<colortype::Gray32Float>(&pixels, &[scale, tie], 2);
    refused("map.tif", &degrees, placement, "degrees");
    let empty = tiff::<colortype::Gray32Float>(&pixels, &[(scale.0, &[0.0, 0.0, 0.0]), tie], 1);
    refused("map.tif", &empty, placement, "no size");
    let turned = tiff::<colortype::Gray32Float>(&pixels, &[(Tag::ModelTransformationTag, &[0.0; 16])], 1);
    refused("map.tif", &turned, placement, "transformation");
    let hole = tiff::<colortype::Gray32Float>(&[1.0, f32::NAN, 1.0, 1.0, 1.0, 1.0], &[scale, tie], 1);
    refused("map.tif", &hole, placement, "column 2, row 1");
    let colours = tiff::<colortype::RGB8>(&[0; 18], &[scale, tie], 1);
    refused("map.tif", &colours, placement, "18 numbers in 3 × 2 pixels");
    for length in [0, 4, 20, image.len() / 2, image.len() - 5] {
        assert!(load("map.tif", &image[..length], placement).is_err(), "{length} bytes");
    }
}
