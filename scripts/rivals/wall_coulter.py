#!/usr/bin/env python3
"""The wall of B5 with phi = psi = 35 degrees in Coulter. Standard library only.

    wall_coulter.py COULTER CELLS

CELLS over the height of the bank. Prints K_p (heave included) and processor seconds as one line of JSON.
"""
import csv
import json
import math
import re
import resource
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

CASE = Path(__file__).resolve().parents[2] / "validation" / "B5_passive_wall" / "case.toml"
PHI, HEIGHT = 35.0, 1.0
SLOPE = math.tan(math.radians(45 - PHI / 2))


def arrays(file):
    """Time and arrays of a field file (VTK's XML with compressed appended data)."""
    raw = file.read_bytes()
    start = raw.index(b"<AppendedData")
    head, data = raw[:start].decode(), raw[raw.index(b"_", start) + 1 :]
    found = {}
    for kind, name, offset in re.findall(r'type="(Float\d\d)" Name="(\w+)".*?offset="(\d+)"', head):
        blocks = struct.unpack_from("<Q", data, int(offset))[0]
        at, plain = int(offset) + 24 + 8 * blocks, b""
        for size in struct.unpack_from(f"<{blocks}Q", data, int(offset) + 24):
            plain += zlib.decompress(data[at : at + size])
            at += size
        code, width = ("f", 4) if kind == "Float32" else ("d", 8)
        found[name] = struct.unpack(f"<{len(plain) // width}{code}", plain)
    return float(re.search(r'TimeValue".*?>([^<]+)<', head)[1]), found


def wedge(found, displacement):
    """Weight of the soil above the plane that rises from the toe of the wall, per metre as drag is [N/m]."""
    x, z = found["x"], found["z"]
    area, cell = 0.0, 0
    for k in range(len(z) - 1):
        high = z[k + 1] - z[k]
        # Integral over s of what of a cell is above a plane that passes s below the cell's top.
        above = lambda s: 0.5 * min(max(s, 0), high) ** 2 + high * max(s - high, 0)
        for i in range(len(x) - 1):
            top = [z[k + 1] + HEIGHT - (x[n] - displacement) * SLOPE for n in (i, i + 1)]
            content = found["evf"][cell] * found["density"][cell]
            if content > 0:     # not NaN, as the density of a cell without soil is
                area += content * (above(top[0]) - above(top[1])) / SLOPE
            cell += 1
    return 9.81 * area


def main():
    if len(sys.argv) != 3 or not sys.argv[2].isdigit() or int(sys.argv[2]) == 0:
        sys.exit("usage: wall_coulter.py COULTER CELLS")
    exe, cells = sys.argv[1], int(sys.argv[2])
    # As the suite has it: the exact factor is that of sand which dilates without end.
    keys = [f"soil.friction_angle={PHI} deg", f"soil.dilation_angle={PHI} deg"]
    keys += ["soil.critical_density=1 kg/m^3", f"grid.cell={1000 * HEIGHT / cells} mm"]
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder, "out")
        command = [exe, "run", str(CASE), "--threads", "1", "-o", str(out)]
        # An exit code may only say that a grade is not good; what counts is whether there are results.
        command += [part for key in keys for part in ("--set", key)]
        ran = subprocess.run(command, capture_output=True, text=True)
        whole = sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2])
        if not (out / "summary.json").is_file():
            sys.exit(f"wall_coulter.py: {(ran.stderr.strip().splitlines() or ['no results'])[-1]}")
        rows = list(csv.DictReader((out / "forces.csv").open(encoding="utf-8")))
        fields = [arrays(file) for file in sorted((out / "fields").glob("soil_*.vtr"))]
        summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
        version = subprocess.run([exe, "--version"], capture_output=True, text=True).stdout.strip()
    columns = ("time [s]", "displacement u [m]", "drag F_H [N]")
    time, moved, drag = ([float(row[key]) for row in rows] for key in columns)
    weights, row = [], 0
    for at, found in fields:
        while row < len(time) - 1 and time[row] < at:
            row += 1
        weights.append((at, wedge(found, moved[row])))
    factors, row = [], 0
    for n in range(1, len(time)):
        while row < len(weights) - 2 and weights[row + 1][0] < time[n]:
            row += 1
        (t0, g0), (t1, g1) = weights[row], weights[row + 1]
        weight = g0 + (g1 - g0) * (time[n] - t0) / (t1 - t0)
        if moved[n] >= 0.05 * HEIGHT:
            factors.append((drag[n] / (weight * SLOPE), time[n] - time[n - 1]))
    span = sum(dt for _, dt in factors)
    mean = sum(value * dt for value, dt in factors) / span
    scatter = math.sqrt(sum((value - mean) ** 2 * dt for value, dt in factors) / span)
    result = {"version": version, "factor": mean, "scatter": scatter, "pushed": moved[-1] / HEIGHT}
    print(json.dumps({**result, "whole_s": whole, "loop_s": summary["wall_s"], "setting": "defaults"}))


if __name__ == "__main__":
    main()
