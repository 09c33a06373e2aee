#!/usr/bin/env python3
"""How near the run time that `coulter check` predicts comes to the one that `coulter run` takes.

run_times.py COULTER [CASE...]     without cases: all of cases/*.toml, some 30 minutes on two cores

For each case the time said, the time taken by the clock and in processor seconds, and the ratio of the first
two; then how many are within a factor of 1.5. Exits with 1 where fewer than nine of ten are.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

FACTOR = 1.5
ENOUGH = 0.9


def said(coulter, case):
    """Seconds; 0 where the trial steps failed."""
    checked = subprocess.run([coulter, "check", case, "--json"], capture_output=True, text=True, check=True)
    return json.loads(checked.stdout)["estimated_wall_s"] or 0.0


def taken(coulter, case):
    """Seconds by the clock and in processor time, and how the run is graded."""
    with tempfile.TemporaryDirectory() as folder:
        before, began = os.times(), time.monotonic()
        run = subprocess.run([coulter, "run", case, "--output", folder + "/run"], capture_output=True, text=True)
        seconds, after = time.monotonic() - began, os.times()
    processor = sum(after[2:4]) - sum(before[2:4])
    grade = [line.split(": ")[1] for line in run.stderr.splitlines() if line.startswith("trust: ")]
    return seconds, processor, (grade or [f"exit code {run.returncode}"])[0]


def main():
    if len(sys.argv) < 2 or not os.access(sys.argv[1], os.X_OK):
        sys.exit(__doc__.strip())
    coulter = os.path.abspath(sys.argv[1])
    shipped = pathlib.Path(__file__).resolve().parents[2] / "cases"
    cases = [pathlib.Path(case) for case in sys.argv[2:]] or sorted(shipped.glob("*.toml"))
    print(f"{'case':28} {'said [s]':>9} {'taken [s]':>9} {'processor [s]':>13} {'said/taken':>10}  grade", flush=True)
    ratios = []
    for case in cases:
        predicted = said(coulter, str(case))
        seconds, processor, grade = taken(coulter, str(case))
        ratios.append(predicted / seconds)
        line = f"{case.stem:28} {predicted:9.1f} {seconds:9.1f} {processor:13.1f} {ratios[-1]:10.2f}  {grade}"
        print(line, flush=True)
    within = sum(1 / FACTOR <= ratio <= FACTOR for ratio in ratios)
    print(f"{within} of {len(ratios)} within a factor of {FACTOR}")
    sys.exit(0 if within >= ENOUGH * len(ratios) else 1)


main()
