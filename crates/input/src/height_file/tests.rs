//! Every format gives the heights that were written into it, and says what is wrong with a broken file.

use super::*;
use geometry::relief::Relief;
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
        ("x [m],y [m],z [m]\r\n0,0,0\r\n0,1,-9999\r\n", "line 3: is -9999 a mark for no height?"),
        ("x [m];y [m];z [m]\r0,5;0,5;0,1\r0,5;1;\r", "line 3: an empty field"),
        ("x [m],y [m],z [m]\n0,0,0\n", "1 × 1 points"),
        ("x [m],y [m],z [m]\n0,0,0\n0,1,0\n", "1 × 2 points"),
        ("x [m],y [m],z [m]\n0,0,0\n0,1,0\n1,0,nan\n1,1,0\n", "line 4: \"nan\""),
        ("x [m],y [m],z [m]\n0,0,0\n0,1,0\n1,0,\n1,1,0\n", "line 4: an empty field"),
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
    refused("map.stl", b"1,2\n", none, "extension");
    refused("map.csv", b"1,2\n3,-32768\n", OVER_A_METRE, "column 2, row 2 from the top: is -32768 a mark");
    let found = HeightFile::load(Path::new("/nowhere"), "map.csv", &none).unwrap_err();
    assert!(found.message.contains("cannot be read"), "{found:?}");
}

#[test]
fn dialects_of_a_map_read_to_the_same_heights() {
    for (name, text) in [
        (
            "a.csv",
            "\u{feff}x [m];y [m];z [mm]\r\n0,0;0,0;4,4\r\n0,5;0,0;-1,4\r\n0,0;0,5;2,0\r\n0,5;0,5;3,0\r\n",
        ),
        ("a.csv", "x (m)\ty (m)\tz (mm)\r0.0\t0.0\t4.4\r0.5\t0.0\t-1.4\r0.0\t0.5\t2.0\r0.5\t0.5\t3.0\r"),
        (
            "a.txt",
            "# a scan\nx,y,z,quality\nm,m,mm,\n0,0,4.4,good\n0.5,0,-1.4,good\n0,0.5,2,\n0.5,0.5,3,bad\n",
        ),
        ("a.xyz", "0 0 0.0044\n0.5 0 -0.0014\n0 0.5 0.002\n0.5 0.5 0.003\n"),
        ("a.xyz", "X Y Z\n0 0 0.0044\n0.5 0 -0.0014\n0 0.5 0.002\n0.5 0.5 0.003\n"),
        ("a.asc", "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 0.5\n0.002 0.003\n0.0044 -0.0014\n"),
        (
            "a.asc",
            "NCOLS 2\r\nNROWS 2\r\nXLLCORNER -0,25\r\nYLLCORNER -0,25\r\nDX 0,5\r\nDY 0,5\r\nNODATA_VALUE -9999\r\n0,002 0,003 0,0044\r\n-0,0014\r\n",
        ),
    ] {
        let file = load(name, text.as_bytes(), Placement::default())
            .unwrap_or_else(|error| panic!("{text}: {error:?}"));
        assert_eq!([file.heights().ends(0), file.heights().ends(1)], [[0.0, 0.5]; 2], "{text}");
        close(height(&file, [0.0, 0.0]), 0.0044);
        close(height(&file, [0.5, 0.0]), -0.0014);
        close(height(&file, [0.0, 0.5]), 0.002);
        let is_said = |words: &str| file.remarks().iter().any(|remark| remark.contains(words));
        assert_eq!(is_said("decimal commas"), text.contains("4,4") || text.contains("0,002"), "{text}");
        assert_eq!(is_said("taken as metres"), !name.ends_with("csv") && !name.ends_with("txt"), "{text}");
    }
}

#[test]
fn an_esri_grid_lies_where_its_header_says() {
    const GRID: &str =
        "ncols 3\nnrows 2\nxllcorner 100\nyllcorner 200\ncellsize 10\nNODATA_value -1\n4 5 6\n1 2 3\n";
    let placement =
        Placement { unit: Some(0.01), origin: Some([1.05, 2.05]), datum: 0.01, ..Placement::default() };
    let file = load("map.asc", GRID.as_bytes(), placement).unwrap();
    assert_eq!(file.heights().size(), [3, 2]);
    close(file.heights().ends(0)[1], 0.2);
    close(height(&file, [0.0, 0.0]), 0.0);
    close(height(&file, [0.2, 0.1]), 0.05);
    let none = Placement::default();
    for (from, to, expected) in [
        ("2 3", "2 -1", "line 8: column 3, row 2 from the top: no height (NODATA_value -1)"),
        ("2 3", "2 nan", "line 8: \"nan\" is not a finite number"),
        ("2 3", "2 -9999", "is -9999 a mark for no height?"),
        ("2 3", "2", "not the 3 × 2 heights"),
        ("2 3", "2 3 4", "more than the 3 × 2 heights"),
        ("2 3", "2 x", "line 8: \"x\" is not a number"),
        ("nrows 2\n", "", "not that of an ESRI grid"),
        ("cellsize 10", "cellsize 0", "no size"),
        ("cellsize", "cell", "line 5: \"cell\" is not known"),
        ("ncols 3", "ncols 1e8", "at most"),
        ("ncols 3", "ncols -3", "not that of an ESRI grid"),
    ] {
        refused("map.asc", GRID.replace(from, to).as_bytes(), none, expected);
    }
    refused("map.asc", GRID.as_bytes(), OVER_A_METRE, "height_map.x has no effect");
}

/// Points at places that lie on no grid, over −0.6 to 0.6 by −0.5 to 0.5 m.
fn survey(count: u32, height: impl Fn(f64, f64) -> f64) -> String {
    // Additive recurrence: even and without repetition.
    let place = |n: u32, step: f64| (f64::from(n) * step).fract();
    let line = |n: u32| {
        let (x, y) = (1.2 * place(n, 0.754_877_666) - 0.6, place(n, 0.569_840_290) - 0.5);
        format!("{x:.5},{y:.5},{:.6}\n", height(x, y))
    };
    format!("x [m],y [m],z [m]\n{}", (0..count).map(line).collect::<String>())
}

#[test]
fn scattered_points_are_triangulated() {
    let plane = survey(2500, |x, y| 0.1 + 0.2 * x - 0.3 * y);
    let file = load("survey.csv", plane.as_bytes(), Placement::default()).unwrap();
    for place in [[0.0, 0.0], [0.4, 0.3], [-0.4, -0.3], [0.55, -0.45]] {
        assert!((height(&file, place) - (0.1 + 0.2 * place[0] - 0.3 * place[1])).abs() < 2e-5, "{place:?}");
    }
    let ends = [file.heights().ends(0), file.heights().ends(1)];
    assert!(ends[0][0] < -0.56 && ends[0][1] > 0.56 && ends[1][0] < -0.46 && ends[1][1] > 0.46, "{ends:?}");
    let remark = &file.remarks()[0];
    assert!(
        remark.contains("2500 points lie on no grid: triangulated") && !remark.contains("gaps"),
        "{remark}"
    );
    let waves =
        load("survey.csv", survey(2500, |x, _| 0.02 * (6.0 * x).sin()).as_bytes(), Placement::default());
    assert!((height(&waves.unwrap(), [0.2, 0.1]) - 0.02 * 1.2_f64.sin()).abs() < 2e-4);
    let holed: String = plane
        .lines()
        .filter(|line| !(line.starts_with("0.1") || line.starts_with("0.2")))
        .map(|line| format!("{line}\n"))
        .collect();
    let file = load("survey.csv", holed.as_bytes(), Placement::default()).unwrap();
    assert!(file.remarks()[0].contains("there are gaps"), "{:?}", file.remarks());
    let twice = format!("{plane}{}\n", plane.lines().nth(1).unwrap());
    refused("survey.csv", twice.as_bytes(), Placement::default(), "line 2502: a second height");
    let line: String = (0..50).map(|n| format!("{n},{n},0\n")).collect();
    refused("line.xyz", line.as_bytes(), Placement::default(), "all on one line");
    refused("line.xyz", b"0,0,0\n1,2,0\n5,3,0\n", Placement::default(), "all on one line");
}

#[test]
fn a_height_far_from_all_others_is_doubted_in_any_format() {
    let pixels = [0.01_f32, 0.02, -32768.0, 0.01, 0.02, 0.03];
    let image = tiff::<colortype::Gray32Float>(&pixels, &[], 1);
    let placement = Placement { unit: Some(1.0), ..OVER_A_METRE };
    refused("map.tif", &image, placement, "is -32768 a mark for no height?");
    let points = "x [m],y [m],z [cm]\n0,0,1\n0,1,1\n1,0,2\n1,1,-12345\n";
    refused("map.csv", points.as_bytes(), Placement::default(), "x = 1 m, y = 1 m (in the case)");
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
