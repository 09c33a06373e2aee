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

/// A block of 0.2 m × 0.1 m × 0.2 m.
const BLOCK: &str = "\
    v -0.1 -0.05 -0.1\nv 0.1 -0.05 -0.1\nv -0.1 0.05 -0.1\nv 0.1 0.05 -0.1\n\
    v -0.1 -0.05 0.1\nv 0.1 -0.05 0.1\nv -0.1 0.05 0.1\nv 0.1 0.05 0.1\n\
    f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

/// Overrides for a very short run.
pub(crate) const TINY: [&str; 4] = [
    "--set",
    "run.tow_distance=1 mm",
    "--set",
    r#"body.disc.forward={ speed = "0.2 m/s", start = "0.01 s", ramp = "0.01 s" }"#,
];

/// After how long without an event a test gives up: far beyond what a busy machine takes.
const PATIENCE: Duration = Duration::from_secs(600);

/// A folder with a case file in it; results go to `out`.
pub(crate) struct Sandbox {
    folder: TempDir,
    case: &'static str,
}

impl Sandbox {
    pub(crate) fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("case.toml"), CASE).unwrap();
        Self { folder, case: "case.toml" }
    }

    /// The case in a folder of its own with a file of its body, run from outside that.
    pub(crate) fn with_body_from_a_file() -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("tools")).unwrap();
        let from_file = "shape = \"mesh\"\nfile = \"block.obj\"\nunit = \"m\"";
        let case = CASE.replace("shape = \"disc\"\ndiameter = \"0.2 m\"\nthickness = \"0.08 m\"", from_file);
        fs::write(folder.path().join("tools/case.toml"), case).unwrap();
        fs::write(folder.path().join("tools/block.obj"), BLOCK).unwrap();
        Self { folder, case: "tools/case.toml" }
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
        command.current_dir(&self.folder).args(["run", self.case, "-o", "out", "--threads", "1"]);
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
        command.current_dir(&self.folder).args(["check", self.case]).args(arguments);
        command.output().unwrap().into()
    }

    /// Output of a bash script in which `$@` runs the case.
    pub(crate) fn script(&self, script: &str, arguments: &[&str]) -> Reply {
        self.bash(script, arguments).output().unwrap().into()
    }

    fn bash(&self, script: &str, arguments: &[&str]) -> Command {
        let run = self.command(arguments);
        let mut bash = Command::new("bash");
        bash.current_dir(&self.folder).args(["-c", script, "bash"]).arg(run.get_program());
        bash.args(run.get_args()).stdin(Stdio::null());
        bash
    }

    /// Starts a run, which is killed at the end of its test.
    pub(crate) fn start(&self, arguments: &[&str]) -> Running<'_> {
        Running::start(self, self.command(arguments))
    }

    /// The same, suspended by itself at its fifth sample, and at every fifth one after it is let go on.
    #[track_caller]
    pub(crate) fn start_held(&self, arguments: &[&str]) -> Running<'_> {
        self.held(self.command(arguments))
    }

    /// The same by a bash script in which `$@` runs the case.
    #[track_caller]
    pub(crate) fn start_script_held(&self, script: &str) -> Running<'_> {
        self.held(self.bash(script, &[]))
    }

    #[track_caller]
    fn held(&self, mut command: Command) -> Running<'_> {
        command.env("COULTER_SUSPEND_EVERY", "5");
        let mut run = Running::start(self, command);
        run.hold_at("the fifth sample", |_| true);
        run
    }

    /// Starts a run and kills it when it has two checkpoints and some lines of history.
    pub(crate) fn killed(&self, arguments: &[&str]) {
        let mut run = self.start_held(arguments);
        while !(self.has_checkpoints() && self.lines() > 20) {
            run.signal("USR1");
            run.go_on();
            run.hold_at("five more samples", |_| true);
        }
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
    child: Child,
    /// Where its output and its messages go.
    streams: [PathBuf; 2],
}

impl<'a> Running<'a> {
    fn start(sandbox: &'a Sandbox, mut command: Command) -> Self {
        let streams =
            ["out", "err"].map(|name| tempfile::Builder::new().prefix(name).tempfile_in(&sandbox.folder));
        let streams = streams.map(|file| file.unwrap().into_temp_path().keep().unwrap());
        let [out, err] = [0, 1].map(|n| fs::File::create(&streams[n]).unwrap());
        let child = command.stdout(out).stderr(err).spawn().unwrap();
        Self { sandbox, child, streams }
    }

    /// Whether the process is suspended.
    fn is_held(&self) -> bool {
        let about = fs::read_to_string(format!("/proc/{}/stat", self.child.id())).unwrap_or_default();
        about.rsplit(") ").next().is_some_and(|state| state.starts_with('T'))
    }

    /// Lets a run that suspends itself go on until it has done so where a condition holds, and leaves it
    /// there.
    #[track_caller]
    pub(crate) fn hold_at(&mut self, what: &str, is_so: impl Fn(&Sandbox) -> bool) {
        loop {
            let held = self.wait(|run| run.is_held());
            assert!(held, "the run ended without: {what}; {}", self.sandbox.text("run.log"));
            if is_so(self.sandbox) {
                return;
            }
            self.go_on();
        }
    }

    /// Waits for an event; whether it came before the run had ended.
    fn wait(&mut self, is_so: impl Fn(&Self) -> bool) -> bool {
        let began = Instant::now();
        loop {
            let ended = self.child.try_wait().unwrap();
            if is_so(self) {
                return true;
            }
            if ended.is_some() {
                return false;
            }
            assert!(began.elapsed() < PATIENCE, "no event; {}", self.sandbox.text("run.log"));
            sleep(Duration::from_millis(2));
        }
    }

    /// Waits for a condition that stays, once it is met.
    #[track_caller]
    pub(crate) fn wait_for(&mut self, what: &str, is_so: impl Fn(&Sandbox) -> bool) {
        let came = self.wait(|run| is_so(run.sandbox));
        assert!(came, "the run ended without: {what}; {}", self.sandbox.text("run.log"));
    }

    /// Waits until a process handles SIGTERM itself.
    pub(crate) fn wait_until_it_listens(&mut self) {
        let listens = |run: &Self| {
            let status = fs::read_to_string(format!("/proc/{}/status", run.child.id())).unwrap_or_default();
            let mask = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
            mask.is_some_and(|mask| u64::from_str_radix(mask.trim(), 16).unwrap() >> 14 & 1 == 1)
        };
        assert!(self.wait(listens), "it ended before");
    }

    pub(crate) fn signal(&mut self, name: &str) {
        let id = self.child.id().to_string();
        assert!(Command::new("kill").args(["-s", name, &id]).status().unwrap().success());
    }

    /// Lets a suspended process continue.
    pub(crate) fn go_on(&mut self) {
        self.signal("CONT");
    }

    /// Its end, however often it suspends itself before.
    pub(crate) fn end(mut self) -> Reply {
        let status = loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                break status;
            }
            if self.is_held() {
                self.go_on();
            }
            sleep(Duration::from_millis(2));
        };
        let [stdout, stderr] = [0, 1].map(|n| fs::read(&self.streams[n]).unwrap());
        Output { status, stdout, stderr }.into()
    }
}

impl Drop for Running<'_> {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
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
