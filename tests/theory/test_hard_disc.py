"""Equations of state of hard discs against exact virial coefficients and published values."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gasbox.theory import hard_disc, kolafa_rottner, virial

# eta, Z of Kolafa and Rottner, chi, and how far the other equations are off in percent. Z agrees with independent
# long simulations; the deviations follow from the formulas.
TABLE = [
    (0.01, 1.02032, 1.0159, 0.000, -0.001),
    (0.05, 1.10839, 1.0839, -0.001, -0.032),
    (0.10, 1.23614, 1.1807, -0.003, -0.127),
    (0.20, 1.57037, 1.4259, -0.003, -0.501),
    (0.30, 2.06326, 1.7721, 0.025, -1.088),
    (0.50, 4.10636, 3.1064, 0.454, -2.590),
    (0.60, 6.45535, 4.5461, 1.176, -3.181),
]


@pytest.mark.parametrize(("eta", "z", "chi", "henderson", "scaled"), TABLE)
def test_published_values(eta, z, chi, henderson, scaled):
    reference = hard_disc.kolafa_rottner(eta)
    assert reference == pytest.approx(z, abs=6e-6)
    assert hard_disc.contact_value(eta) == pytest.approx(chi, abs=6e-5)
    assert 100 * (hard_disc.henderson(eta) / reference - 1) == pytest.approx(henderson, abs=6e-4)
    assert 100 * (hard_disc.scaled_particle(eta) / reference - 1) == pytest.approx(scaled, abs=6e-4)


@pytest.mark.parametrize(
    ("eta", "denser_fit"),
    [(0.6, 6.455334), (0.65, 8.408049), (0.67, 9.362455), (0.68, 9.828701), (0.69, 10.200921)],
)
def test_the_end_of_the_range_agrees_with_the_fit_to_denser_data(eta, denser_fit):
    # The same paper's fit up to n sigma² = 0.89; both describe the same data here, to their scatter of some 4e-5.
    assert hard_disc.kolafa_rottner(eta) == pytest.approx(denser_fit, abs=4e-5)


def taylor(equation, terms):
    """Coefficients of Z in powers of eta from samples on a circle in the complex plane, spectrally exact."""
    points = 64
    circle = 0.2 * np.exp(2j * np.pi * np.arange(points) / points)
    return (np.fft.fft(equation(circle)) / points)[:terms].real / 0.2 ** np.arange(terms)


def test_kolafa_rottner_contains_the_virial_coefficients():
    found = taylor(lambda eta: kolafa_rottner._SERIES(eta / (1.0 - eta)), 10) / 2.0 ** np.arange(10)
    exact = np.array(virial.REDUCED_COEFFICIENTS)
    # Exact ones to the nine digits in which the fit is given; Monte-Carlo ones within three of their standard
    # errors (Clisby and McCoy 2006): 4e-8, 4.2e-6, 4.3e-6, 3.4e-6, 3.5e-6, 8.0e-6.
    np.testing.assert_allclose(found[:4], exact[:4], rtol=0.0, atol=3e-9)
    errors = np.array([4e-8, 4.2e-6, 4.3e-6, 3.4e-6, 3.5e-6, 8.0e-6])
    assert np.all(np.abs(found[4:] - exact[4:]) < 3 * errors)


def test_closed_forms_have_the_second_and_nearly_the_third_coefficient():
    # Henderson: 1 + 2 eta + 3.125 eta²; exact third: 3.12802. Scaled particles: 3.
    np.testing.assert_allclose(
        taylor(lambda eta: (1 + eta**2 / 8) / (1 - eta) ** 2, 3), [1, 2, 3.125], atol=1e-12
    )
    step = 1e-4
    for equation in (hard_disc.henderson, hard_disc.scaled_particle, hard_disc.kolafa_rottner):
        assert equation(0.0) == 1.0
        assert (equation(step) - 1.0) / step == pytest.approx(2.0, abs=4 * step)
    assert 4 * virial.REDUCED_COEFFICIENTS[2] == pytest.approx(3.12801775, abs=1e-8)


@pytest.mark.parametrize(
    ("eta", "error"), [(0.05, 1e-8), (0.1, 1e-7), (0.2, 1e-5), (0.3, 1.2e-4), (0.4, 2.5e-3)]
)
def test_virial_series_meets_the_fit_where_it_converges(eta, error):
    assert virial.virial_series(eta) == pytest.approx(hard_disc.kolafa_rottner(eta), abs=error)
    assert virial.virial_series(eta, terms=2) == pytest.approx(1 + 2 * eta, rel=1e-15)


@pytest.mark.small
def test_second_coefficient_is_half_the_excluded_area():
    assert virial.second_coefficient(2.0) == pytest.approx(0.5 * math.pi * 4.0, rel=1e-15)
    # Z = 1 + B2 n, with n = 4 eta/(pi sigma²), is 1 + 2 eta.
    assert virial.second_coefficient(3.0) * 4 * 0.1 / (math.pi * 9.0) == pytest.approx(0.2, rel=1e-15)


@pytest.mark.small
def test_outside_their_range_equations_give_no_number():
    end = kolafa_rottner.MAXIMUM_AREA_FRACTION
    assert end == pytest.approx(0.6912, abs=5e-5)
    assert math.isfinite(hard_disc.kolafa_rottner(end))
    for name, equation in hard_disc.EQUATIONS.items():
        if name != "ideal":
            assert math.isnan(equation(hard_disc.RANGE[name] + 1e-6))
            assert math.isnan(equation(-1e-6))
    assert hard_disc.ideal(5.0) == 1.0
    both = hard_disc.kolafa_rottner(np.array([0.1, 0.7]))
    assert math.isfinite(both[0])
    assert math.isnan(both[1])


@given(st.floats(1e-3, 0.69))
def test_contact_value_and_compressibility_say_the_same(eta):
    for name in ("henderson", "kolafa-rottner", "scaled-particle"):
        z = hard_disc.EQUATIONS[name](eta)
        assert 1.0 + 2.0 * eta * hard_disc.contact_value(eta, name) == pytest.approx(z, rel=1e-13)
    henderson = (1 - 7 * eta / 16) / (1 - eta) ** 2
    assert hard_disc.contact_value(eta, "henderson") == pytest.approx(henderson, rel=1e-11)


@pytest.mark.small
def test_contact_value_of_a_dilute_gas():
    assert hard_disc.contact_value(0.0) == 1.0
    assert hard_disc.contact_value(0.0, "ideal") == hard_disc.contact_value(0.3, "ideal") == 0.0


@pytest.mark.small
def test_pressure_scales_with_temperature_and_number():
    # 100 discs of radius 1 in an area of 1000 pi: eta = 0.1.
    area = 1000 * math.pi
    assert hard_disc.area_fraction(100, 1.0, area) == pytest.approx(0.1, rel=1e-15)
    one = hard_disc.pressure(100, 1.0, area, 1.0)
    assert one == pytest.approx(1.23614 * 100 / area, rel=1e-5)
    assert hard_disc.pressure(100, 1.0, area, 3.0) == pytest.approx(3 * one, rel=1e-15)
    assert hard_disc.pressure(100, 1.0, area, 2.0, "ideal") == pytest.approx(200 / area, rel=1e-15)


@given(st.floats(0.001, 0.68))
def test_slope_is_the_derivative(eta):
    step = 1e-5
    rise = hard_disc.kolafa_rottner(eta + step) - hard_disc.kolafa_rottner(eta - step)
    assert kolafa_rottner.compressibility_slope(eta) == pytest.approx(eta * rise / (2 * step), rel=1e-5)


def test_finite_number_correction():
    # To second order in density Z_N - 1 = (1 - 1/N)(Z - 1), exactly.
    eta, count = 1e-4, 10
    excess = hard_disc.kolafa_rottner(eta) - 1.0
    finite = hard_disc.finite_compressibility(eta, count) - 1.0
    assert finite / excess == pytest.approx(0.9, abs=5 * eta)
    # Against its definition, by differences of ln S.
    eta, step = 0.3, 1e-4

    def stiffness(at):
        return hard_disc.kolafa_rottner(at) + kolafa_rottner.compressibility_slope(at)

    slope = eta * (math.log(stiffness(eta + step)) - math.log(stiffness(eta - step))) / (2 * step)
    expected = hard_disc.kolafa_rottner(eta) - slope / (2 * count)
    assert hard_disc.finite_compressibility(eta, count) == pytest.approx(expected, rel=1e-8)
    assert hard_disc.finite_compressibility(eta, 10**9) == pytest.approx(
        hard_disc.kolafa_rottner(eta), rel=1e-8
    )
