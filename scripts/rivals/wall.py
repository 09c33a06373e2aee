#!/usr/bin/env python3
"""Coulter beside other codes at the passive wall of B5: error over processor seconds, one run after another.

    wall.py COULTER                  runs all codes, writes wall.csv and draws docs/images/rivals.svg
    wall.py [COULTER] --only CODE    runs one (coulter, kratos, newton) and leaves the others' rows
    wall.py --draw                   draws the picture from wall.csv
    wall.py --check                  says whether the picture is that of wall.csv; runs and writes nothing

A code whose package this Python does not have is skipped. Standard library only.
"""
import csv
import datetime
import importlib.util
import json
import math
import os
import platform
import resource
import subprocess
import sys
from pathlib import Path
from xml.sax.saxutils import escape

HERE = Path(__file__).resolve().parent
TABLE, PICTURE = HERE / "wall.csv", HERE.parents[1] / "docs" / "images" / "rivals.svg"
REACHED = 0.095     # of the height; a run that stopped before is a mark beside the line of its code
EXACT = math.tan(math.radians(45 + 35 / 2)) ** 2
LIMIT_S = 900
PIC = "transfer_scheme=pic"
# Name in the picture, package, colour of Okabe and Ito (2008), mark, and what each run is given: cells first.
CODES = {
    "coulter": ("Coulter", "", "#0072b2", "circle", ["4", "8", "16", "32"]),
    "kratos": ("Kratos", "KratosMultiphysics", "#d55e00", "square", ["4", "8", "4 ppe=16", "8 ppe=16"]),
    "newton": ("Newton", "newton", "#009e73", "triangle", [f"{n} ny=4 dt=0.01 {PIC}" for n in (4, 8)]),
}
COLUMNS = ["code", "version", "cells", "setting", "whole_s", "loop_s", "factor", "error_percent"]
COLUMNS += ["scatter_percent", "pushed", "machine", "date"]
INK, FAINT = "#1c2127", "#c9cdc8"


def machine():
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def run(code, arguments, coulter):
    """One run in its own process: a row of the table, or None."""
    command = [sys.executable, str(HERE / f"wall_{code}.py"), *([coulter] if code == "coulter" else [])]
    command += arguments.split()
    used = lambda: sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
    print(f"{code} {arguments}: ", end="", flush=True)
    before = used()
    try:
        one = {**os.environ, "OMP_NUM_THREADS": "1"}
        ran = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT_S, env=one)
        result = json.loads(ran.stdout.strip().splitlines()[-1])
        error = 100 * (result["factor"] / EXACT - 1)
    except subprocess.TimeoutExpired:
        print(f"not done within {LIMIT_S} s")
        return None
    except (IndexError, ValueError, KeyError, TypeError):
        print(f"failed: {(ran.stderr.strip().splitlines() or ['no result'])[-1]}")
        return None
    if not math.isfinite(error):
        print("failed: its thrust is not a number")
        return None
    whole = result.get("whole_s", used() - before)
    times = f"{whole:.1f} s, loop {result['loop_s']:.1f} s"
    print(f"K_p {result['factor']:.3f}, {error:+.2f} %; {times}", flush=True)
    row = [code, result["version"], arguments.split()[0], result["setting"], f"{whole:.2f}"]
    row += [f"{result['loop_s']:.2f}", f"{result['factor']:.4f}", f"{error:.2f}"]
    row += [f"{100 * result['scatter'] / EXACT:.2f}", f"{result['pushed']:.3f}"]
    return dict(zip(COLUMNS, [*row, machine(), str(datetime.date.today())]))


def read():
    if not TABLE.is_file():
        sys.exit(f"wall.py: there is no {TABLE.name}; run wall.py COULTER")
    with TABLE.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows or set(rows[0]) != set(COLUMNS):
        sys.exit(f"wall.py: {TABLE.name} does not have the columns {', '.join(COLUMNS)}")
    return rows


# --- the picture ---


def words(x, y, text, anchor="start", colour=INK, size=13, weight="normal"):
    look = f'text-anchor="{anchor}" font-size="{size}" font-weight="{weight}" fill="{colour}"'
    return f'<text x="{x:.1f}" y="{y:.1f}" {look}>{escape(text)}</text>'


def stroke(points, colour, width, dash=""):
    line = "L".join(f"{x:.1f} {y:.1f}" for x, y in points)
    return f'<path d="M{line}" fill="none" stroke="{colour}" stroke-width="{width}"{dash}/>'


def mark(shape, x, y, colour, hollow):
    r, fill = 5.0, "#ffffff" if hollow else colour
    paint = f'fill="{fill}" stroke="{colour}" stroke-width="1.8"'
    if shape == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}" {paint}/>'
    corners = {
        "square": [(-r, -r), (r, -r), (r, r), (-r, r)],
        "triangle": [(0, -1.2 * r), (1.1 * r, 0.9 * r), (-1.1 * r, 0.9 * r)],
        "diamond": [(0, -1.3 * r), (1.3 * r, 0), (0, 1.3 * r), (-1.3 * r, 0)],
    }[shape]
    return f'<polygon points="{" ".join(f"{x + a:.1f},{y + b:.1f}" for a, b in corners)}" {paint}/>'


def picture(rows):
    seconds = lambda row: float(row["whole_s" if row["code"] == "coulter" else "loop_s"])
    error = lambda row: max(abs(float(row["error_percent"])), 0.01)
    left, right, top, bottom = 62.0, 704.0, 14.0, 360.0
    spans = []
    for value in (seconds, error):
        found = [value(row) for row in rows]
        spans.append((math.log10(0.7 * min(found)), math.log10(2.0 * max(found))))

    def place(value, span, begin, end):
        return begin + (math.log10(value) - span[0]) / (span[1] - span[0]) * (end - begin)

    at = lambda row: (place(seconds(row), spans[0], left, right), place(error(row), spans[1], bottom, top))
    parts = ['<rect width="720" height="420" fill="#ffffff"/>']
    for digits in range(-3, 6):
        for unit in (1, 2, 5):
            value = unit * 10.0**digits
            if spans[0][0] <= math.log10(value) <= spans[0][1]:
                x = place(value, spans[0], left, right)
                parts.append(stroke([(x, top), (x, bottom)], FAINT, 0.7))
                parts.append(words(x, bottom + 18, f"{value:g}", "middle"))
            if spans[1][0] <= math.log10(value) <= spans[1][1]:
                y = place(value, spans[1], bottom, top)
                parts.append(stroke([(left, y), (right, y)], FAINT, 0.7))
                parts.append(words(left - 7, y + 4.5, f"{value:g}", "end"))
    for code, (name, _, colour, shape, _) in CODES.items():
        own = [row for row in rows if row["code"] == code]
        if not own:
            continue
        whole = [row for row in own if float(row["pushed"]) >= REACHED]
        for one, other in zip(whole, whole[1:]):
            # Where the sign changes the error vanishes somewhere between: no line leads there.
            turns = float(one["error_percent"]) * float(other["error_percent"]) < 0
            dash = ' stroke-dasharray="2 6"' if turns else ""
            parts.append(stroke([at(one), at(other)], colour, 2, dash))
        for row in own:
            x, y = at(row)
            parts.append(mark(shape, x, y, colour, float(row["error_percent"]) > 0))
            if row in whole:
                parts.append(words(x - 8, y - 7, row["cells"], "end", colour))
            else:
                note = f"{row['cells']}, stops at {float(row['pushed']):.2f} H"
                parts.append(words(x + 9, y - 5, note, "start", colour))
        x, y = at(whole[-1] if whole else own[-1])
        parts.append(words(x + 10, y + 11, name, "start", colour, 14, "bold"))
    middle, side = 0.5 * (left + right), words(0, 0, "error of the thrust [%]", "middle")
    parts.append(words(middle, bottom + 38, "processor seconds, one thread", "middle"))
    note = "at the marks: cells over the wall's height; hollow: thrust too large; dotted: the sign changes"
    parts.append(words(middle, bottom + 55, note, "middle", INK, 12))
    parts.append(f'<g transform="translate(18 {0.5 * (top + bottom):.0f}) rotate(-90)">{side}</g>')
    head = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 420" width="720" height="420" '
    head += 'font-family="DejaVu Sans, sans-serif" role="img" '
    head += 'aria-label="Error of the thrust on a passive wall over processor seconds, for several codes">\n'
    return head + "\n".join(parts) + "\n</svg>\n"


def measure(coulter, only):
    rows, new = [row for row in read() if row["code"] != only] if only and TABLE.is_file() else [], []
    for code, (_, package, *_, runs) in CODES.items():
        if only not in (None, code):
            continue
        if package and importlib.util.find_spec(package) is None:
            print(f"{code}: skipped, since this Python has no package {package}")
            continue
        new += filter(None, (run(code, arguments, coulter) for arguments in runs))
    if not new:
        sys.exit("wall.py: no run gave a result; nothing written")
    rows = sorted(rows + new, key=lambda row: list(CODES).index(row["code"]))
    with TABLE.open("w", encoding="utf-8", newline="") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    PICTURE.write_text(picture(rows), encoding="utf-8")


def main():
    given, only = sys.argv[1:], None
    if given[-2:-1] == ["--only"]:
        given, only = given[:-2], given[-1]
        if only not in CODES:
            sys.exit(f"wall.py: no code {only}; there are {', '.join(CODES)}")
    if given == ["--check"] and not only:
        if not PICTURE.is_file() or PICTURE.read_text(encoding="utf-8") != picture(read()):
            sys.exit("wall.py: docs/images/rivals.svg is not that of wall.csv; run wall.py --draw")
    elif given == ["--draw"] and not only:
        PICTURE.write_text(picture(read()), encoding="utf-8")
    elif len(given) == 1 and not given[0].startswith("-"):
        if not os.access(given[0], os.X_OK) or Path(given[0]).is_dir():
            sys.exit(f"wall.py: {given[0]} is not a program")
        measure(str(Path(given[0]).resolve()), only)
    elif not given and only not in (None, "coulter"):
        measure("", only)
    else:
        sys.exit("usage: wall.py COULTER | [COULTER] --only CODE | --draw | --check")


if __name__ == "__main__":
    main()
