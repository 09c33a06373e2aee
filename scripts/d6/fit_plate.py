#!/usr/bin/env python3
"""Fits the sand of validation/D6_wheel to the plate by the rule of its README.

usage: fit_plate.py COULTER OUT [RUNS AT ONCE [RULE]]

RULE is 1 or 2 (the default): the priors. Runs cases/cmu_plate.toml with COULTER, keeps results in OUT, and prints each set with its residuals, then the best set and the eight ends of the
ellipsoid of sets that fit equally well.
"""
import csv
import json
import math
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

CASE = Path(__file__).resolve().parents[2] / "cases" / "cmu_plate.toml"
DEPTHS = [5.0, 10.0, 15.0, 20.0, 25.0]  # mm
MEASURED = [22.1, 51.4, 87.9, 134.7, 192.8]  # N
SCATTER = 0.1  # of ln F
GRAINS = 2650.0  # kg/m^3
DENSEST = 0.63  # e_min/e_max
# Middle and standard deviation of the priors, by rule: phi_cv [deg], e_max, ln(a/0.0009), ln(K_c/20 MPa)
PRIORS = {
    1: ([31.0, 1.02, 0.0, 0.0], [1.5, 0.03, math.log(2.0), math.log(1.5)]),
    2: ([33.0, 1.03, 0.0, 0.0], [3.0, 0.05, math.log(3.0), math.log(3.0)]),
}
MIDDLE, SPREAD = map(np.array, PRIORS[int(sys.argv[4]) if len(sys.argv) > 4 else 2])


def overrides(unknowns):
    phi, e_max, strain, modulus = unknowns
    return [
        f"soil.critical_friction_angle={phi:.5f} deg",
        f"soil.minimum_density={GRAINS / (1 + e_max):.4f} kg/m^3",
        f"soil.maximum_density={GRAINS / (1 + DENSEST * e_max):.4f} kg/m^3",
        f"soil.reference_strain={0.0009 * math.exp(strain):.7f}",
        f"soil.compression_modulus={20e6 * math.exp(modulus):.1f} Pa",
    ]


def forces(coulter, out, unknowns):
    """Force on the plate [N] at the depths."""
    name = "_".join(f"{u:.4f}" for u in unknowns)
    folder = out / name
    sets = [word for one in overrides(unknowns) for word in ("--set", one)]
    command = [coulter, "run", CASE, "-o", folder, "--auto-resume", "--threads", "1", *sets]
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}\n{done.stderr}")
    rows = list(csv.DictReader(open(folder / "forces.csv")))
    depth = np.array([1e3 * float(row["sinkage z [m]"]) for row in rows])
    force = np.array([float(row["vertical F_V [N]"]) for row in rows])
    return np.array([force[abs(depth - z) < 0.6].mean() for z in DEPTHS])


def residuals(coulter, out, z):
    """Residuals of the fit and of the priors at `z`, the unknowns in standard deviations from the middle of their priors."""
    found = forces(coulter, out, MIDDLE + SPREAD * z)
    fit = np.log(found / MEASURED) / SCATTER
    print(json.dumps({"z": [round(x, 3) for x in z], "F": [round(f, 1) for f in found],
                      "sum": round(float(fit @ fit + z @ z), 3)}), flush=True)
    return np.concatenate([fit, z])


def main():
    coulter, out = sys.argv[1], Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    z, step = np.zeros(4), 0.5
    with ThreadPoolExecutor(int(sys.argv[3]) if len(sys.argv) > 3 else 2) as pool:
        for _ in range(8):
            points = [z] + [z + step * np.eye(4)[n] for n in range(4)]
            here, *moved = pool.map(lambda point: residuals(coulter, out, point), points)
            jacobian = np.array([(there - here) / step for there in moved]).T
            change = -np.linalg.solve(jacobian.T @ jacobian, jacobian.T @ here)
            # At most two standard deviations at once: the model is not linear.
            change *= min(1.0, 2.0 / np.abs(change).max())
            z = z + change
            if np.abs(change).max() < 0.1:
                break
        values, vectors = np.linalg.eigh(jacobian.T @ jacobian)
        ends = [z + sign * vectors[:, n] / math.sqrt(values[n]) for n in range(4) for sign in (1, -1)]
        for point in [z, *ends]:
            residuals(coulter, out, point)
            print(" ".join(f'--set "{one}"' for one in overrides(MIDDLE + SPREAD * point)), flush=True)


main()
