"""How much memory the engines take beside the state."""

from __future__ import annotations

import numpy as np
import pytest
from gases import event_driven, state_of, stepped

from gasbox.geometry import Rectangle


def arrays(thing, found):
    """All arrays held by an object, each piece of memory once."""
    if isinstance(thing, np.ndarray):
        while isinstance(thing.base, np.ndarray):
            thing = thing.base
        found[id(thing)] = thing
    elif isinstance(thing, tuple | list):
        for part in thing:
            arrays(part, found)
    elif isinstance(thing, dict):
        arrays(list(thing.values()), found)
    elif type(thing).__module__.startswith("gasbox"):
        arrays(list(vars(thing).values()), found)
    return found


@pytest.mark.parametrize("make", [stepped, event_driven], ids=["stepped", "event-driven"])
@pytest.mark.parametrize("eta", [0.05, 0.6])
@pytest.mark.parametrize("n", [90_000, 160_000])
def test_at_most_250_bytes_a_particle(make, eta, n):
    side = round(n**0.5)
    length = (n * np.pi / 4 / eta) ** 0.5
    at = (np.arange(side) + 0.5) * length / side
    position = np.stack(np.meshgrid(at, at), axis=-1).reshape(-1, 2)
    velocity = np.random.default_rng(1).normal(size=position.shape)
    state = state_of(position, velocity, 0.5)
    dynamics = make(state, Rectangle(length, length, True, True))
    dynamics.advance(state, 0.01)
    own = arrays(dynamics, {})
    beside = [a for a in own.values() if all(a is not b for b in arrays(vars(state), {}).values())]
    assert 50 * n < sum(a.nbytes for a in beside) < 250 * n
