"""What walls do to discs, in the event-driven engine: push, warm, let pass, let out, hold up."""

from __future__ import annotations

import math

import numpy as np
import pytest
from enclosures import BOX, DIVIDER, deepest, enclosure, event_driven, fill, internal_energy
from gases import collect, state_of

from gasbox.geometry import Circle, Passage, Path, Piston, Polygon, Rectangle, Segment
from gasbox.state import ContactKind

DOWN = (0.0, -1.0)


@pytest.mark.small
@pytest.mark.parametrize(("speed", "after"), [(-0.25, -1.5), (0.25, -0.5), (0.0, -1.0)])
def test_a_moving_wall_gives_twice_its_speed(speed, after):
    """v' = 2u - v, and the work is the change of energy: u times the impulse."""
    place = enclosure(BOX, right={"motion": Path((0.0,), (0.0,), (speed,))})
    state = state_of([[10, 6]], [[1, 0.5]], 0.5, 2.0)
    engine = event_driven(state, place)
    engine.advance(state, 7.5)
    assert state.velocity.tolist() == [[after, 0.5]]
    assert engine.tallies.wall_work[1, 0] == pytest.approx(after**2 - 1.0, abs=1e-14)
    assert engine.tallies.wall_impulse[1, 0] == pytest.approx(2.0 * (1.0 - after), abs=1e-14)


@pytest.mark.small
def test_a_wall_overtakes_a_slow_disc():
    place = enclosure(BOX, left={"motion": Path((1.0,), (0.0,), (2.0,))})
    state = state_of([[4, 6]], [[0.5, 0]], 0.5)
    engine = event_driven(state, place)
    engine.advance(state, 5.0)
    assert state.velocity.tolist() == [[3.5, 0.0]]


@pytest.mark.small
def test_a_free_piston_and_a_disc_exchange_momentum():
    place = enclosure(BOX, (DIVIDER,), o0={"motion": Piston(3.0)})
    state = state_of([[2, 6]], [[1, 0]], 0.5)
    engine = event_driven(state, place)
    engine.advance(state, 6.5)
    assert state.velocity.tolist() == [[-0.5, 0.0]]
    assert state.wall_velocity[4] == 0.5
    assert state.wall_displacement[4] == pytest.approx(0.5 * 1.0)
    assert engine.tallies.wall_work[4, 0] == -0.375


@pytest.mark.small
def test_a_piston_bounces_from_its_stops():
    place = enclosure(BOX, (DIVIDER,), o0={"motion": Piston(3.0, speed=1.0, lower=-2.0, upper=2.0)})
    state = state_of(np.zeros((0, 2)), np.zeros((0, 2)))
    engine = event_driven(state, place)
    for time, where in [(2.0, 2.0), (3.0, 1.0), (6.0, -2.0), (9.0, 1.0)]:
        engine.advance(state, time)
        assert state.wall_displacement[4] == pytest.approx(where, abs=1e-12)


@pytest.mark.small
def test_a_piston_rests_on_its_stop_until_it_is_lifted_off():
    """Pressed there, it does not bounce for ever; a disc that flies up gives it twice its share of momentum."""
    place = enclosure(BOX, gravity=DOWN, top={"motion": Piston(5.0, 0.0, lower=0.0, upper=4.0)})
    state = state_of([[8, 2]], [[0, 5]], 0.5)
    engine = event_driven(state, place)
    # It reaches 12 - 0.5 with the speed sqrt(25 - 2 * 9.5).
    met = 5.0 - math.sqrt(6.0)
    engine.advance(state, met - 1e-6)
    assert state.wall_displacement[3] == 0.0
    assert state.wall_velocity[3] == 0.0
    engine.advance(state, met + 1e-6)
    assert state.wall_velocity[3] == pytest.approx(2.0 / 6.0 * math.sqrt(6.0), abs=1e-5)
    for time in np.arange(1, 60) * 0.5 + met:
        engine.advance(state, time)
        assert 0.0 <= state.wall_displacement[3] <= 4.0
    assert engine.tallies.wall_collisions[3, 0] > 1


@pytest.mark.small
@pytest.mark.parametrize("speed", [0.0, 1e-9])
def test_a_disc_at_rest_on_the_floor_stays_there(speed):
    place = enclosure(BOX, gravity=DOWN)
    state = state_of([[8, 0.5]], [[0, speed]], 0.5)
    engine = event_driven(state, place)
    for time in np.arange(1, 40) * 0.77:
        engine.advance(state, time)
        assert 0.5 - 1e-12 <= state.position[0, 1] <= 0.5 + 1.01e-6 * 0.5
    assert engine.tallies.rest_energy[0] == pytest.approx(0.5e-6, rel=1e-6)


def test_discs_at_rest_in_a_heap_do_not_sink():
    """In a V-shaped polygon, in a corner, and wedged in a shaft: for a long time, not a billionth."""
    valley = enclosure(
        Polygon(((0.0, 5.0), (5.0, 0.0), (10.0, 5.0), (10.0, 12.0), (0.0, 12.0))), gravity=DOWN
    )
    one = state_of([[5, np.sqrt(0.5)]], [[0, 0]], 0.5)
    slope = enclosure(BOX, gravity=(-0.2, -1.0))
    corner = state_of([[0.5, 0.5], [0.5, 1.5], [1.5, 0.5]], np.zeros((3, 2)), 0.5)
    shaft = enclosure(Rectangle(1.6, 12), gravity=DOWN)
    wedged = state_of([[0.5 + 0.6 * (k % 2), 0.5 + 0.8 * k] for k in range(5)], np.zeros((5, 2)), 0.5)
    for place, gas in ((valley, one), (slope, corner), (shaft, wedged)):
        height = gas.position[:, 1].copy()
        engine = event_driven(gas, place)
        for time in np.arange(1, 9) * 5.03:
            engine.advance(gas, time)
            assert deepest(gas, place) < 1e-9
            assert place.holds(gas.position, gas.radius * (1 - 1e-9)).all()
        # They only tremble, on what the rule has given.
        assert engine.tallies.rest_energy[0] < 1e-3
        assert 0.5 * (gas.mass * (gas.velocity**2).sum(axis=1)).sum() < 1e-3
        assert np.abs(gas.position[:, 1] - height).max() < 1e-2


def test_a_disc_rolls_along_the_bottom_of_a_circle():
    place = enclosure(Circle(8.0), gravity=DOWN)
    state = state_of([[8 + 7.5 * np.sin(0.5), 8 - 7.5 * np.cos(0.5)]], [[0, 0]], 0.5)
    before = internal_energy(state, place)
    engine = event_driven(state, place)
    engine.advance(state, 60.0)
    assert place.holds(state.position, state.radius * (1 - 1e-9)).all()
    change = internal_energy(state, place) - before - engine.tallies.rest_energy[0]
    assert change == pytest.approx(0.0, abs=1e-10)


@pytest.mark.small
def test_a_membrane_lets_one_species_pass_and_counts_it():
    place = enclosure(BOX, (DIVIDER,), o0={"passes": Passage((1,))})
    state = state_of([[6, 3], [6, 9]], [[1, 0], [1, 0]], 0.5, 1.0, [0, 1])
    engine = event_driven(state, place, contacts=10)
    rows = collect(engine, state, 4.0)
    assert state.velocity[:, 0].tolist() == [-1.0, 1.0]
    assert [(row[0], row[1], row[2], row[3]) for row in rows] == [
        (ContactKind.WALL, 1.5, 0, 4),
        (ContactKind.CROSSING, 2.0, 1, 4),
    ]
    assert engine.tallies.wall_passed[4].tolist() == [[0, 0], [1, 0]]


@pytest.mark.small
def test_each_passage_counts_once():
    """To and fro through a slanting line, with gravity and without: counts are the changes of side."""
    for gravity in ((0.0, 0.0), (0.0, -0.3)):
        line = Segment((3.0, 0.0), (13.0, 12.0))
        place = enclosure(BOX, (line,), gravity, o0={"passes": Passage()})
        state = fill(place, 12, seed=5)
        normal = np.array(line.normal)
        front = (state.position - line.start) @ normal > 0
        engine = event_driven(state, place)
        engine.advance(state, 50.0)
        after = (state.position - line.start) @ normal > 0
        passed = engine.tallies.wall_passed[4].sum(axis=0)
        assert passed.sum() > 20
        assert passed[0] - passed[1] == int(after.sum()) - int(front.sum())


@pytest.mark.small
@pytest.mark.parametrize(
    ("gate", "velocity", "passes"),
    [
        (Passage(None, "forward", 0.5, 2.0), (1.0, 0.0), True),
        (Passage(None, "forward", 0.5, 2.0), (0.3, 0.0), False),
        (Passage(None, "forward", 0.5, 2.0), (3.0, 0.0), False),
        (Passage(None, "backward", 0.5, 2.0), (1.0, 0.0), False),
        (Passage(None, "backward"), (-1.0, 0.0), True),
    ],
)
def test_a_gate_looks_at_speed_and_direction(gate, velocity, passes):
    place = enclosure(BOX, (DIVIDER,), o0={"passes": gate})
    start = 6.0 if velocity[0] > 0 else 10.0
    state = state_of([[start, 6]], [velocity], 0.5)
    engine = event_driven(state, place)
    engine.advance(state, 2.4 / abs(velocity[0]))
    assert bool(state.velocity[0, 0] == velocity[0]) is passes
    assert engine.tallies.wall_passed[4].sum() == passes


@pytest.mark.small
def test_an_open_wall_lets_out_for_good():
    place = enclosure(BOX, left={"open": True})
    state = state_of([[3, 3], [4, 6], [9, 9]], [[-1, 0], [-0.1, 0], [1, 0]], 0.5, 2.0)
    state.id = np.array([4, 7, 9])
    engine = event_driven(state, place, contacts=10)
    rows = collect(engine, state, 5.0)
    assert state.id.tolist() == [7, 9]
    assert state.position.tolist() == [[3.5, 6.0], [14.0, 9.0]]
    assert rows == [(ContactKind.CROSSING, 3.0, 4, 0, -2.0, 0.0)]
    assert engine.tallies.wall_carried[0, 0] == 1.0
    assert engine.tallies.wall_passed[0, 0].tolist() == [0, 1]
    engine.advance(state, 50.0)
    assert state.id.tolist() == []


def test_who_has_left_is_gone_whoever_looks():
    place = enclosure(BOX, (Segment((4.0, 0.0), (4.0, 5.0)),), left={"open": True})
    ends = set()
    for pieces in (1, 7, 40):
        state = fill(place, 40)
        engine = event_driven(state, place)
        for time in np.linspace(0, 12.0, pieces + 1)[1:]:
            engine.advance(state, time)
        ends.add((tuple(state.id.tolist()), state.position.tobytes(), state.velocity.tobytes()))
        assert 0 < state.count < 40
        assert engine.tallies.wall_passed.sum() == 40 - state.count
    assert len(ends) == 1


def test_a_divider_put_back_lets_go_whom_it_meets():
    """Discs that stand in its place are let out on either side, and then nobody passes any more."""
    from gasbox.dynamics import altered
    from gasbox.state import SetWall

    shut = enclosure(BOX, (DIVIDER,))
    open_ = altered(shut, 0.0, SetWall("o0", present=False), shut)
    state = fill(open_, 60, sizes=(0.4, 0.3))
    engine = event_driven(state, open_)
    engine.advance(state, 20.0)
    closed = altered(open_, 20.0, SetWall("o0", present=True), shut)
    inside = np.abs(state.position[:, 0] - 8.0) < state.radius
    assert inside.any()
    engine.alter(state, closed)
    engine.advance(state, 40.0)
    clear = np.abs(state.position[:, 0] - 8.0) >= state.radius * (1 - 1e-9)
    assert clear.mean() > 0.9
    side = state.position[clear, 0] > 8.0
    ids = state.id[clear]
    engine.advance(state, 60.0)
    now = state.position[np.isin(state.id, ids), 0] > 8.0
    assert np.array_equal(side, now)


def test_a_change_that_changes_nothing_leaves_the_gas_alone():
    """But for rounding: references move to the time of the change."""
    place = enclosure(Rectangle(16, 12, True))
    state = fill(place, 10)
    other = state.copy()
    one, two = event_driven(state, place), event_driven(other, place)
    one.advance(state, 2.0)
    two.advance(other, 1.0)
    two.alter(other, place)
    two.advance(other, 2.0)
    assert np.allclose(state.position, other.position, atol=1e-12)
