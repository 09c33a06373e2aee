//! Control characters and marks for the direction of text, wherever text of others is shown: on the terminal,
//! in logs, in reports.

use super::strangers::{CASE, STUDY, run};
use super::support::{Answer, Desk};

const HIDDEN: [char; 6] = ['\u{1b}', '\u{7}', '\u{9b}', '\u{7f}', '\u{202e}', '\u{2066}'];

/// Nothing of the kind reaches a terminal.
fn is_plain(answer: &Answer) {
    for text in [&answer.out, &answer.error] {
        let hidden = |c: char| {
            c != '\n' && c != '\t' && c.is_control()
                || ('\u{202a}'..='\u{2069}').contains(&c) && !c.is_whitespace()
        };
        assert!(!text.contains(hidden), "{text:?}");
    }
}

#[test]
fn a_title_or_a_name_with_one_is_refused_at_its_place() {
    for hidden in HIDDEN {
        let escaped = format!("\\u{:04x}", u32::from(hidden));
        let titled =
            CASE.replacen("format = 2\n", &format!("format = 2\ntitle = \"a{escaped}[31mRED\"\n"), 1);
        let named = CASE.replace("[body.b]", &format!("[body.\"b{escaped}\"]"));
        let listed = CASE.replace("\"0.12 m\", \"0.12 m\"", &format!("\"0.12 m\", \"0.12 m{escaped}\""));
        for (text, line) in [(titled, "2"), (named, "7"), (listed, "9")] {
            let desk = Desk::with(&[("t.toml", &text)]);
            for command in [&["check", "t.toml"][..], &["run", "t.toml"], &["forecast", "t.toml"]] {
                let answer = desk.expect(2, command);
                is_plain(&answer);
                answer.says(&[&format!("U+{:04X}", u32::from(hidden)), &format!("t.toml:{line}:")]);
            }
        }
        let study = STUDY.replacen("format = 2\n", &format!("format = 2\ntitle = \"a{escaped}b\"\n"), 1);
        let desk = Desk::with(&[("c.toml", CASE), ("s.toml", &study)]);
        let answer = desk.expect(2, &["sweep", "expand", "s.toml"]);
        is_plain(&answer);
        answer.says(&["s.toml:2:", &format!("U+{:04X}", u32::from(hidden))]);
    }
    let lines = CASE.replacen("format = 2\n", "format = 2\ntitle = \"one\\ntwo\"\n", 1);
    Desk::with(&[("t.toml", &lines)]).expect(2, &["check", "t.toml"]).says(&["U+000A"]);
    // Text that is written from right to left has none of these.
    let hebrew = CASE.replacen("format = 2\n", "format = 2\ntitle = \"חרישה Ж größe\"\n", 1);
    Desk::with(&[("t.toml", &hebrew)]).expect(0, &["check", "t.toml"]).says(&["חרישה Ж größe"]);
}

#[test]
fn errors_show_what_they_quote() {
    for hidden in HIDDEN {
        let text = format!("format = 2\n# {hidden}]0;pwn\nkey{hidden} = 1\n\"{hidden}x\" = 2\n");
        let desk = Desk::with(&[
            ("t.toml", &text),
            ("m.csv", &format!("time{hidden} [s],drag [N{hidden}]\n0,{hidden}\n")),
        ]);
        let named = format!("n{hidden}[31m.toml");
        desk.write(&named, CASE.replace("30 mm", "30 parsec").as_bytes());
        let missing = format!("no{hidden}.toml");
        for command in [
            &["check", "t.toml"][..],
            &["check", &named],
            &["check", &missing],
            &["run", &missing],
            &["compare", "m.csv", &named],
            &["calibrate", &named, "--measured", &missing],
            &["sweep", &missing],
            &["sweep", "run", &missing],
            &["report", &missing],
            &[&missing],
            &["check", "t.toml", "--set", &format!("soil.{hidden}=1")],
            &["run", &named, "--threads", &format!("{hidden}")],
        ] {
            let answer = desk.coulter(command);
            assert_eq!(answer.code, 2, "{command:?}: {}{}", answer.out, answer.error);
            is_plain(&answer);
        }
    }
}

#[test]
fn a_results_folder_of_a_stranger_shows_nothing_hidden() {
    let desk = Desk::with(&[("c.toml", CASE)]);
    run(&desk, "o");
    let record = desk.read("o/run.json");
    let forged = record.replacen("\"title\": \"", "\"title\": \"\\u001b]0;pwn\\u0007\\u202eDER", 1);
    assert_ne!(record, forged);
    desk.write("o/run.json", forged.as_bytes());
    desk.write("o/case.toml", format!("# \u{202e}\u{1b}[31m\n{CASE}").as_bytes());
    is_plain(&desk.expect(0, &["report", "o"]));
    let page = desk.read("o/report.html");
    assert!(!page.contains(HIDDEN), "a hidden character stands in the page");
    assert!(page.contains("<h1><bdi>\\u001b]0;pwn") && page.contains("\\u202eDER"));
    is_plain(&desk.coulter(&["run", "c.toml", "-o", "o"]));
}

/// What is told as JSON says the same.
#[test]
fn documents_keep_their_words() {
    let curve = "displacement [mm],drag [N]\n0,0\n10,5\n20,6\n";
    let names = ["a\u{202e}\u{9b}x.csv", "b.csv"];
    let desk = Desk::with(&names.map(|name| (name, curve)));
    let answer = desk.expect(0, &["compare", names[0], names[1], "--json"]);
    is_plain(&answer);
    let document: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    assert!(document.to_string().contains(names[0]), "{document}");
}
