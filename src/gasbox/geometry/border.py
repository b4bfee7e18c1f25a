"""The border of the region that centres can reach, piece by piece, each belonging to one wall.

Each side, corner, post and rim has a curve on which centres lie that touch it. The border is what is left of these
curves when all pieces too near to another solid have been taken out; a curve is cut wherever it meets another one.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
import shapely
from numpy.typing import NDArray

from gasbox.geometry.elements import Element, ElementKind
from gasbox.geometry.rectangle import Rectangle
from gasbox.geometry.shapes import Point
from gasbox.geometry.solids import Surroundings, blocked, blocks, box, images, reach, shift, solids, within

__all__ = ["border_lengths"]

_MARGIN: Final = 1e-9
"""Of the box: nearer than this, lengths count as equal."""


@dataclass(frozen=True)
class _Line:
    """Centres touching a side: from `place` along `tangent`, from `low` to `high` [length]."""

    wall: int
    place: Point
    tangent: Point
    low: float
    high: float

    def moved(self, dx: float, dy: float) -> _Line:
        return _Line(self.wall, (self.place[0] + dx, self.place[1] + dy), self.tangent, self.low, self.high)

    def bounds(self) -> tuple[float, float, float, float]:
        (x, y), (tx, ty) = self.place, self.tangent
        ends_x, ends_y = (x + tx * self.low, x + tx * self.high), (y + ty * self.low, y + ty * self.high)
        return min(ends_x), min(ends_y), max(ends_x), max(ends_y)

    def points(self, way: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.stack(
            [self.place[0] + self.tangent[0] * way, self.place[1] + self.tangent[1] * way], axis=1
        )

    def length(self, way: float) -> float:
        return way

    def cuts(self, other: _Curve) -> Iterator[float]:
        (tx, ty) = self.tangent
        dx, dy = other.place[0] - self.place[0], other.place[1] - self.place[1]
        if isinstance(other, _Line):
            across = tx * other.tangent[1] - ty * other.tangent[0]
            if abs(across) > 1e-12:
                yield (dx * other.tangent[1] - dy * other.tangent[0]) / across
            return
        foot, away = dx * tx + dy * ty, dx * ty - dy * tx
        half = math.sqrt(max(other.radius**2 - away**2, 0.0))
        yield from (foot - half, foot, foot + half)


@dataclass(frozen=True)
class _Arc:
    """Centres touching a corner, a post or a rim: a whole circle, angles from 0 to 2 pi [radian]."""

    wall: int
    place: Point
    radius: float
    low: float = 0.0
    high: float = 2 * math.pi

    def moved(self, dx: float, dy: float) -> _Arc:
        return _Arc(self.wall, (self.place[0] + dx, self.place[1] + dy), self.radius)

    def bounds(self) -> tuple[float, float, float, float]:
        (x, y), r = self.place, self.radius
        return x - r, y - r, x + r, y + r

    def points(self, way: NDArray[np.float64]) -> NDArray[np.float64]:
        return np.array(self.place) + self.radius * np.stack([np.cos(way), np.sin(way)], axis=1)

    def length(self, way: float) -> float:
        return way * self.radius

    def cuts(self, other: _Curve) -> Iterator[float]:
        dx, dy = other.place[0] - self.place[0], other.place[1] - self.place[1]
        if isinstance(other, _Line):
            (tx, ty) = other.tangent
            away = dx * ty - dy * tx
            direction, share = math.atan2(-tx * away, ty * away), abs(away) / self.radius
        else:
            distance = math.hypot(dx, dy)
            if distance == 0.0:
                return
            direction = math.atan2(dy, dx)
            share = (distance**2 + self.radius**2 - other.radius**2) / (2 * distance * self.radius)
        half = math.acos(min(max(share, -1.0), 1.0))
        for angle in (direction - half, direction, direction + half):
            yield angle % (2 * math.pi)


_Curve = _Line | _Arc


@functools.lru_cache(maxsize=1024)
def border_lengths(enclosure: Surroundings, radius: float) -> tuple[float, ...]:
    """Length [length] of the border that belongs to each wall, for centres of discs of this radius."""
    curves = list(
        _once(curve for element in enclosure.elements for curve in _curves(enclosure, element, radius))
    )
    pieces = [
        _pieces(curve, near) for curve, near in zip(curves, _neighbours(enclosure, curves), strict=True)
    ]
    total = [0.0] * len(enclosure.walls)
    if not curves:
        return tuple(total)
    middle = np.concatenate(
        [curve.points((low + high) / 2) for curve, (low, high) in zip(curves, pieces, strict=True)]
    )
    free = _free(enclosure, middle, radius)
    least = 2 * _MARGIN * max(enclosure.width, enclosure.height)
    done = 0
    for curve, (low, high) in zip(curves, pieces, strict=True):
        kept = free[done : done + low.size]
        done += low.size
        lengths = curve.length(1.0) * (high - low)[kept]
        total[curve.wall] += float(lengths[lengths > least].sum())
    return tuple(total)


def _once(curves: Iterator[_Curve]) -> Iterator[_Curve]:
    """Without arcs about a corner that two walls share: the first one has it."""
    seen: set[tuple[Point, float]] = set()
    for curve in curves:
        if isinstance(curve, _Arc):
            if (curve.place, curve.radius) in seen:
                continue
            seen.add((curve.place, curve.radius))
        yield curve


def _free(enclosure: Surroundings, middle: NDArray[np.float64], radius: float) -> NDArray[np.bool_]:
    margin = _MARGIN * max(enclosure.width, enclosure.height)
    inside = within(enclosure, middle, np.full(middle.shape[0], radius), margin)
    return inside & ~blocked(solids(enclosure), enclosure.walls, middle, radius, margin)


def _curves(enclosure: Surroundings, element: Element, radius: float) -> Iterator[_Curve]:
    """Where centres lie that touch an element."""
    wall = enclosure.walls[element.wall]
    if not blocks(wall):
        return
    away = reach(wall, radius)
    dx, dy = shift(enclosure, element.wall)
    x, y = element.place[0] + dx, element.place[1] + dy
    if element.kind == ElementKind.RIM:
        if element.radius > away:
            yield _Arc(element.wall, (x, y), element.radius - away)
    elif element.kind == ElementKind.CORNER:
        if element.radius + away > 0:
            yield _Arc(element.wall, (x, y), element.radius + away)
    else:
        (nx, ny), (tx, ty) = element.normal, element.tangent
        low, high = element.low, element.high
        if isinstance(enclosure.container, Rectangle) and math.isinf(low):
            left, right, bottom, top = box(enclosure, enclosure.container)
            low, high = sorted((tx * way_x + ty * way_y for way_x, way_y in ((left, bottom), (right, top))))
            x, y = x * abs(nx), y * abs(ny)
        for face in (element.faces,) if element.faces else (1, -1):
            yield _Line(element.wall, (x + face * nx * away, y + face * ny * away), (tx, ty), low, high)


def _neighbours(enclosure: Surroundings, curves: list[_Curve]) -> list[list[_Curve]]:
    """For each curve, the others (and periodic images of all) that it may meet."""
    others = [curve.moved(dx, dy) for dx, dy in images(enclosure) for curve in curves]
    if not others:
        return []
    tree = shapely.STRtree([shapely.box(*curve.bounds()) for curve in others])
    near: list[list[_Curve]] = [[] for _ in curves]
    margin = _MARGIN * max(enclosure.width, enclosure.height)
    for number, curve in enumerate(curves):
        low_x, low_y, high_x, high_y = curve.bounds()
        reached = shapely.box(low_x - margin, low_y - margin, high_x + margin, high_y + margin)
        near[number] = [others[other] for other in np.sort(tree.query(reached)) if other != number]
    return near


def _pieces(curve: _Curve, near: list[_Curve]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Beginnings and ends of the pieces between the cuts."""
    cuts = np.array([cut for other in near for cut in curve.cuts(other) if curve.low < cut < curve.high])
    ends = np.concatenate([[curve.low], np.sort(cuts), [curve.high]])
    return ends[:-1], ends[1:]
