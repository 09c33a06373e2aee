"""What the tests share: short cases, and the shell's command."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]
CASES = ROOT / "cases"
DISC = CASES / "light_disc.toml"

# The towed disc on a coarse grid, in the soil from the start, for a few hundred steps: a second or two.
SHORT = {
    "grid.cell": "25 mm",
    "body.disc.sinkage": "10 mm",
    "body.disc.forward": {"speed": "0.2 m/s", "ramp": "0.02 s"},
    "body.disc.heave": {"load": "0 N", "ramp": "0.02 s"},
    "run.tow_distance": (8, "mm"),
    "output.history_interval": "2.5 ms",
    "output.field_interval": "20 ms",
}


def program() -> list[str]:
    """The shell's command: the program that COULTER_PROGRAM names, or else that of the package."""
    named = os.environ.get("COULTER_PROGRAM")
    return [named] if named else [sys.executable, "-m", "coulter"]


def shell(*arguments: str, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    """What the shell's command does."""
    return subprocess.run(
        [*program(), *arguments], capture_output=True, text=True, encoding="utf-8", cwd=cwd, check=False
    )


def set_by_shell() -> list[str]:
    """The options of the shell for SHORT."""
    options = {
        **SHORT,
        "body.disc.forward": '{ speed = "0.2 m/s", ramp = "0.02 s" }',
        "body.disc.heave": '{ load = "0 N", ramp = "0.02 s" }',
        "run.tow_distance": "8 mm",
    }
    return [word for key, value in options.items() for word in ("--set", f"{key}={value}")]


@pytest.fixture(scope="session")
def tow(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The results folder of the short case, run by the shell."""
    folder = tmp_path_factory.mktemp("shell") / "tow"
    done = shell("run", str(DISC), "-o", str(folder), "--threads", "1", *set_by_shell())
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture
def in_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder to work in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def disc(in_folder: Path) -> Path:
    """A copy of the case file."""
    return Path(shutil.copy(DISC, in_folder))
