"""Cases that trip event-driven engines: touching, simultaneous, grazing, resting, alone, in corners."""

from __future__ import annotations

import math

import numpy as np
import pytest
from gases import collect, collisions, deepest_overlap, energy, event_driven, random_gas, state_of

from gasbox.errors import DynamicsError
from gasbox.geometry import Rectangle

pytestmark = pytest.mark.small
BOX = Rectangle(40, 40)


def test_newtons_cradle():
    """Five touching discs in a row: the first stops, the last flies off with all the speed."""
    state = state_of([[5, 20]] + [[10 + 2 * k, 20] for k in range(5)], [[1, 0]] + [[0, 0]] * 5)
    engine = event_driven(state, BOX)
    engine.advance(state, 10.0)
    assert state.velocity == pytest.approx(np.array([[0, 0]] * 5 + [[1, 0]]), abs=1e-12)
    assert collisions(engine) == 5
    assert state.position[5, 0] == pytest.approx(18 + 7.0, abs=1e-12)


def test_three_meet_at_once():
    """Two discs hit a third from both sides at one moment: all is exchanged, nothing is lost."""
    state = state_of([[10, 20], [20, 20], [30, 20]], [[1, 0], [0, 0], [-1, 0]])
    engine = event_driven(state, BOX)
    engine.advance(state, 9.0)
    assert energy(state) == pytest.approx(1.0, abs=1e-13)
    assert state.velocity == pytest.approx(np.array([[-1, 0], [0, 0], [1, 0]]), abs=1e-12)
    assert deepest_overlap(state, BOX) < 1e-12


def test_a_crowd_at_one_moment():
    """A lattice in which every disc meets its neighbour at the same time, over and over."""
    k = np.arange(16)
    position = np.stack([2.5 * (k % 4) + 3, 2.5 * (k // 4) + 3], 1)
    velocity = np.stack([np.where(k % 2 == 0, 1.0, -1.0), np.zeros(16)], 1)
    state = state_of(position, velocity)
    geometry = Rectangle(13.5, 13.5)
    engine = event_driven(state, geometry)
    engine.advance(state, 50.0)
    assert collisions(engine) > 100
    assert energy(state) == pytest.approx(8.0, abs=1e-12)
    assert deepest_overlap(state, geometry) < 1e-12


@pytest.mark.parametrize(("offset", "meets"), [(2.0 - 1e-9, True), (2.0, False), (2.0 + 1e-9, False)])
def test_grazing(offset, meets):
    state = state_of([[5, 10], [20, 10 + offset]], [[1, 0], [0, 0]])
    engine = event_driven(state, BOX)
    engine.advance(state, 30.0)
    assert collisions(engine) == int(meets)
    assert energy(state) == pytest.approx(0.5, abs=1e-15)
    assert deepest_overlap(state, BOX) < 1e-12


def test_sliding_along_each_other():
    """Two touching discs with the same velocity, and two that slide apart along their tangent, don't collide."""
    state = state_of([[5, 5], [7, 5], [5, 20], [5, 22]], [[0.1, 0.2], [0.1, 0.2], [1, 0], [-0.1, 0]])
    engine = event_driven(state, BOX)
    engine.advance(state, 20.0)
    assert collisions(engine) == 0


@pytest.mark.parametrize("periodic", [(False, False), (True, False), (True, True)])
def test_alone(periodic):
    geometry = Rectangle(7, 5, *periodic)
    state = state_of([[3, 2]], [[1.5, -0.7]], 0.5)
    engine = event_driven(state, geometry, contacts=2)
    rows = collect(engine, state, 100.0)
    assert energy(state) == pytest.approx(0.5 * (1.5**2 + 0.7**2), rel=1e-14)
    expected = 0
    for axis, at in ((0, 3 + 150.0), (1, 2 - 70.0)):
        if geometry.periodic[axis]:
            assert state.position[0, axis] == pytest.approx(at % geometry.size[axis], abs=1e-11)
        else:
            room = geometry.size[axis] - 1.0
            expected += abs(math.floor((at - 0.5) / room))
            fold = (at - 0.5) % (2 * room)
            assert state.position[0, axis] - 0.5 == pytest.approx(min(fold, 2 * room - fold), abs=1e-11)
    assert len(rows) == expected


def test_nobody_moves():
    state = state_of([[5, 5], [9, 9]], [[0, 0], [0, 0]])
    engine = event_driven(state, BOX)
    engine.advance(state, 1e9)
    assert state.position.tolist() == [[5, 5], [9, 9]]


@pytest.mark.parametrize("contacts", [0, 7])
def test_who_has_no_room_to_move_is_told(contacts):
    """A disc as wide as its box hits both walls for ever at one moment, however often contacts are read meanwhile."""
    state = state_of([[1, 5]], [[1, 0.5]])
    engine = event_driven(state, Rectangle(2, 10), contacts)
    with pytest.raises(DynamicsError, match=r"time 0\b"):
        collect(engine, state, 1.0)


def test_empty_box():
    state = state_of(np.zeros((0, 2)), np.zeros((0, 2)))
    engine = event_driven(state, BOX)
    engine.advance(state, 10.0)
    assert state.time == 10.0


def test_into_the_corner():
    state = state_of([[4, 4]], [[-1, -1]])
    rows = collect(event_driven(state, BOX, contacts=1), state, 6.0)
    assert [row[3] for row in rows] == [0, 2]
    assert state.position == pytest.approx(np.array([[4.0, 4.0]]), abs=1e-12)


def test_never_missed_at_any_speed():
    """A tiny disc crosses the box a million times faster than the rest and still hits the disc in its way."""
    state = state_of([[5, 20], [35, 20]], [[1e6, 0], [0, 0]], [0.001, 0.001])
    engine = event_driven(state, BOX, contacts=1)
    (first, *_) = collect(engine, state, 1e-4)
    assert first[:4] == (0, pytest.approx(29.998e-6, rel=1e-12), 0, 1)


def test_late_times_lose_no_digits():
    """A run that starts at time 2**40 goes through the same bits as one that starts at 0."""
    geometry = Rectangle(12, 9)
    early = random_gas(4, geometry, [0.5] * 20)
    late = early.copy()
    late.time = 2.0**40
    event_driven(early, geometry).advance(early, 3.0)
    event_driven(late, geometry).advance(late, 2.0**40 + 3.0)
    assert np.array_equal(early.position, late.position)
    assert np.array_equal(early.velocity, late.velocity)


def test_references_move_with_the_epochs():
    geometry = Rectangle(12, 9)
    state = random_gas(4, geometry, [0.5] * 20)
    engine = event_driven(state, geometry)
    length = engine.memory()["epoch_length"]
    engine.advance(state, 3.5 * length)
    memory = engine.memory()
    assert memory["epoch"] == 3
    assert memory["time"].max() <= 0.5 * length
    assert memory["time"].min() >= 0.0
