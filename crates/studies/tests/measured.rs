//! Measured curves: what people type is read, what is wrong is refused with its place and a cure.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::history::columns::{FORCES, header};
use proptest::prelude::*;
use studies::measured::{ColumnChoice, Quantity, parse, read, refuse_unused};

#[test]
fn units_aliases_deviations_comments_and_settings() {
    let text = "\u{feff}# a plate in dry sand\n# set body.plate.diameter=50 mm\nDepth [mm]; force [N]; force sd [N]\n\n5; 22.1; 2\n# later\n10; −1.5e1; 3\r\n";
    let record = parse(text, "plate.csv").unwrap();
    assert_eq!(record.values(Quantity::Sinkage).unwrap(), [0.005, 0.01]);
    assert_eq!(record.values(Quantity::Vertical).unwrap(), [22.1, -15.0]);
    assert_eq!(record.channel(Quantity::Vertical).unwrap().deviations.as_deref(), Some(&[2.0, 3.0][..]));
    assert_eq!(record.settings, ["body.plate.diameter=50 mm"]);
    assert_eq!(record.abscissae().next(), Some(Quantity::Sinkage));
    let wheel =
        parse("slip [%],drag [kN],torque ± [N m],torque [N m]\n10,0.1,1,2\n20,0.2,1,3\n", "w").unwrap();
    assert_eq!(wheel.values(Quantity::Slip).unwrap(), [0.1, 0.2]);
    assert_eq!(wheel.values(Quantity::Drag).unwrap(), [100.0, 200.0]);
    assert_eq!(wheel.channel(Quantity::Torque).unwrap().deviations.as_deref(), Some(&[1.0, 1.0][..]));
}

#[test]
fn the_history_of_a_run_is_a_measured_curve() {
    let line = |first: f64| {
        let fields = FORCES.iter().enumerate();
        let field = |(n, column): (usize, &coulter::history::columns::Column<_>)| match column.name {
            // Empty at rest.
            "turn ratio" => String::new(),
            _ => format!("{}", first + n as f64),
        };
        fields.map(field).collect::<Vec<_>>().join(",")
    };
    let record = parse(&format!("{}\n{}\n{}\n", header(FORCES), line(0.0), line(1.0)), "forces.csv").unwrap();
    assert_eq!(record.rows(), 2);
    for quantity in [Quantity::Time, Quantity::Displacement, Quantity::Sinkage, Quantity::Drag] {
        assert!(record.values(quantity).is_some(), "{quantity:?}");
    }
}

/// Text, line and column of the problem, words of its message, words of its cure.
const BROKEN: [(&str, usize, usize, &str, &str); 26] = [
    ("", 1, 1, "empty", "begin with a header"),
    ("# only a comment\n", 1, 1, "empty", "begin with a header"),
    ("sinkage,vertical\n1,2\n2,3\n", 1, 1, "no unit", "sinkage [mm]"),
    ("sinkage [mm],vertical\n1,2\n2,3\n", 1, 14, "no unit", "vertical [N]"),
    ("sinkage [N],vertical [N]\n1,2\n2,3\n", 1, 1, "not a unit of a length", "[mm]"),
    ("sinkage [mm],vertical [mn]\n1,2\n2,3\n", 1, 14, "unknown unit", "[N]"),
    ("sinkage [mm],vertical [m\n1,2\n2,3\n", 1, 14, "no unit", "vertical [N]"),
    ("sinkage [mm],vertcal [N]\n1,2\n2,3\n", 1, 14, "unknown column", "did you mean `vertical`? Or say"),
    (
        "sinkage [mm],qwxyz [N]\n1,2\n2,3\n",
        1,
        14,
        "unknown column",
        "their aliases. Or say what a column is with --column",
    ),
    ("sinkage [mm], [N]\n1,2\n2,3\n", 1, 15, "without a name", "sinkage [mm]"),
    ("sinkage [mm],load [N],force [kN]\n1,2,3\n2,3,4\n", 1, 23, "second column", "leave one"),
    ("slip [mm],drag [N]\n1,2\n2,3\n", 1, 1, "plain number", "[-]"),
    ("drag [N],vertical [N]\n1,2\n2,3\n", 1, 1, "along which", "sinkage [mm]"),
    ("sinkage [mm]\n1\n2\n", 1, 1, "not a curve", "drag [N]"),
    ("sinkage [mm],vertical [N],drag sd [N]\n1,2,3\n2,3,4\n", 1, 27, "without drag itself", "add the column"),
    ("sinkage [mm],vertical [N]\n1,2\n2,x3\n", 3, 3, "\"x3\" is not a number", "12.5"),
    ("sinkage [mm];vertical [N]\n1;2.5\n2;3,5\n", 3, 3, "in two ways", "with a point"),
    ("sinkage [mm],vertical [N]\n1,2\n2,NaN\n", 3, 3, "not a finite number", "leave the line out"),
    ("sinkage [mm],vertical [N]\n1,2\n2\n", 3, 1, "1 fields, but the header has 2", "every line"),
    ("depth [mm],force [kg]\n1,2\n2,3\n", 1, 12, "a mass where a force belongs", "--column"),
    ("1,2\n2,3\n", 1, 1, "begins with numbers", "sinkage [mm]"),
    ("elevation [mm],force [N]\n130,2\n105,3\n", 1, 1, "where the surface lies", "=-sinkage"),
    ("z [mm],force [N]\n2,0\n-20,3\n", 1, 1, "may count upwards", "=-sinkage"),
    ("sinkage [mm],vertical [N]\n1,2\n2,\n", 3, 3, "empty field", "give a number"),
    ("time [s],drag [N]\n1,2\n# later\n1,3\n", 4, 1, "does not rise", "sort"),
    ("sinkage [mm],drag [N],drag sd [N]\n1,2,1\n2,3,0\n", 3, 5, "not above 0", "standard deviation"),
];

#[test]
fn what_is_wrong_is_refused_with_its_place_and_a_cure() {
    for (text, line, column, message, cure) in BROKEN {
        let error = parse(text, "broken.csv").unwrap_err();
        let first = &error.problems[0];
        assert_eq!(error.name, "broken.csv");
        // An empty text has no line to show.
        let place = if text.is_empty() { (1, 1) } else { (first.line, first.column) };
        assert_eq!(place, (line, column), "{text}: {first:?}");
        assert!(first.message.contains(message), "{text}: {}", first.message);
        assert!(first.cure.contains(cure), "{text}: {}", first.cure);
    }
}

/// Of a table that instruments write: the sinkages [m], another quantity, and words of the remarks.
fn reads(text: &str, quantity: Quantity, values: [f64; 2], remarks: &[&str]) {
    let record = parse(text, "x").unwrap_or_else(|error| panic!("{text}: {error:?}"));
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * b.abs();
    let [depths, found] = [Quantity::Sinkage, quantity].map(|q| record.values(q).unwrap());
    assert!(close(depths[0], 0.004) && close(depths[1], 0.008), "{text}: {depths:?}");
    assert!(close(found[0], values[0]) && close(found[1], values[1]), "{text}: {found:?}");
    assert_eq!(record.remarks.len(), remarks.len(), "{text}: {:?}", record.remarks);
    for (remark, words) in record.remarks.iter().zip(remarks) {
        assert!(remark.contains(words), "{text}: {remark}");
    }
}

#[test]
fn dialects_of_instruments() {
    use Quantity::{Pressure, Vertical};
    for (text, quantity, values, remarks) in [
        ("sinkage (mm),force (N)\n4,21\n8,46\n", Vertical, [21.0, 46.0], &[][..]),
        ("sinkage [mm]\tforce [N]\n4\t21\n8\t46\n", Vertical, [21.0, 46.0], &[]),
        ("sinkage [mm];force [N];\r\n4;21;\r\n8;46;\r\n", Vertical, [21.0, 46.0], &[]),
        ("sinkage;force\nmm;N\n4;21\n8;46\n", Vertical, [21.0, 46.0], &[]),
        ("sinkage_mm,force_N\n4,21\n8,46\n", Vertical, [21.0, 46.0], &[]),
        ("depth / cm;Force / kN\n0,4;0,021\n0,8;0,046\n", Vertical, [21.0, 46.0], &["decimal commas"]),
        ("depth [mm],force [kgf]\n4,2\n8,4\n", Vertical, [19.6133, 39.2266], &[]),
        ("depth [mm],force [lbf]\n4,1\n8,2\n", Vertical, [4.4482216152605, 8.896443230521], &[]),
        ("depth [mm],cone_resistance [psi]\n4,1\n8,2\n", Pressure, [6894.757293168, 13789.514586336], &[]),
        (
            "depth [m],qc [MPa],fs [kPa]\n0.004,1,2\n0.008,2,3\n",
            Pressure,
            [1e6, 2e6],
            &["\"fs [kPa]\" left out: not known"],
        ),
        (
            "depth [m],qc [MPa],u [kPa]\n0.004,1,2\n0.008,2,3\n",
            Pressure,
            [1e6, 2e6],
            &["\"u [kPa]\" left out"],
        ),
        (
            "depth [mm],force [N],comment\n4,21,start\n8,46,\n",
            Vertical,
            [21.0, 46.0],
            &["\"comment\" left out: text"],
        ),
        (
            "depth [mm],force [N],comment\n4,21,start\n8,46\n",
            Vertical,
            [21.0, 46.0],
            &["\"comment\" left out: text"],
        ),
        ("depth [mm],,force [N]\n-4,,21\n-8,,46\n", Vertical, [21.0, 46.0], &["counts upwards"]),
        ("z [mm],force [N]\n-4,21\n-8,46\n", Vertical, [21.0, 46.0], &["counts upwards"]),
        ("elevation [mm],force [N]\n-4,21\n-8,46\n", Vertical, [21.0, 46.0], &["counts upwards"]),
    ] {
        reads(text, quantity, values, remarks);
    }
}

#[test]
fn columns_may_be_named_on_the_command_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.csv");
    std::fs::write(&path, "way [mm],Fz,load cell [V],z [mm]\n4,-21,1,0\n8,-46,2,1\n").unwrap();
    let choices = |typed: &[&str]| typed.iter().map(|t| ColumnChoice::parse(t).unwrap()).collect::<Vec<_>>();
    let all = choices(&["way [mm]=sinkage", "Fz=-vertical [N]", "load cell=-", "z=-"]);
    let record = read(&path, &all).unwrap();
    assert_eq!(record.values(Quantity::Sinkage).unwrap(), [0.004, 0.008]);
    assert_eq!(record.values(Quantity::Vertical).unwrap(), [21.0, 46.0]);
    assert!(record.remarks.is_empty(), "{:?}", record.remarks);
    assert!(refuse_unused(&all, [&record].into_iter()).is_ok());
    let other = choices(&["qc=pressure"]);
    assert!(refuse_unused(&other, [&record].into_iter()).unwrap_err().contains("\"way [mm]\""));
    let by_number = read(&path, &choices(&["1=sinkage", "2=force [kN]", "4=-"])).unwrap();
    assert_eq!(by_number.values(Quantity::Vertical).unwrap(), [-21e3, -46e3]);
    let error = read(&path, &choices(&["way=sinkage", "Fz=vertical", "z=-"])).unwrap_err();
    assert!(error.problems[0].message.contains("has no unit"), "{error:?}");
    for (typed, why) in [
        ("way", "no `=`"),
        ("way=", "are needed"),
        ("way=sinkag", "did you mean `sinkage`?"),
        ("way=sinkage [N]", "not a unit of a length"),
        ("way=sinkage [mm", "open"),
    ] {
        assert!(ColumnChoice::parse(typed).unwrap_err().contains(why), "{typed}");
    }
}

#[test]
fn one_line_of_numbers_is_no_curve() {
    let error = parse("sinkage [mm],drag [N]\n1,2\n", "x").unwrap_err();
    assert!(error.problems[0].message.contains("1 lines"), "{error:?}");
}

#[test]
fn files_that_cannot_be_read_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |name: &str, content: Option<&[u8]>| {
        let path = folder.path().join(name);
        if let Some(content) = content {
            std::fs::write(&path, content).unwrap();
        }
        let error = read(&path, &[]).unwrap_err();
        assert!(!error.problems[0].cure.is_empty());
        error.problems[0].message.clone()
    };
    assert!(refused("missing.csv", None).contains("missing.csv"));
    assert!(
        refused("latin.csv", Some(b"sinkage [mm],drag [N]\n1,2\n2,\xe9\n")).contains("\"é\" is not a number")
    );
    assert!(refused("sheet.csv", Some(b"PK\x03\x04")).contains("a spreadsheet"));
    let large = vec![b'1'; usize::try_from(studies::measured::MAX_BYTES).unwrap() + 1];
    assert!(refused("large.csv", Some(&large)).contains("at most"));
    assert!(read(folder.path(), &[]).unwrap_err().problems[0].message.contains("not an ordinary file"));
}

#[test]
fn many_problems_are_reported_at_once() {
    let text = format!("sinkage [mm],drag [N]\n{}", "a,b\n".repeat(1000));
    let error = parse(&text, "x").unwrap_err();
    assert!(error.problems.len() == 20 && error.unseen > 0);
}

proptest! {
    #[test]
    fn no_text_causes_a_panic(text in "\\PC{0,80}") {
        let _ = parse(&text, "x");
    }

    #[test]
    fn no_garbled_file_causes_a_panic(
        text in "(sinkage|drag|time|force sd|±|é)?( ?\\[(mm|N|s|-|°)?\\]?)?[,;\n](drag|u|\"t\")? ?(\\[N\\]|\\[m\\])?\n([0-9.,;eé−\"#-]{0,12}\n){0,4}"
    ) {
        let _ = parse(&text, "x");
    }
}
