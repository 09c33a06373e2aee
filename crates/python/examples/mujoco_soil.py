"""Bodies that MuJoCo moves, in soil that Coulter solves.

    soil = coulter.Simulation(case)
    bridge = SoilBridge(soil, model, data, ["wheel"])  # a body of the model and of the case, by one name
    while soil.time < 10.0:
        data.ctrl[0] = ...
        bridge.step()  # instead of mujoco.mj_step

The origin of a MuJoCo body is the reference point of Coulter's: the centre of its bounding box, on the axle
of a disc or wheel. Both must begin at one place. Mass, inertia and motion are those of the model: the case
needs a weight, and a motion for each direction in which the body moves, but they have no further effect.

What it can do:

* Any tree of joints, with springs, dampers and actuators, and loops that equality constraints close.
* Any integrator of MuJoCo but RK4.

What it cannot do:

* Contacts, limits and dry friction of MuJoCo: their answer to a force is not linear. It refuses them.
* Of several bodies in the soil on one mechanism, each feels what the soil does to the others an exchange
  late: Coulter knows the mobility of each, not that between them. An energy audit says how much that
  matters; the run's own check "exchanged energy" sees each body alone.
"""

from __future__ import annotations

from collections.abc import Sequence

import mujoco
import numpy as np
import numpy.typing as npt

import coulter

Array = npt.NDArray[np.float64]


class SoilBridge:
    """Steps a MuJoCo model and the soil under it together.

    Attributes:
        apart: largest difference of a velocity in MuJoCo and in Coulter at the end of a step [m/s, rad/s].
    """

    def __init__(
        self, soil: coulter.Simulation, model: mujoco.MjModel, data: mujoco.MjData, bodies: Sequence[str]
    ) -> None:
        """Joins them at their present time; ``model.opt.timestep`` is the time between exchanges."""
        if model.opt.integrator == mujoco.mjtIntegrator.mjINT_RK4:
            raise ValueError("RK4 takes four steps in one: choose another integrator")
        self.soil, self.model, self.data = soil, model, data
        self.apart = 0.0
        self._numbers = {name: model.body(name).id for name in bodies}
        self._last = {name: np.zeros(6) for name in bodies}
        self._trial = mujoco.MjData(model)

    def step(self) -> dict[str, coulter.Reaction]:
        """One time step of MuJoCo, in which the mean force of the soil acts.

        Leaves ``data`` as ``mj_forward`` does. Controls and applied forces of the user act as in ``mj_step``.
        """
        model, data = self.model, self.data
        mujoco.mj_step1(model, data)
        if data.nefc > data.ne:
            raise NotImplementedError("a contact, a limit or dry friction of MuJoCo is active")
        jacobians = {name: self._jacobian(number) for name, number in self._numbers.items()}
        commands = {name: self._coupled(name, jacobians) for name in jacobians}
        reactions = self.soil.step_until(self.soil.time + model.opt.timestep, commands)

        given = data.qfrc_applied.copy()
        for name, jacobian in jacobians.items():
            self._last[name] = np.concatenate([reactions[name].force, reactions[name].moment])
            data.qfrc_applied += jacobian.T @ self._last[name]
        mujoco.mj_step2(model, data)
        data.qfrc_applied[:] = given
        for name, jacobian in jacobians.items():
            there = np.concatenate([reactions[name].linear, reactions[name].angular])
            self.apart = max(self.apart, float(np.abs(jacobian @ data.qvel - there).max()))
        mujoco.mj_forward(model, data)
        return {name: reactions[name] for name in jacobians}

    def _jacobian(self, number: int) -> Array:
        """From joint velocities to the twist of a body's origin, along the axes of space: 6 × nv."""
        rows = np.zeros((6, self.model.nv))
        mujoco.mj_jacBody(self.model, self.data, rows[:3], rows[3:], number)
        return rows

    def _gain(self, force: Array) -> Array:
        """Change of the joint velocities in the coming step under a further generalised force.

        A trial step instead of M⁻¹: so implicit damping, actuators and equality constraints are in it as
        the integrator treats them, and the velocities in both programs agree to round-off.
        """
        mujoco.mj_copyData(self._trial, self.model, self.data)
        self._trial.qfrc_applied += force
        mujoco.mj_step2(self.model, self._trial)
        return np.array(self._trial.qvel - self.data.qvel)

    def _coupled(self, name: str, jacobians: dict[str, Array]) -> coulter.Coupled:
        """A body as Coulter has to know it, with the last forces of the soil on the others.

        The Jacobian is that at the start of the step throughout: without J̇ q̇ in the acceleration the work
        of an impulse is one number in both programs. The next exchange takes pose and twist from MuJoCo.
        """
        data, number, step = self.data, self._numbers[name], self.model.opt.timestep
        jacobian, others = jacobians[name], np.zeros(self.model.nv)
        for other in jacobians.keys() - {name}:
            others += jacobians[other].T @ self._last[other]
        alone = self._gain(others)
        mobility = np.zeros((6, 6))
        for axis, row in enumerate(jacobian):
            if row.any():
                mobility[:, axis] = jacobian @ (self._gain(others + row) - alone) / step
        twist, acceleration = jacobian @ data.qvel, jacobian @ alone / step
        return coulter.Coupled(
            coulter.Pose(data.xpos[number], data.xquat[number]),
            coulter.Twist(twist[:3], twist[3:]),
            mobility,
            coulter.Twist(acceleration[:3], acceleration[3:]),
        )
