"""Runs: the same bytes as the shell's, samples, stops, faults."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import DISC, SHORT, shell

import coulter


def same_tables(one: Path, other: Path) -> None:
    names = sorted(path.name for path in one.glob("*.csv"))
    assert len(names) >= 6
    for name in names:
        assert (one / name).read_bytes() == (other / name).read_bytes(), name


def test_a_run_has_the_bytes_of_the_shells(tow: Path, in_folder: Path) -> None:
    samples: list[coulter.Sample] = []
    result = coulter.run(DISC, set=SHORT, output="ours", threads=1, on_sample=samples.append)
    same_tables(tow, result.folder)
    fields = sorted(path.name for path in (tow / "fields").iterdir())
    assert fields
    for name in fields:
        assert (tow / "fields" / name).read_bytes() == (result.folder / "fields" / name).read_bytes(), name
    theirs = coulter.open_result(tow)
    assert result.summary["bodies"] == theirs.summary["bodies"]
    assert (result.outcome, result.grade) == ("finished", theirs.grade)
    assert (result.folder / "report.html").is_file()
    # The callback saw every line but that of the start, in order; the file has nine digits.
    forces = result.forces
    for seen, name in [
        ([sample.time for sample in samples], "time"),
        ([sample["drag"] for sample in samples], "drag F_H"),
        ([sample.bodies["disc"]["sinkage z"] for sample in samples], "sinkage"),
    ]:
        np.testing.assert_allclose(seen, forces[name][1:], rtol=1e-8)
    assert set(samples[0]) == set(forces)


def test_a_device_changes_no_bit(tow: Path, in_folder: Path) -> None:
    result = coulter.run(DISC, set=SHORT, output="there", threads=1, device="stand-in")
    same_tables(tow, result.folder)
    assert "in place of a graphics card" in (result.folder / "run.log").read_text(encoding="utf-8")


def test_a_run_that_a_callback_stops_goes_on_to_the_same_end(tow: Path, in_folder: Path) -> None:
    seen: list[float] = []

    def until_the_third(sample: coulter.Sample) -> bool:
        seen.append(sample.time)
        return len(seen) < 3

    result = coulter.run(DISC, set=SHORT, output="tow", on_sample=until_the_third)
    assert len(seen) == 3 and result.outcome == "interrupted"
    assert result.forces["time"][-1] == pytest.approx(seen[-1], rel=1e-8)
    with pytest.raises(coulter.RequestError, match="start="):
        coulter.run(DISC, set=SHORT, output="tow")
    resumed = coulter.run(DISC, set=SHORT, output="tow", start="resume")
    assert resumed.outcome == "finished"
    same_tables(tow, resumed.folder)


def test_an_exception_of_a_callback_stops_the_run_with_a_checkpoint(in_folder: Path) -> None:
    def fails(sample: coulter.Sample) -> None:
        raise ZeroDivisionError("in the callback")

    with pytest.raises(ZeroDivisionError, match="in the callback"):
        coulter.run(DISC, set=SHORT, output="tow", on_sample=fails)
    assert coulter.Result("tow").outcome == "interrupted"
    assert Path("tow/checkpoints/last.checkpoint").is_file()


INTERRUPTED = """
import sys
import coulter
sys.path.insert(0, sys.argv[1])
from conftest import DISC, SHORT
try:
    coulter.run(DISC, set=SHORT | {"run.tow_distance": "0.3 m"}, output="tow",
                on_sample=lambda sample: print("sample", flush=True))
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


def test_ctrl_c_stops_a_run_with_a_checkpoint(in_folder: Path) -> None:
    tests = str(Path(__file__).parent)
    process = subprocess.Popen([sys.executable, "-c", INTERRUPTED, tests], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None and process.stdout.readline() == "sample\n"
    process.send_signal(signal.SIGINT)
    said, _ = process.communicate(timeout=120)
    assert said.splitlines()[-1] == "interrupted" and process.returncode == 0
    assert coulter.Result("tow").outcome == "interrupted"


def test_the_interpreter_goes_on_during_a_run_and_runs_go_side_by_side(in_folder: Path) -> None:
    ended: list[coulter.Result] = []

    def work(name: str) -> None:
        ended.append(coulter.run(DISC, set=SHORT, output=name, threads=1))

    threads = [threading.Thread(target=work, args=(name,)) for name in ("one", "two")]
    for thread in threads:
        thread.start()
    turns = 0
    while any(thread.is_alive() for thread in threads):
        time.sleep(0.001)
        turns += 1
    assert turns > 20, "the interpreter stood still"
    same_tables(ended[0].folder, ended[1].folder)


def test_a_case_from_dicts_is_the_case_of_the_file(in_folder: Path) -> None:
    try:
        import tomllib
    except ImportError:
        pytest.skip("tomllib came with Python 3.11")
    keys = tomllib.loads(DISC.read_text(encoding="utf-8"))
    keys["soil"]["friction_angle"] = (np.float64(36.0), "deg")
    ours = coulter.check(keys).document["resolved"]
    theirs = coulter.check(DISC, set={"soil.friction_angle": "36 deg"}).document["resolved"]
    assert {**ours, "name": ""} == {**theirs, "name": ""}


def test_a_wrong_case_says_what_the_shell_says(disc: Path) -> None:
    disc.write_text(disc.read_text(encoding="utf-8").replace("friction_angle", "friktion_angle"), encoding="utf-8")
    with pytest.raises(coulter.CaseError) as caught:
        coulter.run(disc.name)
    said = shell("run", disc.name)
    assert said.returncode == 2
    assert str(caught.value) == said.stderr.rstrip("\n")
    problem = next(problem for problem in caught.value.problems if "friktion_angle" in problem.message)
    assert problem.line > 1 and "friction_angle" in problem.cure
    for call in (coulter.check, coulter.forecast):
        with pytest.raises(coulter.CaseError, match="friktion"):
            call(disc.name)
    with pytest.raises(coulter.CaseError, match="cannot be read"):
        coulter.run("nowhere.toml")


def test_a_broken_run_is_no_silent_success(in_folder: Path) -> None:
    with pytest.raises(coulter.BrokenRun, match=r"left the box|between two remaps") as caught:
        coulter.run(DISC, set={"soil.young_modulus": "4 kPa", "grid.cell": "25 mm"}, output="broken")
    assert caught.value.folder == Path("broken")
    assert caught.value.result.grade == "broken" and caught.value.result.outcome == "broke-down"


def test_wrong_arguments_are_refused(in_folder: Path) -> None:
    with pytest.raises(ValueError, match="on_sample"):
        coulter.run(DISC, meshes=3, on_sample=print)
    with pytest.raises(coulter.RequestError, match='it must be "new", "replace"'):
        coulter.run(DISC, start="again")  # type: ignore[arg-type]
    with pytest.raises(coulter.RequestError, match="no value of a case"):
        coulter.run(DISC, set={"soil.friction_angle": object()})
    with pytest.raises(coulter.RequestError, match=r"meshes = 1: it must be from 2 to"):
        coulter.run(DISC, meshes=1)
    with pytest.raises(coulter.RequestError, match=r"threads = 9999: it must be from 0 to"):
        coulter.run(DISC, threads=9999)
    with pytest.raises(coulter.RequestError, match="threads = -1"):
        coulter.run(DISC, threads=-1)
    for start in (coulter.run, coulter.Simulation, coulter.sweep):
        with pytest.raises(coulter.RequestError, match="device: `card` is no device: cpu, gpu"):
            start(DISC, device="card")
        # No machine has so many cards.
        with pytest.raises(coulter.RequestError, match="^device: "):
            start(DISC, device="gpu:4000000000")
    Path("file").write_text("", encoding="utf-8")
    with pytest.raises(coulter.RequestError, match="is a file"):
        coulter.run(DISC, output="file")
    assert not Path("results").exists()


def test_a_check_says_what_the_shell_says(in_folder: Path) -> None:
    import json

    check = coulter.check(DISC, set={"grid.cell": "25 mm"})
    theirs = json.loads(shell("check", str(DISC), "--set", "grid.cell=25 mm", "--json").stdout)
    assert check.document["resolved"] == theirs["resolved"] and check.document["cost"] == theirs["cost"]
    assert check.memory_bytes > 1e6 and check.name == "light_disc" and "grid" in str(check)
