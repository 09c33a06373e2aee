#!/usr/bin/env python3
"""A synthetic trial of `coulter calibrate --model solver`: two known parameters, a coarse plate of some seconds, its own curve with noise.

usage: surrogate_trial.py COULTER OUT [BUDGET [SEED]]

Runs the known case, takes its force at eight depths, adds 5 % of noise to each, calibrates, and says whether the intervals hold what is
known. Exit code 1 where they do not.
"""
import csv
import json
import math
import random
import subprocess
import sys
from pathlib import Path

CASE = Path(__file__).resolve().parents[2] / "cases" / "cmu_plate.toml"
KNOWN = {"soil.critical_friction_angle": (35.0, "deg", "33 ± 3 deg"), "soil.compression_modulus": (9.0, "MPa", "12 MPa */ 2")}
COARSE = ["grid.cell=10 mm", "run.duration=0.2 s", "domain.z=['-0.16 m', '0.06 m']"]
DEPTHS = [3.0, 4.5, 6.0, 7.5, 9.0, 10.5, 12.0, 13.0]  # mm
NOISE = 0.05


def coulter(*arguments):
    done = subprocess.run([sys.argv[1], *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{arguments}\n{done.stderr}")


def main():
    out = Path(sys.argv[2])
    budget = sys.argv[3] if len(sys.argv) > 3 else "14"
    random.seed(int(sys.argv[4]) if len(sys.argv) > 4 else 1)
    out.mkdir(parents=True, exist_ok=True)
    sets = [word for one in COARSE for word in ("--set", one)]
    known = [word for key, (value, unit, _) in KNOWN.items() for word in ("--set", f"{key}={value} {unit}")]
    coulter("run", CASE, *sets, *known, "-o", out / "known", "--auto-resume", "--threads", "1")
    rows = list(csv.DictReader(open(out / "known" / "forces.csv")))
    depth = [1e3 * float(row["sinkage z [m]"]) for row in rows]
    force = [float(row["vertical F_V [N]"]) for row in rows]
    lines = ["sinkage [mm],vertical [N]"]
    for z in DEPTHS:
        near = [f for d, f in zip(depth, force) if abs(d - z) < 0.2]
        lines.append(f"{z},{sum(near) / len(near) * math.exp(random.gauss(0.0, NOISE)):.3f}")
    (out / "measured.csv").write_text("\n".join(lines) + "\n")
    parameters = [word for key, (_, _, prior) in KNOWN.items() for word in ("--parameter", f"{key}={prior}")]
    coulter("calibrate", CASE, out / "measured.csv", *sets, *parameters, "--noise", f"{100 * NOISE}%", "--model", "solver",
            "--budget", budget, "--threads", "1", "-o", out / "calibration")
    solver = json.load(open(out / "calibration" / "calibration.json"))["solver"]
    missed = 0
    for found in solver["result"]["parameters"]:
        value = KNOWN[found["name"]][0]
        low, high = found["interval_90"]
        held = low <= value <= high
        missed += not held
        print(f"{found['name']}: known {value}, best {found['best']:.4g}, interval {low:.4g} to {high:.4g} {found['unit']}: "
              + ("held" if held else "MISSED"))
    print(f"Q2 {solver['predictivity']:.3f}, surprise of the last run {solver['largest_surprise']:.2f} standard deviations")
    sys.exit(1 if missed else 0)


main()
