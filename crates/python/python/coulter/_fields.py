"""Fields of a run at one time: the soil on its grid, the free surface, the bodies."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.etree import ElementTree

import numpy as np
import numpy.typing as npt

from ._errors import RequestError
from ._inside import inside
from ._optional import needed
from ._vtk import VtkFile, read_vtk

if TYPE_CHECKING:
    import xarray

Numbers = npt.NDArray[np.floating[Any]]

# Units of the fields; those that are not listed have none.
_UNITS = {
    "compaction": "m",
    "density": "kg/m^3",
    "disturbed": "m",
    "excess_pore_pressure": "Pa",
    "excess_pore_pressure_ahead": "Pa",
    "height": "m",
    "intact_shear_strength": "Pa",
    "mises": "Pa",
    "mixed": "m",
    "preconsolidation_pressure": "Pa",
    "pressure": "Pa",
    "rise": "m",
    "stress": "Pa",
    "velocity": "m/s",
}
_METRES = {"units": "m"}
_COMPONENTS = {3: ["x", "y", "z"], 6: ["xx", "yy", "zz", "xy", "yz", "xz"]}
_COMPONENT_NAMES = {3: "component", 6: "stress_component"}


class _Field(Mapping[str, Numbers]):
    """Arrays by name, read from a file when they are asked for.

    Attributes:
        path: the file.
    """

    def __init__(self, path: Path) -> None:
        self.path = path

    @cached_property
    def _file(self) -> VtkFile:
        return read_vtk(self.path)

    @property
    def time(self) -> float:
        """Time since the start [s]."""
        return self._file.time

    @property
    def _arrays(self) -> Mapping[str, Numbers]:
        return self._file.sections["PointData"]

    def _shaped(self, array: Numbers) -> Numbers:
        return array

    def __getitem__(self, name: str) -> Numbers:
        if name not in self._arrays:
            raise KeyError(f"there is no field {name!r}; there are {', '.join(self)}")
        return self._shaped(self._arrays[name])

    def __iter__(self) -> Any:
        return iter(self._arrays)

    def __len__(self) -> int:
        return len(self._arrays)

    def __repr__(self) -> str:
        return f"<{type(self).__name__} at {self.time:.6g} s: {', '.join(self)}>"

    def unit(self, name: str) -> str:
        """Unit of a field; ``-`` for one without.

        Raises:
            KeyError: where there is no such field.
        """
        if name not in self:
            raise KeyError(f"there is no field {name!r}; there are {', '.join(self)}")
        return _UNITS.get(name, "-")

    def to_pyvista(self) -> Any:
        """The mesh of the file, with these fields, for pyvista.

        Raises:
            ImportError: where pyvista is not installed.
        """
        return needed("pyvista", "to_pyvista").read(self.path)

    def _dataset(self, dims: tuple[str, ...], coordinates: Mapping[str, Any]) -> xarray.Dataset:
        module = needed("xarray", "to_xarray")
        along = dict(coordinates)
        variables = {}
        for name, values in self.items():
            extra: tuple[str, ...] = ()
            if values.ndim > len(dims):
                components = values.shape[-1]
                extra = (_COMPONENT_NAMES[components],)
                along[extra[0]] = _COMPONENTS[components]
            variables[name] = (dims + extra, values, {"units": self.unit(name)})
        dataset: xarray.Dataset = module.Dataset(variables, along, {"time": self.time, "time_units": "s"})
        return dataset


class SoilField(_Field):
    """The soil on its grid. Arrays have the shape (z, y, x) of the cells, vectors and tensors with their components last.

    ``evf`` is the Eulerian volume fraction, 1 full, 0 void; stresses are positive in tension, ``pressure`` in compression. A symmetric
    case holds y ≥ 0 only.
    """

    @property
    def _arrays(self) -> Mapping[str, Numbers]:
        return self._file.sections["CellData"]

    @property
    def faces(self) -> tuple[Numbers, Numbers, Numbers]:
        """Where the faces of the cells lie along x, y and z [m]."""
        coordinates = self._file.sections["Coordinates"]
        return coordinates["x"], coordinates["y"], coordinates["z"]

    @property
    def centres(self) -> tuple[Numbers, Numbers, Numbers]:
        """Where the centres of the cells lie along x, y and z [m]."""
        x, y, z = (0.5 * (faces[1:] + faces[:-1]) for faces in self.faces)
        return x, y, z

    @property
    def volumes(self) -> Numbers:
        """Volumes of the cells [m³], of shape (z, y, x)."""
        x, y, z = (np.diff(faces) for faces in self.faces)
        return z[:, None, None] * y[:, None] * x

    def _shaped(self, array: Numbers) -> Numbers:
        x, y, z = (len(faces) - 1 for faces in self.faces)
        return array.reshape((z, y, x) + array.shape[1:])

    def to_xarray(self) -> xarray.Dataset:
        """A dataset of the cells along ``z``, ``y`` and ``x`` (their centres), with units in the attributes of each variable.

        Raises:
            ImportError: where xarray is not installed.
        """
        x, y, z = self.centres
        return self._dataset(("z", "y", "x"), {"z": ("z", z, _METRES), "y": ("y", y, _METRES), "x": ("x", x, _METRES)})


class SurfaceField(_Field):
    """The free surface: ``height`` and ``rise`` over the undisturbed one [m], … as arrays of shape (y, x) of columns of cells.

    A symmetric case is mirrored: both halves are there.
    """

    @property
    def _points(self) -> Numbers:
        return self._file.sections["Points"]["Points"]

    @cached_property
    def _columns(self) -> int:
        y = self._points[:, 1]
        return int(np.argmax(y != y[0])) or len(y)

    @property
    def x(self) -> Numbers:
        """Positions of the columns of cells along x [m]."""
        return self._points[: self._columns, 0]

    @property
    def y(self) -> Numbers:
        """Positions of the columns of cells along y [m]."""
        return self._points[:: self._columns, 1]

    def _shaped(self, array: Numbers) -> Numbers:
        return array.reshape((-1, self._columns))

    def to_xarray(self) -> xarray.Dataset:
        """A dataset along ``y`` and ``x``, with units in the attributes of each variable.

        Raises:
            ImportError: where xarray is not installed.
        """
        return self._dataset(("y", "x"), {"y": ("y", self.y, _METRES), "x": ("x", self.x, _METRES)})


class BodyField(_Field):
    """The surface of a body where it is: ``velocity`` of its points [m/s], of shape (points, 3)."""

    @property
    def points(self) -> Numbers:
        """Positions of the points [m], of shape (points, 3)."""
        return self._file.sections["Points"]["Points"]

    @property
    def triangles(self) -> npt.NDArray[np.int64]:
        """Numbers of the three points of each triangle, of shape (triangles, 3)."""
        return self._file.sections["Polys"]["connectivity"].reshape(-1, 3)

    def to_xarray(self) -> xarray.Dataset:
        """A dataset along ``point``, with the ``position`` of each, and units in the attributes of each variable.

        Raises:
            ImportError: where xarray is not installed.
        """
        dataset = self._dataset(("point",), {"component": _COMPONENTS[3]})
        dataset["position"] = (("point", "component"), self.points, _METRES)
        return dataset


def frames(folder: Path, name: str) -> list[tuple[float, int, Path]]:
    """The files of a series, as of its ``.pvd``: time [s], number of the body, file. None where there is no series.

    Raises:
        RequestError: where the list cannot be read.
    """
    path = inside(folder, name)
    if not path.is_file():
        return []
    try:
        tree = ElementTree.parse(path)
        return [
            (float(tag.attrib["timestep"]), int(tag.attrib["part"]), inside(folder, tag.attrib["file"]))
            for tag in tree.iter("DataSet")
        ]
    except (OSError, ValueError, KeyError, ElementTree.ParseError) as error:
        raise RequestError(f"{path} is no list of fields: {error}") from error
