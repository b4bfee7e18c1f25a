"""A gas that flies as a whole, under baths that rescale its velocities."""

from __future__ import annotations

import numpy as np
import pytest
from forced_gases import apart, rectangle, scattered, scenario

from gasbox import Simulation

BATHS = {
    "rescaling": {"thermostat": {"kind": "velocity-rescaling", "temperature": 0.5, "time": 0.1}},
    "heating": {"heating": {"power": 0.5}},
}


@pytest.mark.small
@pytest.mark.parametrize("baths", BATHS.values(), ids=BATHS.keys())
def test_baths_leave_a_common_velocity_alone(baths):
    """It is no heat: the gas does the same with it, and the run goes on as long."""
    position, velocity = scattered(1, 5.0, 5.0, 5)
    common, ends = np.array([2.0, -1.0]), []
    for extra in (0.0, 1.0):
        simulation = Simulation(scenario(rectangle(5, 5), position, velocity + extra * common, **baths))
        simulation.advance(until=1.5)
        assert simulation.state.velocity.mean(axis=0) == pytest.approx(extra * common, abs=1e-12)
        ends.append(simulation.state.position - extra * 1.5 * common)
    assert apart(*ends, simulation.geometry) < 1e-8
