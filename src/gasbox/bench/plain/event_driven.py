"""Exact flight of equal discs of mass 1 in a periodic square, in plain loops.

One event for each disc (its next collision, or the crossing into the next cell) in one binary heap; whoever has an
event looks at all nine cells around it. Everything is in this one file, so that numba's own file stamp notices every
change.

Source: D. C. Rapaport, The Art of Molecular Dynamics Simulation (2004), chapter 14, doi:10.1017/CBO9780511816581;
one event a disc: B. D. Lubachevsky, J. Comput. Phys. 94, 255 (1991), doi:10.1016/0021-9991(91)90222-7.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel

__all__ = ["PlainEventDriven"]

_CROSSING = -1
"""In place of a partner: the event is the crossing into the next cell."""


class _Tables(NamedTuple):
    """What is known of each disc: where it was at its own time, its cell, and its next event.

    Attributes
    ----------
    flight : (n, 5) float64, position, velocity, and the time they belong to
    cell : (n, 2) int32, column and row
    after, before : (n,) int32, neighbours in the list of a cell, -1 at its ends
    head : (cells, cells) int32, first disc of each cell by row and column, -1 if empty
    event : (n,) float64, time of the next event [time]
    partner : (n,) int32, whom it will meet, or _CROSSING
    met : (n,) int64, collisions of each disc so far
    partner_met : (n,) int64, those of the partner when the event was found
    heap : (n,) int32, discs, earliest event first
    place : (n,) int32, where each disc stands in the heap
    """

    flight: NDArray[np.float64]
    cell: NDArray[np.int32]
    after: NDArray[np.int32]
    before: NDArray[np.int32]
    head: NDArray[np.int32]
    event: NDArray[np.float64]
    partner: NDArray[np.int32]
    met: NDArray[np.int64]
    partner_met: NDArray[np.int64]
    heap: NDArray[np.int32]
    place: NDArray[np.int32]


@bare_kernel
def _reorder(tables: _Tables, i: int) -> None:
    """Move disc i to its place in the heap after its event has changed."""
    heap, place, event = tables.heap, tables.place, tables.event
    time, at, n = event[i], place[i], heap.shape[0]
    while at > 0 and time < event[heap[(at - 1) // 2]]:
        above = heap[(at - 1) // 2]
        heap[at], place[above] = above, at
        at = (at - 1) // 2
    while 2 * at + 1 < n:
        child = 2 * at + 1
        if child + 1 < n and event[heap[child + 1]] < event[heap[child]]:
            child += 1
        below = heap[child]
        if time <= event[below]:
            break
        heap[at], place[below] = below, at
        at = child
    heap[at], place[i] = i, at


@bare_kernel
def _enter(tables: _Tables, i: int, column: int, row: int) -> None:
    """Put disc i at the head of the list of a cell."""
    first = tables.head[row, column]
    tables.cell[i, 0], tables.cell[i, 1] = column, row
    tables.after[i], tables.before[i] = first, -1
    if first >= 0:
        tables.before[first] = i
    tables.head[row, column] = i


@bare_kernel
def _leave(tables: _Tables, i: int) -> None:
    """Take disc i out of the list of its cell."""
    before, after = tables.before[i], tables.after[i]
    if before >= 0:
        tables.after[before] = after
    else:
        tables.head[tables.cell[i, 1], tables.cell[i, 0]] = after
    if after >= 0:
        tables.before[after] = before


@bare_kernel
def _to_edge(tables: _Tables, i: int, axis: int, side: float) -> float:
    """Time until disc i, at its own time, leaves its column (axis 0) or row (1)."""
    length = side * tables.head.shape[0]
    speed = tables.flight[i, 2 + axis]
    within = tables.flight[i, axis] - tables.cell[i, axis] * side
    within -= length * np.rint((within - 0.5 * side) / length)
    # Rounding may leave a disc a hair outside of its cell: it is then at the edge.
    way = side - within if speed > 0.0 else within
    return min(max(way, 0.0), side) / abs(speed) if speed != 0.0 else math.inf


@bare_kernel
def _predict(tables: _Tables, i: int, length: float, diameter: float) -> None:
    """Find the next event of disc i, which is up to date, and file it."""
    flight, head, after = tables.flight, tables.head, tables.after
    cells, side = head.shape[0], length / head.shape[0]
    x, y, vx, vy, now = flight[i, 0], flight[i, 1], flight[i, 2], flight[i, 3], flight[i, 4]
    best = min(_to_edge(tables, i, 0, side), _to_edge(tables, i, 1, side))
    partner = _CROSSING
    for up in range(-1, 2):
        row = (tables.cell[i, 1] + up + cells) % cells
        for beside in range(-1, 2):
            j = head[row, (tables.cell[i, 0] + beside + cells) % cells]
            while j >= 0:
                dvx, dvy, elapsed = vx - flight[j, 2], vy - flight[j, 3], now - flight[j, 4]
                dx = x - flight[j, 0] - flight[j, 2] * elapsed
                dy = y - flight[j, 1] - flight[j, 3] * elapsed
                dx -= length * np.rint(dx / length)
                dy -= length * np.rint(dy / length)
                b = dx * dvx + dy * dvy
                if b < 0.0:
                    speed2 = dvx * dvx + dvy * dvy
                    gap = max(dx * dx + dy * dy - diameter * diameter, 0.0)
                    discriminant = b * b - speed2 * gap
                    if discriminant > 0.0:
                        wait = gap / (math.sqrt(discriminant) - b)
                        if wait < best:
                            best, partner = wait, j
                j = after[j]
    tables.event[i], tables.partner[i] = now + best, partner
    if partner >= 0:
        tables.partner_met[i] = tables.met[partner]
    _reorder(tables, i)


@bare_kernel
def _fly(flight: NDArray[np.float64], i: int, time: float, length: float) -> None:
    """Bring disc i up to `time`, into the box."""
    for axis in range(2):
        at = flight[i, axis] + flight[i, 2 + axis] * (time - flight[i, 4])
        flight[i, axis] = at - length * math.floor(at / length)
    flight[i, 4] = time


@bare_kernel
def _cross(tables: _Tables, i: int, side: float) -> None:
    """Move disc i, which has flown to the edge of its cell, into the next one."""
    along_x, along_y = _to_edge(tables, i, 0, side), _to_edge(tables, i, 1, side)
    axis = 0 if along_x <= along_y else 1
    step = 1 if tables.flight[i, 2 + axis] > 0.0 else -1
    cells = tables.head.shape[0]
    column, row = tables.cell[i, 0], tables.cell[i, 1]
    _leave(tables, i)
    if axis == 0:
        _enter(tables, i, (column + step + cells) % cells, row)
    else:
        _enter(tables, i, column, (row + step + cells) % cells)


@bare_kernel
def _collide(tables: _Tables, i: int, j: int, length: float) -> None:
    """Exchange the velocities of two touching discs along the line of their centres."""
    flight = tables.flight
    dx, dy = flight[i, 0] - flight[j, 0], flight[i, 1] - flight[j, 1]
    dx -= length * np.rint(dx / length)
    dy -= length * np.rint(dy / length)
    dvx, dvy = flight[i, 2] - flight[j, 2], flight[i, 3] - flight[j, 3]
    along = (dx * dvx + dy * dvy) / (dx * dx + dy * dy)
    flight[i, 2] -= along * dx
    flight[i, 3] -= along * dy
    flight[j, 2] += along * dx
    flight[j, 3] += along * dy
    tables.met[i] += 1
    tables.met[j] += 1


@bare_kernel
def _start(tables: _Tables, length: float, diameter: float) -> None:
    """Put all discs into their cells, and find their events."""
    cells = tables.head.shape[0]
    tables.head[:] = -1
    for i in range(tables.flight.shape[0]):
        column = min(int(tables.flight[i, 0] / length * cells), cells - 1)
        row = min(int(tables.flight[i, 1] / length * cells), cells - 1)
        _enter(tables, i, column, row)
    for i in range(tables.flight.shape[0]):
        _predict(tables, i, length, diameter)


@bare_kernel
def _advance(tables: _Tables, length: float, diameter: float, until: float) -> int:
    """Execute all events up to the time `until`; return the number of collisions."""
    flight, event, heap = tables.flight, tables.event, tables.heap
    collisions = 0
    while event[heap[0]] <= until:
        i = heap[0]
        partner = tables.partner[i]
        _fly(flight, i, event[i], length)
        if partner == _CROSSING:
            _cross(tables, i, length / tables.head.shape[0])
        elif tables.partner_met[i] == tables.met[partner]:
            _fly(flight, partner, event[i], length)
            _collide(tables, i, partner, length)
            collisions += 1
            _predict(tables, partner, length, diameter)
        _predict(tables, i, length, diameter)
    for i in range(flight.shape[0]):
        _fly(flight, i, until, length)
    return collisions


class PlainEventDriven:
    """Discs fly freely from collision to collision.

    Parameters
    ----------
    position : (n, 2) float64 [length], in the box
    velocity : (n, 2) float64 [length/time]
    length : of a side of the periodic square [length], at least three mean distances of the discs
    diameter : [length]
    """

    def __init__(
        self, position: NDArray[np.float64], velocity: NDArray[np.float64], length: float, diameter: float
    ) -> None:
        n = position.shape[0]
        cells = int(length / max(diameter, length / math.sqrt(n)))
        flight = np.concatenate([position, velocity, np.zeros((n, 1))], axis=1)
        chain, link = np.zeros((3, n), np.int32), np.arange(n, dtype=np.int32)
        self._tables = _Tables(
            flight=flight,
            cell=np.zeros((n, 2), np.int32),
            after=chain[0],
            before=chain[1],
            head=np.zeros((cells, cells), np.int32),
            event=np.full(n, math.inf),
            partner=chain[2],
            met=np.zeros(n, np.int64),
            partner_met=np.zeros(n, np.int64),
            heap=link,
            place=link.copy(),
        )
        self._length, self._diameter = length, diameter
        self.time = 0.0
        self.collisions = 0
        _start(self._tables, length, diameter)

    @property
    def position(self) -> NDArray[np.float64]:
        """(n, 2) float64 [length]."""
        return self._tables.flight[:, :2]

    @property
    def velocity(self) -> NDArray[np.float64]:
        """(n, 2) float64 [length/time]."""
        return self._tables.flight[:, 2:4]

    def advance(self, until: float) -> None:
        """Execute all events up to the absolute time `until` [time]."""
        self.collisions += _advance(self._tables, self._length, self._diameter, until)
        self.time = until
