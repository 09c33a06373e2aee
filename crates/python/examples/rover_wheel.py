"""A rover's driven wheel on its suspension arm, in loose sand: MuJoCo moves it, the soil is Coulter's.

    python rover_wheel.py [SECONDS]

A quarter of a rover: a chassis that the other wheels keep level, free to travel and to heave, an arm with
spring and damper, and a wheel whose motor's torque falls as it turns faster. The chassis pulls a load that
grows in stages. Speed, slip and sinkage follow from the forces. Printed: which pull costs which slip.
"""

from __future__ import annotations

import copy
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import mujoco
import numpy as np
from energy_audit import EnergyAudit
from mujoco_soil import SoilBridge

import coulter

RADIUS, WIDTH, MASS = 0.125, 0.1, 3.0  # of the wheel [m, m, kg]
CHASSIS, ARM = 10.0, 1.0  # masses [kg]
REACH, DROP = 0.2, 0.075  # of the axle behind and below the arm's pivot [m]
STIFFNESS = 200.0  # of the suspension [N m/rad]
RATE = 1.4  # of the motor without a load [rad/s]
PULLS = (0.0, 8.0, 16.0, 24.0)  # on the chassis, one after the other [N]

SAG = (CHASSIS + ARM / 2) * 9.81 * REACH / STIFFNESS  # turn that bears the chassis [rad]
MODEL = f"""
<mujoco>
  <option gravity="0 0 -9.81" integrator="implicitfast"/>
  <default><geom contype="0" conaffinity="0"/></default>  <!-- what touches the soil is Coulter's -->
  <worldbody>
    <body name="chassis" pos="{REACH} 0 {RADIUS + DROP}">
      <joint name="travel" type="slide" axis="1 0 0"/>
      <joint name="heave" type="slide" axis="0 0 1"/>
      <geom type="box" size="0.15 0.1 0.04" mass="{CHASSIS}"/>
      <body name="arm">
        <joint name="suspension" type="hinge" axis="0 1 0"
          stiffness="{STIFFNESS}" damping="10" springref="{-SAG}"/>
        <geom type="capsule" fromto="0 0 0 {-REACH} 0 {-DROP}" size="0.015" mass="{ARM}"/>
        <body name="wheel" pos="{-REACH} 0 {-DROP}">
          <joint name="axle" type="hinge" axis="0 1 0"/>
          <geom type="cylinder" size="{RADIUS} {WIDTH / 2}" zaxis="0 1 0" mass="{MASS}"/>
        </body>
      </body>
    </body>
  </worldbody>
  <actuator>
    <velocity name="motor" joint="axle" kv="20"/>  <!-- 20 N m per rad/s below its rate without a load -->
    <motor name="pull" joint="travel"/>
  </actuator>
</mujoco>
"""

# The soil, and the wheel as the soil meets it. Cells are coarse, so that ten seconds take 30 s on one thread.
SOIL: dict[str, Any] = {
    "format": 2,
    "title": "A rover's wheel",
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
        "x": ["-0.44 m", "0.44 m"],
        "y": ["0 m", "0.36 m"],
        "z": ["-0.31 m", "0.14 m"],
        "symmetric": True,
    },
    "grid": {
        "cell": "12.5 mm",
        "aspect": [2, 2, 1],
        "growth": 1.4,
        "fine_x": ["-0.15 m", "0.175 m"],
        "fine_y": ["0 m", "0.075 m"],
        "fine_z": ["-0.1 m", "0.05 m"],
        "follow": {"body": "wheel", "axes": "x"},
    },
    "body": {
        "wheel": {
            "shape": "disc",
            "diameter": (2 * RADIUS, "m"),
            "thickness": (WIDTH, "m"),
            "rim": "rounded",
            "rim_radius": "25 mm",
            "friction": 0.6,
            "mass": (MASS, "kg"),
            "forward": "free",
            "heave": "free",
            "spin": "free",
        }
    },
    "run": {},
    "output": {"field_interval": "1 s"},
}


class Stage(NamedTuple):
    """Means over the second half of the time under one pull [N, m/s, rad/s, m, N m]."""

    pull: float
    speed: float
    rate: float
    sinkage: float
    torque: float

    @property
    def slip(self) -> float:
        """Of the wheel: 0 rolls, 1 spins on the spot."""
        return 1.0 - self.speed / (self.rate * RADIUS)


@dataclass
class Outcome:
    """A drive.

    Attributes:
        result: the run.
        stages: what each pull made of it.
        energy: its audit.
        apart: largest difference of the wheel's velocities in the two programs [m/s, rad/s].
    """

    result: coulter.Result
    stages: list[Stage]
    energy: EnergyAudit
    apart: float


def drive(seconds: float, folder: Path, steps: int = 1) -> Outcome:
    """Drives under each pull for an equal time, with so many steps of the soil between two exchanges."""
    case = copy.deepcopy(SOIL)
    case["run"]["duration"] = (seconds, "s")
    model = mujoco.MjModel.from_xml_string(MODEL)
    data = mujoco.MjData(model)
    motor, pull = data.actuator("motor"), data.actuator("pull")
    rows: list[tuple[float, ...]] = []
    with coulter.Simulation(case, output=folder, start="replace", threads=1) as soil:
        model.opt.timestep = steps * soil.time_step
        bridge, audit = SoilBridge(soil, model, data, ["wheel"]), EnergyAudit(model, data)
        while soil.time + model.opt.timestep <= seconds:
            share = soil.time / seconds * len(PULLS)
            # The motor starts softly when the wheel has settled for 0.2 s; each pull comes on within 0.1 s.
            motor.ctrl = RATE * min(max((soil.time - 0.2) / 0.2, 0.0), 1.0)
            now, last = PULLS[int(share)], PULLS[max(int(share) - 1, 0)]
            pull.ctrl = -(last + (now - last) * min((share % 1.0) * seconds / len(PULLS) / 0.1, 1.0))
            reactions = bridge.step()
            audit.add(reactions)
            wheel = reactions["wheel"]
            rows.append((share, wheel.linear[0], wheel.angular[1], wheel.sinkage, motor.force[0]))
    table = np.array(rows)
    settled = [table[(table[:, 0] > n + 0.5) & (table[:, 0] < n + 1)].mean(axis=0) for n in range(len(PULLS))]
    stages = [Stage(now, *map(float, means[1:])) for now, means in zip(PULLS, settled, strict=True)]
    return Outcome(soil.result, stages, audit, bridge.apart)


def main() -> None:
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 10.0
    folder = Path(tempfile.mkdtemp(prefix="rover_wheel_"))
    outcome = drive(seconds, folder)
    print("pull [N]  speed [m/s]  slip [-]  sinkage [mm]  motor [N m]")
    for stage in outcome.stages:
        how = f"{stage.speed:13.4f}{stage.slip:10.3f}{1e3 * stage.sinkage:14.2f}{stage.torque:13.3f}"
        print(f"{stage.pull:8.0f}{how}")
    check = next(check for check in outcome.result.checks if check["name"] == "exchanged energy")
    print(f"energy: {outcome.energy}")
    print(f"exchanged energy: {check['value']:.1e} {check['unit']}, {check['verdict']}")
    print(f"velocities of the wheel: at most {outcome.apart:.1e} apart")
    print(f"results: {folder}")


if __name__ == "__main__":
    main()
