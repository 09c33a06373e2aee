#!/usr/bin/env python3
"""Writes docs/reference/measured.md, its rows as docs/data/measured.csv, and its picture from validation/measured and the registered predictions.

    page.py [--check]

Both modes end with exit code 1 where README.md does not have the sentence that sums it up; with --check nothing is written, and page and
picture must be those of the tables, too. Python 3.11, standard library only.
"""
import math
import re
import statistics
import sys
import tomllib
from pathlib import Path
from xml.sax.saxutils import escape

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "reference" / "measured.md"
PICTURE = ROOT / "docs" / "images" / "measured.svg"
ROWS = ROOT / "docs" / "data" / "measured.csv"
# Colours of Okabe and Ito (2008), and marks that survive without them.
STYLE = {
    "footings": ("#0072b2", "circle"),
    "plates": ("#d55e00", "square"),
    "wheels": ("#009e73", "triangle"),
    "blades and small plates": ("#cc79a7", "diamond"),
    "spheres": ("#56b4e9", "cross"),
    "walls": ("#7a5c00", "plus"),
}
INK, FAINT = "#1c2127", "#c9cdc8"


def load(*path):
    file = ROOT.joinpath(*path)
    return tomllib.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}


def latest(entries):
    """Of each row, quantity and model the entry of the last round: {(row, quantity): {model: entry}}."""
    found = {}
    for entry in sorted(entries, key=lambda entry: entry["round"]):
        found.setdefault((entry["row"], entry["quantity"]), {})[entry["model"]] = entry
    return found


class Table:
    """All rows with what was measured, computed and predicted."""

    def __init__(self):
        rows = load("validation", "measured", "rows.toml")
        self.sources, self.sets = rows["source"], rows["set"]
        self.set_of = {row["name"]: row["set"] for row in rows["row"]}
        self.given = latest(load("validation", "measured", "computed.toml").get("given", []))
        predictions = load("validation", "blind", "predictions.toml").get("prediction", [])
        self.blind = latest(predictions)

    def kind(self, row):
        name = self.set_of[row]
        while "kind" not in self.sets[name]:
            name = self.sets[name]["like"]
        return self.sets[name]["kind"]

    def unit(self, row, quantity):
        name = self.set_of[row]
        while True:
            unit = self.sets[name].get("quantity", {}).get(quantity, {}).get("unit")
            if unit is not None:
                return unit
            name = self.sets[name]["like"]

    @staticmethod
    def source(row):
        return re.match(r"[A-Z]+\d+", row)[0]


def error(entry):
    """Computed less measured, over the measured figure or a tenth of the scale."""
    return (entry["value"] - entry["measured"]) / max(abs(entry["measured"]), 0.1 * entry["scale"])


def beyond(entry):
    """Whether it misses by more than a factor of 1.6; where signs may differ, by more than 60 %."""
    if entry["value"] > 0 and entry["measured"] > 0 and entry["scale"] == 0:
        return not 1 / 1.6 <= entry["value"] / entry["measured"] <= 1.6
    return abs(error(entry)) > 0.6


def per_cent(value):
    return f"{100 * value:.0f} %"


def number(value):
    return (f"{value:.0f}" if abs(value) >= 1000 else f"{value:.3g}").replace("-", "−")


def score(entries):
    """Median of the errors, and how many are beyond a factor of 1.6, as two cells."""
    if not entries:
        return ["–", "–"]
    return [per_cent(statistics.median(abs(error(entry)) for entry in entries)), f"{sum(map(beyond, entries))} of {len(entries)}"]


def line(cells):
    return "| " + " | ".join(cells) + " |"


def summary(table):
    header = ["", "solver: median error", "beyond a factor of 1.6", "closed form: median error", "beyond a factor of 1.6"]
    lines = [line(header), line(["---"] + ["--:"] * 4)]
    names = sorted({table.source(row) for row, _ in table.given}, key=lambda name: (name[0], int(name[1:])))
    chosen = lambda model, name: [
        models[model] for (row, _), models in table.given.items() if model in models and name in (None, table.source(row))
    ]
    for name in names:
        lines.append(line([f"{name} {table.sources[name]}", *score(chosen("solver", name)), *score(chosen("closed form", name))]))
    lines.append(line(["**all**", *score(chosen("solver", None)), *score(chosen("closed form", None))]))
    return lines, len(names), len(table.given)


def sentence(table):
    """What README.md says of it, after “Compared with”."""
    solver = [models["solver"] for models in table.given.values() if "solver" in models]
    sources = {table.source(entry["row"]) for entry in solver}
    middle = statistics.median(abs(error(entry)) for entry in solver)
    return f"{len(solver)} measured figures of {len(sources)} sources, the median error is {per_cent(middle)}, and {sum(map(beyond, solver))} are off by more than a factor of 1.6 ([measurements](docs/reference/measured.md))"


def rows(table):
    """Measured, computed and predicted figures as CSV."""
    lines = ["row,quantity,unit,measured,solver,solver_low,solver_high,closed_form,closed_form_low,closed_form_high,grade"]
    for figures, known in ((table.given, True), (table.blind, False)):
        for (row, quantity), models in figures.items():
            cells = [row, quantity, table.unit(row, quantity) or "-"]
            cells.append(f"{next(iter(models.values()))['measured']:.4g}" if known else "")
            for model in ("solver", "closed form"):
                entry = models.get(model, {})
                cells += [f"{entry[key]:.4g}" if key in entry else "" for key in ("value", "low", "high")]
            cells.append(models["solver"]["grade"].split(":")[0] if "solver" in models else "")
            lines.append(",".join(cells))
    return "\n".join(lines) + "\n"


def page(table):
    scores, sources, figures = summary(table)
    rounds = max((entry["round"] for models in table.given.values() for entry in models.values()), default=1)
    return "\n".join([
        "# Measurements",
        "",
        "<!-- Made by scripts/measured/page.py. -->",
        "",
        f"{figures} measured figures of {sources} sources, of wheels, plates, footings, blades, spheres and walls, beside what Coulter computes. The soil of D6 is fitted to a plate in the same bed; of",
        "M1, M3, M4, M6 and the plates of M7 one or two numbers that the set leaves open were decided by the given rows themselves (round 2), so that their given rows are no test; of the others nothing is fitted: [the page of the sets](../../validation/measured/README.md) says what was chosen and why, and has the rule of the intervals.",
        f"Computed by `scripts/measured/run.py` (round {rounds} of the law of sand; M2, M7's wheel, M8 and M10, which are of other soils, are of round 1). An error is relative to what was measured, of drags and pulls that may vanish to a tenth of the load where that is larger; beyond a factor of 1.6 is there an error beyond 60 %.",
        "",
        *scores,
        "",
        "![Computed over measured figures by kind of body; predictions of rows whose measured figures are kept from the project, with their 90 % intervals](../images/measured.svg)",
        "",
        f"All of them are in [measured.csv](../data/measured.csv), and {len(table.blind)} predictions, with 90 % intervals, of figures that were measured too, but that the project has not seen: they are for others to score. [predictions.toml](../../validation/blind/predictions.toml) registers each with its command.",
        "",
    ])


# --- the picture ---


class Axis:
    """A logarithmic axis of whole decades."""

    def __init__(self, low, high, begin, end):
        self.low, self.high = math.floor(math.log10(low)), math.ceil(math.log10(high))
        self.begin, self.end = begin, end

    def at(self, value):
        return self.begin + (math.log10(value) - self.low) / (self.high - self.low) * (self.end - self.begin)

    def ticks(self):
        return [10.0**n for n in range(self.low, self.high + 1)]


def mark(shape, x, y, colour):
    r, paint = 3.6, f'fill="{colour}" fill-opacity="0.75" stroke="{colour}" stroke-width="0.8"'
    points = {
        "square": [(-r, -r), (r, -r), (r, r), (-r, r)],
        "triangle": [(0, -1.2 * r), (1.1 * r, 0.9 * r), (-1.1 * r, 0.9 * r)],
        "diamond": [(0, -1.3 * r), (1.3 * r, 0), (0, 1.3 * r), (-1.3 * r, 0)],
    }
    if shape in points:
        return f'<polygon points="{" ".join(f"{x + a:.1f},{y + b:.1f}" for a, b in points[shape])}" {paint}/>'
    if shape == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}" {paint}/>'
    d = 0.75 if shape == "cross" else 0.0
    ends = [(-r * d, -r * d, r * d, r * d), (-r * d, r * d, r * d, -r * d)] if d else [(-r, 0, r, 0), (0, -r, 0, r)]
    return "".join(f'<path d="M{x + a:.1f} {y + b:.1f}L{x + c:.1f} {y + e:.1f}" stroke="{colour}" stroke-width="2"/>' for a, b, c, e in ends)


def tick(value):
    return f"{value:g}"


def text(x, y, words, anchor="middle", size=11):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" font-size="{size}" fill="{INK}">{escape(words)}</text>'


def stroke(x0, y0, x1, y1, colour=INK, width=1.0, dash=""):
    dashes = f' stroke-dasharray="{dash}"' if dash else ""
    return f'<path d="M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}" stroke="{colour}" stroke-width="{width}"{dashes}/>'


def picture(table):
    points = [
        (table.kind(row), models["solver"])
        for (row, _), models in table.given.items()
        if "solver" in models and models["solver"]["value"] > 0 and models["solver"]["measured"] > 0
    ]
    blind = [(table.kind(row), models["solver"]) for (row, _), models in table.blind.items() if "solver" in models and models["solver"]["low"] > 0]
    blind.sort(key=lambda pair: (list(STYLE).index(pair[0]), pair[1]["value"]))
    values = [entry[key] for _, entry in points for key in ("value", "measured")] + [entry[key] for _, entry in blind for key in ("low", "high")]
    values = [value for value in values if value > 0] or [1.0, 10.0]
    y = Axis(min(values), max(values), 392.0, 24.0)
    x = Axis(min(values), max(values), 62.0, 430.0)
    parts = ['<rect width="880" height="478" fill="#ffffff"/>']
    for value in y.ticks():
        parts += [stroke(x.begin, y.at(value), x.end, y.at(value), FAINT, 0.6), stroke(492, y.at(value), 866, y.at(value), FAINT, 0.6)]
        parts += [stroke(x.at(value), y.begin, x.at(value), y.end, FAINT, 0.6)]
        parts += [text(x.begin - 6, y.at(value) + 4, tick(value), "end"), text(x.at(value), y.begin + 16, tick(value))]
    low, high = y.ticks()[0], y.ticks()[-1]
    parts.append(stroke(x.at(low), y.at(low), x.at(high), y.at(high)))
    parts += [stroke(x.at(low), y.at(1.6 * low), x.at(high / 1.6), y.at(high), INK, 0.8, "4 3"), stroke(x.at(1.6 * low), y.at(low), x.at(high), y.at(high / 1.6), INK, 0.8, "4 3")]
    parts += [mark(STYLE[kind][1], x.at(entry["measured"]), y.at(entry["value"]), STYLE[kind][0]) for kind, entry in points]
    parts += [text(246, y.begin + 34, "measured [kPa, N, mm, N m or –]"), text(246, 16, "dashed: a factor of 1.6")]
    parts.append(f'<g transform="translate(14 {0.5 * (y.begin + y.end):.0f}) rotate(-90)">{text(0, 0, "computed, same unit")}</g>')
    step = 366.0 / max(len(blind), 1)
    for n, (kind, entry) in enumerate(blind):
        at = 496.0 + (n + 0.5) * step
        parts.append(stroke(at, y.at(entry["low"]), at, y.at(entry["high"]), STYLE[kind][0], 1.4))
        parts.append(mark(STYLE[kind][1], at, y.at(entry["value"]), STYLE[kind][0]))
    parts += [text(679, 16, "predicted, with intervals of 90 %"), text(679, y.begin + 34, "rows whose measured figures are not known to the project")]
    seen = [kind for kind in STYLE if any(kind == other for other, _ in points + blind)]
    at = 62.0
    for kind in seen:
        parts += [mark(STYLE[kind][1], at, 456, STYLE[kind][0]), text(at + 10, 460, kind, "start")]
        at += 34 + 6.6 * len(kind)
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 880 478" width="880" height="478" font-family="DejaVu Sans, sans-serif" '
        'role="img" aria-label="Computed over measured figures, and predictions">\n' + "\n".join(parts) + "\n</svg>\n"
    )


def main():
    table = Table()
    if not table.given:
        sys.exit("page.py: validation/measured/computed.toml holds no given row; run scripts/measured/run.py")
    wanted = {PAGE: page(table), ROWS: rows(table), PICTURE: picture(table)}
    if sys.argv[1:] == ["--check"]:
        stale = [str(path.relative_to(ROOT)) for path, new in wanted.items() if not path.is_file() or path.read_text(encoding="utf-8") != new]
        if stale:
            sys.exit(f"page.py: {' and '.join(stale)}: not what the tables say; run scripts/measured/page.py")
    elif sys.argv[1:]:
        sys.exit(__doc__)
    else:
        for path, new in wanted.items():
            path.write_text(new, encoding="utf-8")
    if sentence(table) not in (ROOT / "README.md").read_text(encoding="utf-8"):
        sys.exit(f"page.py: README.md should say: {sentence(table)}")


main()
