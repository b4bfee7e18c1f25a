"""Excluded areas and second virial coefficients of hard molecules, against closed forms and counting at random."""

import math

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from shapely.geometry import Point

from gasbox.theory import hard_bodies, virial

pytestmark = pytest.mark.small

DUMBBELL = [[-0.4, 0.0], [0.4, 0.0]]
WATER = ([1.3, 0.9, 0.9], [[0.0, 0.1], [-0.8, -0.4], [0.8, -0.4]])


def test_a_disc_has_the_coefficient_of_a_disc():
    one = hard_bodies.second_virial([0.7], [[0.3, 0.1]], 8)
    assert one == pytest.approx(virial.second_coefficient(1.4), rel=1e-14)
    # All discs at one place are the largest of them.
    assert hard_bodies.second_virial([0.7, 0.2], np.zeros((2, 2)), 8) == pytest.approx(one)
    assert hard_bodies.convex_second_virial(math.pi * 0.49, 1.4 * math.pi) == pytest.approx(one)


@settings(max_examples=25, deadline=None)
@given(st.lists(st.tuples(st.floats(-2, 2), st.floats(-2, 2), st.floats(0.1, 1.5)), min_size=1, max_size=7))
def test_the_area_of_a_union_of_discs(discs):
    discs = np.array(discs)
    drawn = shapely.union_all([Point(x, y).buffer(r, quad_segs=400) for x, y, r in discs])
    assert hard_bodies.union_area(discs[:, :2], discs[:, 2]) == pytest.approx(drawn.area, rel=1e-4)


def test_two_discs_that_touch_or_hide():
    assert hard_bodies.body_area([1.0, 1.0], [[0, 0], [2, 0]]) == pytest.approx(2 * math.pi)
    assert hard_bodies.body_area([1.0, 0.5], [[0, 0], [0.2, 0]]) == pytest.approx(math.pi)
    lens = 2 * math.acos(0.5) - 0.5 * math.sqrt(3)
    assert hard_bodies.body_area([1.0, 1.0], [[0, 0], [1, 0]]) == pytest.approx(2 * math.pi - lens)


def test_a_rod_of_many_discs_is_nearly_a_stadium():
    # Discs a third of their radius apart leave grooves of depth 0.014 in a rod with round ends.
    place = np.stack([np.linspace(-2.0, 2.0, 13), np.zeros(13)], axis=1)
    found = hard_bodies.second_virial(np.full(13, 1.0), place, 24)
    assert 0.99 < found / hard_bodies.convex_second_virial(*hard_bodies.stadium(1.0, 4.0)) < 1.0


@pytest.mark.parametrize(
    ("radius", "place"), [([0.5, 0.5], DUMBBELL), ([0.5, 0.5], [[-0.5, 0.0], [0.5, 0.0]]), WATER]
)
def test_against_counting_at_random(radius, place):
    radius, place = np.array(radius), np.array(place)
    generator, number = np.random.default_rng(3), 400_000
    reach = 2 * float(np.max(np.hypot(*place.T) + radius))
    centre, angle = generator.uniform(-reach, reach, (number, 2)), generator.uniform(0, 2 * np.pi, number)
    cos, sin = np.cos(angle), np.sin(angle)
    met = np.zeros(number, bool)
    for i, (x, y) in enumerate(place):
        for j, (a, b) in enumerate(place):
            away = centre + np.stack([cos * a - sin * b, sin * a + cos * b], axis=1) - (x, y)
            met |= np.hypot(*away.T) < radius[i] + radius[j]
    share = met.mean()
    error = math.sqrt(share * (1 - share) / number)
    found = 2 * hard_bodies.second_virial(radius, place) / (2 * reach) ** 2
    assert found == pytest.approx(share, abs=3.5 * error)
    # Some grooves remain open: less than what the convex hull would exclude.
    hull = shapely.union_all([Point(*p).buffer(r, quad_segs=200) for p, r in zip(place, radius, strict=True)])
    hull = hull.convex_hull
    assert 0.9 < found * 2 * reach**2 / hard_bodies.convex_second_virial(hull.area, hull.length) < 1.0


def test_few_angles_are_enough():
    coarse, fine = (hard_bodies.second_virial([0.5, 0.5], DUMBBELL, n) for n in (90, 720))
    assert coarse == pytest.approx(fine, rel=2e-5)


def test_pressure_and_adiabat():
    assert hard_bodies.dilute_pressure(100, 3.0, 1000.0, 2.0) == pytest.approx(2.0 * 0.1 * 1.3)
    mixed = hard_bodies.dilute_pressure([50, 50], [[3.0, 3.0], [3.0, 3.0]], 1000.0, 2.0)
    assert mixed == pytest.approx(2.0 * 0.1 * 1.3)
    path = solve_ivp(
        lambda a, t: -2 / (3 * 100) * hard_bodies.dilute_pressure(100, 3.0, a, float(t[0])),
        (2000.0, 900.0),
        [1.3],
        rtol=1e-10,
        atol=1e-12,
    )
    found = hard_bodies.dilute_temperature(900.0, 1.3, 100, 3.0, 2000.0)
    assert found == pytest.approx(path.y[0, -1], rel=1e-8)
