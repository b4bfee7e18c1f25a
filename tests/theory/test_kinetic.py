"""Collision rates and free paths against published values and among each other."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gasbox.theory import Mixture, finite, hard_disc, kinetic, maxwell

# eta, omega in units of sqrt(T/m)/sigma, lambda in units of sigma; exact from Z by omega = 4 (Z - 1)/sqrt(pi).
TABLE = [
    (0.01, 0.04585, 27.335),
    (0.05, 0.24460, 5.1238),
    (0.10, 0.53292, 2.3518),
    (0.20, 1.28718, 0.9737),
    (0.30, 2.39952, 0.5223),
    (0.50, 7.01030, 0.1788),
    (0.60, 12.3114, 0.1018),
]


def pure(eta, count=100, mass=1.0, radius=0.5):
    return Mixture.of([count], [mass], [radius], count * math.pi * radius**2 / eta)


@pytest.mark.parametrize(("eta", "omega", "path"), TABLE)
def test_published_values(eta, omega, path):
    gas = pure(eta)
    assert kinetic.collision_rates(gas, 1.0)[0, 0] == pytest.approx(omega, rel=1.2e-4)
    assert kinetic.mean_free_path(gas, 1.0) == pytest.approx(path, rel=6e-4)
    rate = 4 * (hard_disc.kolafa_rottner(eta) - 1) / math.sqrt(math.pi)
    assert kinetic.collision_rates(gas, 1.0)[0, 0] == pytest.approx(rate, rel=1e-10)


@given(st.floats(0.01, 0.6), st.floats(0.1, 10.0), st.floats(0.1, 10.0), st.floats(0.01, 10.0))
def test_pure_gas_in_any_units(eta, mass, radius, temperature):
    gas = pure(eta, mass=mass, radius=radius)
    chi = hard_disc.contact_value(gas.area_fraction)
    density = gas.total / gas.area
    omega = 2 * density * 2 * radius * chi * math.sqrt(math.pi * temperature / mass)
    assert kinetic.collision_rates(gas, temperature)[0, 0] == pytest.approx(omega, rel=1e-12)
    path = 1 / (2 * math.sqrt(2) * density * 2 * radius * chi)
    assert kinetic.mean_free_path(gas, temperature) == pytest.approx(path, rel=1e-12)
    assert kinetic.mean_free_paths(gas, temperature)[0] == pytest.approx(path, rel=1e-12)


@given(st.lists(st.integers(1, 500), min_size=2, max_size=4), st.floats(0.01, 0.6))
def test_alike_species_collide_like_one(counts, eta):
    number = sum(counts)
    one = pure(eta, number)
    split = Mixture.of(counts, [1.0] * len(counts), [0.5] * len(counts), one.area)
    rates = kinetic.collision_rates(split, 1.5)
    np.testing.assert_allclose(rates.sum(axis=1), kinetic.collision_rates(one, 1.5)[0, 0], rtol=1e-12)
    all_pairs = kinetic.pair_rates(split, 1.5).sum()
    assert all_pairs == pytest.approx(kinetic.pair_rates(one, 1.5).sum(), rel=1e-12)
    assert kinetic.mean_free_path(split, 1.5) == pytest.approx(kinetic.mean_free_path(one, 1.5), rel=1e-12)


def test_each_collision_counts_once_for_either_side():
    gas = Mixture.of([300, 40], [1.0, 16.0], [1.0, 2.5], 20000.0)
    omega = kinetic.collision_rates(gas, 0.7)
    assert 300 * omega[0, 1] == pytest.approx(40 * omega[1, 0], rel=1e-14)
    pairs = kinetic.pair_rates(gas, 0.7)
    assert pairs[0, 1] == pytest.approx(300 * omega[0, 1], rel=1e-14)
    assert pairs[0, 0] == pytest.approx(299 * omega[0, 0] / 2, rel=1e-14)
    assert pairs[1, 0] == 0.0


def test_rate_of_a_rare_species_is_what_it_sweeps():
    # A single disc among points at rest-like heavy scatterers: n (2 sigma_12) <v_rel> in the dilute limit.
    gas = Mixture.of([1, 10], [1.0, 1e9], [0.5, 0.25], 1e7)
    swept = 10 / 1e7 * 2 * 0.75 * maxwell.mean_speed(1.0, 2.0)
    assert kinetic.collision_rates(gas, 2.0)[0, 1] == pytest.approx(swept, rel=1e-5)


@pytest.mark.small
def test_relative_speed():
    assert kinetic.relative_speed(2.0, 2.0, 3.0) == pytest.approx(math.sqrt(2) * maxwell.mean_speed(2.0, 3.0))
    assert kinetic.relative_speed(1.0, 1.0, 4.0, 0.0) == pytest.approx(maxwell.mean_speed(1.0, 4.0))
    mu = 1 * 4 / 5
    assert kinetic.relative_speed(1.0, 4.0, 1.0) == pytest.approx(math.sqrt(math.pi / (2 * mu)))


@pytest.mark.small
def test_without_partners_there_is_no_end_to_a_path():
    alone = Mixture.of([1, 0], [1, 1], [1, 1], 100.0)
    assert kinetic.pair_rates(alone, 1.0).sum() == 0.0
    points = Mixture.of([5], [1], [1], 100.0)
    assert kinetic.collision_rates(points, 1.0, "ideal").sum() == 0.0
    assert kinetic.mean_free_path(points, 1.0, "ideal") == math.inf
    assert kinetic.mean_free_paths(points, 1.0, "ideal")[0] == math.inf


def test_wall_flux_is_density_times_a_quarter_turn_of_the_mean_speed():
    assert kinetic.wall_flux(50, 2.0, 10.0, 3.0) == pytest.approx(
        5.0 * maxwell.mean_speed(2.0, 3.0) / math.pi
    )
    # Pressure is flux times mean impulse 2 m <v_n> over hits, <v_n> = sqrt(pi T/(2m)): n T.
    impulse = 2 * 2.0 * math.sqrt(math.pi * 3.0 / (2 * 2.0))
    assert kinetic.wall_flux(50, 2.0, 10.0, 3.0) * impulse == pytest.approx(5.0 * 3.0)


def test_equalisation_of_two_species():
    gas = Mixture.of([100, 100], [1.0, 1.0], [0.5, 0.5], 4000.0)
    omega = kinetic.collision_rates(gas, 1.0)
    # Equal masses: 4 m1 m2/(m1+m2)² = 1.
    assert kinetic.equalisation_rate(gas, 1.0) == pytest.approx(omega[0, 1] + omega[1, 0])
    heavy = Mixture.of([100, 100], [1.0, 99.0], [0.5, 0.5], 4000.0)
    rates = kinetic.collision_rates(heavy, 1.0)
    assert kinetic.equalisation_rate(heavy, 1.0) == pytest.approx(4 * 99 / 1e4 * (rates[0, 1] + rates[1, 0]))


FACTORS = [(2, 1.12838), (4, 1.06385), (6, 1.04235), (14, 1.0180), (30, 1.0084), (126, 1.0020), (510, 1.0005)]


@pytest.mark.parametrize(("freedom", "factor"), FACTORS)
def test_collision_rate_at_fixed_energy(freedom, factor):
    assert finite.rate_factor(freedom) == pytest.approx(factor, abs=6e-5)


def test_rate_factor_is_smooth_where_the_series_takes_over():
    values = [finite.rate_factor(f) for f in (199.0, 199.999999, 200.0, 201.0)]
    assert values == sorted(values, reverse=True)
    assert values[1] == pytest.approx(values[2], rel=1e-10)
