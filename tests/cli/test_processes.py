from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from command import environment, gasbox, start

import gasbox as package
from gasbox.recording import open_recording

HEAVY = ("numba", "h5py", "matplotlib", "nicegui", "scipy", "rich.progress")


def recording_run(
    path: Path, *arguments: str, growths: int = 1, pause: float = 0.05
) -> subprocess.Popen[str]:
    """A run without end whose recording was seen to grow so many times, with a pause [s] between two looks."""
    running = start("run", "one-gas", "--until", "inf", "--record", path, *arguments)
    deadline = time.monotonic() + 120
    size, grown = 0, 0
    while grown < growths:
        assert running.poll() is None, running.communicate()
        assert time.monotonic() < deadline
        time.sleep(pause)
        now = path.stat().st_size if path.exists() else 0
        size, grown = now, grown + (now > size)
    return running


@pytest.mark.parametrize("frame", ["1e9", "1"])
def test_a_run_without_end_can_be_stopped_in_the_middle_of_a_frame(tmp_path: Path, frame: str) -> None:
    running = recording_run(tmp_path / "a.h5", "--frame", frame, "--json")
    time.sleep(2)
    running.send_signal(signal.SIGINT)
    out, err = running.communicate(timeout=30)
    assert running.returncode == 130, err
    summary = json.loads(out)
    assert summary["time"] > 0
    assert (summary["frames"] == 0) == (frame == "1e9")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_runs_end_cleanly(tmp_path: Path, command: Any, number: signal.Signals) -> None:
    path = tmp_path / "a.h5"
    running = recording_run(path, "--json", "--snapshot", str(tmp_path / "s.json"))
    running.send_signal(number)
    out, err = running.communicate(timeout=60)
    assert running.returncode == 130, err
    summary = json.loads(out)
    assert summary["interrupted"]
    assert "Interrupted at time" in err
    assert "Traceback" not in err
    with open_recording(path) as recording:
        assert recording.frames == summary["recorded_frames"] == summary["frames"] + 1
        # It may have been stopped on the way to the next frame.
        assert (
            recording.times[-1] <= summary["time"] < recording.times[-1] + recording.scenario.frame_interval
        )
    assert command("resume", tmp_path / "s.json", "--frames", 1).status == 0


def test_a_killed_run_can_be_plotted_and_resumed(tmp_path: Path, command: Any) -> None:
    path = tmp_path / "a.h5"
    # Longer than a second apart, so that there was a flush of more than the first frame.
    running = recording_run(path, growths=3, pause=1.2)
    running.kill()
    running.communicate(timeout=60)
    with open_recording(path) as recording:
        assert recording.frames > 1
    assert command("plot", path, "-o", tmp_path / "a.png").status == 0
    assert command("resume", path, "--frames", 1).status == 0


def test_json_is_all_that_stands_on_standard_output() -> None:
    done = gasbox("run", "two-discs", "--frames", 3, "--json")
    assert done.returncode == 0
    assert json.loads(done.stdout)["frames"] == 3


def test_errors_are_sentences_and_status_2(tmp_path: Path) -> None:
    done = gasbox("run", "nothing.json", "--frames", 1, folder=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("Error: there is no file")


def test_the_installed_command_is_the_same() -> None:
    script = Path(sys.executable).parent / "gasbox"
    done = subprocess.run([script, "--version"], capture_output=True, text=True, check=True)
    assert done.stdout == gasbox("--version").stdout == f"gasbox {package.__version__}\n"


@pytest.mark.parametrize("arguments", [["--help"], ["run", "--help"], ["schema"], ["check", "three-gases"]])
def test_what_needs_no_engine_loads_none(arguments: list[str]) -> None:
    code = (
        "import atexit, sys\n"
        f"atexit.register(lambda: print([name for name in {HEAVY!r} if name in sys.modules], file=sys.stderr))\n"
        f"from gasbox.cli import main\nmain({arguments!r})"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env=environment(), check=False
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr.strip() == "[]"


def test_a_reader_that_goes_away_is_no_accident() -> None:
    done = subprocess.run(
        f"'{sys.executable}' -m gasbox schema | head -n 1",
        shell=True,
        capture_output=True,
        text=True,
        env=environment(),
        check=False,
    )
    assert done.stdout == "{\n"
    assert "Traceback" not in done.stderr
