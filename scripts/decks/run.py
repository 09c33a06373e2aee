#!/usr/bin/env python3
"""Runs the ten decks of crates/import/decks, from import to report, and prints force, closed form, grade and time.

usage: scripts/decks/run.py COULTER [NAME ...] [--set KEY=VALUE ...] [--keep FOLDER]

The force is the last filtered one; the closed form that of `coulter forecast` at the depth where the run ends. Keys are set in the
case, which is kept with its results in FOLDER.
"""

import argparse
import csv
import json
import subprocess
import tempfile
import time
from pathlib import Path

DECKS = Path(__file__).resolve().parents[2] / "crates" / "import" / "decks"
# Model of the forecast. The others have no closed form.
MODELS = {"plate": "bearing capacity", "plough": "PW plane strain", "anchor": "uplift", "spudcan": "cone or pile",
          "pile": "cone or pile", "cone": "cone or pile"}
TOWED = {"plough", "wheel", "disc", "pipe"}


def closed_form(coulter, case, name, keys):
    if name not in MODELS:
        return None
    printed = subprocess.run([coulter, "forecast", "--json", str(case), *keys], capture_output=True, text=True, check=True).stdout
    model = next(model for model in json.loads(printed)["models"] if model["name"] == MODELS[name])
    return model["drag_N" if name in TOWED else "vertical_N"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("coulter", type=Path)
    parser.add_argument("names", nargs="*", default=sorted(path.stem for path in DECKS.glob("*.inp")))
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--keep", type=Path)
    arguments = parser.parse_args()
    coulter = str(arguments.coulter.resolve())
    keys = [f"--set={key}" for key in arguments.set]
    print("| deck | force [N] | closed form [N] | difference | grade | time [s] |\n|---|--:|--:|--:|---|--:|")
    for name in arguments.names:
        with tempfile.TemporaryDirectory() as folder:
            folder = arguments.keep or Path(folder)
            folder.mkdir(exist_ok=True)
            case, results = folder / f"{name}.toml", folder / name
            began = time.monotonic()
            subprocess.run([coulter, "import", str(DECKS / f"{name}.inp"), "-o", str(case), "--force"], capture_output=True, check=True)
            run = subprocess.run([coulter, "run", str(case), "-o", str(results), "--force", *keys], capture_output=True, text=True)
            seconds = time.monotonic() - began
            summary = json.loads((results / "summary.json").read_text()) if (results / "summary.json").is_file() else {}
            grade = summary.get("trust", {}).get("verdict", run.stderr.strip()[:60] or "none")
            force, ratio = "–", "–"
            expected = closed_form(coulter, case, name, keys)
            if summary.get("bodies"):
                rows = list(csv.DictReader((results / "filtered.csv").open()))
                column = "drag F_H [N]" if name in TOWED else "vertical F_V [N]"
                force = float(rows[-1][column])
                ratio = f"{100 * (force / expected - 1):+.1f} %" if expected else "–"
                force = f"{force:.5g}"
            print(f"| {name} | {force} | {f'{expected:.5g}' if expected else '–'} | {ratio} | {grade} | {seconds:.0f} |", flush=True)


main()
