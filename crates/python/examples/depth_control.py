"""A blade is pulled through furrowed ground: at a fixed height, at a constant depth, and with a constant drag.

    python depth_control.py [SECONDS [PLOT.png]]

A gauge wheel beside the blade senses the ground, and a controller raises and lowers the blade; or it does so by
the drag, as the draft control of a tractor's hitch. Printed: how well depth and drag are held, and what that costs.

At a fixed height the drag follows the depth. At a constant depth it still swings, for in a trough the ground in front
of the blade rises, and there is more of it to cut than on a crest. Draft control evens that out, at the price of depth.
"""

from __future__ import annotations

import copy
import math
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

import coulter

SPEED, RAMP = 0.5, 0.1  # of the tow [m/s, s]
DEPTH, DRAG = 0.08, 50.0  # that are to be held [m, N]
SPACING, HEIGHT = 0.8, 0.06  # of the furrows, from crest to crest and from trough to crest [m]
EXCHANGE = 0.02  # time between exchanges [s]
LENGTH, THICKNESS, PITCH = 0.3, 0.04, -30.0  # of the blade [m, m, °]
LEANS = math.radians(-PITCH)
TIP = 0.5 * (THICKNESS * math.cos(LEANS) + LENGTH * math.sin(LEANS))  # of its edge in front of its middle [m]
WHEEL = 0.25  # distance of the gauge wheel to the side [m]

# Cells are coarse, so that the three runs of 2.6 s take 40 s on one thread.
SOIL: dict[str, Any] = {
    "format": 2,
    "title": "A blade in furrowed ground",
    "soil": {
        "law": "sand",
        "critical_friction_angle": (32, "deg"),
        "minimum_density": (1400, "kg/m^3"),
        "maximum_density": (1700, "kg/m^3"),
        "relative_density": "loose",
        "young_modulus": (10, "MPa"),
        "stiffness_limit": (2, "kPa"),
    },
    "furrows": {"spacing": (SPACING, "m"), "depth": (HEIGHT, "m")},  # across the tow; a crest lies at x = 0
    "domain": {
        "x": ["-0.3 m", "0.48 m"],
        "y": ["0 m", "0.3 m"],
        "z": ["-0.3 m", "0.15 m"],
        "symmetric": True,
    },
    "grid": {
        "cell": "15 mm",
        "aspect": [2, 1, 1],
        "growth": 1.4,
        "fine_x": ["-0.3 m", "0.48 m"],
        "fine_y": ["0 m", "0.09 m"],
        "fine_z": ["-0.15 m", "0.105 m"],
        "follow": {"body": "blade", "axes": "x"},
    },
    "body": {
        "blade": {
            "shape": "blade",
            "width": "0.09 m",
            "height": (LENGTH, "m"),
            "thickness": (THICKNESS, "m"),
            "pitch": (PITCH, "deg"),
            "bevel_angle": "35 deg",  # the edge is in front and lowest, so that the blade does not ride on its back
            "friction": 0.4,
            "sinkage": (DEPTH, "m"),
            "forward": {"speed": (SPEED, "m/s"), "ramp": (RAMP, "s")},
            "heave": {"speed": "0 m/s"},  # a motion for each direction that is steered
        }
    },
    "run": {},
    "output": {"history_interval": "20 ms", "field_interval": "1 s"},
}

# The velocity of the blade upwards [m/s] until the next exchange, from the simulation and the mean drag over 0.1 s [N].
Steering = Callable[[coulter.Simulation, float], float]


def at_fixed_height() -> Steering:
    """The blade stays as high as it is."""
    return lambda soil, drag: 0.0


def at_depth() -> Steering:
    """The edge is led along the ground that the gauge wheel finds, ahead by what the controller lags behind."""
    gain = 20.0  # [1/s]
    controller = coulter.Controller(gain, limits=(-0.15, 0.15))

    def rise(soil: coulter.Simulation, drag: float) -> float:
        blade = soil.bodies["blade"]
        ground = float(soil.ground([blade.position[0] + TIP + SPEED / gain, WHEEL]))
        return controller.output(ground - DEPTH, -blade.sinkage, EXCHANGE)

    return rise


def at_drag() -> Steering:
    """The blade is raised where the drag is too large, and lowered where it is too small."""
    controller = coulter.Controller(gain=-0.01, limits=(-0.15, 0.15))  # [m/s per N]
    return lambda soil, drag: controller.output(DRAG, drag, EXCHANGE) if soil.time > 2 * RAMP else 0.0


STEERINGS: dict[str, Callable[[], Steering]] = {
    "fixed height": at_fixed_height,
    "constant depth": at_depth,
    "constant drag": at_drag,
}


@dataclass
class Tow:
    """What became of the blade, at each exchange.

    Attributes:
        x: position of its edge [m].
        depth: of the edge below the furrows, by their formula [m].
        drag: mean of the last 0.1 s [N].
        work: of the blade on the soil since the last exchange [J].
        result: the run.
    """

    x: npt.NDArray[np.float64]
    depth: npt.NDArray[np.float64]
    drag: npt.NDArray[np.float64]
    work: npt.NDArray[np.float64]
    result: coulter.Result

    def figures(self) -> dict[str, float]:
        """Over the last furrow: means, r.m.s. of how far the depth is off and of how the drag swings, and work."""
        last = self.x > self.x[-1] - SPACING
        depth, drag = self.depth[last], self.drag[last]
        return {
            "depth": float(depth.mean()),
            "depth off": float(np.sqrt(((depth - DEPTH) ** 2).mean())),
            "drag": float(drag.mean()),
            "drag swings": float(drag.std()),
            "energy": float(self.work[last].sum()),
        }


def tow(steering: Steering, seconds: float, folder: Path) -> Tow:
    """Pulls the blade, steered in this way."""
    case = copy.deepcopy(SOIL)
    case["run"]["duration"] = (seconds, "s")
    rows, forces = [], [0.0]
    with coulter.Simulation(case, output=folder, start="replace", threads=1) as soil:
        for n in range(1, round(seconds / EXCHANGE) + 1):
            speed = SPEED * min(n * EXCHANGE / RAMP, 1.0)
            rise = steering(soil, float(np.mean(forces[-5:])))
            blade = soil.step_until(n * EXCHANGE, {"blade": coulter.Twist([speed, 0.0, rise])})["blade"]
            forces.append(-float(blade.force[0]))
            x = float(blade.position[0]) + TIP
            ground = 0.5 * HEIGHT * math.cos(2.0 * math.pi * x / SPACING)
            rows.append((x, ground + blade.sinkage, float(np.mean(forces[-5:])), -blade.work))
    x_, depth, drag, work = np.array(rows).T
    return Tow(x_, depth, drag, work, soil.result)


def plot(tows: dict[str, Tow], file: str) -> None:
    """Depth and drag over the way."""
    import matplotlib.pyplot as plt

    figure, (above, below) = plt.subplots(2, 1, sharex=True)
    for name, own in tows.items():
        above.plot(own.x, 1e3 * own.depth, label=name)
        below.plot(own.x, own.drag)
    above.set_ylabel("depth [mm]")
    below.set(xlabel="x [m]", ylabel="drag [N]")
    above.legend()
    figure.savefig(file)


def main() -> None:
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 2.6
    folder = Path(tempfile.mkdtemp(prefix="depth_control_"))
    tows = {name: tow(steering(), seconds, folder / name.replace(" ", "_")) for name, steering in STEERINGS.items()}
    print(f"{'':16}depth [mm]  r.m.s. off {1e3 * DEPTH:.0f} mm  drag [N]  swings by [N]  energy [J]")
    for name, own in tows.items():
        depth, off, drag, swings, energy = own.figures().values()
        print(f"{name:16}{1e3 * depth:10.1f}{1e3 * off:18.1f}{drag:10.1f}{swings:15.1f}{energy:12.1f}")
    if len(sys.argv) > 2:
        plot(tows, sys.argv[2])
    print(f"means are over the last furrow; results: {folder}")


if __name__ == "__main__":
    main()
