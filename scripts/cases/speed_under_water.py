#!/usr/bin/env python3
"""The disc of cases/disc_under_water.toml in medium dense sand at several speeds, as `coulter forecast` has it: speed_under_water.py [COULTER]

For each permeability and speed: drainage number, sinkage and drag of the recommended model with suction (a third of it, it, three times as much),
and the drag of the water. Figures of docs/studies/towing-under-water.md. Python 3.
"""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CASE = ROOT / "cases" / "disc_under_water.toml"
SPEEDS = (0.01, 0.05, 0.2, 1.0, 2.0)  # m/s
PERMEABILITIES = (5e-3, 1e-3, 1e-4)  # m/s


def forecast(coulter, speed, permeability):
    sets = [
        "soil.relative_density=0.5",
        f"water.permeability={permeability} m/s",
        f"body.disc.forward={{ speed = '{speed} m/s' }}",
    ]
    command = [coulter, "forecast", CASE, "--json"] + [word for key in sets for word in ("--set", key)]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def main():
    coulter = sys.argv[1] if len(sys.argv) > 1 else "coulter"
    for permeability in PERMEABILITIES:
        for speed in SPEEDS:
            found = forecast(coulter, speed, permeability)
            water, name = found["water"], found["recommended"]
            of = [next(m for m in one["models"] if m["name"] == name) for one in water["with_suction"]]
            sinkage = [f"{1e3 * m['sinkage_m']:.1f}" for m in of]
            drag = [f"{m['drag_N']:.1f}" for m in of]
            drained = next(m for m in found["models"] if m["name"] == name)
            print(
                f"k {permeability:g} m/s, v {speed:g} m/s: N_s {water['drainage_number']:.3g}, "
                f"z {sinkage[1]} mm ({sinkage[2]} to {sinkage[0]}), F_H {drag[1]} N ({drag[2]} to {drag[0]}), "
                f"water {water['water_drag_N']:.3g} N; drained {1e3 * drained['sinkage_m']:.1f} mm, {drained['drag_N']:.1f} N"
            )


if __name__ == "__main__":
    main()
