"""Writes a recording: frame by frame into an H5MD file that a killed run leaves readable."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any, Final

import h5py
import numpy as np
from numpy.typing import ArrayLike

from gasbox.recording import places
from gasbox.recording.atoms import atoms, has_atoms, write_bonds
from gasbox.recording.complaints import refuse_foreign, refuse_full_disk, writing
from gasbox.recording.elements import Elements
from gasbox.recording.header import may_grow, write_header
from gasbox.scenario import Scenario, ScheduledChange
from gasbox.state import FIELDS, ROTATION, Change, Frame, State
from gasbox.units import UNIT

__all__ = ["Recorder"]

_WAITING_BYTES: Final = 2**26
_UNITS: Final = {
    **{f"{places.PARTICLES}/{field.name}": field.unit for field in (*FIELDS, *ROTATION)},
    **{f"{places.ATOMS}/{field.name}": field.unit for field in FIELDS},
    f"{places.WALLS}/displacement": UNIT["position"],
    f"{places.WALLS}/velocity": UNIT["velocity"],
    **{f"{places.FORCES}/{name}": UNIT["energy"] for name in places.FORCE_FIELDS},
    places.EDGES: UNIT["position"],
}
_FILLS: Final[dict[str, float]] = {
    f"{places.PARTICLES}/id": places.NO_PARTICLE,
    f"{places.ATOMS}/molecule": places.NO_PARTICLE,
    **{f"{places.WALLS}/{name}": math.nan for name in places.WALL_FIELDS},
}
_OPTIONAL: Final = (f"{places.MEMORY}/", f"{places.LENGTHS}/", f"{places.WALLS}/", f"{places.FORCES}/")
"""What a gas may come to remember only later, as when a wall is first moved."""


class Recorder:
    """Writes frames to an HDF5 file by the H5MD convention.

    Frames are buffered, appended and flushed together; what was flushed stays readable whatever happens to
    the program. Use it as a context manager: leaving it, also by an exception, writes what is buffered.

    Parameters
    ----------
    path : file to make; an HDF5 file of that name is replaced, any other is refused
    scenario : what is run
    flush_seconds : longest time between two flushes [s], as long as frames come; the first frame is flushed at once
    flush_frames : most frames that are buffered

    Raises
    ------
    FileError
        The file cannot be made or written; from every method.
    """

    def __init__(
        self, path: str | Path, scenario: Scenario, *, flush_seconds: float = 1.0, flush_frames: int = 1000
    ) -> None:
        self.path = Path(path)
        self.frames = 0
        """Frames taken so far."""
        self._flush_seconds = flush_seconds
        self._flush_frames = flush_frames
        self._flushed_at = -math.inf
        self._failed = False
        self._scenario = scenario
        self._box = scenario.geometry() if may_grow(scenario) else None
        self._last_number = -1
        self._roster: State | None = None
        with writing(self.path):
            refuse_foreign(self.path)
            # Neither SWMR nor the newest file format: both mark the file as open, and after a kill plain
            # readers would refuse it.
            self._file = h5py.File(self.path, "w", libver=("v108", "v108"), locking="best-effort")
            write_header(self._file, scenario)
            self._file.flush()
        self._rosters = Elements(self._file)
        self._samples = Elements(self._file, _OPTIONAL)
        self._changes: list[str] = []

    def write(
        self,
        frame: Frame,
        observables: Mapping[str, ArrayLike | None] | None = None,
        changes: Sequence[tuple[float, Change]] = (),
    ) -> None:
        """Take a copy of one frame, and of numbers measured at it.

        Parameters
        ----------
        frame : with a higher number than all before
        observables : name -> number or array, None for no value; the same names and shapes in each frame

        changes : of gravity and walls, (time, change) each: all until now, as `Simulation.changes` has them

        Raises
        ------
        ValueError
            The frame does not follow those before, or its arrays do not fit theirs.
        """
        if frame.number <= self._last_number:
            raise ValueError(f"frame {frame.number} does not come after frame {self._last_number}")
        for moment, change in changes[len(self._changes) :]:
            entry = ScheduledChange.of(moment, change)
            self._changes.append(entry.model_dump_json(exclude_none=True))
        with writing(self.path):
            self._take(frame, observables or {})
            if self._is_due():
                self._flush()

    def flush(self) -> None:
        """Bring everything that was taken into the file."""
        with writing(self.path):
            self._flush()

    def close(self) -> None:
        """Bring everything into the file and close it; a second time does nothing."""
        if not self._file:
            return
        with writing(self.path):
            try:
                if not self._failed:
                    self._flush()
            finally:
                self._file.close()

    def __enter__(self) -> Recorder:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _take(self, frame: Frame, observables: Mapping[str, ArrayLike | None]) -> None:
        number, state = frame.number, frame.state
        if self._roster is None or not _is_same_roster(self._roster, state):
            self._roster = state.copy()
            values: dict[str, ArrayLike] = {
                f"{places.PARTICLES}/{name}": getattr(state, name) for name in places.ROSTER
            }
            if has_atoms(state):
                values |= atoms(state)
            self._rosters.append(number, state.time, values, _FILLS, _UNITS)
            if has_atoms(state) and not self.frames:
                write_bonds(self._file, self._scenario, state)
        sample = _sample(frame, observables)
        if self._box is not None:
            sample[places.EDGES] = self._box.at(state.wall_displacement).size
        sample[places.CHANGES_MADE] = np.int64(len(self._changes))
        lengths = {path: -1.0 for path in sample if path.startswith(places.LENGTHS)}
        self._samples.append(number, state.time, sample, {**_FILLS, **lengths}, _UNITS)
        self._last_number = number
        self.frames += 1

    def _is_due(self) -> bool:
        return (
            self._samples.waiting >= self._flush_frames
            or self._samples.waiting_bytes >= _WAITING_BYTES
            or time.monotonic() - self._flushed_at >= self._flush_seconds
        )

    def _flush(self) -> None:
        # What fails half-way may damage the file, and what follows would damage it further.
        self._failed = True
        refuse_full_disk(self.path, self._rosters.waiting_bytes + self._samples.waiting_bytes)
        if self._rosters.waiting:
            # First and apart, so that a run killed meanwhile leaves no frame without its roster.
            self._rosters.write()
            self._file.flush()
        self._write_changes()
        self._samples.write()
        self._file.flush()
        self._flushed_at = time.monotonic()
        self._failed = False

    def _write_changes(self) -> None:
        texts = self._file[places.CHANGES]
        written = texts.shape[0]
        if len(self._changes) > written:
            texts.resize((len(self._changes),))
            texts[written:] = self._changes[written:]


def _is_same_roster(first: State, second: State) -> bool:
    return all(np.array_equal(getattr(first, name), getattr(second, name)) for name in places.ROSTER)


def _sample(frame: Frame, observables: Mapping[str, ArrayLike | None]) -> dict[str, Any]:
    """Path -> value of everything that has a row for each frame."""
    values = {f"{places.PARTICLES}/{name}": getattr(frame.state, name) for name in places.EVERY_FRAME}
    if frame.state.sites is not None:
        values |= {f"{places.PARTICLES}/{name}": getattr(frame.state, name) for name in places.TURNED}
        if has_atoms(frame.state):
            sites = frame.state.sites
            values |= {f"{places.ATOMS}/{name}": getattr(sites, name) for name in places.EVERY_FRAME}
    if frame.state.wall_displacement.size:
        for name, field in places.WALL_FIELDS.items():
            values[f"{places.WALLS}/{name}"] = getattr(frame.state, field)
    if frame.state.potential or frame.state.virial:
        for name in places.FORCE_FIELDS:
            values[f"{places.FORCES}/{name}"] = np.float64(getattr(frame.state, name))
    for name, tally in vars(frame.tallies).items():
        values[f"{places.TALLIES}/{name}"] = tally
    for name, remembered in frame.memory.items():
        values[f"{places.MEMORY}/{name}"] = remembered
        if np.ndim(remembered):
            values[f"{places.LENGTHS}/{name}"] = np.int64(len(remembered))
    values[f"{places.OBSERVABLES}/particles"] = np.int64(frame.state.count)
    for name, value in observables.items():
        values[f"{places.OBSERVABLES}/{name}"] = np.asarray(np.nan if value is None else value, np.float64)
    return values
