"""Gravity needs a floor: along a periodic direction discs would fall for ever."""

from __future__ import annotations

from collections.abc import Iterator

from gasbox.errors import Problem
from gasbox.geometry import Rectangle
from gasbox.scenario.parts import Parts
from gasbox.scenario.problems import short

__all__ = ["falling_problems"]


def falling_problems(parts: Parts) -> Iterator[Problem]:
    """Gravity, now or later, along a direction without walls."""
    shape = parts.container.geometry() if parts.container is not None else None
    if not isinstance(shape, Rectangle):
        return
    pulls = [("gravity", parts.gravity)]
    pulls += [
        (f"schedule[{number}].gravity", entry.gravity)
        for number, entry in enumerate(parts.schedule)
        if entry is not None
    ]
    for path, gravity in pulls:
        if gravity is None:
            continue
        for axis, pull, periodic in zip("xy", gravity, shape.periodic, strict=True):
            if pull != 0.0 and periodic:
                allowed = f"must be 0 along {axis}, which is periodic: discs would fall for ever"
                yield Problem(path, short(list(gravity)), allowed)
