#!/usr/bin/env python3
"""Speed of the static program over that of the ordinary one: best of the documents of `coulter bench --json`.

    compare_speed.py STATIC... -- ORDINARY...
"""

import json
import sys
from pathlib import Path

KEYS = ["million_cell_steps_per_core_second", "million_cell_steps_per_core_second_threads"]


def best(names: list[str], key: str) -> float:
    return max(json.loads(Path(name).read_text())[key] for name in names)


def main() -> None:
    between = sys.argv.index("--")
    static, ordinary = sys.argv[1:between], sys.argv[between + 1 :]
    for key in KEYS:
        pair = best(static, key), best(ordinary, key)
        print(f"release: {key}: static {pair[0]:.3g}, ordinary {pair[1]:.3g}, ratio {pair[0] / pair[1]:.3f}")


if __name__ == "__main__":
    main()
