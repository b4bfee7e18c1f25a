"""Lists of neighbours made anew: sort all atoms, lay out the slots, list who is near."""

from __future__ import annotations

from typing import NamedTuple

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas
from gasbox.kernels.forced.crowd import Crowd
from gasbox.kernels.forced.molecules import find
from gasbox.kernels.forced.sort import divide, lay_out, list_neighbours, sort_atoms, wrap
from gasbox.kernels.forced.tables import Terms
from gasbox.kernels.forced.wall_tables import Walls
from gasbox.kernels.forced.walls import list_walls

__all__ = ["GROW", "Rule", "box_of", "list_share", "sort_all"]

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
def sort_all(crowd: Crowd, terms: Terms, rule: Rule, gas: Gas, walls: Walls) -> int:
    """Bring all atoms back into the box, sort them and lay out the slots; 0, or 1 if room is short."""
    atoms, slots, lists, strips, room, bodies = crowd
    n, reach, box = room.stage[1], terms.reach + rule.skin, box_of(crowd, rule)
    wrap(atoms, bodies, box, 0, n)
    if not divide(strips, box, n, reach):
        return 1
    sort_atoms(atoms, box, strips, room)
    find(bodies, atoms, n)
    if not list_walls(walls, atoms, bodies, gas, box, n, rule.skin):
        return 1
    return 0 if lay_out(atoms, slots, lists, bodies, box, strips, reach) else 1


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
