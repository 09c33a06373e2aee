"""Studies: many cases that vary."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable
from functools import cached_property
from pathlib import Path

from . import _native
from ._errors import CoulterWarning, RequestError, translated
from ._inside import inside
from ._results import Result
from ._table import Table


class Study:
    """A study in its folder, as ``coulter sweep`` or :func:`coulter.sweep` has written it.

    Attributes:
        folder: where it is.
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        """Reads what a folder holds.

        Raises:
            RequestError: where it holds no study.
        """
        self.folder = Path(folder)
        if not (self.folder / "cases.jsonl").is_file():
            raise RequestError(f"{self.folder} holds no study: there is no cases.jsonl in it")

    def __repr__(self) -> str:
        return f"<Study {self.folder}>"

    @cached_property
    def table(self) -> Table:
        """A line for every case and model: factors and responses with their units, state, grade, reason.

        Raises:
            RequestError: where the study has not been collected.
        """
        return Table.read(inside(self.folder, "table.csv"))

    @cached_property
    def without_results(self) -> Table:
        """The cases without results, and why.

        Raises:
            RequestError: where the study has not been collected.
        """
        return Table.read(inside(self.folder, "without_results.csv"))

    @property
    def report(self) -> Path:
        """The page of the study."""
        return self.folder / "report.html"

    def run(self, id: str) -> Result:
        """The results of a run of the solver by its id, which is in the table.

        Raises:
            RequestError: where there is no such run.
        """
        return Result(inside(self.folder, f"runs/{id}"))


def sweep(
    study: str | os.PathLike[str],
    *,
    quick: bool = False,
    output: str | os.PathLike[str] | None = None,
    workers: int | None = None,
    threads: int | None = None,
    device: str = "cpu",
    on_case: Callable[[int, str, str, str], object] | None = None,
) -> Study:
    """Runs what is left of a study and collects it, as ``coulter sweep`` does, in the same folder: either goes on with what the other left.

    The work is done without the interpreter's lock. Ctrl-C stops it and raises ``KeyboardInterrupt``; what has ended is kept, and the
    same call goes on from there. Cases without results raise no exception but give a :class:`CoulterWarning`.

    Args:
        study: the study file.
        quick: the quick version that the study file describes: fewer levels, cheaper runs.
        output: folder of the study; by default ``results/NAME``, of the quick version ``results/NAME_quick``.
        workers: cases that run at the same time; by default those of the study, or as many as cores and memory allow.
        threads: threads of each run of the solver; by default those of the study.
        device: what strains the soil, as of :func:`run`; cases that run at the same time share a card.
        on_case: called in this thread with point, id, state (``done``, ``broken``, ``refused``, ``failed``) and reason of every case
            that ends. An exception stops the study and is raised.

    Raises:
        CaseError: the study file or its case is wrong; with file, line and cure.
        RequestError: no case is valid, or the folder holds something else.
    """
    call = {
        "study": os.fspath(study),
        "quick": quick,
        "output": None if output is None else os.fspath(output),
        "workers": workers,
        "threads": threads,
        "device": device,
    }
    with translated():
        folder, text = _native.sweep(json.dumps(call), on_case)
    counts: dict[str, int] = json.loads(text)
    without = {state: counts[state] for state in ("broken", "refused", "failed", "missing") if counts[state]}
    if without:
        listed = ", ".join(f"{count} {state}" for state, count in without.items())
        warnings.warn(
            f"of {counts['cases']} cases {listed}; without_results says why", CoulterWarning, stacklevel=2
        )
    return Study(folder)
