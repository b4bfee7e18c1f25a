"""Forces, energy, virial and the way of a hundred atoms as LAMMPS has them; which LAMMPS, the file says."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gasbox.scenario import parse
from gasbox.simulation import Simulation

REFERENCE = json.loads((Path(__file__).parent / "lennard_jones_reference.json").read_text("utf-8"))
SIDE = REFERENCE["start"]["side"]


def fluid(truncation: str) -> Simulation:
    """The same atoms at the same start."""
    position, velocity = REFERENCE["start"]["position"], REFERENCE["start"]["velocity"]
    return Simulation(
        parse(
            {
                "container": {"shape": "rectangle", "width": SIDE, "height": SIDE, "periodic": ["x", "y"]},
                "species": [{"name": "atom", "radius": 0.5, "mass": 1}],
                "particles": {
                    "species": ["atom"] * len(position),
                    "position": position,
                    "velocity": velocity,
                },
                "dynamics": {"kind": "forced", "time_step": REFERENCE["time step"]},
                "forces": {"law": "lennard-jones", "cutoff": 2.5, "truncation": truncation},
            }
        ),
        threads=1,
    )


def answers(truncation: str) -> dict[str, Any]:
    found: dict[str, Any] = REFERENCE["answers"][truncation]
    return found


@pytest.mark.parametrize("truncation", ["shifted", "force-shifted"])
def test_forces_energy_and_virial(truncation: str) -> None:
    simulation, wanted = fluid(truncation), answers(truncation)
    forces = simulation.dynamics.forces(simulation.state)
    largest = np.abs(wanted["forces"]).max()
    assert np.abs(forces - wanted["forces"]).max() < 1e-12 * largest
    assert simulation.state.potential == pytest.approx(wanted["potential"], rel=1e-12)
    assert simulation.state.virial == pytest.approx(wanted["virial"], rel=1e-12)


@pytest.mark.parametrize("truncation", ["shifted", "force-shifted"])
def test_the_same_way(truncation: str) -> None:
    simulation = fluid(truncation)
    # Rounding grows with the chaos of the fluid, some e-fold in a unit of time: 1e-9 leaves three powers of ten.
    for steps, tolerance in ((1, 1e-13), (10, 1e-12), (100, 1e-9)):
        simulation.advance(until=steps * REFERENCE["time step"])
        wanted = answers(truncation)[f"after {steps} steps"]
        apart = simulation.state.position - wanted["position"]
        apart -= SIDE * np.rint(apart / SIDE)
        assert np.abs(apart).max() < tolerance
        assert simulation.state.potential == pytest.approx(wanted["potential"], rel=10 * tolerance)
        assert simulation.energy() == pytest.approx(wanted["kinetic"], rel=10 * tolerance)
