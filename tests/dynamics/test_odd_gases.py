"""Event-driven runs of odd gases against brute force: the same events in the same order, and the same bits."""

from __future__ import annotations

import numpy as np
import pytest
from brute_force import BruteForce
from gases import collect, deepest_overlap, energy, event_driven
from odd_gases import odd_gas

from gasbox.geometry import Rectangle
from gasbox.state import State


def compare(state: State, geometry: Rectangle, wanted: int) -> int:
    """Run some `wanted` collisions, and twice as long each time if there are few; return how many there were."""
    begin = energy(state)
    engine = event_driven(state, geometry, contacts=7)
    brute = BruteForce(state, geometry, engine.memory()["epoch_length"])
    fastest = float(np.abs(state.velocity).max())
    span = 0.1 * np.sqrt(geometry.area / state.count) / np.sqrt((state.velocity**2).sum(axis=1).mean())
    done = 0
    for _ in range(60):
        until = state.time + span
        rows = collect(engine, state, until)
        brute.run(until)
        events = [(time, 1 if kind == 0 else 2, i, j) for kind, time, i, j, *_ in rows]
        assert events == brute.events
        assert np.array_equal(state.position, brute.position(until))
        assert np.array_equal(state.velocity, brute.v)
        assert deepest_overlap(state, geometry) < 1e-9
        assert np.all(geometry.holds(state.position, state.radius * (1 - 1e-9)))
        brute.events.clear()
        done += len(events)
        # In a box that is nearly empty the search over all images takes as long as the flight.
        if done > wanted or span * fastest > 100 * geometry.size.max():
            break
        span *= 2.0 if len(events) < wanted / 5 else 1.0
    assert energy(state) == pytest.approx(begin, rel=1e-11)
    return done


def test_odd_gases_as_by_brute_force():
    assert sum(compare(*odd_gas(seed), 150) for seed in range(60)) > 1e4


@pytest.mark.validate
def test_many_odd_gases_as_by_brute_force():
    assert sum(compare(*odd_gas(seed), 600) for seed in range(1000, 1200)) > 1e5
