#!/usr/bin/env python3
"""Mean forces of towed bodies, and what rim and flanks contribute, for docs/studies/thin-bodies.md.

    forces.py RESULTS...
"""

import json
import sys
from pathlib import Path

for folder in map(Path, sys.argv[1:]):
    with open(folder / "summary.json", encoding="utf-8") as file:
        summary = json.load(file)
    for name, body in summary["bodies"].items():
        if body["steady"]["turn_ratio"] is None:
            continue  # a frame
        mean, rim = body["steady"], body["rim"]
        forces = " ".join(f"{mean[key]:.2f}" for key in ("drag_N", "vertical_N", "lateral_N"))
        of_rim = f"{rim['drag_N']:.2f} {rim['vertical_N']:.2f}"
        of_flanks = f"{rim['flank_drag_N']:.2f} {rim['flank_vertical_N']:.2f}"
        leak = 1e6 * body["peak"]["leaked_m3"]
        print(
            f"{folder.name}, {name}: drag, vertical, lateral {forces} N; drag, vertical of the rim {of_rim}, of the flanks"
            f" {of_flanks} N; turn ratio {mean['turn_ratio']:.2f}; noise {mean['drag_noise']:.3f}; leak {leak:.2f} cm³"
        )
