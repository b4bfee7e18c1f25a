"""Rules on dynamics `walk`: where people can walk, and what they know nothing of."""

from __future__ import annotations

from collections.abc import Iterator

from gasbox.errors import Problem
from gasbox.geometry import Rectangle
from gasbox.scenario.dynamics import Walk
from gasbox.scenario.parts import Parts
from gasbox.scenario.rooms import room_boxes

__all__ = ["walk_problems"]


def walk_problems(parts: Parts) -> Iterator[Problem]:
    """All that people cannot walk in, or do not feel."""
    if not isinstance(parts.dynamics, Walk):
        return
    strange = "people who walk know only rooms in a rectangle"
    for path, there in (
        ("walls", parts.walls),
        ("obstacles", parts.obstacles),
        ("molecules", parts.molecules),
    ):
        if there:
            yield Problem(path, f"{path} under dynamics of kind walk", strange)
    if parts.gravity is not None and any(parts.gravity):
        yield Problem("gravity", "gravity under dynamics of kind walk", strange)
    for number, entry in enumerate(parts.schedule):
        for key in ("gravity", "wall"):
            if entry is not None and getattr(entry, key) is not None:
                yield Problem(f"schedule[{number}].{key}", f"{key} under dynamics of kind walk", strange)
    if parts.container is None:
        return
    shape = parts.container.geometry()
    if not isinstance(shape, Rectangle):
        yield Problem("container.shape", parts.container.shape, "people walk in a rectangle only")
        return
    yield from _rooms(parts.dynamics, shape)


def _rooms(walk: Walk, box: Rectangle) -> Iterator[Problem]:
    rooms, region = walk.rooms, walk.rooms.region
    divided = rooms.columns * rooms.rows > 1 or region is not None
    if divided and box.periodic.any():
        allowed = "rooms have walls, so that the container may not be periodic"
        yield Problem("dynamics.rooms", "rooms in a periodic container", allowed)
        return
    for axis, ends, length in (
        ("x", region.x if region else None, box.width),
        ("y", region.y if region else None, box.height),
    ):
        if ends is not None and not 0 <= ends[0] < ends[1] <= length:
            allowed = f"must lie inside the container, [0, {length:g}], the lower end first"
            yield Problem(f"dynamics.rooms.region.{axis}", f"[{ends[0]:g}, {ends[1]:g}]", allowed)
            return
    boxes = room_boxes(rooms, (box.width, box.height))
    if not (boxes[:, :2] < boxes[:, 2:]).all():
        allowed = "must leave some room between the gaps"
        yield Problem("dynamics.rooms.gap", f"{rooms.gap:g}", allowed)
