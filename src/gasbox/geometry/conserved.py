"""Which momenta a geometry leaves alone: what is conserved is no heat, and counts as no degree of freedom.

Momentum along a direction is conserved if nothing changes when everything is shifted along it: the direction is
periodic, no gravity acts along it, and all that discs bounce off are smooth straight walls along it. Angular momentum
about the centre of a circle is conserved if the circle is bare, smooth and without gravity. Walls that everybody
passes, open walls and absent ones push nobody.
"""

from __future__ import annotations

import functools

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry.elements import Element, ElementKind
from gasbox.geometry.enclosure import Enclosure
from gasbox.geometry.rectangle import Rectangle
from gasbox.geometry.shapes import Circle
from gasbox.geometry.wall import Wall, lets_everybody_pass

__all__ = ["conserved_momentum", "conserves_rotation", "is_solid", "lets_everybody_pass"]

_ALONG = 1e-12
"""Greatest component of the normal of a wall along a direction to which it is parallel."""


def conserved_momentum(geometry: Rectangle | Enclosure) -> NDArray[np.bool_]:
    """(2,) bool: whether the total momentum along x, and along y, is conserved."""
    if isinstance(geometry, Rectangle):
        return geometry.periodic
    return np.array(_conserved(geometry))


@functools.lru_cache(maxsize=256)
def conserves_rotation(geometry: Rectangle | Enclosure) -> bool:
    """Whether the angular momentum about the centre of the container is conserved."""
    if not isinstance(geometry, Enclosure) or not isinstance(geometry.container, Circle):
        return False
    rim, *rest = geometry.walls
    return geometry.gravity == (0.0, 0.0) and rim.temperature is None and not any(map(is_solid, rest))


def is_solid(wall: Wall) -> bool:
    """Whether anybody bounces off it."""
    return wall.present and not wall.open and not lets_everybody_pass(wall.passes)


@functools.lru_cache(maxsize=256)
def _conserved(geometry: Enclosure) -> tuple[bool, bool]:
    if not np.any(geometry.periodic):
        return False, False
    touched = [element for element in geometry.elements if is_solid(geometry.walls[element.wall])]
    x, y = (
        bool(geometry.periodic[axis])
        and geometry.gravity[axis] == 0.0
        and all(_is_smooth(geometry, element, axis) for element in touched)
        for axis in (0, 1)
    )
    return x, y


def _is_smooth(geometry: Enclosure, element: Element, axis: int) -> bool:
    """Whether an element never pushes a disc along an axis."""
    if element.kind is not ElementKind.SIDE or geometry.walls[element.wall].temperature is not None:
        return False
    return abs(element.normal[axis]) < _ALONG
