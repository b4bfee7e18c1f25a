"""What acts within flexible molecules: bonds, angles, and the force of pairs that no bond or angle joins.

None of it counts to the virial of molecules. Source of the laws: M. P. Allen, D. J. Tildesley, Computer Simulation of
Liquids, 2nd ed. (2017), appendix C, doi:10.1093/oso/9780198803195.001.0001.
"""

from __future__ import annotations

import math

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.arguments import Box
from gasbox.kernels.forced.bodies import FLEXIBLE, Bodies
from gasbox.kernels.forced.molecules import unwrapped
from gasbox.kernels.forced.push import bounded
from gasbox.kernels.forced.tables import CUT, CUT2, F_CUT, U_CUT, A, Atoms, B, C, D, Terms
from gasbox.kernels.lanes import WIDTH, spread, total

__all__ = ["hold"]


@inlined_kernel
def _stretch(bodies: Bodies, atoms: Atoms, box: Box, bond: int) -> None:
    """Add the force of a bond, k (r - length) along it."""
    inner = bodies.inner
    one, other = inner.bond[bond, 0], inner.bond[bond, 1]
    x, y = unwrapped(bodies, atoms, box, one)
    dx, dy = unwrapped(bodies, atoms, box, other)
    dx, dy = x - dx, y - dy
    distance = math.sqrt(dx * dx + dy * dy)
    longer = distance - inner.bond_length[bond]
    pull = inner.bond_stiffness[bond] * longer
    # Discs at one place have no direction in which to part.
    over = pull / distance if distance > 0.0 else 0.0
    k, j = bodies.where[one], bodies.where[other]
    atoms.fx[k] -= over * dx
    atoms.fy[k] -= over * dy
    atoms.fx[j] += over * dx
    atoms.fy[j] += over * dy
    atoms.u[k] += 0.5 * pull * longer


@inlined_kernel
def _bend(bodies: Bodies, atoms: Atoms, box: Box, bend: int) -> None:
    """Add the forces of an angle, whichever side it opens to."""
    inner = bodies.inner
    one, middle, other = inner.bend[bend, 0], inner.bend[bend, 1], inner.bend[bend, 2]
    x, y = unwrapped(bodies, atoms, box, middle)
    ax, ay = unwrapped(bodies, atoms, box, one)
    bx, by = unwrapped(bodies, atoms, box, other)
    ax, ay, bx, by = ax - x, ay - y, bx - x, by - y
    angle = math.atan2(ax * by - ay * bx, ax * bx + ay * by)
    wider = abs(angle) - inner.bend_angle[bend]
    moment = inner.bend_stiffness[bend] * wider
    turn = moment if angle >= 0.0 else -moment
    of_one, of_other = turn / (ax * ax + ay * ay), turn / (bx * bx + by * by)
    k, i, j = bodies.where[one], bodies.where[middle], bodies.where[other]
    atoms.fx[k] -= of_one * ay
    atoms.fy[k] += of_one * ax
    atoms.fx[j] += of_other * by
    atoms.fy[j] -= of_other * bx
    atoms.fx[i] += of_one * ay - of_other * by
    atoms.fy[i] += of_other * bx - of_one * ax
    atoms.u[i] += 0.5 * moment * wider


@bare_kernel
def _repel(bodies: Bodies, atoms: Atoms, terms: Terms, box: Box, pair: int) -> None:
    """Add the force of the pair law between two discs of one molecule."""
    one, other = bodies.inner.pair[pair, 0], bodies.inner.pair[pair, 1]
    x, y = unwrapped(bodies, atoms, box, one)
    dx, dy = unwrapped(bodies, atoms, box, other)
    dx, dy = x - dx, y - dy
    square = dx * dx + dy * dy
    k, j = bodies.where[one], bodies.where[other]
    column = atoms.species[k] * terms.species + atoms.species[j]
    for t in range(terms.law.shape[0]):
        value = terms.value[t]
        if not square < value[CUT2, column]:
            continue
        us, fs = bounded(
            terms.law[t],
            terms.shifted[t],
            spread(square),
            spread(value[A, column]),
            spread(value[B, column]),
            spread(value[C, column]),
            spread(value[D, column]),
            spread(value[CUT2, column]),
            spread(value[CUT, column]),
            spread(value[U_CUT, column]),
            spread(value[F_CUT, column]),
        )
        # All lanes hold the same number, and a sum of eight of them is exact.
        over = total(fs) / WIDTH
        atoms.fx[k] += over * dx
        atoms.fy[k] += over * dy
        atoms.fx[j] -= over * dx
        atoms.fy[j] -= over * dy
        atoms.u[k] += total(us) / WIDTH


@bare_kernel
def hold(bodies: Bodies, atoms: Atoms, terms: Terms, box: Box, begin: int, end: int) -> None:
    """Add all that acts within the flexible ones of particles `begin` to `end`."""
    inner = bodies.inner
    for row in range(begin, end):
        if bodies.style[row] != FLEXIBLE:
            continue
        for bond in range(inner.bond_first[row], inner.bond_first[row + 1]):
            _stretch(bodies, atoms, box, bond)
        for bend in range(inner.bend_first[row], inner.bend_first[row + 1]):
            _bend(bodies, atoms, box, bend)
        for pair in range(inner.pair_first[row], inner.pair_first[row + 1]):
            _repel(bodies, atoms, terms, box, pair)
