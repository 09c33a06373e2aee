"""A case as it is given: a path or nested dicts, and keys that are set, as the compiled part takes them."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

from ._errors import RequestError

# The path of a case file, or its keys as nested dicts: {"soil": {"friction_angle": "35 deg"}, ...}.
CaseLike: TypeAlias = str | os.PathLike[str] | Mapping[str, Any]

# The value of a key: text as in the case file ("35 deg"), a number without a unit, (35, "deg"), a truth value, a list, a dict.
KeyValue: TypeAlias = Any

# Keys by their dotted names.
Keys: TypeAlias = Mapping[str, KeyValue]


def source_of(case: CaseLike) -> dict[str, Any]:
    """The case for the compiled part."""
    if isinstance(case, Mapping):
        return {"keys": plain(case)}
    return {"path": os.fspath(case)}


def assignments(keys: Keys | None) -> list[str]:
    """The keys that are set as the shell writes them: ``soil.friction_angle=35 deg``.

    Raises:
        RequestError: where a value cannot be written.
    """
    return [f"{key}={_typed(value)}" for key, value in (keys or {}).items()]


def _typed(value: KeyValue) -> str:
    if isinstance(value, str):
        return value
    if is_quantity(value):
        return f"{float(value[0])!r} {value[1]}"
    return _toml(plain(value))


def is_quantity(value: object) -> bool:
    """Whether it is a number with its unit: ``(35, "deg")``."""
    return (
        isinstance(value, tuple)
        and len(value) == 2
        and isinstance(value[1], str)
        and not isinstance(value[0], (str, bool))
    )


def plain(value: Any) -> Any:
    """The value in text, numbers, truth values, lists and dicts; numbers with a unit as text.

    Raises:
        RequestError: where it is something else.
    """
    if is_quantity(value):
        return f"{float(value[0])!r} {value[1]}"
    if isinstance(value, Mapping):
        return {str(key): plain(inner) for key, inner in value.items()}
    if isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist"):
        return plain(value.tolist())
    if isinstance(value, Sequence):
        return [plain(inner) for inner in value]
    raise RequestError(f"{value!r} is no value of a case: give text, a number, (number, unit), True or False, a list or a dict")


def _toml(value: Any) -> str:
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{json.dumps(key)} = {_toml(inner)}" for key, inner in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    if isinstance(value, float):
        return repr(value)
    return json.dumps(value, ensure_ascii=False)
