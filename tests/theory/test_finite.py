"""Laws of a few particles at fixed energy: normalised, with the right mean, and Maxwell's in the limit."""

import math

import numpy as np
import pytest
from scipy.integrate import quad

from gasbox.theory import finite, maxwell


@pytest.mark.parametrize("count", [2, 3, 8])
def test_energy_law_between_walls(count):
    total, freedom = 5.0, 2 * count
    temperature = 2 * total / freedom
    density = quad(lambda e: finite.finite_energy_pdf(e, total, freedom), 0, total)[0]
    mean = quad(lambda e: e * finite.finite_energy_pdf(e, total, freedom), 0, total)[0]
    square = quad(lambda e: e * e * finite.finite_energy_pdf(e, total, freedom), 0, total)[0]
    assert density == pytest.approx(1.0, rel=1e-9)
    assert mean == pytest.approx(temperature, rel=1e-9)
    assert square - mean**2 == pytest.approx(temperature**2 * (count - 1) / (count + 1), rel=1e-8)
    for energy in (0.1, 2.0, 4.9):
        below = quad(lambda e: finite.finite_energy_pdf(e, total, freedom), 0, energy)[0]
        assert finite.finite_energy_cdf(energy, total, freedom) == pytest.approx(below, rel=1e-9)


def test_energy_law_where_momentum_is_conserved():
    # Five particles, one of mass 3 among four of mass 1, in the frame of their centre of mass: mean T (1 - m/M).
    total, freedom, masses = 4.0, 8, np.array([3.0, 1.0, 1.0, 1.0, 1.0])
    temperature = 2 * total / freedom
    for mass in (3.0, 1.0):
        greatest = total * (1 - mass / masses.sum())
        mean = quad(lambda e, top=greatest: e * finite.finite_energy_pdf(e, top, freedom), 0, greatest)[0]
        expected = temperature * finite.energy_share(mass, masses.sum(), conserved=2)
        assert mean == pytest.approx(expected, rel=1e-9)
    shares = [finite.energy_share(mass, masses.sum(), 2) for mass in masses]
    assert sum(shares) * temperature == pytest.approx(total)


def test_sampling_the_sphere_gives_the_law():
    # Independent of any engine: normalised Gaussian vectors are spread evenly over the sphere.
    rng = np.random.default_rng(5)
    vectors = rng.normal(size=(20_000, 6))
    vectors /= np.linalg.norm(vectors, axis=1)[:, None]
    energy = np.sort(np.sum(vectors[:, :2] ** 2, axis=1))
    law = finite.finite_energy_cdf(energy, 1.0, 6)
    rank = np.arange(1, energy.size + 1) / energy.size
    distance = np.max(np.maximum(np.abs(rank - law), np.abs(rank - 1 / energy.size - law)))
    assert distance < 1.95 / math.sqrt(energy.size)  # 0.1 % level of Kolmogorov and Smirnov


def test_many_particles_obey_maxwell():
    energies = np.linspace(0.0, 5.0, 11)
    count = 10**6
    np.testing.assert_allclose(
        finite.finite_energy_cdf(energies, float(count), 2 * count),
        maxwell.energy_cdf(energies, 1.0),
        atol=1e-5,
    )


@pytest.mark.small
def test_ends_of_the_law():
    assert finite.finite_energy_cdf(-1.0, 2.0, 6) == 0.0
    assert finite.finite_energy_cdf(2.0, 2.0, 6) == 1.0
    assert finite.finite_energy_pdf(2.5, 2.0, 6) == 0.0
    assert finite.energy_share(1.0, 2.0, 0) == 1.0
    assert finite.energy_share(1.0, 1.0, 2) == 0.0
