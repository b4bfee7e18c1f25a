"""Gases of molecules come back from a recording with their angles, and flexible ones with every atom."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest
from made_up import same_bits

from gasbox.initial import populate
from gasbox.recording import Recorder, open_recording
from gasbox.scenario import Scenario, parse
from gasbox.simulation import snapshot
from gasbox.state import Frame, State, Tallies

pytestmark = pytest.mark.small

BOX = {"width": 60, "height": 60, "periodic": ["x", "y"]}
DISC = {"name": "disc", "radius": 0.5, "count": 3, "temperature": 1}


def scenario_of(flexible: bool) -> Scenario:
    bonds = [{"atoms": [0, k], **({"stiffness": 50} if flexible else {})} for k in (1, 2)]
    atoms = [
        {"position": [0, 0], "mass": 5},
        {"position": [1, 0.5]},
        {"position": [-1, 0.5], "species": "disc"},
    ]
    bent = {"name": "bent", "atoms": atoms, "bonds": bonds, "count": 4, "temperature": 1}
    dynamics = {"kind": "forced", "time_step": 0.01} if flexible else {"kind": "event-driven"}
    return parse({"container": BOX, "species": [DISC], "molecules": [bent], "dynamics": dynamics})


def frame_of(scenario: Scenario, number: int) -> Frame:
    """Any bits, turned and bent anyhow."""
    random = np.random.default_rng(number)
    state: State = populate(scenario)
    state.time = float(number)
    turns = state.inertia > 0
    state.position = random.uniform(5, 55, (state.count, 2))
    state.angle = np.where(turns, random.normal(size=state.count) * 1e3, 0.0)
    state.angular_velocity = np.where(turns, random.normal(size=state.count), 0.0)
    assert state.sites is not None
    state.turn_sites()
    if state.sites.flexible.any():
        state.sites.position = random.normal(size=(state.sites.count, 2))
        state.sites.velocity = random.normal(size=(state.sites.count, 2))
    memory = {"step": number, "anything": random.normal(size=(number + 1, 3))}
    return Frame(number, state, Tallies.zero(2, 4), memory)


@pytest.mark.parametrize("flexible", [False, True])
def test_every_bit_of_a_molecule_comes_back(tmp_path: Path, flexible: bool) -> None:
    scenario = scenario_of(flexible)
    frames = [frame_of(scenario, number) for number in range(3)]
    with Recorder(tmp_path / "a.h5", scenario) as recorder:
        for frame in frames:
            recorder.write(frame)
    with open_recording(tmp_path / "a.h5") as recording:
        for number, frame in enumerate(frames):
            assert same_bits(recording.read(number), frame)
    with h5py.File(tmp_path / "a.h5") as file:
        assert ("particles/atoms" in file) == flexible


def test_a_frame_goes_on_with_its_angles(tmp_path: Path) -> None:
    scenario = scenario_of(False)
    frame = frame_of(scenario, 1)
    frame.memory.pop("anything")
    with Recorder(tmp_path / "a.h5", scenario) as recorder:
        recorder.write(frame)
    with open_recording(tmp_path / "a.h5") as recording:
        again = recording.scenario_at(0)
    assert same_bits(populate(again), frame.state)
    assert again == snapshot.snapshot(scenario, frame)
    assert same_bits(populate(parse(again.to_json())), frame.state)


def test_atoms_are_as_h5md_wants_them(tmp_path: Path) -> None:
    scenario = scenario_of(True)
    with Recorder(tmp_path / "a.h5", scenario) as recorder:
        for number in range(2):
            recorder.write(frame_of(scenario, number))
    with h5py.File(tmp_path / "a.h5") as file:
        atoms = file["particles/atoms"]
        assert set(atoms) == {"box", "position", "velocity", "species", "mass", "radius", "molecule"}
        assert atoms["box"].attrs["dimension"] == 2
        assert atoms["position/value"].shape == (2, 15, 2)
        assert atoms["position/value"].attrs["unit"] == "length"
        assert atoms["molecule/value"][0].tolist() == [0, 1, 2, *np.repeat([3, 4, 5, 6], 3)]
        assert atoms["species/value"][0].tolist() == [0, 0, 0, *([1, 2, 0] * 4)]
        bonds = file["connectivity/bonds"]
        assert file[bonds.attrs["particles_group"]] == atoms
        assert bonds[:4].tolist() == [[3, 4], [3, 5], [6, 7], [6, 8]]
        assert file["particles/all/angle/value"].attrs["unit"] == "rad"
