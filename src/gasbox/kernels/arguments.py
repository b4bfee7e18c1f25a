"""What every dynamics kernel is given: the particles, the box, and the ledger it writes its collisions into."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.jit import inlined_kernel
from gasbox.state import Contacts, State, Tallies

__all__ = [
    "DONE",
    "FULL",
    "NO_PROGRESS",
    "Box",
    "Gas",
    "Ledger",
    "book_crossing",
    "book_hall",
    "book_pair",
    "book_wall",
    "box",
    "gas",
    "ledger",
]

DONE = 0
FULL = 1
NO_PROGRESS = 2

_PAIR = 0
_WALL = 1
_CROSSING = 2


class Gas(NamedTuple):
    """The particles; fields as in `gasbox.state.State`."""

    id: NDArray[np.int64]
    species: NDArray[np.int32]
    mass: NDArray[np.float64]
    radius: NDArray[np.float64]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]


class Box(NamedTuple):
    """The rectangle: sides [length] and which directions are periodic."""

    width: float
    height: float
    periodic_x: bool
    periodic_y: bool


class Ledger(NamedTuple):
    """Where executed collisions are booked: the arrays of `Tallies` and of `Contacts`, the rows in use, and all ids."""

    pair_virial: NDArray[np.float64]
    pair_collisions: NDArray[np.int64]
    wall_impulse: NDArray[np.float64]
    wall_collisions: NDArray[np.int64]
    wall_work: NDArray[np.float64]
    wall_heat: NDArray[np.float64]
    wall_passed: NDArray[np.int64]
    wall_carried: NDArray[np.float64]
    rest_energy: NDArray[np.float64]
    rows: NDArray[np.int64]
    kind: NDArray[np.uint8]
    time: NDArray[np.float64]
    first: NDArray[np.int64]
    second: NDArray[np.int64]
    impulse: NDArray[np.float64]
    id: NDArray[np.int64]


def gas(state: State) -> Gas:
    """The arrays of `state` as a kernel takes them (no copies)."""
    return Gas(state.id, state.species, state.mass, state.radius, state.position, state.velocity)


def box(geometry: Geometry) -> Box:
    """The rectangle, or the box around an enclosure, as a kernel takes it."""
    return Box(
        float(geometry.width), float(geometry.height), bool(geometry.periodic_x), bool(geometry.periodic_y)
    )


def ledger(tallies: Tallies, contacts: Contacts, rows: NDArray[np.int64], state: State) -> Ledger:
    """The ledger over the arrays of `tallies` and `contacts` (no copies); `rows` is (1,), how many are in use."""
    return Ledger(
        tallies.pair_virial,
        tallies.pair_collisions,
        tallies.wall_impulse,
        tallies.wall_collisions,
        tallies.wall_work,
        tallies.wall_heat,
        tallies.wall_passed,
        tallies.wall_carried,
        tallies.rest_energy,
        rows,
        contacts.kind,
        contacts.time,
        contacts.first,
        contacts.second,
        contacts.impulse,
        state.id,
    )


@inlined_kernel
def _write(book: Ledger, kind: int, time: float, first: int, second: int, jx: float, jy: float) -> None:
    row = book.rows[0]
    book.kind[row] = kind
    book.time[row] = time
    book.first[row] = first
    book.second[row] = second
    book.impulse[row, 0] = jx
    book.impulse[row, 1] = jy
    book.rows[0] = row + 1


@inlined_kernel
def book_pair(
    book: Ledger,
    species_i: int,
    species_j: int,
    row_i: int,
    row_j: int,
    time: float,
    jx: float,
    jy: float,
    virial: float,
) -> None:
    """Book a collision of two particles (row of i below row of j); (jx, jy) is the impulse given to i.

    Precondition: the buffer of contacts has a free row, or a capacity of zero.
    """
    book.pair_virial[0] += virial
    book.pair_collisions[min(species_i, species_j), max(species_i, species_j)] += 1
    if book.kind.shape[0] > 0:
        _write(book, _PAIR, time, book.id[row_i], book.id[row_j], jx, jy)


@inlined_kernel
def book_wall(book: Ledger, species: int, row: int, wall: int, time: float, jx: float, jy: float) -> None:
    """Book a collision with a wall; (jx, jy) is the impulse given to the particle.

    Precondition: as for `book_pair`.
    """
    book.wall_impulse[wall, species] += abs(jx) + abs(jy)
    book.wall_collisions[wall, species] += 1
    if book.kind.shape[0] > 0:
        _write(book, _WALL, time, book.id[row], wall, jx, jy)


@inlined_kernel
def book_hall(
    book: Ledger,
    species: int,
    row: int,
    wall: int,
    time: float,
    jx: float,
    jy: float,
    result: NDArray[np.float64],
) -> None:
    """Book a collision with a wall of an enclosure; (jx, jy) is the impulse given to the particle.

    result : as `gasbox.kernels.hall.rebound.rebound` leaves it

    Precondition: as for `book_pair`.
    """
    book.wall_impulse[wall, species] += result[2]
    book.wall_collisions[wall, species] += 1
    book.wall_work[wall, species] += result[3]
    book.wall_heat[wall, species] += result[4]
    book.rest_energy[0] += result[5]
    if book.kind.shape[0] > 0:
        _write(book, _WALL, time, book.id[row], wall, jx, jy)


@inlined_kernel
def book_crossing(
    book: Ledger,
    species: int,
    row: int,
    wall: int,
    time: float,
    px: float,
    py: float,
    along: bool,
    carried: float,
) -> None:
    """Book a particle that passes a wall, along its normal or against it.

    px, py : its momentum
    carried : its kinetic energy if it leaves the gas, otherwise 0

    Precondition: as for `book_pair`.
    """
    book.wall_passed[wall, species, 0 if along else 1] += 1
    book.wall_carried[wall, species] += carried
    if book.kind.shape[0] > 0:
        _write(book, _CROSSING, time, book.id[row], wall, px, py)
