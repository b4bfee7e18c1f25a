"""A gas as a spring: how stiff a column is, and how a free piston swings on it.

Slowly displaced by dx, a piston of length L on a column of height h changes the area by L dx and feels the
force -k dx, k = gamma P L/h. The exponent gamma = -d ln P/d ln A is S/Z at constant temperature and S/Z + (2/f) Z
without heat (S the `fluid.stiffness`); of points 1 and (f + 2)/f. Columns on both sides of a piston add their
k. A piston much slower than sound, in a gas that exchanges no heat with its walls, feels the adiabatic one.

Source: H. B. Callen, Thermodynamics and an Introduction to Thermostatistics, 2nd ed. (Wiley, 1985), chs. 3 and
7; for the piston E. Rüchardt, Phys. Z. 30, 58 (1929).
"""

from __future__ import annotations

import math

import numpy as np

from gasbox.theory.fluid import compressibility, stiffness
from gasbox.theory.real import Real

__all__ = ["adiabatic_exponent", "column_stiffness", "isothermal_exponent", "piston_frequency", "sound_speed"]


def isothermal_exponent(eta: Real, equation: str = "kolafa-rottner") -> Real:
    """gamma = -d ln P/d ln A at constant temperature, (Z + eta Z')/Z; 1 in a dilute gas.

    Parameters
    ----------
    eta : area fraction
    equation : a name in `hard_disc.EQUATIONS`
    """
    value: Real = stiffness(eta, equation) / compressibility(eta, equation)
    return value


def adiabatic_exponent(eta: Real, equation: str = "kolafa-rottner", freedom: float = 2.0) -> Real:
    """gamma = -d ln P/d ln A without heat, (Z + eta Z')/Z + (2/f) Z; (f + 2)/f in a dilute gas.

    Parameters
    ----------
    eta, equation : as for `isothermal_exponent`
    freedom : f, quadratic degrees of freedom of one disc (2, with rotation 3)
    """
    return isothermal_exponent(eta, equation) + 2.0 / freedom * compressibility(eta, equation)


def sound_speed(
    eta: Real, mass: float, temperature: float, equation: str = "kolafa-rottner", freedom: float = 2.0
) -> Real:
    """Speed of sound, c² = gamma Z T/m with the adiabatic gamma [length/time]; as `adiabatic_exponent`."""
    square = adiabatic_exponent(eta, equation, freedom) * compressibility(eta, equation)
    speed: Real = np.sqrt(square * temperature / mass)
    return speed


def column_stiffness(exponent: float, pressure: float, length: float, height: float) -> float:
    """k = gamma P L/h [mass/time²]: force per displacement of a piston on a column of gas.

    Parameters
    ----------
    exponent : gamma, adiabatic or isothermal
    pressure : P of the gas at rest [mass/time²]
    length, height : L along the piston and h of the column, that centres can reach [length]
    """
    return exponent * pressure * length / height


def piston_frequency(spring: float, mass: float, gas_mass: float = 0.0) -> float:
    """Angular frequency of small swings, sqrt(k/(M + m/3)) [radian/time].

    A light gas moves along, at the fixed end not at all: a third of its mass swings too. The standing wave
    of sound in one column has x tan x = m/M with x = omega h/c, which this meets within (m/M)²/90.

    Parameters
    ----------
    spring : k of all columns that the piston rests on [mass/time²]
    mass : M of the piston [mass]
    gas_mass : m of those columns [mass]
    """
    return math.sqrt(spring / (mass + gas_mass / 3.0))
