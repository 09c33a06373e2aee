#!/usr/bin/env python3
"""Runs the rows of validation/D6_wheel and prints them beside what was measured.

usage: run_wheels.py COULTER OUT [--jobs N] [--sets FILE] [--friction MU ...] [--rows SLIP ...] [--set KEY=VALUE ...]

Every run is cases/cmu_wheel.toml with the slip and the vertical force of a row. FILE holds one set of parameters per line, as
fit_plate.py prints them; without it the set of the case is run. Runs that are already in OUT are read, not repeated.
"""
import argparse
import csv
import hashlib
import json
import shlex
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

CASE = Path(__file__).resolve().parents[2] / "cases" / "cmu_wheel.toml"
# Slip, drag [N], vertical force [N], sinkage [mm]: means of three repeats (C. Pavlov, CMU).
MEASURED = [
    (-1.0, 38.84, 19.50, 50.31),
    (-0.5, 17.15, 23.24, 23.66),
    (0.0, 1.34, 24.58, 14.43),
    (0.23, -0.70, 24.62, 17.88),
    (0.75, -0.82, 24.00, 25.44),
]


def run(coulter, out, overrides):
    """Drag and vertical force [N] and sinkage [mm] over the last 40 % of the tow, and the grade."""
    name = hashlib.sha1(json.dumps(overrides).encode()).hexdigest()[:12]
    folder = out / name
    words = [word for one in overrides for word in ("--set", one)]
    command = list(map(str, [coulter, "run", CASE, "-o", folder, "--auto-resume", "--threads", "1", *words]))
    done = subprocess.run(command, capture_output=True, text=True)
    (out / f"{name}.txt").write_text(" ".join(overrides) + "\n" + done.stdout + done.stderr)
    if not (folder / "summary.json").is_file():
        raise SystemExit(f"no result for {' '.join(overrides)}:\n{done.stdout}{done.stderr}")
    trust = json.loads((folder / "summary.json").read_text())["trust"]
    worst = [check for check in trust["checks"] if check["verdict"] == trust["verdict"] != "good"]
    grade = ", ".join([trust["verdict"], *(f"{check['name']} {check['value']:.3g} {check['unit']}" for check in worst)])
    rows = list(csv.DictReader(open(folder / "forces.csv")))
    column = lambda name: [float(row[name]) for row in rows]
    travel, drag, vertical, sinkage = map(column, ("displacement u [m]", "drag F_H [N]", "vertical F_V [N]", "sinkage z [m]"))
    last = [n for n, u in enumerate(travel) if u > 0.6 * travel[-1]]
    mean = lambda values: sum(values[n] for n in last) / len(last)
    early = [n for n, u in enumerate(travel) if 0.3 * travel[-1] < u <= 0.6 * travel[-1]]
    drift = (mean(sinkage) - sum(sinkage[n] for n in early) / len(early)) * 1e3
    return mean(drag), mean(vertical), 1e3 * mean(sinkage), drift, grade


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("coulter")
    parser.add_argument("out", type=Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--sets", type=Path)
    parser.add_argument("--friction", type=float, nargs="+", default=[0.45])
    parser.add_argument("--rows", type=float, nargs="+", default=[row[0] for row in MEASURED])
    parser.add_argument("--set", action="append", default=[])
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    lines = given.sets.read_text().splitlines() if given.sets else [""]
    sets = [[word for word in shlex.split(line) if word != "--set"] for line in lines]
    with ThreadPoolExecutor(given.jobs) as pool:
        jobs = []
        for number, parameters in enumerate(sets):
            for friction in given.friction:
                for slip, *measured in MEASURED:
                    if slip not in given.rows:
                        continue
                    overrides = [f"body.wheel.spin.slip={slip}", f"body.wheel.weight={measured[1]} N",
                                 f"body.wheel.friction={friction}", *parameters, *given.set]
                    jobs.append((number, friction, slip, measured, pool.submit(run, given.coulter, given.out, overrides)))
        print("set  mu   slip   F_H (measured)   error   z (measured)   error   F_H/F_V (measured)  drift  grade")
        for number, friction, slip, (drag, vertical, depth), job in jobs:
            f_h, f_v, z, drift, grade = job.result()
            # Errors of a drag are relative to the larger of the measured drag and a tenth of the load.
            error = (f_h - drag) / max(abs(drag), 0.1 * vertical)
            print(f"{number}  {friction:.2f}  {slip:+.2f}  {f_h:6.2f} ({drag:6.2f})  {error:+.0%}  {z:5.1f} ({depth:5.1f})  "
                  f"{z / depth - 1:+.0%}  {f_h / f_v:+.2f} ({drag / vertical:+.2f})  {drift:+.1f} mm  {grade}", flush=True)


main()
