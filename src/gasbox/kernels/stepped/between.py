"""Walls between two discs."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel
from gasbox.kernels.arguments import Box, Gas
from gasbox.kernels.hall.tables import KIND, OPEN, SIDE, WALL
from gasbox.kernels.stepped.tables import Grid, Slots, Walls
from gasbox.kernels.stepped.ways import choices, choose, elements, side_crossing

__all__ = ["divided"]


@bare_kernel
def divided(
    first: int, second: int, slots: Slots, gas: Gas, box: Box, grid: Grid, walls: Walls, dx: float, dy: float
) -> bool:
    """Whether a wall that neither passes lies between the centres of two discs; (dx, dy) leads from second to first."""
    for turn in range(2):
        a = first if turn == 0 else second
        row, other = slots.row[a], slots.row[second if turn == 0 else first]
        x, y = slots.x[a], slots.y[a]
        sign = -1.0 if turn == 0 else 1.0
        way = x, y, x + sign * dx, y + sign * dy, slots.reach[a]
        where = elements((x, y, x, y, slots.reach[a]), grid.level[row], box, grid, walls)
        for choice in range(choices(where, walls)):
            e, image_x, image_y = choose(choice, where, walls)
            number = walls.hall.kind[e, WALL]
            if walls.hall.kind[e, KIND] != SIDE or walls.hall.rule[number, OPEN]:
                continue
            if walls.hall.passes[number, gas.species[row]] or walls.hall.passes[number, gas.species[other]]:
                continue
            sx, sy = image_x * box.width, image_y * box.height
            if side_crossing(walls, e, sx, sy, way, False, 0.0, 0.0) < math.inf:
                return True
    return False
