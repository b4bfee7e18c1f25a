"""What follows from an equation of state, against integrals and differences of the equation itself."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from gasbox.theory import fluid, hard_disc, kolafa_rottner, virial

NAMES = list(hard_disc.EQUATIONS)
names = st.sampled_from(NAMES)


@given(st.floats(0.001, 0.69), names)
def test_free_energy_is_the_integral(eta, name):
    integral = quad(lambda e: (hard_disc.EQUATIONS[name](e) - 1.0) / e, 0.0, eta, epsabs=1e-13, epsrel=1e-12)
    assert fluid.excess_free_energy(eta, name) == pytest.approx(integral[0], rel=1e-11, abs=1e-13)


@given(st.floats(0.001, 0.69), names)
def test_stiffness_is_the_slope_of_the_pressure(eta, name):
    step = 1e-5

    def pressure(at):
        return at * hard_disc.EQUATIONS[name](at)

    # The error of a central difference: step² times a third derivative of at most some 1e5.
    slope = (pressure(eta + step) - pressure(eta - step)) / (2 * step)
    assert fluid.stiffness(eta, name) == pytest.approx(slope, rel=1e-6)


@given(st.floats(0.001, 0.69), names)
def test_gibbs_and_duhem(eta, name):
    # d(eta Z) = eta dmu/T: the chemical potential knows what the pressure knows.
    step = 1e-5 * eta
    rise = fluid.chemical_potential(eta + step, name) - fluid.chemical_potential(eta - step, name)
    assert eta * rise / (2 * step) == pytest.approx(fluid.stiffness(eta, name), rel=1e-5)


@given(st.floats(1e-9, 0.69), names)
def test_the_chemical_potential_can_be_inverted(eta, name):
    there = fluid.chemical_potential(eta, name)
    assert fluid.area_fraction_at(there, name) == pytest.approx(eta, rel=1e-13)


@pytest.mark.small
def test_first_virial_corrections():
    # F = 2 eta + (B_3/B_2²)(2 eta)²/2 + ..., whose next term is (B_4/B_2³)(2 eta)³/3.
    eta = 1e-3
    third, fourth = virial.REDUCED_COEFFICIENTS[2:4]
    series = 2 * eta + third * (2 * eta) ** 2 / 2 + fourth * (2 * eta) ** 3 / 3
    assert fluid.excess_free_energy(eta) == pytest.approx(series, abs=1e-11)


@pytest.mark.small
def test_arrays_ends_and_what_lies_outside():
    eta = np.array([[0.0, 0.1], [0.3, 0.75]])
    for name in NAMES:
        potential = fluid.chemical_potential(eta, name)
        assert potential.shape == (2, 2)
        assert potential[0, 0] == -math.inf
        assert isinstance(fluid.excess_free_energy(0.2, name), float)
        np.testing.assert_allclose(fluid.area_fraction_at(potential[:1], name), eta[:1], rtol=1e-13)
    assert fluid.excess_free_energy(0.0) == 0.0
    assert np.isnan(fluid.excess_free_energy(eta)[1, 1])
    assert np.isnan(fluid.stiffness(eta)[1, 1])
    assert math.isnan(fluid.excess_free_energy(-0.1, "henderson"))
    assert math.isnan(fluid.stiffness(1.0, "scaled-particle"))
    end = kolafa_rottner.MAXIMUM_AREA_FRACTION
    assert fluid.greatest_area_fraction() == end
    assert fluid.greatest_area_fraction("henderson") == pytest.approx(0.9069, abs=5e-5)
    top = fluid.chemical_potential(end)
    assert fluid.area_fraction_at(top) == pytest.approx(end, rel=1e-13)
    assert math.isnan(fluid.area_fraction_at(top + 1e-9))
    assert fluid.area_fraction_at(-math.inf) == fluid.area_fraction_at(-math.inf, "ideal") == 0.0
