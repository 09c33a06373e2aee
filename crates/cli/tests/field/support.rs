//! The command in a folder of its own.

use assert_cmd::Command;
use std::path::Path;
use tempfile::TempDir;

/// A folder with the files of a test, in which the command is run.
pub(crate) struct Desk {
    folder: TempDir,
}

/// What the command answered.
pub(crate) struct Answer {
    pub(crate) code: i32,
    pub(crate) out: String,
    pub(crate) error: String,
}

impl Desk {
    /// A new folder with these files: name and content.
    pub(crate) fn with(files: &[(&str, &str)]) -> Desk {
        let desk = Desk { folder: tempfile::tempdir().unwrap() };
        for (name, content) in files {
            desk.write(name, content.as_bytes());
        }
        desk
    }

    pub(crate) fn path(&self) -> &Path {
        self.folder.path()
    }

    pub(crate) fn write(&self, name: &str, content: &[u8]) {
        std::fs::write(self.path().join(name), content).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path().join(name)).unwrap()
    }

    /// `coulter ARGUMENTS`, run in the folder; a check does not take the time to measure that of a run.
    pub(crate) fn coulter(&self, arguments: &[&str]) -> Answer {
        let untimed = arguments.first().filter(|first| **first == "check").map(|_| "--untimed");
        self.answer(Command::cargo_bin("coulter").unwrap().args(arguments).args(untimed))
    }

    /// The same as it stands, killed after so many seconds of processor time: the clock of a busy machine
    /// says nothing.
    #[track_caller]
    pub(crate) fn expect_within(&self, seconds: &str, code: i32, arguments: &[&str]) -> Answer {
        let mut shell = Command::new("sh");
        shell.args(["-c", "ulimit -t \"$1\"; shift; exec \"$@\"", "sh", seconds]);
        let answer = self.answer(shell.arg(assert_cmd::cargo::cargo_bin("coulter")).args(arguments));
        assert_eq!(answer.code, code, "{arguments:?}:\n{}\n{}", answer.out, answer.error);
        answer
    }

    fn answer(&self, command: &mut Command) -> Answer {
        let output = command.current_dir(self.path()).output().unwrap();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        Answer {
            code: output.status.code().unwrap_or(-1),
            out: text(&output.stdout),
            error: text(&output.stderr),
        }
    }

    /// The same, whose exit code must be this.
    pub(crate) fn expect(&self, code: i32, arguments: &[&str]) -> Answer {
        let answer = self.coulter(arguments);
        assert_eq!(answer.code, code, "{arguments:?}:\n{}\n{}", answer.out, answer.error);
        answer
    }
}

impl Desk {
    /// Figure and verdict of the check of this name in a results folder of the desk; `None` where the run has
    /// no such check.
    pub(crate) fn graded(&self, results: &str, check: &str) -> Option<(Option<f64>, String)> {
        let summary = self.read(&format!("{results}/summary.json"));
        let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
        let checks = summary["trust"]["checks"].as_array().unwrap().clone();
        let found = checks.into_iter().find(|found| found["name"] == check)?;
        Some((found["value"].as_f64(), found["verdict"].as_str().unwrap().to_owned()))
    }
}

impl Answer {
    /// Both streams, without line breaks that a terminal's width has put in.
    pub(crate) fn text(&self) -> String {
        format!("{} {}", self.out, self.error).split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// Each of these words stands in the answer.
    pub(crate) fn says(&self, words: &[&str]) -> &Answer {
        let text = self.text();
        for word in words {
            assert!(text.contains(word), "{word:?} is missing in:\n{}\n{}", self.out, self.error);
        }
        self
    }
}
