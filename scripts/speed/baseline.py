#!/usr/bin/env python3
"""Measures how fast the solver is on this machine, and renews the table of docs/reference/performance.md.

baseline.py COULTER NAME    NAME of the machine, such as "Zen 5, 2 cores"; its rows of baseline.csv are replaced
baseline.py --check         whether the table is that of baseline.csv; runs nothing

Each row is the median of three runs of a command. Run it on a quiet machine.
"""

import csv
import datetime
import json
import os
import pathlib
import shlex
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TABLE, PAGE = HERE / "baseline.csv", HERE.parents[1] / "docs" / "reference" / "performance.md"
BEGIN, END = "<!-- made by scripts/speed/baseline.py -->\n", "<!-- end -->\n"
RUNS = 3
COMMANDS = [
    "bench",
    'bench --set grid.cell="10 mm" --steps 600 --warm-up 200',
    'bench --set grid.cell="5 mm" --steps 200 --warm-up 300',
    "bench --threads 1 --set numerics.precision=single",
    "bench cases/towed_disc.toml --warm-up 8000 --steps 3000",
]
FIELDS = ["machine", "date", "command", "cells", "yielding", "speed", "two_threads", "multiply_add", "bytes_per_cell"]
HEADER = """| machine | `coulter …` | cells with soil | yields | million cell-steps per core-second | cell-steps per million \
operations of the multiply-add test | all threads, times one | bytes per cell |
|---|---|--:|--:|--:|--:|--:|--:|
"""


def measured(coulter, command):
    arguments = [coulter, *shlex.split(command), "--json"]
    run = subprocess.run(arguments, capture_output=True, text=True, cwd=HERE.parents[1])
    if run.returncode != 0:
        sys.exit(f"coulter {command}: {run.stderr.strip()}")
    return json.loads(run.stdout)


def row(coulter, machine, command):
    runs = [measured(coulter, command) for _ in range(RUNS)]
    of = lambda key: statistics.median(run[key] or 0 for run in runs)  # noqa: E731
    return {
        "machine": machine,
        "date": datetime.date.today().isoformat(),
        "command": command,
        "cells": round(of("filled_cells") / 100) * 100,
        "yielding": round(of("yielding"), 2),
        "speed": round(of("million_cell_steps_per_core_second"), 1),
        "two_threads": round(of("speed_up"), 2) if "--threads" not in command else "",
        "multiply_add": round(of("fma_GFLOP_per_s")),
        "bytes_per_cell": round(of("bytes_per_cell")),
    }


def drawn(rows):
    line = "| {machine}, {date} | `{command}` | {cells:.0f} | {yields:.0f} % | {speed} | {ratio} | {two_threads} | \
{bytes_per_cell} |\n"
    text = HEADER
    for row in rows:
        numbers = {"cells": float(row["cells"]), "yields": 100 * float(row["yielding"])}
        # Of rows that were measured before this script, not all is known.
        known = row["multiply_add"] != ""
        ratio = f"{1000 * float(row['speed']) / float(row['multiply_add']):.0f}" if known else ""
        text += line.format(**{**row, **numbers}, ratio=ratio)
    return text


def page_with(rows):
    text = PAGE.read_text()
    before, rest = text.split(BEGIN)
    return before + BEGIN + drawn(rows) + END + rest.split(END, 1)[1]


def main():
    rows = list(csv.DictReader(TABLE.open())) if TABLE.exists() else []
    if sys.argv[1:] == ["--check"]:
        if page_with(rows) != PAGE.read_text():
            sys.exit("docs/reference/performance.md does not show scripts/speed/baseline.csv: run baseline.py")
        return
    if len(sys.argv) != 3 or not os.access(sys.argv[1], os.X_OK):
        sys.exit(__doc__.strip())
    coulter, machine = os.path.abspath(sys.argv[1]), sys.argv[2]
    rows = [row for row in rows if row["machine"] != machine]
    for command in COMMANDS:
        rows.append(row(coulter, machine, command))
        print(rows[-1], flush=True)
    with TABLE.open("w") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    PAGE.write_text(page_with(rows))


main()
