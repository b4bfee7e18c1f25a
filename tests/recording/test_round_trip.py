from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest
from made_up import SCENARIO, frame, same_bits

from gasbox.errors import FileError
from gasbox.recording import Recorder, open_recording

pytestmark = pytest.mark.small


@pytest.mark.parametrize("counts", [[3] * 7, [1] * 600, [0, 3, 3, 1, 8, 8, 0], [70_000, 70_001]])
def test_every_bit_comes_back_however_the_number_of_particles_varies(
    tmp_path: Path, counts: list[int]
) -> None:
    frames = [frame(number, count) for number, count in enumerate(counts)]
    with Recorder(tmp_path / "a.h5", SCENARIO, flush_frames=3) as recorder:
        for each in frames:
            recorder.write(each)
    with open_recording(tmp_path / "a.h5") as recording:
        assert recording.frames == len(frames)
        assert recording.times.tolist() == [each.state.time for each in frames]
        for index, each in enumerate(frames):
            assert same_bits(recording.read(index), each)


def test_frames_are_copied_when_written(tmp_path: Path) -> None:
    kept, passing = frame(1, 4), frame(1, 4)
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        # The first is flushed at once, the next waits in memory.
        recorder.write(frame(0, 4))
        recorder.write(passing)
        for array in (
            passing.state.position,
            passing.state.mass,
            passing.memory["time"],
            passing.tallies.wall_impulse,
        ):
            array += 1
    with open_recording(tmp_path / "a.h5") as recording:
        assert same_bits(recording.read(1), kept)


def test_negative_indices_count_from_the_end_and_missing_frames_are_named(tmp_path: Path) -> None:
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        for number in range(0, 30, 10):
            recorder.write(frame(number, 2))
    with open_recording(tmp_path / "a.h5") as recording:
        assert recording.read().number == 20
        assert recording.read(-3).number == 0
        with pytest.raises(FileError, match=r"no frame 3: its 3 frames are 0 to 2"):
            recording.read(3)
        with pytest.raises(FileError, match="no frame -4"):
            recording.scenario_at(-4)


def test_observables_come_back_with_gaps_as_not_a_number(tmp_path: Path) -> None:
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        recorder.write(frame(0, 2), {"energy": 3, "pressure": None, "momentum": np.array([1.0, 2.0])})
        recorder.write(frame(1, 2), {"energy": 0.1, "pressure": 4.0, "momentum": np.array([3.0, 4.0])})
    with open_recording(tmp_path / "a.h5") as recording:
        numbers = recording.observables()
    assert numbers["energy"].tolist() == [3.0, 0.1]
    assert np.isnan(numbers["pressure"][0])
    assert numbers["pressure"][1] == 4.0
    assert numbers["momentum"].tolist() == [[1, 2], [3, 4]]
    assert numbers["particles"].tolist() == [2, 2]


def test_frames_that_do_not_follow_or_fit_are_refused(tmp_path: Path) -> None:
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        recorder.write(frame(5, 2), {"energy": 1.0})
        with pytest.raises(ValueError, match="frame 5 does not come after frame 5"):
            recorder.write(frame(5, 2), {"energy": 1.0})
        with pytest.raises(ValueError, match="observables/energy"):
            recorder.write(frame(6, 2))


def test_the_origin_is_inside(tmp_path: Path) -> None:
    with Recorder(tmp_path / "a.h5", SCENARIO):
        pass
    with open_recording(tmp_path / "a.h5") as recording:
        assert recording.scenario == SCENARIO
        assert recording.frames == 0
        with pytest.raises(FileError, match="holds no frame"):
            recording.read()


def test_a_frame_becomes_a_scenario_that_goes_on(tmp_path: Path) -> None:
    frames = [frame(number, 5) for number in range(4)]
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        for each in frames:
            recorder.write(each)
    with open_recording(tmp_path / "a.h5") as recording:
        scenario = recording.scenario_at(2)
    assert scenario.snapshot is not None
    assert scenario.particles is not None
    assert scenario.snapshot.time == frames[2].state.time
    assert same_bits(scenario.snapshot.memory, frames[2].memory)
    assert scenario.snapshot.tallies == {
        name: sums.tolist() for name, sums in vars(frames[2].tallies).items()
    }
    species, position, velocity = scenario.particles.arrays(["a", "b"])
    for array, name in ((species, "species"), (position, "position"), (velocity, "velocity")):
        assert same_bits(array, getattr(frames[2].state, name))
    assert scenario.model_copy(update={"snapshot": None, "particles": None}) == SCENARIO


def test_the_file_follows_h5md(tmp_path: Path) -> None:
    with Recorder(tmp_path / "a.h5", SCENARIO) as recorder:
        for number, count in enumerate([3, 3, 2]):
            recorder.write(frame(number, count), {"energy": 1.0})
    with h5py.File(tmp_path / "a.h5") as file:
        assert file["h5md"].attrs["version"].tolist() == [1, 1]
        assert file["h5md/author"].attrs["name"]
        assert file["h5md/creator"].attrs["name"] == b"gasbox"
        box = file["particles/all/box"]
        assert box.attrs["dimension"] == 2
        assert box.attrs["boundary"].tolist() == [b"none", b"periodic"]
        assert box["edges"][:].tolist() == [30.5, 20]
        for name in ("position", "velocity"):
            element = file[f"particles/all/{name}"]
            assert element["value"].shape == (3, 3, 2)
            assert element["value"].dtype == np.float64
            assert element["step"][:].tolist() == [0, 1, 2]
            assert element["time"][:].tolist() == [0, 1 / 3, 2 / 3]
        # Whatever is sampled together shares one clock.
        assert file["particles/all/velocity/step"] == file["observables/energy/step"]
        identity = file["particles/all/id/value"]
        assert identity.fillvalue == identity[-1, 2] == -1
        assert file["particles/all/position/value"].attrs["unit"] == "length"
