"""Who keeps a distance turns away from those nearby. Symbols: i j people, c cell, x y position, d distance."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel
from gasbox.kernels.grid import span
from gasbox.kernels.walk.filing import cell_at, shortest
from gasbox.kernels.walk.tables import Files, Ground, Walkers

__all__ = ["keep_apart"]


@bare_kernel
def keep_apart(people: Walkers, ground: Ground, files: Files, reach: float) -> None:
    """Write into `push` the sum of (1 - d/reach) over all within `reach` [length], away from each.

    Precondition: all are filed in cells not narrower than `reach`. Those in another place don't count.
    """
    columns, rows = files.cells[0], files.cells[1]
    across, along = ground.period_x < math.inf, ground.period_y < math.inf
    for i in range(people.id.shape[0]):
        people.push[i, 0], people.push[i, 1] = 0.0, 0.0
        if people.distancing[i] == 0.0 or people.going[i] == 1:
            continue
        x, y = people.position[i, 0], people.position[i, 1]
        c = cell_at(x, y, files, ground)
        column, line = c % columns, c // columns
        low, high = span(line, rows, along)
        left, right = span(column, columns, across)
        for up in range(low, high + 1):
            for beside in range(left, right + 1):
                c = (line + up) % rows * columns + (column + beside) % columns
                for entry in range(files.begin[c], files.begin[c + 1]):
                    j = files.row[entry]
                    dx = shortest(x - people.position[j, 0], ground.period_x)
                    dy = shortest(y - people.position[j, 1], ground.period_y)
                    d2 = dx * dx + dy * dy
                    if d2 >= reach * reach or d2 == 0.0 or people.place[j] != people.place[i]:
                        continue
                    d = math.sqrt(d2)
                    share = (1.0 / d - 1.0 / reach) if d > 0.0 else 0.0
                    people.push[i, 0] += share * dx
                    people.push[i, 1] += share * dy
