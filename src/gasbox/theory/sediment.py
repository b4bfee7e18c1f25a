"""Hard discs in a field of gravity, by local density: each height is a piece of bulk fluid.

The pressure carries the weight above, dP/dy = -m g n, with P = n T Z. Since dP = n dmu, the chemical
potential falls evenly, mu(y)/T = mu(0)/T - y/ell, and the floor's area fraction follows from the weight,
eta_0 Z_0 - eta_H Z_H = N pi R²/(W ell). The mean height is the integral of the pressure over the room, less
H P(H), over the weight; with d(eta Z) = eta dmu/T it needs only int Z d(eta Z).

It holds where the density changes little over a diameter, ell >> sigma. The layers that discs form within a
few diameters of a floor are not in it, so average profiles over a diameter at least. Conventions (y, H, W,
ell) are those of `gravity`. Where the floor is denser than the equation of state allows, functions give
not-a-number: there the gas freezes from below.

Source: J.-P. Hansen and I. R. McDonald, Theory of Simple Liquids, 4th ed. (Academic Press, 2013), ch. 6,
doi:10.1016/C2010-0-66723-X (the local-density approximation).
"""

from __future__ import annotations

import math
from collections.abc import Callable
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

_SHALLOW: Final = 1.0
"""Below this H/ell profiles are averaged over the height; above it differences lose no digits."""
_NODES: Final = 0.5 + 0.5 * np.polynomial.legendre.leggauss(64)[0]
_WEIGHTS: Final = 0.5 * np.polynomial.legendre.leggauss(64)[1]
"""Gauss and Legendre's rule on 0 to 1."""


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
    if radius == 0.0 or count == 0.0 or equation == "ideal":
        return gravity.mean_height(scale, room)
    floor, rise = _floor_potential(count, width, radius, scale, room, equation), room / scale
    if rise < _SHALLOW:
        eta = area_fraction_at(floor - rise * _NODES, equation)
        return room * float(np.sum(_WEIGHTS * _NODES * eta) / np.sum(_WEIGHTS * eta))
    bottom, top = area_fraction_at(floor, equation), area_fraction_at(floor - rise, equation)
    lid = rise * _reduced_pressure(top, equation) if top > 0.0 else 0.0
    weight = _weight(count, width, radius, scale)
    return scale * (_pressure_integral(top, bottom, equation) - lid) / weight


def _weight(count: float, width: float, radius: float, scale: float) -> float:
    """N pi R²/(W ell): weight per width in units of T/(pi R²), as is the pressure eta Z."""
    return count * math.pi * radius**2 / (width * scale)


def _reduced_pressure(eta: float, equation: str) -> float:
    """Eta Z: pressure in units of T/(pi R²)."""
    return eta * compressibility(eta, equation)


def _floor_potential(
    count: float, width: float, radius: float, scale: float, room: float, equation: str
) -> float:
    """Chemical potential over T at the floor; not a number if the discs would be too dense there."""
    if count == 0.0:
        return -math.inf
    end = greatest_area_fraction(equation)
    # At the floor discs are denser than on average, and, since S >= 1, not denser than points would be.
    mean = count * math.pi * radius**2 / (width * room)
    points = count * math.pi * radius**2 / (width * gravity.effective_height(scale, room))
    dense = min(points, end)
    if not mean < end:
        return math.nan
    load = _load(mean, _weight(count, width, radius, scale), room / scale, equation)
    high = chemical_potential(dense, equation)
    if points >= end and load(high)[0] < 0.0:
        return math.nan
    # The floor bears the whole weight, and its eta Z is at most eta times the greatest Z.
    least = max(mean, _weight(count, width, radius, scale) / compressibility(dense, equation))
    return rising_root(load, chemical_potential(min(least, dense), equation), high)


def _load(mean: float, weight: float, rise: float, equation: str) -> Callable[[float], tuple[float, float]]:
    """By how much too many discs a potential at the floor holds, and the slope of that."""

    def shallow(potential: float) -> tuple[float, float]:
        eta = area_fraction_at(potential - rise * _NODES, equation)
        slope = np.sum(_WEIGHTS * eta / stiffness(eta, equation))
        return float(np.sum(_WEIGHTS * eta)) - mean, float(slope)

    def deep(potential: float) -> tuple[float, float]:
        bottom, top = area_fraction_at(potential, equation), area_fraction_at(potential - rise, equation)
        borne = _reduced_pressure(bottom, equation) - _reduced_pressure(top, equation)
        return borne - weight, bottom - top

    return shallow if rise < _SHALLOW else deep


def _pressure_integral(top: float, bottom: float, equation: str) -> float:
    """int Z d(eta Z) from `top` to `bottom`, as (eta Z² + int Z² d eta)/2: no slope of Z is needed."""
    z = compressibility(top + (bottom - top) * _NODES, equation)
    inner = (bottom - top) * float(np.sum(_WEIGHTS * z**2))
    outer = bottom * compressibility(bottom, equation) ** 2 - top * compressibility(top, equation) ** 2
    return 0.5 * (outer + inner)
