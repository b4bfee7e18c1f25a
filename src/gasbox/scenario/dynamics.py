"""Which rule of motion, and its settings."""

from __future__ import annotations

from typing import Annotated, Final, Literal

from pydantic import ConfigDict, Field, Strict
from pydantic.config import JsonDict

from gasbox.scenario.species import Region
from gasbox.scenario.values import WHOLE, NotNegative, Positive, Section

__all__ = ["KINDS", "Dynamics", "EventDriven", "Forced", "Rooms", "Stepped", "Walk"]

_KIND_REQUIRED: Final[JsonDict] = {"required": ["kind"]}
"""In a file the kind must be said; in Python the class says it."""


class Stepped(Section):
    """The classroom rule: move by `velocity * time_step`, then let touching, approaching pairs collide."""

    model_config = ConfigDict(json_schema_extra=_KIND_REQUIRED)

    kind: Literal["stepped"] = "stepped"
    """Rule of motion."""
    time_step: Positive = 1.0
    """Simulated time of one step [time]."""


class EventDriven(Section):
    """Exact: fly to the next collision, so that none is ever missed."""

    model_config = ConfigDict(json_schema_extra=_KIND_REQUIRED)

    kind: Literal["event-driven"] = "event-driven"
    """Rule of motion."""


class Forced(Section):
    """Forces between discs: velocity Verlet, with what the section `forces` says."""

    model_config = ConfigDict(json_schema_extra=_KIND_REQUIRED)

    kind: Literal["forced"] = "forced"
    """Rule of motion."""
    time_step: Positive = 0.005
    """Simulated time of one step [time]."""


class Rooms(Section):
    """Rooms that walkers do not leave by themselves: rows and columns of equal boxes."""

    columns: Annotated[int, Strict(), Field(ge=1, le=100), WHOLE] = 1
    """How many stand side by side."""
    rows: Annotated[int, Strict(), Field(ge=1, le=100), WHOLE] = 1
    """How many stand one above the other."""
    gap: NotNegative = 0.0
    """Between two rooms [length]."""
    region: Region | None = None
    """The part of the container that they share out among themselves; without it, the whole."""


class Walk(Section):
    """People who walk about: at a steady speed, in a direction that is forgotten bit by bit."""

    model_config = ConfigDict(json_schema_extra=_KIND_REQUIRED)

    kind: Literal["walk"] = "walk"
    """Rule of motion."""
    time_step: Positive = 0.05
    """Simulated time of one step [time]."""
    speed: Positive = 1.0
    """At which everybody walks [length/time]."""
    turning: NotNegative = 1.0
    """Rate at which the direction is forgotten [1/time]; 0 walks straight on."""
    hurry: Positive = 3.0
    """So many times faster they walk who are on their way to somewhere."""
    reach: Positive = 1.0
    """From so near on they are avoided by those who keep their distance [length]."""
    rooms: Rooms = Rooms()
    """Where they walk; without it, in the whole container."""


KINDS: Final[dict[str, type[Stepped] | type[EventDriven] | type[Forced] | type[Walk]]] = {
    "stepped": Stepped,
    "event-driven": EventDriven,
    "forced": Forced,
    "walk": Walk,
}

Dynamics = Annotated[Stepped | EventDriven | Forced | Walk, Field(discriminator="kind")]
