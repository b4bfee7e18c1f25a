"""Water-like molecules with screened charges: hydrogen finds oxygen across molecules."""

from __future__ import annotations

import math

import numpy as np

from gasbox import Simulation
from gasbox.scenario import parse

HALF = math.radians(104.48 / 2)
X, Y = 0.9584 * math.sin(HALF), 0.9584 * math.cos(HALF)
CHARGES = {"charges": {"strength": 800.0, "screening_length": 3.0, "cutoff": 10.0}}
"""As the documentation says: lengths in ångström, energies in units of the attraction of two oxygens."""


def water(count, side, temperature, charged=True):
    """Molecules of water in a square."""
    oxygen = {"name": "oxygen", "mass": 16.0, "radius": 1.52, "sigma": 3.17}
    hydrogen = {"name": "hydrogen", "mass": 1.0, "radius": 1.1, "epsilon": 0.0}
    if charged:
        oxygen["charge"], hydrogen["charge"] = -0.82, 0.41
    atoms = [
        {"species": "oxygen", "position": [0, 0]},
        {"species": "hydrogen", "position": [-X, -Y]},
        {"species": "hydrogen", "position": [X, -Y]},
    ]
    return parse(
        {
            "seed": 1,
            "container": {"width": side, "height": side, "periodic": ["x", "y"]},
            "species": [oxygen, hydrogen],
            "molecules": [{"name": "water", "atoms": atoms, "count": count, "temperature": temperature}],
            "forces": CHARGES if charged else {},
            "thermostat": {"kind": "langevin", "temperature": temperature, "time": 2.0},
            "dynamics": {"kind": "forced", "time_step": 0.005},
        }
    )


def bonded(simulation, reach=2.6):
    """Share of the hydrogens that an oxygen of another molecule is near to."""
    sites, size = simulation.state.sites, simulation.geometry.size
    oxygen = sites.species == 0
    gap = sites.position[~oxygen][:, None] - sites.position[oxygen]
    gap -= np.rint(gap / size) * size
    other = sites.owner[~oxygen][:, None] != sites.owner[oxygen]
    return float(np.any((np.hypot(gap[..., 0], gap[..., 1]) < reach) & other, axis=1).mean())


def mean_share(**more):
    simulation = Simulation(water(50, 36.0, **more))
    simulation.advance(until=15.0)
    found = []
    for _ in range(12):
        simulation.advance(until=simulation.time + 1.0)
        found.append(bonded(simulation))
    return float(np.mean(found))


def test_hydrogen_bonds():
    """Far more than where only the discs attract each other, and fewer in the heat."""
    cold, hot, control = (
        mean_share(temperature=2.0),
        mean_share(temperature=12.0),
        mean_share(temperature=2.0, charged=False),
    )
    assert cold > 1.8 * control
    assert cold > 1.25 * hot
    assert cold > 0.22
