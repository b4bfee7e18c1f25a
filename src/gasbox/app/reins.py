"""How far and how fast a wall follows a hand: no faster than the gas can take it, no farther than there is room."""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Block, Enclosure, Geometry, Piston, Post, Rectangle, Segment, side_count
from gasbox.observe import mean_speed
from gasbox.state import MoveWall, SetWall, State

__all__ = ["displacement_of", "guided", "limits", "movable", "released"]

_SHARE: Final = 0.5
"""Of the mean speed of the particles; a faster wall would leave shock waves and never end heating the gas."""
_UPRIGHT: Final = 1e-9
_DENSEST: Final = 0.6
"""Area fraction to which a hand may press the gas together."""


def movable(geometry: Geometry, wall: int) -> bool:
    """Whether a wall can be moved by hand: one that is there, and moves anyway or divides a rectangle along an axis."""
    if not isinstance(geometry, Enclosure) or not 0 <= wall < len(geometry.walls):
        return False
    one, normal = geometry.walls[wall], geometry.normal(wall)
    if not one.present or normal == (0.0, 0.0) or _is_post(geometry, wall):
        return False
    if one.motion is not None:
        return True
    upright = isinstance(geometry.container, Rectangle) and min(map(abs, normal)) < _UPRIGHT
    return upright and not _is_side(geometry, wall) and one.passes is None and not one.open


def displacement_of(state: State, wall: int) -> float:
    """How far a wall is from where it was at the start, along its normal [length]."""
    return float(state.wall_displacement[wall]) if wall < state.wall_displacement.size else 0.0


def guided(
    geometry: Geometry, state: State, wall: int, displacement: float, frame_interval: float
) -> MoveWall | None:
    """The change that lets a wall follow; None if it cannot be moved.

    Parameters
    ----------
    displacement : where the hand is [length]
    frame_interval : [time], for a gas at rest, which gives no speed to go by
    """
    if not (isinstance(geometry, Enclosure) and movable(geometry, wall) and math.isfinite(displacement)):
        return None
    low, high = limits(geometry, state, wall)
    target = min(max(displacement, low), high)
    speed = _SHARE * (mean_speed(state) or 0.0) or float(geometry.size.min()) / (100.0 * frame_interval)
    return MoveWall(geometry.walls[wall].name, target, speed)


def released(start: Geometry, wall: int) -> SetWall | None:
    """The change when a hand lets go: a piston is free again, any other wall comes to rest by itself.

    Parameters
    ----------
    start : geometry of the scenario, in which no wall was moved yet
    """
    if not isinstance(start, Enclosure) or not 0 <= wall < len(start.walls):
        return None
    one = start.walls[wall]
    return SetWall(one.name, free=True) if isinstance(one.motion, Piston) else None


def limits(geometry: Enclosure, state: State, wall: int) -> tuple[float, float]:
    """Least and greatest displacement [length] to which a hand may move a wall."""
    normal = np.array(geometry.normal(wall))
    across = abs(float(np.array([-normal[1], normal[0]]) @ geometry.size))
    now = displacement_of(state, wall)
    place = _places(geometry, state, wall, normal)[0]
    below, above = _neighbours(geometry, state, wall, normal, place)
    along = state.position @ normal
    area = math.pi * state.radius**2
    spare = 4.0 * float(state.radius.max(initial=0.0))
    length = float(np.abs(normal) @ geometry.size)

    def room(inside: NDArray[np.bool_]) -> float:
        return max(float(area[inside].sum()) / (_DENSEST * across), spare)

    # Beyond a side of the container there is no gas; it may go out as far as the box is long.
    low = -length if wall in (0, 2) and _is_side(geometry, wall) else below - place + now
    high = length if wall in (1, 3) and _is_side(geometry, wall) else above - place + now
    if not (_is_side(geometry, wall) and wall in (0, 2)):
        low += room((along < place) & (along >= below))
    if not (_is_side(geometry, wall) and wall in (1, 3)):
        high -= room((along >= place) & (along <= above))
    return min(low, now), max(high, now)


def _is_post(geometry: Enclosure, wall: int) -> bool:
    """A post has no line to take hold of."""
    return not _is_side(geometry, wall) and isinstance(
        geometry.obstacles[wall - side_count(geometry.container)], Post
    )


def _is_side(geometry: Enclosure, wall: int) -> bool:
    return wall < side_count(geometry.container)


def _neighbours(
    geometry: Enclosure, state: State, wall: int, normal: NDArray[np.float64], place: float
) -> tuple[float, float]:
    """Where the next walls are along the normal, below and above `place` [length]."""
    box = sorted((0.0, float(normal @ geometry.size)))
    ends = [box[0], box[1]] if not _is_side(geometry, wall) else []
    for other, one in enumerate(geometry.walls):
        if other != wall and one.present and not one.open and one.passes is None:
            ends += _places(geometry, state, other, normal)
    below = [end for end in ends if end <= place]
    above = [end for end in ends if end >= place]
    return max(below, default=box[0]), min(above, default=box[1])


def _places(geometry: Enclosure, state: State, wall: int, normal: NDArray[np.float64]) -> list[float]:
    """How far along `normal` a wall begins and ends [length]; nothing for sides that it does not face."""
    first = side_count(geometry.container)
    shift = displacement_of(state, wall) * float(np.array(geometry.normal(wall)) @ normal)
    if wall < first:
        if not isinstance(geometry.container, Rectangle) or not any(np.array(geometry.normal(wall)) * normal):
            return []
        corner = geometry.size if wall % 2 else np.zeros(2)
        return [float(corner @ normal) + shift]
    match geometry.obstacles[wall - first]:
        case Segment(start=start, end=end):
            ends = [float(np.array(point) @ normal) + shift for point in (start, end)]
        case Block(vertices=vertices):
            ends = (np.array(vertices) @ normal).tolist()
        case Post(center=center, radius=radius):
            middle = float(np.array(center) @ normal)
            ends = [middle - radius, middle + radius]
    return [min(ends), max(ends)]
