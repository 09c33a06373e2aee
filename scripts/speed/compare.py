#!/usr/bin/env python3
"""Speed of one program over that of another: best of the documents of `coulter bench --json`.

    compare.py NAME DOCUMENT... -- OTHER DOCUMENT... [--at-least RATIO]

Exits with 1 where a ratio is below RATIO.
"""

import json
import sys
from pathlib import Path

KEYS = ["million_cell_steps_per_core_second", "million_cell_steps_per_core_second_threads"]


def best(names: list[str], key: str) -> float:
    return max(json.loads(Path(name).read_text())[key] for name in names)


def main() -> None:
    arguments, least = sys.argv[1:], 0.0
    if "--at-least" in arguments:
        at = arguments.index("--at-least")
        least = float(arguments[at + 1])
        del arguments[at : at + 2]
    between = arguments.index("--")
    (name, *documents), (other, *others) = arguments[:between], arguments[between + 1 :]
    ratios = []
    for key in KEYS:
        pair = best(documents, key), best(others, key)
        ratios.append(pair[0] / pair[1])
        print(f"speed: {key}: {name} {pair[0]:.3g}, {other} {pair[1]:.3g}, ratio {ratios[-1]:.3f}")
    if min(ratios) < least:
        sys.exit(f"speed: {name} is below {least} of the speed of {other}")


main()
