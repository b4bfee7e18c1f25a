from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import h5py
import pytest
from made_up import SCENARIO, frame, same_bits

from gasbox.errors import FileError
from gasbox.recording import Recorder, open_recording


def test_what_is_no_recording_is_refused_by_name(tmp_path: Path) -> None:
    path = tmp_path / "x.h5"
    with pytest.raises(FileError, match=r"no file .*x\.h5"):
        open_recording(path)
    for garbage in (b"", b"{}", os.urandom(5000)):
        path.write_bytes(garbage)
        with pytest.raises(FileError, match=r"x\.h5 is not a recording: it is not an HDF5 file"):
            open_recording(path)
    with pytest.raises(FileError, match="folder"):
        open_recording(tmp_path)
    with h5py.File(path, "w") as file:
        file["a"] = 1
    with pytest.raises(FileError, match="HDF5 of another kind"):
        open_recording(path)


def test_another_version_of_the_format_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "x.h5"
    Recorder(path, SCENARIO).close()
    with h5py.File(path, "a") as file:
        file["parameters/gasbox"].attrs["format"] = "gasbox-recording/9"
    with pytest.raises(FileError, match="gasbox-recording/9"):
        open_recording(path)


def test_a_file_cut_short_anywhere_gives_a_sentence(tmp_path: Path) -> None:
    path = tmp_path / "x.h5"
    with Recorder(path, SCENARIO) as recorder:
        for number in range(3):
            recorder.write(frame(number, 50))
    whole = path.read_bytes()
    for length in range(8, len(whole), max(1, len(whole) // 40)):
        path.write_bytes(whole[:length])
        with pytest.raises(FileError, match="damaged or cut short"):
            open_recording(path)


def test_missing_parts_give_a_sentence(tmp_path: Path) -> None:
    path = tmp_path / "x.h5"
    for part in (
        "particles/all/id",
        "particles/all",
        "parameters/gasbox/scenario",
        "parameters/gasbox/tallies",
    ):
        with Recorder(path, SCENARIO) as recorder:
            recorder.write(frame(0, 5))
        with h5py.File(path, "a") as file:
            del file[part]
        with pytest.raises(FileError, match="damaged"), open_recording(path) as recording:
            recording.read()


def test_only_a_recording_is_replaced(tmp_path: Path) -> None:
    path = tmp_path / "scenario.json"
    path.write_text("{}")
    with pytest.raises(FileError, match=r"scenario.json exists and is not a recording"):
        Recorder(path, SCENARIO)
    assert path.read_text() == "{}"
    with pytest.raises(FileError, match="there is no folder"):
        Recorder(tmp_path / "none" / "x.h5", SCENARIO)
    with pytest.raises(FileError, match="it is a folder"):
        Recorder(tmp_path, SCENARIO)
    Recorder(tmp_path / "x.h5", SCENARIO).close()
    Recorder(tmp_path / "x.h5", SCENARIO).close()


def test_a_recording_that_is_being_written_is_said_to_be(tmp_path: Path) -> None:
    path = tmp_path / "x.h5"
    with Recorder(path, SCENARIO):
        code = f"from gasbox.recording import open_recording; open_recording({str(path)!r})"
        other = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert "FileError" in other.stderr
    assert "another program has it open" in other.stderr


WRITER = """
import sys
from made_up import SCENARIO, frame
from gasbox.recording import Recorder
recorder = Recorder(sys.argv[1], SCENARIO, flush_seconds=1e9)
for number in range(10**9):
    recorder.write(frame(number, int(sys.argv[2])))
    if number % 3 == 2:
        recorder.flush()
        print(number + 1, flush=True)
"""


@pytest.mark.parametrize(("count", "delay"), [(2, 0.05), (2, 0.3), (3000, 0.2), (3000, 0.25)])
def test_a_killed_run_leaves_all_that_was_flushed(tmp_path: Path, count: int, delay: float) -> None:
    path = tmp_path / "x.h5"
    writer = subprocess.Popen(
        [sys.executable, "-c", WRITER, str(path), str(count)],
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parent)},
    )
    assert writer.stdout is not None
    writer.stdout.readline()
    time.sleep(delay)
    writer.send_signal(signal.SIGKILL)
    flushed = int(("3\n" + writer.stdout.read()).split()[-1])
    writer.stdout.close()
    writer.wait()
    with open_recording(path) as recording:
        assert recording.frames >= flushed
        for index in range(flushed):
            assert same_bits(recording.read(index), frame(index, count))


def test_a_disk_that_fills_up_costs_no_frame_that_was_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "x.h5"
    recorder = Recorder(path, SCENARIO)
    recorder.write(frame(0, 5))
    monkeypatch.setattr(shutil, "disk_usage", lambda path: SimpleNamespace(free=2**20))
    recorder.write(frame(1, 5))
    with pytest.raises(FileError, match="only 1 MiB are left"):
        recorder.flush()
    recorder.close()
    with open_recording(path) as recording:
        assert recording.frames == 1
        assert same_bits(recording.read(0), frame(0, 5))
