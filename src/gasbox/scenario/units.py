"""Real units, shown beside the scenario's own."""

from __future__ import annotations

import math
from typing import Annotated, Final

from pydantic import Field

from gasbox.scenario.values import Positive, Section

__all__ = ["Units"]

_BOLTZMANN: Final = 1.380649e-23
"""[J/K], exact since 2019."""


class Units(Section):
    """What one unit of the scenario is in the SI. It changes nothing but what is shown."""

    name: Annotated[str, Field(min_length=1, max_length=60)]
    """What these units stand for, as in "argon"."""
    length: Positive
    """One unit of length [m]."""
    energy: Positive
    """One unit of energy [J]."""
    mass: Positive
    """One unit of mass [kg]."""

    @property
    def time(self) -> float:
        """One unit of time [s]."""
        return self.length * math.sqrt(self.mass / self.energy)

    @property
    def temperature(self) -> float:
        """One unit of temperature [K]."""
        return self.energy / _BOLTZMANN

    @property
    def pressure(self) -> float:
        """One unit of pressure, in two dimensions a force per length [N/m]."""
        return self.energy / self.length**2
