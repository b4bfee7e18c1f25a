"""Overlaps are found in cells as all pairs find them, and pushed apart."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from placed_gases import assert_in_place, deepest_by_hand

from gasbox.errors import ScenarioError
from gasbox.geometry import Rectangle
from gasbox.initial import Overlap, separate, worst_overlap
from gasbox.state import State

BOXES = [
    Rectangle(30, 20),
    Rectangle(30, 20, periodic_x=True),
    Rectangle(20, 30, periodic_y=True),
    Rectangle(25, 25, True, True),
    Rectangle(5, 200, True, True),
]


def state_of(position, radius, mass=None):
    count = len(position)
    mass = np.ones(count) if mass is None else np.array(mass, float)
    return State(
        0.0,
        np.arange(count) * 2,
        np.zeros(count, np.int32),
        mass,
        np.array(radius, float),
        np.array(position, float).reshape(-1, 2),
        np.zeros((count, 2)),
    )


def random_state(geometry, count, ratio, seed):
    random = np.random.default_rng(seed)
    radius = np.exp(random.uniform(0, np.log(ratio), count))
    radius *= 0.45 * min(geometry.width, geometry.height) / max(ratio, 4)
    room = np.where(geometry.periodic, 0.0, radius[:, None])
    return state_of(room + random.random((count, 2)) * (geometry.size - 2 * room), radius)


@settings(max_examples=120, deadline=None, derandomize=True)
@given(st.sampled_from(BOXES), st.integers(2, 40), st.sampled_from([1, 1.5, 5, 50]), st.integers(0, 2**32))
def test_the_worst_pair_is_that_of_all_pairs(geometry, count, ratio, seed):
    state = random_state(geometry, count, ratio, seed)
    depth = deepest_by_hand(state, geometry)
    found = worst_overlap(state, geometry)
    if depth.max() <= 0:
        assert found is None
    else:
        assert found.depth == pytest.approx(depth.max(), rel=1e-12)
        assert depth[found.first // 2, found.second // 2] == depth.max()
        assert found.first < found.second
        assert found.wall is None


@pytest.mark.small
@pytest.mark.parametrize("axis", [0, 1])
@pytest.mark.parametrize("far", [False, True])
def test_walls(axis, far):
    position = np.array([[10.0, 10.0], [15.0, 15.0]])
    position[1, axis] = 19.75 if far else 0.25
    state, box = state_of(position, [1, 1]), Rectangle(20, 20)
    wall = [["left", "right"], ["bottom", "top"]][axis][far]
    assert worst_overlap(state, box) == Overlap(2, None, 0.75, wall)
    assert str(worst_overlap(state, box)) == f"particle 2 and the {wall} wall overlap by 0.75"
    assert worst_overlap(state, Rectangle(20, 20, axis == 0, axis == 1)) is None


@pytest.mark.small
def test_touching_is_no_overlap():
    box = Rectangle(10, 10)
    assert worst_overlap(state_of([[1, 1], [3, 1]], [1, 1]), box) is None
    assert worst_overlap(state_of([[1, 1], [3 - 1e-10, 1]], [1, 1]), box) is None
    assert worst_overlap(state_of([[1 - 1e-10, 1], [5, 1]], [1, 1]), box) is None
    deep = worst_overlap(state_of([[1, 1], [2.5, 1]], [1, 1]), box)
    assert (deep.first, deep.second, deep.depth) == (0, 2, 0.5)
    assert str(deep) == "particle 0 and particle 2 overlap by 0.5"


@pytest.mark.small
def test_nothing_at_all():
    empty = state_of([], [])
    assert worst_overlap(empty, Rectangle(5, 5)) is None
    assert separate(empty, Rectangle(5, 5)) == 0.0


@settings(max_examples=60, deadline=None, derandomize=True)
@given(st.sampled_from(BOXES), st.integers(2, 60), st.sampled_from([1, 1.5, 5]), st.integers(0, 2**32))
def test_separate_undoes_all_overlaps(geometry, count, ratio, seed):
    state = random_state(geometry, count, ratio, seed)
    if np.pi * np.square(state.radius).sum() > 0.4 * geometry.area:
        return
    before = state.copy()
    moved = separate(state, geometry)
    assert_in_place(state, geometry)
    assert worst_overlap(state, geometry) is None
    way = state.position - before.position
    way -= np.where(geometry.periodic, np.round(way / geometry.size) * geometry.size, 0)
    assert moved == pytest.approx(np.hypot(*way.T).max(), rel=1e-9, abs=1e-12)
    assert (moved == 0) == (worst_overlap(before, geometry) is None)
    assert state.velocity.tobytes() == before.velocity.tobytes()


@pytest.mark.small
def test_separate_moves_only_what_it_must_and_the_lighter_farther():
    box = Rectangle(20, 20)
    state = state_of([[10, 10], [11, 10], [4, 4]], [1, 1, 1], mass=[1, 3, 1])
    moved = separate(state, box)
    assert moved == pytest.approx(0.75, rel=1e-6)
    assert state.position[0].tolist() == pytest.approx([9.25, 10], rel=1e-6)
    assert state.position[1].tolist() == pytest.approx([11.25, 10], rel=1e-6)
    assert state.position[2].tolist() == [4, 4]


@pytest.mark.small
def test_separate_what_stands_on_one_place_or_beyond_a_wall():
    box = Rectangle(20, 20)
    state = state_of([[5, 5]] * 6 + [[-3, 25]], [1] * 7)
    separate(state, box)
    assert_in_place(state, box)
    assert state.position[6].tolist() == [1, 19]


@pytest.mark.small
def test_a_separated_gas_is_left_alone():
    state = state_of([[1, 1], [3, 1], [19, 19]], [1, 1, 1])
    before = state.position.tobytes()
    assert separate(state, Rectangle(20, 20)) == 0.0
    assert state.position.tobytes() == before


def test_what_cannot_be_separated_is_refused_and_left():
    state = state_of([[2, 2], [2.5, 2], [3, 3], [2, 3]], [1.3] * 4)
    before = state.position.copy()
    with pytest.raises(ScenarioError, match="could not be pushed apart"):
        separate(state, Rectangle(5, 5))
    assert (state.position == before).all()


def test_a_hundred_thousand_are_searched_quickly():
    random = np.random.default_rng(1)
    state = state_of(random.random((100_000, 2)) * 1000, np.where(np.arange(100_000) % 1000, 0.2, 10))
    assert worst_overlap(state, Rectangle(1000, 1000)).depth > 0.2
