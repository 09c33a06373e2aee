#!/usr/bin/env python3
"""Draws the figures of this folder anew from their CSV files, with matplotlib: change it as you like.

    python3 figures.py               # all figures, as PDF and SVG, into redrawn/
    python3 figures.py NAME …        # some of them
"""

import csv
import pathlib
import sys
from dataclasses import dataclass, field

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
# Points of a line up to which their intervals are drawn.
MOST_BARS = 24


@dataclass
class Look:
    """Colour, mark and dashes (lengths over the width of the line) of a series."""

    colour: str
    mark: str
    dashes: list
    bold: bool = False


@dataclass
class Axis:
    """Label, ends and scale of an axis; words at 0, 1, 2, … of an axis of words."""

    label: str
    range: tuple | None = None
    logarithmic: bool = False
    words: list = field(default_factory=list)


@dataclass
class Figure:
    """A figure: width in mm, height over width, sizes in pt, series by (kind, level, source)."""

    name: str
    x: Axis
    y: Axis
    looks: dict
    legend: str
    names: list
    width: float = 90
    aspect: float = 0.75
    font_size: float = 8
    line_width: float = 0.9
    mark_size: float = 4.5


FIGURES = []


def settings(figure):
    """Settings of matplotlib: a face without serifs, embedded; ticks inwards on all sides."""
    size, faces = figure.font_size, ["Liberation Sans", "Arimo", "Arial", "Helvetica", "DejaVu Sans"]
    known = {face.name for face in matplotlib.font_manager.fontManager.ttflist}
    face = next(face for face in faces if face in known)
    return {
        "font.family": face, "font.size": size, "axes.labelsize": size, "xtick.labelsize": size,
        "ytick.labelsize": size, "legend.fontsize": size, "mathtext.fontset": "custom", "mathtext.rm": face,
        "mathtext.it": f"{face}:italic", "axes.linewidth": 0.6, "lines.linewidth": figure.line_width,
        "lines.scale_dashes": True, "xtick.direction": "in", "ytick.direction": "in", "xtick.top": True,
        "ytick.right": True, "xtick.minor.visible": not figure.x.words, "ytick.minor.visible": True,
        "xtick.major.width": 0.6, "xtick.minor.width": 0.6, "ytick.major.width": 0.6, "ytick.minor.width": 0.6,
        "legend.frameon": False, "legend.handlelength": 2.6, "legend.labelspacing": 0.3, "pdf.fonttype": 42,
        "svg.fonttype": "path", "svg.hashsalt": "coulter", "axes.unicode_minus": True,
    }


def number(text):
    return float(text) if text else float("nan")


def read(figure):
    """The series of a figure: points (x, y, ends of x, ends of y, grade) by (kind, level, source)."""
    series = {}
    with open(HERE / f"{figure.name}.csv", newline="", encoding="utf-8") as file:
        for row in list(csv.reader(file))[1:]:
            kind, level, source, x, x_low, x_high, y, y_low, y_high, grade = row
            x = figure.x.words.index(x) if figure.x.words else number(x)
            point = (x, number(y), (number(x_low), number(x_high)), (number(y_low), number(y_high)), grade)
            series.setdefault((kind, level, source), []).append(point)
    return series


def style(look, figure, hollow=False):
    """Keywords of a mark."""
    fill = "white" if hollow else look.colour
    return {"marker": look.mark, "markersize": figure.mark_size, "markerfacecolor": fill,
            "markeredgecolor": look.colour, "markeredgewidth": 0.18 * figure.mark_size, "color": look.colour}


def line(look, figure):
    """Keywords of a line."""
    width = figure.line_width * (2 if look.bold else 1)
    return {"color": look.colour, "linewidth": width, "linestyle": (0, tuple(look.dashes)) if look.dashes else "-"}


def bars(axes, point, look, figure, cap=0.3):
    """Error bars of a point; `cap` is the half-width of a cap over the size of a mark."""
    x, y, x_ends, y_ends, _ = point
    errors = {}
    if y_ends[0] == y_ends[0]:
        errors["yerr"] = [[max(y - y_ends[0], 0)], [max(y_ends[1] - y, 0)]]
    if x_ends[0] == x_ends[0]:
        errors["xerr"] = [[max(x - x_ends[0], 0)], [max(x_ends[1] - x, 0)]]
    if errors:
        axes.errorbar(x, y, fmt="none", ecolor=look.colour, elinewidth=0.7 * figure.line_width,
                      capsize=cap * figure.mark_size, capthick=0.7 * figure.line_width, zorder=2.5, **errors)


def breaks(points):
    """Parts of a line, between points without a value."""
    part = []
    for x, y, *_ in points:
        if x == x and y == y:
            part.append((x, y))
        elif part:
            yield part
            part = []
    if part:
        yield part


def plot(axes, figure):
    for key, points in read(figure).items():
        look = figure.looks.get(key, Look("#000000", "o", []))
        if key[0] == "line":
            for part in breaks(points):
                axes.plot(*zip(*part), **line(look, figure), marker="_" if len(points) == 1 else None, zorder=2)
            for point in points if len(points) <= MOST_BARS else ():
                bars(axes, point, look, figure, cap=0)
            continue
        for point in points:
            bars(axes, point, look, figure)
            keywords = style(look, figure, hollow=point[4] == "doubtful")
            if key[0] == "dots":
                keywords["markersize"] *= 0.5
            axes.plot([point[0]], [point[1]], linestyle="none", zorder=3, **keywords)


def key(figure, line_look, mark_look, hollow):
    """What stands before a name in the legend."""
    keywords = line(line_look, figure) if line_look else {"linestyle": "none"}
    if mark_look:
        marked = style(mark_look, figure, hollow)
        marked.pop("color")
        keywords.update(marked)
    return Line2D([], [], **keywords)


def draw(figure):
    with plt.rc_context(settings(figure)):
        width = figure.width / 25.4
        page, axes = plt.subplots(figsize=(width, figure.aspect * width), layout="constrained")
        for name, axis in (("x", figure.x), ("y", figure.y)):
            axes.set(**{f"{name}label": axis.label})
            if axis.logarithmic:
                axes.set(**{f"{name}scale": "log"})
        plot(axes, figure)
        if figure.x.words:
            axes.set_xticks(range(len(figure.x.words)), figure.x.words)
            axes.set_xlim(-0.5, len(figure.x.words) - 0.5)
        for name, axis in (("x", figure.x), ("y", figure.y)):
            if axis.range:
                axes.set(**{f"{name}lim": axis.range})
        if figure.names and figure.legend != "none":
            handles = [key(figure, *entry[1:]) for entry in figure.names]
            names = [entry[0] for entry in figure.names]
            if figure.legend == "outside":
                page.legend(handles, names, loc="outside upper center", ncols=3)
            else:
                axes.legend(handles, names, loc=figure.legend)
        (HERE / "redrawn").mkdir(exist_ok=True)
        for ending in ("pdf", "svg"):
            page.savefig(HERE / "redrawn" / f"{figure.name}.{ending}", metadata={"CreationDate": None} if ending == "pdf" else {"Date": None})
        plt.close(page)


if __name__ == "__main__":
    wanted = sys.argv[1:]
    for one in FIGURES:
        if not wanted or one.name in wanted:
            draw(one)
