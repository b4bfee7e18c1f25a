"""A gas in a field of gravity: how density falls with height, in an ideal gas and in one of hard discs.

Heights y are those of centres, measured from the lowest that a centre can reach (a radius above the floor);
the room H is the height that centres can reach, infinite without a lid, and the width W that which they can
reach sideways. The scale height is ell = T/(m g), infinite without gravity. Points of each species are
spread by their own ell, exp(-y/ell), and are equally hot at every height. With x = H/(2 ell), Langevin's
function L(x) = coth x - 1/x gives the mean height, H (1 - L)/2, and its slope the variance, (H²/4) dL/dx.

Whatever the particles do to each other, all of them together press on the floor by their weight more than
on the lid: `weight_pressure`. The other functions are those of one ideal species; `sediment` has hard discs.

Source: L. D. Landau and E. M. Lifshitz, Statistical Physics, part 1, 3rd ed. (Pergamon, 1980), sec. 38; the
closed forms are elementary integrals of exp(-y/ell).
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from gasbox.theory.real import Real, pick

__all__ = [
    "density",
    "effective_height",
    "expected_height_counts",
    "heat_capacity",
    "height_cdf",
    "height_variance",
    "mean_height",
    "scale_height",
    "weight_pressure",
]

_LANGEVIN: Final = Polynomial(
    [0, 1 / 3, 0, -1 / 45, 0, 2 / 945, 0, -1 / 4725, 0, 2 / 93555, 0, -1382 / 638512875, 0, 4 / 18243225]
)
"""coth x - 1/x for small x, where the closed form loses its digits."""
_SLOPE: Final = _LANGEVIN.deriv()
_SMALL: Final = 0.3
"""Up to this x the series is right to 13 digits, and beyond it the closed forms are."""


def scale_height(mass: float, temperature: float, gravity: float) -> float:
    """ell = T/(m g) [length]: over this height the density of points falls to 1/e; infinite without gravity.

    Parameters
    ----------
    mass, temperature : [mass], [energy]
    gravity : g, >= 0 [length/time²]
    """
    return temperature / (mass * gravity) if gravity > 0.0 else math.inf


def density(height: Real, count: float, width: float, scale: float, room: float = math.inf) -> Real:
    """Number of points per area at a height, (N/W) exp(-y/ell)/(ell (1 - exp(-H/ell))) [1/length²].

    Parameters
    ----------
    height : y [length]; outside the room the density is 0
    count : number of particles
    width : W [length]
    scale : ell > 0 [length], infinite only in a room of finite height
    room : H [length]
    """
    y = _within(height, room)
    outside = np.logical_or(np.less(height, 0.0), np.greater(height, room))
    value: Real = pick(outside, 0.0, count / (width * effective_height(scale, room)) * np.exp(-y / scale))
    return value


def height_cdf(height: Real, scale: float, room: float = math.inf) -> Real:
    """Probability that a particle is below `height`, (1 - exp(-y/ell))/(1 - exp(-H/ell)); as `density`."""
    y = _within(height, room)
    if math.isinf(scale):
        even: Real = y / room
        return even
    below: Real = np.expm1(-y / scale) / math.expm1(-room / scale)
    return below


def expected_height_counts(
    edges: NDArray[np.float64], count: float, scale: float, room: float = math.inf
) -> NDArray[np.float64]:
    """How many of `count` particles the law puts into each bin of height.

    Parameters
    ----------
    edges : (bins+1,) float64 [length], ascending
    count, scale, room : as for `density`

    Returns
    -------
    (bins,) float64: exact integrals over the bins, not values at their middles.
    """
    y = _within(edges, room)
    # The share of a bin is that of its lower edge times that of its own height, exact far up too.
    if math.isinf(scale):
        return count * np.diff(y) / room
    share = np.exp(-y[:-1] / scale) * np.expm1(-np.diff(y) / scale) / math.expm1(-room / scale)
    return count * share + 0.0


def effective_height(scale: float, room: float = math.inf) -> float:
    """ell (1 - exp(-H/ell)) [length]: at the floor's density everywhere, points would fill this height."""
    return room if math.isinf(scale) else -scale * math.expm1(-room / scale)


def mean_height(scale: float, room: float = math.inf) -> float:
    """Mean height of a particle, ell - H/(exp(H/ell) - 1) [length]: H/2 without gravity, ell without a lid."""
    if math.isinf(room):
        return scale
    x = 0.5 * room / scale
    if x < _SMALL:
        return 0.5 * room * (1.0 - float(_LANGEVIN(x)))
    return scale + room * math.exp(-2.0 * x) / math.expm1(-2.0 * x)


def height_variance(scale: float, room: float = math.inf) -> float:
    """Variance of the height [length²]: ell² (1 - (x/sinh x)²), H²/12 without gravity, ell² without a lid."""
    x = 0.5 * room / scale
    if x < _SMALL:
        return 0.25 * room**2 * float(_SLOPE(x))
    return scale**2 * _falling_share(x)


def heat_capacity(scale: float, room: float = math.inf, freedom: float = 2.0) -> float:
    """Heat that one particle takes per temperature: f/2 + 1 - a² e^a/(e^a - 1)², a = H/ell.

    A warmer gas is lifted too: without a lid that adds 1 to the f/2 of motion, in a low room nothing.

    Parameters
    ----------
    scale, room : as for `density`
    freedom : f, quadratic degrees of freedom of one particle (2, with rotation 3)
    """
    return 0.5 * freedom + _falling_share(0.5 * room / scale)


def weight_pressure(count: float, mass: float, gravity: float, width: float) -> float:
    """Time average of the pressure on the floor less that on the lid, N m g/W [mass/time²].

    Exact for any particles that stay within the room and for a floor and lid of the same length; of several
    species, the sum.
    """
    return count * mass * gravity / width


def _within(height: Real, room: float) -> Real:
    """`height` with everything outside the room moved to its nearer end."""
    inside: Real = np.clip(height, 0.0, room)
    return inside


def _falling_share(x: float) -> float:
    """1 - (x/sinh x)², x = H/(2 ell): the potential energy's part of the heat capacity, 0 to 1."""
    if x < _SMALL:
        return x * x * float(_SLOPE(x))
    decay = math.exp(-x)
    return 1.0 - (2.0 * x * decay / math.expm1(-2.0 * x)) ** 2 if decay > 0.0 else 1.0
