"""The examples with MuJoCo: energy closes, and Coulter's own mechanism agrees."""

from __future__ import annotations

import copy
import sys
from pathlib import Path

import numpy as np
import pytest

import coulter

mujoco = pytest.importorskip("mujoco")
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "examples"))

import disc_on_a_boom  # noqa: E402
import rover_wheel  # noqa: E402
from energy_audit import EnergyAudit  # noqa: E402
from mujoco_soil import SoilBridge  # noqa: E402


def exchanged(result: coulter.Result) -> str:
    """The verdict on the energy that passed between the programs."""
    return next(str(check["verdict"]) for check in result.checks if check["name"] == "exchanged energy")


def test_a_disc_on_a_boom_moves_as_coulter_moves_it(in_folder: Path) -> None:
    outcome = disc_on_a_boom.compare(3.0, in_folder)
    assert exchanged(outcome.mujoco) == "good"
    assert outcome.apart < 1e-10
    assert abs(outcome.energy.missing) < 1e-4
    for name, theirs, ours, _ in outcome.rows():
        assert theirs == pytest.approx(ours, rel=0.01), name
    rows = {name: ours for name, _, ours, _ in outcome.rows()}
    assert 0.02 < rows["sinkage"] < 0.05 and 0.5 < rows["turn_ratio"] < 1.0 and 50.0 < rows["drag"] < 100.0


def test_a_rover_wheel_slips_and_sinks_as_it_pulls(in_folder: Path) -> None:
    outcome = rover_wheel.drive(2.0, in_folder)
    assert exchanged(outcome.result) == "good"
    assert outcome.apart < 1e-9
    assert abs(outcome.energy.missing) < 1e-3
    stages = outcome.stages
    for now, then in zip(stages, stages[1:], strict=False):
        assert now.slip < then.slip and now.torque < then.torque and now.sinkage < then.sinkage
    assert 0.1 < stages[0].slip < 0.5 < stages[-1].slip < 1.0
    # What the motor puts in, less what the arm's damper takes and the chassis pulls, goes into the soil.
    assert outcome.energy.spent > outcome.energy.drives > 0.0 > outcome.energy.dampers


def joined(model_text: str, soil: coulter.Simulation) -> SoilBridge:
    """A bridge for the disc of a model."""
    model = mujoco.MjModel.from_xml_string(model_text)
    model.opt.timestep = soil.time_step
    return SoilBridge(soil, model, mujoco.MjData(model), ["disc"])


def test_a_mass_beside_the_axle_and_a_dozen_steps_of_the_soil_between_exchanges(in_folder: Path) -> None:
    case = copy.deepcopy(disc_on_a_boom.SOIL)
    case["run"]["duration"] = (0.2, "s")
    ballast = '<geom size="0.03" pos="0.1 0 0.02" mass="5"/></body>'
    text = disc_on_a_boom.MODEL.replace("</body>", ballast, 1)
    with coulter.Simulation(case, output="ballast", threads=1) as soil:
        bridge = joined(text, soil)
        bridge.model.opt.timestep = 12 * soil.time_step
        audit = EnergyAudit(bridge.model, bridge.data)
        while soil.time < 0.19:
            reactions = bridge.step()
            audit.add(reactions)
    disc = reactions["disc"]
    assert bridge.apart < 1e-10 and abs(audit.missing) < 0.01
    # The disc has turned towards its heavy side, in front.
    assert disc.angular[1] != 0.0 and disc.quaternion[2] > 0.01
    np.testing.assert_allclose(disc.position, bridge.data.body("disc").xpos, atol=1e-4)


def test_what_is_not_linear_is_refused(in_folder: Path) -> None:
    case = copy.deepcopy(disc_on_a_boom.SOIL)
    case["run"]["duration"] = (0.1, "s")
    with coulter.Simulation(case, output="refused", threads=1) as soil:
        sticky = disc_on_a_boom.MODEL.replace('name="hitch"', 'name="hitch" frictionloss="1"')
        with pytest.raises(NotImplementedError, match="dry friction"):
            joined(sticky, soil).step()
        with pytest.raises(ValueError, match="RK4"):
            joined(disc_on_a_boom.MODEL.replace("implicitfast", "RK4"), soil)
        assert soil.time == 0.0
        joined(disc_on_a_boom.MODEL, soil).step()
