"""Shows that what is wrong on a page is reported, and what is right is not."""

import os
import tempfile
from pathlib import Path

import walk
from page import Wrong

FENCE = "```"


def block(kind, text):
    return f"{FENCE}{kind}\n{text}\n{FENCE}\n"


RIGHT = (
    "# A page\n\n[itself](page.md#a-page)\n\n<!-- file: a/s.json -->\n"
    + block("json", '{"disc": {"drag": 45.2, "grade": "good", "soil.phi": [1, 30]}}')
    + block("sh", "printf 'time 3 s\\n  drag: 45.3 N,  interval 44 … 47 N (−1.5e−3)\\njobs 0-3, 25 deg..45 deg\\ndone\\n'; echo 'u [m],F [N]\n0,1\n1,7' > h.csv")
    + block("text", "drag: 45.2 N, interval 44 … 47 N (−1.5e−3)\njobs 0-3, 25 deg..45 deg\ndone")
    + "<!-- expect: exit 3 -->\n"
    + block("sh", "exit 3")
    + "<!-- skip: no such queue here -->\n"
    + block("sh", "sbatch /no/such/job")
    + block("text", "Submitted batch job 1")
    + "<!-- exists: h.csv a/s.json -->\n<!-- values: a/s.json -->\n\n| key | value |\n|---|---|\n| `disc.drag` | 45 ± 1 % |\n"
    + "| `disc.grade` | good |\n| `disc.soil.phi.1` | 29 … 31 |\n\n<!-- check: h.csv: F [N] = 7 -->\n"
    + "<!-- file: r.html -->\n"
    + block("html", "<p class='a'>It pulls <b>45.3&nbsp;N</b>,\nand sinks.</p>")
    + "<!-- quote: r.html -->\n> It pulls 45.2 N, and\n> sinks.\n"
)

# What is put in place of what on the page that is right; words of the line that must be named; words of the message.
WRONG = {
    "a wrong number in a text": ("drag: 45.2 N, int", "drag: 47.2 N, int", "drag: 47.2", "drag: 45.3 N"),
    "a wrong word in a text": ("done\n```", "finished\n```", "finished", "expected  finished"),
    "lines in another order": ("drag: 45.2 N, interval 44 … 47 N (−1.5e−3)\njobs 0-3, 25 deg..45 deg\ndone", "done\ntime 3 s", "time 3 s", "time 3 s"),
    "a failing command": ("printf", "false; printf", "```sh", "came 1"),
    "a failing command in a pipe": ("printf", "false | cat; printf", "```sh", "came 1"),
    "a command that is not there": ("printf", "coulterr; printf", "```sh", "came 127"),
    "a command that hangs": ("printf", "sleep 100; printf", "```sh", "not at its end after 5 s"),
    "a wrong exit code": ("expect: exit 3", "expect: exit 1", "```sh", "expected exit code 1, came 3"),
    "a wrong number in a table": ("45 ± 1 %", "44 ± 1 %", "44 ± 1 %", "came      45.2"),
    "a value outside its range": ("29 … 31", "31 … 33", "31 … 33", "came      30"),
    "a wrong word in a table": ("| good |", "| broken |", "broken", "came      good"),
    "a value that is not there": ("disc.grade", "disc.verdict", "disc.verdict", "has no disc.verdict"),
    "a wrong number in a column": ("F [N] = 7", "F [N] = 8", "= 8", "came      7.0"),
    "wrong words in a quotation": ("> sinks", "> floats", "quote: r.html", "does not say"),
    "a wrong number in a quotation": ("> It pulls 45.2", "> It pulls 54.2", "quote: r.html", "does not say"),
    "a missing file": ("exists: h.csv", "exists: none.csv", "none.csv", "none.csv, it is not there"),
    "values of a missing file": ("values: a/s.json", "values: b/s.json", "disc.drag", "b/s.json, it is not there"),
    "a broken link": ("(page.md#a-page)", "(pages.md)", "(pages.md)", "leads nowhere"),
    "a missing heading": ("(page.md#a-page)", "(page.md#b)", "(page.md#b)", "no such heading"),
    "a misspelt comment": ("<!-- exists", "<!-- exist", "<!-- exist:", "unknown comment"),
    "a block that is not closed": ("> sinks.\n", "```sh\n", "```sh", "not closed"),
}


def outcome(text, folder):
    """None where a page is as it promises, otherwise what is wrong."""
    folder.mkdir()
    path = folder / "page.md"
    path.write_text(text, encoding="utf-8")
    try:
        return None, walk.one_page(path, folder, os.environ | {"LC_ALL": "C.UTF-8"}, limit_s=5)
    except Wrong as why:
        return why, None


def run():
    """Tries all pages; the exit code."""
    faults = []
    with tempfile.TemporaryDirectory(prefix="coulter-tutorials-") as scratch:
        why, done = outcome(RIGHT, Path(scratch) / "right")
        if why:
            faults.append(f"the page that is right: line {why.line}: {why}")
        elif (done.checked, done.skipped) != (11, [(24, "no such queue here")]):
            faults.append(f"the page that is right: {done.checked} promises, skipped {done.skipped}")
        for number, (name, (old, new, line, words)) in enumerate(WRONG.items()):
            if RIGHT.count(old) < 1:
                faults.append(f"{name}: the page has no {old}")
                continue
            text = RIGHT.replace(old, new, 1)
            why, _ = outcome(text, Path(scratch) / str(number))
            if why is None or line not in text.split("\n")[why.line - 1] or words not in str(why):
                faults.append(f"{name}: expected {line} to be named with `{words}`, came " + (f"line {why.line}: {why}" if why else "nothing"))
    for fault in faults:
        print(f"tutorials: self-test: {fault}")
    print(f"tutorials: self-test: {len(WRONG) + 1 - len(faults)} of {len(WRONG) + 1} pages judged as they should be")
    return 1 if faults else 0
