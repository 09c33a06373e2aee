//! Scripts for other engines, of studies in folders whose names mean something to a shell, to Snakemake or to
//! GNU parallel: what the script starts must get the folder as it is, and nothing else must happen.

use super::strangers::{CASE, STUDY, sh};
use super::support::Desk;
use std::fs;
use std::os::unix::fs::PermissionsExt;

const NAMES: [&str; 16] = [
    "plain",
    "a space",
    "h b$(touch PWN)",
    "h b`touch PWN`",
    "it's",
    "\"double\" 'single' '\"'\"'",
    "semi; touch PWN; &",
    "a\nnew line\ntouch PWN\nIDS\n",
    "{x}",
    "{} {.} {1} {#} {= $_=`touch PWN` =}",
    "{{id}}",
    "-o dash",
    "größe Ж 砂",
    "back\\slash \\n",
    "%{TASK_ID} $HQ_ENTRY ~ * ? [a] !1 #",
    "tab\tand dash-",
];

/// What `coulter` is: it notes its words, each ended by a NUL.
const PROGRAM: &str = "#!/bin/sh\nprintf '%s\\0' \"$@\" >> \"$NOTED\"\nprintf '\\n' >> \"$NOTED\"\n";
/// HyperQueue: runs what stands behind `--`, once for every line of the list.
const HQ: &str = "#!/bin/sh\nwhile [ \"$1\" != -- ]; do [ \"$1\" != --each-line ] || list=$2; shift; done\nshift\n\
                  while read -r HQ_ENTRY; do export HQ_ENTRY; \"$@\"; done < \"$list\"\n";
/// GNU parallel with -q: replaces its words in braces, quotes every word, and gives the line to a shell.
const PARALLEL: &str = r#"#!/usr/bin/env python3
import shlex, subprocess, sys
words = sys.argv[1:]
assert '-q' in words, words
words = words[words.index('-q') + 1:]
assert not any(part in word for word in words for part in ('{.}', '{1}', '{#}', '{=')), words
for line in sys.stdin.read().splitlines():
    subprocess.run(' '.join(shlex.quote(word.replace('{}', line)) for word in words), shell=True, check=True)
"#;
/// Snakemake, as far as the rules go.
const SNAKEMAKE: &str = r#"
import os, re, subprocess, sys
text = open(sys.argv[1]).read()
space = {}
exec(text[:text.index('workdir:')], space)
assert re.search(r'^workdir: FOLDER$', text, re.M)
class Case: pass
for id in space['IDS']:
    case = Case(); case.id = id
    shell = eval(re.search(r'^    shell: (.*)$', text, re.M)[1])
    output = eval(re.search(r'^    output: (.*)$', text, re.M)[1])
    assert re.findall(r'\{(\w+)\}', output) == ['id'], output
    subprocess.run(shell.format(wildcards=case, output=output.format(id=id)), shell=True, check=True, cwd=space['FOLDER'])
"#;

fn desk(name: &str) -> Desk {
    let desk = Desk::with(&[("c.toml", CASE), ("s.toml", STUDY), ("snakemake.py", SNAKEMAKE)]);
    fs::create_dir_all(desk.path().join("stubs")).unwrap();
    for (stub, text) in [("stub", PROGRAM), ("hq", HQ), ("parallel", PARALLEL)] {
        let path = format!("stubs/{stub}");
        desk.write(&path, text.as_bytes());
        fs::set_permissions(desk.path().join(path), fs::Permissions::from_mode(0o755)).unwrap();
    }
    desk.expect(0, &["sweep", "expand", "s.toml", "-o", &format!("./{name}/st")]);
    desk
}

#[test]
fn a_folder_arrives_as_it_is_called() {
    for name in NAMES {
        let desk = desk(name);
        let folder = format!("./{name}/st");
        let ids = desk.expect(0, &["sweep", "script", &folder, "--for", "ids"]).out;
        let there = desk.path().join(name).join("st");
        let word = there.to_str().unwrap();
        let expected: String =
            ids.lines().map(|id| format!("sweep\0run\0{word}\0--threads\x001\0--id\0{id}\0\n")).collect();
        let program = desk.path().join("stubs/stub").display().to_string();
        for (engine, run) in [
            ("parallel", "sh script"),
            ("slurm", "for n in 0 1; do SLURM_ARRAY_TASK_ID=$n bash script || exit; done"),
            ("hyperqueue", "sh script"),
            ("snakemake", "python3 snakemake.py script"),
        ] {
            let script =
                desk.expect(0, &["sweep", "script", &folder, "--for", engine, "--command", &program]).out;
            desk.write("script", script.as_bytes());
            let _ = fs::remove_file(desk.path().join("noted"));
            let done = sh(&desk, &format!("export NOTED=\"$PWD/noted\" PATH=\"$PWD/stubs:$PATH\"; {run}"));
            let error = String::from_utf8_lossy(&done.stderr).into_owned();
            assert!(done.status.success(), "{engine}, {name:?}: {error}\n{script}");
            assert_eq!(desk.read("noted"), expected, "{engine}, {name:?}:\n{script}");
            assert!(!desk.path().join("PWN").exists(), "{engine}, {name:?}:\n{script}");
        }
    }
}

/// What nobody sees has no place in a script.
#[test]
fn a_folder_with_hidden_characters_is_refused() {
    for name in ["esc\u{1b}[31m", "right\u{202e}left", "over\rwritten"] {
        let desk = desk(name);
        let wish = ["sweep", "script", &format!("./{name}/st"), "--for", "slurm"].map(str::to_owned);
        let answer = desk.expect(2, &wish.each_ref().map(String::as_str));
        answer.says(&["a control character stands in this name"]);
        assert!(!answer.error.contains(['\u{1b}', '\u{202e}', '\r']), "{:?}", answer.error);
    }
}

/// The program, too, may lie in such a folder.
#[test]
fn a_program_is_started_wherever_it_lies() {
    let desk = desk("study");
    for name in ["a $(touch PWN) space", "it's {x} {}"] {
        fs::create_dir_all(desk.path().join(name)).unwrap();
        fs::copy(desk.path().join("stubs/stub"), desk.path().join(name).join("stub")).unwrap();
        let program = desk.path().join(name).join("stub").display().to_string();
        for (engine, run) in [
            ("parallel", "sh script"),
            ("hyperqueue", "sh script"),
            ("snakemake", "python3 snakemake.py script"),
        ] {
            let wish = ["sweep", "script", "study/st", "--for", engine, "--command", &program];
            desk.write("script", desk.expect(0, &wish).out.as_bytes());
            let _ = fs::remove_file(desk.path().join("noted"));
            let done = sh(&desk, &format!("export NOTED=\"$PWD/noted\" PATH=\"$PWD/stubs:$PATH\"; {run}"));
            assert!(done.status.success(), "{engine}: {}", String::from_utf8_lossy(&done.stderr));
            assert_eq!(desk.read("noted").lines().count(), 2, "{engine}");
            assert!(!desk.path().join("PWN").exists());
        }
    }
}

/// Every word of the shell comes out of it as it went in.
#[test]
fn no_engine_is_left_out() {
    let desk = desk("study");
    let answer = desk.coulter(&["sweep", "script", "study/st", "--for", "no such"]);
    for engine in ["parallel", "slurm", "hyperqueue", "snakemake", "ids"] {
        assert!(
            answer.text().contains(engine),
            "a new engine belongs into the test above: {}",
            answer.text()
        );
    }
}
