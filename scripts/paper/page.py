#!/usr/bin/env python3
"""Writes the table of docs/studies/paper.md from the table of the study cases/studies/paper.toml.

    page.py FOLDER      takes table.csv and figures of the folder of the study, and writes docs/data/paper.csv, docs/images/paper and the page
    page.py [--check]   from docs/data/paper.csv; with --check nothing is written, and the page must be that of the data

A point of both models agrees where the closed form lies in the interval of the solver, or the solver in that of the closed form (5 to
95 %): the drag always, the vertical force of a disc that is held, the sinkage of one that is free. Python 3.11, standard library only.
"""

import csv
import math
import re
import shutil
import statistics
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "studies" / "paper.md"
DATA = ROOT / "docs" / "data" / "paper.csv"
BEGIN, END = "<!-- Below: scripts/paper/page.py -->", "<!-- Above: scripts/paper/page.py -->"
# What of the table of the study is kept.
KEPT = [
    "point", "id", "part", "model", "body", "W_bar", "phi", "psi", "cohesion", "E", "density", "t_bar", "d", "depth", "axle", "spacing",
    "drag", "vertical", "F_H_bar", "F_H_bar_low", "F_H_bar_high", "F_V_bar", "F_V_bar_low", "F_V_bar_high", "Z", "Z_low", "Z_high",
    "turn_ratio", "state", "grade",
]  # fmt: skip
# Of each part what it varies, with how it is shown; others repeat points of these.
PARTS = {
    "fixed": ("held in sand", ["axle", "depth"]),
    "fixed_textbook": ("held in textbook soil", ["axle", "depth"]),
    "strength": ("free, friction angle", ["phi", "W_bar"]),
    "dilation": ("free, dilation angle", ["psi", "W_bar"]),
    "cohesion": ("free, cohesion", ["cohesion", "W_bar"]),
    "stiffness": ("free, stiffness", ["E", "W_bar"]),
    "thickness": ("free, thickness", ["t_bar", "W_bar"]),
    "diameter": ("free, diameter", ["d"]),
    "density": ("free, density of sand", ["density", "W_bar"]),
    "rockhopper": ("three discs on an axle", ["spacing"]),
    "single": ("one of the three alone", []),
    "wing": ("four discs, swept by 45°", []),
}
HELD = ("fixed", "fixed_textbook")


def read(path):
    """The leading row of every case: of several bodies all together. Headers lose their units."""
    with open(path, encoding="utf-8", newline="") as file:
        lines = list(csv.reader(file))
    head = [name.split(" [")[0] for name in lines[0]]
    rows, seen = [], set()
    for line in lines[1:]:
        row = dict(zip(head, line))
        # A run that stands in several parts counts once.
        if row["id"] not in seen:
            seen.add(row["id"])
            rows.append({name: row.get(name, "") for name in KEPT})
    return rows


def short(text, digits=3):
    if text == "":
        return ""
    try:
        return f"{float(text):.{digits}g}"
    except ValueError:
        return text


def number(row, name):
    return float(row[name]) if row.get(name) else None


def inside(value, row, name):
    low, high = number(row, name + "_low"), number(row, name + "_high")
    return value is not None and low is not None and low <= value <= high


def shown(row, name):
    """A value with the ends of its interval."""
    if not row.get(name):
        return "–"
    text = short(row[name])
    low, high = row.get(name + "_low"), row.get(name + "_high")
    return f"{text} ({short(low)}…{short(high)})" if low else text


class Pair:
    """A point: what the solver and the closed form say."""

    def __init__(self, solver, closed):
        self.solver, self.closed = solver, closed
        self.part = solver["part"]

    def quantities(self):
        return ["F_H_bar", "F_V_bar" if self.part in HELD else "Z"]

    def verdict(self, name):
        """Whether the two agree; `None` where one of them says nothing, or the run is broken."""
        if self.solver["state"] != "done" or self.closed is None or not self.closed.get(name) or not self.solver.get(name):
            return None
        return inside(number(self.closed, name), self.solver, name) or inside(number(self.solver, name), self.closed, name)


def pairs(rows):
    closed = {row["point"]: row for row in rows if row["model"] != "solver"}
    return [Pair(row, closed.get(row["point"])) for row in rows if row["model"] == "solver" and row["part"] in PARTS]


def table(points):
    lines = ["| | varied | drag F̄_H: solver | closed form | Z, or F̄_V of a disc that is held: solver | closed form | turn ratio: solver; closed | grade |",
             "|---|---|---|---|---|---|---|---|"]  # fmt: skip
    for pair in points:
        solver, closed = pair.solver, pair.closed or {}
        what, factors = PARTS[pair.part]
        varied = ", ".join(f"{name} {short(solver[name])}" for name in factors if solver[name] != "")
        other = pair.quantities()[1]
        cells = []
        for name in ("F_H_bar", other):
            mark = {True: "", False: " ✗", None: ""}[pair.verdict(name)]
            cells += [shown(solver, name), shown(closed, name) + mark]
        turn = "; ".join(short(row.get("turn_ratio", ""), 2) or "–" for row in (solver, closed))
        grade = solver["grade"] if solver["state"] == "done" else solver["state"]
        lines.append(f"| {what} | {varied} | {' | '.join(cells)} | {turn} | {grade} |")
    return lines


def counts(points):
    """How many agree, by kind of soil."""
    lines = ["| | points | drag agrees | sinkage or vertical force agrees | both |", "|---|--:|--:|--:|--:|"]
    groups = {
        "sand": lambda pair: pair.part in ("fixed", "density", "rockhopper", "single"),
        "textbook soil": lambda pair: pair.part not in ("fixed", "density", "rockhopper", "single", "wing"),
    }
    for name, belongs in groups.items():
        found = []
        for pair in filter(belongs, points):
            verdicts = [pair.verdict(quantity) for quantity in pair.quantities()]
            if None not in verdicts:
                found.append(verdicts)
        drag, other = (sum(verdict[n] for verdict in found) for n in (0, 1))
        lines.append(f"| {name} | {len(found)} | {drag} | {other} | {sum(all(verdict) for verdict in found)} |")
    grades = {}
    for pair in points:
        grade = pair.solver["grade"] if pair.solver["state"] == "done" else pair.solver["state"]
        grades[grade] = grades.get(grade, 0) + 1
    return lines, ", ".join(f"{count} {grade}" for grade, count in sorted(grades.items()))


def of_contact(row):
    """The angle of the resultant over that of the contact on level ground."""
    return math.atan2(number(row, "drag"), number(row, "vertical")) / math.acos(1 - 2 * number(row, "Z"))


def slope(points):
    """How near the drag of a free disc over its weight comes to √(Z/(1 − Z)), in a sentence."""
    free = [pair.solver for pair in points if pair.part not in (*HELD, "wing") and pair.solver["state"] == "done"]
    closed = [pair.closed for pair in points if pair.solver in free and pair.closed and pair.closed.get("F_H_bar")]
    errors = []
    for row in free:
        z = number(row, "Z")
        errors.append(number(row, "drag") / number(row, "vertical") / (z / (1 - z)) ** 0.5 - 1)
    errors.sort()
    angles = {model: statistics.median(map(of_contact, rows)) for model, rows in (("solver", free), ("closed", closed))}
    near = sum(abs(error) <= 0.2 for error in errors)
    return (
        f"Of the {len(errors)} free discs of the solver {near} have a drag over weight within 20 % of √(Z/(1 − Z)); the median is "
        f"{round(100 * statistics.median(errors))} %, the ends are {100 * errors[0]:+.0f} and {100 * errors[-1]:+.0f} %. "
        f"The resultant stands at a median of {angles['solver']:.2f} of the contact angle of level ground, by the closed form at {angles['closed']:.2f}."
    ).replace("-", "−")


def page(rows):
    points = pairs(rows)
    lines, grades = counts(points)
    count = f"{len(points)} points of the solver: {grades}."
    body = [count, "", *lines, "", slope(points), "", *table(points)]
    text = PAGE.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    return before + BEGIN + "\n\n" + "\n".join(body) + "\n\n" + END + rest.split(END)[1]


def main():
    arguments = sys.argv[1:]
    check = "--check" in arguments
    folders = [argument for argument in arguments if argument != "--check"]
    if folders:
        rows = read(Path(folders[0]) / "table.csv")
        DATA.parent.mkdir(exist_ok=True)
        with open(DATA, "w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, KEPT, lineterminator="\n")
            writer.writeheader()
            writer.writerows({name: short(value, 5) for name, value in row.items()} for row in rows)
        for name in re.findall(r"images/paper/(\w+\.svg)", PAGE.read_text(encoding="utf-8")):
            shutil.copy(Path(folders[0]) / "figures" / name, PAGE.parents[1] / "images" / "paper" / name)
    wanted = page(read(DATA))
    if check and wanted != PAGE.read_text(encoding="utf-8"):
        sys.exit(f"{PAGE.relative_to(ROOT)} is not that of {DATA.relative_to(ROOT)}: run scripts/paper/page.py")
    if not check:
        PAGE.write_text(wanted, encoding="utf-8")


main()
