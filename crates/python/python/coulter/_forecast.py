"""The closed-form models at one point or over arrays."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._case import CaseLike, Keys, assignments, source_of
from ._errors import translated
from ._optional import needed

if TYPE_CHECKING:
    import pandas
    import xarray

Numbers = npt.NDArray[np.float64]
Texts = npt.NDArray[np.object_]


class Forecast(Mapping[str, Numbers]):
    """What the closed-form models say: arrays by name, of the common shape of the keys that vary; of one point without axes.

    With ``model="all"`` the models are the first axis, in the order of ``rows``. Not-a-number stands where there is no answer, and
    ``reason`` says why.

    Attributes:
        units: unit of each quantity: ``drag``, ``vertical``, ``lateral`` [N], ``axle_torque`` [N m], ``sinkage`` [m],
            ``contact_angle``, ``force_inclination`` [rad], ``slip`` and the groups ``F_H_bar``, ``F_V_bar``, ``Z`` [-].
        rows: the models of the first axis; without ``model="all"`` the one row that there is.
        model: which model answered, as texts of the same shape; empty where none did.
        reason: why there is no answer, as texts of the same shape; empty where there is one.
        varied: the keys that vary, each with its values of that shape (without the axis of the models) and their unit.
    """

    def __init__(
        self,
        values: Mapping[str, tuple[str, Numbers]],
        rows: list[str],
        texts: tuple[Texts, Texts],
        varied: Mapping[str, tuple[Numbers, str]],
        has_model_axis: bool,
    ) -> None:
        self._values = {name: numbers for name, (_, numbers) in values.items()}
        self.units = {name: unit for name, (unit, _) in values.items()}
        self.rows = rows
        self.model, self.reason = texts
        self.varied = dict(varied)
        self._has_model_axis = has_model_axis

    def __getitem__(self, name: str) -> Numbers:
        if name not in self._values:
            raise KeyError(f"there is no quantity {name!r}; there are {', '.join(self)}")
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __repr__(self) -> str:
        answered = int(np.count_nonzero(~np.isnan(self.drag)))
        return f"<Forecast of shape {self.shape}: {answered} of {self.drag.size} answers; {', '.join(self)}>"

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of every array."""
        return self.drag.shape

    @property
    def drag(self) -> Numbers:
        """Drag [N], positive against the tow."""
        return self["drag"]

    @property
    def vertical(self) -> Numbers:
        """Vertical force of the soil [N], positive upwards."""
        return self["vertical"]

    @property
    def sinkage(self) -> Numbers:
        """Sinkage of the lowest point [m]."""
        return self["sinkage"]

    @property
    def slip(self) -> Numbers:
        """Slip [-]: −1 locked, 0 rolling, above 0 driven."""
        return self["slip"]

    def to_pandas(self) -> pandas.DataFrame:
        """A data frame with a line for each point (and model): the keys that vary, model, quantities, reason; units in ``attrs``.

        Raises:
            ImportError: where pandas is not installed.
        """
        columns: dict[str, Any] = {
            key: np.broadcast_to(values, self.shape).ravel() for key, (values, _) in self.varied.items()
        }
        columns["model"] = self.model.ravel()
        columns |= {name: np.ravel(values) for name, values in self.items()}
        columns["reason"] = self.reason.ravel()
        frame = needed("pandas", "Forecast.to_pandas").DataFrame(columns)
        frame.attrs["units"] = {key: unit for key, (_, unit) in self.varied.items()} | self.units
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """A dataset along the keys that vary: each axis has the name of the only key that varies along it, else ``axis_0``, ….

        Units are in the attributes of each variable and coordinate.

        Raises:
            ImportError: where xarray is not installed.
        """
        module = needed("xarray", "Forecast.to_xarray")
        offset = 1 if self._has_model_axis else 0
        dims, coordinates = self._axes()
        if self._has_model_axis:
            dims = ["row", *dims]
            coordinates["row"] = ("row", self.rows)
        for key, (values, unit) in self.varied.items():
            if key not in coordinates:
                coordinates[key] = (dims[offset:], values, {"units": unit or "-"})
        variables: dict[str, Any] = {name: (dims, values, {"units": self.units[name]}) for name, values in self.items()}
        variables["model"] = (dims, self.model)
        variables["reason"] = (dims, self.reason)
        dataset: xarray.Dataset = module.Dataset(variables, coordinates)
        return dataset

    def _axes(self) -> tuple[list[str], dict[str, Any]]:
        """The name of each axis, and the coordinates of those along which one key alone varies."""
        shape = self.shape[1:] if self._has_model_axis else self.shape
        names, coordinates = [], {}
        for axis in range(len(shape)):
            along = [key for key, (values, _) in self.varied.items() if _varies(values, axis)]
            others = [a for a in range(len(shape)) if a != axis]
            if len(along) == 1 and not any(_varies(self.varied[along[0]][0], other) for other in others):
                values, unit = self.varied[along[0]]
                line = values[tuple(slice(None) if a == axis else 0 for a in range(len(shape)))]
                coordinates[along[0]] = (along[0], line, {"units": unit or "-"})
                names.append(along[0])
            else:
                names.append(f"axis_{axis}")
        return names, coordinates


def _varies(values: Numbers, axis: int) -> bool:
    first = np.take(values, [0], axis=axis)
    return bool(np.any(values != first))


def forecast(
    case: CaseLike,
    *,
    set: Keys | None = None,
    vary: Mapping[str, Any] | None = None,
    grid: bool = False,
    model: str | None = None,
    threads: int = 0,
) -> Forecast:
    """Evaluates the closed-form models for a case, at one point or over arrays.

    A point is the case with its keys set, as ``coulter forecast --set`` sets them: its numbers are the same. The work is done on several
    threads without the interpreter's lock; Ctrl-C ends it.

    Args:
        case: the path of a case file, or its keys as nested dicts.
        set: keys that have one value, such as ``{"soil.friction_angle": "35 deg"}``.
        vary: keys with arrays: ``{"soil.friction_angle": (angles, "deg"), "body.disc.friction": frictions}``; a number without a unit
            needs none. Arrays are broadcast against each other by numpy's rules.
        grid: vary the keys, each with an array of one axis, in every combination instead: an axis for each, in their order.
        model: the name of a model, such as ``"BC-WW"``, or ``"all"``; by default the one that is recommended at each point.
        threads: number of threads, 0 for as many as ``coulter run`` has by default.

    Raises:
        CaseError: the case is wrong at every point; with file, line and cure.
        RequestError: no closed form applies at any point, or there is no such model.
        ValueError: the arrays cannot be broadcast, or, with ``grid``, have not one axis each.
    """
    typed = {key: _array_and_unit(value) for key, value in (vary or {}).items()}
    spread = _spread([array for array, _ in typed.values()], grid)
    shape = spread[0].shape if spread else ()
    varied = {key: (values, unit) for (key, (_, unit)), values in zip(typed.items(), spread, strict=True)}
    call = {
        "source": source_of(case),
        "set": assignments(set),
        "varied": [[key, unit] for key, (_, unit) in typed.items()],
        "count": int(np.prod(shape, dtype=np.int64)),
        "which": {None: "recommended", "all": "all"}.get(model, {"named": model}),
        "threads": threads,
    }
    with translated():
        found = _native.forecast(json.dumps(call), [np.ascontiguousarray(values, "<f8").tobytes() for values in spread])
    has_model_axis = model == "all"
    if has_model_axis:
        shape = (len(found["rows"]), *shape)
    values = {
        name: (unit, np.frombuffer(numbers, "<f8").reshape(shape).copy())
        for name, (unit, numbers) in found["quantities"].items()
    }
    texts = _texts(found["models"], shape), _texts(found["reasons"], shape)
    return Forecast(values, found["rows"], texts, varied, has_model_axis)


def _spread(arrays: list[Numbers], grid: bool) -> list[Numbers]:
    """The arrays in a common shape: broadcast, or in every combination."""
    if not arrays:
        return []
    if not grid:
        return list(np.broadcast_arrays(*arrays))
    if any(array.ndim != 1 for array in arrays):
        raise ValueError("with grid=True every key varies along one axis: give arrays of one axis")
    return list(np.meshgrid(*arrays, indexing="ij"))


def _texts(texts: list[str], shape: tuple[int, ...]) -> Texts:
    array = np.empty(len(texts), dtype=object)
    array[:] = texts
    return array.reshape(shape)


def _array_and_unit(value: Any) -> tuple[Numbers, str]:
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], str):
        return np.asarray(value[0], dtype=np.float64), value[1]
    return np.asarray(value, dtype=np.float64), ""
