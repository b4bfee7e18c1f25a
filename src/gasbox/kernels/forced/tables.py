"""What the kernels of the forced rule work on."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.state import State, Tallies

__all__ = [
    "BLOCK",
    "Atoms",
    "Books",
    "Lists",
    "Room",
    "Slots",
    "Strips",
    "Terms",
    "atoms",
    "books",
    "lists",
    "room",
    "slots",
    "strips",
]

# Columns of `Terms.value`.
A, B, C, D, CUT2, CUT, U_CUT, F_CUT = range(8)
# Laws.
INVERSE_POWERS, SCREENED, WELL = range(3)

# Columns of `Room.sums`: mass, momentum, kinetic energy, potential energy, virial, and heat of a Langevin thermostat.
MASS, PX, PY, KINETIC, POTENTIAL, VIRIAL, HEAT = range(7)

BLOCK = 64
"""Atoms that are summed up together, whatever the number of threads."""
FAR = 1e9
"""Where empty slots lie, in lengths of the box: beyond every cutoff."""


class Terms(NamedTuple):
    """The table of pair laws; what acts between two discs is the sum of all terms.

    Attributes
    ----------
    law : (terms,) int64, which function of `gasbox.kernels.forced.laws`
    shifted : (terms,) bool, whether the force is shifted to zero at the cutoff, too
    value : (terms, 8, species * species) float64: four parameters of the law, square of the cutoff (0: the term does
        not act on this pair), the cutoff, and potential and force there
    species : number of species
    reach : largest cutoff [length]
    """

    law: NDArray[np.int64]
    shifted: NDArray[np.bool_]
    value: NDArray[np.float64]
    species: int
    reach: float


class Atoms(NamedTuple):
    """All discs, sorted in space: strip by strip, from left to right. Arrays are longer than n, for whole lanes.

    Attributes
    ----------
    row : (n+,) int32, row in the state
    species : (n+,) int32
    mass : (n+,) float64; rate : 1/mass, 0 beyond n
    x, y, vx, vy : (n+,) float64; places may lie a little outside a periodic box
    fx, fy : (n+,) float64, force at the present place
    bx, by : (n+,) float64, places at which the lists were made
    u, w : (n+,) float64, half of the potential energy and of the virial of all pairs of this disc, where measured
    """

    row: NDArray[np.int32]
    species: NDArray[np.int32]
    mass: NDArray[np.float64]
    rate: NDArray[np.float64]
    x: NDArray[np.float64]
    y: NDArray[np.float64]
    vx: NDArray[np.float64]
    vy: NDArray[np.float64]
    fx: NDArray[np.float64]
    fy: NDArray[np.float64]
    bx: NDArray[np.float64]
    by: NDArray[np.float64]
    u: NDArray[np.float64]
    w: NDArray[np.float64]


class Slots(NamedTuple):
    """Places that lists point into: all discs and their periodic images, sorted; empty ones end each strip.

    Attributes
    ----------
    x, y : (m+,) float64
    source : (m+,) int32, of which atom
    sx, sy : (m+,) float64, shift of the image
    species : (m+,) int32
    size : (1,) int64, how many are in use
    molecule : (m+,) float64, the same number for discs of one molecule, another one for its images; (0,) without any
    """

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    source: NDArray[np.int32]
    sx: NDArray[np.float64]
    sy: NDArray[np.float64]
    species: NDArray[np.int32]
    size: NDArray[np.int64]
    molecule: NDArray[np.float64]


class Lists(NamedTuple):
    """Neighbours: for each atom the slots at which eight of them begin, at least one of which is near.

    Attributes
    ----------
    home : (n+,) int32, the atom's own slot
    first, last : (n+,) int64, its part of `start`
    start : (room,) int32
    """

    home: NDArray[np.int32]
    first: NDArray[np.int64]
    last: NDArray[np.int64]
    start: NDArray[np.int32]


class Strips(NamedTuple):
    """How the box is divided into strips along x, and where each lies among atoms and slots.

    Attributes
    ----------
    shape : (2,) int64, strips of the box; and of images below and above it, which is also how many away neighbours are
    first : (strips + 1,) int64, first atom of each
    slot : (strips with images, 2) int64, first slot of each, and one past its last disc
    place : (threads, strips) int64, room: where in each strip an atom's neighbours begin
    """

    shape: NDArray[np.int64]
    first: NDArray[np.int64]
    slot: NDArray[np.int64]
    place: NDArray[np.int64]


class Room(NamedTuple):
    """What threads share, and space for sorting.

    Attributes
    ----------
    stage : (2,) int64, what comes next within the step; number of discs
    size : (2,) float64 [length], width and height of the box
    order : (n+,) int32; spare : (n+,) float64
    far : (threads,) float64, square of the largest way of each thread's atoms
    full : (threads + 1,) int64, whether the room of each thread was too short, or that of all
    sums : (blocks, 7) float64
    before : (3,) float64, energy before the area was changed, by what lengths are multiplied, and the area before
    """

    stage: NDArray[np.int64]
    size: NDArray[np.float64]
    order: NDArray[np.int32]
    spare: NDArray[np.float64]
    far: NDArray[np.float64]
    full: NDArray[np.int64]
    sums: NDArray[np.float64]
    before: NDArray[np.float64]


class Books(NamedTuple):
    """Where energies are booked: arrays (1,) of `gasbox.state.Tallies`, and (3,) the energies at present.

    Attributes
    ----------
    now : potential energy, virial, kinetic energy
    """

    pair_virial: NDArray[np.float64]
    kinetic_time: NDArray[np.float64]
    potential_time: NDArray[np.float64]
    area_time: NDArray[np.float64]
    measured_time: NDArray[np.float64]
    rotational_time: NDArray[np.float64]
    vibrational_time: NDArray[np.float64]
    thermostat_heat: NDArray[np.float64]
    heater_heat: NDArray[np.float64]
    barostat_work: NDArray[np.float64]
    now: NDArray[np.float64]


def books(tallies: Tallies) -> Books:
    """The books over the arrays of tallies (no copies)."""
    return Books(
        tallies.pair_virial,
        tallies.kinetic_time,
        tallies.potential_time,
        tallies.area_time,
        tallies.measured_time,
        tallies.rotational_time,
        tallies.vibrational_time,
        tallies.thermostat_heat,
        tallies.heater_heat,
        tallies.barostat_work,
        np.zeros(3),
    )


def _padded(count: int) -> int:
    return (count // BLOCK + 1) * BLOCK


def atoms(state: State, held: NDArray[np.bool_]) -> Atoms:
    """Room for all discs of a state, in the order of its rows; those `held` (n,) have no motion of their own."""
    n = state.count
    size = _padded(n)

    def column(values: NDArray[np.float64] | float = 0.0) -> NDArray[np.float64]:
        array = np.zeros(size)
        array[:n] = values
        return array

    row, species = np.zeros(size, np.int32), np.zeros(size, np.int32)
    row[:n], species[:n] = np.arange(n), state.species
    x, y = state.position.T if n else (0.0, 0.0)
    vx, vy = np.where(held, 0.0, state.velocity.T) if n else (0.0, 0.0)
    return Atoms(
        row,
        species,
        column(state.mass),
        column(np.where(held, 0.0, 1.0 / state.mass)),
        *(column(values) for values in (x, y, vx, vy)),
        *(column() for _ in range(6)),
    )


def strips(height: float, reach: float, thickness: float, threads: int) -> Strips:
    """Room for strips of about this thickness in a box of this height, with images."""
    most = int(1.5 * height / thickness) + 4
    more = int(2.0 * reach / min(thickness, height)) + 2
    return Strips(
        np.zeros(2, np.int64),
        np.zeros(most + 1, np.int64),
        np.zeros((most + 2 * more, 2), np.int64),
        np.zeros((threads, 2 * more + 1), np.int64),
    )


def room(count: int, size: tuple[float, float], threads: int) -> Room:
    """For so many atoms in a box of this size."""
    padded = _padded(count)
    return Room(
        np.array([0, count], np.int64),
        np.array(size, np.float64),
        np.zeros(padded, np.int32),
        np.zeros(padded),
        np.zeros(threads),
        np.zeros(threads + 1, np.int64),
        np.zeros((padded // BLOCK, 7)),
        np.zeros(3),
    )


def slots(room: int, in_molecules: bool) -> Slots:
    """Room for so many slots."""
    return Slots(
        np.zeros(room),
        np.zeros(room),
        np.zeros(room, np.int32),
        np.zeros(room),
        np.zeros(room),
        np.zeros(room, np.int32),
        np.zeros(1, np.int64),
        np.zeros(room if in_molecules else 0),
    )


def lists(count: int, room: int) -> Lists:
    """Lists for so many atoms with room for so many entries."""
    size = _padded(count)
    return Lists(
        np.zeros(size, np.int32), np.zeros(size, np.int64), np.zeros(size, np.int64), np.zeros(room, np.int32)
    )
