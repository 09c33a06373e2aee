"""A sensor of the ground and a controller: closed forms, and what they hold in the soil."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import DISC, SHORT

import coulter

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "examples"))

import depth_control  # noqa: E402

# A disc that is let go at once, for long enough.
STEERED = {
    **{key: value for key, value in SHORT.items() if key != "run.tow_distance"},
    "body.disc.forward": {"speed": "0.2 m/s", "ramp": "0 s"},
    "body.disc.heave": {"load": "0 N", "ramp": "0 s"},
    "run": {"duration": (1, "s")},
}


def step_response(controller: coulter.Controller, lag: float, interval: float, number: int) -> list[float]:
    """A quantity that follows what drives it with a lag, from 0 to a setpoint of 1."""
    stays, y = math.exp(-interval / lag), [0.0]
    for _ in range(number):
        y.append(stays * y[-1] + (1.0 - stays) * 3.0 * controller.output(1.0, y[-1], interval))
    return y


def test_a_step_response_is_the_exact_one() -> None:
    # The integral time that cancels the lag leaves one pole, 1 - 3 K (1 - exp(-h/T)).
    lag, interval, gain, number = 0.5, 0.1, 0.4, 30
    stays = math.exp(-interval / lag)
    controller = coulter.Controller(gain, (-9.0, 9.0), integral_time=interval / (1.0 - stays))
    pole = 1.0 - 3.0 * gain * (1.0 - stays)
    exact = [1.0 - pole**n for n in range(number + 1)]
    np.testing.assert_allclose(step_response(controller, lag, interval, number), exact, atol=1e-14)
    # With short intervals that of the controller in continuous time.
    fine = step_response(coulter.Controller(gain, (-9.0, 9.0), integral_time=lag), lag, 1e-4, 5000)
    exact = [1.0 - math.exp(-3.0 * gain * n * 0.05 / lag) for n in range(11)]
    np.testing.assert_allclose(fine[::500], exact, atol=2e-4)


def test_the_derivative_of_a_ramp_is_its_slope() -> None:
    gain, time, interval, slope = 2.0, 0.3, 0.02, -0.7
    controller = coulter.Controller(gain, (-9.0, 9.0), derivative_time=time, derivative_filter=5.0)
    found = [controller.output(n * interval * slope, n * interval * slope, interval) for n in range(60)]
    decays = time / (time + 5.0 * interval)
    np.testing.assert_allclose(found, [-gain * time * slope * (1.0 - decays**n) for n in range(60)], atol=1e-13)


def test_the_integral_does_not_wind_up_at_a_limit() -> None:
    controller = coulter.Controller(2.0, (-1.0, 3.0), integral_time=0.5)
    outputs = [controller.output(1.0, -9.0, 0.1) for _ in range(200)]
    assert outputs == [3.0] * 200 and controller.is_limited
    assert controller.integral == pytest.approx(3.0)
    # It leaves the limit as soon as the error changes its sign.
    assert controller.output(1.0, 1.01, 0.1) == pytest.approx(2.98)
    assert not controller.is_limited
    controller.reset(0.5)
    assert controller.output(1.0, 1.0, 0.1) == 0.5
    assert controller.output(1.0, 1.0, 0.1, feedforward=-7.0) == -1.0 and controller.is_limited


@pytest.mark.parametrize(
    ("wrong", "why"),
    [
        ({"gain": 0.0}, "gain = 0"),
        ({"gain": math.nan}, "gain = nan"),
        ({"limits": (1.0, 1.0)}, "must be less than the second"),
        ({"limits": (0.0, math.nan)}, "must be less than the second"),
        ({"integral_time": 0.0}, "integral_time = 0.0: it must be positive"),
        ({"derivative_time": -1.0}, "derivative_time = -1"),
        ({"derivative_filter": 0.0}, "derivative_filter"),
        ({"setpoint_weight": math.inf}, "setpoint_weight"),
    ],
)
def test_what_makes_no_controller_is_refused(wrong: dict[str, Any], why: str) -> None:
    with pytest.raises(coulter.RequestError, match=why):
        coulter.Controller(**{"gain": 1.0, "limits": (-1.0, 1.0), **wrong})


def test_what_cannot_be_controlled_is_refused() -> None:
    controller = coulter.Controller(1.0, (-1.0, 1.0), integral_time=0.1)
    for arguments, why in [
        ((math.nan, 0.0, 0.1), "setpoint = nan"),
        ((0.0, math.inf, 0.1), "measured = inf"),
        ((0.0, 0.0, 0.0), "interval = 0.0: it must be positive"),
        ((0.0, 0.0, 0.2), "exchange more often"),
    ]:
        with pytest.raises(coulter.RequestError, match=why):
            controller.output(*arguments)
    assert controller.integral == 0.0


def test_ground_is_sensed(in_folder: Path) -> None:
    with coulter.Simulation(DISC, set=STEERED, output="sensed", threads=1) as simulation:
        heights = simulation.ground([[[0.3, 0.0], [0.3, -0.2]], [[0.3, 0.4], [9.0, 0.0]]])
        np.testing.assert_array_equal(heights, [[0.0, 0.0], [np.nan, np.nan]])
        assert float(simulation.ground((0.3, 0.1))) == 0.0
        assert simulation.ground(np.empty((0, 2))).shape == (0,)
        for wrong in [[1.0, 2.0, 3.0], [[0.0, math.nan]], 1.0]:
            with pytest.raises(coulter.RequestError, match="pairs"):
                simulation.ground(wrong)
        simulation.step_until(0.01)
        simulation.stop()
        with pytest.raises(coulter.RequestError, match="has ended"):
            simulation.ground([[0.0, 0.0]])


def held(
    command: Callable[[coulter.Reaction], coulter.Command], measured: Callable[[coulter.Reaction], float], **keys: Any
) -> float:
    """Mean of what is measured over the last 0.3 s of 0.9 s."""
    values = []
    with coulter.Simulation(DISC, set={**STEERED, **keys}, output="held", threads=1) as simulation:
        for n in range(1, 91):
            disc = simulation.step_until(0.01 * n, {"disc": command(simulation.bodies["disc"])})["disc"]
            values.append(measured(disc))
    return float(np.mean(values[60:]))


def test_a_load_is_held_by_the_height(in_folder: Path) -> None:
    controller = coulter.Controller(gain=-0.001, limits=(-0.1, 0.1), integral_time=1.0)

    def command(disc: coulter.Reaction) -> coulter.Command:
        return coulter.Twist([0.2, 0.0, controller.output(50.0, float(disc.force[2]), 0.01)], [0.0, 1.5, 0.0])

    # Cells of a quarter of the disc's radius: from one exchange to the next the force scatters by 8 N.
    assert held(command, lambda disc: float(disc.force[2])) == pytest.approx(50.0, rel=0.1)


def test_a_speed_is_held_by_a_force(in_folder: Path) -> None:
    controller = coulter.Controller(gain=200.0, limits=(0.0, 60.0), integral_time=0.1)

    def command(disc: coulter.Reaction) -> coulter.Command:
        return coulter.Load([controller.output(0.15, float(disc.linear[0]), 0.01), 0.0, 0.0])

    speed = held(command, lambda disc: float(disc.linear[0]), **{"body.disc.forward": "free"})
    assert speed == pytest.approx(0.15, rel=0.03)


def test_a_slip_is_held_by_a_torque(in_folder: Path) -> None:
    controller = coulter.Controller(gain=2.0, limits=(-5.0, 5.0), integral_time=0.1)

    def slip(disc: coulter.Reaction) -> float:
        rolls = 0.1 * float(disc.angular[1])
        return (rolls - 0.2) / max(rolls, 0.2)

    def command(disc: coulter.Reaction) -> coulter.Command:
        return coulter.Load(moment=[0.0, controller.output(0.2, slip(disc), 0.01), 0.0])

    assert held(command, slip) == pytest.approx(0.2, rel=0.03)


def test_a_blade_keeps_to_the_ground_or_to_its_drag(in_folder: Path) -> None:
    tows = {
        name: depth_control.tow(steering(), 1.8, in_folder / name) for name, steering in depth_control.STEERINGS.items()
    }
    fixed, depth, drag = (own.figures() for own in tows.values())
    for own in tows.values():
        exchanged = next(check for check in own.result.checks if check["name"] == "exchanged energy")
        assert exchanged["verdict"] == "good"
    # Furrows of an amplitude of 30 mm; their r.m.s. is 30 mm/sqrt(2).
    assert fixed["depth off"] == pytest.approx(0.03 / math.sqrt(2.0), rel=0.1)
    assert depth["depth off"] < 0.1 * fixed["depth off"]
    assert depth["depth"] == pytest.approx(depth_control.DEPTH, rel=0.02)
    assert drag["drag swings"] < 0.6 * fixed["drag swings"]
    assert drag["drag"] == pytest.approx(depth_control.DRAG, rel=0.1)
    # At a fixed height the drag follows the depth; at a constant one it is larger in a trough, where the ground
    # in front rises.
    for name, sign in [("fixed height", -1.0), ("constant depth", 1.0)]:
        own = tows[name]
        settled = own.x > 0.2
        trough = -np.cos(2.0 * math.pi * own.x / depth_control.SPACING)
        assert sign * np.corrcoef(trough[settled], own.drag[settled])[0, 1] > 0.6, name
