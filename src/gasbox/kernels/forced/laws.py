"""The pair laws: potential and force as functions of the square of the distance.

A law is one function of the square of the distance and of up to four parameters, written for single numbers and for
lanes alike, and one line in `pair_law`. It gives the potential u and the force divided by the distance, -u'(r)/r; the
cutoff and the shifts are the same for all laws. What its parameters are made of stands in
`gasbox.dynamics.pair_terms`.

Sources: M. P. Allen, D. J. Tildesley, Computer Simulation of Liquids, 2nd ed. (2017), chapters 1 and 5,
doi:10.1093/oso/9780198803195.001.0001; S. Toxvaerd, J. C. Dyre, J. Chem. Phys. 134, 081102 (2011),
doi:10.1063/1.3558787, for forces shifted to zero at the cutoff.
"""

from __future__ import annotations

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.forced.tables import INVERSE_POWERS, SCREENED
from gasbox.kernels.lanes import WIDTH, Lanes, exponential, root, spread, total

__all__ = ["law_at", "pair_law"]


@inlined_kernel
def inverse_powers(square: Lanes, a: Lanes, b: Lanes, c: Lanes) -> tuple[Lanes, Lanes]:
    """b s12 - c s6 with s = sqrt(a)/r: Lennard-Jones, and soft spheres with c = 0."""
    inverse = 1.0 / square
    s2 = a * inverse
    s6 = s2 * s2 * s2
    return s6 * (b * s6 - c), 6.0 * s6 * (2.0 * b * s6 - c) * inverse


@inlined_kernel
def screened(square: Lanes, a: Lanes, b: Lanes, c: Lanes) -> tuple[Lanes, Lanes]:
    """a exp(-b (r - c))/r: charges in a screening medium (Yukawa)."""
    inverse = 1.0 / square
    distance = root(square)
    u = a * exponential(b * (c - distance)) * inverse * distance
    return u, u * (inverse + b * inverse * distance)


@inlined_kernel
def well(square: Lanes, a: Lanes, b: Lanes, c: Lanes, d: Lanes) -> tuple[Lanes, Lanes]:
    """b [s36 - 1/(1 + exp(c r/sigma - d))] with s = sigma/r, a = sigma²: a steep core in a well with a soft edge."""
    inverse = 1.0 / square
    s2 = a * inverse
    s6 = s2 * s2 * s2
    s36 = s6 * s6 * s6 * s6 * s6 * s6
    distance = root(square)
    scaled = distance / root(a)
    edge = exponential(c * scaled - d)
    fermi = 1.0 / (1.0 + edge)
    u = b * (s36 - fermi)
    slope = b * fermi * (1.0 - fermi) * c * scaled
    return u, (36.0 * b * s36 - slope) * inverse


@inlined_kernel
def pair_law(law: int, square: Lanes, a: Lanes, b: Lanes, c: Lanes, d: Lanes) -> tuple[Lanes, Lanes]:
    """Potential, and force over distance, by the number of the law."""
    if law == INVERSE_POWERS:
        return inverse_powers(square, a, b, c)
    if law == SCREENED:
        return screened(square, a, b, c)
    return well(square, a, b, c, d)


@bare_kernel
def law_at(law: int, distance: float, a: float, b: float, c: float, d: float) -> tuple[float, float]:
    """Potential and force (repulsive > 0) at one distance, without shifts and cutoff."""
    square = spread(distance * distance)
    u, f = pair_law(law, square, spread(a), spread(b), spread(c), spread(d))
    # All lanes hold the same number, and a sum of eight of them is exact.
    return total(u) / WIDTH, total(f) / WIDTH * distance
