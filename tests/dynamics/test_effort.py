"""What finding a collision costs, in numbers that don't depend on the machine's mood."""

from __future__ import annotations

import numpy as np
import pytest
from gases import collisions, event_driven, state_of

from gasbox.geometry import Rectangle


def equilibrated(count: int, fraction: float):
    """Discs of diameter 1 from a square lattice, m = kT = 1, some three collisions each."""
    columns = int(np.ceil(np.sqrt(count)))
    side = np.sqrt(count * np.pi / 4 / fraction)
    place = (np.stack(np.divmod(np.arange(count), columns), 1) + 0.5) * side / columns
    velocity = np.random.default_rng(3).normal(size=(count, 2))
    state = state_of(place, velocity, 0.5)
    engine = event_driven(state, Rectangle(side, side, True, True))
    while collisions(engine) < 3 * count:
        engine.advance(state, state.time + 0.1)
    return state, engine


# Ceilings: a tenth above what the engine needs today (5.8 and 21, 2.2 and 12.5, 1.4 and 16), the same on every machine.
@pytest.mark.parametrize(
    ("fraction", "events", "tests"), [(0.05, 6.4, 23), (0.3, 2.5, 13.8), (0.6, 1.53, 17.8)]
)
def test_events_and_pair_tests_a_collision(fraction, events, tests):
    state, engine = equilibrated(2500, fraction)
    before, done = engine.effort(), collisions(engine)
    engine.advance(state, state.time + 2.0 / fraction)
    executed = collisions(engine) - done
    effort = {name: (value - before[name]) / executed for name, value in engine.effort().items()}
    assert executed > 2000
    assert effort["events"] < events
    assert effort["pair_tests"] < tests
    assert effort["stale_events"] < 0.2
