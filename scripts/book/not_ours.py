#!/usr/bin/env python3
"""Finds words and phrases in the pages that are not ours, listed in scripts/book/not-ours.txt with what to write instead, and lines
that the book would leave out."""

import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]


def prose(text):
    """The page without code, links' targets and comments; the lines stay where they are."""
    blank = lambda found: re.sub(r"[^\n]", " ", found[0])  # noqa: E731
    for pattern in (r"```.*?```", r"<!--.*?-->", r"\$\$.*?\$\$", r"`[^`\n]*`", r"\]\([^)]*\)"):
        text = re.sub(pattern, blank, text, flags=re.S)
    return text


def main():
    rules = [(re.compile(r"^ *%", re.M), "the book takes this line for a comment; break it elsewhere")]
    for line in (HERE / "not-ours.txt").read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            pattern, better = line.rsplit("|", 1)
            rules.append((re.compile(pattern.strip().replace(" ", r"\s+"), re.I), better.strip()))
    listed = subprocess.run(["git", "ls-files", "*.md"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    found = 0
    for page in listed.splitlines():
        if not (ROOT / page).exists():
            continue
        text = prose((ROOT / page).read_text(encoding="utf-8"))
        for rule, better in rules:
            for hit in rule.finditer(text):
                found += 1
                print(f"{page}:{text.count(chr(10), 0, hit.start()) + 1}: “{' '.join(hit[0].split())}”: {better}", file=sys.stderr)
    if found:
        sys.exit(f"words: {found} places")


main()
