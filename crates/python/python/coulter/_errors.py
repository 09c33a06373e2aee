"""What can go wrong, as exceptions: the same reasons, in the same words, as the command gives."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from . import _native


class CoulterError(Exception):
    """Anything that went wrong."""


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong with a case.

    Attributes:
        path: its key, such as ``soil.friction_angle``; empty where it concerns the whole case.
        message: what is wrong.
        cure: what to write instead.
        line: line of the case file, counted from 1; 0 where it is in no text.
        column: column in characters, counted from 1; 0 where it is in no text.
    """

    path: str
    message: str
    cure: str
    line: int
    column: int


class CaseError(CoulterError, ValueError):
    """The case is wrong, and nothing was run. Its text is that of the command: file, line, what was expected.

    Attributes:
        problems: what is wrong, in the order of the file.
    """

    def __init__(self, text: str, problems: list[Problem] | None = None) -> None:
        super().__init__(text)
        self.problems = problems or []


class RequestError(CoulterError, ValueError):
    """The request was wrong in another way: a folder that holds another run, a file that cannot be written, an unknown option."""


class CoulterWarning(UserWarning):
    """A doubt about a case, or cases of a study without results."""


# How the options of the command are called here.
_OPTIONS = {
    "use --force to start again": 'give start="replace" to start again',
    "--force": 'start="replace"',
    "--meshes 3 --resume": 'meshes=3, start="resume"',
    "--confidence --resume": 'confidence=True, start="resume"',
    "--resume": 'start="resume"',
    "-o DIR": "output=DIR",
    "--device": "device",
}


def in_our_words(text: str) -> str:
    """A text of the command, with its options as they are called here."""
    for option, ours in _OPTIONS.items():
        text = text.replace(option, ours)
    return text


@contextmanager
def translated() -> Iterator[None]:
    """Raises what the compiled part reports as the exception for it.

    Raises:
        CaseError, RequestError, KeyboardInterrupt, CoulterError: by the kind of the failure.
    """
    try:
        yield
    except _native.Failure as failure:
        kind, text, problems = failure.args
    else:
        return
    text = in_our_words(text.rstrip("\n"))
    match kind:
        case "case":
            raise CaseError(text, [Problem(**problem) for problem in json.loads(problems)]) from None
        case "request":
            raise RequestError(text) from None
        case "stopped":
            raise KeyboardInterrupt(text) from None
        case _:
            raise CoulterError(text) from None
