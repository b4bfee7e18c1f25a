"""Collisions of two particles, and of discs with the sides of a plain rectangle."""

from __future__ import annotations

import math

import numpy as np

from gasbox.jit import inlined_kernel
from gasbox.kernels.arguments import Box, Ledger, book_pair, book_wall
from gasbox.kernels.collision import exchange
from gasbox.kernels.event_driven.flight import note_speed, place_at, velocity_at
from gasbox.kernels.event_driven.knock import knock
from gasbox.kernels.event_driven.tables import (
    LABEL,
    RADIUS,
    SPECIES,
    T0,
    VX,
    VY,
    Tables,
    X,
    Y,
)
from gasbox.kernels.hall import Hall
from gasbox.kernels.molecules.spin import Spin, is_disc, turn_to

__all__ = ["bounce", "collide", "refer"]


@inlined_kernel
def refer(tables: Tables, box: Box, hall: Hall | None, spin: Spin | None, i: int, now: float) -> None:
    """Make `now` the reference time of particle i: its position then, inside the box where it is periodic."""
    flight = tables.flight
    elapsed = now - flight[i, T0]
    turn_to(spin, i, elapsed)
    x, y = place_at(flight, hall, i, elapsed)
    if hall is not None:
        flight[i, VX], flight[i, VY] = velocity_at(flight, hall, i, elapsed)
    if box.periodic_x:
        x -= math.floor(x / box.width) * box.width
    if box.periodic_y:
        y -= math.floor(y / box.height) * box.height
    flight[i, X] = x
    flight[i, Y] = y
    flight[i, T0] = now


@inlined_kernel
def _are_bodies(tables: Tables, spin: Spin | None, i: int, j: int) -> bool:
    """Whether one of two particles is made of several discs."""
    if spin is None:
        return False
    return not (is_disc(spin, tables.link[i, SPECIES]) and is_disc(spin, tables.link[j, SPECIES]))


@inlined_kernel
def _collide_bodies(
    tables: Tables,
    box: Box,
    spin: Spin | None,
    book: Ledger,
    i: int,
    j: int,
    now: float,
    epoch: float,
) -> None:
    """As `collide`, of molecules; if nothing touches yet, they look again from here."""
    if spin is None:
        return
    jx, jy, virial = knock(tables, spin, box, i, j)
    if jx == 0.0 and jy == 0.0:
        return
    note_speed(tables.flight, tables.number, i)
    note_speed(tables.flight, tables.number, j)
    link = tables.link
    book_pair(
        book,
        link[i, SPECIES],
        link[j, SPECIES],
        link[i, LABEL],
        link[j, LABEL],
        epoch + now,
        jx,
        jy,
        virial,
    )


@inlined_kernel
def collide(
    tables: Tables,
    box: Box,
    hall: Hall | None,
    spin: Spin | None,
    book: Ledger,
    i: int,
    j: int,
    now: float,
    epoch: float,
) -> None:
    """Execute the collision of i and j (label of i below that of j); if rounding finds them parting, let them pass."""
    flight = tables.flight
    refer(tables, box, hall, spin, i, now)
    refer(tables, box, hall, spin, j, now)
    if _are_bodies(tables, spin, i, j):
        _collide_bodies(tables, box, spin, book, i, j, now, epoch)
        return
    dx, dy = flight[i, X] - flight[j, X], flight[i, Y] - flight[j, Y]
    if box.periodic_x:
        dx -= box.width * np.rint(dx / box.width)
    if box.periodic_y:
        dy -= box.height * np.rint(dy / box.height)
    dvx, dvy = flight[i, VX] - flight[j, VX], flight[i, VY] - flight[j, VY]
    if dvx * dx + dvy * dy >= 0.0:
        return
    change_i, change_j, impulse, virial = exchange(dx, dy, dvx, dvy, tables.mass[i], tables.mass[j])
    flight[i, VX] -= change_i * dx
    flight[i, VY] -= change_i * dy
    flight[j, VX] += change_j * dx
    flight[j, VY] += change_j * dy
    note_speed(flight, tables.number, i)
    note_speed(flight, tables.number, j)
    link = tables.link
    book_pair(
        book,
        link[i, SPECIES],
        link[j, SPECIES],
        link[i, LABEL],
        link[j, LABEL],
        epoch + now,
        -impulse * dx,
        -impulse * dy,
        virial,
    )


@inlined_kernel
def bounce(tables: Tables, box: Box, book: Ledger, i: int, wall: int, now: float, epoch: float) -> None:
    """Execute the collision of disc i with a wall, and put it exactly on it."""
    flight = tables.flight
    species, label = tables.link[i, SPECIES], tables.link[i, LABEL]
    refer(tables, box, None, None, i, now)
    if wall < 2:
        flight[i, X] = flight[i, RADIUS] if wall == 0 else box.width - flight[i, RADIUS]
        flight[i, VX] = -flight[i, VX]
        book_wall(book, species, label, wall, epoch + now, 2.0 * tables.mass[i] * flight[i, VX], 0.0)
    else:
        flight[i, Y] = flight[i, RADIUS] if wall == 2 else box.height - flight[i, RADIUS]
        flight[i, VY] = -flight[i, VY]
        book_wall(book, species, label, wall, epoch + now, 0.0, 2.0 * tables.mass[i] * flight[i, VY])
