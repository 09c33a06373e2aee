"""Coulter predicts how a rigid object moves through soil.

Four functions do the work: :func:`run` simulates a case, :func:`forecast` evaluates the closed-form models over arrays, :func:`sweep`
runs a study, :func:`check` says how a case is understood and what it costs. :class:`Result` and :class:`Study` read what lies in a
folder. A :class:`Simulation` is stepped and steered by another program; a :class:`Controller` holds a depth, a load or a speed in it.
:func:`command` calls any other command of the shell. All numbers are in SI units and radians, unless a unit is written beside them.

Numbers are those of the ``coulter`` command for the same case: both call the same functions.
"""

from ._broken import BrokenRun
from ._command import command, compare
from ._control import Controller
from ._errors import CaseError, CoulterError, CoulterWarning, Problem, RequestError
from ._fields import BodyField, SoilField, SurfaceField
from ._forecast import Forecast, forecast
from ._native import __version__
from ._results import Quantity, Result, open_result
from ._run import Check, Sample, check, run
from ._simulation import Coupled, Load, Pose, Reaction, Simulation, Twist
from ._study import Study, sweep
from ._table import Table

__all__ = [
    "BodyField",
    "BrokenRun",
    "CaseError",
    "Check",
    "Controller",
    "Coupled",
    "CoulterError",
    "CoulterWarning",
    "Forecast",
    "Load",
    "Pose",
    "Problem",
    "Quantity",
    "Reaction",
    "RequestError",
    "Result",
    "Sample",
    "Simulation",
    "SoilField",
    "Study",
    "SurfaceField",
    "Table",
    "Twist",
    "__version__",
    "check",
    "command",
    "compare",
    "forecast",
    "open_result",
    "run",
    "sweep",
]
