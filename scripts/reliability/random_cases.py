#!/usr/bin/env python3
"""Runs random valid cases and asks whether their grades can be believed.

Every case is drawn within the documented ranges of the case file, on a coarse grid: half of them anything goes, half of
them resolved as a careful user would. None may panic, hang or end otherwise than docs/reliability.md says. For every run
that is graded good this script looks for itself, in the CSV files, at motion, energy balance and leak. The first graded
good are run again on cells of two thirds the size: the drag of a towed body, the vertical force of any other, must be
within 25 % in nine of ten.

    random_cases.py path/to/coulter [--count 500] [--finer 60] [--seed 1] [--jobs 2] [--short] [--keep DIR]

With --keep every outcome is written down as soon as it is known; given again, the same command continues from there, as
long as the program is the same to the byte.

Exits with 1 if a promise is broken. Python 3, standard library only.
"""

import argparse
import csv
import hashlib
import json
import math
import random
import shutil
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

TIME_LIMIT = 240  # seconds for one run; the longest takes a quarter of it on an idle core
WORK_LIMIT = 1e8  # cell-steps above which a case is drawn again


def si(value, unit):
    return f'"{value:.6g} {unit}"'


class Case:
    """A case as a tree of TOML values, with the few numbers that the checks need."""

    def __init__(self, draw, careful=False):
        self.draw = draw
        self.careful = careful or draw.random() < 0.6
        self.soil()
        self.body()
        self.motion()

    def soil(self):
        draw, soil = self.draw, {}
        self.law = draw.choices(["mohr-coulomb", "tresca", "von-mises", "elastic"], [80, 15, 3, 2])[0]
        self.gamma = draw.uniform(8e3, 20e3)
        soil["law"] = f'"{self.law}"'
        soil["unit_weight"] = si(self.gamma, "N/m^3")
        # Scaled by the body's size below.
        self.stiffness = 10 ** (draw.uniform(2.0, 2.8) if self.careful else draw.uniform(1.5, 3.2))
        if self.law == "mohr-coulomb":
            self.phi = draw.uniform(15, 42) if self.careful else draw.uniform(0.5, 60)
            soil["friction_angle"] = si(self.phi, "deg")
            if draw.random() < (0.15 if self.careful else 0.5):
                soil["dilation_angle"] = si(self.phi * draw.random(), "deg")
            if draw.random() < 0.25:
                soil["cohesion"] = si(10 ** draw.uniform(1, 4), "Pa")
        elif self.law == "tresca":
            soil["shear_strength"] = si(10 ** draw.uniform(3, 4), "Pa")
        elif self.law == "von-mises":
            soil["yield_stress"] = si(10 ** draw.uniform(3, 4.5), "Pa")
        soil["poisson_ratio"] = f"{draw.uniform(0.05, 0.45) if draw.random() < 0.5 else 0.3:.3g}"
        self.sections = {"soil": soil}

    def body(self):
        draw, body = self.draw, {}
        scale = 10 ** draw.uniform(-1.3, 0.0)
        self.sections["soil"]["young_modulus"] = si(self.stiffness * self.gamma * scale, "Pa")
        shape = draw.choice(["disc", "block", "cylinder", "sphere"])
        self.plane_strain = shape != "sphere" and draw.random() < (0.6 if self.careful else 0.3)
        self.diameter = None
        body["shape"] = f'"{shape}"'
        slender = draw.uniform(0.35, 1.5)
        if shape == "block":
            size = [scale * draw.uniform(0.4, 1.5), scale * slender, scale]
            edges = [size[0], size[2]] if self.plane_strain else size
            body["size"] = "[" + ", ".join(si(e, "m") for e in edges) + "]"
            self.height, narrow = scale, min(edges)
            if draw.random() < 0.2:
                body["pitch"] = si(draw.uniform(-60, 60), "deg")
        else:
            body["diameter"] = si(scale, "m")
            self.height, narrow = scale, scale
            self.diameter = scale
            if shape == "disc" and not self.plane_strain:
                body["thickness"] = si(scale * slender, "m")
                narrow = min(scale, scale * slender)
            if shape == "cylinder":
                axis = "y" if self.plane_strain else draw.choice("xyz")
                body["axis"] = f'"{axis}"'
                if not self.plane_strain:
                    body["length"] = si(scale * slender, "m")
                    narrow = min(scale, scale * slender)
                    self.height = scale * slender if axis == "z" else scale
        cells = draw.uniform(7, 12) if self.careful else draw.uniform(2.1, 7)
        if self.plane_strain and self.careful:
            cells *= 1.5
        self.cell = narrow / cells
        body["friction"] = draw.choice([f"{draw.uniform(0, 0.8):.3g}", f"{draw.uniform(0.1, 0.6):.3g}", '"rough"'])
        self.scale = scale
        self.sections["body.thing"] = body
        self.sections["grid"] = {"cell": si(self.cell, "m")}
        self.sections["domain"] = {}
        if self.plane_strain:
            self.sections["domain"]["plane_strain"] = "true"
        elif draw.random() < 0.8:
            self.sections["domain"]["symmetric"] = "true"
        else:
            # Drawn apart, so that the other cases of a seed stay as they are.
            apart = random.Random(self.cell)
            body["yaw"], body["tilt"] = si(apart.uniform(-60, 60), "deg"), si(apart.uniform(-30, 30), "deg")

    def motion(self):
        draw, body = self.draw, self.sections["body.thing"]
        gravity = 9.81
        # Speeds as multiples of that at which inertia matters.
        speed = math.sqrt(gravity * self.scale) * (draw.uniform(0.05, 0.15) if self.careful else 10 ** draw.uniform(-1.3, 0.3))
        ramp = draw.uniform(0.1, 0.3) * self.scale / speed
        self.kind = draw.choices(["held", "free", "pressed", "loaded", "dropped"], [40, 25, 20, 10, 5])[0]
        self.towed = self.kind in ("held", "free")
        if self.kind == "held":
            depth = draw.uniform(0.4, 0.9) if self.careful else draw.uniform(0.0, 1.1)
            body["sinkage"] = si(depth * self.height, "m")
        volume = self.scale**3
        if self.kind in ("free", "loaded", "dropped"):
            pressure = self.gamma * self.scale * 10 ** (draw.uniform(0.0, 0.8) if self.careful else draw.uniform(-2, 1.5))
            if self.plane_strain:
                body["mass"] = si(pressure * self.scale / gravity, "kg")
            else:
                body["weight"] = si(pressure * volume / self.scale, "N")
            body["heave"] = f"{{ load = \"0 N\", ramp = {si(ramp, 's')} }}"
        run = {}
        if self.towed:
            start = draw.uniform(1, 3) * ramp if self.kind == "free" else 0
            body["forward"] = f"{{ speed = {si(speed, 'm/s')}, start = {si(start, 's')}, ramp = {si(ramp, 's')} }}"
            self.travel = self.scale * (draw.uniform(0.8, 1.5) if self.careful else draw.uniform(0.2, 1.5))
            run["tow_distance"] = si(self.travel, "m")
            if self.diameter and draw.random() < 0.5 and "mass" not in body:
                body["spin"] = draw.choice(['"free"', '"locked"'])
                if body["spin"] == '"free"' and self.kind == "held":
                    body["mass"] = si(2000 * volume, "kg")
        elif self.kind == "pressed":
            goal = self.height * (draw.uniform(0.3, 0.8) if self.careful else draw.uniform(0.05, 1.0))
            body["heave"] = f"{{ speed = {si(-speed, 'm/s')}, ramp = {si(ramp, 's')} }}"
            run["duration"] = si(goal / speed + 0.5 * ramp, "s")
            self.travel = 0
        else:
            if self.kind == "dropped":
                body["sinkage"] = si(-draw.uniform(0.05, 1.0) * self.scale, "m")
            run["duration"] = si(draw.uniform(1.0, 3.0) * math.sqrt(self.scale / gravity) + 2 * ramp, "s")
            self.travel = 0
        if not self.careful and draw.random() < 0.3:
            self.sections["numerics"] = draw.choice(
                [
                    {"courant": f"{draw.uniform(0.1, 1.0):.3g}"},
                    {"contact": '"penalty"'},
                    {"hourglass": f"{10 ** draw.uniform(-3, -1):.3g}"},
                    {"precision": '"single"'},
                    {"remap_displacement": f"{draw.uniform(0.02, 0.5):.3g}"},
                ]
            )
        self.sections["run"] = run
        self.sections["output"] = {"field_interval": '"1 h"'}

    def text(self, cell=None):
        lines = ["format = 2", ""]
        for name, keys in self.sections.items():
            lines.append(f"[{name}]")
            lines += [f"{key} = {value}" for key, value in keys.items()]
            lines.append("")
        text = "\n".join(lines)
        return text if cell is None else text.replace(f'cell = {si(self.cell, "m")}', f'cell = {si(cell, "m")}')


def check(program, case, path):
    """The costs as `coulter check` tells them; None if the case is refused (with its words)."""
    path.write_text(case.text())
    told = subprocess.run([program, "check", path, "--json"], capture_output=True, text=True, timeout=60)
    if told.returncode == 0:
        return json.loads(told.stdout)["cost"], ""
    return None, f"{told.returncode}: {told.stderr}"


def run(program, text, folder):
    """Exit code (None for a hang), summary (None if there is none) and what was told on standard error."""
    path = folder.with_suffix(".toml")
    path.write_text(text)
    command = [program, "run", path, "-o", folder, "--threads", "1", "--json"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=TIME_LIMIT)
    except subprocess.TimeoutExpired:
        return None, None, "no end in sight"
    summary = folder / "summary.json"
    return done.returncode, json.loads(summary.read_text()) if summary.exists() else None, done.stderr


def column(folder, name, file="forces.csv"):
    with open(folder / file) as lines:
        return [float(line[name] or "nan") for line in csv.DictReader(lines)]


def out_of_bounds(case, folder):
    """What is wrong with motion, energy balance or leak of a run, by its CSV files alone."""
    faults = []
    sinkage, leak, embedded = (column(folder, n) for n in ("sinkage z [m]", "leak [m^3]", "embedded [m^3]"))
    numbers = sinkage + [v for n in ("drag F_H [N]", "vertical F_V [N]", "spin [rad/s]", "speed v [m/s]") for v in column(folder, n)]
    if not all(math.isfinite(v) for v in numbers):
        faults.append("not a number")
    if embedded[-1] > case.cell**3 and leak[-1] > 5.001e-3 * embedded[-1]:
        faults.append(f"leak {leak[-1] / embedded[-1]:.2e}")
    closure = column(folder, "closure [-]", "energy.csv")[-1]
    if abs(closure) > 0.01:
        faults.append(f"energy balance {closure:.3f}")
    tail = sinkage[2 * len(sinkage) // 3 :]
    if case.kind in ("free", "loaded") and sum(tail) / len(tail) < -0.06 * case.height:
        faults.append(f"lifted to {-tail[-1]:.3g} m")
    if max(sinkage) > 5 * case.height:
        faults.append(f"sunk to {max(sinkage):.3g} m")
    return faults


def force(case, summary):
    body = summary["bodies"]["thing"]
    return body["steady"]["drag_N" if case.towed else "vertical_N"]


class Outcomes:
    """What came of the runs of one program; kept in a file, one line of JSON for each, if there is a folder for it."""

    def __init__(self, program, keep):
        self.program, self.known, self.file, self.lock = program, {}, None, threading.Lock()
        if keep:
            Path(keep).mkdir(parents=True, exist_ok=True)
            digest = hashlib.sha256(Path(program).read_bytes()).hexdigest()
            path = Path(keep) / f"outcomes-{digest[:12]}.jsonl"
            if path.exists():
                # The last line may have been cut short.
                lines = (line for line in path.read_text().splitlines() if line.endswith("}"))
                self.known = {entry["case"]: entry for entry in map(json.loads, lines)}
            self.file = open(path, "a")

    def of(self, case, text, folder):
        """Exit code, summary, standard error, and what is wrong with a run that is graded good."""
        key = hashlib.sha256(text.encode()).hexdigest()
        if key not in self.known:
            code, summary, told = run(self.program, text, folder)
            is_good = summary is not None and code in (0, 1) and summary["trust"]["verdict"] == "good"
            entry = {
                "case": key,
                "code": code,
                "summary": summary and {name: summary[name] for name in ("trust", "bodies")},
                "told": told[-400:],
                "wrong": out_of_bounds(case, folder) if is_good else [],
            }
            shutil.rmtree(folder, ignore_errors=True)
            with self.lock:
                self.known[key] = entry
                if self.file:
                    print(json.dumps(entry), file=self.file, flush=True)
        entry = self.known[key]
        return entry["code"], entry["summary"], entry["told"], entry["wrong"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=500)
    parser.add_argument("--finer", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--short", action="store_true", help="50 cases, none of them finer")
    parser.add_argument("--keep", help="folder for a line of JSON per case")
    options = parser.parse_args()
    if options.short:
        options.count, options.finer = 50, 0
    faults, refused, records = [], [], []
    outcomes = Outcomes(options.program, options.keep)
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)

        def one(n, careful=False):
            case_draw = random.Random(f"{options.seed}-{n}")
            while True:
                case = Case(case_draw, careful)
                cost, why = check(options.program, case, scratch / f"{n}.check.toml")
                if cost is None:
                    refused.append(why)
                elif cost["filled_cells"] * cost["steps"] <= WORK_LIMIT:
                    break
            folder = scratch / f"case-{n}"
            code, summary, told, wrong = outcomes.of(case, case.text(), folder)
            record = {"n": n, "kind": case.kind, "careful": case.careful, "code": code, "verdict": None}
            if code not in (0, 1):
                faults.append(f"case {n}: ends with {code}: {told[-400:]}\n{case.text()}")
            elif summary is None:
                faults.append(f"case {n}: no summary: {told[-400:]}")
            else:
                trust = summary["trust"]
                record["verdict"] = trust["verdict"]
                record["checks"] = {c["name"]: c["value"] for c in trust["checks"]}
                record["doubts"] = [c["name"] for c in trust["checks"] if c["verdict"] != "good"]
                record["force"] = force(case, summary)
                if (code == 1) != (trust["verdict"] == "broken"):
                    faults.append(f"case {n}: graded {trust['verdict']}, exit code {code}")
                faults.extend(f"case {n}: graded good with {w}" for w in wrong)
            records.append(record)
            return case, record

        def finer(pair):
            case, record = pair
            text = case.text(case.cell / 1.5)
            code, summary, told, _ = outcomes.of(case, text, scratch / f"finer-{record['n']}")
            if summary is None or code not in (0, 1):
                faults.append(f"case {record['n']}, finer: ends with {code}: {told[-400:]}")
                return
            record["finer"] = force(case, summary)
            record["finer_verdict"] = summary["trust"]["verdict"]

        with ThreadPoolExecutor(options.jobs) as team:
            done = list(team.map(one, range(options.count)))
            good = [pair for pair in done if pair[1]["verdict"] == "good"]
            # Where too few are good, careful ones are drawn until there are enough, within reason.
            while len(good) < options.finer and len(done) < 4 * options.count:
                more = list(team.map(lambda n: one(n, True), range(len(done), len(done) + 10)))
                done += more
                good += [pair for pair in more if pair[1]["verdict"] == "good"]
            list(team.map(finer, good[: options.finer]))
        if options.keep:
            lines = [json.dumps(record) + "\n" for record in sorted(records, key=lambda r: r["n"])]
            (Path(options.keep) / f"seed-{options.seed}.jsonl").write_text("".join(lines))
            for case, record in done:
                (Path(options.keep) / f"case-{options.seed}-{record['n']}.toml").write_text(case.text())

    count = {v: sum(r["verdict"] == v for r in records) for v in ("good", "doubtful", "broken")}
    print(f"{len(records)} cases (seed {options.seed}): {count}; {len(refused)} drawings refused by check")
    for why in refused:
        if "panick" in why or not why.startswith("2"):
            faults.append(f"check: {why}")
    compared = [r for r in records if r.get("finer") is not None]
    near = [r for r in compared if abs(r["finer"] - r["force"]) <= 0.25 * max(abs(r["finer"]), abs(r["force"]))]
    if options.finer:
        fraction = len(near) / len(compared) if compared else 0
        print(f"{len(near)} of {len(compared)} graded good are within 25 % on cells of two thirds the size ({100 * fraction:.0f} %)")
        for r in compared:
            if r not in near:
                print(f"  case {r['n']} ({r['kind']}): {r['force']:.4g} N, finer {r['finer']:.4g} N")
        if len(compared) < options.finer or fraction < 0.9:
            faults.append("too few graded good are near their finer selves")
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
