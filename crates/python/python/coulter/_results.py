"""A folder of results, of a run that has ended, was stopped, or is on."""

from __future__ import annotations

import json
import os
import re
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from ._errors import RequestError
from ._fields import BodyField, SoilField, SurfaceField, frames
from ._inside import inside
from ._native import RESULTS_FORMAT
from ._table import Table

# Units at the end of a name of summary.json: "drag_N", "axle_torque_Nm".
_ENDINGS = {
    "N_m": "N/m",
    "Nm": "N m",
    "N": "N",
    "m": "m",
    "s": "s",
    "rad": "rad",
    "W": "W",
}


class Quantity(NamedTuple):
    """A number with its unit.

    Attributes:
        value: the number, in ``unit``; not-a-number where there is none.
        unit: the unit; ``-`` for a number without one.
        interval: its lower and upper end, where it has an interval.
    """

    value: float
    unit: str
    interval: tuple[float, float] | None = None


class Result:
    """The results of a run in a folder.

    Files are read when they are asked for, so that the folder of a run that is on can be read, too.

    Attributes:
        folder: where they are.
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        """Reads what a folder holds.

        Raises:
            RequestError: where it holds no run, or one of another version of the format of results.
        """
        self.folder = Path(folder)
        self._record: dict[str, Any] = self._json("run.json")
        found = self._record.get("format")
        if found != RESULTS_FORMAT:
            newer = isinstance(found, int) and found > RESULTS_FORMAT
            cure = "install a newer version of coulter" if newer else "read it with the version that wrote it, or run its case again"
            raise RequestError(f"{self.folder} has results of format {found}; this version of coulter reads {RESULTS_FORMAT}; {cure}")

    def __repr__(self) -> str:
        return f"<Result {self.folder}: {self.outcome}, {self.grade or 'not graded'}>"

    def _json(self, name: str) -> dict[str, Any]:
        path = inside(self.folder, name)
        try:
            document = json.loads(path.read_text(encoding="utf-8"))
        except OSError as error:
            raise RequestError(f"{self.folder} holds no such result: {name} cannot be read: {error.strerror}") from error
        except ValueError as error:
            raise RequestError(f"{path} is not what a run writes: {error}") from error
        if not isinstance(document, dict):
            raise RequestError(f"{path} is not what a run writes: it is no object")
        return document

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The key numbers, ``summary.json``: SI units, the unit at the end of each name.

        Raises:
            RequestError: where the run has not come to writing it.
        """
        return self._json("summary.json")

    @property
    def grade(self) -> str:
        """``good``, ``doubtful`` or ``broken``; empty of a run without a summary."""
        if not (self.folder / "summary.json").is_file():
            return ""
        return str(self.summary["trust"]["verdict"])

    @property
    def checks(self) -> list[dict[str, Any]]:
        """The checks behind the grade: name, body, value, unit, limits, verdict, advice."""
        return list(self.summary["trust"]["checks"])

    @property
    def outcome(self) -> str:
        """``finished``, ``interrupted`` (it can be resumed), ``broke-down``, or ``running`` (or killed)."""
        outcome = self._record.get("statistics", {}).get("outcome", "running")
        return outcome if isinstance(outcome, str) else str(next(iter(outcome)))

    @property
    def bodies(self) -> list[str]:
        """Names of the bodies."""
        return [str(body["name"]) for body in self._record["bodies"]]

    @property
    def tables(self) -> list[str]:
        """Names of the tables that there are, such as ``forces`` or ``energy``."""
        return sorted(path.stem for path in self.folder.glob("*.csv"))

    def table(self, name: str, body: str | None = None) -> Table:
        """A CSV file of the folder by its name.

        Args:
            name: ``forces``, ``energy``, ``boundaries``, ``rut``, ``filtered``, ``rim``, ``height_map``, ``joint_NAME``, …
            body: the body that it is about, of a file that there is for each; the first by default.

        Raises:
            RequestError: where there is no such table or body.
        """
        stem = name
        if body is not None and body not in self.bodies:
            raise RequestError(f"there is no body {body!r}; there are {', '.join(self.bodies)}")
        if len(self.bodies) > 1 and not (self.folder / f"{name}.csv").is_file():
            stem = f"{name}_{_file_safe(body or self.bodies[0])}"
        if stem not in self.tables:
            raise RequestError(f"{self.folder} has no table {name!r}; it has {', '.join(self.tables)}")
        return Table.read(inside(self.folder, f"{stem}.csv"))

    @property
    def forces(self) -> Table:
        """History of the first body; :meth:`table` has those of the others."""
        return self.table("forces")

    @property
    def energy(self) -> Table:
        """History of the energy balance."""
        return self.table("energy")

    def steady(self, body: str | None = None) -> dict[str, Quantity]:
        """Means over the steady window, by name: ``drag``, ``vertical``, ``lateral``, ``sinkage``, ``slip``, ``axle_torque``, …

        Args:
            body: whose; the first by default.

        Raises:
            RequestError: where there is no such body, or the run has no summary.
        """
        body = body or next(iter(self.bodies), "")
        if body not in self.summary["bodies"]:
            raise RequestError(f"there is no body {body!r} in the summary; there are {', '.join(self.summary['bodies'])}")
        means = self.summary["bodies"][body]["steady"]
        found = {}
        for key, value in means.items():
            if key.endswith("_interval") or key.startswith(("from_", "to_", "is_")) or isinstance(value, (dict, list)):
                continue
            name, unit = _split(key)
            found[name] = Quantity(_number(value), unit, _interval(means.get(f"{key}_interval")))
        return found

    @property
    def times(self) -> npt.NDArray[np.float64]:
        """Times of the fields [s]."""
        return np.array([time for time, _, _ in frames(self.folder, "soil.pvd")])

    def soil(self, at: int = -1) -> SoilField:
        """The soil at the time ``times[at]``; the last by default.

        Raises:
            RequestError: where there is none.
        """
        return SoilField(self._frame("soil.pvd", at, 0))

    def surface(self, at: int = -1) -> SurfaceField:
        """The free surface at the time ``times[at]``; the last by default.

        Raises:
            RequestError: where there is none.
        """
        return SurfaceField(self._frame("surface.pvd", at, 0))

    def body(self, name: str | None = None, at: int = -1) -> BodyField:
        """The surface of a body at the time ``times[at]``; the first body and the last time by default.

        Raises:
            RequestError: where there is none.
        """
        if name is None:
            parts = [part for _, part, _ in frames(self.folder, "body.pvd")]
            return BodyField(self._frame("body.pvd", at, min(parts, default=0)))
        if name not in self.bodies:
            raise RequestError(f"there is no body {name!r}; there are {', '.join(self.bodies)}")
        return BodyField(self._frame("body.pvd", at, self.bodies.index(name)))

    def _frame(self, series: str, at: int, part: int) -> Path:
        files = [path for _, number, path in frames(self.folder, series) if number == part]
        try:
            return files[at]
        except IndexError:
            raise RequestError(f"{self.folder / series} lists {len(files)} times; there is no number {at}") from None


def open_result(folder: str | os.PathLike[str]) -> Result:
    """The results in a folder that ``coulter run`` or :func:`coulter.run` has written.

    Raises:
        RequestError: where it holds no run.
    """
    return Result(folder)


def _file_safe(name: str) -> str:
    return re.sub(r"[^\w-]", "_", name)


def _split(key: str) -> tuple[str, str]:
    for ending, unit in _ENDINGS.items():
        if key.endswith(f"_{ending}"):
            return key[: -len(ending) - 1], unit
    return key, "-"


def _number(value: float | None) -> float:
    return float("nan") if value is None else float(value)


def _interval(ends: Any) -> tuple[float, float] | None:
    if isinstance(ends, dict):
        ends = [ends.get("low"), ends.get("high")]
    return (float(ends[0]), float(ends[1])) if isinstance(ends, list) and None not in ends else None
