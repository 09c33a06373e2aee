"""Tables with units: the CSV files of runs and studies."""

from __future__ import annotations

import csv
import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ._errors import RequestError
from ._optional import needed

if TYPE_CHECKING:
    import pandas
    import xarray

# A column: 64-bit numbers, not-a-number where there is none, or text.
Column = npt.NDArray[Any]

# "drag F_H [N]": name and unit.
_HEADER = re.compile(r"^(?P<name>.*?)\s*\[(?P<unit>[^\[\]]*)\]$")
# The symbol at the end of a name: "sinkage z", "drag F_H".
_SYMBOL = re.compile(r"^(?P<word>.+) (?:[A-Za-z]|[A-Z]_[A-Za-z]+)$")


class Table(Mapping[str, Column]):
    """Columns by name, of shape (lines,), with their units: ``table["drag F_H"]`` or in short ``table["drag"]``.

    A short name has underscores for spaces and goes without the symbol at its end, where no other column has the same.

    Attributes:
        units: the unit of each column by its name; ``-`` of a number without one, empty of text.
        path: the file that it was read from, if any.
    """

    def __init__(self, columns: Mapping[str, Column], units: Mapping[str, str], path: Path | None = None) -> None:
        self._columns = dict(columns)
        self.units = dict(units)
        self.path = path
        self._names = _short_names(list(self._columns))

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Table:
        """Reads a CSV file with units in its header; lines that begin with ``#`` are left out.

        Raises:
            RequestError: where it is missing or no such file.
        """
        path = Path(path)
        try:
            with path.open(encoding="utf-8", newline="") as file:
                lines = list(csv.reader(line for line in file if not line.startswith("#")))
        except OSError as error:
            raise RequestError(f"{path} cannot be read: {error.strerror}") from error
        if not lines:
            raise RequestError(f"{path} is empty; expected a CSV file with a header")
        header, *rows = lines
        for number, row in enumerate(rows, start=2):
            if len(row) != len(header):
                raise RequestError(f"{path}: line {number} has {len(row)} fields, its header {len(header)}")
        columns: dict[str, Column] = {}
        units: dict[str, str] = {}
        for position, title in enumerate(header):
            name, unit = _split(title)
            columns[name] = _column([row[position] for row in rows])
            units[name] = unit
        return cls(columns, units, path)

    def __getitem__(self, name: str) -> Column:
        return self._columns[self.name(name)]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        lines = len(next(iter(self._columns.values()), ()))
        shown = ", ".join(f"{name} [{self.units[name]}]" if self.units[name] else name for name in self)
        return f"<Table of {lines} lines: {shown}>"

    def name(self, name: str) -> str:
        """The full name of a column, from its full or its short name.

        Raises:
            KeyError: where there is none, with the names that there are.
        """
        if name in self._columns:
            return name
        if name in self._names:
            return self._names[name]
        raise KeyError(f"there is no column {name!r}; there are {', '.join(self)}")

    def unit(self, name: str) -> str:
        """The unit of a column, by its full or its short name.

        Raises:
            KeyError: where there is no such column.
        """
        return self.units[self.name(name)]

    def to_pandas(self) -> pandas.DataFrame:
        """A data frame with these columns; their units are in ``attrs["units"]``, by name.

        Raises:
            ImportError: where pandas is not installed.
        """
        frame = needed("pandas", "Table.to_pandas").DataFrame(self._columns)
        frame.attrs["units"] = dict(self.units)
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """A dataset with the columns by their short names, along the first of them if it increases, else along ``line``.

        Each variable has its ``units`` and its ``long_name`` in its attributes.

        Raises:
            ImportError: where xarray is not installed.
        """
        module = needed("xarray", "Table.to_xarray")
        short = {full: name for name, full in self._names.items()}
        first = next(iter(self._columns), None)
        runs_along = first is not None and _increases(self._columns[first])
        along = short[first] if first is not None and runs_along else "line"
        variables = {
            short[name]: (along, values, {"units": self.units[name], "long_name": name})
            for name, values in self._columns.items()
        }
        coordinates = {along: variables.pop(along)} if runs_along else {}
        dataset: xarray.Dataset = module.Dataset(variables, coordinates)
        return dataset


def _split(title: str) -> tuple[str, str]:
    found = _HEADER.match(title)
    return (found["name"], found["unit"]) if found else (title, "")


def _column(fields: list[str]) -> Column:
    try:
        return np.array([float(field) if field else np.nan for field in fields])
    except ValueError:
        return np.array(fields, dtype=np.str_)


def _increases(values: Column) -> bool:
    return values.dtype.kind == "f" and bool(np.all(np.diff(values) > 0))


def _short_names(names: list[str]) -> dict[str, str]:
    """The full name for each short one."""

    def word(name: str) -> str:
        found = _SYMBOL.match(name)
        return found["word"] if found else name

    words = [word(name) for name in names]
    chosen = {
        name: short if words.count(short) == 1 and (short == name or short not in names) else name
        for name, short in zip(names, words, strict=True)
    }
    return {short.replace(" ", "_"): name for name, short in chosen.items()}
