//! Hostile input and output, through the binary: each is answered immediately, with a clear message and the
//! right exit code.
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used)] // helpers of tests are not known as tests

use assert_cmd::Command;
use std::fmt::Write;
use std::path::Path;
use std::process::Output;

fn disc() -> String {
    format!("{}/../../cases/light_disc.toml", env!("CARGO_MANIFEST_DIR"))
}

/// `coulter ARGUMENTS`, killed after a minute of processor time: the clock of a busy machine says nothing.
fn coulter(arguments: &[&str]) -> Output {
    within("60", arguments)
}

/// The same within so many seconds of processor time.
fn within(seconds: &str, arguments: &[&str]) -> Output {
    let mut shell = Command::new("sh");
    shell.args(["-c", "ulimit -t \"$1\"; shift; exec \"$@\"", "sh", seconds]);
    shell.arg(assert_cmd::cargo::cargo_bin("coulter")).args(arguments).output().unwrap()
}

/// Output of a shell script in which `$0` is the program, `$1` the disc's case and `$2` a folder.
fn shell(script: &str, folder: &Path) -> Output {
    let program = assert_cmd::cargo::cargo_bin("coulter");
    let mut shell = Command::new("sh");
    shell.args(["-c", script]).arg(program).arg(disc()).arg(folder).output().unwrap()
}

#[track_caller]
fn refused(output: &Output, words: &[&str]) -> String {
    let reply = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{reply}");
    for word in words {
        assert!(reply.contains(word), "`{word}` is not in: {reply}");
    }
    reply
}

#[test]
fn what_is_no_file_is_refused_at_once() {
    let folder = tempfile::tempdir().unwrap();
    refused(&coulter(&["check", "/dev/zero"]), &["a pipe or a device"]);
    refused(&shell("mkfifo \"$2/pipe\"; \"$0\" run \"$2/pipe\"", folder.path()), &["a pipe or a device"]);
    refused(&coulter(&["forecast", folder.path().to_str().unwrap()]), &["a directory"]);
    let large = folder.path().join("large.toml");
    std::fs::write(&large, vec![b'#'; (1 << 20) + 1]).unwrap();
    refused(&coulter(&["check", large.to_str().unwrap()]), &["too large", "1048576"]);
}

/// Refused within three seconds of processor time.
#[track_caller]
fn refused_soon(text: &str, words: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("case.toml");
    std::fs::write(&path, text).unwrap();
    let reply = refused(&within("3", &["check", path.to_str().unwrap()]), words);
    assert!(reply.lines().count() < 250, "{} lines", reply.lines().count());
}

#[test]
fn many_keys_and_many_bodies_are_answered_soon() {
    let mut keys = std::fs::read_to_string(disc()).unwrap();
    let mut bodies = keys.clone();
    for n in 0..10_000 {
        writeln!(keys, "nonsense_{n} = {n}").unwrap();
    }
    refused_soon(&keys, &["unknown key `nonsense_0`", "… and 9980 more", "10000 problems"]);
    for n in 0..2000 {
        writeln!(bodies, "[body.b{n}]\nshape = 'sphere'\ndiameter = '0.1 m'\nfriction = 0.3").unwrap();
    }
    refused_soon(&bodies, &["2001 bodies", "at most 500"]);
}

/// A block of 14 m on cells of 50 mm: 7.5 million points, 2 GB; of 40 mm: 12 million.
const BLOCK: &str = "format = 2\n[soil]\nlaw = 'mohr-coulomb'\nfriction_angle = '35 deg'\nunit_weight = '16 kN/m^3'\n\
    young_modulus = '5 MPa'\n[domain]\nx = ['-9 m', '9 m']\ny = ['-9 m', '9 m']\nz = ['-5 m', '1 m']\n[grid]\n\
    cell = '40 mm'\nfine_x = ['-1 m', '1 m']\nfine_y = ['-1 m', '1 m']\n[body.b]\nshape = 'block'\n\
    size = ['14 m', '14 m', '14 m']\nfriction = 0.3\n[run]\nduration = '3 ms'\n";

#[test]
fn a_body_with_too_many_points_is_refused_before_they_are_laid_out() {
    refused_soon(BLOCK, &["1.2e7 contact points; at most 1e7 are allowed", "numerics.point_spacing larger"]);
}

#[test]
fn names_of_devices_are_refused() {
    refused(&coulter(&["check", &disc(), "--set", "name=CON"]), &["\"CON\" is not a valid name"]);
    let body = ["--set", "body.com1.shape=sphere"];
    refused(&coulter(&[&["check", &disc()], &body[..]].concat()), &["\"com1\" is not a valid name"]);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("nul.toml");
    std::fs::copy(disc(), &path).unwrap();
    let seen = coulter(&["check", "--json", "--untimed", path.to_str().unwrap()]);
    assert!(String::from_utf8_lossy(&seen.stdout).contains("\"nul-case\""));
}

#[test]
fn a_slip_in_the_name_of_a_body_is_told() {
    refused(
        &coulter(&["check", &disc(), "--set", "body.disk.weight=60 N"]),
        &["no body of this name", "did you mean `body.disc`?"],
    );
}

#[test]
fn lengths_have_no_traces_of_rounding() {
    let seen = coulter(&[
        "check",
        &disc(),
        "--set",
        "domain.x=['-350 mm', '75 cm']",
        "--set",
        "body.disc.thickness=0.1 m",
    ]);
    let text = String::from_utf8_lossy(&seen.stdout).into_owned();
    assert!(seen.status.success() && !text.contains("0000000"), "{text}");
}

#[test]
fn a_full_standard_output_is_an_error_and_a_closed_one_is_none() {
    let folder = tempfile::tempdir().unwrap();
    for command in [
        "check \"$1\"",
        "check --json \"$1\"",
        "schema",
        "forecast \"$1\"",
        "pressure --friction-angle '33 deg'",
        "--help",
        "--version",
    ] {
        let full = shell(&format!("\"$0\" {command} >/dev/full"), folder.path());
        refused(&full, &["cannot write to standard output: No space left"]);
        let closed = shell(&format!("{{ \"$0\" {command}; echo $? >\"$2/code\"; }} | true"), folder.path());
        assert!(closed.stderr.is_empty(), "{command}: {}", String::from_utf8_lossy(&closed.stderr));
        assert_eq!(std::fs::read_to_string(folder.path().join("code")).unwrap().trim(), "0", "{command}");
    }
}

#[test]
fn a_standard_error_that_cannot_be_written_stops_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let short = "--set grid.cell='25 mm' --set run.tow_distance='1 mm' --set body.disc.forward='{ speed = \"0.2 m/s\", start = \"0.01 s\", ramp = \"0.01 s\" }'";
    let run = shell(&format!("\"$0\" run \"$1\" {short} -o \"$2/out\" 2>/dev/full"), folder.path());
    assert_eq!(run.status.code(), Some(0));
    assert!(folder.path().join("out/report.html").is_file());
    let piped = shell(
        &format!("{{ \"$0\" run \"$1\" {short} -o \"$2/piped\"; echo $? >\"$2/code\"; }} 2>&1 | true"),
        folder.path(),
    );
    assert!(piped.status.success());
    assert_eq!(std::fs::read_to_string(folder.path().join("code")).unwrap().trim(), "0");
    let wrong =
        shell("\"$0\" check no-such-file 2>/dev/full; test $? = 2 && \"$0\" chek 2>/dev/full", folder.path());
    assert_eq!(wrong.status.code(), Some(2));
}

#[test]
fn no_home_no_utf8_and_strange_names_are_no_trouble() {
    let folder = tempfile::tempdir().unwrap();
    let bare = shell("env -i LANG=C TERM=dumb \"$0\" check \"$1\"", folder.path());
    assert!(bare.status.success() && !String::from_utf8_lossy(&bare.stdout).contains('\u{1b}'));
    let odd =
        shell("f=$(printf '%s/\\377.toml' \"$2\"); cp \"$1\" \"$f\" && \"$0\" check \"$f\"", folder.path());
    assert!(odd.status.success(), "{}", String::from_utf8_lossy(&odd.stderr));
    let argument = shell("\"$0\" check \"$1\" --set \"$(printf 'soil.x=\\377')\"", folder.path());
    refused(&argument, &["error"]);
}

#[test]
fn a_file_where_results_should_go_is_called_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("taken");
    std::fs::write(&path, "mine").unwrap();
    let reply = coulter(&["forecast", &disc(), "-o", path.to_str().unwrap()]);
    refused(&reply, &["is a file, not a folder"]);
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "mine");
}
