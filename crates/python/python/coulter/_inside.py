"""Entries of a folder that may have come from others: nothing is followed out of it, as in the command."""

from __future__ import annotations

import stat
from pathlib import Path, PurePath

from ._errors import RequestError


def inside(folder: Path, name: str) -> Path:
    """The path of an entry of a folder. The folder itself may be a link, for its user has named it.

    Raises:
        RequestError: where the name leads out of the folder, or the entry or a folder on the way is a link, a pipe or a device.
    """
    parts = PurePath(name).parts
    if PurePath(name).is_absolute() or ".." in parts:
        raise RequestError(f"{folder}: the name {name!r} leads out of the folder")
    path = folder
    for part in parts:
        path = path / part
        try:
            mode = path.lstat().st_mode
        except OSError:
            return folder / name  # whoever opens it says why
        if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
            what = "a link, which is not followed" if stat.S_ISLNK(mode) else "a pipe or a device"
            raise RequestError(f"{path} is {what}; put an ordinary file or folder in its place, or remove it")
    return path
