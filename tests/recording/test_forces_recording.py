"""A gas with forces in a recording: its potential energy, its box that grows, heats and works."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest
from made_up import frame, same_bits

from gasbox.geometry import Rectangle
from gasbox.recording import Measurements, Recorder, open_recording
from gasbox.scenario import Scenario, parse
from gasbox.state import Change, Frame, SetBarostat, SetGravity, SetHeating

pytestmark = pytest.mark.small

SCENARIO: Scenario = parse(
    {
        "container": {"shape": "rectangle", "width": 30, "height": 20, "periodic": ["x", "y"]},
        "species": [
            {"name": "a", "radius": 0.1, "count": 3, "temperature": 1},
            {"name": "b", "mass": 0.1, "radius": 0.2},
        ],
        "dynamics": {"kind": "forced"},
        "barostat": {"pressure": 0.02},
    }
)


def with_forces(number: int) -> Frame:
    """A frame with energies and with a box that has grown."""
    made = frame(number, 4)
    made.state.potential, made.state.virial = -1.5 / (number + 1), 0.1 * number
    if number:
        made.state.wall_displacement = np.array([0.0, 3.0 * number, 0.0, 2.0 * number])
        made.state.wall_velocity = np.zeros(4)
    return made


def test_energies_of_forces_come_back_to_the_bit(tmp_path: Path) -> None:
    frames = [with_forces(number) for number in range(3)]
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        for each in frames:
            recorder.write(each)
    with open_recording(tmp_path / "a.h5") as recording:
        for index, each in enumerate(frames):
            assert same_bits(recording.read(index), each)


def test_forces_that_come_later(tmp_path: Path) -> None:
    frames = [frame(0, 4), with_forces(1), frame(2, 4)]
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        for each in frames:
            recorder.write(each)
    with open_recording(tmp_path / "a.h5") as recording:
        assert [recording.read(index).state.potential for index in range(3)] == [0.0, -0.75, 0.0]


def test_the_box_follows_the_barostat_by_the_rules_of_h5md(tmp_path: Path) -> None:
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        for number in range(3):
            recorder.write(with_forces(number))
    with h5py.File(tmp_path / "a.h5") as file:
        box = file["particles/all/box"]
        assert box["edges/value"][:].tolist() == [[30, 20], [33, 22], [36, 24]]
        assert box["edges/step"] == file["particles/all/position/step"]
        assert box.attrs["boundary"].tolist() == [b"periodic", b"periodic"]


def test_what_is_measured_under_forces() -> None:
    measurements = Measurements(SCENARIO)
    made = with_forces(2)
    made.state.velocity[:] = 1.0
    made.tallies.heater_heat[0] = 7.0
    numbers = measurements.of(made)
    assert numbers["potential_energy"] == -0.5
    assert numbers["virial"] == 0.2
    assert numbers["area"] == 36.0 * 24.0
    assert numbers["heater_heat"] == 7.0
    assert {"thermostat_heat", "barostat_work"} < numbers.keys()


def test_heat_and_pressure_are_no_part_of_the_geometry(tmp_path: Path) -> None:
    changes: list[tuple[float, Change]] = [(0.1, SetHeating(0.5)), (0.2, SetBarostat(0.03, 5.0))]
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        recorder.write(with_forces(0))
        recorder.write(with_forces(1), {}, changes)
        recorder.write(with_forces(2), {}, [*changes, (0.5, SetGravity((0.0, 0.0)))])
    with open_recording(tmp_path / "a.h5") as recording:
        assert recording.changes[:2] == changes
        assert recording.geometry_at(1) == Rectangle(30.0, 20.0, True, True)
