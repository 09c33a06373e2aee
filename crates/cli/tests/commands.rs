//! The commands, as docs/reference/commands.md shows them.
#![allow(missing_docs, clippy::unwrap_used)]

use assert_cmd::Command;
use std::fmt::Write;

/// What `coulter WORDS --help` prints.
fn help(words: &[&str]) -> String {
    let output = Command::cargo_bin("coulter").unwrap().args(words).arg("--help").output().unwrap();
    assert!(output.status.success(), "{words:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// The names below `Commands:` in a help text.
fn subcommands(help: &str) -> Vec<&str> {
    let listed = help.split_once("Commands:\n").map_or("", |(_, rest)| rest);
    let lines = listed.lines().take_while(|line| line.starts_with("  "));
    // Lines that are further in go on with the one above.
    let names =
        lines.filter(|line| !line.starts_with("   ")).filter_map(|line| line.split_whitespace().next());
    names.filter(|name| *name != "help").collect()
}

#[test]
fn the_documented_commands_are_up_to_date() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/reference/commands.md");
    let mut text = String::from(
        "# Commands\n\nWhat `coulter COMMAND --help` prints. Exit codes: 0 done (good or doubtful), 1 broken, 2 the request was wrong, \
         130, 143 and 129 stopped by SIGINT, SIGTERM and SIGHUP.\n\n\
         <!-- Below: written by a test with COULTER_UPDATE=1. -->\n",
    );
    for name in subcommands(&help(&[])) {
        let own = help(&[name]);
        let _ = write!(text, "\n## {name}\n\n```\n{}\n```\n", own.trim_end());
        for inner in subcommands(&own) {
            let _ = write!(text, "\n### {name} {inner}\n\n```\n{}\n```\n", help(&[name, inner]).trim_end());
        }
    }
    if std::env::var_os("COULTER_UPDATE").is_some() {
        std::fs::write(path, &text).unwrap();
    }
    let shipped = std::fs::read_to_string(path).unwrap_or_default();
    assert!(shipped == text, "docs/reference/commands.md: run the tests with COULTER_UPDATE=1");
}
