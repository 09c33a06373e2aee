//! Measured curves: what people type is read, what is wrong is refused with its place and a cure.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::history::columns::{FORCES, header};
use proptest::prelude::*;
use studies::measured::{Quantity, parse, read};

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
const BROKEN: [(&str, usize, usize, &str, &str); 22] = [
    ("", 1, 1, "empty", "begin with a header"),
    ("# only a comment\n", 1, 1, "empty", "begin with a header"),
    ("sinkage,vertical\n1,2\n2,3\n", 1, 1, "no unit", "sinkage [mm]"),
    ("sinkage [mm],vertical\n1,2\n2,3\n", 1, 14, "no unit", "vertical [N]"),
    ("sinkage [N],vertical [N]\n1,2\n2,3\n", 1, 1, "not a unit of a length", "[mm]"),
    ("sinkage [mm],vertical [mn]\n1,2\n2,3\n", 1, 14, "unknown unit", "[N]"),
    ("sinkage [mm],vertical [m\n1,2\n2,3\n", 1, 14, "no unit", "vertical [N]"),
    ("sinkage [mm],vertcal [N]\n1,2\n2,3\n", 1, 14, "unknown column", "did you mean `vertical`?"),
    ("sinkage [mm],qwxyz [N]\n1,2\n2,3\n", 1, 14, "unknown column", "known are"),
    ("sinkage [mm], [N]\n1,2\n2,3\n", 1, 15, "without a name", "sinkage [mm]"),
    ("sinkage [mm],load [N],force [kN]\n1,2,3\n2,3,4\n", 1, 23, "second column", "leave one"),
    ("slip [mm],drag [N]\n1,2\n2,3\n", 1, 1, "plain number", "[-]"),
    ("drag [N],vertical [N]\n1,2\n2,3\n", 1, 1, "along which", "sinkage [mm]"),
    ("sinkage [mm]\n1\n2\n", 1, 1, "not a curve", "drag [N]"),
    ("sinkage [mm],vertical [N],drag sd [N]\n1,2,3\n2,3,4\n", 1, 27, "without drag itself", "add the column"),
    ("sinkage [mm],vertical [N]\n1,2\n2,x3\n", 3, 3, "\"x3\" is not a number", "12.5"),
    ("sinkage [mm];vertical [N]\n1;2\n2;3,5\n", 3, 3, "not a number", "with a point"),
    ("sinkage [mm],vertical [N]\n1,2\n2,NaN\n", 3, 3, "not a finite number", "leave the line out"),
    ("sinkage [mm],vertical [N]\n1,2\n2\n", 3, 1, "1 fields, but the header has 2", "every line"),
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
        let error = read(&path).unwrap_err();
        assert!(!error.problems[0].cure.is_empty());
        error.problems[0].message.clone()
    };
    assert!(refused("missing.csv", None).contains("missing.csv"));
    assert!(refused("latin.csv", Some(b"sinkage [mm],drag [N]\n1,2\n2,\xe9\n")).contains("line 3"));
    let large = vec![b'1'; usize::try_from(studies::measured::MAX_BYTES).unwrap() + 1];
    assert!(refused("large.csv", Some(&large)).contains("at most"));
    assert!(read(folder.path()).unwrap_err().problems[0].message.contains("not an ordinary file"));
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
