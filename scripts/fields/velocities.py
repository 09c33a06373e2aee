"""What the velocities of the soil round a disc at y = 0 consist of, from the field files of a run.

    coulter run CASE -o DIR --set output.field_interval="50 ms"
    python3 scripts/fields/velocities.py DIR [BODY]

For each time: root mean squares, over the full cells within 120 mm of the body's middle along x, 50 mm along y and 100 mm below the
surface, of the linear part of the velocities in a cell (half the difference between opposite faces) and of their hourglass parts, in mm/s;
and over the nodes there of what is not its own mirror image in the plane y = 0. Needs numpy and pyvista.
"""

import sys
from pathlib import Path

import numpy as np
import pyvista

CORNERS = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
HOURGLASS = {"yz": (0, 1, 1), "xz": (1, 0, 1), "xy": (1, 1, 0), "xyz": (1, 1, 1)}
LINEAR = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}


def rms(values):
    return np.sqrt((values**2).mean(axis=0))


def report(soil, body):
    """A line for one time."""
    grid = pyvista.read(soil)
    nx, ny, nz = grid.dimensions
    velocity = 1e3 * np.asarray(grid.point_data["velocity"]).reshape(nz, ny, nx, 3)
    fraction = np.asarray(grid.cell_data["evf"]).reshape(nz - 1, ny - 1, nx - 1)
    middle = pyvista.read(body).center[0]
    x, y, z = (np.asarray(axis) for axis in (grid.x - middle, grid.y, grid.z))

    corner = [velocity[c[2] : nz - 1 + c[2], c[1] : ny - 1 + c[1], c[0] : nx - 1 + c[0]] for c in CORNERS]

    def part(powers):
        signs = [np.prod([(2 * c - 1) ** p for c, p in zip(at, powers)]) for at in CORNERS]
        return sum(s * v for s, v in zip(signs, corner)) / 8

    cz, cy, cx = np.meshgrid(*(0.5 * (a[1:] + a[:-1]) for a in (z, y, x)), indexing="ij")
    near = (abs(cx) < 0.12) & (abs(cy) < 0.05) & (cz < 0.0) & (cz > -0.1) & (fraction > 0.9)
    linear = np.sqrt(sum(rms(part(p)[near]) ** 2 for p in LINEAR.values()).sum())
    modes = {name: rms(part(p)[near]) for name, p in HOURGLASS.items()}

    zero = int(abs(y).argmin())
    reach = min(zero, ny - 1 - zero, 12)
    slab = velocity[:, zero - reach : zero + reach + 1]
    mirrored = slab[:, ::-1] * np.array([1.0, -1.0, 1.0])
    odd = 0.5 * (slab - mirrored)[(z <= 0.0) & (z > -0.1)][:, :, abs(x) < 0.12]
    text = " ".join(f"{name} {m[0]:.1f},{m[1]:.1f},{m[2]:.1f}" for name, m in modes.items())
    odd = ",".join(f"{v:.1f}" for v in rms(odd.reshape(-1, 3)))
    print(f"t = {grid.field_data['TimeValue'][0]:.3f} s  linear {linear:.1f}  hourglass {text}  not mirrored {odd}")


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    fields = Path(sys.argv[1]) / "fields"
    name = sys.argv[2] if len(sys.argv) > 2 else "disc"
    for soil in sorted(fields.glob("soil_*.vtr")):
        report(soil, fields / soil.name.replace("soil_", f"body_{name}_").replace(".vtr", ".vtp"))


if __name__ == "__main__":
    main()
