#!/usr/bin/env python3
"""Compares the runs of two builds of the command: summaries number by number, histories byte by byte.

    compare_runs.py FOLDER FOLDER [--steady]

Fails where a number of the summaries differs by more than LIMIT. With --steady it only says how far the steady means of the bodies are
apart: elementary functions differ in the last bit from one C library to another, and the motion of a free body in sand enlarges that.
"""

import json
import sys
from pathlib import Path

LIMIT = 1e-6
"""Largest relative difference; chosen: far above rounding, far below what anybody reads."""
STEADY = ("drag_N", "vertical_N", "sinkage_m", "turn_ratio")
CLOCKS = {"wall_s", "version"}


def numbers(value, path=""):
    """All numbers of a document, by their path."""
    if isinstance(value, dict):
        for key, inner in value.items():
            if key not in CLOCKS:
                yield from numbers(inner, f"{path}.{key}")
    elif isinstance(value, list):
        for n, inner in enumerate(value):
            yield from numbers(inner, f"{path}[{n}]")
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path.lstrip("."), float(value)


def main() -> None:
    folders = [Path(name) for name in sys.argv[1:3]]
    first, second = (dict(numbers(json.loads((folder / "summary.json").read_text()))) for folder in folders)
    if first.keys() != second.keys():
        sys.exit(f"release: the summaries have different numbers: {sorted(first.keys() ^ second.keys())}")
    only_steady = "--steady" in sys.argv[3:]
    if only_steady:
        first = {path: value for path, value in first.items() if ".steady." in path and path.endswith(STEADY)}
    # What is zero but for rounding does not count.
    apart = {path: abs(first[path] - second[path]) / max(abs(first[path]), abs(second[path]), 1e-9) for path in first}
    worst = max(apart, key=apart.__getitem__)
    tables = sorted(path.name for path in folders[0].glob("*.csv"))
    same = [name for name in tables if (folders[0] / name).read_bytes() == (folders[1] / name).read_bytes()]
    what = "steady means" if only_steady else "summaries"
    print(f"release: {len(first)} numbers of the {what}, largest relative difference {apart[worst]:.1e} ({worst})")
    print(f"release: {len(same)} of {len(tables)} histories are the same bytes")
    if apart[worst] > LIMIT and not only_steady:
        sys.exit(f"release: {worst} differs: {first[worst]} and {second[worst]}")


if __name__ == "__main__":
    main()
