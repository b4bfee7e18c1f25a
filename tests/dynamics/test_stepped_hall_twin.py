"""The stepped rule in enclosures against a slow twin without cells, marks, or order of memory."""

from __future__ import annotations

import numpy as np
import pytest
from enclosures import ALL, BOX, enclosure, fill
from gases import collect
from stepped_gases import stepped
from stepped_hall_twin import SteppedHallTwin

from gasbox.geometry import Circle, Segment

PLACES = ALL | {
    "leaking": enclosure(BOX, (Segment((8.0, 0.0), (8.0, 9.0)),), (0.0, -0.2), right={"open": True}),
    "drain": enclosure(Circle(8.0), (Segment((6.0, 6.0), (9.0, 8.0)),), o0={"open": True}),
}


@pytest.mark.parametrize(("speed", "time_step"), [(1.0, 0.05), (25.0, 0.03)])
@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
def test_equals_the_slow_twin_to_the_bit(place, speed, time_step):
    """All pairs, then all elements and images for every disc: the same gas, slow and as fast as a radius a step."""
    state = fill(place, 14)
    state.velocity *= speed
    twin = SteppedHallTwin(state.copy(), place, time_step, 5)
    engine = stepped(state, place, contacts=3, time_step=time_step)
    collect(engine, state, 300 * time_step)
    twin.run(300)
    tallies = engine.tallies
    assert tallies.wall_collisions.sum() + tallies.wall_passed.sum() >= 3
    assert np.array_equal(state.id, twin.state.id)
    assert np.array_equal(state.position, twin.state.position)
    assert np.array_equal(state.velocity, twin.state.velocity)
