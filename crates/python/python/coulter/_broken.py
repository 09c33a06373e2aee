"""A run that must not be used, as an exception."""

from __future__ import annotations

from pathlib import Path

from ._errors import CoulterError, RequestError
from ._results import Result


class BrokenRun(CoulterError):
    """The physics failed, or the result is graded broken: it must not be used.

    Attributes:
        folder: the results folder, if one is known.
    """

    def __init__(self, text: str, folder: Path | None = None) -> None:
        super().__init__(text)
        self.folder = folder

    @property
    def result(self) -> Result:
        """What was written until then, to find out what went wrong.

        Raises:
            RequestError: where the folder is not known.
        """
        if self.folder is None:
            raise RequestError("the results folder of the broken run is not known")
        return Result(self.folder)
