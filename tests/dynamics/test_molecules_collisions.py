"""Single collisions of molecules, checked by hand: with each other, with discs, and with walls."""

from __future__ import annotations

import math

import numpy as np
import pytest
from enclosures import enclosure
from gases import collect
from molecular_gases import (
    BARBELL,
    BENT,
    DISC,
    DUMBBELL,
    ROD,
    angular_momentum,
    body,
    energy,
    engine_of,
    gas_of,
    momentum,
    overlap,
)

from gasbox.geometry import Passage, Path, Piston, Post, Rectangle, Segment

pytestmark = pytest.mark.small

BOX = Rectangle(20, 20)
FREE = Rectangle(200, 200)


def test_rods_end_on_exchange_their_velocities():
    state = gas_of([DUMBBELL], [0, 0], [[5, 10], [10, 10]], [[2, 0], [0.5, 0]])
    engine = engine_of(state, BOX, contacts=4)
    rows = collect(engine, state, 2.2)
    # Reaches of 1 each: they touch when the centres of mass are 2 apart, after 3/1.5.
    assert [row[:4] for row in rows] == [(0, pytest.approx(2.0, abs=1e-14), 0, 1)]
    np.testing.assert_allclose(state.velocity, [[0.5, 0], [2, 0]], atol=1e-15)
    assert state.angular_velocity.tolist() == [0, 0]
    assert engine.tallies.pair_virial[0] == pytest.approx(2.0 * 1.5 * 2.0, abs=1e-13)


def test_a_disc_that_hits_the_end_of_a_dumbbell_turns_it():
    """j = 2 v/(1/m + 1/M + l²/I), at a right angle to the axis, l = 1/2 from the centre of mass."""
    state = gas_of([DUMBBELL, DISC], [0, 1], [[10, 10], [10.5, 5]], [[0, 0], [0, 1]])
    engine = engine_of(state, BOX, contacts=4)
    rows = collect(engine, state, 4.5)
    inertia = 2 * (0.25 + 0.125)
    push = 2.0 / (1.0 + 0.5 + 0.25 / inertia)
    assert [row[:4] for row in rows] == [(0, pytest.approx(4.0, abs=1e-14), 0, 1)]
    assert rows[0][5] == pytest.approx(push, rel=1e-14)
    np.testing.assert_allclose(state.velocity, [[0, push / 2], [0, 1 - push]], atol=1e-14)
    np.testing.assert_allclose(state.angular_velocity, [0.5 * push / inertia, 0], atol=1e-14)
    assert state.angle[0] == pytest.approx(0.5 * 0.5 * push / inertia, abs=1e-14)


def test_a_spinning_dumbbell_sweeps_up_a_disc_at_rest():
    """The disc lies where the turning end comes by after an angle known from the triangle of the centres."""
    away = np.array([0.9, 1.0])
    state = gas_of([DUMBBELL, DISC], [0, 1], [[10, 10], 10 + away], np.zeros((2, 2)), 0.0, [0.5, 0.0])
    length = math.hypot(*away)
    inner = math.acos((0.25 + length**2 - 1.0) / (2 * 0.5 * length))
    expected = (math.atan2(away[1], away[0]) - inner) / 0.5
    engine = engine_of(state, BOX, contacts=4)
    rows = collect(engine, state, expected + 0.1)
    assert rows[0][1] == pytest.approx(expected, rel=1e-14)
    assert energy(state) == pytest.approx(0.5 * 0.75 * 0.25, rel=1e-14)


@pytest.mark.parametrize("shapes", [(DUMBBELL, DUMBBELL), (BENT, ROD), (BARBELL, DISC), (ROD, ROD)])
def test_each_collision_conserves_energy_momentum_and_angular_momentum(shapes):
    rng = np.random.default_rng(4)
    happened = 0
    for _ in range(40):
        turn, spin = (
            rng.random(2) * 2 * np.pi,
            rng.normal(size=2) * 3 * (np.array([s.inertia for s in shapes]) > 0),
        )
        speed = rng.normal(size=(2, 2))
        aim = 100 + np.array([[-4.0, 0.3 * rng.normal()], [4.0, 0.3 * rng.normal()]])
        speed[:, 0] = [2 + abs(speed[0, 0]), -abs(speed[1, 0])]
        state = gas_of(shapes, [0, 1], aim, speed, turn, spin)
        before = energy(state), momentum(state), angular_momentum(state, (100, 100))
        engine = engine_of(state, FREE)
        engine.advance(state, 6.0)
        happened += int(engine.tallies.pair_collisions.sum())
        assert overlap(state, FREE) < 1e-12
        assert energy(state) == pytest.approx(before[0], rel=1e-13)
        np.testing.assert_allclose(momentum(state), before[1], rtol=0, atol=1e-13 * np.abs(speed).max() * 4)
        scale = before[0] ** 0.5 * 30
        assert angular_momentum(state, (100, 100)) == pytest.approx(before[2], abs=1e-13 * scale)
    assert happened > 15


def test_a_barbell_can_hit_twice():
    """It falls aslant on a disc so large and heavy that first one end hits it, and then the other."""
    heavy = body([[0, 0]], 4.0, 1000.0)
    state = gas_of([BARBELL, heavy], [0, 1], [[100, 105], [100, 100]], [[0, -1], [0, 0]], 0.1)
    before = energy(state), angular_momentum(state, (100, 100))
    engine = engine_of(state, FREE, contacts=20)
    rows = collect(engine, state, 8.0)
    assert len(rows) == 2
    assert rows[1][1] - rows[0][1] < 1.0
    assert energy(state) == pytest.approx(before[0], rel=1e-13)
    assert angular_momentum(state, (100, 100)) == pytest.approx(before[1], abs=1e-12)


def test_a_dumbbell_that_falls_flat_on_a_wall_bounces_flat():
    """Both ends touch at one moment; the two impulses, one after the other, keep its energy."""
    state = gas_of([DUMBBELL], [0], [[10, 10]], [[0, -1]])
    engine = engine_of(state, BOX, contacts=8)
    rows = collect(engine, state, 12.0)
    assert energy(state) == pytest.approx(1.0, rel=1e-14)
    assert state.velocity[0, 1] > 0
    assert {row[3] for row in rows if row[1] < 10.0} == {2}


def test_a_wall_turns_a_dumbbell_that_hits_it_aslant():
    """J = 2 v/(1/m + l²/I) with the lever l = sin(45°)/2 of the end that touches."""
    state = gas_of([DUMBBELL], [0], [[10, 5]], [[0, -1]], math.pi / 4)
    engine = engine_of(state, BOX, contacts=4)
    rows = collect(engine, state, 4.5)
    lever = 0.5 * math.sqrt(0.5)
    push = 2.0 / (0.5 + lever**2 / 0.75)
    assert [row[:4] for row in rows] == [(1, pytest.approx(5 - 0.5 - lever, rel=1e-14), 0, 2)]
    np.testing.assert_allclose(state.velocity, [[0, push / 2 - 1]], atol=1e-14)
    np.testing.assert_allclose(state.angular_velocity, [-lever * push / 0.75], atol=1e-14)
    assert engine.tallies.wall_impulse[2, 0] == pytest.approx(push, rel=1e-14)
    assert energy(state) == pytest.approx(1.0, rel=1e-14)


@pytest.mark.parametrize("rate", [-0.25, 0.25])
def test_a_moving_wall_does_the_work_that_it_books(rate):
    place = enclosure(BOX, right={"motion": Path((0.0,), (0.0,), (rate,))})
    state = gas_of([BENT], [0], [[10, 10]], [[1, 0.3]], 0.7, 1.3)
    before = energy(state)
    engine = engine_of(state, place)
    engine.advance(state, 14.0)
    assert engine.tallies.wall_collisions[1, 0] >= 1
    assert energy(state) - before == pytest.approx(engine.tallies.wall_work[1, 0], rel=1e-12)
    assert abs(engine.tallies.wall_work[1, 0]) > 0.1


def test_a_free_piston_and_a_molecule_share_energy_and_momentum():
    place = enclosure(BOX, (Segment((10.0, 0.0), (10.0, 20.0)),), o0={"motion": Piston(3.0)})
    state = gas_of([BENT], [0], [[5, 10]], [[1, 0.1]], 0.7, 0.4)
    before, along = energy(state), momentum(state)[0]
    engine = engine_of(state, place)
    engine.advance(state, 6.0)
    assert engine.tallies.wall_collisions[4, 0] >= 1
    speed = state.wall_velocity[4]
    assert energy(state) + 1.5 * speed**2 == pytest.approx(before, rel=1e-13)
    assert momentum(state)[0] + 3.0 * speed == pytest.approx(along, abs=1e-13)
    assert energy(state) - before == pytest.approx(engine.tallies.wall_work[4, 0], rel=1e-12)


def test_a_molecule_hits_a_corner_with_an_end():
    """The end of a segment, and a post, between two discs of a barbell: only discs touch."""
    place = enclosure(BOX, (Segment((10.0, 5.0), (10.0, 10.0)), Post((4.0, 4.0), 0.5)))
    state = gas_of([BARBELL], [0], [[10.3, 14]], [[0, -1]])
    engine = engine_of(state, place, contacts=4)
    rows = collect(engine, state, 3.8)
    # The lighter end is 4/3 to the left of the centre of mass, the heavier one 2/3 to its right.
    assert rows == []
    state = gas_of([BARBELL], [0], [[9.3333333333, 14]], [[0, -1]])
    rows = collect(engine_of(state, place, contacts=4), state, 3.8)
    assert [row[:4] for row in rows] == [(1, pytest.approx(3.7, abs=1e-12), 0, 4)]


def test_a_line_and_an_open_wall_know_the_centre_of_mass():
    place = enclosure(
        BOX, (Segment((10.0, 0.0), (10.0, 20.0)),), right={"open": True}, o0={"passes": Passage()}
    )
    state = gas_of([DUMBBELL], [0], [[5, 10]], [[1, 0]], 0.3, 2.0)
    engine = engine_of(state, place, contacts=4)
    rows = collect(engine, state, 14.9)
    assert [row[:4] for row in rows] == [(2, 5.0, 0, 4)]
    assert state.count == 1
    carried = energy(state)
    rows = collect(engine, state, 15.1)
    assert [row[:4] for row in rows] == [(2, 15.0, 0, 1)]
    assert state.count == state.sites.count == state.angle.size == 0
    assert engine.tallies.wall_carried[1, 0] == pytest.approx(carried, rel=1e-15)
