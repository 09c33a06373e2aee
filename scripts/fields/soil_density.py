"""The share of the soil's mass that lies in cells of a density that soil at low pressure does not have, over the times of a run.

    python3 scripts/fields/soil_density.py DIR...

Dense: above 1.25 of the median density at the start; loose: below half of it; cells less than 1 % full are left out. Needs numpy and
pyvista.
"""

import sys
from pathlib import Path

import numpy as np
import pyvista


def shares(folder):
    """Largest shares of dense and loose mass at any time [%]."""
    start, whole, dense, loose = None, None, 0.0, 0.0
    for file in sorted((Path(folder) / "fields").glob("soil_*.vtr")):
        grid = pyvista.read(file)
        dx, dy, dz = (np.diff(np.asarray(axis)) for axis in (grid.x, grid.y, grid.z))
        volume = (dz[:, None, None] * dy[None, :, None] * dx[None, None, :]).ravel()
        fraction = np.asarray(grid.cell_data["evf"])
        density = np.nan_to_num(np.asarray(grid.cell_data["density"]))
        mass, full = fraction * density * volume, fraction > 0.01
        if start is None:
            start, whole = np.median(density[fraction > 0.5]), mass.sum()
        dense = max(dense, mass[full & (density > 1.25 * start)].sum() / whole)
        loose = max(loose, mass[full & (density < 0.5 * start)].sum() / whole)
    return 100 * dense, 100 * loose


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    for folder in sys.argv[1:]:
        dense, loose = shares(folder)
        print(f"{folder}: dense {dense:.4f} %, loose {loose:.4f} %")


if __name__ == "__main__":
    main()
