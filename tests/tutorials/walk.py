"""Walks pages: runs their commands and compares."""

import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path

import agree
import page
from page import Wrong

# Chosen: far longer than any block takes, so that a command that hangs is noticed.
LIMIT_S = 600


class Walk:
    """A page on its way: its folder, the output of its last commands, the tolerance."""

    def __init__(self, folder, environment, limit_s):
        self.folder, self.environment, self.limit_s = folder, environment, limit_s
        self.output, self.within, self.skipped, self.checked = None, 0.02, [], 0

    def step(self, item):
        """Does what one item asks for."""
        if "file" in item.comments:
            self.write(item)
        elif item.kind in ("sh", "text", "values", "quote", "check", "exists", "tolerance"):
            getattr(self, item.kind)(item)
        elif item.comments:
            raise Wrong(item.line, f"{', '.join(item.comments)} before a block that is not run")

    def write(self, item):
        file = self.folder / item.comments["file"]
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(item.text + "\n", encoding="utf-8")

    def sh(self, item):
        needed = item.comments.get("needs")
        why = item.comments.get("skip") or (needed and not shutil.which(needed) and f"{needed} is not installed")
        if why:
            self.skipped.append((item.line, why))
            self.output = "skipped"
            return
        code, self.output = self.call(item)
        wanted = int(item.comments.get("expect", "exit 0").removeprefix("exit "))
        if code != wanted:
            raise Wrong(item.line, f"expected exit code {wanted}, came {code} from\n{item.text}\nwhich printed\n{self.output[-3000:]}")

    def call(self, item):
        """Exit code and output of a block."""
        command = ["bash", "-c", "set -euo pipefail\n" + item.text]
        pipes = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
        with subprocess.Popen(command, cwd=self.folder, env=self.environment, start_new_session=True, **pipes) as process:
            try:
                output, _ = process.communicate(timeout=self.limit_s)
            except BaseException as why:
                # The group: commands that bash has started would go on, and keep the pipe open.
                os.killpg(process.pid, signal.SIGKILL)
                if isinstance(why, subprocess.TimeoutExpired):
                    raise Wrong(item.line, f"not at its end after {self.limit_s} s:\n{item.text}") from None
                raise
        return process.returncode, output.decode("utf-8", "replace").replace("\r", "\n")

    def text(self, item):
        if self.output is None:
            raise Wrong(item.line, "no commands before this output")
        missing = None if self.output == "skipped" else agree.missing_line(item.text, self.output, self.within)
        if missing:
            place, line, like = missing
            tail = "\n".join(self.output.rstrip().split("\n")[-40:])
            raise Wrong(item.line + 1 + place, f"expected  {line}\n  came      {like}\n  The commands printed at the end\n{tail}")
        self.checked += sum(line.strip() not in ("", "…") for line in item.text.split("\n"))

    def values(self, item):
        for line, path, expected in item.comments["rows"]:
            self.compare(line, item.text, path, expected)

    def quote(self, item):
        file = self.folder / item.text
        if not file.is_file():
            raise Wrong(item.line, f"expected the file {item.text}, it is not there")
        if not agree.is_quoted(item.comments["words"], file, self.within):
            raise Wrong(item.line, f"{item.text} does not say: {item.comments['words']}")
        self.checked += 1

    def check(self, item):
        parts = re.match(r"^(\S+): (.+?) = (.+)$", item.text)
        if not parts:
            raise Wrong(item.line, "not of the form FILE: PATH = VALUE")
        self.compare(item.line, *parts.groups())

    def compare(self, line, name, path, expected):
        file = self.folder / name
        if not file.is_file():
            raise Wrong(line, f"expected the file {name}, it is not there")
        try:
            came = agree.value_of(file, path)
        except (KeyError, IndexError, ValueError, TypeError) as why:
            raise Wrong(line, f"{name} has no {path}: {why}") from None
        if not agree.value_agrees(expected, came, self.within):
            raise Wrong(line, f"{name}: {path}\n  expected  {expected}\n  came      {came}")
        self.checked += 1

    def exists(self, item):
        missing = [name for name in item.text.split() if not (self.folder / name).exists()]
        if missing:
            raise Wrong(item.line, f"expected the file {', '.join(missing)}, it is not there")
        self.checked += len(item.text.split())

    def tolerance(self, item):
        self.within = float(item.text.removesuffix("%")) / 100


def one_page(path, folder, environment, limit_s=LIMIT_S):
    """Walks a page in a folder; returns the walk. `Wrong` says what is wrong."""
    for line, why in page.links(path):
        raise Wrong(line, why)
    walk = Walk(folder, environment, limit_s)
    for item in page.read(path):
        walk.step(item)
    return walk


def in_order(folder):
    """The pages of a folder in the order of its index."""
    index = (folder / "README.md").read_text(encoding="utf-8")
    named = dict.fromkeys(re.findall(r"\]\(([\w-]+\.md)\)", index))
    forgotten = {file.name for file in folder.glob("*.md")} - set(named) - {"README.md"}
    if forgotten:
        raise SystemExit(f"tutorials: {folder}/README.md does not name {', '.join(sorted(forgotten))}")
    return [folder / "README.md"] + [folder / name for name in named]


def before(path):
    """The page that this one continues, or None."""
    found = re.search(r"^<!--\s*continues:\s*(\S+)\s*-->", path.read_text(encoding="utf-8"), re.M)
    return path.parent / found.group(1) if found else None


def with_those_before(pages):
    """The pages, each after the one that it continues."""
    order = []
    for path in pages:
        chain = [path]
        while (earlier := before(chain[0])) is not None and earlier not in order and earlier not in chain:
            chain.insert(0, earlier)
        order += [one for one in chain if one not in order]
    return order


def all_pages(coulter, pages, keep):
    """Walks all pages and says how long each took; the exit code."""
    if not os.access(coulter, os.X_OK) or coulter.is_dir():
        raise SystemExit(f"tutorials: {coulter} is not a program")
    scratch = Path(tempfile.mkdtemp(prefix="coulter-tutorials-"))
    (scratch / "bin").mkdir()
    (scratch / "bin" / "coulter").symlink_to(coulter)
    environment = os.environ | {"PATH": f"{scratch / 'bin'}{os.pathsep}{os.environ['PATH']}", "LC_ALL": "C.UTF-8"}
    try:
        failed = report(with_those_before(pages), scratch, environment)
    finally:
        if keep:
            print(f"tutorials: what they wrote is in {scratch}")
        else:
            shutil.rmtree(scratch)
    return 1 if failed else 0


def report(pages, scratch, environment):
    """Walks pages in folders of their own and prints a line on each; the names of those that failed."""
    failed, folders, wall, busy = [], {}, 0.0, 0.0
    for path in pages:
        earlier = before(path)
        folders[path] = folders.get(earlier) or scratch / path.stem
        folders[path].mkdir(exist_ok=True)
        began, used = time.monotonic(), processor_time()
        try:
            if earlier and earlier.name in failed:
                raise Wrong(1, f"it continues {earlier.name}, which failed")
            walk = one_page(path, folders[path], environment)
            what = f"{walk.checked} promises kept"
        except Wrong as why:
            failed.append(path.name)
            walk, what = None, f"FAILED\n{path.name}:{why.line}: {why}"
        took, spent = time.monotonic() - began, processor_time() - used
        wall, busy = wall + took, busy + spent
        print(f"tutorials: {path.name}: {took:.0f} s, {spent:.0f} s of one core: {what}", flush=True)
        for line, why in walk.skipped if walk else []:
            print(f"tutorials: {path.name}:{line}: skipped: {why}", flush=True)
    print(f"tutorials: {len(pages) - len(failed)} of {len(pages)} pages, {wall:.0f} s, {busy:.0f} s of one core")
    return failed


def processor_time():
    """Processor time of all commands so far [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
