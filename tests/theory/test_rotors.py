"""Laws of rotation against quadrature and scipy, and what follows from them."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.stats import gamma, norm

from gasbox.theory import adiabat, maxwell, rotors

pytestmark = pytest.mark.small

warm, heavy = st.floats(0.1, 10.0), st.floats(0.1, 10.0)


def test_moments_of_inertia():
    assert rotors.disc_inertia(3.0, 2.0) == 6.0
    # Two discs of mass 1.5 and radius 2, 3 apart: 2 * 1.5 * (2 + 2.25).
    assert rotors.dumbbell_inertia(3.0, 2.0, 3.0) == pytest.approx(12.75)
    pair = rotors.body_inertia([1.5, 1.5], [2.0, 2.0], [[5.0, 1.0], [5.0, 4.0]])
    assert pair == pytest.approx(rotors.dumbbell_inertia(3.0, 2.0, 3.0))
    # The centre of mass of 1 and 3, 4 apart, is 3 and 1 away from them.
    assert rotors.body_inertia([1.0, 3.0], [0.0, 0.0], [[0, 0], [4, 0]]) == pytest.approx(12.0)


def test_heat_capacity_and_adiabat():
    assert [rotors.heat_capacity(f) for f in (2, 3, 4)] == [1.0, 1.5, 2.0]
    assert rotors.adiabatic_exponent(2) == 2.0
    assert rotors.adiabatic_exponent(3) == pytest.approx(5 / 3)
    assert rotors.mean_energy(0.5, 3) == 0.75
    # T A^(2/f) and P A^gamma are constant together: P ~ T/A.
    new = adiabat.ideal_temperature(0.4, 1.3, 1.0, freedom=3.0)
    assert new / 0.4 * 0.4 ** rotors.adiabatic_exponent(3) == pytest.approx(1.3)


@given(st.floats(-5, 5), heavy, warm)
def test_angular_velocities_are_normal(rate, inertia, temperature):
    law = norm(scale=math.sqrt(temperature / inertia))
    assert rotors.angular_velocity_pdf(rate, inertia, temperature) == pytest.approx(law.pdf(rate), abs=1e-14)
    assert rotors.angular_velocity_cdf(rate, inertia, temperature) == pytest.approx(law.cdf(rate), abs=1e-14)


@given(st.floats(-1, 30), warm, st.integers(1, 9))
def test_energies_follow_gammas_law(energy, temperature, freedom):
    law = gamma(0.5 * freedom, scale=temperature)
    if energy != 0.0:
        assert rotors.energy_pdf(energy, temperature, freedom) == pytest.approx(law.pdf(energy), rel=1e-10)
    assert rotors.energy_cdf(energy, temperature, freedom) == pytest.approx(law.cdf(energy), abs=1e-12)


def test_two_degrees_of_freedom_are_a_disc():
    energy = np.linspace(0.0, 5.0, 11)
    np.testing.assert_allclose(rotors.energy_cdf(energy, 0.7, 2), maxwell.energy_cdf(energy, 0.7), rtol=1e-14)
    np.testing.assert_allclose(rotors.energy_pdf(energy, 0.7, 2), maxwell.energy_pdf(energy, 0.7), rtol=1e-14)
    assert rotors.energy_pdf(0.0, 1.0, 1) == math.inf
    assert rotors.energy_pdf(0.0, 1.0, 3) == 0.0
    assert isinstance(rotors.energy_cdf(1.0, 1.0, 3), float)


def test_mean_energy_is_the_mean_of_the_law():
    for freedom in (2, 3, 5):
        mean, _ = quad(lambda e, f=freedom: e * rotors.energy_pdf(e, 0.8, f), 0.0, np.inf)
        assert mean == pytest.approx(rotors.mean_energy(0.8, freedom), rel=1e-8)


@pytest.mark.parametrize("fold", [1, 2])
def test_free_turning_is_the_transform_of_the_normal_law(fold):
    time, inertia, temperature = 1.7, 2.5, 0.6
    mean, _ = quad(
        lambda w: math.cos(fold * w * time) * rotors.angular_velocity_pdf(w, inertia, temperature), -9, 9
    )
    assert rotors.free_turning(time, inertia, temperature, fold) == pytest.approx(mean, rel=1e-8)


def test_order_by_chance():
    angle = np.random.default_rng(1).uniform(0, 2 * np.pi, (4000, 100))
    order = np.abs(np.mean(np.exp(2j * angle), axis=1))
    # Rayleigh's law of the mean of 100 unit vectors: variance (1 - pi/4)/N.
    assert order.mean() == pytest.approx(rotors.mean_order(100), abs=4 * math.sqrt(0.215 / 100 / 4000) + 2e-4)
