"""Packages that are not required: with what to do where one is missing."""

from __future__ import annotations

import importlib
from typing import Any


def needed(name: str, what: str) -> Any:
    """The module of an optional package.

    Args:
        name: name of the package.
        what: what needs it, such as ``Table.to_pandas``.

    Raises:
        ImportError: where it is not installed, with the command that installs it.
    """
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(
            f'{what} needs {name}, which cannot be imported ({error}): pip install "coulter[{name}]"'
        ) from error
