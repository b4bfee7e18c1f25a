"""Which rule of motion, and its settings."""

from __future__ import annotations

from typing import Annotated, Final, Literal

from pydantic import ConfigDict, Field
from pydantic.config import JsonDict

from gasbox.scenario.values import Positive, Section

__all__ = ["KINDS", "Dynamics", "EventDriven", "Forced", "Stepped"]

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


KINDS: Final[dict[str, type[Stepped] | type[EventDriven] | type[Forced]]] = {
    "stepped": Stepped,
    "event-driven": EventDriven,
    "forced": Forced,
}

Dynamics = Annotated[Stepped | EventDriven | Forced, Field(discriminator="kind")]
