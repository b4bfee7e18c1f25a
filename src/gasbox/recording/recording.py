"""Reads a recording: any frame of it, its numbers over time, and a scenario that goes on from it."""

from __future__ import annotations

from pathlib import Path
from types import TracebackType
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from gasbox.errors import FileError, ScenarioError
from gasbox.geometry import Geometry
from gasbox.recording import places
from gasbox.recording.complaints import is_hdf5, reading
from gasbox.scenario import Particles, Scenario, ScheduledChange, parse, sites_of
from gasbox.state import Change, Frame, MoveWall, SetGravity, SetWall, State, Tallies
from gasbox.worlds import Replies

__all__ = ["Recording", "open_recording"]


def open_recording(path: str | Path) -> Recording:
    """The recording in the file `path`; close it, or use it as a context manager.

    Raises
    ------
    FileError
        There is no such file, it is no recording of gasbox, it is damaged, or another program is writing it.
    """
    return Recording(Path(path))


class Recording:
    """An open recording.

    Attributes
    ----------
    path : the file
    scenario : what was run
    version : version of gasbox that wrote it
    frames : number of complete frames
    numbers : (frames,) int64, number of each frame since the start of its run
    times : (frames,) float64 [time]
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        with reading(path):
            if not is_hdf5(path):
                raise FileError(f"{path} is not a recording: it is not an HDF5 file")
            self._file = h5py.File(path, "r", locking="best-effort")
        try:
            with reading(path):
                self._read_header()
        except BaseException:
            self._file.close()
            raise

    def read(self, index: int = -1) -> Frame:
        """One frame, with arrays of its own; negative indices count from the end.

        Raises
        ------
        FileError
            There is no such frame, or it cannot be read.
        """
        row = self._row(index)
        with reading(self.path):
            number, time = int(self.numbers[row]), float(self.times[row])
            tallies = self._tallies(row)
            return Frame(number, self._state(row, number, time), tallies, self._memory(row))

    def observables(self) -> dict[str, NDArray[np.float64]]:
        """Name -> (frames, ...) float64: the numbers measured at each frame; NaN where there was no value."""
        with reading(self.path):
            elements = self._file.get(places.OBSERVABLES, {}).items()
            return {name: element["value"][: self.frames].astype(np.float64) for name, element in elements}

    def scenario_at(self, index: int = -1) -> Scenario:
        """A scenario with a `snapshot`, to go on from a frame with the same bits as if nothing had stopped.

        Raises
        ------
        FileError
            There is no such frame, or it cannot be read.
        """
        frame = self.read(index)
        state = frame.state
        with reading(self.path):
            names = [kind.name for kind in self.scenario.kinds]
            species = [names[number] for number in state.species]
            tallies = {name: sums.tolist() for name, sums in vars(frame.tallies).items()}
            turned = {} if state.sites is None else {name: getattr(state, name) for name in places.TURNED}
            memory: dict[str, Any] = {"memory": frame.memory, "tallies": tallies}
            if not np.array_equal(state.id, np.arange(state.count)):
                # Some have left; the others keep their numbers.
                memory["ids"] = state.id.tolist()
            made = self._changes_until(self._row(index))
            if made:
                memory["changes"] = [
                    ScheduledChange.of(*each).model_dump(mode="json", exclude_none=True) for each in made
                ]
            return parse(
                {
                    **self.scenario.model_copy(update={"particles": None, "snapshot": None}).to_dict(),
                    "particles": Particles.of(species, state.position, state.velocity, **turned),
                    "snapshot": {"version": self.version, "time": state.time, **memory},
                },
                source=f"frame {index} of {self.path}",
            )

    @property
    def changes(self) -> list[tuple[float, Change]]:
        """Changes of gravity and walls made while the gas ran, (time, change) each, in the order of time."""
        with reading(self.path):
            texts = [text.decode() for text in self._file[places.CHANGES][:]]
        entries = [ScheduledChange.model_validate_json(text) for text in texts]
        return [(entry.at, entry.change()) for entry in entries]

    def geometry_at(self, index: int = -1) -> Geometry:
        """What the gas was in at a frame, after all changes until then, its moving walls not displaced.

        Raises
        ------
        FileError
            There is no such frame, or it cannot be read.
        """
        row = self._row(index)
        time, changes = float(self.times[row]), self._changes_until(row)
        # What a schedule did stands among the changes as well; twice is once.
        planned = [(entry.at, entry.change()) for entry in self.scenario.schedule if entry.at <= time]
        start = geometry = self.scenario.geometry()
        replies = Replies.recalled(self._memory(row), start.wall_names).entries()
        for moment, change in sorted([*planned, *changes, *replies], key=lambda entry: entry[0]):
            if not isinstance(change, SetGravity | SetWall | MoveWall):
                # Baths and settings of a world are no part of what a gas is in.
                continue
            # Here, because it loads the kernels, which most readers do without.
            from gasbox.dynamics import altered

            geometry = altered(geometry, moment, change, start)
        return geometry

    def _changes_until(self, row: int) -> list[tuple[float, Change]]:
        made = self._file.get(places.CHANGES_MADE)
        return self.changes[: int(made["value"][row])] if made is not None else []

    def close(self) -> None:
        """Close the file."""
        self._file.close()

    def __enter__(self) -> Recording:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def _read_header(self) -> None:
        own = self._file.get(places.OWN)
        found = "" if own is None else own.attrs.get("format", "")
        if found != places.FORMAT:
            what = f"its format is {found!r}" if found else "it is HDF5 of another kind"
            raise FileError(
                f"{self.path} is no recording that this version reads: {what}, not {places.FORMAT!r}"
            )
        self.version = str(own.attrs["version"])
        try:
            self.scenario = parse(own["scenario"][()], f"the scenario in {self.path}")
        except ScenarioError as error:
            raise FileError(str(error)) from None
        elements = self._elements()
        # A kill in the middle of a flush can leave some elements longer than others.
        self.frames: int = min((len(dataset) for group in elements for dataset in group.values()), default=0)
        self.numbers = np.array(elements[0]["step"][: self.frames] if elements else [], np.int64)
        self.times = np.array(elements[0]["time"][: self.frames] if elements else [], np.float64)

    def _elements(self) -> list[h5py.Group]:
        """All elements that have a row for each frame."""
        particles = self._file[places.PARTICLES]
        every = (*places.EVERY_FRAME, *places.TURNED)
        found = [particles[name] for name in every if name in particles]
        discs = self._file.get(places.ATOMS, {})
        found += [discs[name] for name in places.EVERY_FRAME if name in discs]
        found += [self._file[places.CHANGES_MADE]] if places.CHANGES_MADE in self._file else []
        several = (places.TALLIES, places.MEMORY, places.LENGTHS, places.WALLS, places.FORCES)
        for path in (*several, places.OBSERVABLES):
            found += self._file.get(path, {}).values()
        return found

    def _row(self, index: int) -> int:
        if not self.frames:
            raise FileError(f"{self.path} holds no frame: the run was stopped before the first was written")
        if not -self.frames <= index < self.frames:
            found = (
                f"its {self.frames} frames are 0 to {self.frames - 1}" if self.frames > 1 else "only frame 0"
            )
            raise FileError(f"{self.path} has no frame {index}: {found}")
        return index % self.frames

    def _state(self, row: int, number: int, time: float) -> State:
        group = self._file[places.PARTICLES]
        held = int(np.searchsorted(group["id/step"][:], number, side="right")) - 1
        there = group["id/value"][held] != places.NO_PARTICLE
        roster = {name: group[name]["value"][held][there] for name in places.ROSTER}
        count = int(np.count_nonzero(there))
        vectors = {name: group[name]["value"][row, :count] for name in places.EVERY_FRAME}
        state = State(time=time, **roster, **vectors)
        if self.scenario.molecules:
            self._turn(state, row)
        for name, field in places.WALL_FIELDS.items():
            found = self._values(places.WALLS, row).get(name)
            # Before the first wall has moved there is nothing.
            if found is not None and not np.isnan(found).any():
                setattr(state, field, found)
        for name, found in self._values(places.FORCES, row).items():
            setattr(state, name, float(found))
        return state

    def _turn(self, state: State, row: int) -> None:
        """Give the particles their angles and their discs."""
        group, kinds = self._file[places.PARTICLES], self.scenario.kinds
        for name in places.TURNED:
            setattr(state, name, group[name]["value"][row, : state.count])
        state.inertia = np.array([kind.inertia for kind in kinds])[state.species]
        state.sites = sites_of(self.scenario, state.species)
        state.turn_sites()
        if places.ATOMS in self._file:
            for name in places.EVERY_FRAME:
                setattr(state.sites, name, self._file[places.ATOMS][name]["value"][row, : state.sites.count])

    def _tallies(self, row: int) -> Tallies:
        """Sums that a recording of version 0.1 does not have yet are zero."""
        found = self._values(places.TALLIES, row)
        walls, species = found["wall_impulse"].shape
        return Tallies(**{**vars(Tallies.zero(species, walls)), **found})

    def _values(self, group: str, row: int) -> dict[str, Any]:
        return {name: element["value"][row] for name, element in self._file.get(group, {}).items()}

    def _memory(self, row: int) -> dict[str, Any]:
        """Numbers as Python numbers, arrays without their padding."""
        lengths = self._values(places.LENGTHS, row)
        return {
            name: value[: lengths[name]] if name in lengths else value.item()
            for name, value in self._values(places.MEMORY, row).items()
            if lengths.get(name, 0) >= 0
        }
