"""Thermostat, barostat and heating, between the scenario and the kernels."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import UsageError
from gasbox.geometry import Geometry
from gasbox.geometry.conserved import conserved_momentum, conserves_rotation
from gasbox.kernels.forced.bath import (
    BAROSTAT,
    LANGEVIN,
    OFF,
    P_BEGIN,
    P_FROM,
    P_TIME,
    P_TO,
    POWER,
    RESCALING,
    T_BEGIN,
    T_FROM,
    T_TIME,
    T_TO,
    THERMOSTAT,
    aim,
)
from gasbox.scenario import Barostat, Heating, Langevin, Thermostat, VelocityRescaling
from gasbox.state import Control, SetBarostat, SetHeating, SetThermostat, State

__all__ = ["Drive", "degrees_of_freedom", "drive_of"]


def degrees_of_freedom(state: State, geometry: Geometry) -> int:
    """Velocities that share the energy: 2 of a particle, 1 more if it turns; 2 of each disc of a flexible molecule.

    Less one for each momentum that is conserved.
    """
    moving = 2 * state.count
    if state.sites is not None:
        flexible = state.sites.flexible
        moving += int(np.count_nonzero((state.inertia > 0.0) & ~flexible))
        moving += 2 * int((np.diff(state.sites.first) - 1)[flexible].sum())
    conserved = int(np.count_nonzero(conserved_momentum(geometry))) + int(conserves_rotation(geometry))
    return max(moving - conserved, 0)


def drive_of(
    thermostat: Thermostat | None, barostat: Barostat | None, heating: Heating | None
) -> NDArray[np.float64]:
    """(13,) float64, the columns of `gasbox.kernels.forced.bath`."""
    drive = np.zeros(13)
    # Times for baths that are switched on later.
    drive[T_TIME], drive[P_TIME] = VelocityRescaling().time, Barostat(pressure=0.0).time
    if thermostat is not None:
        drive[THERMOSTAT] = LANGEVIN if isinstance(thermostat, Langevin) else RESCALING
        drive[[T_FROM, T_TO]] = thermostat.temperature
        drive[T_TIME] = thermostat.time
    if barostat is not None:
        drive[BAROSTAT] = 1.0
        drive[[P_FROM, P_TO]] = barostat.pressure
        drive[P_TIME] = barostat.time
    if heating is not None:
        drive[POWER] = heating.power
    return drive


class Drive:
    """The numbers that kernels read, and what changes them.

    Attributes
    ----------
    values : (13,) float64, shared with the kernels
    """

    def __init__(self, values: NDArray[np.float64]) -> None:
        self.values = values
        # A thermostat that was switched off comes back as the same kind.
        self._kind = float(values[THERMOSTAT]) or float(RESCALING)

    @property
    def has_barostat(self) -> bool:
        """Whether the area may change."""
        return bool(self.values[BAROSTAT])

    @staticmethod
    def refuse_barostat(change: Control) -> None:
        """Raise UsageError for a barostat: the box is not periodic in both directions."""
        if isinstance(change, SetBarostat) and change.pressure is not None:
            raise UsageError("a barostat needs a box that is periodic in both directions, without obstacles")

    def change(self, change: Control, now: float, temperature: float) -> None:
        """Set a bath to something new at time `now` [time], at which the gas has this temperature [energy]."""
        values = self.values
        match change:
            case SetThermostat(temperature=None):
                self._kind = float(values[THERMOSTAT]) or self._kind
                values[THERMOSTAT] = OFF
            case SetThermostat(temperature=float() | int() as to, over=over):
                begin = aim(values, T_FROM, now) if values[THERMOSTAT] else temperature
                values[THERMOSTAT] = values[THERMOSTAT] or self._kind
                values[T_FROM : T_BEGIN + 2] = begin if over else to, to, now, now + over
            case SetBarostat(pressure=None):
                values[BAROSTAT] = 0.0
            case SetBarostat(pressure=float() | int() as to, over=over):
                begin = aim(values, P_FROM, now) if values[BAROSTAT] else to
                values[BAROSTAT] = 1.0
                values[P_FROM : P_BEGIN + 2] = begin if over else to, to, now, now + over
            case SetHeating(power=power):
                values[POWER] = power
