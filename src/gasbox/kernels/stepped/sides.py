"""What the sides of a plain rectangle do to molecules."""

from __future__ import annotations

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box, Gas, Ledger, book_wall
from gasbox.kernels.stepped.bodies import BOUNCES, CUT_SHORT, Bodies
from gasbox.kernels.stepped.strike import closing_at, lever_of, push_body, yielding_of
from gasbox.kernels.stepped.visit import is_full

__all__ = ["settle"]

MOST_BOUNCES = 64
"""Of one molecule at walls in one step; more are wanted only where it is wedged in."""


@inlined_kernel
def _side(wall: int) -> tuple[float, float]:
    """Normal of a side of the box (0 left, 1 right, 2 bottom, 3 top), inwards."""
    inwards = 1.0 if wall % 2 == 0 else -1.0
    return (inwards, 0.0) if wall < 2 else (0.0, inwards)


@inlined_kernel
def _is_at(site: int, row: int, wall: int, gas: Gas, bodies: Bodies, box: Box) -> bool:
    """Whether a site is at or beyond a side of the box."""
    axis = 0 if wall < 2 else 1
    if box.periodic_x if axis == 0 else box.periodic_y:
        return False
    place, reach = bodies.position[row, axis] + bodies.arm[site, axis], gas.radius[site]
    return place <= reach if wall % 2 == 0 else place + reach >= (box.width if axis == 0 else box.height)


@bare_kernel
def settle(row: int, gas: Gas, bodies: Bodies, box: Box, book: Ledger, time: float) -> bool:
    """Let a molecule bounce off the sides of the box until none of its sites approaches; False if contacts are full."""
    begin = bodies.first[row]
    choice, last = 0, 4 * (bodies.first[row + 1] - begin)
    while choice < last:
        site, wall = begin + choice // 4, choice % 4
        nx, ny = _side(wall)
        closing = closing_at(bodies, row, site, nx, ny, 0.0)
        if closing == 0.0 or not _is_at(site, row, wall, gas, bodies, box):
            choice += 1
            continue
        if bodies.cursor[BOUNCES] >= MOST_BOUNCES:
            bodies.mishaps[CUT_SHORT] += 1
            return True
        if is_full(book):
            return False
        bodies.cursor[BOUNCES] += 1
        arm = lever_of(bodies, site, nx, ny)
        impulse = -2.0 * closing / yielding_of(bodies, row, arm)
        push_body(bodies, row, arm, nx, ny, impulse)
        book_wall(book, gas.species[site], site, wall, time, impulse * nx, impulse * ny)
        choice = 0
    return True
