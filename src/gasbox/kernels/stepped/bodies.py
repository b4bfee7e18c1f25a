"""Molecules as rigid bodies, whose sites are what the rest of the stepped rule knows as discs.

With bodies, the rows of grid, slots and lists are those of the sites, and each step begins with slots in their order.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas
from gasbox.kernels.stepped.bounce import parked
from gasbox.kernels.stepped.tables import Slots, Walls
from gasbox.kernels.team import share
from gasbox.state import State

__all__ = [
    "BOUNCES",
    "CHANGED",
    "CUT_SHORT",
    "DEEP",
    "DEEPEST",
    "HELD_BACK",
    "SWEEP",
    "Bodies",
    "bodies",
    "carry",
    "is_single",
    "no_mishaps",
    "show_bodies",
    "site_gas",
    "turn_arms",
    "wrap_site",
]

SWEEP, CHANGED, BOUNCES = range(3)
"""Columns of the cursor: how far the execution of a step is."""
DEEP, CUT_SHORT, HELD_BACK = range(3)
"""Columns of `mishaps`: contacts of sites deeper than the smaller radius; jams in which some were left approaching; and
molecules held back at a wall that they would have got across."""
DEEPEST = 0
"""Column of `worst`: depth of the deepest contact over the smaller radius."""
_TURN = 2.0 * math.pi


class Bodies(NamedTuple):
    """Particles (n) and their sites (m).

    Attributes
    ----------
    first : (n + 1,) int64, first site of each; owner : (m,) int32, whose site it is
    place : (m, 2) float64, where a site stands in its body at angle 0 [length]
    arm : (m, 2) float64, where it stands now, seen from the centre of mass [length]
    mass, inertia, angle, spin : (n,) float64 [mass], [mass·length²], [rad], [rad/time]
    position, velocity : (n, 2) float64, of the centre of mass [length], [length/time]
    before : (n, 3) float64, position and angle at the begin of the step; unwrapped, so that the way is straight
    fallen : (2,) float64, what gravity has added to velocities in this step [length/time]
    cursor : (3,) int64, how far the execution is: sweep, whether anything collided in it, bounces of one body
    mishaps : (3,) int64; worst : (1,) float64; what went wrong so far, see the columns above
    """

    first: NDArray[np.int64]
    owner: NDArray[np.int32]
    place: NDArray[np.float64]
    arm: NDArray[np.float64]
    mass: NDArray[np.float64]
    inertia: NDArray[np.float64]
    angle: NDArray[np.float64]
    spin: NDArray[np.float64]
    position: NDArray[np.float64]
    velocity: NDArray[np.float64]
    before: NDArray[np.float64]
    fallen: NDArray[np.float64]
    cursor: NDArray[np.int64]
    mishaps: NDArray[np.int64]
    worst: NDArray[np.float64]


def no_mishaps() -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Books of what goes wrong, `mishaps` and `worst`, with nothing in them yet."""
    return np.zeros(3, np.int64), np.zeros(1)


def bodies(state: State, mishaps: NDArray[np.int64], worst: NDArray[np.float64]) -> Bodies | None:
    """The particles of `state` over its own arrays, with these books of what goes wrong; None if all are discs."""
    sites, n = state.sites, state.count
    if sites is None or sites.count == n:
        return None
    made = Bodies(
        sites.first,
        sites.owner.astype(np.int32),
        sites.place,
        np.zeros_like(sites.place),
        state.mass,
        state.inertia,
        state.angle,
        state.angular_velocity,
        state.position,
        state.velocity,
        np.zeros((n, 3)),
        np.zeros(2),
        np.zeros(3, np.int64),
        mishaps,
        worst,
    )
    _turn_all(made)
    return made


def site_gas(state: State) -> Gas:
    """All sites as a kernel takes discs: with the id and the species of their particles, and the mass of these."""
    sites = state.sites
    assert sites is not None
    owner = sites.owner
    return Gas(
        state.id[owner],
        state.species[owner],
        state.mass[owner],
        sites.radius,
        sites.position,
        sites.velocity,
    )


@inlined_kernel
def is_single(bodies: Bodies, row: int) -> bool:
    """Whether a body is a single disc, which collides as discs do."""
    return bodies.first[row + 1] - bodies.first[row] == 1


@bare_kernel
def turn_arms(bodies: Bodies, row: int) -> None:
    """Turn the sites of a body to its angle."""
    cos, sin = math.cos(bodies.angle[row]), math.sin(bodies.angle[row])
    for site in range(bodies.first[row], bodies.first[row + 1]):
        x, y = bodies.place[site, 0], bodies.place[site, 1]
        bodies.arm[site, 0] = cos * x - sin * y
        bodies.arm[site, 1] = sin * x + cos * y


@bare_kernel
def _turn_all(bodies: Bodies) -> None:
    for row in range(bodies.mass.shape[0]):
        turn_arms(bodies, row)


@inlined_kernel
def _turn(bodies: Bodies, row: int, time_step: float) -> None:
    """Let a body rotate for a step; its angle stays within half a turn."""
    angle = bodies.angle[row] + bodies.spin[row] * time_step
    if not abs(angle) <= math.pi:
        angle -= _TURN * math.floor(angle / _TURN + 0.5)
    bodies.angle[row] = angle
    turn_arms(bodies, row)


@inlined_kernel
def _wrapped(place: float, length: float, periodic: bool) -> float:
    return place - math.floor(place / length) * length if periodic else place


@bare_kernel
def carry(
    bodies: Bodies, slots: Slots, box: Box, walls: Walls | None, time_step: float, thread: int, threads: int
) -> None:
    """Move this thread's share of the bodies, and put their sites where they are, in their own order."""
    begin, end = share(bodies.mass.shape[0], thread, threads)
    if walls is not None and thread == 0:
        bodies.fallen[0], bodies.fallen[1] = walls.hall.gx * time_step, walls.hall.gy * time_step
    for row in range(begin, end):
        if walls is not None:
            _fly(bodies, row, slots, box, walls, time_step)
            continue
        x = bodies.position[row, 0] + bodies.velocity[row, 0] * time_step
        y = bodies.position[row, 1] + bodies.velocity[row, 1] * time_step
        x, y = _wrapped(x, box.width, box.periodic_x), _wrapped(y, box.height, box.periodic_y)
        bodies.position[row, 0], bodies.position[row, 1] = x, y
        first = bodies.first[row]
        if is_single(bodies, row):
            slots.x[first], slots.y[first] = x, y
            slots.vx[first], slots.vy[first] = bodies.velocity[row, 0], bodies.velocity[row, 1]
            continue
        _turn(bodies, row, time_step)
        for site in range(first, bodies.first[row + 1]):
            slots.x[site] = _wrapped(x + bodies.arm[site, 0], box.width, box.periodic_x)
            slots.y[site] = _wrapped(y + bodies.arm[site, 1], box.height, box.periodic_y)


@inlined_kernel
def _shift(place: float, length: float, periodic: bool) -> float:
    """What brings a place back into a periodic box."""
    return math.floor(place / length) * length if periodic and not 0.0 <= place < length else 0.0


@bare_kernel
def _fly(bodies: Bodies, row: int, slots: Slots, box: Box, walls: Walls, time_step: float) -> None:
    """Move one body in an enclosure, on an exact parabola, and note where it and its sites came from."""
    first, last = bodies.first[row], bodies.first[row + 1]
    if walls.gone[first]:
        slots.x[first] = parked(first, box)
        return
    gx, gy = walls.hall.gx, walls.hall.gy
    x, y, vx, vy = (
        bodies.position[row, 0],
        bodies.position[row, 1],
        bodies.velocity[row, 0],
        bodies.velocity[row, 1],
    )
    to_x = x + vx * time_step + 0.5 * gx * time_step * time_step
    to_y = y + vy * time_step + 0.5 * gy * time_step * time_step
    shift_x, shift_y = _shift(to_x, box.width, box.periodic_x), _shift(to_y, box.height, box.periodic_y)
    to_x, to_y, x, y = to_x - shift_x, to_y - shift_y, x - shift_x, y - shift_y
    bodies.before[row, 0], bodies.before[row, 1], bodies.before[row, 2] = x, y, bodies.angle[row]
    bodies.position[row, 0], bodies.position[row, 1] = to_x, to_y
    vx += gx * time_step
    vy += gy * time_step
    bodies.velocity[row, 0], bodies.velocity[row, 1] = vx, vy
    if last - first == 1:
        slots.vx[first], slots.vy[first] = vx, vy
    for site in range(first, last):
        walls.before[site, 0] = x + bodies.arm[site, 0]
        walls.before[site, 1] = y + bodies.arm[site, 1]
    if last - first > 1:
        _turn(bodies, row, time_step)
    for site in range(first, last):
        slots.x[site] = to_x + bodies.arm[site, 0]
        slots.y[site] = to_y + bodies.arm[site, 1]
        wrap_site(site, site, slots, box, walls)


@inlined_kernel
def wrap_site(site: int, slot: int, slots: Slots, box: Box, walls: Walls) -> None:
    """Bring a site back into a periodic box, together with the begin of its way."""
    shift_x = _shift(slots.x[slot], box.width, box.periodic_x)
    shift_y = _shift(slots.y[slot], box.height, box.periodic_y)
    slots.x[slot] -= shift_x
    slots.y[slot] -= shift_y
    walls.before[site, 0] -= shift_x
    walls.before[site, 1] -= shift_y


@bare_kernel
def show_bodies(bodies: Bodies, gas: Gas, walls: Walls | None, thread: int, threads: int) -> None:
    """Write the sites of this thread's share of the bodies into the state."""
    begin, end = share(bodies.mass.shape[0], thread, threads)
    for row in range(begin, end):
        if walls is not None and walls.gone[bodies.first[row]]:
            continue
        spin = bodies.spin[row]
        for site in range(bodies.first[row], bodies.first[row + 1]):
            x, y = bodies.arm[site, 0], bodies.arm[site, 1]
            gas.position[site, 0] = bodies.position[row, 0] + x
            gas.position[site, 1] = bodies.position[row, 1] + y
            gas.velocity[site, 0] = bodies.velocity[row, 0] - spin * y
            gas.velocity[site, 1] = bodies.velocity[row, 1] + spin * x
