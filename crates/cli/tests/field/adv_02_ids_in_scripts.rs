//! `cases.jsonl` from a stranger: an id is an id, and nothing else comes into a script or a path.

use super::strangers::{CASE, STUDY};
use super::support::Desk;
use serde_json::Value;

/// A study whose first case has this id.
pub(super) fn study_with(id: &str) -> Desk {
    let desk = Desk::with(&[("c.toml", CASE), ("s.toml", STUDY)]);
    desk.expect(0, &["sweep", "expand", "s.toml", "-o", "so"]);
    let list = desk.read("so/cases.jsonl");
    let mut lines: Vec<Value> = list.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    lines[1]["id"] = id.into();
    let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
    desk.write("so/cases.jsonl", text.as_bytes());
    desk
}

#[test]
fn an_id_that_is_none_refuses_the_list_with_its_line() {
    for id in [
        "x\nIDS\ntouch PWN\ncat <<IDS",
        "$(touch PWN)",
        "'; touch PWN; '",
        "../../evil",
        "/tmp/evil",
        "r0123456789abcde",
        "r0123456789abcdeF",
        "",
    ] {
        let desk = study_with(id);
        for engine in ["parallel", "slurm", "hyperqueue", "snakemake", "ids"] {
            let answer = desk.expect(2, &["sweep", "script", "so", "--for", engine]);
            answer.says(&["cases.jsonl", "line 2", "no id of a case"]);
            assert_eq!(answer.out, "");
        }
        for step in [&["sweep", "run", "so"][..], &["sweep", "collect", "so"]] {
            desk.expect(2, step).says(&["cases.jsonl", "line 2"]);
        }
        if !id.is_empty() {
            desk.expect(2, &["sweep", "run", "so", "--id", id]);
        }
    }
}
