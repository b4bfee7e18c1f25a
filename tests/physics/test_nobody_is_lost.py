"""Long runs in a star, whose corners point inwards and outwards: nobody gets out, and energy stays."""

from __future__ import annotations

import numpy as np
import pytest
from test_pressure_of_vessels import star
from vessels import gas, kinetic_energy, run, vessel


def hold(gravity, collisions: int) -> None:
    place = vessel(star(), gravity=gravity)
    state = gas(place, [150, 40], [0.3, 0.6], [1.0, 5.0])
    at = run(place, state)

    def energy() -> float:
        return kinetic_energy(state) - float(state.mass @ (state.position @ np.array(gravity)))

    before, scale = energy(), kinetic_energy(state)
    tallies = at.engine.tallies
    while tallies.pair_collisions.sum() + tallies.wall_collisions.sum() < collisions:
        at.advance(200.0)
        assert place.holds(state.position, state.radius * (1 - 1e-9)).all()
    assert abs(energy() - before - tallies.rest_energy[0]) < 1e-11 * scale
    assert state.count == 190


@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.02, -0.15)])
def test_a_star_keeps_everybody(gravity):
    hold(gravity, 300_000)


@pytest.mark.validate
@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.02, -0.15)])
def test_a_star_keeps_everybody_for_ten_million_collisions(gravity):
    hold(gravity, 10_000_000)
