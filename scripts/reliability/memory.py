#!/usr/bin/env python3
"""Compares the memory that `coulter check` predicts with the peak that `coulter run` takes.

    memory.py PROGRAM [--short]

PROGRAM is the coulter binary. Prints a line for each case: predicted and measured peak of the resident memory, and their
ratio. --short takes only what is done within a minute. Exit code 1 when a prediction is off by more than 10 %.
Linux and macOS; standard library only.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

CASES = Path(__file__).resolve().parents[2] / "cases"
TOLERANCE = 0.10
SOON = 'body.disc.forward={ speed = "0.2 m/s", start = "0.02 s", ramp = "0.01 s" }'


def many_discs(number):
    """A case of thin discs side by side."""
    text = """format = 2
[soil]
law = "mohr-coulomb"
friction_angle = "35 deg"
unit_weight = "16 kN/m^3"
young_modulus = "5 MPa"
[domain]
x = ["-0.2 m", "0.4 m"]
y = ["-0.7 m", "0.7 m"]
z = ["-0.2 m", "0.1 m"]
[grid]
cell = "25 mm"
[run]
duration = "0.01 s"
[output]
history_interval = "1 ms"
"""
    for n in range(number):
        text += f"""[body.d{n}]
shape = "disc"
diameter = "0.2 m"
thickness = "26 mm"
y = "{27 * n - 526} mm"
friction = 0.3
sinkage = "{20 + n % 7} mm"
forward = {{ speed = "0.2 m/s", ramp = "1 s" }}
"""
    return text


BLOCK = """format = 2
[soil]
law = "mohr-coulomb"
friction_angle = "35 deg"
unit_weight = "16 kN/m^3"
young_modulus = "5 MPa"
[domain]
x = ["-9 m", "9 m"]
y = ["-9 m", "9 m"]
z = ["-5 m", "1 m"]
[grid]
cell = "0.1 m"
fine_x = ["-1 m", "1 m"]
fine_y = ["-1 m", "1 m"]
[body.b]
shape = "block"
size = ["14 m", "14 m", "14 m"]
friction = 0.3
sinkage = "0.5 m"
heave = { speed = "-1 m/s" }
[run]
duration = "30 ms"
"""


def cases(folder, is_short):
    """Name, case file and settings."""
    disc = CASES / "light_disc.toml"
    yield "towed disc, short", disc, ["run.tow_distance=0.02 m", SOON]
    yield "strip footing", CASES / "strip_footing.toml", []
    yield "passive wall", CASES / "passive_wall.toml", []
    yield "column collapse", CASES / "column_collapse.toml", ["run.duration=0.1 s"] if is_short else []
    fine = ["grid.cell=6.25 mm", "run.tow_distance=0.005 m", SOON]
    yield "towed disc, d/h = 32, single", disc, fine + ["numerics.precision=single"]
    if is_short:
        return
    yield "towed disc, d/h = 32", disc, fine
    yield "towed disc, whole", disc, []
    for name, text in [("40 discs", many_discs(40)), ("block of 14 m", BLOCK)]:
        path = Path(folder) / (name.replace(" ", "_") + ".toml")
        path.write_text(text)
        yield name, path, []


def peak(arguments):
    """Peak of the resident memory of a program [bytes]."""
    child = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    # 1: a result that the run itself does not trust; memory it took all the same.
    if child.returncode not in (0, 1):
        sys.exit(f"{' '.join(map(str, arguments))}: exit code {child.returncode}")
    return usage.ru_maxrss * (1 if sys.platform == "darwin" else 1024)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program, is_short = sys.argv[1], "--short" in sys.argv[2:]
    off = 0
    print(f"{'case':30} {'told [MB]':>10} {'taken [MB]':>10} {'ratio':>7}")
    with tempfile.TemporaryDirectory() as folder:
        for n, (name, path, settings) in enumerate(cases(folder, is_short)):
            sets = [word for setting in settings for word in ("--set", setting)]
            check = subprocess.run(
                [program, "check", "--json", path, *sets], check=True, capture_output=True
            )
            told = json.loads(check.stdout)["cost"]["memory_bytes"]
            taken = peak([program, "run", path, *sets, "-o", Path(folder) / str(n)])
            off += abs(told / taken - 1) > TOLERANCE
            print(f"{name:30} {told / 1e6:10.1f} {taken / 1e6:10.1f} {told / taken:7.3f}", flush=True)
    sys.exit(1 if off else 0)


if __name__ == "__main__":
    main()
