#!/usr/bin/env python3
"""Compares the law `sand` with published element tests of Karlsruhe fine sand and Toyoura sand, and its stiffness with what is published
on many sands.

    compare.py COULTER [--stiffness] [--set KEY=VALUE]..

COULTER is the program. Runs `coulter element` on cases/sands/karlsruhe_fine.toml and cases/sands/toyoura.toml for every test of published/*.csv (each
file names its source), and prints published and computed figures, whose means are in docs/studies/sand-laws.md. `--stiffness` prints instead those of
docs/studies/sand-stiffness.md. Half a minute; standard library only. `--set`
is handed on, such as --set soil.stiffness_limit="50 kPa"; without it the elastic moduli grow up to 500 kPa, beyond every test.
"""

import csv
import math
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
SANDS = HERE.parents[1] / "cases" / "sands"
GRAINS = {"karlsruhe_fine": 2650.0, "toyoura": 2640.0, "hostun_rf": 2650.0, "ottawa_f65": 2650.0}  # kg/m^3
LIMIT = ["--set", "soil.stiffness_limit=500 kPa"]
# Tests at up to this pressure were used to fit the constants of the law [kPa].
CALIBRATED = 110.0


def published(name):
    """Lines of a file of published values, as dictionaries."""
    with open(HERE / "published" / name, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def limits(sand):
    """Void ratios in the loosest and in the densest state, from the densities of cases/sands."""
    soil = tomllib.loads((SANDS / f"{sand}.toml").read_text(encoding="utf-8"))["soil"]
    return [GRAINS[sand] / float(soil[key].split()[0]) - 1.0 for key in ("minimum_density", "maximum_density")]


class Program:
    """The program, and settings that are handed on to it."""

    def __init__(self, path, settings):
        self.path, self.settings = path, settings

    def test(self, kind, sand, void_ratio, options):
        """Curve of one specimen: columns by the name without unit."""
        density = GRAINS[sand] / (1.0 + void_ratio)
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "out"
            command = [self.path, "element", kind, SANDS / f"{sand}.toml", "--density", f"{density:.4f} kg/m^3"]
            command += [*options, "-o", out, *self.settings]
            done = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
            if done.returncode != 0:
                sys.exit(f"{' '.join(map(str, command))}\n{done.stderr}")
            with open(out / "curves.csv", encoding="utf-8") as file:
                rows = [row for row in csv.DictReader(file) if float(row["unloading [-]"]) == 0.0]
        return {name.split(" [")[0]: [float(row[name]) for row in rows] for name in rows[0]}


def at(xs, ys, x):
    """y at x, interpolated; not-a-number where x is not reached."""
    for (x0, y0), (x1, y1) in zip(zip(xs, ys), zip(xs[1:], ys[1:])):
        if x0 <= x <= x1 and x1 > x0:
            return y0 + (x - x0) / (x1 - x0) * (y1 - y0)
    return math.nan


class Triaxial:
    """Figures of a triaxial curve: angles in degrees, strains in per cent."""

    def __init__(self, curve):
        self.strain = [100.0 * x for x in curve["axial strain"]]
        self.volume = [100.0 * x for x in curve["volumetric strain"]]
        self.angle = [math.degrees(x) for x in curve["mobilised friction angle"]]
        self.ratio = [v / l for v, l in zip(curve["vertical stress"], curve["lateral stress"])]

    def angle_at(self, strain):
        return at(self.strain, self.angle, strain)

    def volume_at(self, strain):
        return at(self.strain, self.volume, strain)

    def dilatancy(self):
        """Largest over 0.5 % of axial strain."""
        middles = [0.25 * n for n in range(2, 60)]
        return max(2.0 * (self.volume_at(m - 0.25) - self.volume_at(m + 0.25)) for m in middles)

    def strain_at_ratio(self, ratio):
        for n in range(1, len(self.ratio)):
            if self.ratio[n] >= ratio:
                return at(self.ratio[n - 1 : n + 1], self.strain[n - 1 : n + 1], ratio)
        return math.nan


def shown(number, digits):
    """A number with so many decimals, and a proper minus; a dash where there is none."""
    return "–" if math.isnan(number) else f"{number:.{digits}f}".replace("-", "−")


def significant(number):
    """A number in two digits."""
    return f"{number:#.2g}".rstrip(".")


def line(cells):
    print("| " + " | ".join(cells) + " |")


def bias(pairs, digits=1):
    """Mean and root mean square of computed less published."""
    differences = [computed - known for known, computed in pairs]
    mean = sum(differences) / len(differences)
    square = math.sqrt(sum(d * d for d in differences) / len(differences))
    return f"{mean:+.{digits}f} / {square:.{digits}f}".replace("-", "−")


FIGURES = [
    ("peak friction angle [deg]", "φ peak [°]", 1, lambda t: max(t.angle)),
    ("largest dilatancy [-]", "−dε_v/dε₁", 2, Triaxial.dilatancy),
    ("friction angle at 1 % [deg]", "φ at 1 % [°]", 1, lambda t: t.angle_at(1.0)),
    ("friction angle at 5 % [deg]", "φ at 5 % [°]", 1, lambda t: t.angle_at(5.0)),
    ("volumetric strain at 5 % [%]", "ε_v at 5 % [%]", 1, lambda t: t.volume_at(5.0)),
    ("volumetric strain at 10 % [%]", "ε_v at 10 % [%]", 1, lambda t: t.volume_at(10.0)),
]


def karlsruhe_triaxial(program):
    print("\nKarlsruhe fine sand, triaxial compression: published, computed\n")
    line(["test", "e", "σ₃ [kPa]", *(header for _, header, _, _ in FIGURES)])
    line(["---"] + ["--:"] * (2 + len(FIGURES)))
    groups = {"50 and 100 kPa (calibration)": [], "200 to 400 kPa (prediction)": []}
    for row in published("karlsruhe_triaxial.csv"):
        pressure = float(row["lateral stress [kPa]"])
        options = ["--pressure", f"{pressure} kPa", "--strain", "0.25"]
        found = Triaxial(program.test("triaxial", "karlsruhe_fine", float(row["void ratio [-]"]), options))
        pairs = [(float(row[name]), figure(found)) for name, _, _, figure in FIGURES]
        groups[list(groups)[pressure > CALIBRATED]].append(pairs)
        if pressure <= CALIBRATED:
            cells = [f"{shown(k, d)}, {shown(c, d)}" for (k, c), (_, _, d, _) in zip(pairs, FIGURES)]
            line([row["test"], row["void ratio [-]"], row["lateral stress [kPa]"], *cells])
    for name, tests in groups.items():
        columns = [bias(column, 2 if n == 1 else 1) for n, column in enumerate(zip(*tests))]
        line([f"{name}, mean / rms of {len(tests)}", "", "", *columns])


def karlsruhe_oedometer(program):
    print("\nKarlsruhe fine sand, oedometer: secant modulus [MPa], published, computed\n")
    rows = published("karlsruhe_oedometer.csv")
    names = [name for name in rows[0] if name.startswith("modulus")]
    line(["test", "e", *(name.split(" ", 1)[1].split(" [")[0] for name in names)])
    line(["---"] + ["--:"] * (1 + len(names)))
    levels = [[float(word) for word in name.split() if word[0].isdigit()] for name in names]
    logarithms = []
    for row in rows:
        options = ["--pressure", "1 kPa", "--largest-pressure", "120 kPa"]
        curve = program.test("oedometer", "karlsruhe_fine", float(row["void ratio [-]"]), options)
        stress, strain = [math.log(s / 1e3) for s in curve["vertical stress"]], curve["axial strain"]
        reached = lambda level: at(stress, strain, max(math.log(level), stress[0]))
        cells = []
        for name, (low, high) in zip(names, levels):
            modulus = (high - low) / (reached(high) - reached(low)) / 1e3
            cells.append(f"{significant(float(row[name]))}, {significant(modulus)}")
            logarithms.append(math.log(modulus / float(row[name])))
        line([row["test"], row["void ratio [-]"], *cells])
    mean = math.exp(sum(logarithms) / len(logarithms))
    scatter = math.sqrt(sum(x * x for x in logarithms) / len(logarithms))
    print(f"\ncomputed over published: geometric mean {mean:.2f}; root mean square of the logarithm {scatter:.2f}")


def toyoura_triaxial(program):
    print("\nToyoura sand, triaxial compression: published, computed\n")
    rows = published("toyoura_triaxial.csv")
    line(["figure", "e", "σ₃ [kPa]: published, computed", "mean / rms up to 110 kPa"])
    line(["---", "--:", "---", "--:"])
    groups = {}
    for row in rows:
        groups.setdefault((row["quantity"], row["void ratio [-]"]), []).append(row)
    for (quantity, void_ratio), own in groups.items():
        cells, pairs = [], []
        for row in own:
            pressure = float(row["lateral stress [kPa]"])
            options = ["--pressure", f"{pressure} kPa", "--strain", "0.25"]
            found = Triaxial(program.test("triaxial", "toyoura", float(void_ratio), options))
            level = next((float(word) for word in quantity.split() if word.isdigit()), None)
            if quantity.startswith("peak"):
                computed, digits = max(found.angle), 1
            elif quantity.startswith("volumetric"):
                computed, digits = found.volume_at(level), 1
            else:
                computed, digits = found.strain_at_ratio(level), 2
            known = float(row["value"])
            cells.append(f"{pressure:.0f}: {shown(known, digits)}, {shown(computed, digits)}")
            if pressure <= CALIBRATED:
                pairs.append((known, computed))
        line([quantity, void_ratio, "; ".join(cells), bias(pairs, digits)])


def usual_modulus(strain, pressure, void_ratio, relative_density):
    """Secant shear modulus [Pa] at an engineering shear strain and a mean pressure [Pa]: Oztoprak & Bolton (2013), who fitted 454 tests of sands
    within a factor of 1.13, and the initial modulus of 379 tests within 1.6. From memory; here of uniform sand, C_u = 1.5."""
    initial = 5760e5 * (pressure / 1e5) ** 0.49 / (1.0 + void_ratio) ** 3
    reference = 0.01 * 1.5**-0.3 * pressure / 1e5 + 0.08 * void_ratio * relative_density  # in per cent, as the next
    elastic = 0.0002 + 0.012 * reference
    return initial / (1.0 + (max(100.0 * strain - elastic, 0.0) / reference) ** 1.5**-0.075)


def usual_stiffness(stress, relative_density):
    """Tangent modulus of the oedometer at a vertical stress, and secant modulus of a triaxial test at half of its strength, at a lateral
    stress [kPa], in MPa: both by Brinkgreve, Engin & Engin (2010), fitted to several sands. From memory."""
    return 60.0 * relative_density * (stress / 100.0) ** (0.7 - 0.3125 * relative_density)


def stiffness_ratios(program, sand, void_ratio, relative_density):
    """Moduli of a sand, computed over published, by name."""
    ratios = {}
    for level in (20.0, 100.0):
        curve = program.test("triaxial", sand, void_ratio, ["--pressure", f"{level} kPa", "--strain", "0.15"])
        sheared = [(a - v / 3.0) * math.sqrt(3.0) for a, v in zip(curve["axial strain"], curve["volumetric strain"])]
        for strain in (1e-4, 3e-4, 1e-3):
            modulus = at(sheared, curve["Mises stress q"], strain) / math.sqrt(3.0) / strain
            usual = usual_modulus(strain, at(sheared, curve["mean pressure p"], strain), void_ratio, relative_density)
            ratios[f"G at {100.0 * strain:g} %, {level:g} kPa"] = modulus / usual
        half = 0.5 * max(curve["Mises stress q"])
        secant = half / at(curve["Mises stress q"], curve["axial strain"], half) / 1e6
        ratios[f"E₅₀, {level:g} kPa"] = secant / usual_stiffness(level, relative_density)
    curve = program.test("oedometer", sand, void_ratio, ["--pressure", "5 kPa", "--largest-pressure", "150 kPa"])
    for level in (20.0, 100.0):
        low, high = (at(curve["vertical stress"], curve["axial strain"], factor * 1e3 * level) for factor in (0.95, 1.05))
        ratios[f"E_oed, {level:g} kPa"] = 1e-4 * level / (high - low) / usual_stiffness(level, relative_density)
    return ratios


def stiffness(program):
    print("\nComputed over published; in each cell loose, medium and dense sand (I_D = 0.3, 0.6, 0.9)\n")
    table = {}
    for sand in GRAINS:
        loosest, densest = limits(sand)
        for relative_density in (0.3, 0.6, 0.9):
            void_ratio = loosest - relative_density * (loosest - densest)
            for name, ratio in stiffness_ratios(program, sand, void_ratio, relative_density).items():
                table.setdefault(name, {}).setdefault(sand, []).append(ratio)
    line(["modulus", *GRAINS, "geometric mean"])
    line(["---"] + ["--:"] * (len(GRAINS) + 1))
    for name, row in table.items():
        logarithms = [math.log(ratio) for ratios in row.values() for ratio in ratios]
        mean = math.exp(sum(logarithms) / len(logarithms))
        line([name, *(", ".join(shown(ratio, 2) for ratio in ratios) for ratios in row.values()), shown(mean, 2)])


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    settings = sys.argv[2:]
    if "--stiffness" in settings:
        settings.remove("--stiffness")
        stiffness(Program(sys.argv[1], LIMIT + settings))
        return
    program = Program(sys.argv[1], LIMIT + settings)
    karlsruhe_triaxial(program)
    karlsruhe_oedometer(program)
    toyoura_triaxial(program)


main()
