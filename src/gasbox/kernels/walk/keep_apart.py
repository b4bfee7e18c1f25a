"""Who keeps a distance turns away from those nearby. Symbols: i j people, c cell, x y position, d distance."""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.grid import span
from gasbox.kernels.walk.filing import shortest
from gasbox.kernels.walk.tables import Files, Ground, Walkers

__all__ = ["keep_apart"]

_TINY = 1e-300


@bare_kernel
def keep_apart(people: Walkers, ground: Ground, files: Files, reach: float) -> None:
    """Write into `push` the sum of (1 - d/reach) over all within `reach` [length], away from each.

    Precondition: all are filed in cells not narrower than `reach`. Those in another place don't count.
    """
    columns, rows = files.cells[0], files.cells[1]
    across, along = ground.period_x < math.inf, ground.period_y < math.inf
    people.push[:] = 0.0
    for entry in range(people.id.shape[0]):
        files.mark[entry] = people.place[files.row[entry]]
    for line in range(rows):
        low, high = span(line, rows, along)
        for column in range(columns):
            left, right = span(column, columns, across)
            c = line * columns + column
            # Cells side by side are filed one after the other: they are gone through in one go.
            whole = column + left >= 0 and column + right < columns
            for entry in range(files.begin[c], files.begin[c + 1]):
                i = files.row[entry]
                if people.distancing[i] == 0.0 or people.going[i] == 1:
                    continue
                for up in range(low, high + 1):
                    base = (line + up) % rows * columns
                    if whole:
                        first, last = base + column + left, base + column + right
                        _turn_away(
                            people, ground, files, reach, entry, files.begin[first], files.begin[last + 1]
                        )
                        continue
                    for beside in range(left, right + 1):
                        first = base + (column + beside) % columns
                        _turn_away(
                            people, ground, files, reach, entry, files.begin[first], files.begin[first + 1]
                        )


@inlined_kernel
def _turn_away(
    people: Walkers, ground: Ground, files: Files, reach: float, entry: int, first: int, last: int
) -> None:
    """Add what those push who are filed from `first` to before `last`."""
    x, y, here = files.x[entry], files.y[entry], files.mark[entry]
    push_x, push_y = 0.0, 0.0
    for other in range(first, last):
        dx = shortest(x - files.x[other], ground.period_x)
        dy = shortest(y - files.y[other], ground.period_y)
        d2 = dx * dx + dy * dy
        # Without a branch: nobody could foretell which of them are near.
        near = (d2 < reach * reach) & (d2 > 0.0) & (files.mark[other] == here)
        share = 1.0 / math.sqrt(max(d2, _TINY)) - 1.0 / reach
        share = share if near else 0.0
        push_x += share * dx
        push_y += share * dy
    i = files.row[entry]
    people.push[i, 0] += push_x
    people.push[i, 1] += push_y
