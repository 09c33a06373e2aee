"""A simulation that Python steps and steers."""

from __future__ import annotations

import os
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import DISC, SHORT

import coulter

# Let go at once, and long enough for what is tested.
STEERED = {
    **SHORT,
    "body.disc.forward": {"speed": "0.2 m/s", "ramp": "0 s"},
    "body.disc.heave": {"load": "0 N", "ramp": "0 s"},
    "run.tow_distance": (30, "mm"),
}


@pytest.mark.parametrize("device", ["cpu", "stand-in"])
def test_own_motions_have_the_bytes_of_a_run(device: str, tow: Path, in_folder: Path) -> None:
    with coulter.Simulation(DISC, set=SHORT, output="stepped", threads=1, device=device) as simulation:
        step = simulation.time_step
        for _ in range(round(coulter.open_result(tow).forces["time"][-1] / step)):
            simulation.step_until(simulation.time + step)
    for name in ["forces.csv", "energy.csv", "boundaries.csv"]:
        assert (tow / name).read_bytes() == (simulation.folder / name).read_bytes(), name
    assert simulation.result.outcome == "finished"
    assert (simulation.folder / "report.html").is_file()


def test_a_body_goes_where_it_is_led(in_folder: Path) -> None:
    with coulter.Simulation(DISC, set=STEERED, output="led") as simulation:
        start = simulation.bodies["disc"]
        assert start.force.tolist() == [0.0, 0.0, 0.0]
        angle = 0.05
        to = coulter.Pose(start.position + [0.004, 0.0, -0.003], [np.cos(angle), 0.0, np.sin(angle), 0.0])
        now = simulation.step_until(0.0213, {"disc": to})["disc"]
        np.testing.assert_allclose(now.position, to.position, atol=1e-9)
        np.testing.assert_allclose(now.quaternion, to.quaternion, atol=1e-7)
        assert simulation.time == pytest.approx(0.0213, abs=1e-9)
        assert now.force[2] > 0.0 and now.sinkage == pytest.approx(0.013, abs=1e-6)
        work = now.force @ [0.004, 0.0, -0.003] + now.moment @ [0.0, 2 * angle, 0.0]
        assert now.work == pytest.approx(work, rel=0.02)
        further = simulation.step_until(0.03, {"disc": coulter.Twist([0.2, 0.0, 0.0])})["disc"]
        assert further.linear.tolist() == [0.2, 0.0, 0.0]
    names = {check["name"] for check in simulation.result.summary["trust"]["checks"]}
    assert "exchanged energy" in names


def coupled(mass: float, position: np.ndarray, speed: float) -> coulter.Coupled:
    """A body that is free to sink and towed at 0.2 m/s."""
    mobility = np.zeros((6, 6))
    mobility[2, 2] = 1.0 / mass
    return coulter.Coupled(
        coulter.Pose(position), coulter.Twist([0.2, 0.0, speed]), mobility, coulter.Twist([0.0, 0.0, -9.81])
    )


def test_a_light_body_of_another_program_is_borne(in_folder: Path) -> None:
    mass, speed = 0.05, 0.0
    with coulter.Simulation(DISC, set=STEERED, output="coupled") as simulation:
        position, step = simulation.bodies["disc"].position.copy(), 3 * simulation.time_step
        for _ in range(60):
            now = simulation.step_until(simulation.time + step, {"disc": coupled(mass, position, speed)})["disc"]
            speed += step * (now.force[2] / mass - 9.81)
            position += step * np.array([0.2, 0.0, speed])
            assert speed == pytest.approx(now.linear[2], abs=1e-9)
            assert abs(speed) < 0.3
    assert simulation.result.outcome == "finished"


def test_a_saved_state_goes_on_to_the_same_bytes(in_folder: Path) -> None:
    down = {"disc": coulter.Twist([0.1, 0.0, -0.05], [0.0, 1.0, 0.0])}
    press = {"disc": coulter.Load([0.0, 0.0, -20.0])}
    with coulter.Simulation(DISC, set=STEERED, output="whole") as whole:
        whole.step_until(0.01, down)
        state = whole.save()
        first = whole.step_until(0.03, press)["disc"]
        whole.step_until(0.04, down)
        whole.restore(state)
        assert whole.time == pytest.approx(0.01)
        again = whole.step_until(0.03, press)["disc"]
        np.testing.assert_array_equal(first.force, again.force)
    with pytest.raises(RuntimeError), coulter.Simulation(DISC, set=STEERED, output="parts") as parts:
        parts.step_until(0.01, down)
        raise RuntimeError
    assert parts.result.outcome == "interrupted"
    with coulter.Simulation(DISC, set=STEERED, output="parts", start="resume") as parts:
        assert parts.time == pytest.approx(0.01)
        parts.step_until(0.03, press)
        with pytest.raises(coulter.RequestError, match="not a Coulter checkpoint"):
            parts.restore(b"nothing of the kind")
    for name in ["forces.csv", "energy.csv"]:
        assert (whole.folder / name).read_bytes() == (parts.folder / name).read_bytes(), name


def test_what_cannot_be_done_is_refused(in_folder: Path) -> None:
    with coulter.Simulation(DISC, set=STEERED, output="refused") as simulation:
        simulation.step_until(0.005)
        for time_, commands, why in [
            (0.005, {}, "not after the present time"),
            (9.0, {}, "run.duration"),
            (0.01, {"plough": coulter.Twist()}, 'no body "plough", but disc'),
            (0.01, {"disc": coulter.Twist([0.0, 1.0, 0.0])}, "along y"),
            (0.01, {"disc": coulter.Twist([0.0, 1.0])}, "3 finite numbers"),
            (0.01, {"disc": coulter.Pose([0, 0, 0], [0, 0, 0, 0])}, "no rotation"),
            (0.01, {"disc": "down"}, "no command"),
        ]:
            with pytest.raises(coulter.RequestError, match=why):
                simulation.step_until(time_, commands)  # type: ignore[arg-type]
            assert simulation.time == pytest.approx(0.005)
        with pytest.raises(coulter.RequestError, match="still on"):
            _ = simulation.result
        simulation.step_until(0.01)
    with pytest.raises(coulter.RequestError, match="has ended"):
        simulation.step_until(0.02)
    with pytest.raises(coulter.RequestError, match="start="):
        coulter.Simulation(DISC, set=STEERED, output="refused")
    with pytest.raises(coulter.CaseError, match=r"soil.friction_angle"):
        coulter.Simulation(DISC, set={"soil.friction_angle": "400 deg"}, output="wrong")


def test_a_body_that_is_led_out_of_the_soil_ends_the_run(in_folder: Path) -> None:
    with coulter.Simulation(DISC, set=STEERED, output="out") as simulation:
        with pytest.raises(coulter.BrokenRun, match="left the box"):
            simulation.step_until(0.14, {"disc": coulter.Twist([-4.0, 0.0, 0.0])})
    assert simulation.result.outcome == "broke-down" or "left the box" in str(simulation.result.outcome)


@pytest.mark.skipif(os.name == "nt", reason="signals differ")
def test_ctrl_c_ends_a_step_and_leaves_a_checkpoint(in_folder: Path) -> None:
    longer = {**STEERED, "run.tow_distance": (3, "m"), "grid.cell": "12.5 mm", "domain.x": ["-0.35 m", "4 m"]}
    simulation = coulter.Simulation(DISC, set=longer, output="stopped")

    def interrupt() -> None:
        time.sleep(1.0)
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=interrupt, daemon=True).start()
    with pytest.raises(KeyboardInterrupt):
        while True:
            simulation.step_until(simulation.time + 1.0)
    assert simulation.result.outcome == "interrupted"
    with coulter.Simulation(DISC, set=longer, output="stopped", start="resume") as again:
        assert again.time > 0.0
        again.stop()
