#!/usr/bin/env python3
"""Thrust on the share of plough.inp at every field time beside that of the straight wedge that carries what is heaped on it.

    scripts/decks/run.py COULTER plough --keep DIR
    scripts/decks/wedge.py DIR/plough

P = (G sin(a + f) + c l cos f) / cos(a + f): weight G of the soil above the plane that rises from the toe at a = 45 deg - f/2, length l
of the plane in soil; f and c of the deck, and Davis' f* with tan f* = sin f, c* = c tan f* / tan f. Needs numpy and pyvista.
"""

import csv
import sys
from pathlib import Path

import numpy as np
import pyvista

PHI, COHESION, DEPTH, GRAVITY = np.radians(32.0), 500.0, 0.2, 9.81
DAVIS = np.arctan(np.sin(PHI))
SOILS = [(PHI, COHESION), (DAVIS, COHESION * np.tan(DAVIS) / np.tan(PHI))]
SUB = 16  # points across a cell


def thrust(grid, toe, phi, cohesion):
    angle = np.pi / 4 - phi / 2
    nx, _, nz = (n - 1 for n in grid.dimensions)
    fraction, density = (np.nan_to_num(grid.cell_data[name]).reshape(nz, nx) for name in ("evf", "density"))
    x, z = (np.interp((np.arange(n * SUB) + 0.5) / SUB, np.arange(n + 1), axis) for n, axis in ((nx, grid.x), (nz, grid.z)))
    above = (z[:, None] + DEPTH > (x - toe) * np.tan(angle)) & (x > toe)
    share = above.reshape(nz, SUB, nx, SUB).mean((1, 3))
    weight = GRAVITY * (share * np.outer(np.diff(grid.z), np.diff(grid.x)) * fraction * density).sum()
    along = np.arange(0.0, 1.5, 1e-3)
    column = np.searchsorted(grid.x, toe + along * np.cos(angle)) - 1
    row = np.searchsorted(grid.z, -DEPTH + along * np.sin(angle)) - 1
    inside = (column < nx) & (row < nz)
    length = 1e-3 * fraction[row[inside], column[inside]].sum()
    return (weight * np.sin(angle + phi) + cohesion * length * np.cos(phi)) / np.cos(angle + phi)


def main():
    results = Path(sys.argv[1])
    rows = list(csv.DictReader((results / "filtered.csv").open()))
    time, moved, drag = (np.array([float(row[name]) for row in rows]) for name in ("time [s]", "displacement u [m]", "drag F_H [N]"))
    print("travel [mm]  thrust [N]  wedge at phi [N]      at phi* [N]")
    for file in sorted((results / "fields").glob("soil_*.vtr"))[1:]:
        grid = pyvista.read(file)
        now = float(grid.field_data["TimeValue"][0])
        toe, force = np.interp(now, time, moved), drag[abs(time - now) <= 0.03].mean()
        forms = [thrust(grid, toe, *soil) for soil in SOILS]
        print(f"{1e3 * toe:11.1f}  {force:10.0f}", *(f"{form:10.0f} {100 * (force / form - 1):+6.1f} %" for form in forms))


main()
