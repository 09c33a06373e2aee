#!/usr/bin/env python3
"""The map of the source files: what each is for, from the first sentence of its own comment.

map.py [CRATE]      prints the map, of one crate or of all
map.py --check      fails where a file does not say what it is for
map.py --markdown   for the book
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CRATES = re.findall(r'^    "crates/(\w+)",$', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.M)


def purpose(path):
    """The first sentence of the comment at the head of a file."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if not line.startswith("//!") or line == "//!":
            break
        lines.append(line[3:].strip())
    sentence = re.match(r".*?[.:;](?=\s|$)", " ".join(lines))
    return (sentence[0] if sentence else " ".join(lines)).rstrip(".:;")


def entries(crate):
    """Depth, name and purpose of the files of a crate, a folder before what it holds."""
    source = ROOT / "crates" / crate / "src"
    for path in sorted(source.rglob("*.rs"), key=lambda path: [(part != "mod.rs", part) for part in path.relative_to(source).parts]):
        parts = path.relative_to(source).with_suffix("").parts
        if path.name == "tests.rs":
            continue
        if parts[-1] == "mod":
            yield len(parts) - 1, parts[-2] + "/", purpose(path)
        else:
            yield len(parts), parts[-1], purpose(path)


def main():
    wanted = [name for name in sys.argv[1:] if not name.startswith("--")] or CRATES
    unknown = set(wanted) - set(CRATES)
    if unknown:
        sys.exit(f"map.py: there is no crate {', '.join(sorted(unknown))}; there are {', '.join(CRATES)}")
    missing = []
    for crate in wanted:
        rows = list(entries(crate))
        head = next((what for _, name, what in rows if name in ("lib", "main")), "")
        missing += [f"crates/{crate}: {name}" for _, name, what in rows if not what]
        if "--check" in sys.argv:
            continue
        if "--markdown" in sys.argv:
            print(f"## {crate}\n\n{head}.\n")
            print("".join(f"{'  ' * (depth - 1)}* `{name}` {what}\n" for depth, name, what in rows if name not in ("lib", "main")))
        else:
            print(f"{crate}: {head}")
            print("".join(f"{'  ' * depth}{name:<{max(1, 30 - 2 * depth)}} {what}\n" for depth, name, what in rows if name not in ("lib", "main")))
    if missing:
        sys.exit("map.py: no comment at the head of " + ", ".join(missing))


main()
