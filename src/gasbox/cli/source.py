"""Where a run starts: a scenario, a snapshot or a frame of a recording, with the changes asked for."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from gasbox.errors import FileError, UsageError
from gasbox.scenario import Scenario, load, with_settings
from gasbox.version import __version__

__all__ = ["Changes", "Source", "from_saved", "from_scenario"]


@dataclass(frozen=True)
class Changes:
    """What the command line changes in a scenario.

    Attributes
    ----------
    settings : texts PATH=VALUE
    seed : another seed
    frame_interval : [time]
    """

    settings: Sequence[str] = ()
    seed: int | None = None
    frame_interval: float | None = None


@dataclass(frozen=True)
class Source:
    """A scenario to run, and the file it came from, which no output may replace by accident."""

    scenario: Scenario
    path: Path


def from_scenario(name: str, changes: Changes) -> Source:
    """A scenario by name or path.

    Raises
    ------
    FileError, ScenarioError, UsageError
        It cannot be read, accepted or changed as asked.
    """
    return Source(_changed(load(name), changes, name), Path(name))


def from_saved(path: Path, at: int, changes: Changes) -> Source:
    """What a snapshot or a recording holds.

    Parameters
    ----------
    at : number of the frame, if it is a recording; negative ones count from the end

    Raises
    ------
    FileError, ScenarioError, UsageError
        It cannot be read, resumed or changed as asked.
    """
    scenario = _recorded(path, at) if _is_recording(path) else _snapshot(path, at)
    assert scenario.snapshot is not None
    if scenario.snapshot.version != __version__:
        print(
            f"Note: {path} was written by gasbox {scenario.snapshot.version}, this is {__version__}: "
            "the same bits are promised within one version only.",
            file=sys.stderr,
        )
    return Source(_changed(scenario, changes, str(path)), path)


def _is_recording(path: Path) -> bool:
    from gasbox.recording import is_hdf5

    try:
        return is_hdf5(path)
    except OSError as error:
        raise FileError(f"cannot read {path}: {error.strerror}") from None


def _recorded(path: Path, at: int) -> Scenario:
    from gasbox.recording import open_recording

    with open_recording(path) as recording:
        return recording.scenario_at(at)


def _snapshot(path: Path, at: int) -> Scenario:
    if at != -1:
        raise UsageError(f"--at chooses a frame of a recording, and {path} is none")
    scenario = load(path)
    if scenario.snapshot is None:
        raise UsageError(
            f"{path} is a scenario, not a snapshot, so there is nothing to resume: use gasbox run {path}"
        )
    return scenario


def _changed(scenario: Scenario, changes: Changes, source: str) -> Scenario:
    settings = {}
    for text in changes.settings:
        path, equals, value = text.partition("=")
        if not (path and equals):
            raise UsageError(f"--set {text}: write PATH=VALUE, as in --set species.0.count=500")
        settings[path] = value
    if changes.seed is not None:
        settings["seed"] = str(changes.seed)
    if changes.frame_interval is not None:
        settings["frame_interval"] = repr(changes.frame_interval)
    return with_settings(scenario, settings, source) if settings else scenario
