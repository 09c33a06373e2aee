#!/usr/bin/env python3
"""A thin plate that cuts saturated sand, beside Miedema's coefficient c1: docs/studies/saturated-blade.md.

    scripts/cases/saturated_blade.py target/release/coulter FOLDER

For blade angles of 30, 45 and 60 degrees, each drained and at two permeabilities. Some 15 minutes on one core.
"""

import csv
import math
import statistics
import subprocess
import sys
from pathlib import Path

DEPTH = 0.1  # of the cut, and height of the blade [m]
BOTTOM = 0.01  # length of the level lower face [m]
WIDTH = 0.0125  # of the slab, both halves [m]
SPEED = 0.5  # [m/s]
STRAIN = 0.05  # volume strain of the sand that is cut
PERMEABILITIES = {"drained": 1.0, "5e-4 m/s": 5e-4, "2.5e-4 m/s": 2.5e-4}  # [m/s]
FROM = 0.2  # displacement from which forces are averaged [m]
# Appendix E of The Delft Sand, Clay & Rock Cutting Model, h_b/h_i = 1, delta = 24 deg: at phi = 32 and 37 deg.
TABLE = {30: (0.236, 0.276), 45: (0.332, 0.401), 60: (0.466, 0.587)}

CASE = """format = 2
title = "A plate at {angle} deg cuts saturated sand"
[water]
level = "200 m"                 # no cavitation
permeability = "{permeability} m/s"
pore_pressure = true
drag_coefficient = 0
[soil]
law = "mohr-coulomb"
friction_angle = "37 deg"
dilation_angle = "15 deg"
critical_density = "1500 kg/m^3"
density = "1575 kg/m^3"
young_modulus = "20 MPa"
poisson_ratio = 0.3
[domain]
x = ["-0.7 m", "0.9 m"]
y = ["0 m", "6.25 mm"]
z = ["-0.6 m", "0.25 m"]
symmetric = true
[grid]
cell = "6.25 mm"
growth = 1.15
fine_x = ["-0.25 m", "0.3 m"]
fine_y = ["0 m", "6.25 mm"]
fine_z = ["-0.15 m", "0.15 m"]
follow = {{ body = "blade", axes = "x" }}
[body.blade]
shape = "mesh"
file = "blade.stl"
unit = "m"
friction = 0.4452               # tan 24 deg
sinkage = "100 mm"
forward = {{ speed = "0.5 m/s", ramp = "0.1 s" }}
[run]
tow_distance = "0.4 m"
[output]
history_interval = "2 ms"
field_interval = "0.2 s"
"""


def plate(angle):
    """The surface of the plate as an STL text: an inclined front, a level lower face, its tip at the origin."""
    back = DEPTH / math.tan(math.radians(angle))
    outline = [(0, 0), (-back, DEPTH), (-back - BOTTOM, DEPTH), (-BOTTOM, 0)]
    at = lambda n, y: (outline[n % 4][0], y, outline[n % 4][1])
    low, high = -WIDTH / 2, WIDTH / 2
    triangles = [(at(0, low), at(2, low), at(1, low)), (at(0, low), at(3, low), at(2, low))]
    triangles += [(at(0, high), at(1, high), at(2, high)), (at(0, high), at(2, high), at(3, high))]
    for n in range(4):
        triangles.append((at(n, low), at(n + 1, low), at(n + 1, high)))
        triangles.append((at(n, low), at(n + 1, high), at(n, high)))
    vertex = lambda p: "vertex {:.6f} {:.6f} {:.6f}".format(*p)
    facet = lambda t: "facet normal 0 0 0\nouter loop\n" + "\n".join(map(vertex, t)) + "\nendloop\nendfacet\n"
    return "solid blade\n" + "".join(map(facet, triangles)) + "endsolid blade\n"


def means(folder):
    """Mean drag, and the portion that pore pressure exerts [N]."""
    with open(folder / "forces.csv") as file:
        rows = list(csv.DictReader(file))
    steady = [row for row in rows if float(row["displacement u [m]"]) > FROM]
    mean = lambda column: statistics.mean(float(row[column]) for row in steady)
    return mean("drag F_H [N]"), mean("pore pressure drag [N]")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, root = sys.argv[1], Path(sys.argv[2])
    print("| angle | k | F_H [N] | c1 | c1 of the book, 32 and 37 deg | -pore pressure drag over the unit |")
    for angle, book in TABLE.items():
        drained = None
        for name, permeability in PERMEABILITIES.items():
            folder = root / f"{angle}_{permeability}"
            folder.mkdir(parents=True, exist_ok=True)
            (folder / "blade.stl").write_text(plate(angle))
            (folder / "case.toml").write_text(CASE.format(angle=angle, permeability=permeability))
            out = folder / "results"
            subprocess.run([program, "run", folder / "case.toml", "-o", out, "--force", "--threads", "1"],
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
            force, pore = means(out)
            drained = force if drained is None else drained
            unit = 1000 * 9.81 * SPEED * STRAIN * DEPTH**2 * WIDTH / permeability
            c1 = (force - drained) / unit
            print(f"| {angle} | {name} | {force:.2f} | {c1:.3f} | {book} | {-pore / unit:.3f} |", flush=True)


if __name__ == "__main__":
    main()
