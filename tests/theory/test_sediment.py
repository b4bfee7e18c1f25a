"""Columns of hard discs against published numbers, the hydrostatic equation solved step by step, and limits."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from gasbox.theory import gravity, hard_disc, kolafa_rottner, sediment, virial


@pytest.mark.small
@pytest.mark.parametrize(
    ("load", "mean", "error"), [(1, 1.0388, 6e-5), (2, 1.0769, 6e-5), (5, 1.187, 6e-4), (10, 1.362, 6e-4)]
)
def test_published_mean_heights(load, mean, error):
    # ell = 20 sigma, N sigma/W = load; independent quadrature of the same equation of state.
    for sigma in (1.0, 0.3):
        width, scale = 50 * sigma, 20 * sigma
        found = sediment.hard_disc_mean_height(50 * load, width, 0.5 * sigma, scale)
        assert found / scale == pytest.approx(mean, abs=error)


def pressure_slope(name, eta):
    """d(eta Z)/d eta by a difference of fourth order."""
    step = 1e-4 * eta

    def p(at):
        return at * hard_disc.EQUATIONS[name](at)

    near, far = p(eta + step) - p(eta - step), p(eta + 2 * step) - p(eta - 2 * step)
    return (8 * near - far) / (12 * step)


@pytest.mark.parametrize("name", ["kolafa-rottner", "henderson", "scaled-particle"])
@pytest.mark.parametrize(("count", "scale", "room"), [(900, 20.0, 30.0), (450, 20.0, 12.0), (200, 3.0, 60.0)])
def test_the_hydrostatic_equation_climbed_step_by_step(name, count, scale, room):
    width, radius = 50.0, 0.5
    floor = sediment.floor_area_fraction(count, width, radius, scale, room, name)
    heights = np.linspace(0.0, room, 25)
    # dP/dy = -m g n is d eta/dy = -eta/(ell d(eta Z)/d eta); columns: ln eta, then int eta dy and int y eta dy.
    climb = solve_ivp(
        lambda y, s: [
            -1 / (scale * pressure_slope(name, math.exp(s[0]))),
            math.exp(s[0]),
            y * math.exp(s[0]),
        ],
        (0.0, room),
        [math.log(floor), 0.0, 0.0],
        t_eval=heights,
        rtol=1e-10,
        atol=1e-13,
    )
    eta = np.exp(climb.y[0])
    disc = math.pi * radius**2
    profile = sediment.hard_disc_density(heights, count, width, radius, scale, room, name)
    np.testing.assert_allclose(profile * disc, eta, rtol=1e-7)
    assert climb.y[1, -1] * width / disc == pytest.approx(count, rel=1e-8)
    mean = sediment.hard_disc_mean_height(count, width, radius, scale, room, name)
    assert climb.y[2, -1] / climb.y[1, -1] == pytest.approx(mean, rel=1e-8)


@settings(deadline=None, max_examples=40)
@given(st.floats(1e-10, 100.0), st.floats(0.01, 0.5), st.sampled_from(["kolafa-rottner", "henderson"]))
def test_the_floor_bears_the_weight_and_the_column_holds_all(rise, mean_fraction, name):
    width, radius, scale = 10.0, 0.5, 25.0
    room, disc = rise * scale, math.pi * radius**2
    count = mean_fraction * width * room / disc / max(1.0, rise)
    floor, lid = (
        sediment.hard_disc_density(y, count, width, radius, scale, room, name) * disc for y in (0.0, room)
    )
    borne = floor * hard_disc.EQUATIONS[name](floor) - lid * hard_disc.EQUATIONS[name](lid)
    assert borne == pytest.approx(count * disc / (width * scale), rel=1e-9, abs=1e-13)
    if rise < 40.0:
        nodes, weights = np.polynomial.legendre.leggauss(200)
        heights = 0.5 * room * (1.0 + nodes)
        density = sediment.hard_disc_density(heights, count, width, radius, scale, room, name)
        assert 0.5 * room * width * np.sum(weights * density) == pytest.approx(count, rel=1e-8)


@pytest.mark.small
@pytest.mark.parametrize("room", [0.0001, 5.0, 19.9, 20.1, 300.0, math.inf])
def test_points_obey_the_barometric_law(room):
    heights = np.array([-1.0, 0.0, 0.00005, 4.0, 60.0, 250.0, 1e9])
    law = gravity.density(heights, 30.0, 50.0, 20.0, room)
    ideal = sediment.hard_disc_density(heights, 30.0, 50.0, 0.001, 20.0, room, "ideal")
    np.testing.assert_allclose(ideal, law, rtol=1e-12)
    np.testing.assert_array_equal(sediment.hard_disc_density(heights, 30.0, 50.0, 0.0, 20.0, room), law)
    mean = gravity.mean_height(20.0, room)
    assert sediment.hard_disc_mean_height(30.0, 50.0, 0.001, 20.0, room, "ideal") == mean
    assert sediment.hard_disc_mean_height(30.0, 50.0, 0.0, 20.0, room) == mean
    # Discs of a thousandth: still points, to their area fraction.
    tiny = sediment.hard_disc_mean_height(30.0, 50.0, 0.001, 20.0, room)
    assert tiny == pytest.approx(mean, rel=1e-6)


@pytest.mark.small
def test_second_virial_coefficient_lifts_the_column():
    # <y> = ell + B_2 N/(2 W), the next term relatively of the order of eta.
    count, width, radius, scale = 2.0, 50.0, 0.5, 20.0
    lift = sediment.hard_disc_mean_height(count, width, radius, scale) - scale
    assert lift == pytest.approx(virial.second_coefficient(1.0) * count / (2 * width), rel=0.005)


@pytest.mark.small
def test_shallow_and_deep_columns_meet():
    # The two ways to fill the column take over from each other at H = ell.
    for fraction in (0.05, 0.5):
        means = []
        for room in (20.0 * (1 - 1e-12), 20.0 * (1 + 1e-12)):
            count = fraction * 50.0 * room / (math.pi / 4)
            means.append(sediment.hard_disc_mean_height(count, 50.0, 0.5, 20.0, room))
        assert means[0] == pytest.approx(means[1], rel=2e-12)


@pytest.mark.small
def test_weak_gravity_tilts_by_the_stiffness():
    # n(y) = n (1 + (H/2 - y)/(ell S)), so <y> = H/2 (1 - H/(6 ell S)); without gravity H/2.
    room, eta = 10.0, 0.4
    count = eta * 50.0 * room / (math.pi / 4)
    slope = kolafa_rottner.compressibility(eta) + kolafa_rottner.compressibility_slope(eta)
    for scale in (1e4, 1e7):
        mean = sediment.hard_disc_mean_height(count, 50.0, 0.5, scale, room)
        assert (0.5 * room - mean) * 12 * scale * slope / room**2 == pytest.approx(
            1.0, abs=1e-7 * scale / 1e4
        )
    assert sediment.hard_disc_mean_height(count, 50.0, 0.5, math.inf, room) == pytest.approx(5.0, rel=1e-14)
    even = sediment.hard_disc_density(np.array([0.0, 10.0, 11.0]), count, 50.0, 0.5, math.inf, room)
    np.testing.assert_allclose(even * math.pi / 4, [0.4, 0.4, 0.0], rtol=1e-13)


@pytest.mark.small
def test_too_many_discs_and_none():
    # eta Z at the end of the range is the greatest weight pi N R²/(W ell) that the fluid bears.
    most = 0.691149 * kolafa_rottner.compressibility(0.691149) * 50.0 * 20.0 / (math.pi / 4)
    assert sediment.floor_area_fraction(0.999 * most, 50.0, 0.5, 20.0) > 0.69
    assert math.isnan(sediment.floor_area_fraction(1.001 * most, 50.0, 0.5, 20.0))
    assert math.isnan(sediment.hard_disc_mean_height(1.001 * most, 50.0, 0.5, 20.0))
    assert math.isnan(sediment.hard_disc_mean_height(900.0, 50.0, 0.5, 20.0, 20.0))
    assert np.isnan(sediment.hard_disc_density(np.array([0.0, 5.0]), 1e6, 50.0, 0.5, 20.0)).all()
    assert sediment.floor_area_fraction(0.0, 50.0, 0.5, 20.0) == 0.0
    assert sediment.hard_disc_density(3.0, 0.0, 50.0, 0.5, 20.0) == 0.0
    assert sediment.hard_disc_mean_height(0.0, 50.0, 0.5, 20.0) == 20.0
    assert isinstance(sediment.hard_disc_density(3.0, 10.0, 50.0, 0.5, 20.0), float)
