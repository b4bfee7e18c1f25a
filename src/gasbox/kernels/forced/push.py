"""Forces: each atom goes through its neighbours, eight at a time.

Every pair is computed twice, once for each of its discs. That costs less than adding to the other disc's force would:
sums stay in registers, the order of addition is that of the lists whatever the number of threads, and forces are equal
and opposite to the bit.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.forced.bodies import Bodies
from gasbox.kernels.forced.laws import pair_law
from gasbox.kernels.forced.tables import (
    CUT,
    CUT2,
    F_CUT,
    INVERSE_POWERS,
    SCREENED,
    U_CUT,
    WELL,
    A,
    Atoms,
    B,
    C,
    D,
    Lists,
    Slots,
    Terms,
)
from gasbox.kernels.lanes import Lanes, choose, load, root, spread, take, total

__all__ = ["bounded", "push"]


@inlined_kernel
def bounded(
    law: int,
    shifted: bool,
    square: Lanes,
    a: Lanes,
    b: Lanes,
    c: Lanes,
    d: Lanes,
    cut2: Lanes,
    cut: Lanes,
    u_cut: Lanes,
    f_cut: Lanes,
) -> tuple[Lanes, Lanes]:
    """Potential, and force over distance, shifted and cut off; an atom does not act on itself."""
    u, f = pair_law(law, square, a, b, c, d)
    u = u - u_cut
    if shifted:
        distance = root(square)
        u = u + f_cut * (distance - cut)
        f = f - f_cut / distance
    near = (square < cut2) & (square > 0.0)
    nothing = spread(0.0)
    return choose(near, u, nothing), choose(near, f, nothing)


@inlined_kernel
def _of_others(
    bodies: Bodies | None, slots: Slots, home: int, j: int, u: Lanes, f: Lanes
) -> tuple[Lanes, Lanes]:
    """Nothing where both discs are of one molecule, which holds together by other means."""
    if bodies is None:
        return u, f
    away = load(slots.molecule, j) - slots.molecule[home]
    other, nothing = away * away > 0.0, spread(0.0)
    return choose(other, u, nothing), choose(other, f, nothing)


@inlined_kernel
def _alike(
    law: int,
    shifted: bool,
    measured: bool,
    bodies: Bodies | None,
    atoms: Atoms,
    slots: Slots,
    lists: Lists,
    value: NDArray[np.float64],
    begin: int,
    end: int,
) -> None:
    """Add the forces of one term where all discs are of one species; the first three arguments are constants."""
    a, b, c, d = spread(value[A, 0]), spread(value[B, 0]), spread(value[C, 0]), spread(value[D, 0])
    cut2, cut, u_cut, f_cut = (
        spread(value[CUT2, 0]),
        spread(value[CUT, 0]),
        spread(value[U_CUT, 0]),
        spread(value[F_CUT, 0]),
    )
    for k in range(begin, end):
        home = lists.home[k]
        x, y = spread(slots.x[home]), spread(slots.y[home])
        fx, fy, us, ws = spread(0.0), spread(0.0), spread(0.0), spread(0.0)
        for entry in range(lists.first[k], lists.last[k]):
            j = lists.start[entry]
            dx, dy = x - load(slots.x, j), y - load(slots.y, j)
            square = dx * dx + dy * dy
            u, f = bounded(law, shifted, square, a, b, c, d, cut2, cut, u_cut, f_cut)
            u, f = _of_others(bodies, slots, home, j, u, f)
            fx, fy = fx + f * dx, fy + f * dy
            if measured:
                us, ws = us + u, ws + f * square
        atoms.fx[k] += total(fx)
        atoms.fy[k] += total(fy)
        if measured:
            atoms.u[k] += 0.5 * total(us)
            atoms.w[k] += 0.5 * total(ws)


@bare_kernel
def _push_alike(
    atoms: Atoms,
    slots: Slots,
    lists: Lists,
    terms: Terms,
    bodies: Bodies | None,
    t: int,
    measured: bool,
    begin: int,
    end: int,
) -> None:
    """As `_alike`, with a loop of its own for each law, and for the commonest case of all."""
    law, shifted, value = terms.law[t], terms.shifted[t], terms.value[t]
    if law == INVERSE_POWERS:
        if shifted:
            _alike(INVERSE_POWERS, True, True, bodies, atoms, slots, lists, value, begin, end)
        elif measured:
            _alike(INVERSE_POWERS, False, True, bodies, atoms, slots, lists, value, begin, end)
        else:
            _alike(INVERSE_POWERS, False, False, bodies, atoms, slots, lists, value, begin, end)
    elif law == SCREENED:
        _alike(SCREENED, shifted, True, bodies, atoms, slots, lists, value, begin, end)
    else:
        _alike(WELL, shifted, True, bodies, atoms, slots, lists, value, begin, end)


@bare_kernel
def _push_mixed(
    atoms: Atoms,
    slots: Slots,
    lists: Lists,
    terms: Terms,
    bodies: Bodies | None,
    t: int,
    begin: int,
    end: int,
) -> None:
    """Add the forces of one term among several species."""
    law, shifted, many = terms.law[t], terms.shifted[t], terms.species
    value = terms.value[t]
    for k in range(begin, end):
        home = lists.home[k]
        mine = atoms.species[k] * many
        last = mine + many
        x, y = spread(slots.x[home]), spread(slots.y[home])
        fx, fy, us, ws = spread(0.0), spread(0.0), spread(0.0), spread(0.0)
        for entry in range(lists.first[k], lists.last[k]):
            j = lists.start[entry]
            dx, dy = x - load(slots.x, j), y - load(slots.y, j)
            square = dx * dx + dy * dy
            u, f = bounded(
                law,
                shifted,
                square,
                take(value[A, mine:last], slots.species, j),
                take(value[B, mine:last], slots.species, j),
                take(value[C, mine:last], slots.species, j),
                take(value[D, mine:last], slots.species, j),
                take(value[CUT2, mine:last], slots.species, j),
                take(value[CUT, mine:last], slots.species, j),
                take(value[U_CUT, mine:last], slots.species, j),
                take(value[F_CUT, mine:last], slots.species, j),
            )
            u, f = _of_others(bodies, slots, home, j, u, f)
            fx, fy = fx + f * dx, fy + f * dy
            us, ws = us + u, ws + f * square
        atoms.u[k] += 0.5 * total(us)
        atoms.w[k] += 0.5 * total(ws)
        atoms.fx[k] += total(fx)
        atoms.fy[k] += total(fy)


@bare_kernel
def push(
    atoms: Atoms,
    slots: Slots,
    lists: Lists,
    terms: Terms,
    bodies: Bodies | None,
    gx: float,
    gy: float,
    measured: bool,
    begin: int,
    end: int,
) -> None:
    """Forces on atoms `begin` to `end`; also their energy and virial, if these are asked for.

    gx, gy : acceleration of all discs [length/time²]
    """
    for k in range(begin, end):
        atoms.fx[k], atoms.fy[k] = atoms.mass[k] * gx, atoms.mass[k] * gy
        atoms.u[k] = atoms.w[k] = 0.0
    for t in range(terms.law.shape[0]):
        if terms.species == 1:
            _push_alike(atoms, slots, lists, terms, bodies, t, measured, begin, end)
        else:
            _push_mixed(atoms, slots, lists, terms, bodies, t, begin, end)
