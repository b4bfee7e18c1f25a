"""Pair laws: shapes at the cutoff, forces as slopes, minima, second virial coefficients."""

import math

import numpy as np
import pytest
from some_laws import ALL, FULL, TRUNCATED, Law

from gasbox.theory import imperfect, pair_laws

pytestmark = pytest.mark.small

TEMPERATURES = (0.45, 0.5, 0.6, 0.7, 0.8, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0)
# By independent quadrature, in units of sigma², rounded to four digits.
B2_FULL = (-7.6592, -5.9867, -3.9447, -2.7612, -1.9962, -1.0735, -0.0681, 0.3507, 0.7141, 0.9551, 1.0804)
B2_TRUNCATED = (-6.8635, -5.3228, -3.4445, -2.3588, -1.6589, -0.8180, 0.0920, 0.4675, 0.7901, 1.0, 1.1026)
# Likewise, in units of sigma to the fourth.
B3_TEMPERATURES = (0.45, 0.5, 0.7, 1.0, 2.0, 10.0)
B3_FULL = (-12.07, -0.075, 4.326, 2.426, 1.249, 1.138)
B3_TRUNCATED = (-4.27, 3.466, 4.507, 2.336, 1.222, 1.141)


def ids(law):
    return f"{law.law} {law.truncation}"


@pytest.mark.parametrize("law", ALL, ids=ids)
def test_the_force_is_the_slope_of_the_potential(law):
    distance = np.linspace(0.8, 0.999 * pair_laws.cutoff_of(law), 57)
    step = 1e-6
    slope = (pair_laws.potential(law, distance + step) - pair_laws.potential(law, distance - step)) / (
        2 * step
    )
    inside = distance + step < pair_laws.cutoff_of(law)
    # A central difference is off by u''' step²/6, and by rounding of some 1e-16/step of u, at most 1e4 here.
    scale = 1.0 + np.abs(slope)
    assert np.max(np.abs(pair_laws.force(law, distance) + slope)[inside] / scale[inside]) < 1e-6


@pytest.mark.parametrize("law", ALL, ids=ids)
def test_nothing_is_left_at_the_cutoff(law):
    cutoff = pair_laws.cutoff_of(law)
    just_inside = cutoff * (1.0 - 1e-9)
    assert pair_laws.potential(law, just_inside) == pytest.approx(0.0, abs=1e-7)
    assert pair_laws.potential(law, cutoff) == pair_laws.force(law, 2.0 * cutoff) == 0.0
    if law.truncation == "force-shifted":
        assert pair_laws.force(law, just_inside) == pytest.approx(0.0, abs=1e-6)


def test_numbers_of_lennard_jones():
    assert pair_laws.potential(FULL, 2.5) == pytest.approx(-0.016316891, abs=1e-9)
    assert pair_laws.force(FULL, 2.5) == pytest.approx(-0.038999, abs=1e-6)
    assert pair_laws.potential(TRUNCATED, 1.0) == pytest.approx(0.016316891, abs=1e-9)
    assert pair_laws.force(TRUNCATED, 2.49) == pair_laws.force(FULL, 2.49)
    place, depth = pair_laws.lowest(FULL)
    assert (place, depth) == pytest.approx((2 ** (1 / 6), -1.0), abs=1e-9)
    assert pair_laws.lowest(TRUNCATED) == pytest.approx((2 ** (1 / 6), -1.0 + 0.016316891), abs=1e-9)


def test_other_laws_in_the_head():
    wca, soft, yukawa, well = (
        Law(name, 2.0, 1.5, math.inf) for name in ("wca", "soft-sphere", "yukawa", "square-well")
    )
    assert pair_laws.potential(wca, 1.5) == pytest.approx(2.0)
    assert pair_laws.lowest(wca) == (pair_laws.cutoff_of(wca), 0.0)
    assert pair_laws.potential(soft, 3.0) == pytest.approx(2.0 / 4096)
    assert pair_laws.virial(soft, 3.0) == pytest.approx(24.0 / 4096)
    assert pair_laws.potential(yukawa, 3.0) == pytest.approx(math.exp(-1.5))
    # Half-way up the edge of the well, at one and a half sigma.
    assert pair_laws.potential(well, 2.25) == pytest.approx(-1.0, abs=1e-5)
    assert pair_laws.lowest(well)[1] == pytest.approx(-2.0, rel=1e-3)
    assert pair_laws.potential(Law("none", cutoff=0.0), 1.0) == 0.0
    with pytest.raises(ValueError, match="no pair law 'gravity'"):
        pair_laws.potential(Law("gravity"), 1.0)


@pytest.mark.parametrize(("law", "expected"), [(FULL, B2_FULL), (TRUNCATED, B2_TRUNCATED)])
def test_second_virial_coefficients(law, expected):
    found = [imperfect.second_virial(law, temperature) for temperature in TEMPERATURES]
    assert found == pytest.approx(expected, abs=1e-4)


def test_second_virial_coefficients_scale():
    scaled = Law(epsilon=3.0, sigma=2.0, cutoff=5.0)
    assert imperfect.second_virial(scaled, 3.0) == pytest.approx(
        4.0 * imperfect.second_virial(TRUNCATED, 1.0), rel=1e-9
    )
    # Inverse powers: B_2 = (pi/2) sigma² (eps/T)^(1/6) Gamma(5/6).
    soft = Law("soft-sphere", 2.0, 1.0, math.inf)
    exact = 0.5 * math.pi * (2.0 / 0.7) ** (1 / 6) * math.gamma(5 / 6)
    assert imperfect.second_virial(soft, 0.7) == pytest.approx(exact, rel=1e-9)
    assert imperfect.second_virial(Law("none", cutoff=0.0), 1.0) == 0.0


def test_boyle_temperatures():
    assert imperfect.boyle_temperature(FULL) == pytest.approx(1.56014, abs=1e-5)
    assert imperfect.boyle_temperature(TRUNCATED) == pytest.approx(1.41979, abs=1e-5)


@pytest.mark.parametrize(("law", "expected"), [(TRUNCATED, B3_TRUNCATED), (FULL, B3_FULL)])
def test_third_virial_coefficients(law, expected):
    found = [imperfect.third_virial(law, temperature) for temperature in B3_TEMPERATURES]
    # At 0.45 and below terms of hundreds nearly cancel; the tables there have four digits, or two decimals.
    assert found == pytest.approx(expected, rel=1e-3, abs=5e-3)


def test_third_virial_coefficients_scale():
    scaled = Law(epsilon=3.0, sigma=2.0, cutoff=5.0)
    expected = 16.0 * imperfect.third_virial(TRUNCATED, 1.0)
    assert imperfect.third_virial(scaled, 3.0) == pytest.approx(expected, rel=1e-9)
    assert imperfect.third_virial(Law("none", cutoff=0.0), 1.0) == 0.0


@pytest.mark.parametrize(
    ("law", "density", "expected"),
    [(TRUNCATED, 0.05, 0.04825), (TRUNCATED, 0.1, 0.09416), (FULL, 0.1, 0.09169)],
)
def test_pressure_of_a_dilute_gas(law, density, expected):
    # The series to the third coefficient, by independent quadrature.
    assert imperfect.virial_gas_pressure(law, density, 1.0) == pytest.approx(expected, abs=1e-5)
