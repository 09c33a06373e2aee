//! A case with a folder for its results, and runs of it that can be watched and sent signals.

use std::fs;
use std::path::PathBuf;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// A second or two of work, with frequent checkpoints and fields.
const CASE: &str = r#"
format = 2

[soil]
law = "mohr-coulomb"
friction_angle = "35 deg"
unit_weight = "16 kN/m^3"
young_modulus = "5 MPa"

[domain]
x = ["-0.35 m", "0.55 m"]
y = ["0 m", "0.3 m"]
z = ["-0.25 m", "0.1 m"]
symmetric = true

[grid]
cell = "25 mm"
growth = 1.15

[body.disc]
shape = "disc"
diameter = "0.2 m"
thickness = "0.08 m"
friction = 0.3
weight = "60 N"
forward = { speed = "0.2 m/s", start = "0.05 s", ramp = "0.02 s" }
heave = "free"
spin = "free"

[run]
tow_distance = "24 mm"

[output]
history_interval = "2 ms"
field_interval = "50 ms"
checkpoint_interval = "0.05 s"
"#;

/// Overrides for a very short run.
pub(crate) const TINY: [&str; 4] = [
    "--set",
    "run.tow_distance=1 mm",
    "--set",
    r#"body.disc.forward={ speed = "0.2 m/s", start = "0.01 s", ramp = "0.01 s" }"#,
];

/// Time limit for any event, even on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// A folder with a case file in it; results go to `out`.
pub(crate) struct Sandbox {
    folder: TempDir,
}

impl Sandbox {
    pub(crate) fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("case.toml"), CASE).unwrap();
        Self { folder }
    }

    /// A file or folder of the results.
    pub(crate) fn out(&self, name: &str) -> PathBuf {
        self.folder.path().join("out").join(name)
    }

    /// The text of a file of the results; nothing where there is none yet.
    pub(crate) fn text(&self, name: &str) -> String {
        fs::read_to_string(self.out(name)).unwrap_or_default()
    }

    pub(crate) fn summary(&self) -> serde_json::Value {
        serde_json::from_str(&self.text("summary.json")).unwrap()
    }

    /// `coulter run` on one thread, so that it does not slow down other tests.
    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin("coulter"));
        command.current_dir(&self.folder).args(["run", "case.toml", "-o", "out", "--threads", "1"]);
        command.args(arguments).stdin(Stdio::null());
        command
    }

    /// Runs to the end.
    pub(crate) fn run(&self, arguments: &[&str]) -> Reply {
        self.command(arguments).output().unwrap().into()
    }

    /// `coulter report` on the results.
    pub(crate) fn report(&self) -> Reply {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin("coulter"));
        command.current_dir(&self.folder).args(["report", "out"]).output().unwrap().into()
    }

    /// `coulter check` on the case.
    pub(crate) fn check(&self, arguments: &[&str]) -> Reply {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin("coulter"));
        command.current_dir(&self.folder).args(["check", "case.toml"]).args(arguments);
        command.output().unwrap().into()
    }

    /// Output of a bash script in which `$@` runs the case.
    pub(crate) fn script(&self, script: &str, arguments: &[&str]) -> Reply {
        let run = self.command(arguments);
        let mut bash = Command::new("bash");
        bash.current_dir(&self.folder).args(["-c", script, "bash"]).arg(run.get_program());
        bash.args(run.get_args()).stdin(Stdio::null()).output().unwrap().into()
    }

    /// Starts a run, which is killed at the end of its test.
    pub(crate) fn start(&self, arguments: &[&str]) -> Running<'_> {
        let mut command = self.command(arguments);
        let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        Running { sandbox: self, child: Some(child) }
    }

    /// Starts a run and kills it when it has two checkpoints and some lines of history.
    pub(crate) fn killed(&self, arguments: &[&str]) {
        let mut run = self.start(arguments);
        run.wait_for("two checkpoints", |sandbox| sandbox.has_checkpoints() && sandbox.lines() > 20);
        run.signal("KILL");
        assert_eq!(run.end().code, None);
    }

    pub(crate) fn has_checkpoints(&self) -> bool {
        ["last", "previous"].iter().all(|name| self.out(&format!("checkpoints/{name}.checkpoint")).is_file())
    }

    /// Lines of the history so far.
    pub(crate) fn lines(&self) -> usize {
        self.text("forces.csv").lines().count()
    }

    /// The files that must not depend on how often a run was stopped.
    pub(crate) fn histories(&self) -> [String; 5] {
        ["forces.csv", "energy.csv", "boundaries.csv", "soil.pvd", "body.pvd"].map(|name| self.text(name))
    }

    /// Names of all files of the results, sorted, with their contents.
    pub(crate) fn files(&self) -> Vec<(PathBuf, Vec<u8>)> {
        let (mut folders, mut files) = (vec![self.out("")], Vec::new());
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(&folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else {
                    files.push((path.clone(), fs::read(&path).unwrap()));
                }
            }
        }
        files.sort();
        files
    }

    /// Whether a half-written file or a lock is left.
    pub(crate) fn is_tidy(&self) -> bool {
        let is_left = |path: &PathBuf| path.extension().is_some_and(|e| e == "part" || e == "lock");
        !self.files().iter().any(|(path, _)| is_left(path))
    }
}

/// A run in progress; it does not outlive its test.
pub(crate) struct Running<'a> {
    sandbox: &'a Sandbox,
    child: Option<Child>,
}

impl Running<'_> {
    /// Waits for a condition.
    #[track_caller]
    pub(crate) fn wait_for(&mut self, what: &str, is_so: impl Fn(&Sandbox) -> bool) {
        let began = Instant::now();
        while !is_so(self.sandbox) {
            let ended = self.child.as_mut().unwrap().try_wait().unwrap();
            assert!(ended.is_none(), "the run ended without: {what}; {}", self.sandbox.text("run.log"));
            assert!(began.elapsed() < PATIENCE, "no sign of: {what}; {}", self.sandbox.text("run.log"));
            sleep(Duration::from_millis(2));
        }
    }

    /// Waits until the first lines of the history are there.
    #[track_caller]
    pub(crate) fn wait_until_under_way(&mut self) {
        self.wait_for("lines of the history", |sandbox| sandbox.lines() > 5);
    }

    pub(crate) fn signal(&mut self, name: &str) {
        let id = self.child.as_ref().unwrap().id().to_string();
        assert!(Command::new("kill").args(["-s", name, &id]).status().unwrap().success());
    }

    /// Suspends the process, unnoticed by the program, or lets it continue.
    pub(crate) fn hold(&mut self) {
        self.signal("STOP");
    }

    pub(crate) fn go_on(&mut self) {
        self.signal("CONT");
    }

    pub(crate) fn end(mut self) -> Reply {
        self.child.take().unwrap().wait_with_output().unwrap().into()
    }
}

impl Drop for Running<'_> {
    fn drop(&mut self) {
        if let Some(child) = &mut self.child {
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

/// The output of a program and its exit code; `None` when a signal ended it.
pub(crate) struct Reply {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl From<Output> for Reply {
    fn from(output: Output) -> Self {
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        Self { code: output.status.code(), out: text(&output.stdout), err: text(&output.stderr) }
    }
}

impl Reply {
    /// Checks the exit code and words on standard error.
    #[track_caller]
    pub(crate) fn is(self, code: i32, words: &[&str]) -> Self {
        assert_eq!(self.code, Some(code), "{}", self.err);
        for word in words {
            assert!(self.err.contains(word), "`{word}` is not in: {}", self.err);
        }
        assert!(!self.err.contains("panicked"), "{}", self.err);
        self
    }
}
