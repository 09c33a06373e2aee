#!/usr/bin/env python3
"""Slip of a wheel that drives itself, for docs/studies/wheel-on-a-slope.md.

    wheel_slip.py RESULTS... [--from SECONDS --to SECONDS]

Slip is 1 − v/(ω r), with r of the rim between the grousers and of their tips; v is the mean speed over the last four grousers
(1.31 s), or between two times. Sinkage and pull are means over the same time.
"""

import argparse
import csv
import math
from pathlib import Path

RATE, RADII, GROUSERS = 0.8, (0.225, 0.255), 24  # rad/s, m


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("results", nargs="+", type=Path)
    parser.add_argument("--from", dest="begin", type=float)
    parser.add_argument("--to", dest="end", type=float)
    arguments = parser.parse_args()
    for folder in arguments.results:
        with open(folder / "forces.csv", encoding="utf-8") as file:
            rows = [[float(value) for value in row[:4]] for row in list(csv.reader(file))[1:]]
        end = arguments.end or rows[-1][0]
        begin = arguments.begin or end - 4 * math.tau / GROUSERS / RATE
        rows = [row for row in rows if begin <= row[0] <= end + 1e-9]
        speed = (rows[-1][1] - rows[0][1]) / (rows[-1][0] - rows[0][0])
        slips = "  ".join(f"{1 - speed / (RATE * radius):+.3f}" for radius in RADII)
        sinkage, drag = (sum(row[n] for row in rows) / len(rows) for n in (2, 3))
        print(f"{folder.name}: slip {slips}, sinkage {1e3 * sinkage:.1f} mm, pull {-drag:.2f} N")


if __name__ == "__main__":
    main()
