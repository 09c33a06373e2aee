//! No case file, however garbled, may cause a panic: it is a case, or it is refused.

use miette::GraphicalReportHandler;
use proptest::prelude::*;

const TOWED_DISC: &str = include_str!("../../../cases/light_disc.toml");
const FOOTING: &str = include_str!("../../../cases/strip_footing.toml");
const STAGES: &str = include_str!("../../../cases/press_and_tow.toml");
const WALL: &str = include_str!("../../../cases/passive_wall.toml");

/// Garbles a case: lines or characters are deleted, duplicated or replaced.
fn garbled() -> impl Strategy<Value = String> {
    let change = (0usize..6, any::<prop::sample::Index>(), any::<prop::sample::Index>(), "\\PC{0,3}");
    let cases = prop::sample::select(vec![TOWED_DISC, FOOTING, WALL, STAGES]);
    (cases, prop::collection::vec(change, 1..5)).prop_map(|(case, changes)| {
        changes
            .into_iter()
            .fold(case.to_owned(), |text, (kind, a, b, filling)| garble(&text, kind, a, b, &filling))
    })
}

fn garble(text: &str, kind: usize, a: prop::sample::Index, b: prop::sample::Index, filling: &str) -> String {
    if text.is_empty() {
        return filling.to_owned();
    }
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let (one, two) = (a.index(lines.len()), b.index(lines.len()));
    let mut chars: Vec<char> = text.chars().collect();
    let place = b.index(chars.len());
    match kind {
        0 => drop(lines.remove(one)),
        1 => lines.insert(two, lines[one].clone()),
        2 => lines.swap(one, two),
        3 => {
            chars.splice(place..(place + 1).min(chars.len()), filling.chars());
            return chars.into_iter().collect();
        }
        4 => {
            // Another number in place of one digit, to get past the syntax.
            let digits: Vec<usize> = (0..chars.len()).filter(|n| chars[*n].is_ascii_digit()).collect();
            if let Some(n) = digits.get(b.index(digits.len().max(1))) {
                chars[*n] = ['0', '9', '-', 'e', '.'][a.index(5)];
            }
            return chars.into_iter().collect();
        }
        _ => {
            let value = lines[two].split_once('=').map_or("", |(_, v)| v).to_owned();
            let key = lines[one].split_once('=').map_or("", |(k, _)| k).to_owned();
            lines[one] = format!("{key}={value}");
        }
    }
    lines.join("\n")
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1500, ..ProptestConfig::default() })]
    #[test]
    fn garbled_cases_never_panic(text in garbled(), set in prop::option::of("\\PC{0,20}")) {
        let overrides: Vec<String> = set.into_iter().collect();
        match coulter::case::parse(&text, "garbled.toml", &overrides) {
            Ok(case) => {
                let _ = coulter::case::advice(&case);
                let cost = coulter::case::estimate::estimate(&case);
                prop_assert!(cost.time_step_s > 0.0 && cost.cells >= 1.0);
            }
            Err(error) => {
                prop_assert!(!error.problems.is_empty());
                let mut rendered = String::new();
                for problem in &error.problems {
                    prop_assert!(GraphicalReportHandler::new().render_report(&mut rendered, problem).is_ok());
                }
            }
        }
    }
}
