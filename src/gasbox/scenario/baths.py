"""What holds temperature or pressure, or adds heat, and where a schedule leads it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any, Final, Literal

from pydantic import ConfigDict, Discriminator, Field, Tag
from pydantic.config import JsonDict

from gasbox.scenario.kinds import Kind
from gasbox.scenario.species import Species
from gasbox.scenario.values import Finite, NotNegative, Positive, Section

__all__ = [
    "Barostat",
    "BarostatAim",
    "Heating",
    "Langevin",
    "NewPressure",
    "NewTemperature",
    "Thermostat",
    "ThermostatAim",
    "VelocityRescaling",
    "starting_temperature",
]

_KIND_REQUIRED: Final[JsonDict] = {"required": ["kind"]}


class Langevin(Section):
    """Friction and random kicks on each disc: a medium around them."""

    model_config = ConfigDict(json_schema_extra=_KIND_REQUIRED)

    kind: Literal["langevin"] = "langevin"
    """Kind of thermostat."""
    temperature: NotNegative | None = None
    """Temperature [energy]; without it, that of the start."""
    time: Positive = 1.0
    """Time in which a velocity is forgotten; the friction is its inverse [time]."""


class VelocityRescaling(Section):
    """One factor on all velocities, drawn so that the kinetic energy is distributed as in a heat bath.

    G. Bussi, D. Donadio, M. Parrinello, J. Chem. Phys. 126, 014101 (2007), doi:10.1063/1.2408420.
    """

    model_config = ConfigDict(json_schema_extra=_KIND_REQUIRED)

    kind: Literal["velocity-rescaling"] = "velocity-rescaling"
    """Kind of thermostat."""
    temperature: NotNegative | None = None
    """Temperature [energy]; without it, that of the start."""
    time: Positive = 1.0
    """Time in which the kinetic energy relaxes [time]."""


Thermostat = Annotated[Langevin | VelocityRescaling, Field(discriminator="kind")]


class Barostat(Section):
    """Holds the pressure: the area of a periodic box is rescaled, with all that is in it.

    M. Bernetti, G. Bussi, J. Chem. Phys. 153, 114107 (2020), doi:10.1063/5.0020514.
    """

    pressure: NotNegative
    """Pressure [mass/time²]."""
    time: Positive = 20.0
    """Time in which the area of an ideal gas relaxes; that of a liquid is some 50 times shorter [time]."""


class Heating(Section):
    """Heat that is added at a constant rate."""

    power: Finite
    """For each particle [energy/time]; less than 0 takes heat away, 0 does nothing."""


class ThermostatAim(Section):
    """Where the thermostat goes from where it is."""

    temperature: NotNegative
    """Temperature in the end [energy]."""
    over: NotNegative = 0.0
    """Time in which it goes there, evenly [time]."""


class BarostatAim(Section):
    """Where the barostat goes from where it is."""

    pressure: NotNegative
    """Pressure in the end [mass/time²]."""
    over: NotNegative = 0.0
    """Time in which it goes there, evenly [time]."""


def _tag(value: Any) -> str:
    return "off" if isinstance(value, str) else "aim"


_Off = Annotated[Literal["off"], Tag("off")]
NewTemperature = Annotated[Annotated[ThermostatAim, Tag("aim")] | _Off, Discriminator(_tag)]
NewPressure = Annotated[Annotated[BarostatAim, Tag("aim")] | _Off, Discriminator(_tag)]


def starting_temperature(species: Sequence[Species | Kind]) -> float | None:
    """Mean temperature [energy] of all counted discs that start with one; None if none do."""
    warm = [(entry.temperature, entry.count) for entry in species if entry.temperature is not None]
    total = sum(count for _, count in warm)
    return sum(temperature * count for temperature, count in warm) / total if total else None
