"""Reads the VTK files that a run writes: XML with zlib-compressed arrays appended. No VTK is needed."""

from __future__ import annotations

import re
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import numpy.typing as npt

from ._errors import RequestError

_TYPES = {"Float32": "<f4", "Float64": "<f8", "Int64": "<i8"}
_BEGIN = re.compile(rb'<AppendedData encoding="raw">\s*_')

# An array of a file, of shape (n,) or (n, components).
Array = npt.NDArray[Any]


@dataclass(frozen=True)
class VtkFile:
    """The arrays of a file.

    Attributes:
        time: time since the start [s].
        sections: arrays by section (``PointData``, ``CellData``, ``Coordinates``, ``Points``, ``Polys``) and name.
    """

    time: float
    sections: Mapping[str, Mapping[str, Array]]


def read_vtk(path: Path) -> VtkFile:
    """Reads a ``.vtr`` or ``.vtp`` file of a run.

    Raises:
        RequestError: where it is missing or no such file.
    """
    try:
        content = path.read_bytes()
    except OSError as error:
        raise RequestError(f"{path} cannot be read: {error.strerror}") from error
    begin = _BEGIN.search(content)
    try:
        if begin is None:
            raise ValueError("it has no appended data")
        tree = ElementTree.fromstring(content[: begin.start()] + b"</VTKFile>")
        time = tree.find(".//FieldData/DataArray")
        piece = tree.find(".//Piece")
        if piece is None or time is None:
            raise ValueError("it has no piece, or no time")
        sections = {
            section.tag: {str(tag.get("Name")): _array(tag, content, begin.end()) for tag in section}
            for section in piece
        }
        return VtkFile(float(time.text or "nan"), sections)
    except (ValueError, KeyError, IndexError, zlib.error, ElementTree.ParseError) as error:
        raise RequestError(f"{path} is no field file of a run: {error}") from error


def _array(tag: ElementTree.Element, content: bytes, begin: int) -> Array:
    """The array that an element describes; its data begin with the number of blocks, their size and their compressed sizes."""
    at = begin + int(tag.attrib["offset"])
    count = int(np.frombuffer(content, "<u8", 1, at)[0])
    sizes = np.frombuffer(content, "<u8", count, at + 24)
    at += 24 + 8 * count
    blocks = []
    for size in sizes.tolist():
        blocks.append(zlib.decompress(content[at : at + size]))
        at += size
    numbers = np.frombuffer(b"".join(blocks), _TYPES[tag.attrib["type"]])
    components = int(tag.attrib["NumberOfComponents"])
    return numbers if components == 1 else numbers.reshape(-1, components)
