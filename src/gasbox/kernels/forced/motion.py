"""Velocity Verlet, phase by phase: kick, drift; eight atoms at a time.

Source: W. C. Swope, H. C. Andersen, P. H. Berens, K. R. Wilson, J. Chem. Phys. 76, 637 (1982), doi:10.1063/1.442716.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas
from gasbox.kernels.forced.tables import Atoms, Slots
from gasbox.kernels.lanes import WIDTH, choose, load, spread, store, total

__all__ = ["drift", "furthest", "inside", "kick", "publish", "scale", "show"]


@bare_kernel
def kick(atoms: Atoms, time: float, begin: int, end: int) -> None:
    """Change velocities by force/mass * time. begin, end : multiples of WIDTH."""
    for k in range(begin, end, WIDTH):
        rate = load(atoms.rate, k) * time
        store(atoms.vx, k, load(atoms.vx, k) + load(atoms.fx, k) * rate)
        store(atoms.vy, k, load(atoms.vy, k) + load(atoms.fy, k) * rate)


@bare_kernel
def drift(atoms: Atoms, time: float, begin: int, end: int) -> None:
    """Change places by velocity * time. begin, end : multiples of WIDTH."""
    for k in range(begin, end, WIDTH):
        store(atoms.x, k, load(atoms.x, k) + load(atoms.vx, k) * time)
        store(atoms.y, k, load(atoms.y, k) + load(atoms.vy, k) * time)


@bare_kernel
def furthest(atoms: Atoms, begin: int, end: int) -> float:
    """Square of the largest way from where the lists were made; infinite if a place is no number."""
    if begin >= end:
        return 0.0
    most, wrong = spread(0.0), spread(0.0)
    for k in range(begin, end, WIDTH):
        dx, dy = load(atoms.x, k) - load(atoms.bx, k), load(atoms.y, k) - load(atoms.by, k)
        square = dx * dx + dy * dy
        most = choose(square < most, most, square)
        # Stays zero as long as all are numbers.
        wrong = wrong + (square - square)
    if total(wrong) != 0.0:
        return math.inf
    store(atoms.u, begin, most)
    largest = 0.0
    for lane in range(WIDTH):
        largest = max(largest, atoms.u[begin + lane])
    return largest


@bare_kernel
def publish(atoms: Atoms, slots: Slots, begin: int, end: int) -> None:
    """Bring slots `begin` to `end` to where their atoms are now."""
    for m in range(begin, end):
        k = slots.source[m]
        slots.x[m] = atoms.x[k] + slots.sx[m]
        slots.y[m] = atoms.y[k] + slots.sy[m]


@bare_kernel
def scale(atoms: Atoms, by: float, begin: int, end: int) -> None:
    """Multiply places by a factor and divide velocities by it. begin, end : multiples of WIDTH."""
    for k in range(begin, end, WIDTH):
        store(atoms.x, k, load(atoms.x, k) * by)
        store(atoms.y, k, load(atoms.y, k) * by)
        store(atoms.vx, k, load(atoms.vx, k) / by)
        store(atoms.vy, k, load(atoms.vy, k) / by)


@inlined_kernel
def inside(place: float, length: float) -> float:
    """A place brought into [0, length), so that doing it twice changes nothing."""
    place -= math.floor(place / length) * length
    return place - length if place >= length else place


@bare_kernel
def show(atoms: Atoms, gas: Gas, box: Box, begin: int, end: int) -> None:
    """Write places, inside a periodic box, and velocities of atoms `begin` to `end` into the state."""
    for k in range(begin, end):
        row = atoms.row[k]
        gas.position[row, 0] = inside(atoms.x[k], box.width) if box.periodic_x else atoms.x[k]
        gas.position[row, 1] = inside(atoms.y[k], box.height) if box.periodic_y else atoms.y[k]
        gas.velocity[row, 0], gas.velocity[row, 1] = atoms.vx[k], atoms.vy[k]
