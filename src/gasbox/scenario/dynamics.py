"""Which rule of motion, and its settings."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from gasbox.scenario.values import Positive, Section

__all__ = ["Dynamics", "EventDriven", "Stepped"]


class Stepped(Section):
    """The classroom rule: move by `velocity * time_step`, then let touching, approaching pairs collide."""

    kind: Literal["stepped"] = "stepped"
    """Rule of motion."""
    time_step: Positive = 1.0
    """Simulated time of one step [time]."""


class EventDriven(Section):
    """Exact: fly to the next collision, so that none is ever missed."""

    kind: Literal["event-driven"] = "event-driven"
    """Rule of motion."""


Dynamics = Annotated[Stepped | EventDriven, Field(discriminator="kind")]
