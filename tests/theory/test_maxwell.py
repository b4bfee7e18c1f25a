"""Maxwell's laws in two dimensions against their own integrals, moments and inverses."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.stats import rayleigh

from gasbox.theory import maxwell

masses = st.floats(1e-3, 1e3)
temperatures = st.floats(1e-3, 1e3)


@given(masses, temperatures)
def test_moments_are_integrals_of_the_density(mass, temperature):
    def moment(power):
        scale = maxwell.most_probable_speed(mass, temperature)
        inner = quad(
            lambda x: (x * scale) ** power * maxwell.speed_pdf(x * scale, mass, temperature) * scale, 0, 40
        )
        return inner[0]

    mean = maxwell.mean_speed(mass, temperature)
    assert moment(0) == pytest.approx(1.0, rel=1e-7)
    assert moment(1) == pytest.approx(mean, rel=1e-7)
    assert moment(2) == pytest.approx(maxwell.rms_speed(mass, temperature) ** 2, rel=1e-7)
    assert moment(2) - mean**2 == pytest.approx(maxwell.speed_variance(mass, temperature), rel=1e-5)
    assert 0.5 * mass * moment(2) == pytest.approx(maxwell.mean_energy(temperature), rel=1e-7)


def test_textbook_ratios():
    # Most probable : median : mean : rms = 1 : 1.17741 : 1.25331 : 1.41421, in units of sqrt(T/m).
    assert maxwell.most_probable_speed(4.0, 9.0) == 1.5
    assert maxwell.median_speed(1.0, 1.0) == pytest.approx(1.17741, abs=5e-6)
    assert maxwell.mean_speed(1.0, 1.0) == pytest.approx(1.25331, abs=5e-6)
    assert maxwell.rms_speed(1.0, 1.0) == pytest.approx(1.41421, abs=5e-6)
    assert maxwell.speed_variance(1.0, 1.0) == pytest.approx(0.42920, abs=5e-6)
    assert maxwell.energy_survival(1.0, 1.0) == pytest.approx(0.3679, abs=5e-5)
    assert maxwell.energy_quantile(0.5, 1.0) == pytest.approx(0.6931, abs=5e-5)


def test_rayleigh_of_scipy():
    speeds = np.linspace(0.0, 6.0, 50)
    law = rayleigh(scale=math.sqrt(2.5 / 0.7))
    np.testing.assert_allclose(maxwell.speed_pdf(speeds, 0.7, 2.5), law.pdf(speeds), rtol=1e-12)
    np.testing.assert_allclose(maxwell.speed_cdf(speeds, 0.7, 2.5), law.cdf(speeds), rtol=1e-12)
    np.testing.assert_allclose(maxwell.speed_survival(speeds, 0.7, 2.5), law.sf(speeds), rtol=1e-12)


def test_density_is_the_slope_of_the_distribution_and_peaks_at_the_most_probable_speed():
    mass, temperature, step = 3.0, 0.4, 1e-5
    for speed in (0.05, 0.365, 1.0):
        rise = maxwell.speed_cdf(speed + step, mass, temperature) - maxwell.speed_cdf(
            speed - step, mass, temperature
        )
        assert maxwell.speed_pdf(speed, mass, temperature) == pytest.approx(rise / (2 * step), rel=1e-7)
    grid = np.linspace(0.0, 2.0, 20001)
    peak = grid[np.argmax(maxwell.speed_pdf(grid, mass, temperature))]
    assert peak == pytest.approx(maxwell.most_probable_speed(mass, temperature), abs=1e-4)


@given(st.floats(0.0, 0.999999), masses, temperatures)
def test_quantile_and_distribution_are_inverses(share, mass, temperature):
    speed = maxwell.speed_quantile(share, mass, temperature)
    energy = maxwell.energy_quantile(share, temperature)
    assert maxwell.speed_cdf(speed, mass, temperature) == pytest.approx(share, abs=1e-12)
    assert maxwell.energy_cdf(energy, temperature) == pytest.approx(share, abs=1e-12)
    assert 0.5 * mass * speed**2 == pytest.approx(energy, rel=1e-12)


@given(st.lists(st.floats(0.0, 5.0), min_size=2, max_size=20, unique=True), masses)
def test_expected_counts_add_up_to_what_lies_between_the_outer_edges(edges, mass):
    ordered = np.sort(np.array(edges))
    counts = maxwell.expected_speed_counts(ordered, 1000.0, mass, 1.0)
    within = maxwell.speed_cdf(ordered[-1], mass, 1.0) - maxwell.speed_cdf(ordered[0], mass, 1.0)
    assert counts.shape == (ordered.size - 1,)
    assert np.all(counts >= 0.0)
    assert counts.sum() == pytest.approx(1000.0 * within, abs=1e-9)
    energy_counts = maxwell.expected_energy_counts(0.5 * mass * ordered**2, 1000.0, 1.0)
    np.testing.assert_allclose(energy_counts, counts, atol=1e-9)


def test_expected_counts_keep_their_digits_in_the_tail():
    # Differences of the distribution function, close to 1, would be zero here.
    counts = maxwell.expected_energy_counts(np.array([50.0, 51.0]), 1.0, 1.0)
    assert counts[0] == pytest.approx(math.exp(-50.0) * (1.0 - math.exp(-1.0)), rel=1e-12)


@pytest.mark.small
def test_at_temperature_zero_everything_rests():
    edges = np.array([0.0, 1.0, 2.0])
    assert maxwell.speed_cdf(0.5, 1.0, 0.0) == 1.0
    assert list(maxwell.expected_speed_counts(edges, 7.0, 1.0, 0.0)) == [7.0, 0.0]
    assert maxwell.speed_quantile(0.9, 1.0, 0.0) == 0.0


@pytest.mark.small
def test_numbers_give_numbers_and_nothing_lies_below_zero():
    assert isinstance(maxwell.speed_pdf(1.0, 1.0, 1.0), float)
    assert maxwell.speed_pdf(-1.0, 1.0, 1.0) == 0.0
    assert maxwell.speed_cdf(-1.0, 1.0, 1.0) == 0.0
    assert maxwell.energy_pdf(-1.0, 1.0) == 0.0
    assert maxwell.energy_pdf(0.0, 2.0) == 0.5
    assert maxwell.energy_survival(np.array([[0.0, -1.0]]), 1.0).shape == (1, 2)
