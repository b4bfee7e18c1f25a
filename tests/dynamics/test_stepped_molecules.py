"""Molecules under the stepped rule: against a slow twin, the laws of each collision, and the same bits."""

from __future__ import annotations

import numpy as np
import pytest
from stepped_molecules import (
    PERIODIC,
    PLACES,
    molecules,
    parts_of,
    run,
)
from stepped_molecules_twin import MoleculesTwin


@pytest.mark.parametrize("place", PLACES.values(), ids=PLACES.keys())
def test_equals_the_slow_twin(place):
    """Until rounding has grown: the twin writes some sums differently."""
    parts = parts_of(molecules(place))
    twin = MoleculesTwin(parts.state.copy(), parts.geometry, 0.02)
    run(parts, 3.0)
    twin.run(150)
    tallies = parts.dynamics.tallies
    assert tallies.pair_collisions.sum() > 25
    assert "container" not in place or tallies.wall_collisions.sum() > 10 or place is PERIODIC
    assert twin.sweeps >= 1
    for name in ("position", "velocity", "angle", "angular_velocity"):
        assert np.allclose(getattr(parts.state, name), getattr(twin.state, name), rtol=0, atol=1e-9), name
    assert np.allclose(parts.state.sites.position, twin.state.sites.position, rtol=0, atol=1e-9)
    assert np.allclose(parts.state.sites.velocity, twin.state.sites.velocity, rtol=0, atol=1e-9)
