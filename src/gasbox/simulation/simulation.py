"""One gas and its clock: the object that the command line, the page, a notebook and the tests all hold."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

from gasbox import observe
from gasbox.build import build
from gasbox.dynamics import altered
from gasbox.errors import UsageError
from gasbox.protocols import Controlled, Observer, Status, World
from gasbox.scenario import Scenario, ScheduledChange, Stepped, Walk, load
from gasbox.simulation import snapshot, summary
from gasbox.simulation.guide import Guide
from gasbox.state import (
    Change,
    Contacts,
    Control,
    Frame,
    MoveWall,
    SetGravity,
    SetWall,
    SetWorld,
    Surrounding,
)

__all__ = ["Simulation"]

_CONTACTS = 1 << 16
"""Room for contacts between two readings, where an observer reads them."""


class Simulation:
    """A gas that can be moved on in time, measured and saved.

    Parameters
    ----------
    scenario : a scenario, or a snapshot to go on from
    observers : what reads the run; whether contacts are written depends on them
    world : rules on top of the gas, in place of those that the scenario names
    threads : how many work together; None takes as many processors as there are, if the dynamics can use them and
        there are many particles. It changes no bit

    Raises
    ------
    UsageError
        Fewer than one thread.
    ScenarioError
        Particles that cannot be placed, or overlap where that is not allowed.
    """

    def __init__(
        self,
        scenario: Scenario,
        observers: Iterable[Observer] = (),
        threads: int | None = None,
        world: World | None = None,
    ) -> None:
        if threads is not None and threads < 1:
            raise UsageError(f"the number of threads is {threads}; there must be at least one")
        parts = build(scenario, threads, world)
        self.scenario = scenario
        self.state = parts.state
        self.geometry = parts.geometry
        self.dynamics = parts.dynamics
        self.frame_interval = parts.frame_interval
        """Simulated time of one frame [time]."""
        self.changes = parts.changes
        """What was changed so far, and when [time]: by the schedule of the scenario, or by `apply`."""
        self.warnings = parts.warnings
        """Sentences about what the user should know of this scenario."""
        self.frame = 0
        """Frames done since the start of this run."""
        self.wall_seconds = 0.0
        """Seconds spent in the dynamics so far."""
        self.start_time = self.state.time
        """Time at the start of this run [time]."""
        self.start_tallies = self.dynamics.tallies.copy()
        """Tallies at the start of this run."""
        self.mean_displacement = observe.MeanDisplacement(self.state)
        """Where walls were on average over this run."""
        self._origin = (self.state.time, 0)
        self._start_geometry = scenario.geometry()
        self._plan = self._what_is_to_come()
        self._observers: list[Observer] = []
        self._guide = None if parts.world is None else Guide(self, parts.world)
        for observer in observers:
            self.attach(observer)

    @property
    def time(self) -> float:
        """Simulated time [time]."""
        return self.state.time

    @property
    def world(self) -> World | None:
        """The rules on top of the gas."""
        return None if self._guide is None else self._guide.world

    def _what_is_to_come(self) -> list[ScheduledChange]:
        """The schedule, the latest first; of a snapshot, what was not done yet."""
        done = self.time if self.scenario.snapshot is not None else -math.inf
        plan = [entry for entry in self.scenario.schedule if entry.at > done]
        # Of several at one time, the first goes first.
        return sorted(plan, key=lambda entry: entry.at)[::-1]

    def apply(self, change: Change) -> None:
        """Change gravity, a wall, a bath or a setting of the world now; logged, so the run can be repeated to the bit.

        Raises
        ------
        UsageError
            There is no such wall, or it cannot do that; or there is nothing in this dynamics or world to change so.
        """
        match change:
            case SetWorld():
                if self._guide is None:
                    raise UsageError(f"there is no world in which {change.name} could be set")
                self._guide.world.take(change)
            case SetGravity() | SetWall() | MoveWall():
                change = self.from_here(change) if isinstance(change, MoveWall) else change
                self.surround(change)
            case _:
                self._control(change)
        self.changes.append((self.time, change))

    def from_here(self, change: MoveWall) -> MoveWall:
        """The same motion, with the place from which the wall sets out."""
        names, moved = self.geometry.wall_names, self.state.wall_displacement
        here = moved[names.index(change.wall)] if change.wall in names and moved.size else 0.0
        return replace(change, origin=float(here))

    def surround(self, change: Surrounding) -> None:
        """Change gravity or a wall now, without a note of it in `changes`; a motion must say from where.

        Raises
        ------
        UsageError
            There is no such wall, or it cannot do that.
        """
        geometry = altered(self.geometry, self.time, change, self._start_geometry)
        self.dynamics.alter(self.state, geometry)
        self.geometry = geometry
        for observer in self._observers:
            if isinstance(observer, observe.FollowsChanges):
                observer.changed(self.state, self.geometry)

    def _control(self, change: Control) -> None:
        if not isinstance(self.dynamics, Controlled):
            raise UsageError(
                f"{self.scenario.dynamics.kind} dynamics has no thermostat, barostat or heating; forced dynamics has"
            )
        self.dynamics.control(self.state, change)

    def attach(self, observer: Observer) -> None:
        """Let an observer read the run from now on."""
        observer.start(self.state, self.dynamics.tallies)
        self._observers.append(observer)
        if observer.reads_contacts:
            self.write_contacts()

    def write_contacts(self) -> None:
        """Let the dynamics write contacts from now on: somebody reads them."""
        if self.dynamics.contacts.capacity == 0:
            self.dynamics.contacts = Contacts.empty(_CONTACTS)

    def advance(self, *, frames: int | None = None, until: float | None = None) -> None:
        """Move on by a number of frames (default 1), or to the absolute time `until` [time].

        Observers see each frame; a time that is no frame boundary they do not see.

        Raises
        ------
        UsageError
            Both or a time in the past was asked for.
        DynamicsError
            The engine cannot go on.
        """
        if until is not None:
            if frames is not None:
                raise UsageError("give either frames or until, not both")
            self._advance_to(until)
            self._origin = (until, self.frame)
            return
        for _ in range(1 if frames is None else frames):
            origin_time, origin_frame = self._origin
            self._advance_to(origin_time + (self.frame + 1 - origin_frame) * self.frame_interval)
            self.frame += 1
            self.observe()

    def observe(self) -> None:
        """Show the observers the state as it is now."""
        for observer in self._observers:
            observer.observe(self.state, self.dynamics.tallies)

    def _advance_to(self, until: float) -> None:
        # Under the stepped rule the clock stands at a whole step, perhaps a rounding beyond the frame.
        if not until >= self.time - 1e-9 * max(self.frame_interval, abs(self.time)):
            raise UsageError(f"until is {until:g}, but the gas is at time {self.time:g} already")
        begin = clock.perf_counter()
        while self._plan and self._plan[-1].at <= until:
            entry = self._plan.pop()
            self._run_to(max(entry.at, self.time))
            self.apply(entry.change())
        self._run_to(until)
        self.wall_seconds += clock.perf_counter() - begin

    def _run_to(self, until: float) -> None:
        while True:
            turn = math.inf if self._guide is None else self._guide.next
            self._move_to(min(turn, until))
            # The clock may stand a rounding beyond, where it is the world's turn already.
            if self._guide is None or turn > max(until, self.time):
                return
            self._guide.act()

    def _move_to(self, until: float) -> None:
        while self.dynamics.advance(self.state, until) is Status.FULL:
            self._read_contacts()
        self._read_contacts()
        self.mean_displacement.see(self.state)

    def _read_contacts(self) -> None:
        contacts = self.dynamics.contacts
        if contacts.count:
            for observer in self._observers:
                if observer.reads_contacts:
                    observer.read(contacts)
            if self._guide is not None and self._guide.world.reads_contacts:
                self._guide.world.read(contacts)
            contacts.clear()

    def temperature(self) -> float | None:
        """Temperature of the whole gas [energy]; None where there is none, as for one disc in a periodic box."""
        return observe.temperature(self.state, self.geometry)

    def pressure(self) -> float | None:
        """Pressure on the walls, measured over this run [mass/time²]; None without walls, or before it began."""
        change = self.dynamics.tallies - self.start_tallies
        radii = summary.radii(self.scenario)
        geometry = summary.mean_geometry(self)
        return observe.wall_pressure(change, geometry, radii, self.time - self.start_time)

    def energy(self) -> float:
        """Kinetic energy of all particles [energy]."""
        return observe.kinetic_energy(self.state)

    def momentum(self) -> tuple[float, float]:
        """Total momentum [mass·length/time]."""
        x, y = observe.momentum(self.state)
        return float(x), float(y)

    def frame_view(self) -> Frame:
        """The present frame; its arrays are the simulation's own."""
        memory = self.dynamics.memory()
        if self._guide is not None:
            memory |= self._guide.memory()
        return Frame(self.frame, self.state, self.dynamics.tallies, memory)

    def summary(self) -> dict[str, Any]:
        """What `gasbox run --json` prints."""
        return summary.summary(self)

    @property
    def scenario_in_use(self) -> Scenario:
        """The scenario with the frame interval that was chosen for it, so that who goes on keeps it."""
        if isinstance(self.scenario.dynamics, Stepped | Walk):
            # There it is the time step, which may be changed later.
            return self.scenario
        return self.scenario.model_copy(update={"frame_interval": self.frame_interval})

    def snapshot(self) -> Scenario:
        """The scenario with the whole gas in it, to go on from with the same bits."""
        return snapshot.snapshot(self.scenario_in_use, self.frame_view(), self.changes)

    def save(self, path: str | Path) -> None:
        """Write a snapshot as JSON (compressed if the name ends in .gz).

        Raises
        ------
        FileError
            The file cannot be written.
        """
        snapshot.write(self.snapshot(), Path(path))

    @classmethod
    def restore(cls, source: str | Path | Scenario, world: World | None = None) -> Simulation:
        """Go on from a snapshot, or from a file that holds one; `world` as for `Simulation`.

        Raises
        ------
        FileError, ScenarioError
            The file cannot be read or accepted.
        """
        return cls(source if isinstance(source, Scenario) else load(str(source)), world=world)
