"""The barometric law against quadrature, published numbers, samples and its own limits."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from gasbox.theory import gravity

# H/ell, <y>/H, heat capacity per disc; exact, rounded to the digits shown.
TABLE = [
    (0.1, 0.49167, 1.0008),
    (0.5, 0.45851, 1.0206),
    (1.0, 0.41802, 1.0793),
    (2.0, 0.34348, 1.2759),
    (3.0, 0.28094, 1.5037),
    (5.0, 0.19322, 1.8293),
    (10.0, 0.09995, 1.9955),
]


@pytest.mark.small
@pytest.mark.parametrize(("rise", "mean", "heat"), TABLE)
def test_published_values(rise, mean, heat):
    for scale in (1.0, 7.0):
        assert gravity.mean_height(scale, rise * scale) == pytest.approx(mean * rise * scale, rel=6e-5)
        assert gravity.heat_capacity(scale, rise * scale) == pytest.approx(heat, abs=5.1e-5)


@pytest.mark.parametrize("room", [0.01, 3.0, 3.6, 40.0, 4000.0, math.inf])
def test_moments_are_integrals_of_the_density(room):
    scale, count, width = 6.0, 50.0, 4.0
    end = min(room, 60 * scale)

    def moment(power):
        return quad(
            lambda y: width / count * y**power * gravity.density(y, count, width, scale, room),
            0,
            end,
            epsabs=0.0,
            epsrel=1e-12,
            limit=200,
        )[0]

    mean = gravity.mean_height(scale, room)
    assert moment(0) == pytest.approx(1.0, rel=1e-10)
    assert moment(1) == pytest.approx(mean, rel=1e-10)
    assert moment(2) == pytest.approx(gravity.height_variance(scale, room) + mean**2, rel=1e-10)


@given(st.floats(1e-6, 1e3), st.floats(0.5, 20.0), st.sampled_from([2.0, 3.0]))
def test_heat_capacity_is_the_slope_of_the_energy(rise, temperature, freedom):
    # m g = 1, so that ell = T and the energy of a disc is f T/2 + <y>.
    room, step = rise * temperature, 1e-4 * temperature

    def energy(at):
        return 0.5 * freedom * at + gravity.mean_height(at, room)

    slope = (energy(temperature + step) - energy(temperature - step)) / (2 * step)
    # Rounding of the heights, 1e-16 H/step, and the cubic term of the difference, 1e-8.
    assert gravity.heat_capacity(temperature, room, freedom) == pytest.approx(slope, abs=1e-7 + 1e-11 * rise)


def test_samples_obey_the_law():
    # Points that fall and bounce without loss, at a random time of their flight: p(y) of a Boltzmann gas follows
    # from dynamics alone. With m = g = T = 1 the energy above the floor E = y + v²/2 has the density
    # sqrt(E) exp(-E), since the flight over the floor lasts 2 sqrt(2 E).
    rng = np.random.default_rng(11)
    energy = rng.gamma(1.5, size=40_000)
    flight = 2 * np.sqrt(2 * energy)
    time = rng.random(energy.size) * flight
    height = np.sort(np.sqrt(2 * energy) * time - 0.5 * time**2)
    law = gravity.height_cdf(height, 1.0)
    rank = np.arange(1, height.size + 1) / height.size
    distance = np.max(np.maximum(np.abs(rank - law), np.abs(rank - 1 / height.size - law)))
    assert distance < 1.95 / math.sqrt(height.size)  # 0.1 % level of Kolmogorov and Smirnov
    # Mean 1 and variance 1, so a standard error of 1/sqrt(n); five of them.
    assert height.mean() == pytest.approx(gravity.mean_height(1.0), abs=5 / math.sqrt(height.size))


@given(st.floats(0.1, 10.0), st.floats(0.1, 50.0), st.integers(1, 30))
def test_counts_in_bins_are_integrals(scale, room, bins):
    edges = np.linspace(0.0, room, bins + 1)
    counts = gravity.expected_height_counts(edges, 70.0, scale, room)
    np.testing.assert_allclose(counts, 70.0 * np.diff(gravity.height_cdf(edges, scale, room)), atol=1e-12)
    assert counts.sum() == pytest.approx(70.0, rel=1e-12)
    middle = quad(lambda y: gravity.density(y, 70.0, 2.0, scale, room), edges[0], edges[1])[0]
    assert counts[0] == pytest.approx(2.0 * middle, rel=1e-9)


@pytest.mark.small
def test_counts_keep_their_digits_far_up():
    counts = gravity.expected_height_counts(np.array([50.0, 51.0]), 1.0, 1.0)
    assert counts[0] == pytest.approx(math.exp(-50.0) * (1.0 - math.exp(-1.0)), rel=1e-12)


@pytest.mark.small
def test_series_and_closed_form_meet():
    # At x = 0.3, H = 0.6 ell. Values by 60-digit arithmetic.
    for room in (0.6 * (1 - 1e-15), 0.6 * (1 + 1e-15)):
        assert gravity.mean_height(1.0, room) == pytest.approx(0.2701784709034775, rel=4e-15)
        assert gravity.height_variance(1.0, room) == pytest.approx(0.02946761820920931, rel=1e-12)


@pytest.mark.small
def test_without_gravity_and_without_a_lid():
    assert gravity.scale_height(2.0, 3.0, 0.5) == 3.0
    none = gravity.scale_height(2.0, 3.0, 0.0)
    assert none == math.inf
    assert gravity.mean_height(none, 8.0) == 4.0
    assert gravity.height_variance(none, 6.0) == pytest.approx(3.0, rel=1e-15)
    assert gravity.heat_capacity(none, 8.0) == 1.0
    np.testing.assert_allclose(
        gravity.density(np.array([-1.0, 0.0, 8.0, 9.0]), 40, 5.0, none, 8.0), [0, 1, 1, 0]
    )
    assert gravity.height_cdf(2.0, none, 8.0) == 0.25
    assert list(gravity.expected_height_counts(np.array([0.0, 2.0, 8.0, 9.0]), 8, none, 8.0)) == [
        2.0,
        6.0,
        0.0,
    ]
    assert gravity.mean_height(3.0) == gravity.mean_height(3.0, 1e5) == 3.0
    assert gravity.height_variance(3.0) == gravity.height_variance(3.0, 1e5) == 9.0
    assert gravity.heat_capacity(3.0) == gravity.heat_capacity(3.0, 1e5) == 2.0
    assert gravity.heat_capacity(3.0, freedom=3.0) == 2.5
    assert isinstance(gravity.density(1.0, 40, 5.0, 3.0), float)


@given(st.floats(0.01, 100.0), st.floats(0.01, 100.0))
def test_floor_and_lid_differ_by_the_weight(mass, acceleration):
    # P = n T at floor and lid of an ideal gas.
    count, width, room, temperature = 300.0, 12.0, 3.0, 2.0
    scale = gravity.scale_height(mass, temperature, acceleration)
    floor, lid = (temperature * gravity.density(y, count, width, scale, room) for y in (0.0, room))
    weight = gravity.weight_pressure(count, mass, acceleration, width)
    # The difference of two nearly equal pressures loses digits where gravity is weak.
    assert floor - lid == pytest.approx(weight, rel=1e-12, abs=1e-14 * floor)
