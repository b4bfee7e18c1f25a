"""Event-driven dynamics in enclosures of every kind."""

from __future__ import annotations

import hashlib

import numpy as np
import pytest
from enclosures import (
    ACTIVE,
    ALL,
    AT_REST,
    angular_momentum,
    deepest,
    event_driven,
    fill,
    internal_energy,
    still,
)
from gases import collect
from hall_twin import HallTwin

every = pytest.mark.parametrize("place", ALL.values(), ids=ALL.keys())
at_rest = pytest.mark.parametrize("place", AT_REST.values(), ids=AT_REST.keys())
active = pytest.mark.parametrize("place", ACTIVE.values(), ids=ACTIVE.keys())


def bits(state, dynamics) -> str:
    digest = hashlib.sha256()
    arrays = [state.position, state.velocity, state.wall_displacement, *vars(dynamics.tallies).values()]
    for _, value in sorted(dynamics.memory().items()):
        arrays.append(np.asarray(value))
    for array in arrays:
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


@every
def test_equals_the_slow_twin_to_the_bit(place):
    """All pairs and all elements before each event: the same collisions, at the same places and times."""
    state = fill(place, 14)
    twin = HallTwin(state.copy(), place, 5)
    engine = event_driven(state, place, contacts=5)
    until = min(8.0, engine.memory()["epoch_length"])
    rows = collect(engine, state, until)
    twin.run(until, engine.memory()["epoch_length"])
    assert len(rows) >= 10
    memory = engine.memory()
    assert np.array_equal(memory["time"], twin.t)
    assert np.array_equal(memory["position"], twin.x)
    assert np.array_equal(memory["velocity"], twin.v)


@every
def test_looking_never_disturbs(place):
    """In one go; in many odd pieces; with a tiny buffer of contacts; and resumed from memory: the same bits."""
    start, until = fill(place), 30.0
    whole = start.copy()
    engine = event_driven(whole, place)
    engine.advance(whole, until)
    expected = bits(whole, engine)
    assert engine.tallies.pair_collisions.sum() > 50

    pieces = start.copy()
    engine = event_driven(pieces, place)
    for time in np.sort(np.random.default_rng(1).uniform(0, until, 37)):
        engine.advance(pieces, time)
    engine.advance(pieces, until)
    assert bits(pieces, engine) == expected

    watched = start.copy()
    engine = event_driven(watched, place, contacts=3)
    rows = collect(engine, watched, until)
    tallies = engine.tallies
    assert (
        len(rows) == tallies.pair_collisions.sum() + tallies.wall_collisions.sum() + tallies.wall_passed.sum()
    )
    assert bits(watched, engine) == expected

    stopped = start.copy()
    first = event_driven(stopped, place)
    for time in (0.0, 11.3, 11.3, 23.05):
        first.advance(stopped, time)
        resumed = stopped.copy()
        second = event_driven(resumed, place, memory=first.memory())
        second.tallies = first.tallies.copy()
        first, stopped = second, resumed
    first.advance(stopped, until)
    assert bits(stopped, first) == expected


@at_rest
def test_conservation(place):
    """Energy with gravity to 1e-11, nobody overlaps, everybody is inside."""
    state = fill(place, 40)
    before = internal_energy(state, place)
    kinetic = 0.5 * (state.mass * (state.velocity**2).sum(axis=1)).sum()
    engine = event_driven(state, place)
    for time in (100.0, 200.0, 300.0):
        engine.advance(state, time)
        assert deepest(state, place) < 1e-9
        assert place.holds(state.position, state.radius * (1 - 1e-9)).all()
    assert engine.tallies.pair_collisions.sum() > 2000
    change = internal_energy(state, place) - before - engine.tallies.rest_energy[0]
    assert abs(change) < (1e-11 if any(place.gravity) else 1e-12) * kinetic * 10


@active
def test_work_and_heat_make_up_the_change_of_energy(place):
    """dU = W + Q to 1e-10, also of walls that move, swing, are warm, or free."""
    state = fill(place, 40)
    before = internal_energy(state, place)
    engine = event_driven(state, place)
    engine.advance(state, 60.0)
    tallies = engine.tallies
    change = internal_energy(state, place) - before
    booked = tallies.wall_work.sum() + tallies.wall_heat.sum() + tallies.rest_energy[0]
    assert change == pytest.approx(booked, abs=1e-10 * abs(before))
    assert deepest(state, place) < 1e-9
    now = still(place).at(state.wall_displacement)
    solid = [wall for wall in place.walls if wall.passes is None]
    if len(solid) == len(place.walls):
        assert now.holds(state.position, state.radius * (1 - 1e-9)).all()


def test_a_smooth_circle_keeps_the_angular_momentum():
    place = AT_REST["circle"]
    state = fill(place, 40)
    before = angular_momentum(state, (8.0, 8.0))
    engine = event_driven(state, place)
    engine.advance(state, 300.0)
    assert engine.tallies.wall_collisions.sum() > 400
    scale = (state.mass * np.hypot(*(state.position - 8.0).T) * np.hypot(*state.velocity.T)).sum()
    assert angular_momentum(state, (8.0, 8.0)) == pytest.approx(before, abs=1e-12 * scale)


@at_rest
def test_run_backwards(place):
    """Turned round, every disc flies back to where it came from."""
    state = fill(place, 12)
    start = state.position.copy()
    engine = event_driven(state, place)
    engine.advance(state, 6.0)
    assert engine.tallies.pair_collisions.sum() + engine.tallies.wall_collisions.sum() > 4
    state.velocity *= -1.0
    back = event_driven(state, place)
    back.advance(state, 12.0)
    away = place.wrap(state.position) - place.wrap(start)
    away -= np.where(place.periodic, np.rint(away / place.size) * place.size, 0.0)
    assert np.abs(away).max() < 1e-6
