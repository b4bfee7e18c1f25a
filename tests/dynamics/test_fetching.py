"""Fetching ahead of time what coming events will touch, as in a very large gas."""

from __future__ import annotations

import pytest
from gases import event_driven, random_gas

from gasbox.geometry import Rectangle
from gasbox.kernels.event_driven.tables import FETCHES

RADII = [1.2, 0.9] + [0.4] * 40 + [0.15] * 60


@pytest.mark.parametrize(
    "geometry", [Rectangle(16, 12), Rectangle(16, 12, True, True)], ids=["walled", "periodic"]
)
def test_fetching_ahead_changes_no_bit(geometry):
    found = set()
    for fetches in (0, 1):
        state = random_gas(7, geometry, RADII)
        dynamics = event_driven(state, geometry)
        dynamics._tables.counter[FETCHES] = fetches
        dynamics.advance(state, 10.0)
        assert dynamics.tallies.pair_collisions.sum() > 200
        found.add((state.position.tobytes(), state.velocity.tobytes()))
    assert len(found) == 1
