"""Lists of neighbours made anew, and all that a run must know before its first step."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import DONE, Box, Gas, Ledger
from gasbox.kernels.forced.bath import Bath, sum_atoms, sum_blocks
from gasbox.kernels.forced.motion import publish
from gasbox.kernels.forced.push import push
from gasbox.kernels.forced.sort import divide, lay_out, list_neighbours, sort_atoms, wrap
from gasbox.kernels.forced.tables import Books, Crowd, Terms
from gasbox.kernels.forced.walls import Walls, list_walls, push_back

__all__ = ["GROW", "Rule", "box_of", "list_share", "prepare", "sort_all"]

GROW = 20
"""Status: lists or slots are too short; give longer ones and call again."""


class Rule(NamedTuple):
    """Numbers that stay the same.

    Attributes
    ----------
    time_step : [time]
    skin : by which lists reach beyond the largest cutoff [length]
    most : way in one step that is too long [length]
    periodic_x, periodic_y : of the box
    gx, gy : acceleration of all discs [length/time²]
    """

    time_step: float
    skin: float
    most: float
    periodic_x: bool
    periodic_y: bool
    gx: float
    gy: float


@inlined_kernel
def box_of(crowd: Crowd, rule: Rule) -> Box:
    """The box as it is now."""
    return Box(crowd.room.size[0], crowd.room.size[1], rule.periodic_x, rule.periodic_y)


@bare_kernel
def sort_all(crowd: Crowd, terms: Terms, rule: Rule, gas: Gas, walls: Walls | None) -> int:
    """Bring all atoms back into the box, sort them and lay out the slots; 0, or 1 if room is short."""
    atoms, slots, lists, strips, room = crowd
    n, reach, box = room.stage[1], terms.reach + rule.skin, box_of(crowd, rule)
    wrap(atoms, box, 0, n)
    if not divide(strips, box, reach):
        return 1
    sort_atoms(atoms, box, strips, room)
    if walls is not None and not list_walls(walls, atoms, gas, box, n, rule.skin):
        return 1
    return 0 if lay_out(atoms, slots, lists, box, strips, reach) else 1


@inlined_kernel
def list_share(
    crowd: Crowd, terms: Terms, rule: Rule, begin: int, end: int, thread: int, threads: int
) -> int:
    """List the neighbours of this thread's atoms; 0, or 1 if room is short."""
    reach = terms.reach + rule.skin
    found = list_neighbours(
        crowd.atoms,
        crowd.slots,
        crowd.lists,
        box_of(crowd, rule),
        crowd.strips,
        reach,
        begin,
        end,
        thread,
        threads,
    )
    return 0 if found else 1


@bare_kernel
def prepare(
    crowd: Crowd,
    terms: Terms,
    rule: Rule,
    bath: Bath,
    gas: Gas,
    walls: Walls | None,
    book: Ledger,
    books: Books,
    present: NDArray[np.float64],
) -> int:
    """List neighbours at the places of the atoms, put them where they are at present, and find forces and energies.

    present : (n, 2) places by row of the state, for a run that goes on; empty to leave the atoms where they are

    Returns
    -------
    DONE or GROW.
    """
    atoms, slots, lists, _, room = crowd
    n = room.stage[1]
    if sort_all(crowd, terms, rule, gas, walls) or list_share(crowd, terms, rule, 0, n, 0, 1):
        return GROW
    if present.shape[0] > 0:
        for k in range(n):
            atoms.x[k], atoms.y[k] = present[atoms.row[k], 0], present[atoms.row[k], 1]
        publish(atoms, slots, 0, slots.size[0])
    push(atoms, slots, lists, terms, rule.gx, rule.gy, True, 0, n)
    if walls is not None and walls.strength > 0.0:
        push_back(walls, atoms, gas, box_of(crowd, rule), book, 0.0)
    sum_blocks(atoms, room, True, 0, room.sums.shape[0])
    sums = sum_atoms(bath, room)
    books.now[0], books.now[1], books.now[2] = sums.potential, sums.virial, sums.kinetic
    return DONE
