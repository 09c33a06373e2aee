"""The compiled part: requests come as JSON, columns as bytes. Not for users."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import TypedDict

__version__: str
RESULTS_FORMAT: int

class Failure(Exception):
    """``args``: kind (case, request, physics, stopped, internal), text, problems of a case as JSON."""

class _Forecast(TypedDict):
    rows: list[str]
    quantities: dict[str, tuple[str, bytes]]
    models: list[str]
    reasons: list[str]

def check(call: str) -> tuple[str, str]: ...
def forecast(call: str, columns: list[bytes]) -> _Forecast: ...
def main(program: str | os.PathLike[str], arguments: list[str]) -> int: ...
def run(
    call: str,
    on_sample: Callable[[float, dict[str, list[float]]], bool] | None,
    warn: Callable[[str], object],
) -> tuple[Path, str, str]: ...
def sample_columns() -> list[tuple[str, str, str]]: ...
def sweep(call: str, on_case: Callable[[int, str, str, str], object] | None) -> tuple[Path, str]: ...
