//! The reader of tables: every dialect of one table reads to the same numbers, a fault is found in its line
//! however lines end, and no bytes make it panic.
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use coulter::case::table_file::TableFile;
use proptest::prelude::*;

/// How a program writes a table.
#[derive(Clone, Debug)]
struct Dialect {
    separator: &'static str,
    has_comma: bool,
    is_quoted: bool,
    end: &'static str,
    trails: bool,
    brackets: usize,
    is_wide: bool,
    has_mark: bool,
}

fn dialects() -> impl Strategy<Value = Dialect> {
    let separator = prop::sample::select(vec![",", ";", "\t", "  ", " ", ", ", " ; "]);
    let end = prop::sample::select(vec!["\n", "\r\n", "\r"]);
    (separator, any::<bool>(), any::<bool>(), end, any::<bool>(), 0..3_usize, any::<bool>(), any::<bool>())
        .prop_map(|(separator, has_comma, is_quoted, end, trails, brackets, is_wide, has_mark)| Dialect {
            separator,
            // Where commas separate, a decimal comma needs quotes.
            has_comma: has_comma && (is_quoted || !separator.contains(',')),
            is_quoted: is_quoted && !separator.trim().is_empty(),
            end,
            trails: trails && !separator.trim_matches(' ').is_empty(),
            brackets,
            is_wide,
            has_mark,
        })
}

impl Dialect {
    fn number(&self, number: f64) -> String {
        let text = format!("{number:.4}");
        let text = if self.has_comma { text.replace('.', ",") } else { text };
        if self.is_quoted { format!("\"{text}\"") } else { text }
    }

    fn line(&self, fields: &[String]) -> String {
        format!(
            "{}{}{}",
            fields.join(self.separator),
            if self.trails { self.separator } else { "" },
            self.end
        )
    }

    fn header(&self) -> String {
        let names = ["time", "sinkage", "force"];
        let units = ["s", "mm", "kN/m²"];
        let joined = |open: &str, close: &str| {
            let column = |(name, unit): (&&str, &&str)| format!("{name}{open}{unit}{close}");
            self.line(&names.iter().zip(&units).map(column).collect::<Vec<_>>())
        };
        match self.brackets {
            0 => joined(" [", "]"),
            1 => joined(" (", ")"),
            _ => self.line(&names.map(str::to_owned)) + &self.line(&units.map(str::to_owned)),
        }
    }

    fn written(&self, rows: &[[f64; 3]]) -> String {
        let mut text = format!("# a comment, with: marks; in it{}{}", self.end, self.header());
        for row in rows {
            text += &self.line(&row.map(|number| self.number(number)));
            text += self.end;
        }
        text
    }

    fn bytes(&self, text: &str) -> Vec<u8> {
        if self.is_wide {
            let units = "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(u16::to_le_bytes);
            return units.collect();
        }
        let mark = if self.has_mark { "\u{feff}" } else { "" };
        format!("{mark}{text}").into_bytes()
    }
}

fn rows() -> impl Strategy<Value = Vec<[f64; 3]>> {
    let number = || (-9_000_000..9_000_000_i32).prop_map(|n| f64::from(n) / 1e4);
    prop::collection::vec([number(), number(), number()], 2..12)
}

proptest! {
    #[test]
    fn every_dialect_reads_to_the_same_numbers(dialect in dialects(), rows in rows()) {
        let table = TableFile::read(dialect.bytes(&dialect.written(&rows))).unwrap();
        let columns: Vec<_> = table.columns().iter().map(|c| (c.name.as_str(), c.unit.as_deref())).collect();
        prop_assert_eq!(&columns, &[("time", Some("s")), ("sinkage", Some("mm")), ("force", Some("kN/m²"))]);
        let body = table.numbers(&[0, 1, 2], "");
        prop_assert!(body.problems.is_empty(), "{:?}", body.problems);
        prop_assert_eq!(body.remark.is_some(), dialect.has_comma);
        for (n, row) in rows.iter().enumerate() {
            prop_assert_eq!([0, 1, 2].map(|column| body.columns[column][n]), *row);
        }
    }

    #[test]
    fn a_fault_is_found_in_its_line(dialect in dialects(), rows in rows(), at in 0..12_usize) {
        let at = at % rows.len();
        let mut lines = rows.iter().map(|row| dialect.line(&row.map(|n| dialect.number(n)))).collect::<Vec<_>>();
        lines[at] = dialect.line(&["1".to_owned(), "x".to_owned(), "2".to_owned()]);
        let header = dialect.header();
        let text = header.clone() + &lines.concat();
        let table = TableFile::read(dialect.bytes(&text)).unwrap();
        let body = table.numbers(&[0, 1, 2], "");
        prop_assert_eq!(body.problems.len(), 1);
        let expected = at + 1 + header.matches(dialect.end).count();
        prop_assert_eq!(table.line_of(body.problems[0].0.start), expected);
        let place = &table.text()[body.problems[0].0.clone()];
        prop_assert_eq!(place, "x");
    }

    #[test]
    fn no_bytes_make_it_panic(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        all_of(bytes);
    }

    #[test]
    fn no_garbled_table_makes_it_panic(
        text in "(\u{feff}|#|ncols 3\n)?([a-zé_]{0,6}( ?[\\[(](mm|N|%|°|s)[\\])]?)?[,;\t \"]{0,2}){0,4}(\n|\r|\r\n)([-0-9.,;eE\t \"'é−#]{0,14}(\n|\r|\r\n)){0,5}"
    ) {
        all_of(text.into_bytes());
    }
}

/// Everything that can be asked of a table.
fn all_of(bytes: Vec<u8>) {
    let Ok(table) = TableFile::read(bytes) else { return };
    let all: Vec<usize> = (0..table.columns().len()).collect();
    let body = table.numbers(&all, "");
    for problem in body.problems {
        let _ = (&table.text()[problem.0.start.min(table.text().len())..], table.in_words(problem));
    }
    let _ = (table.grid(""), table.titles(), table.comments().count());
    for n in 0..all.len() {
        let _ = (table.is_text(n), table.place(table.header().end, n));
    }
}

fn read(text: &[u8]) -> (TableFile, Vec<Vec<f64>>) {
    let table = TableFile::read(text.to_vec()).unwrap();
    let all: Vec<usize> = (0..table.columns().len()).collect();
    let body = table.numbers(&all, "");
    assert!(body.problems.is_empty(), "{:?}", body.problems);
    (table, body.columns)
}

#[test]
fn what_instruments_write_is_read() {
    let (table, columns) = read(b"sinkage [mm];pressure [kN/m\xb2]\r\n4;3.3\r\n8;7.2\r\n");
    assert_eq!(table.columns()[1].unit.as_deref(), Some("kN/m²"));
    assert!(table.remark().unwrap().contains("line 1 is not UTF-8"), "{:?}", table.remark());
    assert_eq!(columns[1], [3.3, 7.2]);
    // Names over two lines, as cells of a spreadsheet have them; marks between thousands; a quoted decimal
    // comma.
    let (table, columns) =
        read("\"depth\n[mm]\";\"force\n[N]\"\n1;1 234,5\n2;\"2.5e3\"\n".replace("2.5e3", "2500").as_bytes());
    assert_eq!(table.columns()[0].title, "depth [mm]");
    assert_eq!(columns[1], [1234.5, 2500.0]);
    let (_, columns) = read(b"depth [mm],force [N]\n\"1,5\",\"20,25\"\n");
    assert_eq!(columns, [[1.5], [20.25]]);
    // A unit apart from its name, names of several words, runs of blanks.
    let (table, _) = read(b"cone resistance [MPa]   depth [m]\n1.0   2.0\n");
    assert_eq!(table.columns()[0].name, "cone resistance");
    let (table, _) = read(b"depth [m] qc [MPa]\n0,02 0,06\n");
    assert_eq!(table.columns()[1].name, "qc");
    // A mark of inches is no quote.
    let (table, columns) = read(b"depth \"a,force [N]\n1,2\n");
    assert_eq!((table.columns().len(), columns[1][0]), (2, 2.0));
}

#[test]
fn what_is_ambiguous_is_refused() {
    for (text, message) in [
        ("a [m];b [N]\n1.5;2\n1,5;3\n", "write decimals in two ways"),
        ("a [m];b [N]\n1.234,5;2\n", "both a comma and a point"),
        ("a [m],b [N]\n\"1,234\",2\n", "may be 1.234 or 1234"),
        ("a [m],b [N]\n1,5,2,5\n", "4 fields, but the header has 2"),
        ("a [m];b [N]\n1,2,3;2\n", "not a number"),
    ] {
        let table = TableFile::read(text.as_bytes().to_vec()).unwrap();
        let body = table.numbers(&[0, 1], "");
        assert!(
            body.problems.iter().any(|(_, p)| p.message.contains(message)),
            "{text}: {:?}",
            body.problems
        );
    }
    for bytes in [&b"PK\x03\x04rest"[..], b"a\0b", b"\xff\xfea"] {
        assert!(TableFile::read(bytes.to_vec()).is_err());
    }
}
