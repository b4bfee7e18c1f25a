"""Lists of neighbours, made anew when discs have moved: sort, lay out the slots, list who is near.

All is a function of the places alone, so that a resumed run makes the same lists.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.forced.bodies import Bodies
from gasbox.kernels.forced.molecules import wrap_bodies
from gasbox.kernels.forced.motion import inside
from gasbox.kernels.forced.tables import FAR, Atoms, Lists, Room, Slots, Strips
from gasbox.kernels.lanes import WIDTH, bits, load, lowest, spread
from gasbox.kernels.team import share

_IMAGES = 4096.0
"""More than molecules and forces can go round a periodic box, both ways."""

__all__ = ["divide", "lay_out", "list_neighbours", "sort_atoms", "thickness", "wrap"]


@bare_kernel
def wrap(atoms: Atoms, bodies: Bodies | None, box: Box, begin: int, end: int) -> None:
    """Bring atoms back into the box along its periodic directions, and remember their places."""
    if bodies is not None:
        wrap_bodies(bodies, atoms, box)
        return
    for k in range(begin, end):
        if box.periodic_x:
            atoms.x[k] = inside(atoms.x[k], box.width)
        if box.periodic_y:
            atoms.y[k] = inside(atoms.y[k], box.height)
        atoms.bx[k], atoms.by[k] = atoms.x[k], atoms.y[k]


@inlined_kernel
def _strip_of(y: float, height: float, count: int) -> int:
    return max(0, min(int(y * (count / height)), count - 1))


@inlined_kernel
def thickness(n: int, area: float, reach: float) -> float:
    """How thick strips are to be for n discs: a part of the reach, so that a strip holds few more than eight at once.

    It depends on nothing but the present, so that a run that goes on divides the box in the same way.
    """
    around = n * (2.0 * reach) ** 2 / area
    return reach / max(1, int(around / 20.0 + 0.5))


@bare_kernel
def divide(strips: Strips, box: Box, n: int, reach: float) -> bool:
    """Choose the number of strips for the box as it is; a periodic one holds a whole number. False if room is short."""
    count = max(1, int(box.height / thickness(n, box.width * box.height, reach)))
    thick = box.height / count
    more = math.ceil(reach / thick)
    if not box.periodic_y:
        more = min(more, count)
    if count + 1 > strips.first.shape[0] or count + 2 * more > strips.slot.shape[0]:
        return False
    strips.shape[0], strips.shape[1] = count, more
    return 2 * more + 1 <= strips.place.shape[1]


@bare_kernel
def sort_atoms(atoms: Atoms, box: Box, strips: Strips, room: Room) -> None:
    """Sort by strip, then by x, then by row of the state."""
    n, order, spare = room.stage[1], room.order, room.spare
    first, count, high = strips.first, strips.shape[0], box.height
    for s in range(count + 1):
        first[s] = 0
    for k in range(n):
        first[_strip_of(atoms.y[k], high, count) + 1] += 1
    for s in range(count):
        first[s + 1] += first[s]
    for k in range(n):
        s = _strip_of(atoms.y[k], high, count)
        order[first[s]] = k
        first[s] += 1
    for s in range(count, 0, -1):
        first[s] = first[s - 1]
    first[0] = 0
    for s in range(count):
        _sort_strip(atoms, order, first[s], first[s + 1])
    for column in (atoms.mass, atoms.rate, atoms.x, atoms.y, atoms.vx, atoms.vy, atoms.bx, atoms.by):
        for k in range(n):
            spare[k] = column[order[k]]
        for k in range(n):
            column[k] = spare[k]
    for whole in (atoms.row, atoms.species):
        for k in range(n):
            spare[k] = whole[order[k]]
        for k in range(n):
            whole[k] = int(spare[k])


@inlined_kernel
def _sort_strip(atoms: Atoms, order: NDArray[np.int32], begin: int, end: int) -> None:
    """By insertion: from one time to the next, little changes."""
    for place in range(begin + 1, end):
        k = order[place]
        x, row = atoms.x[k], atoms.row[k]
        below = place - 1
        while below >= begin and (
            atoms.x[order[below]] > x or (atoms.x[order[below]] == x and atoms.row[order[below]] > row)
        ):
            order[below + 1] = order[below]
            below -= 1
        order[below + 1] = k


@inlined_kernel
def _number(bodies: Bodies | None, slots: Slots, m: int, site: int, image: int, turn: int) -> None:
    """Number the molecule that a slot belongs to: by its row, and by where this image of it stands."""
    if bodies is None:
        return
    column, level = image - bodies.shift_x[site], turn - bodies.shift_y[site]
    slots.molecule[m] = (bodies.owner[site] * _IMAGES + column) * _IMAGES + level


@inlined_kernel
def _fill(slots: Slots, m: int, k: int, sx: float, sy: float, atoms: Atoms) -> None:
    slots.source[m], slots.sx[m], slots.sy[m] = k, sx, sy
    slots.species[m] = atoms.species[k]
    slots.x[m], slots.y[m] = atoms.x[k] + sx, atoms.y[k] + sy


@bare_kernel
def lay_out(
    atoms: Atoms,
    slots: Slots,
    lists: Lists,
    bodies: Bodies | None,
    box: Box,
    strips: Strips,
    reach: float,
) -> bool:
    """Fill the slots: atoms, images within `reach` of a periodic box, empty ones; False if there are too few."""
    m, size = 0, slots.x.shape[0]
    count, more = strips.shape[0], strips.shape[1]
    images = math.ceil(reach / box.width) if box.periodic_x else 0
    for t in range(count + 2 * more):
        level = t - more
        turn = math.floor(level / count)
        s = level - turn * count
        strips.slot[t, 0] = strips.slot[t, 1] = m
        if turn != 0 and not box.periodic_y:
            continue
        sy = turn * box.height
        for image in range(-images, images + 1):
            sx = image * box.width
            for k in range(strips.first[s], strips.first[s + 1]):
                x = atoms.x[k] + sx
                if image != 0 and not -reach <= x <= box.width + reach:
                    continue
                if m + 2 * WIDTH > size:
                    return False
                _fill(slots, m, k, sx, sy, atoms)
                _number(bodies, slots, m, atoms.row[k], image, turn)
                if image == 0 and turn == 0:
                    lists.home[k] = m
                m += 1
        strips.slot[t, 1] = m
        for _ in range(WIDTH):
            if m + WIDTH > size:
                return False
            slots.source[m], slots.sx[m], slots.sy[m], slots.species[m] = 0, FAR * box.width, 0.0, 0
            slots.x[m] = slots.y[m] = FAR * box.width
            m += 1
    slots.size[0] = m
    return True


@bare_kernel
def list_neighbours(
    atoms: Atoms,
    slots: Slots,
    lists: Lists,
    box: Box,
    strips: Strips,
    reach: float,
    begin: int,
    end: int,
    thread: int,
    threads: int,
) -> bool:
    """List the neighbours within `reach` of atoms `begin` to `end`, a thread's share; False if its room is full.

    Eight slots are listed at once, beginning with one that is near. As atoms go from left to right, so do, in each
    strip around theirs, the places from which on slots can be near.
    """
    entry, limit = share(lists.start.shape[0], thread, threads)
    count, more = strips.shape[0], strips.shape[1]
    thick, width = box.height / count, 2 * more + 1
    square = spread(reach * reach)
    most, s = 0, -1
    for k in range(begin, end):
        if s < 0 or k >= strips.first[s + 1]:
            s = max(s, 0)
            while k >= strips.first[s + 1]:
                s += 1
            most = width
            for t in range(width):
                strips.place[thread, t] = strips.slot[s + t, 0]
                most += (strips.slot[s + t, 1] - strips.slot[s + t, 0]) // WIDTH
        x, y = atoms.x[k], atoms.y[k]
        lists.first[k] = entry
        if entry + most > limit:
            return False
        lanes_x, lanes_y = spread(x), spread(y)
        for t in range(width):
            low = (s + t - more) * thick
            if low - y >= reach or y - low - thick >= reach:
                continue
            j, last = strips.place[thread, t], strips.slot[s + t, 1]
            while j < last and slots.x[j] < x - reach:
                j += 1
            strips.place[thread, t] = j
            while j < last and slots.x[j] <= x + reach:
                dx, dy = load(slots.x, j) - lanes_x, load(slots.y, j) - lanes_y
                near = bits(dx * dx + dy * dy < square)
                # Without a branch: the entry stays only if somebody is near.
                skip = lowest(near | (1 << WIDTH)) % WIDTH
                lists.start[entry] = j + skip
                entry += near != 0
                j += skip + WIDTH
        lists.last[k] = entry
    return True
