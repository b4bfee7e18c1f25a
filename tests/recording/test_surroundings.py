"""Walls that move, discs that leave, and changes made while the gas ran, in a recording."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import h5py
import numpy as np
import pytest
from made_up import SCENARIO, frame, same_bits

from gasbox.geometry import Enclosure, Rectangle
from gasbox.recording import Measurements, Recorder, open_recording
from gasbox.scenario import Scenario, parse
from gasbox.state import Change, Frame, MoveWall, SetGravity, SetWall

pytestmark = pytest.mark.small

HALL: Scenario = parse(
    {
        "container": {"shape": "rectangle", "width": 30, "height": 20},
        "walls": {"right": {"motion": {"kind": "constant", "speed": -1, "stop": 5}}},
        "obstacles": [{"shape": "segment", "start": [10, 0], "end": [10, 20], "name": "divider"}],
        "gravity": [0, -0.5],
        "species": [{"name": "a", "radius": 0.1, "count": 3, "temperature": 1}, {"name": "b"}],
        "schedule": [{"at": 0.5, "wall": "divider", "present": False}],
    }
)


def at_walls(number: int, count: int, *displacement: float) -> Frame:
    """A frame with its walls displaced."""
    made = frame(number, count)
    made.state.wall_displacement = np.array(displacement)
    made.state.wall_velocity = -np.array(displacement) / 3
    return made


def test_places_of_walls_come_back(tmp_path: Path) -> None:
    frames = [at_walls(number, 4, 0.0, -0.1 * number, 0.0, 0.0) for number in range(4)]
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        for each in frames:
            recorder.write(each)
    with open_recording(tmp_path / "a.h5") as recording:
        for index, each in enumerate(frames):
            assert same_bits(recording.read(index), each)
    with h5py.File(tmp_path / "a.h5") as file:
        element = file["parameters/gasbox/walls/displacement"]
        assert element["value"].attrs["unit"] == "length"
        assert element["step"] == file["particles/all/position/step"]


@pytest.mark.parametrize("flush_frames", [1, 1000])
def test_a_wall_that_begins_to_move_later_and_what_is_remembered_of_it(
    tmp_path: Path, flush_frames: int
) -> None:
    rows = np.arange(32.0).reshape(4, 8)
    frames = [frame(0, 3), frame(1, 3), at_walls(2, 3, 0.0, 1.0, 0.0, 0.0), frame(3, 2)]
    frames[2] = dataclasses.replace(frames[2], memory={**frames[2].memory, "walls": rows})
    with Recorder(tmp_path / "a.h5", SCENARIO, flush_frames=flush_frames) as recorder:
        for each in frames:
            recorder.write(each)
    with open_recording(tmp_path / "a.h5") as recording:
        assert recording.frames == 4
        for index, each in enumerate(frames):
            assert same_bits(recording.read(index), each), index


def test_frames_whose_discs_have_left_keep_their_numbers(tmp_path: Path) -> None:
    frames = [frame(0, 5), frame(1, 3)]
    frames[1].state.id = np.array([0, 3, 4])
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        for each in frames:
            recorder.write(each)
    with open_recording(tmp_path / "a.h5") as recording:
        assert same_bits(recording.read(1), frames[1])


def test_a_recording_of_an_older_version_has_no_work_yet(tmp_path: Path) -> None:
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        recorder.write(frame(0, 2))
    with h5py.File(tmp_path / "a.h5", "a") as file:
        for name in ("wall_work", "wall_heat", "wall_passed", "wall_carried", "rest_energy"):
            del file[f"parameters/gasbox/tallies/{name}"]
    with open_recording(tmp_path / "a.h5") as recording:
        tallies = recording.read(0).tallies
    assert same_bits(tallies.wall_impulse, frame(0, 2).tallies.wall_impulse)
    assert tallies.wall_passed.shape == (4, 2, 2)
    assert not tallies.wall_work.any()


def test_changes_are_kept_once_each(tmp_path: Path) -> None:
    changes: list[tuple[float, Change]] = []
    with Recorder(tmp_path / "a.h5", SCENARIO, flush_frames=1) as recorder:
        recorder.write(frame(0, 2), {}, changes)
        changes.append((0.1, SetGravity((0.0, -2.0))))
        recorder.write(frame(1, 2), {}, changes)
        recorder.write(frame(2, 2), {}, changes)
        changes += [(0.9, SetWall("right", temperature=3.0)), (1.0, MoveWall("right", -3.0, 0.5, 0.25))]
        recorder.write(frame(3, 2), {}, changes)
    with open_recording(tmp_path / "a.h5") as recording:
        assert recording.changes == changes


def test_the_geometry_at_a_frame(tmp_path: Path) -> None:
    changes: list[tuple[float, Change]] = [
        (1.0, SetGravity((0.0, 0.0))),
        (1.0, SetWall("left", temperature=2.0)),
    ]
    with Recorder(tmp_path / "a.h5", HALL) as recorder:
        for number in range(4):
            recorder.write(frame(number, 2), {}, changes if number == 3 else ())
    with open_recording(tmp_path / "a.h5") as recording:
        found = [recording.geometry_at(number) for number in range(4)]
    assert all(isinstance(each, Enclosure) for each in found)
    assert found[0] == HALL.geometry()
    # Times are 0, 1/3, 2/3 and 1.
    assert [each.walls[4].present for each in found] == [True, True, False, False]
    assert [each.gravity[1] for each in found] == [-0.5, -0.5, -0.5, 0.0]
    assert found[3].walls[0].temperature == 2.0


def test_what_is_changed_right_after_a_frame_is_no_part_of_it(tmp_path: Path) -> None:
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        recorder.write(frame(0, 2))
        recorder.write(
            frame(3, 2), {}, [(0.0, SetGravity((-1.0, 0.0))), (0.6, MoveWall("left", 3.0, 0.5, 0.0))]
        )
    with open_recording(tmp_path / "a.h5") as recording:
        assert isinstance(recording.geometry_at(0), Rectangle)
        later = recording.geometry_at(1)
    assert later.gravity == (-1.0, 0.0)
    assert later.moves
    assert later.periodic_y


def test_measurements_of_an_enclosure() -> None:
    measurements = Measurements(HALL)
    tall = [0.0, 0.0, 0.0, 0.0, 0.0]
    first, second = at_walls(0, 2, *tall), at_walls(3, 2, 0.0, -1.0, 0.0, 0.0, 0.0)
    for each in (first, second):
        each.state.position[:] = [[1.0, 4.0], [2.0, 6.0]]
        each.state.velocity[:] = 1.0
        each.state.mass[:] = 1.0
        each.state.radius[:] = 0.1
        for name in vars(each.tallies):
            shape = getattr(each.tallies, name).shape
            wide = (5, *shape[1:]) if name.startswith("wall") else shape
            setattr(each.tallies, name, np.zeros(wide, getattr(each.tallies, name).dtype))
    second.tallies.wall_impulse[1, 0] = 4.0
    second.tallies.wall_impulse[3, 0] = 2.0
    start = measurements.of(first)
    assert start["potential_energy"] == 0.5 * 10
    assert start["area"] == pytest.approx(600)
    assert np.isnan(np.asarray(start["wall_pressure"])).all()
    open_hall = HALL.geometry().with_wall(4, present=False)  # type: ignore[union-attr]
    numbers = measurements.of(second, open_hall)
    pressures = np.asarray(numbers["wall_pressure"])
    assert numbers["area"] == pytest.approx(580)
    assert pressures[1] == pytest.approx(4 / 19.8)
    # The top was 30 wide and then 29.
    assert pressures[3] == pytest.approx(2 / 29.3)
    assert np.isnan(pressures[4])
