#!/usr/bin/env python3
"""Kills a run at random moments and starts it again until it has finished, on changing numbers of threads.

CSV files, fields, time lists and checkpoints of every finished run must be those of a run that nobody killed, byte for
byte; so must summary.json, but for the wall clock. After every kill `coulter report` must work on what there is.

    kills.py path/to/coulter [--kills 300] [--seed 1] [--short]

Exits with 1 if anything differs. Python 3, standard library only.
"""

import argparse
import hashlib
import json
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

CASE = """
format = 2

[soil]
law = "mohr-coulomb"
friction_angle = "35 deg"
unit_weight = "16 kN/m^3"
young_modulus = "5 MPa"

[domain]
x = ["-0.35 m", "0.55 m"]
y = ["0 m", "0.3 m"]
z = ["-0.25 m", "0.1 m"]
symmetric = true

[grid]
cell = "20 mm"
growth = 1.15

[body.disc]
shape = "disc"
diameter = "0.2 m"
thickness = "0.08 m"
friction = 0.3
weight = "60 N"
forward = { speed = "0.2 m/s", start = "0.3 s" }
heave = "free"
spin = "free"

[run]
tow_distance = "0.12 m"

[output]
history_interval = "5 ms"
field_interval = "60 ms"
checkpoint_interval = "0.15 s"
"""

# How likely each signal is, and the exit code that must follow (negative: the signal's own, where no handler is set yet).
SIGNALS = [
    (signal.SIGKILL, 0.5, {-signal.SIGKILL}),
    (signal.SIGTERM, 0.2, {143, -signal.SIGTERM}),
    (signal.SIGINT, 0.15, {130, -signal.SIGINT}),
    (signal.SIGHUP, 0.15, {129, -signal.SIGHUP}),
]


def fingerprint(folder):
    """Hash of every file whose bytes must not depend on how often the run was stopped."""
    prints = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.suffix in (".csv", ".vtr", ".vtp", ".pvd", ".checkpoint") and path.is_file():
            prints[name] = hashlib.sha256(path.read_bytes()).hexdigest()
        if path.suffix in (".part", ".lock"):
            prints[name] = "must not be left behind"
    summary = json.loads((folder / "summary.json").read_text())
    summary.pop("wall_s")
    prints["summary.json"] = json.dumps(summary, sort_keys=True)
    return prints


def start(program, case, folder, threads):
    command = [program, "run", case, "-o", folder, "--auto-resume", "--threads", str(threads)]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--kills", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--short", action="store_true", help="20 kills")
    options = parser.parse_args()
    wanted = 20 if options.short else options.kills
    draw = random.Random(options.seed)
    faults, kills, runs, requests = [], 0, 0, 0
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)
        case = scratch / "kills.toml"
        case.write_text(CASE)
        began = time.monotonic()
        run = start(options.program, case, scratch / "whole", 1)
        _, told = run.communicate()
        if run.returncode != 0:
            sys.exit(f"the uninterrupted run ends with {run.returncode}: {told}")
        whole, seconds = fingerprint(scratch / "whole"), time.monotonic() - began
        while kills < wanted:
            folder = scratch / f"run-{runs}"
            runs += 1
            while True:
                run = start(options.program, case, folder, draw.choice([1, 2, 3]))
                delay = draw.choice([0.02, 0.2, 0.8]) * seconds * draw.random()
                try:
                    _, told = run.communicate(timeout=delay if kills < wanted else None)
                    if run.returncode != 0:
                        faults.append(f"run {runs}: ends with {run.returncode}: {told}")
                    break
                except subprocess.TimeoutExpired:
                    pass
                if draw.random() < 0.2:
                    run.send_signal(signal.SIGUSR1)
                    requests += 1
                    time.sleep(0.02)
                number, _, codes = draw.choices(SIGNALS, [weight for _, weight, _ in SIGNALS])[0]
                run.send_signal(number)
                _, told = run.communicate()
                # It may have finished just before.
                if run.returncode == 0:
                    break
                kills += 1
                # A request for a checkpoint before the handlers are set ends the program as well.
                if run.returncode not in codes | {-signal.SIGUSR1}:
                    faults.append(f"run {runs}: signal {number} gives {run.returncode}: {told}")
                if (folder / "run.json").exists() and draw.random() < 0.2:
                    report = subprocess.run([options.program, "report", folder], capture_output=True, text=True)
                    # Nothing to tell yet is a refusal with reasons.
                    if report.returncode not in (0, 2) or "panick" in report.stderr:
                        faults.append(f"run {runs}: report gives {report.returncode}: {report.stderr}")
            found = fingerprint(folder)
            for name in sorted(whole.keys() | found.keys()):
                if whole.get(name) != found.get(name):
                    faults.append(f"run {runs}: {name} differs")
            if len(faults) > 20:
                break
    for fault in faults:
        print(fault)
    print(
        f"{kills} kills and {requests} requests for a checkpoint in {runs} runs: {len(faults)} faults; "
        f"{len(whole)} files compared after each run"
    )
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
