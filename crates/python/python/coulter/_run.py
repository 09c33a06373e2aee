"""A run from case to results, and the case as it is understood."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any, Literal

import numpy as np

from . import _native
from ._broken import BrokenRun
from ._case import CaseLike, Keys, assignments, source_of
from ._errors import CoulterWarning, in_our_words, translated
from ._results import Result
from ._table import Table

# What to do with a folder that holds a run: refuse, replace it, continue from its checkpoint, or, for schedulers, start, continue or
# leave a finished run as it is.
Start = Literal["new", "replace", "resume", "auto-resume"]


@dataclass(frozen=True)
class Sample(Mapping[str, float]):
    """A sample of a run that is on: a line of ``forces.csv`` of every body, in SI units.

    ``sample["drag"]`` is a number of the first body; names are those of the columns, in full or in short. Forces are averages over the
    interval that ends at ``time``. Not-a-number stands where a number is not defined.

    Attributes:
        time: time since the start [s].
        bodies: the numbers of every body, by its name.
    """

    time: float
    bodies: dict[str, dict[str, float]] = field(repr=False)

    @property
    def first(self) -> dict[str, float]:
        """The numbers of the first body."""
        return next(iter(self.bodies.values()))

    def __getitem__(self, name: str) -> float:
        return self.first[_columns().name(name)]

    def __iter__(self) -> Iterator[str]:
        return iter(self.first)

    def __len__(self) -> int:
        return len(self.first)


@cache
def _columns() -> Table:
    """The columns of a sample, without lines."""
    columns = _native.sample_columns()
    return Table({name: np.empty(0) for name, _, _ in columns}, {name: unit for name, unit, _ in columns})


class _Following:
    """Hands samples to a callback."""

    def __init__(self, callback: Callable[[Sample], object]) -> None:
        self._callback = callback
        self._names = [name for name, _, _ in _native.sample_columns()]

    def __call__(self, time: float, bodies: dict[str, list[float]]) -> bool:
        """Whether the run is to go on: unless the callback returns ``False``, be it numpy's."""
        named = {body: dict(zip(self._names, values, strict=True)) for body, values in bodies.items()}
        returned = self._callback(Sample(time, named))
        return not isinstance(returned, (bool, np.bool_)) or bool(returned)


def run(
    case: CaseLike,
    *,
    set: Keys | None = None,
    output: str | os.PathLike[str] | None = None,
    start: Start = "new",
    threads: int | None = None,
    device: str = "cpu",
    meshes: int | None = None,
    confidence: bool = False,
    accuracy: str | None = None,
    budget: str | None = None,
    without: tuple[str, ...] = (),
    on_sample: Callable[[Sample], object] | None = None,
    progress: bool = False,
) -> Result:
    """Runs a case, as ``coulter run`` does, and writes the same folder of results.

    The solver runs on threads of its own without the interpreter's lock. Ctrl-C stops it at its next step with a checkpoint, from which
    ``start="resume"`` goes on, and raises ``KeyboardInterrupt``.

    Args:
        case: the path of a case file, or its keys as nested dicts; files that these name lie in the current folder.
        set: keys to set, such as ``{"soil.friction_angle": "35 deg"}`` or ``{"soil.friction_angle": (35, "deg")}``.
        output: results folder; ``results/NAME`` by default.
        start: ``new`` refuses a folder that holds a run; ``replace`` starts again; ``resume`` continues from the last checkpoint;
            ``auto-resume`` starts, continues, or leaves a finished run as it is.
        threads: threads of the solver, 0 for as many as ``coulter run`` has by default; by default those of the case. They change no bit of the results.
        device: what strains the soil: ``cpu``; ``gpu``, a graphics card of NVIDIA (``gpu:1`` for the second); ``stand-in``, the kernels
            of the card on the processor, for comparison. It changes no bit of the results.
        meshes: run the case on so many meshes, to get intervals.
        confidence: run variations of the case as well, to get one 90 % interval for each force and sinkage.
        accuracy: choose the cells, so that the 90 % intervals become as narrow as wanted: ``"5 %"``, or ``"drag 5 %, sinkage 8 %"``.
            The effects of the domain and of the speed are examined on coarse cells.
        budget: how long the variations, or all runs with ``accuracy``, may take together: ``"20 min"``, or ``"4x"`` the run itself.
        without: what the intervals leave out: ``"domain"``, ``"speed"``, ``"mesh"``, ``"precision"``.
        on_sample: called in this thread with every :class:`Sample` of the case's run, in order, while the solver waits; not with
            ``meshes``, ``confidence`` or ``accuracy``. Returning ``False`` stops the run at this sample, and an exception does so and is raised; both
            leave a checkpoint.
        progress: show a bar on standard error.

    Returns:
        The results; of a run that ``on_sample`` stopped those so far, with ``outcome == "interrupted"``.

    Raises:
        CaseError: the case is wrong; with file, line and cure.
        RequestError: the request is wrong: the folder holds another run, a file cannot be written, there is no such device; or the
            device was lost.
        BrokenRun: the physics failed, or the result is graded broken; its ``result`` shows what was written.
    """
    if on_sample is not None and (meshes is not None or confidence or accuracy is not None):
        raise ValueError("on_sample follows one run: it does not go with meshes, confidence or accuracy")
    if accuracy is not None and (meshes is not None or confidence):
        raise ValueError("accuracy chooses its own meshes: it does not go with meshes or confidence")
    if (budget is not None or without) and not confidence and accuracy is None:
        raise ValueError("budget and without belong to confidence=True or accuracy")
    call = {
        "source": source_of(case),
        "set": assignments(set),
        "output": None if output is None else os.fspath(output),
        "start": start,
        "threads": threads,
        "device": device,
        "meshes": meshes,
        "confidence": confidence,
        "accuracy": accuracy,
        "budget": budget,
        "without": list(without),
        "quiet": not progress,
    }
    return _result(json.dumps(call), None if on_sample is None else _Following(on_sample))


def _result(call: str, following: _Following | None) -> Result:
    with translated():
        folder, end, why = _native.run(call, following, _warn)
    if end == "broken":
        raise BrokenRun(in_our_words(why), folder)
    return Result(folder)


def _warn(text: str) -> None:
    # Whoever has called `run`, beyond `_result` and `run` itself; the compiled part has no frame.
    warnings.warn(text, CoulterWarning, stacklevel=4)


@dataclass(frozen=True)
class Check:
    """A case as it is understood; as text what ``coulter check`` prints of it, without the time that the run will take.

    Attributes:
        document: case in SI units (``resolved``), ``cost``, ``groups`` and ``warnings``, as of ``coulter check --json``.
    """

    document: dict[str, Any] = field(repr=False)
    _text: str = field(repr=False)

    @property
    def name(self) -> str:
        """Name of the case."""
        return str(self.document["case"])

    @property
    def memory_bytes(self) -> float:
        """Memory that the run will need [bytes]."""
        return float(self.document["cost"]["memory_bytes"])

    @property
    def warnings(self) -> list[str]:
        """Doubts about the case."""
        return list(self.document["warnings"])

    def __str__(self) -> str:
        return self._text


def check(case: CaseLike, *, set: Keys | None = None) -> Check:
    """A case as it is understood, what it will cost, and doubts about it; runs nothing.

    Args:
        case: the path of a case file, or its keys as nested dicts.
        set: keys to set, as of :func:`run`.

    Raises:
        CaseError: the case is wrong; with file, line and cure.
    """
    with translated():
        text, document = _native.check(json.dumps({"source": source_of(case), "set": assignments(set)}))
    return Check(json.loads(document), text)
