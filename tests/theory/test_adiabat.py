"""Adiabats, work and entropy against their differential equations, quadrature and a slow piston."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad, solve_ivp

from gasbox.theory import adiabat, hard_disc

COUNT, RADIUS = 200.0, 0.5
DISCS = COUNT * math.pi * RADIUS**2
names = st.sampled_from(list(hard_disc.EQUATIONS))
fractions = st.floats(0.01, 0.65)
freedoms = st.sampled_from([2.0, 3.0])


@pytest.mark.small
def test_published_ratio():
    # Discs from eta = 0.05 to 0.10: 2.2395, points 2.
    ratio = adiabat.adiabatic_temperature(DISCS / 0.1, 1.0, COUNT, RADIUS, DISCS / 0.05)
    assert ratio == pytest.approx(2.2395, abs=5.1e-5)
    assert adiabat.ideal_temperature(1.0, 1.0, 2.0) == 2.0
    assert adiabat.ideal_temperature(1.0, 3.0, 8.0, freedom=3.0) == pytest.approx(12.0, rel=1e-14)


@given(fractions, fractions, freedoms, names)
def test_no_heat_flows_along_the_adiabat(before, after, freedom, name):
    # (f/2) N dT = -P dA, solved step by step with the pressure of `hard_disc`.
    area, new = DISCS / before, DISCS / after
    path = solve_ivp(
        lambda a, t: -2 / (freedom * COUNT) * hard_disc.pressure(COUNT, RADIUS, a, t, name),
        (area, new),
        [1.3],
        method="DOP853",
        rtol=1e-10,
        atol=1e-12,
    )
    found = adiabat.adiabatic_temperature(new, 1.3, COUNT, RADIUS, area, name, freedom)
    assert found == pytest.approx(path.y[0, -1], rel=1e-8)
    pressure = adiabat.adiabatic_pressure(new, 1.3, COUNT, RADIUS, area, name, freedom)
    assert pressure == pytest.approx(hard_disc.pressure(COUNT, RADIUS, new, found, name), rel=1e-12)


@given(st.floats(0.02, 0.6), st.floats(0.02, 0.6), freedoms, names)
def test_work_is_the_integral_of_the_pressure(before, after, freedom, name):
    area, new = DISCS / before, DISCS / after
    slow = quad(
        lambda a: -adiabat.adiabatic_pressure(a, 1.3, COUNT, RADIUS, area, name, freedom),
        area,
        new,
        epsrel=1e-11,
    )
    work = adiabat.adiabatic_work(new, 1.3, COUNT, RADIUS, area, name, freedom)
    assert work == pytest.approx(slow[0], rel=1e-9, abs=1e-9)
    warm = quad(lambda a: -hard_disc.pressure(COUNT, RADIUS, a, 1.3, name), area, new, epsrel=1e-11)
    work = adiabat.isothermal_work(new, 1.3, COUNT, RADIUS, area, name)
    assert work == pytest.approx(warm[0], rel=1e-9, abs=1e-9)
    # A free expansion loses the heat that the isothermal one would have taken up.
    entropy = adiabat.expansion_entropy(new, COUNT, RADIUS, area, name)
    assert entropy == pytest.approx(-warm[0] / 1.3, rel=1e-9, abs=1e-9)


@given(st.floats(0.1, 10.0), freedoms)
def test_points(ratio, freedom):
    area, new = 40.0, 40.0 * ratio
    for radius, name in ((0.0, "kolafa-rottner"), (0.5, "ideal")):
        case = (COUNT, radius, area, name)
        ideal = adiabat.ideal_temperature(new, 1.3, area, freedom)
        assert adiabat.adiabatic_temperature(new, 1.3, *case, freedom) == pytest.approx(ideal, rel=1e-13)
        work = 0.5 * freedom * COUNT * (ideal - 1.3)
        assert adiabat.adiabatic_work(new, 1.3, *case, freedom) == pytest.approx(work, rel=1e-12, abs=1e-11)
        assert adiabat.isothermal_work(new, 1.3, *case) == pytest.approx(
            -COUNT * 1.3 * math.log(ratio), abs=1e-11
        )
        assert adiabat.expansion_entropy(new, *case) == pytest.approx(COUNT * math.log(ratio), abs=1e-11)


@pytest.mark.small
@pytest.mark.parametrize("end", [0.5, 2.0])
def test_particles_before_a_slow_piston(end):
    # In one direction f = 1: T L² constant. Each particle bounces between a wall at rest and a piston that gives
    # it 2u - v. The invariant is kept to O(u/v), and v = 1 at most 1000 u here.
    rng = np.random.default_rng(2)
    start, speed = rng.random(50), 0.5 + rng.random(50)
    piston = math.copysign(5e-4, end - 1.0)
    final = np.array([after_the_stroke(x, v, piston, end) for x, v in zip(start, speed, strict=True)])
    measured = np.mean(final**2) / np.mean(speed**2)
    theory = adiabat.ideal_temperature(end, 1.0, 1.0, freedom=1.0)
    assert measured == pytest.approx(theory, rel=4 * abs(piston) / 0.5)


def after_the_stroke(position, speed, piston, end):
    """Speed of a point after the piston has gone from 1 to `end`, met at x = 1 + u t."""
    time, length = 0.0, 1.0
    path = length - position  # from the point to the piston
    while True:
        time += path / (speed - piston)
        length = 1.0 + piston * time
        if (length - end) * piston >= 0.0:
            return speed
        speed -= 2.0 * piston
        # Back to the wall and out again.
        time, path = time + length / speed, length + piston * length / speed


@pytest.mark.small
def test_entropy_of_mixing():
    assert adiabat.mixing_entropy([[30, 0], [0, 50]]) == 0.0
    assert adiabat.mixing_entropy([[25, 25], [25, 25]]) == pytest.approx(100 * math.log(2), rel=1e-14)
    # Left 3 and 1, right only 4 of the second: -3 ln(3/4) - ln(1/4).
    expected = -3 * math.log(0.75) - math.log(0.25)
    assert adiabat.mixing_entropy([[3, 0], [1, 4]]) == pytest.approx(expected, rel=1e-14)
    assert adiabat.mixing_entropy([[7, 3]]) == 0.0
    assert adiabat.mixing_entropy([[0, 0], [0, 0]]) == 0.0


@pytest.mark.small
def test_entropy_of_spreading():
    assert adiabat.spreading_entropy([10, 30], [1.0, 3.0]) == pytest.approx(0.0, abs=1e-13)
    assert adiabat.spreading_entropy([40, 0], [1.0, 1.0]) == pytest.approx(-40 * math.log(2), rel=1e-14)
    # From all in a quarter to even is the free expansion of points to four times the area, species by species.
    gained = 0.0 - adiabat.spreading_entropy([[40, 0], [0, 9]], [1.0, 3.0])
    expansions = adiabat.expansion_entropy(4.0, 40, 0.0, 1.0) + adiabat.expansion_entropy(4.0, 9, 0.0, 3.0)
    assert gained == pytest.approx(expansions, rel=1e-13)
    # Stirling: the logarithm of the number of ways over 2^N, but for half a logarithm.
    ways = math.lgamma(1001) - math.lgamma(301) - math.lgamma(701) - 1000 * math.log(2)
    assert adiabat.spreading_entropy([300, 700], [1.0, 1.0]) == pytest.approx(ways, abs=5.0)


@pytest.mark.small
def test_arrays_and_what_lies_outside():
    areas = DISCS / np.array([0.05, 0.1, 0.75])
    temperatures = adiabat.adiabatic_temperature(areas, 2.0, COUNT, RADIUS, DISCS / 0.05)
    assert temperatures[0] == 2.0
    assert math.isnan(temperatures[2])
    assert math.isnan(adiabat.isothermal_work(DISCS / 0.1, 1.0, COUNT, RADIUS, DISCS / 0.75))
    assert isinstance(adiabat.adiabatic_pressure(DISCS / 0.1, 2.0, COUNT, RADIUS, DISCS / 0.05), float)
