"""Mixtures: alike species are the pure fluid, contact values give the pressure."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gasbox.theory import Mixture, hard_disc
from gasbox.theory.mixture import compressibility, contact_values, ideal_pressure, pressure

counts = st.lists(st.integers(1, 1000), min_size=1, max_size=4)


def filled(count, mass, radius, eta):
    """A mixture in an area that it fills to `eta`."""
    count, radius = np.array(count, float), np.array(radius, float)
    return Mixture.of(count, mass, radius, np.sum(count * math.pi * radius**2) / eta)


@given(counts, st.floats(0.01, 10.0), st.floats(0.01, 0.69), st.sampled_from(["henderson", "kolafa-rottner"]))
def test_alike_species_are_the_pure_fluid(count, radius, eta, equation):
    alike = [1.0] * len(count)
    gas = filled(count, alike, [radius] * len(count), eta)
    pure = hard_disc.EQUATIONS[equation](gas.area_fraction)
    assert compressibility(gas, equation) == pytest.approx(pure, rel=1e-12)
    chi = hard_disc.contact_value(gas.area_fraction, equation)
    np.testing.assert_allclose(contact_values(gas, equation), chi, rtol=1e-12)
    one = hard_disc.pressure(sum(count), radius, gas.area, 2.0, equation)
    assert pressure(gas, 2.0, equation) == pytest.approx(one, rel=1e-12)


@given(
    st.lists(st.tuples(st.integers(1, 100), st.floats(0.02, 1.0)), min_size=1, max_size=5),
    st.floats(0.01, 0.6),
)
def test_pressure_follows_from_the_contact_values(species, eta):
    count, radius = zip(*species, strict=True)
    gas = filled(count, [1.0] * len(count), radius, eta)
    share = gas.count / gas.total
    density = gas.total / gas.area
    virial = np.sum(np.outer(share, share) * gas.contact_distance**2 * contact_values(gas))
    assert compressibility(gas) == pytest.approx(1.0 + 0.5 * math.pi * density * virial, rel=1e-10)


def test_contact_values_of_jenkins_and_mancini():
    # chi_ij = 1/(1 - eta) + (9/16) eta/(1 - eta)² z_ij for Henderson's chi.
    gas = filled([30, 10], [1.0, 4.0], [1.0, 3.0], 0.35)
    eta, sigma = gas.area_fraction, 2 * gas.radius
    mean, square = 0.75 * sigma[0] + 0.25 * sigma[1], 0.75 * sigma[0] ** 2 + 0.25 * sigma[1] ** 2
    for i in range(2):
        for j in range(2):
            z = sigma[i] * sigma[j] / (0.5 * (sigma[i] + sigma[j])) * mean / square
            expected = 1 / (1 - eta) + 9 / 16 * eta / (1 - eta) ** 2 * z
            assert contact_values(gas, "henderson")[i, j] == pytest.approx(expected, rel=1e-12)


def test_second_virial_coefficient_of_a_mixture_is_exact():
    gas = filled([3, 1], [1.0, 1.0], [1.0, 2.0], 1e-6)
    share, density = gas.count / gas.total, gas.total / gas.area
    second = 0.5 * math.pi * np.sum(np.outer(share, share) * gas.contact_distance**2)
    assert (compressibility(gas) - 1.0) / density == pytest.approx(second, rel=1e-5)


def test_points_among_discs_feel_only_the_free_area():
    # A point species: its partial pressure is that of an ideal gas in what the discs leave, N T/(A (1 - eta)).
    gas = filled([1000, 1], [1.0, 1.0], [1e-9, 1.0], 0.2)
    assert contact_values(gas)[0, 0] == pytest.approx(1 / 0.8, rel=1e-6)


@pytest.mark.small
def test_nothing_and_too_much():
    empty = Mixture.of([0, 0], [1, 1], [1, 2], 100.0)
    assert compressibility(empty) == 1.0
    assert pressure(empty, 1.0) == 0.0
    dense = filled([10], [1.0], [1.0], 0.75)
    assert pressure(dense, 1.0) is None
    assert pressure(dense, 1.0, "henderson") is not None
    assert pressure(dense, 1.0, "ideal") == ideal_pressure(dense, 1.0) == pytest.approx(10 / dense.area)
    points = Mixture.of([5], [1], [0], 10.0)
    assert pressure(points, 2.0) == pytest.approx(1.0)


@pytest.mark.small
def test_what_a_mixture_knows():
    gas = Mixture.of([2, 3], [1, 4], [1, 2], 50 * math.pi)
    assert gas.total == 5
    assert gas.area_fraction == pytest.approx(14 / 50)
    np.testing.assert_allclose(gas.density, np.array([2, 3]) / (50 * math.pi))
    np.testing.assert_allclose(gas.contact_distance, [[2, 3], [3, 4]])
    np.testing.assert_allclose(gas.reduced_mass, [[0.5, 0.8], [0.8, 2.0]])
