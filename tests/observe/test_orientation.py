"""Order and correlation of how molecules are turned, by hand and in the limits that are known exactly."""

import math

import numpy as np
import pytest
from hand_made import gas
from molecules_by_hand import dumbbell_and_disc, rods

from gasbox import observe
from gasbox.geometry import Rectangle
from gasbox.state import Tallies
from gasbox.theory import rotors

TORUS = Rectangle(10.0, 10.0, periodic_x=True, periodic_y=True)
TALLIES = Tallies.zero(1, 4)

pytestmark = pytest.mark.small


def test_order_of_rods_along_a_line():
    # Both ends of a rod are the same, whole turns too.
    found = observe.nematic_order(rods([0.3, 0.3 + math.pi, 0.3 - 2 * math.pi]))
    assert found.order == pytest.approx(1.0)
    assert found.director == pytest.approx(0.3)
    crossed = observe.nematic_order(rods([0.2, 0.2 + math.pi / 2]))
    assert crossed.order == pytest.approx(0.0, abs=1e-15)
    half = observe.nematic_order(rods([0.0, 0.0, math.pi / 4]))
    assert half.order == pytest.approx(math.sqrt(5) / 3)
    assert half.director == pytest.approx(0.5 * math.atan2(1, 2))


def test_only_what_rotates_has_an_order():
    assert observe.nematic_order(gas([[1.0, 0.0]])) is None
    assert observe.nematic_order(dumbbell_and_disc(), 0) is None
    assert observe.nematic_order(dumbbell_and_disc()).order == 1.0


def test_order_of_many_at_random_is_that_of_chance():
    generator = np.random.default_rng(7)
    orders = [observe.nematic_order(rods(generator.uniform(0, 2 * np.pi, 200))).order for _ in range(300)]
    # Rayleigh: variance (1 - pi/4)/N.
    error = math.sqrt((1 - math.pi / 4) / 200 / 300)
    assert np.mean(orders) == pytest.approx(rotors.mean_order(200), abs=4 * error)


def test_correlation_of_a_pair():
    # Across the periodic edge they are 2 apart, and the third is a disc.
    state = rods([0.0, math.pi / 3, 9.0], position=[[1.0, 5.0], [9.0, 5.0], [5.0, 1.0]])
    state.inertia[2] = 0.0
    pairs = observe.OrientationCorrelation(TORUS, 4, 4.0)
    pairs.start(state, TALLIES)
    pairs.observe(state, TALLIES)
    found = pairs.value()
    assert found.r.tolist() == [0.5, 1.5, 2.5, 3.5]
    assert found.pairs.tolist() == [0.0, 0.0, 2.0, 0.0]
    assert found.first[2] == pytest.approx(0.5)
    assert found.second[2] == pytest.approx(-0.5)
    assert np.isnan(found.first[0])


def test_molecules_turned_at_random_do_not_know_of_each_other():
    generator = np.random.default_rng(8)
    pairs = observe.OrientationCorrelation(TORUS, 5, 4.0)
    for time in range(20):
        place = generator.uniform(0, 10, (200, 2))
        pairs.observe(rods(generator.uniform(0, 2 * np.pi, 200), place, time=float(time)), TALLIES)
    found = pairs.value()
    # Each pair was counted from both sides, and cos² has the mean 1/2.
    assert np.all(np.abs(found.first) < 4 / np.sqrt(found.pairs))
    assert np.all(np.abs(found.second) < 4 / np.sqrt(found.pairs))


def test_a_field_of_angles_correlates_as_it_turns():
    # Turned by 2 pi x/10: over all pairs r apart the mean of cos(m (x_i - x_j) 2 pi/10) is J_0(2 pi m r/10).
    generator = np.random.default_rng(9)
    pairs = observe.OrientationCorrelation(TORUS, 20, 4.0)
    for time in range(30):
        place = generator.uniform(0, 10, (400, 2))
        pairs.observe(rods(place[:, 0] * 0.2 * np.pi, place, time=float(time)), TALLIES)
    found = pairs.value()
    around = np.linspace(0, 2 * np.pi, 400, endpoint=False)
    for fold, measured in ((1, found.first), (2, found.second)):
        law = np.mean(np.cos(0.2 * np.pi * fold * found.r[:, None] * np.cos(around)), axis=1)
        assert np.max(np.abs(measured - law)[2:]) < 0.03


def test_free_rotors_forget_as_the_normal_law_says():
    generator, count, warmth = np.random.default_rng(10), 4000, 1.5
    rates = generator.normal(0, math.sqrt(warmth / 2.0), count)
    start = generator.uniform(0, 2 * np.pi, count)
    turning = observe.Turning()
    turning.start(rods(start), TALLIES)
    for step in range(1, 31):
        turning.observe(rods(start + rates * 0.1 * step, time=0.1 * step), TALLIES)
    found = turning.value(20)
    assert found.times == pytest.approx(0.1 * np.arange(20))
    assert found.first[0] == found.second[0] == pytest.approx(1.0)
    # All beginnings of free rotors tell the same: the error is that of 4000 angles.
    for fold, measured in ((1, found.first), (2, found.second)):
        law = rotors.free_turning(found.times, 2.0, warmth, fold)
        assert np.all(np.abs(measured - law) < 4 * math.sqrt(0.5 / count))
    assert abs(found.first[8] - rotors.free_turning(found.times[8], 2.0, 1.3 * warmth)) > 0.03


def test_who_leaves_does_not_count():
    turning = observe.Turning()
    turning.start(rods([0.0, 1.0]), TALLIES)
    later = rods([9.0, 1.5], time=1.0)
    later.keep(np.array([False, True]))
    turning.observe(later, TALLIES)
    assert turning.value(2).first == pytest.approx([1.0, math.cos(0.5)])
    assert np.isnan(observe.Turning().value().first).all()
