"""Ten million collisions at each corner of the table of rates: nobody overlaps, nobody is outside, energy is exact."""

from __future__ import annotations

import math

import numpy as np
import pytest
from gases import collisions
from scipy.spatial import cKDTree

from gasbox import Simulation
from gasbox.observe import kinetic_energy
from gasbox.scenario import parse


def gas(count: int, eta: float, periodic: bool) -> Simulation:
    side = math.sqrt(count * math.pi / 4 / eta)
    box = {"shape": "rectangle", "width": side, "height": side, "periodic": ["x", "y"] if periodic else []}
    discs = {"name": "discs", "radius": 0.5, "count": count, "temperature": 1}
    kind = {"kind": "event-driven"}
    return Simulation(parse({"seed": 5, "container": box, "species": [discs], "dynamics": kind}))


@pytest.mark.validate
@pytest.mark.parametrize("eta", [0.05, 0.6])
@pytest.mark.parametrize(("count", "periodic"), [(1000, True), (1000, False), (1_000_000, True)])
def test_ten_million_collisions(count, eta, periodic):
    simulation = gas(count, eta, periodic)
    begin = kinetic_energy(simulation.state)
    rate = 2 * count * math.sqrt(math.pi) * count / simulation.geometry.area / 2
    while collisions(simulation.dynamics) < 10_000_000:
        simulation.advance(until=simulation.time + 1_000_000 / rate)
    state, geometry = simulation.state, simulation.geometry
    tree = cKDTree(state.position, boxsize=geometry.size if periodic else None)
    assert not tree.query_pairs(1.0 - 1e-9)
    assert tree.query_pairs(1.0 + 0.1)
    assert np.all(geometry.holds(state.position, 0.0 if periodic else 0.5 * (1 - 1e-9)))
    assert kinetic_energy(state) == pytest.approx(begin, rel=1e-12)
