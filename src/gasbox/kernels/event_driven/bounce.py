"""What happens at the elements of an enclosure: a disc bounces, passes and is counted, or leaves the gas."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Ledger, book_crossing, book_hall
from gasbox.kernels.event_driven.tables import LABEL, RADIUS, SPECIES, VX, VY, WALL, Tables, X, Y
from gasbox.kernels.hall import Hall
from gasbox.kernels.hall.approach import PASS
from gasbox.kernels.hall.motion import speed
from gasbox.kernels.hall.rebound import normal_at, rebound
from gasbox.kernels.hall.tables import (
    HIGH,
    KIND,
    LOW,
    MASS,
    NX,
    NY,
    OPEN,
    PX,
    PY,
    RHO,
    RIM,
    SIDE,
    TX,
    TY,
)
from gasbox.kernels.hall.tables import WALL as OWNER

__all__ = ["meet"]


@inlined_kernel
def _reach(hall: Hall, e: int, r: float, what: int) -> float:
    """Distance of the centre from element e at a meeting."""
    if what == PASS:
        return 0.0
    if hall.kind[e, KIND] == RIM:
        return hall.shape[e, RHO] - r
    return r + hall.shape[e, RHO]


@inlined_kernel
def _off(
    hall: Hall, e: int, x: float, y: float, shift_x: float, shift_y: float, reach: float, now: float
) -> float:
    """How far a centre is from where it would touch (an image of) element e."""
    away = normal_at(hall, e, x, y, shift_x, shift_y, now)[2]
    if hall.kind[e, KIND] != SIDE:
        return abs(away - reach)
    foot = (x - hall.shape[e, PX] - shift_x) * hall.shape[e, TX]
    foot += (y - hall.shape[e, PY] - shift_y) * hall.shape[e, TY]
    beyond = max(hall.shape[e, LOW] - foot, foot - hall.shape[e, HIGH], 0.0)
    return abs(away - reach) + beyond


@bare_kernel
def _image(hall: Hall, box: Box, e: int, x: float, y: float, reach: float, now: float) -> tuple[float, float]:
    """Which image of element e a centre touches, as what is added to its place [length]."""
    best, shift_x, shift_y = math.inf, 0.0, 0.0
    wide, high = (1 if box.periodic_x else 0), (1 if box.periodic_y else 0)
    for row in range(-high, high + 1):
        for column in range(-wide, wide + 1):
            off = _off(hall, e, x, y, column * box.width, row * box.height, reach, now)
            if off < best:
                best, shift_x, shift_y = off, column * box.width, row * box.height
    return shift_x, shift_y


@inlined_kernel
def _pass(tables: Tables, hall: Hall, book: Ledger, i: int, wall: int, along: bool, now: float) -> None:
    flight, link = tables.flight, tables.link
    vx, vy, mass = flight[i, VX], flight[i, VY], tables.mass[i]
    species, label = link[i, SPECIES], link[i, LABEL]
    carried = 0.0
    if hall.rule[wall, OPEN]:
        carried = 0.5 * mass * (vx * vx + vy * vy)
        link[i, SPECIES] = -1 - species
    book_crossing(book, species, label, wall, now, mass * vx, mass * vy, along, carried)


@bare_kernel
def meet(
    tables: Tables, box: Box, hall: Hall, book: Ledger, i: int, code: int, now: float, epoch: float
) -> int:
    """Execute the meeting of disc i with an element; its reference is that of `now` already.

    Parameters
    ----------
    code : how search told it: WALL - (2 * element + what happens)

    Returns
    -------
    The number of the wall if it is a piston that now moves in another way, otherwise -1. A disc that has left has
    a negative species.
    """
    flight, link = tables.flight, tables.link
    e, what = (WALL - code) // 2, (WALL - code) % 2
    wall, r = hall.kind[e, OWNER], flight[i, RADIUS]
    reach = _reach(hall, e, r, what)
    shift_x, shift_y = 0.0, 0.0
    if box.periodic_x or box.periodic_y:
        shift_x, shift_y = _image(hall, box, e, flight[i, X], flight[i, Y], reach, now)
    nx, ny, away = normal_at(hall, e, flight[i, X], flight[i, Y], shift_x, shift_y, now)
    flight[i, X] += (away - reach if hall.kind[e, KIND] == RIM else reach - away) * nx
    flight[i, Y] += (away - reach if hall.kind[e, KIND] == RIM else reach - away) * ny
    if what == PASS:
        front = _faces_front(hall, e, nx, ny)
        rate = flight[i, VX] * nx + flight[i, VY] * ny - speed(hall, wall, now) * (1.0 if front else -1.0)
        _pass(tables, hall, book, i, wall, (rate > 0.0) == front, epoch + now)
        return -1
    vx, vy, mass = flight[i, VX], flight[i, VY], tables.mass[i]
    result, species = hall.result, link[i, SPECIES]
    label = link[i, LABEL]
    if not rebound(hall, e, nx, ny, vx, vy, mass, r, int(book.id[label]), now, epoch, result):
        return -1
    flight[i, VX], flight[i, VY] = result[0], result[1]
    jx, jy = mass * (result[0] - vx), mass * (result[1] - vy)
    book_hall(book, species, label, wall, epoch + now, jx, jy, result)
    return wall if hall.wall[wall, MASS] > 0.0 else -1


@inlined_kernel
def _faces_front(hall: Hall, e: int, nx: float, ny: float) -> bool:
    """Whether (nx, ny) is the normal of side e, and not its opposite."""
    return nx * hall.shape[e, NX] + ny * hall.shape[e, NY] > 0.0
