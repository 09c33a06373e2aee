#!/usr/bin/env python3
"""Draws docs/images/wheel_drag.svg: drag of the measured wheel over its slip, beside solver and closed form.

    chart.py COULTER [-o FILE]

What was measured and computed is read from the table "The wheel" of validation/D6_wheel/README.md; the closed form and its
interval are those of `coulter forecast cases/cmu_wheel.toml` at the slip and the vertical force of each row.

Python 3 with matplotlib (tried with 3.10).
"""

import argparse
import json
import re
import subprocess
from pathlib import Path

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
MEASURED, SOLVER, CLOSED = "#1c2127", "#0072b2", "#d55e00"


def rows():
    """Slip, vertical force, computed and measured drag [N] of every row of the table."""
    text = (ROOT / "validation" / "D6_wheel" / "README.md").read_text().split("## The wheel")[1]
    table = [line.strip("|").split("|") for line in text.splitlines() if line.startswith("|")][2:7]
    number = lambda cell: float(re.sub(r"\(.*\)", "", cell).strip().replace("−", "-"))
    return [tuple(map(number, line[:4])) for line in table]


def forecast(coulter, slip, load):
    """Drag of the recommended closed form, and the ends of its interval [N]."""
    values = [f"body.wheel.spin.slip={slip}", f"body.wheel.weight={load} N"]
    words = [word for value in values for word in ("--set", value)]
    command = [coulter, "forecast", ROOT / "cases" / "cmu_wheel.toml", "--json", *words]
    model = json.loads(subprocess.run(command, capture_output=True, check=True).stdout)["models"][0]
    interval = model["interval"]["drag_N"]
    return model["drag_N"], interval["low"], interval["high"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("coulter")
    parser.add_argument("-o", type=Path, default=ROOT / "docs" / "images" / "wheel_drag.svg")
    arguments = parser.parse_args()
    slip, load, computed, measured = zip(*rows())
    closed, low, high = zip(*(forecast(arguments.coulter, *row) for row in zip(slip, load)))
    plt.rcParams.update({"svg.hashsalt": "coulter", "font.family": "DejaVu Sans", "font.size": 10})
    figure, axes = plt.subplots(figsize=(6.4, 3.5))
    axes.axhline(0, color="#d9dcd8", linewidth=1)
    axes.fill_between(slip, low, high, color=CLOSED, alpha=0.14, linewidth=0, label="interval of the closed form (90 %)")
    axes.plot(slip, closed, "--", color=CLOSED, linewidth=1.6, label="closed form (coulter forecast)")
    axes.plot(slip, computed, "-o", color=SOLVER, linewidth=1.6, markersize=5, label="solver (coulter run)")
    axes.plot(slip, measured, "D", color=MEASURED, markersize=6, label="measured (mean of three)")
    axes.set_xlabel("slip (−1: locked, 0: rolling)")
    axes.set_ylabel("drag [N]")
    axes.spines[["top", "right"]].set_visible(False)
    handles, labels = axes.get_legend_handles_labels()
    order = [3, 2, 1, 0]
    axes.legend([handles[n] for n in order], [labels[n] for n in order], frameon=False)
    figure.tight_layout()
    figure.savefig(arguments.o, facecolor="white", metadata={"Date": None})


main()
