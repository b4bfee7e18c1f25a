"""A gas as a spring, against differences of the equation of state and a piston set free."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from gasbox.theory import adiabat, hard_disc, piston

# eta and speed of sound in units of sqrt(T/m), by Kolafa and Rottner's equation.
SOUND = [
    (0.01, 1.4429),
    (0.05, 1.5666),
    (0.10, 1.7441),
    (0.20, 2.1993),
    (0.30, 2.8515),
    (0.50, 5.4162),
    (0.60, 8.2226),
]


@pytest.mark.small
@pytest.mark.parametrize(("eta", "speed"), SOUND)
def test_published_speed_of_sound(eta, speed):
    assert piston.sound_speed(eta, 4.0, 9.0) == pytest.approx(1.5 * speed, abs=1.5 * 5.1e-5)


@given(st.floats(0.01, 0.6), st.sampled_from([2.0, 3.0]), st.sampled_from(list(hard_disc.EQUATIONS)))
def test_exponents_are_slopes_of_the_pressure(eta, freedom, name):
    count, radius, step = 100.0, 0.5, 1e-4
    area = count * math.pi * radius**2 / eta

    def slope(pressure):
        return -math.log(pressure(area * math.exp(step)) / pressure(area * math.exp(-step))) / (2 * step)

    warm = slope(lambda a: hard_disc.pressure(count, radius, a, 1.0, name))
    assert piston.isothermal_exponent(eta, name) == pytest.approx(warm, rel=1e-6)
    fast = slope(lambda a: adiabat.adiabatic_pressure(a, 1.0, count, radius, area, name, freedom))
    assert piston.adiabatic_exponent(eta, name, freedom) == pytest.approx(fast, rel=1e-6)


@pytest.mark.small
def test_points():
    for name in hard_disc.EQUATIONS:
        assert piston.isothermal_exponent(0.0, name) == 1.0
        assert piston.adiabatic_exponent(0.0, name) == 2.0
        assert piston.adiabatic_exponent(0.0, name, freedom=3.0) == pytest.approx(5 / 3, rel=1e-15)
    assert piston.adiabatic_exponent(0.3, "ideal") == 2.0
    assert math.isnan(piston.isothermal_exponent(0.8))
    assert np.isnan(piston.sound_speed(np.array([0.1, 0.8]), 1.0, 1.0)).tolist() == [False, True]


@pytest.mark.small
def test_a_piston_set_free_swings_at_this_frequency():
    # A piston of mass 50 between two columns of discs, moved by 0.01 % of a column and let go: half a period later
    # it stands still again on the other side.
    length, heights, mass, temperature, radius = 20.0, (12.0, 18.0), 50.0, 1.5, 0.5
    count = 100.0
    pressure = hard_disc.pressure(count, radius, length * heights[0], temperature)
    other = equal_pressure(pressure, length * heights[1], temperature, radius)
    numbers = (count, other)

    def force(shift):
        sides = zip(numbers, heights, (1.0, -1.0), strict=True)
        below, above = (
            adiabat.adiabatic_pressure(length * (h + sign * shift), temperature, n, radius, length * h)
            for n, h, sign in sides
        )
        return length * (below - above)

    def spring(exponent):
        etas = [n * math.pi * radius**2 / (length * h) for n, h in zip(numbers, heights, strict=True)]
        return sum(
            piston.column_stiffness(exponent(eta), pressure, length, h)
            for eta, h in zip(etas, heights, strict=True)
        )

    def stands(time, state):
        return state[1] if time > 0.0 else 1.0

    stands.terminal, stands.direction = True, -1
    swing = solve_ivp(
        lambda _, s: [s[1], force(s[0]) / mass],
        (0, 100.0),
        [-0.0012, 0.0],
        events=stands,
        rtol=1e-10,
        atol=1e-14,
    )
    frequency = piston.piston_frequency(spring(piston.adiabatic_exponent), mass)
    # The shift enters the frequency by its square, 1e-8.
    assert math.pi / swing.t_events[0][0] == pytest.approx(frequency, rel=1e-6)
    assert piston.piston_frequency(spring(piston.isothermal_exponent), mass) < 0.9 * frequency


def equal_pressure(pressure, area, temperature, radius):
    """How many discs in an area press as much."""
    return brentq(
        lambda n: hard_disc.pressure(n, radius, area, temperature) - pressure, 1.0, 250.0, xtol=1e-12
    )


@pytest.mark.small
@pytest.mark.parametrize("share", [0.05, 0.3, 1.0])
def test_gas_that_moves_along(share):
    # A standing wave of sound under the piston: x tan x = m/M, x = omega h/c, and k = gamma P L/h = m (c/h)².
    x = brentq(lambda at: at * math.tan(at) - share, 1e-9, 1.5)
    found = piston.piston_frequency(share, 1.0, gas_mass=share)
    assert found == pytest.approx(x, rel=share**2 / 90)
    assert abs(piston.piston_frequency(share, 1.0) - x) > 0.1 * share * x
