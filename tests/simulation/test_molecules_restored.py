"""Molecules in event-driven dynamics, through scenarios and files: resumed to the bit, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import gasbox
from gasbox.errors import ScenarioError
from gasbox.scenario import parse

MOLECULES = [
    {"name": "nitrogen", "model": "nitrogen", "count": 8, "temperature": 1},
    {"name": "water", "model": "water", "count": 8, "temperature": 1},
]


def scenario_of(**more):
    return parse(
        {
            "container": {"width": 30, "height": 30},
            "species": [{"name": "argon", "radius": 1.0, "count": 8, "temperature": 1}],
            "molecules": MOLECULES,
            "dynamics": {"kind": "event-driven"},
            **more,
        }
    )


def bits(simulation):
    state, memory = simulation.state, simulation.dynamics.memory()
    arrays = [state.position, state.velocity, state.angle, state.angular_velocity, state.sites.position]
    tallies = simulation.dynamics.tallies
    arrays += [tallies.pair_virial, tallies.wall_impulse, *(memory[name] for name in sorted(memory))]
    return [np.asarray(entry).tobytes() for entry in arrays]


def test_a_gas_of_molecules_is_restored_to_the_bit(tmp_path):
    gravity = {"gravity": [0, -0.05]}
    whole = gasbox.Simulation(scenario_of(**gravity))
    whole.advance(until=40.0)
    first = gasbox.Simulation(scenario_of(**gravity))
    first.advance(until=15.5)
    first.save(tmp_path / "later.json")
    second = gasbox.Simulation.restore(tmp_path / "later.json")
    second.advance(until=40.0)
    assert bits(second) == bits(whole)
    assert second.dynamics.tallies.pair_collisions.sum() > 20


@pytest.mark.small
def test_molecules_that_overlap_are_refused():
    rows = {
        "species": ["nitrogen", "nitrogen"],
        "position": [[10, 10], [10.5, 10]],
        "velocity": [[0, 0], [0, 0]],
        "angle": [0, 1],
    }
    molecules = [{"name": "nitrogen", "model": "nitrogen"}]
    with pytest.raises(ScenarioError, match="particle 0 and particle 1 overlap by"):
        gasbox.Simulation(scenario_of(species=[], molecules=molecules, particles=rows))


@pytest.mark.small
def test_gates_for_molecules_are_refused():
    def gate(**passes):
        line = {"shape": "segment", "start": [15, 0], "end": [15, 30], "passes": passes}
        return scenario_of(obstacles=[line])

    for passes in ({"direction": "forward"}, {"least_speed": 1}, {"greatest_speed": 2, "species": ["water"]}):
        with pytest.raises(ScenarioError, match="a gate for molecules"):
            gate(**passes)
    gate(species=["argon"], direction="forward")
    gate(species=["water"])
