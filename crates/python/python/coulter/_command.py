"""The other commands of the shell, from Python."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from typing import Any

from ._broken import BrokenRun
from ._errors import CoulterError, RequestError
from ._results import Result


def command(*arguments: str | os.PathLike[str]) -> str:
    """Calls a command in a process of its own: ``command("element", "triaxial", "case.toml", "--json")``.

    Args:
        arguments: those of the shell's command, such as of ``calibrate``, ``element``, ``pressure``, ``report`` or ``verify``.

    Returns:
        What it prints on standard output; ``--json`` makes this one document.

    Raises:
        RequestError: the request was wrong (exit code 2), with the text of the command.
        BrokenRun: a result must not be used (exit code 1), with the text of the command.
        CoulterError: it ended in another way.
    """
    words = [os.fspath(argument) for argument in arguments]
    done = subprocess.run(
        [sys.executable, "-m", "coulter", *words], capture_output=True, text=True, encoding="utf-8", check=False
    )
    match done.returncode:
        case 0:
            return done.stdout
        case 1:
            raise BrokenRun(done.stderr.strip())
        case 2:
            raise RequestError(done.stderr.strip())
        case code:
            raise CoulterError(f"coulter {' '.join(words)} ended with {code}: {done.stderr.strip()}")


def compare(
    items: Sequence[str | os.PathLike[str] | Result],
    *,
    reference: str | os.PathLike[str] | None = None,
    against: str | None = None,
    quantities: Sequence[str] = (),
    columns: Mapping[str, str] | None = None,
    window: str | None = None,
    align: bool = False,
    output: str | os.PathLike[str] | None = None,
) -> dict[str, Any]:
    """Puts runs, closed forms and measurements side by side, as ``coulter compare`` does.

    Args:
        items: results (or their folders), forecasts, case files (by their closed form), measured CSV files.
        reference: the item that the others are compared with; the first measured one by default.
        against: along what: ``u``, ``z``, ``t`` or ``slip``.
        quantities: what is compared, such as ``["drag", "vertical"]``.
        columns: what columns of measured files are, where their names do not say it: ``{"qc [MPa]": "pressure", "note": "-"}``.
        window: the part of the abscissa that counts, such as ``'"5 mm".."25 mm"'``.
        align: move the zero of the abscissa of each curve to where it fits the reference best.
        output: where to write page, table and document; an earlier comparison there is replaced.

    Returns:
        The document: items, and for each quantity differences, peaks and steady means.

    Raises:
        RequestError: an item cannot be read, or nothing can be compared; with the text of the command.
    """
    words: list[str | os.PathLike[str]] = [item.folder if isinstance(item, Result) else item for item in items]
    for option, value in (("--reference", reference), ("--against", against), ("--window", window)):
        if value is not None:
            words += [option, value]
    if quantities:
        words += ["--quantity", ",".join(quantities)]
    for column, meaning in (columns or {}).items():
        words += ["--column", f"{column}={meaning}"]
    if align:
        words.append("--align")
    if output is not None:
        words += ["--output", output, "--force"]
    document: dict[str, Any] = json.loads(command("compare", *words, "--json"))
    return document
