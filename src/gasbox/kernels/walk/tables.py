"""The arrays of people who walk, as their kernels take them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Files", "Ground", "Manner", "Walkers", "files", "ground"]

_CELLS_EACH = 4
"""Cells for each person, at most."""


class Walkers(NamedTuple):
    """One row for each person.

    Attributes
    ----------
    id : (n,) int64
    position : (n, 2) float64 [length], inside the container
    velocity : (n, 2) float64 [length/time], of the own walking, without what others push
    heading : (n, 2) float64, a unit vector
    place : (n,) int64, row of the table of places in which one walks, or to which one goes
    going : (n,) int64, 1 on the way to the target, else 0
    target : (n, 2) float64 [length]
    distancing : (n,) float64, how firmly one keeps away from others; 0 not at all
    pace : (n,) float64, factor on the speed; 0 stands still
    push : (n, 2) float64, sum over those nearby of how firmly one turns away from them
    """

    id: NDArray[np.int64]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    heading: NDArray[np.float64]
    place: NDArray[np.int64]
    going: NDArray[np.int64]
    target: NDArray[np.float64]
    distancing: NDArray[np.float64]
    pace: NDArray[np.float64]
    push: NDArray[np.float64]


class Ground(NamedTuple):
    """Where one can walk.

    Attributes
    ----------
    places : (m, 4) float64 [length], boxes: left, lower, right and upper end
    size : (2,) float64 [length], of the container
    period_x, period_y : its size where it is periodic, else infinite [length]
    """

    places: NDArray[np.float64]
    size: NDArray[np.float64]
    period_x: float
    period_y: float


class Manner(NamedTuple):
    """How one walks.

    Attributes
    ----------
    speed : [length/time]
    hurry : so many times faster on the way to a target
    reach : within which others are avoided [length]
    swerve : greatest tangent of half the angle by which one turns in a step
    step : [time]
    seed : (2,) int64, halves of the seed
    """

    speed: float
    hurry: float
    reach: float
    swerve: float
    step: float
    seed: NDArray[np.int64]


class Files(NamedTuple):
    """Cells that people are filed in.

    Attributes
    ----------
    cells : (2,) int64, columns and rows
    begin : (cells + 2,) int64, where each cell begins in `row`, once they are filed
    row : (n,) int64, rows of people by cell, in ascending order within one
    at : (n,) int64, cell of each
    x, y : (n,) float64 [length], their positions by cell, side by side in memory
    mark : (n,) int64, room for something of each, likewise
    """

    cells: NDArray[np.int64]
    begin: NDArray[np.int64]
    row: NDArray[np.int64]
    at: NDArray[np.int64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    mark: NDArray[np.int64]


def ground(places: NDArray[np.float64], size: NDArray[np.float64], periodic: NDArray[np.bool_]) -> Ground:
    """The ground of a container of this size (2,) [length], periodic (2,) or not."""
    period = np.where(periodic, size, math.inf)
    return Ground(np.ascontiguousarray(places, np.float64), size, float(period[0]), float(period[1]))


def files(size: NDArray[np.float64], reach: float, people: int) -> Files:
    """Cells not narrower than `reach` [length] in a container of this size (2,) [length]; not many more than people."""
    largest = math.sqrt(_CELLS_EACH * max(people, 16) * float(size[0] / size[1]))
    columns = max(1, int(min(size[0] / reach, largest, 1e9)))
    rows = max(1, int(min(size[1] / reach, _CELLS_EACH * max(people, 16) / columns, 1e9)))
    return Files(
        np.array([columns, rows], np.int64),
        np.zeros(columns * rows + 2, np.int64),
        np.zeros(people, np.int64),
        np.zeros(people, np.int64),
        np.zeros(people),
        np.zeros(people),
        np.zeros(people, np.int64),
    )
