"""A simulation that another program steps and steers: a robot's, a vehicle's, a controller."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from types import TracebackType
from typing import Any, Literal, TypeAlias

import numpy as np
import numpy.typing as npt

from . import _native
from ._broken import BrokenRun
from ._case import CaseLike, Keys, assignments, source_of
from ._errors import CoulterWarning, RequestError, in_our_words, translated
from ._results import Result

# Three components along the axes of space, or four of a quaternion.
Vector: TypeAlias = Sequence[float] | npt.NDArray[np.float64]


@dataclass(frozen=True)
class Load:
    """The body moves as the case says, under a further constant load.

    Attributes:
        force: force [N].
        moment: moment about the body's reference point [N m].
    """

    force: Vector = (0.0, 0.0, 0.0)
    moment: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Twist:
    """The body moves at a constant velocity, whatever acts on it.

    Attributes:
        linear: velocity of its reference point [m/s].
        angular: angular velocity [rad/s].
    """

    linear: Vector = (0.0, 0.0, 0.0)
    angular: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Pose:
    """The body moves at the constant velocity that carries it to this pose, turning the shorter way.

    Attributes:
        position: where its reference point is to be [m].
        quaternion: its attitude, (w, x, y, z).
    """

    position: Vector
    quaternion: Vector = (1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Coupled:
    """The body is one of a mechanism that the other program moves.

    Soil and mechanism are solved together: the body yields to the soil as its mobility says, so that the exchange is stable however
    light it is. The other program then applies the mean force and moment that the exchange returns over the same time.

    Attributes:
        pose: where the body is.
        twist: its velocity.
        mobility: 6 × 6, J M⁻¹ Jᵀ of the Jacobian J of its reference point and the mass matrix M of the mechanism: velocity [m/s] and
            angular velocity [rad/s] per impulse [N s] and angular impulse [N m s].
        acceleration: change of the velocity without the soil: gravity, loads, joints.
    """

    pose: Pose
    twist: Twist
    mobility: npt.ArrayLike
    acceleration: Twist


Command: TypeAlias = Load | Twist | Pose | Coupled


@dataclass(frozen=True)
class Reaction:
    """What has become of a body since the last exchange. Vectors are along the axes of space.

    Attributes:
        force: mean force of the soil on the whole body [N].
        moment: its mean moment about the body's reference point [N m].
        position: where the reference point is now [m].
        quaternion: attitude now, (w, x, y, z).
        linear: velocity in the last step [m/s].
        angular: angular velocity in the last step [rad/s].
        sinkage: of its lowest point below the undisturbed surface [m].
        work: work of the soil on the whole body [J].
    """

    force: npt.NDArray[np.float64]
    moment: npt.NDArray[np.float64]
    position: npt.NDArray[np.float64]
    quaternion: npt.NDArray[np.float64]
    linear: npt.NDArray[np.float64]
    angular: npt.NDArray[np.float64]
    sinkage: float
    work: float


class Simulation:
    """A run that another program steps and steers, from one exchange to the next.

    Used as a context it ends with the block: as a finished run, or where an exception leaves the block as one that can be resumed. The
    solver runs on threads of its own without the interpreter's lock, and Ctrl-C stops it with a checkpoint. Its folder is that of
    :func:`coulter.run`, whose check "exchanged energy" says whether exchanges are frequent enough.

    A body without a command moves as the case says, and a degree of freedom that the case holds stays held.

    Attributes:
        time: time of this exchange [s].
        time_step: longest step of the solver [s].
        bodies: every body as it stands, by its name.
        folder: the results folder.
    """

    def __init__(
        self,
        case: CaseLike,
        *,
        set: Keys | None = None,
        output: str | os.PathLike[str] | None = None,
        start: Literal["new", "replace", "resume"] = "new",
        threads: int | None = None,
        device: str = "cpu",
    ) -> None:
        """Begins a run, or goes on with one from its last checkpoint.

        Args:
            case: the path of a case file, or its keys as nested dicts; one without stages.
            set: keys to set, as of :func:`coulter.run`.
            output: results folder; ``results/NAME`` by default.
            start: ``new`` refuses a folder that holds a run; ``replace`` starts again; ``resume`` continues from the last checkpoint.
            threads: threads of the solver, as of :func:`coulter.run`.
            device: what strains the soil, as of :func:`coulter.run`.

        Raises:
            CaseError: the case is wrong; with file, line and cure.
            RequestError: the folder holds another run, a file cannot be written.
        """
        call = {
            "source": source_of(case),
            "set": assignments(set),
            "output": None if output is None else os.fspath(output),
            "start": start,
            "threads": threads,
            "device": device,
        }
        if start not in ("new", "replace", "resume"):
            raise RequestError(f'start = "{start}": it must be "new", "replace" or "resume"')
        self._result: Result | None = None
        with translated():
            self._session = _native.Session(json.dumps(call), _warn)
        self._names = self._session.names()
        self.folder = self._session.folder()
        with self._followed():
            self._stand(self._session.standing())

    def step_until(self, time: float, commands: Mapping[str, Command] | None = None) -> dict[str, Reaction]:
        """Goes on to a time, at which what the bodies have met is exchanged for new commands.

        Args:
            time: time of the next exchange [s]. Steps are shortened so that a whole number of them reaches it, unless it does so anyway.
            commands: how bodies move until then, by name.

        Returns:
            Every body by its name, with the mean force and moment of the soil on it since the last exchange.

        Raises:
            RequestError: what cannot be done; the simulation stands as before.
            BrokenRun: the physics failed; its ``result`` shows what was written.
        """
        numbered = [(self._number(name), _as_call(command)) for name, command in (commands or {}).items()]
        with self._followed():
            self._stand(self._session.step(float(time), json.dumps(numbered)))
        return self.bodies

    def ground(self, points: npt.ArrayLike) -> npt.NDArray[np.float64]:
        """The height of the ground as it is now: a sensor.

        Where a body is in the soil, the height is that of the soil under or over it. So look at the ground in front of a body, or beside
        it, as a gauge wheel does.

        Args:
            points: places (x, y) [m], in an array whose last axis has these two.

        Returns:
            Height z of the free surface at each place [m], linear between the columns of cells; nan outside the grid.

        Raises:
            RequestError: points of another shape, or that are not finite.
        """
        places = np.asarray(points, dtype=float)
        if places.ndim == 0 or places.shape[-1] != 2 or not np.isfinite(places).all():
            raise RequestError(f"points: they must be pairs (x, y) of finite numbers, not of the shape {places.shape}")
        with self._followed():
            heights = self._session.ground([(float(x), float(y)) for x, y in places.reshape(-1, 2)])
        return np.array(heights).reshape(places.shape[:-1])

    def save(self) -> bytes:
        """The state, from which :meth:`restore` goes on: of this simulation, or of another one of the same case."""
        with self._followed():
            return self._session.save()

    def restore(self, state: bytes) -> dict[str, Reaction]:
        """Goes back, or on, to a state that was saved; the tables of the folder forget what came after it.

        Raises:
            RequestError: it is no state, or that of another case.
        """
        with self._followed():
            self._stand(self._session.restore(state))
        return self.bodies

    def finish(self) -> Result:
        """Ends the run here and writes its report.

        Raises:
            BrokenRun: the result is graded broken.
        """
        return self._end(True)

    def stop(self) -> Result:
        """Stops the run with a checkpoint, from which ``start="resume"`` goes on."""
        return self._end(False)

    @property
    def result(self) -> Result:
        """What was written.

        Raises:
            RequestError: while the run is on.
        """
        if self._result is None:
            raise RequestError("the simulation is still on: finish() or stop() it")
        return self._result

    def __enter__(self) -> Simulation:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._result is None:
            self._end(kind is None)

    def _number(self, name: str) -> int:
        if name not in self._names:
            raise RequestError(f'the case has no body "{name}", but {", ".join(self._names)}')
        return self._names.index(name)

    def _stand(self, standing: tuple[float, float, list[list[float]]]) -> None:
        self.time, self.time_step, numbers = standing
        self.bodies = {name: _reaction(own) for name, own in zip(self._names, numbers, strict=True)}

    def _end(self, finishes: bool) -> Result:
        if self._result is not None:
            return self._result
        with self._followed():
            folder, end, why = self._session.end(finishes)
        self._result = Result(folder)
        if end == "broken" and finishes:
            raise BrokenRun(in_our_words(why), folder)
        return self._result

    @contextmanager
    def _followed(self) -> Iterator[None]:
        """Raises what goes wrong; a run that has broken down has ended."""
        try:
            with translated():
                yield
        except (RequestError, ValueError):
            raise
        except KeyboardInterrupt:
            self._result = Result(self.folder)
            raise
        except Exception as error:
            self._result = Result(self.folder)
            raise BrokenRun(str(error), self.folder) from None


def _as_call(command: Command) -> dict[str, Any]:
    match command:
        case Load(force, moment):
            return {"load": {"force": _vector(force), "moment": _vector(moment)}}
        case Twist():
            return {"twist": _twist(command)}
        case Pose():
            return {"pose": _pose(command)}
        case Coupled(pose, twist, mobility, acceleration):
            rows = np.asarray(mobility, dtype=float)
            if rows.shape != (6, 6) or not np.isfinite(rows).all():
                raise RequestError(f"mobility: it must be 6 × 6 finite numbers, not {rows.shape}")
            return {
                "coupled": {
                    "pose": _pose(pose),
                    "twist": _twist(twist),
                    "mobility": rows.tolist(),
                    "acceleration": _twist(acceleration),
                }
            }
    raise RequestError(f"{command!r} is no command: give a Load, a Twist, a Pose or a Coupled")


def _twist(twist: Twist) -> dict[str, list[float]]:
    return {"linear": _vector(twist.linear), "angular": _vector(twist.angular)}


def _pose(pose: Pose) -> dict[str, list[float]]:
    return {"position": _vector(pose.position), "quaternion": _vector(pose.quaternion, 4)}


def _vector(vector: Vector, length: int = 3) -> list[float]:
    numbers = np.asarray(vector, dtype=float)
    if numbers.shape != (length,) or not np.isfinite(numbers).all():
        raise RequestError(f"{vector!r}: it must be {length} finite numbers")
    return [float(number) for number in numbers]


def _reaction(numbers: list[float]) -> Reaction:
    force, moment, position, quaternion, linear, angular, last = np.split(
        np.array(numbers), [3, 6, 9, 13, 16, 19]
    )
    return Reaction(force, moment, position, quaternion, linear, angular, float(last[0]), float(last[1]))


def _warn(text: str) -> None:
    # Whoever has made the simulation, beyond its constructor; the compiled part has no frame.
    warnings.warn(text, CoulterWarning, stacklevel=3)
