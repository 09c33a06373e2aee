"""Where the energy of a MuJoCo model in Coulter's soil has gone.

    audit = EnergyAudit(model, data)
    audit.add(bridge.step())  # after every step
    print(audit)

Work of drives and dampers, kinetic and potential energy are MuJoCo's numbers, work of the soil is Coulter's.
So what is missing shows what the exchange adds or takes. Forces that the user applies without an actuator
are not counted.
"""

from __future__ import annotations

from collections.abc import Mapping

import mujoco

import coulter


class EnergyAudit:
    """Works and energies since it began [J].

    Attributes:
        drives: work of the actuators.
        spent: that of them which was positive.
        dampers: work of the dampers, which is negative.
        soil: work of the soil on the bodies, which is negative.
        potential: loss of potential energy, of weights and springs.
        kinetic: gain of kinetic energy.
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData) -> None:
        """Begins at the state as it is."""
        self.drives = self.spent = self.dampers = self.soil = self.potential = self.kinetic = 0.0
        model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
        mujoco.mj_forward(model, data)
        self._model, self._data = model, data
        self._start = data.energy.copy()
        self._before = data.qvel.copy(), data.actuator_velocity.copy()

    def add(self, reactions: Mapping[str, coulter.Reaction]) -> None:
        """Adds a step of the bridge.

        An impulse does work at the mean of the velocities before and after it. Implicit integrators apply a
        force as it is at the velocity at the end of a step, which data has now.
        """
        data, half = self._data, 0.5 * self._model.opt.timestep
        joints, actuators = self._before
        drives = half * data.actuator_force * (actuators + data.actuator_velocity)
        self.drives += float(drives.sum())
        self.spent += float(drives.clip(0.0).sum())
        self.dampers += half * float(data.qfrc_damper @ (joints + data.qvel))
        self.soil += sum(reaction.work for reaction in reactions.values())
        self.potential = float(self._start[0] - data.energy[0])
        self.kinetic = float(data.energy[1] - self._start[1])
        self._before = data.qvel.copy(), data.actuator_velocity.copy()

    @property
    def missing(self) -> float:
        """What does not add up, over what drives have spent and weights have lost."""
        gone = self.drives + self.potential + self.dampers + self.soil - self.kinetic
        return gone / (self.spent + max(0.0, self.potential))

    def __str__(self) -> str:
        return (
            f"drives {self.drives:.3f} J, weights and springs {self.potential:.3f} J, "
            f"dampers {self.dampers:.3f} J, soil {self.soil:.3f} J, gained {self.kinetic:.3f} J; "
            f"missing {100.0 * self.missing:.1e} % of what was put in"
        )
