"""The command of the wheel, and studies: the same as the shell's."""

from __future__ import annotations

import signal
import subprocess
import sys
import sysconfig
import warnings
from pathlib import Path

import pytest
from conftest import DISC, SHORT, set_by_shell, shell

import coulter

COMMAND = str(Path(sysconfig.get_path("scripts")) / "coulter")

STUDY = f"""
format = 2
case = "{DISC.as_posix()}"

[factor.phi]
key = "soil.friction_angle"
values = ["32 deg", "36 deg", "40 deg"]

[factor.mu]
key = "body.disc.friction"
values = [0.2, 0.4]
"""


def wheel(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([COMMAND, *arguments], capture_output=True, text=True, encoding="utf-8", check=False)


def test_the_command_is_that_of_the_shell(disc: Path) -> None:
    assert wheel("--version").stdout == f"coulter {coulter.__version__}\n" == shell("--version").stdout
    for arguments, code in [(("forecast", disc.name), 0), (("forecast", "nowhere.toml"), 2), (("fly",), 2), ((), 2)]:
        ours, theirs = wheel(*arguments), shell(*arguments)
        assert (ours.returncode, ours.stdout, ours.stderr) == (code, theirs.stdout, theirs.stderr), arguments


def test_the_command_stops_at_a_signal_with_a_checkpoint(in_folder: Path) -> None:
    arguments = ["run", str(DISC), "-o", "tow", *set_by_shell(), "--set", "run.tow_distance=0.3 m"]
    process = subprocess.Popen([COMMAND, *arguments], stderr=subprocess.PIPE, text=True, encoding="utf-8")
    forces = Path("tow/forces.csv")
    while process.poll() is None and not (forces.is_file() and forces.read_text(encoding="utf-8").count("\n") > 2):
        pass
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 130 and "--resume" in said and "Traceback" not in said


def test_other_commands_are_called(disc: Path) -> None:
    assert '"models"' in coulter.command("forecast", disc, "--json")
    with pytest.raises(coulter.RequestError, match=r"nowhere\.toml"):
        coulter.command("forecast", "nowhere.toml")


def test_a_run_is_compared_with_a_measurement(tow: Path, in_folder: Path) -> None:
    Path("measured.csv").write_text("displacement [mm],drag [N]\n1,4\n3,9\n5,11\n7,11\n", encoding="utf-8")
    document = coulter.compare([coulter.open_result(tow), "measured.csv"], quantities=["drag"])
    assert document == __import__("json").loads(
        shell("compare", str(tow), "measured.csv", "--quantity", "drag", "--json").stdout
    )


def test_a_study_is_that_of_the_shell_and_either_goes_on(in_folder: Path) -> None:
    Path("study.toml").write_text(STUDY, encoding="utf-8")
    assert shell("sweep", "study.toml", "-o", "theirs", cwd=in_folder).returncode == 0
    ended: list[int] = []

    def two(point: int, id: str, state: str, reason: str) -> None:
        ended.append(point)
        if len(ended) == 2:
            raise StopIteration("two are enough")

    with pytest.raises(StopIteration, match="two are enough"):
        coulter.sweep("study.toml", output="ours", workers=1, on_case=two)
    assert len(ended) == 2
    assert shell("sweep", "study.toml", "-o", "ours", cwd=in_folder).returncode == 0
    study = coulter.sweep("study.toml", output="ours", on_case=lambda *case: ended.append(case[0]))
    assert len(ended) == 2, "no case is left"
    assert Path("theirs/table.csv").read_bytes() == Path("ours/table.csv").read_bytes()
    assert study.table.unit("phi") == "deg" and set(study.table["state"]) == {"done"}
    assert len(study.without_results["reason"]) == 0 and study.report.is_file()
    point = coulter.forecast(DISC, set={"soil.friction_angle": "36 deg", "body.disc.friction": 0.2})
    chosen = (study.table["phi"] == 36.0) & (study.table["mu"] == 0.2)
    assert study.table["drag"][chosen].tolist() == [float(point.drag)]


def test_cases_of_a_study_without_results_are_told(in_folder: Path) -> None:
    # Sand cannot dilate by more than its friction angle.
    dilating = STUDY.replace("body.disc.friction", "soil.dilation_angle").replace("[0.2, 0.4]", '["0 deg", "38 deg"]')
    Path("study.toml").write_text(dilating, encoding="utf-8")
    with pytest.warns(coulter.CoulterWarning, match="of 6 cases 2 refused"):
        study = coulter.sweep("study.toml")
    assert len(study.without_results["reason"]) == 2
    with pytest.raises(coulter.RequestError, match="cases.jsonl"):
        coulter.Study("nowhere")


def test_a_study_of_runs(in_folder: Path) -> None:
    typed = "\n".join(f'"{key}" = {value}' for key, value in typed_keys().items())
    Path("study.toml").write_text(
        STUDY.split("[factor.mu]")[0].replace('"40 deg"', '"37 deg"').replace('case =', 'models = ["solver"]\ncase =')
        + f"\n[set]\n{typed}\n",
        encoding="utf-8",
    )
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        study = coulter.sweep("study.toml", workers=2)
        there = coulter.sweep("study.toml", output="there", workers=2, device="stand-in")
    assert (study.folder / "table.csv").read_bytes() == (there.folder / "table.csv").read_bytes()
    run = study.run(str(study.table["id"][0]))
    assert run.steady()["drag"].value == study.table["drag"][0]


def typed_keys() -> dict[str, str]:
    quoted = {key: f'"{value}"' for key, value in SHORT.items() if isinstance(value, str)}
    return {
        **quoted,
        "body.disc.forward": '{ speed = "0.2 m/s", ramp = "0.02 s" }',
        "body.disc.heave": '{ load = "0 N", ramp = "0.02 s" }',
        "run.tow_distance": '"8 mm"',
    }


def test_an_interrupted_forecast_and_study_end(in_folder: Path) -> None:
    code = (
        "import coulter, numpy, signal, sys\n"
        # A shell that starts the tests in the background has it ignored.
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "print('ready', flush=True)\n"
        "try:\n"
        "    coulter.forecast(sys.argv[1], vary={'soil.friction_angle': (numpy.linspace(30, 40, 10**6), 'deg')})\n"
        "except KeyboardInterrupt:\n"
        "    print('interrupted')\n"
    )
    process = subprocess.Popen([sys.executable, "-c", code, str(DISC)], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None and process.stdout.readline() == "ready\n"
    __import__("time").sleep(1.0)
    process.send_signal(signal.SIGINT)
    said, _ = process.communicate(timeout=60)
    assert said == "interrupted\n"
