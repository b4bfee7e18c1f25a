"""Walls that discs pass, and those through which they leave."""

from __future__ import annotations

from gasbox.jit import inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger, book_crossing
from gasbox.kernels.forced.tables import Atoms
from gasbox.kernels.forced.wall_tables import Walls, seen
from gasbox.kernels.hall.sides import passes
from gasbox.kernels.hall.tables import FACES, HIGH, KIND, LOW, NX, NY, OPEN, SIDE, TX, TY, WALL

__all__ = ["cross", "lets_pass", "note_places"]


@inlined_kernel
def note_places(walls: Walls, atoms: Atoms, begin: int, end: int) -> None:
    """Remember where atoms are before a step, if that will be asked for."""
    for k in range(begin, min(end, walls.was_x.shape[0])):
        walls.was_x[k], walls.was_y[k] = atoms.x[k], atoms.y[k]


@inlined_kernel
def lets_pass(walls: Walls, e: int, species: int, vx: float, vy: float) -> bool:
    """Whether a disc with this velocity passes element e; at the end of a wall it has no direction."""
    hall = walls.hall
    number, nx, ny = hall.kind[e, WALL], hall.shape[e, NX], hall.shape[e, NY]
    ux, uy = vx - nx * walls.rate[number], vy - ny * walls.rate[number]
    along = ux * nx + uy * ny if hall.kind[e, KIND] == SIDE else 0.0
    return passes(hall, number, species, ux, uy, along)


@inlined_kernel
def cross(
    walls: Walls, entry: int, atoms: Atoms, gas: Gas, box: Box, book: Ledger, time: float, time_step: float
) -> None:
    """Book the disc of one entry of the list if its centre has got to the other side; through an open wall it leaves.

    Velocities are those of the middle of the step; half a kick more makes them those of its end.
    """
    hall, k, e = walls.hall, walls.near[entry, 0], walls.near[entry, 1]
    row, number = atoms.row[k], hall.kind[e, WALL]
    leaves = hall.rule[number, OPEN] != 0
    if hall.kind[e, KIND] != SIDE or not (leaves or hall.passes[number, gas.species[row]]):
        return
    x, y = seen(walls, entry, walls.earlier, walls.was_x[k], walls.was_y[k], box)
    to_x, to_y = seen(walls, entry, walls.place, atoms.x[k], atoms.y[k], box)
    nx, ny, tx, ty = hall.shape[e, NX], hall.shape[e, NY], hall.shape[e, TX], hall.shape[e, TY]
    height, to = x * nx + y * ny, to_x * nx + to_y * ny
    if (height >= 0.0) == (to >= 0.0) or walls.gone[row]:
        return
    forward = to >= 0.0
    if hall.kind[e, FACES] != 0 and forward == (hall.kind[e, FACES] > 0):
        return
    foot = x * tx + y * ty
    foot += height / (height - to) * (to_x * tx + to_y * ty - foot)
    if not hall.shape[e, LOW] <= foot <= hall.shape[e, HIGH]:
        return
    px = atoms.mass[k] * atoms.vx[k] + 0.5 * time_step * atoms.fx[k]
    py = atoms.mass[k] * atoms.vy[k] + 0.5 * time_step * atoms.fy[k]
    carried = 0.0
    if leaves:
        carried = 0.5 * (px * px + py * py) / atoms.mass[k]
        walls.gone[row] = 1
        walls.left[0] += 1
    book_crossing(book, gas.species[row], row, number, time, px, py, forward, carried)
