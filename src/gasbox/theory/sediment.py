"""Hard discs in a field of gravity, by local density: each height is a piece of bulk fluid.

The pressure carries the weight above, dP/dy = -m g n, with P = n T Z. Since dP = n dmu, the chemical
potential falls evenly, mu(y)/T = mu(0)/T - y/ell, and the floor's area fraction follows from the weight,
eta_0 Z_0 - eta_H Z_H = N pi R²/(W ell). The mean height is the integral of the pressure over the room, less
H P(H), over the weight; with d(eta Z) = eta dmu/T it needs only int Z d(eta Z).

It holds where the density changes little over a diameter, ell >> sigma. The layers that discs form within a
few diameters of a floor are not in it, so average profiles over a diameter at least. Conventions (y, H, W,
ell) are those of `gravity`. Where the floor is denser than the equation of state allows, functions give
not-a-number: there the gas freezes from below.

Source: J.-P. Hansen and I. R. McDonald, Theory of Simple Liquids, 4th ed. (Academic Press, 2013), sec. 6.2,
doi:10.1016/C2010-0-66723-X (the local-density approximation).
"""

from __future__ import annotations

import math
from typing import Any, Final

import numpy as np

from gasbox.theory import gravity
from gasbox.theory.fluid import (
    area_fraction_at,
    chemical_potential,
    compressibility,
    greatest_area_fraction,
    stiffness,
)
from gasbox.theory.real import Real, pick
from gasbox.theory.roots import rising_root

__all__ = ["floor_area_fraction", "hard_disc_density", "hard_disc_mean_height"]

_WEIGHTLESS: Final = 1e-5
"""Below this H/ell the linear answer to gravity is exact to ten digits, and differences are not."""
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(64)


def floor_area_fraction(
    count: float,
    width: float,
    radius: float,
    scale: float,
    room: float = math.inf,
    equation: str = "kolafa-rottner",
) -> float:
    """Area fraction eta_0 of hard discs at the floor.

    Parameters
    ----------
    count : number of discs
    width : W [length]
    radius : of a disc, sigma/2 [length]
    scale : ell > 0 [length], infinite only in a room of finite height
    room : H [length]
    equation : a name in `hard_disc.EQUATIONS`
    """
    return area_fraction_at(_floor_potential(count, width, radius, scale, room, equation), equation)


def hard_disc_density(
    height: Real,
    count: float,
    width: float,
    radius: float,
    scale: float,
    room: float = math.inf,
    equation: str = "kolafa-rottner",
) -> Real:
    """Number of hard discs per area at a height [1/length²]; 0 outside the room.

    Parameters
    ----------
    height : y [length]
    count, width, radius, scale, room, equation : as for `floor_area_fraction`; radius 0 gives points
    """
    if radius == 0.0:
        return gravity.density(height, count, width, scale, room)
    outside = np.logical_or(np.less(height, 0.0), np.greater(height, room))
    floor = _floor_potential(count, width, radius, scale, room, equation)
    eta: Any = area_fraction_at(floor - np.clip(height, 0.0, room) / scale, equation)
    value: Real = pick(outside, 0.0, eta / (math.pi * radius**2))
    return value


def hard_disc_mean_height(
    count: float,
    width: float,
    radius: float,
    scale: float,
    room: float = math.inf,
    equation: str = "kolafa-rottner",
) -> float:
    """Mean height of hard discs [length]; parameters as for `floor_area_fraction`, radius 0 gives points.

    Without a lid, in a dilute gas, ell + B_2 N/(2 W) with B_2 = pi sigma²/2.
    """
    if radius == 0.0 or equation == "ideal":
        return gravity.mean_height(scale, room)
    floor = _floor_potential(count, width, radius, scale, room, equation)
    rise = room / scale
    bottom = area_fraction_at(floor, equation)
    if rise < _WEIGHTLESS:
        return room * (0.5 - rise / (12.0 * stiffness(bottom, equation)))
    top = area_fraction_at(floor - rise, equation)
    weight = _weight(count, width, radius, scale)
    lid = rise * top * compressibility(top, equation) if math.isfinite(rise) else 0.0
    return scale * (_pressure_integral(top, bottom, equation) - lid) / weight


def _weight(count: float, width: float, radius: float, scale: float) -> float:
    """N pi R²/(W ell): weight per width in units of T/(pi R²)."""
    return count * math.pi * radius**2 / (width * scale)


def _floor_potential(
    count: float, width: float, radius: float, scale: float, room: float, equation: str
) -> float:
    """Chemical potential over T at the floor; not a number if the discs would be too dense there."""
    rise = room / scale
    if rise < _WEIGHTLESS:
        even = count * math.pi * radius**2 / (width * room)
        return chemical_potential(even, equation) + 0.5 * rise
    weight = _weight(count, width, radius, scale)
    end = greatest_area_fraction(equation)

    def excess(potential: float) -> tuple[float, float]:
        bottom, top = area_fraction_at(potential, equation), area_fraction_at(potential - rise, equation)
        borne = bottom * compressibility(bottom, equation) - top * compressibility(top, equation)
        return borne - weight, bottom - top

    # At the floor eta is above its mean, and, since Z >= 1 and S >= 1, below that of points.
    mean, points = weight / rise, -weight / math.expm1(-rise)
    if not mean < end:
        return math.nan
    high = chemical_potential(min(points, end), equation)
    if points >= end and excess(high)[0] < 0.0:
        return math.nan
    # A pressure eta Z is at most eta times the greatest Z.
    least = max(mean, weight / compressibility(min(points, end), equation))
    return rising_root(excess, chemical_potential(min(least, end), equation), high)


def _pressure_integral(top: float, bottom: float, equation: str) -> float:
    """int Z d(eta Z) from `top` to `bottom`, as (eta Z² + int Z² d eta)/2: no slope of Z is needed."""
    half = 0.5 * (bottom - top)
    eta = 0.5 * (bottom + top) + half * _NODES
    inner = half * float(np.sum(_WEIGHTS * compressibility(eta, equation) ** 2))
    ends = (value * compressibility(value, equation) ** 2 for value in (bottom, top))
    return 0.5 * (next(ends) - next(ends) + inner)
