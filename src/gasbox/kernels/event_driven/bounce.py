"""What happens at the elements of an enclosure: a disc bounces, passes and is counted, or leaves the gas."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Ledger, book_crossing, book_hall
from gasbox.kernels.event_driven.tables import LABEL, RADIUS, SPECIES, VX, VY, WALL, Tables, X, Y
from gasbox.kernels.hall import Hall
from gasbox.kernels.hall.approach import BOUNCE, PASS
from gasbox.kernels.hall.bodies import site_at
from gasbox.kernels.hall.body_rebound import rebound_body
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
from gasbox.kernels.molecules.impulse import lever
from gasbox.kernels.molecules.spin import (
    ANGLE,
    ARM,
    INERTIA,
    SITE_RADIUS,
    SITE_X,
    SITE_Y,
    TURNING,
    Spin,
    is_disc,
)

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
def _pass(
    tables: Tables,
    hall: Hall,
    spin: Spin | None,
    book: Ledger,
    i: int,
    wall: int,
    along: bool,
    now: float,
) -> None:
    flight, link = tables.flight, tables.link
    vx, vy, mass = flight[i, VX], flight[i, VY], tables.mass[i]
    species, label = link[i, SPECIES], link[i, LABEL]
    carried = 0.0
    if hall.rule[wall, OPEN]:
        carried = 0.5 * mass * (vx * vx + vy * vy) + _energy_of_turning(spin, i)
        link[i, SPECIES] = -1 - species
    book_crossing(book, species, label, wall, now, mass * vx, mass * vy, along, carried)


@inlined_kernel
def _energy_of_turning(spin: Spin | None, i: int) -> float:
    if spin is None:
        return 0.0
    return 0.5 * spin.turn[i, INERTIA] * spin.turn[i, TURNING] * spin.turn[i, TURNING]


@inlined_kernel
def _is_body(spin: Spin | None, species: int) -> bool:
    if spin is None:
        return False
    return not is_disc(spin, species)


@inlined_kernel
def _bounce_body(
    tables: Tables,
    box: Box,
    hall: Hall,
    spin: Spin | None,
    book: Ledger,
    i: int,
    e: int,
    now: float,
    epoch: float,
) -> int:
    """As `meet`, for a molecule; nothing happens if it touches nothing yet."""
    if spin is None:
        return -1
    return _meet_body(tables, box, hall, spin, book, i, e, now, epoch)


@bare_kernel
def _meet_body(
    tables: Tables,
    box: Box,
    hall: Hall,
    spin: Spin,
    book: Ledger,
    i: int,
    e: int,
    now: float,
    epoch: float,
) -> int:
    flight, turn, wall = tables.flight, spin.turn, hall.kind[e, OWNER]
    species, label, mass = tables.link[i, SPECIES], tables.link[i, LABEL], tables.mass[i]
    x, y, vx, vy, r = flight[i, X], flight[i, Y], flight[i, VX], flight[i, VY], flight[i, RADIUS]
    angle, omega, arm = turn[i, ANGLE], turn[i, TURNING], turn[i, ARM]
    best = (math.inf, 0.0, 0.0, 0.0, 0)
    wide, high = (1 if box.periodic_x else 0), (1 if box.periodic_y else 0)
    for row in range(-high, high + 1):
        for column in range(-wide, wide + 1):
            aside = (column * box.width, row * box.height)
            found = site_at(
                hall, spin, e, (x, y, vx, vy, now, r), species, angle, omega, arm, aside[0], aside[1]
            )
            if found[0] < best[0]:
                best = found
    if best[0] == math.inf:
        return -1
    _, nx, ny, closing, k = best
    cos, sin = math.cos(angle), math.sin(angle)
    arm_x = cos * spin.site[k, SITE_X] - sin * spin.site[k, SITE_Y]
    arm_y = sin * spin.site[k, SITE_X] + cos * spin.site[k, SITE_Y]
    flight[i, VX], flight[i, VY], turn[i, TURNING] = rebound_body(
        hall,
        e,
        nx,
        ny,
        (vx, vy, omega),
        closing,
        lever(arm_x, arm_y, nx, ny),
        mass,
        turn[i, INERTIA],
        spin.site[k, SITE_RADIUS],
        int(book.id[label]),
        now,
        epoch,
    )
    jx, jy = mass * (flight[i, VX] - vx), mass * (flight[i, VY] - vy)
    book_hall(book, species, label, wall, epoch + now, jx, jy, hall.result)
    return wall if hall.wall[wall, MASS] > 0.0 else -1


@bare_kernel
def meet(
    tables: Tables,
    box: Box,
    hall: Hall,
    spin: Spin | None,
    book: Ledger,
    i: int,
    code: int,
    now: float,
    epoch: float,
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
    if _is_body(spin, link[i, SPECIES]) and what == BOUNCE:
        return _bounce_body(tables, box, hall, spin, book, i, e, now, epoch)
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
        _pass(tables, hall, spin, book, i, wall, (rate > 0.0) == front, epoch + now)
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
