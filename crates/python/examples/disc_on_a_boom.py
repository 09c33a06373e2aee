"""A disc that turns freely on a boom, towed through loose sand: MuJoCo moves it, the soil is Coulter's.

    python disc_on_a_boom.py [SECONDS]

The boom pitches freely on a carriage that is towed at a constant speed. Coulter then moves the same mechanism
itself, and both are compared.
"""

from __future__ import annotations

import copy
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import mujoco
from energy_audit import EnergyAudit
from mujoco_soil import SoilBridge

import coulter

SPEED, START, RAMP = 0.3, 0.4, 0.1  # of the tow [m/s, s, s], after the disc has settled
RADIUS, THICKNESS, MASS = 0.15, 0.1, 20.0  # of the disc [m, m, kg]
BOOM, BOOM_MASS = 0.6, 2.0  # length [m] and mass [kg]
BOOM_INERTIA = BOOM_MASS * BOOM**2 / 12.0  # about its middle [kg m²]

MODEL = f"""
<mujoco>
  <option gravity="0 0 -9.81" integrator="implicitfast"/>
  <default><geom contype="0" conaffinity="0"/></default>  <!-- what touches the soil is Coulter's -->
  <worldbody>
    <body name="carriage" pos="{BOOM} 0 {RADIUS}">
      <joint name="tow" type="slide" axis="1 0 0"/>
      <inertial pos="0 0 0" mass="1" diaginertia="0.01 0.01 0.01"/>
      <body name="boom">
        <joint name="hitch" type="hinge" axis="0 1 0"/>
        <inertial pos="{-BOOM / 2} 0 0" mass="{BOOM_MASS}" diaginertia="{3 * f'{BOOM_INERTIA} '}"/>
        <body name="disc" pos="{-BOOM} 0 0">
          <joint name="axle" type="hinge" axis="0 1 0"/>
          <geom type="cylinder" size="{RADIUS} {THICKNESS / 2}" zaxis="0 1 0" mass="{MASS}"/>
        </body>
      </body>
    </body>
  </worldbody>
  <actuator>
    <velocity joint="tow" kv="1e6"/>  <!-- so stiff that the speed keeps to 0.1 mm/s -->
  </actuator>
</mujoco>
"""

# The soil, and the disc as the soil meets it. Cells are coarse, so that ten seconds take 40 s on one thread.
SOIL: dict[str, Any] = {
    "format": 2,
    "title": "A disc on a boom",
    "soil": {
        "law": "sand",
        "critical_friction_angle": (32, "deg"),
        "minimum_density": (1400, "kg/m^3"),
        "maximum_density": (1700, "kg/m^3"),
        "relative_density": "loose",
        "young_modulus": (10, "MPa"),
        "stiffness_limit": (2, "kPa"),
    },
    "domain": {
        "x": ["-0.52 m", "0.52 m"],
        "y": ["0 m", "0.42 m"],
        "z": ["-0.37 m", "0.16 m"],
        "symmetric": True,
    },
    "grid": {
        "cell": "12.5 mm",
        "aspect": [2, 2, 1],
        "growth": 1.4,
        "fine_x": ["-0.175 m", "0.2 m"],
        "fine_y": ["0 m", "0.075 m"],
        "fine_z": ["-0.1 m", "0.05 m"],
        "follow": {"body": "disc", "axes": "x"},
    },
    "body": {
        "disc": {
            "shape": "disc",
            "diameter": (2 * RADIUS, "m"),
            "thickness": (THICKNESS, "m"),
            "rim": "rounded",  # with a square one on so coarse cells the drag scatters by 3 %
            "rim_radius": "25 mm",
            "friction": 0.4,
            "mass": (MASS, "kg"),
            "axle_inertia": (0.5 * MASS * RADIUS**2, "kg*m^2"),  # of the cylinder in the model
            "forward": "free",
            "heave": {"load": "0 N", "ramp": "0 s"},  # let go at once, as MuJoCo does
            "spin": "free",
        }
    },
    "run": {},
    "output": {"field_interval": "1 s", "steady_fraction": 0.4},
}


@dataclass
class Outcome:
    """What both programs make of the same mechanism.

    Attributes:
        mujoco: the run whose bodies MuJoCo moved.
        own: the run whose bodies Coulter moved.
        energy: audit of the former.
        apart: largest difference of the disc's velocities in the two programs [m/s, rad/s].
    """

    mujoco: coulter.Result
    own: coulter.Result
    energy: EnergyAudit
    apart: float

    def rows(self) -> list[tuple[str, float, float, str]]:
        """Sinkage, turn ratio and drag by MuJoCo and by Coulter, as means over the last 40 %."""
        ours, theirs = self.own.steady("disc"), self.mujoco.steady("disc")
        names = ("sinkage", "turn_ratio", "drag")
        return [(name, theirs[name].value, ours[name].value, ours[name].unit) for name in names]


def speed(time: float) -> float:
    """Speed of the carriage: Coulter's smooth ramp."""
    risen = min(max((time - START) / RAMP, 0.0), 1.0)
    return SPEED * risen * risen * (3.0 - 2.0 * risen)


def by_mujoco(case: dict[str, Any], folder: Path, steps: int) -> tuple[coulter.Result, EnergyAudit, float]:
    """MuJoCo moves carriage, boom and disc, in ``steps`` steps of the soil at a time."""
    model = mujoco.MjModel.from_xml_string(MODEL)
    data = mujoco.MjData(model)
    with coulter.Simulation(case, output=folder, start="replace", threads=1) as soil:
        model.opt.timestep = steps * soil.time_step
        bridge, audit = SoilBridge(soil, model, data, ["disc"]), EnergyAudit(model, data)
        while soil.time + model.opt.timestep <= case["run"]["duration"][0]:
            data.ctrl[0] = speed(soil.time + 0.5 * model.opt.timestep)
            audit.add(bridge.step())
    return soil.result, audit, bridge.apart


def by_coulter(case: dict[str, Any], folder: Path) -> coulter.Result:
    """Coulter moves carriage, boom and disc."""
    case = copy.deepcopy(case)
    at = {"elevation": (RADIUS, "m")}
    tow = {"speed": (SPEED, "m/s"), "start": (START, "s"), "ramp": (RAMP, "s")}
    case["body"]["carriage"] = {"shape": "frame", "x": (BOOM, "m"), **at, "mass": "1 kg", "forward": tow}
    case["body"]["boom"] = {
        "shape": "frame",
        "x": (BOOM / 2, "m"),
        **at,
        "mass": (BOOM_MASS, "kg"),
        "axle_inertia": (BOOM_INERTIA, "kg*m^2"),
        "heave": case["body"]["disc"]["heave"],
    }
    case["joint"] = {
        "hitch": {
            "kind": "hinge",
            "bodies": ["carriage", "boom"],
            "at": [(BOOM, "m"), (0, "m"), (RADIUS, "m")],
            "axis": [0, 1, 0],
        },
        "axle": {"kind": "hinge", "bodies": ["boom", "disc"]},
    }
    return coulter.run(case, output=folder, start="replace", threads=1)


def compare(seconds: float, folder: Path, steps: int = 1) -> Outcome:
    """Both runs, into ``folder``, with so many steps of the soil between two exchanges."""
    case = copy.deepcopy(SOIL)
    case["run"]["duration"] = (seconds, "s")
    case["output"]["history_interval"] = (seconds / 500, "s")
    moved, energy, apart = by_mujoco(case, folder / "mujoco", steps)
    return Outcome(moved, by_coulter(case, folder / "coulter"), energy, apart)


def main() -> None:
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 10.0
    folder = Path(tempfile.mkdtemp(prefix="disc_on_a_boom_"))
    outcome = compare(seconds, folder)
    print(f"{'':12}{'MuJoCo':>12}{'Coulter':>12}{'difference':>12}")
    for name, theirs, ours, unit in outcome.rows():
        print(f"{name:12}{theirs:12.5f}{ours:12.5f}{100 * (theirs / ours - 1):+11.3f} %  [{unit}]")
    check = next(check for check in outcome.mujoco.checks if check["name"] == "exchanged energy")
    print(f"energy: {outcome.energy}")
    print(f"exchanged energy: {check['value']:.1e} {check['unit']}, {check['verdict']}")
    print(f"velocities of the disc: at most {outcome.apart:.1e} apart")
    print(f"results: {folder}")


if __name__ == "__main__":
    main()
