#!/usr/bin/env python3
"""A disc that is pressed into soil (D1) and one that is towed free (D3), beside the closed forms: pressed_and_free.py COULTER FOLDER [SOIL ...]

Runs what is not yet in FOLDER, one after the other, and prints the tables of docs/studies/pressed-and-free.md. SOIL is `sand` or
`mohr-coulomb`; both if none is given. Python 3.
"""

import csv
import json
import math
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DIAMETER, THICKNESS = 0.2, 0.05  # m
PRESSED = ROOT / "scripts" / "cases" / "pressed_disc.toml"
TOWED = {"sand": "towed_disc.toml", "mohr-coulomb": "towed_disc_mohr_coulomb.toml"}
UNIT_WEIGHT = {"sand": 14367.88, "mohr-coulomb": 16000.0}  # N/m³
CELLS = (16, 24, 32)  # cells of the disc's diameter along x; half as high
WEIGHTS = (0.6, 1.2, 2.4, 3.5, 6.0)  # W/(γ t d²)
TEXTBOOK = {  # the soil of cases/towed_disc_mohr_coulomb.toml
    "law": '"mohr-coulomb"',
    "friction_angle": '"35 deg"',
    "dilation_angle": '"0 deg"',
    "cohesion": '"0 Pa"',
    "unit_weight": '"16 kN/m^3"',
    "young_modulus": '"5 MPa"',
    "poisson_ratio": "0.3",
}
# Light discs, which sink by some millimetres: flat cells half as high, at half the speed, so that v²/(g z) stays below 0.2.
LIGHT = {
    "grid.cell": '"3 mm"',
    "grid.aspect": "[3, 3, 1]",
    "grid.fine_x": '["-0.108 m", "0.126 m"]',
    "grid.fine_y": '["0 m", "0.054 m"]',
    "grid.fine_z": '["-0.06 m", "0.03 m"]',
    "body.disc.forward": '{ speed = "0.1 m/s", start = "0.3 s", ramp = "0.1 s" }',
}
FINE = {"grid.cell": '"2 mm"', "grid.aspect": "[4, 4, 1]"}
HEAVY = {
    "domain.z": '["-0.3 m", "0.1 m"]',
    "grid.fine_x": '["-0.144 m", "0.192 m"]',
    "grid.fine_z": '["-0.144 m", "0.045 m"]',
}


def words(sets):
    return [word for key, value in sets.items() for word in ("--set", f"{key}={value}")]


def run(coulter, case, folder, sets):
    if not (folder / "summary.json").exists():
        command = [coulter, "run", case, "--output", folder, "--force", "--threads", "1"] + words(sets)
        subprocess.run(command, check=False, stdout=subprocess.DEVNULL)
    return json.loads((folder / "summary.json").read_text(encoding="utf-8"))


def forecast(coulter, case, sets):
    done = subprocess.run([coulter, "forecast", case, "--json"] + words(sets), check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def history(folder):
    with open(folder / "forces.csv", encoding="utf-8") as file:
        return [{name: float(value) for name, value in row.items() if value} for row in csv.DictReader(file)]


def moving_average(values, half):
    return [sum(values[i - half : i + half + 1]) / (2 * half + 1) for i in range(half, len(values) - half)]


def pressed_case(folder, soil):
    """The case of the pressed disc, in textbook soil with that of the shipped case."""
    text = PRESSED.read_text(encoding="utf-8")
    if soil == "mohr-coulomb":
        begin, end = text.index("[soil]"), text.index("[domain]")
        text = text[:begin] + "[soil]\n" + "".join(f"{k} = {v}\n" for k, v in TEXTBOOK.items()) + "\n" + text[end:]
    path = folder / f"pressed_{soil}.toml"
    path.write_text(text, encoding="utf-8")
    return path


def pressed(coulter, folder, soil):
    """Vertical force at z = 0.1 d, its noise from 0.05 d on, and the closed forms at that depth."""
    case = pressed_case(folder, soil)
    for cells in CELLS:
        out = folder / f"pressed_{soil}_{cells}"
        summary = run(coulter, case, out, {"grid.cell": f'"{1e3 * DIAMETER / cells / 2} mm"'})
        rows = [row for row in history(out) if "sinkage z [m]" in row]
        half = round(0.01 * DIAMETER / (rows[-2]["sinkage z [m]"] - rows[-3]["sinkage z [m]"]))
        force = [row["vertical F_V [N]"] for row in rows]
        mean = moving_average(force, half)
        depth = [row["sinkage z [m]"] for row in rows][half:-half]
        window = [n for n, z in enumerate(depth) if 0.05 <= z / DIAMETER <= 0.1]
        rms = math.sqrt(sum((force[n + half] - mean[n]) ** 2 for n in window) / len(window))
        level = sum(mean[n] for n in window) / len(window)
        at = [min(range(len(depth)), key=lambda n: abs(depth[n] - z * DIAMETER)) for z in (0.05, 0.1)]
        forces = "; ".join(f"{mean[n]:.1f} N" for n in at)
        print(f"D1 | {soil} | {cells} | {forces} | noise {100 * rms / level:.2f} % | {summary['trust']['verdict']}")
    found = forecast(coulter, case, {"body.disc.sinkage": '"20 mm"', "run.duration": '"1 ms"'})
    for model in (model for model in found["models"] if model["applicable"]):
        print(f"D1 | {soil} | {model['name']} | {model['vertical_N']:.1f} N ({ends(model, 'vertical_N', 1.0)})")
    davis = [model for model in found["models_davis"] if model["name"] == found["recommended"]]
    print("".join(f"D1 | {soil} | {model['name']}, Davis' angle | {model['vertical_N']:.1f} N" for model in davis))


def ends(model, quantity, size):
    interval = model["interval"][quantity]
    return f"{interval['low'] * size:.3g} to {interval['high'] * size:.3g}" if interval else "–"


def front(folder, sinkage):
    """Angle of the front of the contact [°] and its height over the undisturbed surface [mm], from the stress on the rim."""
    with open(folder / "rim.csv", encoding="utf-8") as file:
        rim = [(float(row["angle [rad]"]), float(row["normal stress [Pa]"] or 0)) for row in csv.DictReader(file)]
    most = max(stress for _, stress in rim)
    angle = max(angle for angle, stress in rim if stress > 0.02 * most)
    return math.degrees(angle), 1e3 * (0.5 * DIAMETER * (1 - math.cos(angle)) - sinkage)


def free(coulter, folder, soil):
    """Sinkage, drag, skid and axle torque of the free disc at several weights, and the closed forms of the same case."""
    case = ROOT / "cases" / TOWED[soil]
    runs = [(ratio, f"free_{soil}_{ratio}", LIGHT if ratio < 2 else HEAVY) for ratio in WEIGHTS]
    if soil == "sand":  # the lightest once more, on finer cells
        runs.insert(1, (WEIGHTS[0], f"free_{soil}_{WEIGHTS[0]}_fine", LIGHT | FINE))
    for ratio, name, grid in runs:
        weight = ratio * UNIT_WEIGHT[soil] * THICKNESS * DIAMETER**2
        sets = {"body.disc.weight": f'"{weight:.2f} N"'} | grid
        out = folder / name
        summary = run(coulter, case, out, sets)
        mean = summary["bodies"]["disc"]["steady"]
        sinkage, drag = mean["sinkage_m"], mean["drag_N"]
        angle, height = front(out, sinkage)
        resultant = math.degrees(math.atan(drag / mean["vertical_N"]))
        print(
            f"D3 | {soil} | {ratio} | {weight:.1f} N | z {1e3 * sinkage:.1f} mm | F_H {drag:.2f} N | skid {mean['turn_ratio'] - 1:.2f} | "
            f"torque {200 * mean['axle_torque_Nm'] / (weight * DIAMETER):.3f} % | noise {100 * mean['drag_noise']:.2f} % | "
            f"{summary['trust']['verdict']} | front {angle:.0f}°, {height:.1f} mm, resultant {resultant:.1f}°, {resultant / angle:.2f} of it"
        )
        found = forecast(coulter, case, sets)
        for model in (model for model in found["models"] if model["applicable"]):
            skid = "–" if model["skid"] is None else f"{model['skid']:.2f}"
            print(
                f"D3 | {soil} | {ratio} | {model['name']} | z {1e3 * model['sinkage_m']:.1f} ({ends(model, 'sinkage_m', 1e3)}) mm | "
                f"F_H {model['drag_N']:.2f} ({ends(model, 'drag_N', 1.0)}) N | skid {skid}"
            )


def main():
    coulter, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for soil in sys.argv[3:] or ("sand", "mohr-coulomb"):
        pressed(coulter, folder, soil)
        free(coulter, folder, soil)


if __name__ == "__main__":
    main()
