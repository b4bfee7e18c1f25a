"""How molecules under forces start: moved apart where they overlap, told of long steps, and remembered rightly."""

from __future__ import annotations

import json

import numpy as np
import pytest
from forced_gases import rectangle
from forced_molecules import ATOM, DUMBBELL, HEAVY, TRIMER, gas

from gasbox import Simulation, load
from gasbox.errors import ScenarioError
from gasbox.scenario import parse


def listed(molecule, position, angle, container=None, **more):
    """Molecules at these places."""
    particles = {
        "species": [molecule["name"]] * len(position),
        "position": position,
        "velocity": [[0, 0]] * len(position),
        "angle": angle,
    }
    return parse(
        {
            "container": container or rectangle(12, 12),
            "species": [ATOM, HEAVY],
            "molecules": [molecule],
            "particles": particles,
            "dynamics": {"kind": "forced", "time_step": 0.001},
            **more,
        }
    )


def shape(simulation, row):
    """Distances of all discs of a molecule."""
    sites = simulation.state.sites
    place = sites.position[sites.first[row] : sites.first[row + 1]]
    return np.hypot(*(place[:, None] - place[None]).transpose(2, 0, 1))


@pytest.mark.parametrize("molecule", [DUMBBELL, TRIMER], ids=["rigid", "flexible"])
def test_molecules_that_overlap_are_moved_apart(molecule):
    place = [[5.0, 5.0], [5.2, 5.1], [5.0, 5.0], [11.9, 0.1], [0.0, 0.0]]
    simulation = Simulation(listed(molecule, place, [0.0, 1.3, 0.0, 0.2, 2.0]))
    assert "moved apart" in simulation.warnings[0]
    assert simulation.state.potential < 500.0
    alone = Simulation(listed(molecule, [[5.0, 5.0]], [0.0]))
    for row in range(5):
        assert np.abs(shape(simulation, row) - shape(alone, 0)).max() < 1e-12
    simulation.advance(until=0.5)
    assert np.isfinite(simulation.state.potential)


def test_molecules_that_overlap_stay_within_walls():
    box, forces = rectangle(6, 6, []), {"walls": "repulsive"}
    place = [[1.0, 1.0], [1.1, 1.0], [5.0, 5.1], [5.0, 5.0]]
    simulation = Simulation(listed(DUMBBELL, place, [0.0, 0.1, 0.0, 1.5], box, forces=forces))
    sites = simulation.state.sites
    assert simulation.warnings
    assert (sites.position >= 0.5).all()
    assert (sites.position <= 5.5).all()


def test_a_step_that_is_long_for_bonds_is_named():
    """With springs of k between masses of 1 the frequency is sqrt(2k)."""
    stiff = {**DUMBBELL, "bonds": [{"atoms": [0, 1], "stiffness": 2e4}]}
    assert Simulation(gas([10], molecules=[{**stiff}], time_step=0.0009)).warnings == ()
    (warning,) = Simulation(gas([10], molecules=[stiff], time_step=0.0011)).warnings
    assert "time_step" in warning
    assert "is long" in warning


def test_a_step_that_is_too_long_stops_molecules():
    """A bond is unstable beyond a step of 2 over its frequency."""
    from gasbox.errors import DynamicsError

    stiff = {**DUMBBELL, "bonds": [{"atoms": [0, 1], "stiffness": 1e5, "length": 0.61}]}
    simulation = Simulation(gas([10], molecules=[stiff], time_step=0.005))
    with pytest.raises(DynamicsError, match="too long"):
        simulation.advance(until=1.0)


@pytest.mark.small
@pytest.mark.parametrize("name", ["built", "site_position", "site_velocity", "site_shift", "position"])
def test_a_snapshot_without_its_discs_is_refused(name, tmp_path):
    simulation = Simulation(gas([4], width=8.0, height=8.0, atoms=2))
    simulation.save(tmp_path / "snapshot.json")
    data = json.loads((tmp_path / "snapshot.json").read_text())
    memory = data["snapshot"]["memory"]
    memory[name] = memory[name][:-1]
    (tmp_path / "snapshot.json").write_text(json.dumps(data))
    with pytest.raises(ScenarioError, match=f"snapshot.memory.{name}"):
        load(tmp_path / "snapshot.json")
    del memory[name]
    (tmp_path / "snapshot.json").write_text(json.dumps(data))
    with pytest.raises(ScenarioError, match="is required"):
        load(tmp_path / "snapshot.json")
