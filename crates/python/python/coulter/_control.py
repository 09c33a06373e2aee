"""A controller for bodies that a program steers: of depth, of a load, of a speed."""

from __future__ import annotations

import math

from ._errors import RequestError


class Controller:
    """A PID controller in discrete time, whose output stays within limits.

    With the setpoint r, the measured value y and a time h to the next exchange its output u is::

        v = feedforward + K (b r - y) + I + D,  u = min(max(v, low), high)
        D = T_d / (T_d + N h) (D before - K N (y - y before))
        I afterwards = I + K h / T_i (r - y) + h / T_t (u - v)

    The last term keeps the integral from winding up while the output is at a limit; T_t is T_i, with a derivative √(T_i T_d). Source:
    Åström & Hägglund 1995, PID Controllers, chapter 3. The unit of K is that of the output over that of the measured value.

    Three uses, in a loop ``while soil.time < end`` with ``now = soil.bodies["tine"]`` and exchanges every ``h`` seconds. The case needs a
    motion for each direction that is steered, such as ``heave = { speed = "0 m/s" }``.

    Hold a depth of 50 mm below the ground, as found by a gauge wheel 0.3 m beside the tine, at 0.4 m/s. The output is a velocity
    upwards, so K is in 1/s. A wheel that is ahead by the speed over K makes up for the lag::

        depth = coulter.Controller(gain=20.0, limits=(-0.3, 0.3))
        surface = float(soil.ground([now.position[0] + 0.4 / 20.0, 0.3]))
        rise = depth.output(surface - 0.05, -now.sinkage, h)  # of the lowest point; the undisturbed surface is at z = 0
        soil.step_until(soil.time + h, {"tine": coulter.Twist([0.4, 0.0, rise])})

    Hold a load: the drag, as the draft control of a tractor's hitch does, by the depth. More drag has to raise the tine, so K is
    negative, in m/s per N. Forces scatter: use the mean of some exchanges. With ``now.force[2]`` it is the vertical force::

        draft = coulter.Controller(gain=-0.01, limits=(-0.15, 0.15))
        rise = draft.output(50.0, drag, h)  # the mean of -now.force[0] over the last 0.1 s
        soil.step_until(soil.time + h, {"tine": coulter.Twist([0.4, 0.0, rise])})

    Hold a speed by a force, with ``forward = "free"``; or the slip of a wheel by a torque, with ``spin = "free"``::

        speed = coulter.Controller(gain=200.0, integral_time=0.1, limits=(0.0, 60.0))
        pull = speed.output(0.15, now.linear[0], h)
        soil.step_until(soil.time + h, {"tine": coulter.Load([pull, 0.0, 0.0])})

    Its state is not that of the simulation: to go back with :meth:`Simulation.restore`, keep a :func:`copy.copy` of it.

    Attributes:
        integral: the integral part I, in the unit of the output.
        is_limited: whether the last output is a limit.
    """

    def __init__(
        self,
        gain: float,
        limits: tuple[float, float],
        *,
        integral_time: float | None = None,
        derivative_time: float = 0.0,
        derivative_filter: float = 10.0,
        setpoint_weight: float = 1.0,
    ) -> None:
        """A controller at its start.

        Args:
            gain: K, output over measured value; negative where a larger output lowers the measured value.
            limits: the least and the largest output; infinite where there is none.
            integral_time: T_i [s]; without it there is no integral part.
            derivative_time: T_d [s].
            derivative_filter: N: the derivative is smoothed over T_d/N. Usual are 2 to 20.
            setpoint_weight: b: how much of a change of the setpoint acts at once, usually 0 to 1.

        Raises:
            RequestError: a number that makes no controller.
        """
        low, high = (float(limit) for limit in limits)
        _require(math.isfinite(gain) and gain != 0.0, f"gain = {gain}: it must be finite and not zero")
        _require(low < high, f"limits = ({low}, {high}): the first must be less than the second")
        _positive("integral_time", integral_time)
        _require(
            math.isfinite(derivative_time) and derivative_time >= 0.0,
            f"derivative_time = {derivative_time}: it must be a time in seconds, or 0",
        )
        _positive("derivative_filter", derivative_filter)
        _require(math.isfinite(setpoint_weight), f"setpoint_weight = {setpoint_weight}: it must be finite")
        self._gain, self._limits, self._weight = gain, (low, high), setpoint_weight
        self._integral_time, self._derivative_time, self._filter = integral_time, derivative_time, derivative_filter
        self._tracking_time = integral_time
        if integral_time is not None and derivative_time > 0.0:
            self._tracking_time = math.sqrt(integral_time * derivative_time)
        self.reset()

    def reset(self, integral: float = 0.0) -> None:
        """Back to the start, with this integral part: the output that has held the setpoint so far, for a smooth change-over."""
        _require(math.isfinite(integral), f"integral = {integral}: it must be finite")
        self.integral, self.is_limited = float(integral), False
        self._derivative, self._last = 0.0, math.nan

    def output(self, setpoint: float, measured: float, interval: float, feedforward: float = 0.0) -> float:
        """The output from now to the next exchange.

        Args:
            setpoint: r, what the measured value is to be.
            measured: y, what it is now.
            interval: h, the time to the next exchange [s].
            feedforward: what is added to the output, such as that which is known to be needed.

        Raises:
            RequestError: a number that is not finite, an interval that is not positive or too long for the integral.
        """
        for name, number in [("setpoint", setpoint), ("measured", measured), ("feedforward", feedforward)]:
            _require(math.isfinite(number), f"{name} = {number}: it must be finite")
        _positive("interval", interval)
        tracking = self._tracking_time
        _require(
            tracking is None or interval <= tracking,
            f"interval = {interval} s: it must not be longer than the tracking time of {tracking} s; exchange more often",
        )
        smooth = self._derivative_time + self._filter * interval
        change = 0.0 if math.isnan(self._last) else measured - self._last
        fresh = self._gain * self._filter * change
        self._derivative, self._last = self._derivative_time / smooth * (self._derivative - fresh), measured
        wanted = self._gain * (self._weight * setpoint - measured) + self.integral + self._derivative + feedforward
        low, high = self._limits
        output = min(max(wanted, low), high)
        self.is_limited = output != wanted
        if self._integral_time is not None and tracking is not None:
            self.integral += self._gain * interval / self._integral_time * (setpoint - measured)
            self.integral += interval / tracking * (output - wanted)
        return float(output)


def _require(holds: bool, why: str) -> None:
    if not holds:
        raise RequestError(why)


def _positive(name: str, number: float | None) -> None:
    _require(number is None or (math.isfinite(number) and number > 0.0), f"{name} = {number}: it must be positive")
