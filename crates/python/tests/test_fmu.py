"""Cases as functional mock-up units, driven by FMPy."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import coulter

fmpy = pytest.importorskip("fmpy")
import fmpy.fmi3  # noqa: E402
import fmpy.validation  # noqa: E402

PROGRAM = os.environ.get("COULTER_PROGRAM", "coulter")

CASE = """
format = 2
soil = { law = "mohr-coulomb", friction_angle = "35 deg", unit_weight = "16 kN/m^3", young_modulus = "5 MPa" }
domain = { x = ["-0.35 m", "0.55 m"], y = ["0 m", "0.3 m"], z = ["-0.25 m", "0.1 m"], symmetric = true }
grid = { cell = "25 mm", growth = 1.15 }
run = { duration = "0.2 s" }
output = { history_interval = "2 ms" }
[body.disc]
shape = "disc"
diameter = "0.2 m"
thickness = "0.08 m"
friction = 0.3
weight = "60 N"
forward = { speed = "0.2 m/s", start = "0.05 s", ramp = "0.02 s" }
heave = "free"
spin = "free"
"""


def exported(folder: Path, *options: str) -> Path:
    (folder / "tow.toml").write_text(CASE)
    command = [PROGRAM, "export-fmu", "tow.toml", "-o", "tow.fmu", "--force", *options]
    subprocess.run(command, cwd=folder, check=True, capture_output=True)
    return folder / "tow.fmu"


def step_of(unit: Path) -> float:
    return float(fmpy.read_model_description(unit).defaultExperiment.stepSize)


class Driven:
    """An instance as an importer drives it."""

    def __init__(self, unit: Path, **start: str) -> None:
        self.messages: list[str] = []
        about = fmpy.read_model_description(unit)
        self.references = {variable.name: variable.valueReference for variable in about.modelVariables}
        self.fmu: Any = fmpy.fmi3.FMU3Slave(
            guid=about.guid,
            modelIdentifier=about.coSimulation.modelIdentifier,
            unzipDirectory=fmpy.extract(unit),
            instanceName="tow",
        )

        def log(_environment: int, _status: int, _category: bytes, message: bytes) -> None:
            self.messages.append(message.decode())

        self.callback = fmpy.fmi3.fmi3LogMessageCallback(log)
        self.fmu.instantiate(logMessage=self.callback)
        for name, value in start.items():
            self.fmu.setString([self.references[name]], [value])
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def get(self, *names: str) -> list[float]:
        values = self.fmu.getFloat64([self.references[name] for name in names])
        return [float(value) for value in values]

    def set(self, **values: float) -> None:
        for name, value in values.items():
            self.fmu.setFloat64([self.references[f"disc.command.{name.replace('__', '.')}"]], [value])


FORCE = ("disc.force.x", "disc.force.y", "disc.force.z")


def test_a_unit_has_the_forces_of_the_run(tmp_path: Path) -> None:
    unit = exported(tmp_path)
    assert fmpy.validation.validate_fmu(str(unit)) == []
    step = step_of(unit)
    driven = fmpy.simulate_fmu(
        str(unit), stop_time=90 * step, output_interval=step, start_values={"output": str(tmp_path / "driven")}
    )
    coulter.run(tmp_path / "tow.toml", output=tmp_path / "run")
    own = (tmp_path / "run/forces.csv").read_text().splitlines()
    # Steps agree but for the last, which FMPy takes to the time that it was told.
    assert (tmp_path / "driven/forces.csv").read_text().splitlines()[:90] == own[:90]
    table = np.genfromtxt(own[2:90], delimiter=",")
    drag, vertical = -driven["disc.force.x"][1:89], driven["disc.force.z"][1:89]
    scale = np.abs(table[:, 4]).max()
    # Both are means over the same steps: as far as the table has digits they are alike.
    np.testing.assert_allclose(np.c_[drag, vertical], table[:, 3:5], atol=1e-8 * scale)
    assert scale > 50.0


def test_a_unit_is_steered_like_a_simulation(tmp_path: Path) -> None:
    unit = exported(tmp_path, "--steer", "disc=velocity")
    driven = Driven(unit, output=str(tmp_path / "driven"))
    twist = coulter.Twist([0.2, 0.0, -0.1], [0.0, 1.0, 0.0])
    driven.set(velocity__x=0.2, velocity__z=-0.1, angular_velocity__y=1.0)
    with coulter.Simulation(tmp_path / "tow.toml", output=tmp_path / "own") as own:
        for n in range(10):
            driven.fmu.doStep(n * 1e-3, 1e-3)
            own.step_until(n * 1e-3 + 1e-3, {"disc": twist})
            assert driven.get(*FORCE) == own.bodies["disc"].force.tolist()
        state = driven.fmu.getFMUState()
        once = again(driven)
        driven.fmu.setFMUState(driven.fmu.deserializeFMUState(driven.fmu.serializeFMUState(state)))
        assert again(driven) == once
    driven.fmu.freeFMUState(state)
    driven.fmu.terminate()
    assert (tmp_path / "driven/report.html").is_file()
    assert any("trust:" in message for message in driven.messages)
    driven.fmu.freeInstance()


def again(driven: Driven) -> list[float]:
    for n in range(10, 15):
        driven.fmu.doStep(n * 1e-3, 1e-3)
    return driven.get(*FORCE, "time")


def test_what_is_wrong_is_an_error_of_the_standard(tmp_path: Path) -> None:
    unit = exported(tmp_path, "--steer", "disc=velocity")
    driven = Driven(unit)
    driven.set(velocity__y=0.1)
    with pytest.raises(fmpy.fmi1.FMICallException) as error:
        driven.fmu.doStep(0.0, 1e-3)
    assert error.value.status == 2 and "it is to move along y" in driven.messages[-1]
    driven.set(velocity__y=0.0)
    driven.fmu.doStep(0.0, 1e-3)
    driven.fmu.freeInstance()
    with pytest.raises(fmpy.fmi1.FMICallException):
        Driven(unit, set="soil.friction_angle=95 deg")
