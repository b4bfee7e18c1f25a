"""Neighbours against a slow twin, and the order of perfect and random patterns."""

import itertools
import math

import numpy as np
import pytest
from hand_made import gas, hall, moved
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from gasbox import observe
from gasbox.geometry import Circle, Rectangle

pytestmark = pytest.mark.small

places = st.integers(0, 12).flatmap(lambda n: arrays(np.float64, (n, 2), elements=st.floats(0.0, 1.0)))


def at(position):
    position = np.asarray(position, float).reshape(-1, 2)
    return gas(np.zeros_like(position), position=position)


def twin(position, size, periodic, distance):
    """(row, other) -> ways, by looking at every image of every disc."""
    ways = [
        math.ceil(distance / length) + 1 if wraps else 0 for length, wraps in zip(size, periodic, strict=True)
    ]
    images = list(itertools.product(*(range(-way, way + 1) for way in ways)))
    found = {}
    for i, j in itertools.product(range(len(position)), repeat=2):
        for image in images:
            way = (position[j] - position[i]) + np.array(image) * size
            if (i != j or any(image)) and way @ way <= distance**2:
                found.setdefault((i, j), []).append(tuple(way))
    return found


@settings(deadline=None)
@given(places, st.tuples(st.booleans(), st.booleans()), st.floats(0.05, 2.5), st.floats(0.3, 3.0))
def test_neighbours_against_all_pairs(place, periodic, distance, height):
    box = Rectangle(1.0, height, *periodic)
    position = place * box.size
    found = observe.neighbours(at(position), box, distance)
    expected = twin(position, box.size, box.periodic, distance)
    listed = {}
    for i, j, way in zip(found.rows.tolist(), found.other.tolist(), found.way, strict=True):
        listed.setdefault((i, j), []).append(tuple(way))
    sure = {key: ways for key, ways in expected.items() if is_clear(ways, distance)}
    for key, ways in sure.items():
        np.testing.assert_allclose(sorted(listed[key]), sorted(ways), atol=1e-12)
    unsure = expected.keys() - sure.keys()
    assert listed.keys() - unsure == sure.keys()
    for i in range(len(position)):
        mine = found.other[found.first[i] : found.first[i + 1]]
        assert np.all(np.diff(mine) >= 0)


def is_clear(ways, distance):
    """Whether rounding cannot decide who is near enough."""
    return all(abs(math.hypot(*way) - distance) > 1e-9 for way in ways)


@pytest.mark.parametrize("periodic", [(True, True), (True, False), (False, False)])
def test_many_discs_against_all_pairs(periodic):
    box = Rectangle(17.0, 11.0, *periodic)
    position = np.random.default_rng(5).uniform(0.0, 1.0, (400, 2)) * box.size
    found = observe.neighbours(at(position), box, 1.3)
    way = position[None, :, :] - position[:, None, :]
    way -= np.where(box.periodic, np.round(way / box.size) * box.size, 0.0)
    near = np.sum(way**2, axis=2) <= 1.3**2
    np.fill_diagonal(near, False)
    rows, others = np.nonzero(near)
    assert found.rows.tolist() == rows.tolist()
    assert found.other.tolist() == others.tolist()
    np.testing.assert_allclose(found.way, way[near], atol=1e-12)


def test_both_sides_see_the_same_distance_to_the_bit():
    box = Rectangle(3.7, 2.9, True, True)
    position = np.random.default_rng(6).uniform(0.0, 1.0, (60, 2)) * box.size
    found = observe.neighbours(at(position), box, 2.2)
    one = sorted(zip(found.rows.tolist(), found.other.tolist(), *found.way.T.tolist(), strict=True))
    other = sorted(zip(found.other.tolist(), found.rows.tolist(), *(-found.way).T.tolist(), strict=True))
    assert one == other


def test_one_disc_sees_itself_in_a_small_box():
    found = observe.neighbours(at([[0.2, 0.3]]), Rectangle(1.0, 1.0, True, True), 1.0)
    assert found.counts.tolist() == [4]
    assert sorted(map(tuple, found.way.round(12).tolist())) == [(-1, 0), (0, -1), (0, 1), (1, 0)]


def test_no_disc_has_no_neighbour():
    empty = at(np.zeros((0, 2)))
    found = observe.neighbours(empty, Rectangle(1.0, 1.0), 1.0)
    assert (found.first.tolist(), found.other.size) == ([0], 0)
    assert observe.hexatic_order(empty, Rectangle(1.0, 1.0)) == 0.0


def test_a_box_that_has_grown_and_walls_of_any_shape():
    torus = Rectangle(4.0, 4.0, True, True)
    state = at([[0.2, 2.0], [3.8, 2.0]])
    assert observe.coordination(state, torus, 1.0).tolist() == [1, 1]
    assert observe.coordination(moved(state, 0.0, 1.0, 0.0, 0.0), torus, 1.0).tolist() == [0, 0]
    assert observe.coordination(state, hall(Circle(2.0)), 1.0).tolist() == [0, 0]


def lattice(columns, rows, spacing):
    """A triangular lattice that fills a periodic box, and the box."""
    place = np.array([[i + 0.5 * (j % 2), j * math.sqrt(0.75)] for j in range(rows) for i in range(columns)])
    box = Rectangle(columns * spacing, rows * spacing * math.sqrt(0.75), True, True)
    return at((place + 0.25) * spacing), box


def test_a_perfect_lattice():
    state, box = lattice(8, 6, 1.1)
    assert np.all(observe.coordination(state, box) == 6)
    np.testing.assert_allclose(observe.hexatic(state, box), 1.0, atol=1e-12)
    assert observe.hexatic_order(state, box) == pytest.approx(1.0, abs=1e-12)
    # Turned by an angle, psi_6 turns six times as fast.
    turn = np.exp(0.1j)
    turned = (state.position @ [1, 1j]) * turn
    patch = observe.hexatic(at(np.stack([turned.real, turned.imag], axis=1)), Rectangle(99.0, 99.0))
    np.testing.assert_allclose(patch[np.abs(patch) > 0.0], np.exp(0.6j), atol=1e-12)


def test_a_square_lattice_has_no_hexagons():
    place = np.array(list(itertools.product(range(6), repeat=2)), float)
    square = Rectangle(6.0, 6.0, True, True)
    # Four neighbours at right angles: exp(6 i theta) is 1, -1, 1, -1.
    np.testing.assert_allclose(observe.hexatic(at(place), square, 1.2), 0.0, atol=1e-12)


def test_random_points_have_little_order():
    box = Rectangle(40.0, 40.0, True, True)
    position = np.random.default_rng(8).uniform(0.0, 40.0, (2000, 2))
    counts = observe.coordination(at(position), box, 1.5)
    # Poisson: N pi d² / A, with an error of sqrt(2/N) of the mean over pairs.
    mean = 1999 * math.pi * 1.5**2 / 1600
    assert np.mean(counts) == pytest.approx(mean, abs=4 * math.sqrt(2 * mean / 2000))
    # A walk of 2000 steps of rms length <= 1: beyond 4/sqrt(N) once in e^16.
    assert observe.hexatic_order(at(position), box) < 4 / math.sqrt(2000)
