"""Heat capacity from fluctuations that are drawn from the laws themselves."""

import math

import numpy as np
import pytest

from gasbox.observe import capacity_at_fixed_energy, capacity_at_fixed_temperature

pytestmark = pytest.mark.small

COUNT, FRAMES = 50, 40_000


def test_fixed_energy():
    # Velocities spread evenly over a sphere in 3N dimensions, of which 2N are flight: C = 3N/2.
    generator = np.random.default_rng(2)
    normal = generator.normal(size=(FRAMES, 3 * COUNT)) ** 2
    flight = np.sum(normal[:, : 2 * COUNT], axis=1) / np.sum(normal, axis=1)
    found = capacity_at_fixed_energy(flight, 2 * COUNT)
    # 1 - f/(2C) = 1/3, known to sqrt(2/frames); so C to half of that. And f/2 instead of f/2 + 1 from the sphere.
    error = 0.5 * math.sqrt(2 / FRAMES) + 1 / (1.5 * COUNT)
    assert found / COUNT == pytest.approx(1.5, rel=4 * error)
    # If only rotation could take up energy, or also vibration did, it would be another one.
    assert abs(found / COUNT - 2.0) > 0.3


def test_all_energy_kinetic_and_fixed():
    assert capacity_at_fixed_energy(np.full(9, 7.0), 150) == pytest.approx(75.0)


def test_what_cannot_be_told():
    assert capacity_at_fixed_energy([1.0], 2) is None
    assert capacity_at_fixed_energy([1.0, 30.0], 2) is None
    assert capacity_at_fixed_temperature([1.0], 1.0) is None


def test_fixed_temperature():
    generator = np.random.default_rng(3)
    energy = generator.gamma(1.5 * COUNT, 0.7, FRAMES)
    found = capacity_at_fixed_temperature(energy, 0.7)
    assert found / COUNT == pytest.approx(1.5, rel=4 * math.sqrt(2 / FRAMES) * 1.1)
