"""The stepped rule in enclosures: who passes a wall, who is counted, and who leaves."""

from __future__ import annotations

import numpy as np
import pytest
from enclosures import BOX, DIVIDER, enclosure, fill
from gases import collect, state_of
from stepped_gases import bits, stepped

from gasbox.geometry import Passage, Rectangle, Segment
from gasbox.state import ContactKind


@pytest.mark.small
def test_a_membrane_lets_one_species_pass_and_counts_it():
    place = enclosure(BOX, (DIVIDER,), o0={"passes": Passage((1,))})
    state = state_of([[6, 3], [6, 9]], [[1, 0], [1, 0]], 0.5, 1.0, [0, 1])
    engine = stepped(state, place, contacts=10, time_step=0.25)
    rows = collect(engine, state, 4.0)
    assert state.velocity[:, 0].tolist() == [-1.0, 1.0]
    assert [row[:4] for row in rows] == [(ContactKind.WALL, 1.5, 0, 4), (ContactKind.CROSSING, 2.0, 1, 4)]
    assert engine.tallies.wall_passed[4].tolist() == [[0, 0], [1, 0]]


@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.0, -0.3)])
@pytest.mark.parametrize("speed", [1.0, 60.0])
def test_each_passage_counts_once(gravity, speed):
    """To and fro through a slanting line: counts are the changes of side."""
    line = Segment((3.0, 0.0), (13.0, 12.0))
    place = enclosure(BOX, (line,), gravity, o0={"passes": Passage()})
    state = fill(place, 12, seed=5)
    state.velocity *= speed
    normal = np.array(line.normal)
    engine = stepped(state, place)
    passed, front = 0, (state.position - line.start) @ normal >= 0
    for step in range(1, 2500):
        engine.advance(state, step * 0.02)
        after = (state.position - line.start) @ normal >= 0
        passed, front = passed + np.array([(after & ~front).sum(), (front & ~after).sum()]), after
    assert passed.sum() > 20
    assert engine.tallies.wall_passed[4].sum(axis=0).tolist() == passed.tolist()


@pytest.mark.small
@pytest.mark.parametrize("place_of_line", [8.0, 8.05])
@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_centre_that_stops_on_the_line_is_counted_once(place_of_line, way):
    place = enclosure(BOX, (Segment((place_of_line, 0.0), (place_of_line, 12.0)),), o0={"passes": Passage()})
    state = state_of([[8.0 - 2.0 * way, 6]], [[way, 0]], 0.5)
    engine = stepped(state, place, time_step=0.25)
    engine.advance(state, 4.0)
    assert engine.tallies.wall_passed[4, 0].tolist() == ([1, 0] if way > 0 else [0, 1])


@pytest.mark.small
@pytest.mark.parametrize(
    ("gate", "velocity", "passes"),
    [
        (Passage(None, "forward", 0.5, 2.0), (1.0, 0.0), True),
        (Passage(None, "forward", 0.5, 2.0), (0.3, 0.0), False),
        (Passage(None, "forward", 0.5, 2.0), (3.0, 0.0), False),
        (Passage(None, "forward", 0.5, 2.0), (90.0, 0.0), False),
        (Passage(None, "backward", 0.5, 2.0), (1.0, 0.0), False),
        (Passage(None, "backward"), (-1.0, 0.0), True),
        (Passage(None, "backward"), (-30.0, 0.0), True),
    ],
)
def test_a_gate_looks_at_speed_and_direction(gate, velocity, passes):
    place = enclosure(BOX, (DIVIDER,), o0={"passes": gate})
    start = 6.0 if velocity[0] > 0 else 10.0
    state = state_of([[start, 6]], [velocity], 0.5)
    engine = stepped(state, place, time_step=2.4 / abs(velocity[0]) / (1 if abs(velocity[0]) > 5 else 48))
    engine.advance(state, 2.4 / abs(velocity[0]))
    assert bool(state.velocity[0, 0] == velocity[0]) is passes
    assert bool((state.position[0, 0] - 8.0) * velocity[0] > 0.0) is passes
    assert engine.tallies.wall_passed[4].sum() == passes


@pytest.mark.small
def test_an_open_wall_lets_out_for_good():
    place = enclosure(BOX, left={"open": True})
    state = state_of([[3.1, 3], [4, 6], [9, 9]], [[-1, 0], [-0.1, 0], [1, 0]], 0.5, 2.0)
    state.id = np.array([4, 7, 9])
    engine = stepped(state, place, contacts=10, time_step=0.3)
    rows = collect(engine, state, 5.1)
    assert state.id.tolist() == [7, 9]
    assert state.position == pytest.approx(np.array([[3.49, 6.0], [14.1, 9.0]]), abs=1e-12)
    assert [row[:4] for row in rows] == [(ContactKind.CROSSING, 11 * 0.3, 4, 0)]
    assert rows[0][4:] == (-2.0, 0.0)
    assert engine.tallies.wall_carried[0, 0] == 1.0
    assert engine.tallies.wall_passed[0, 0].tolist() == [0, 1]
    engine.advance(state, 60.0)
    assert state.id.tolist() == []


def test_a_crowd_that_leaves_is_the_same_whoever_looks():
    """Hundreds leave within one call, so that the engine lets go of them on the way."""
    place = enclosure(Rectangle(60, 40), left={"open": True}, right={"open": True})
    start = fill(place, 400)
    ends = set()
    for pieces in (1, 7, 60):
        state = start.copy()
        engine = stepped(state, place)
        for time in np.linspace(0, 60.0, pieces + 1)[1:]:
            engine.advance(state, time)
        ends.add(bits(state, engine))
        assert 0 < state.count < 200
        assert engine.tallies.wall_passed.sum() == 400 - state.count
    assert len(ends) == 1
