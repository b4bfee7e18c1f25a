"""Stand-ins for tests of the transport, which need no engine and no real time."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np

from gasbox.errors import UsageError
from gasbox.geometry import Enclosure, Geometry, Rectangle, Wall
from gasbox.scenario import Scenario, parse
from gasbox.state import Change, Control, MoveWall, SetGravity, SetWall, State, Tallies


class FakeClock:
    """Seconds that pass only when a test says so."""

    def __init__(self) -> None:
        self.now = 1000.0

    def __call__(self) -> float:
        return self.now


class FreeFlight:
    """Discs that pass through each other in a periodic box.

    By the fake clock, a unit of simulated time costs `cost` seconds, and each call `overhead` seconds.
    """

    def __init__(
        self, scenario: Scenario, clock: FakeClock | None = None, cost: float = 0.0, overhead: float = 0.0
    ) -> None:
        self.scenario = scenario
        self.geometry = scenario.geometry()
        self.changes: list[tuple[float, Change]] = []
        self.world: Any = None
        self.frame_interval = scenario.frame_interval or 1.0
        self.warnings = ()
        self.calls: list[float] = []
        self._clock, self._cost, self._overhead = clock, cost, overhead
        counts = [one.count for one in scenario.species]
        names = [one.name for one in scenario.species]
        drawn = np.repeat(np.arange(len(counts), dtype=np.int32), counts)
        listed, places, speeds = _listed(scenario, names)
        species = np.concatenate([listed, drawn])
        random = np.random.default_rng(scenario.seed)
        self.state = State(
            time=0.0,
            id=np.arange(len(species)),
            species=species,
            mass=np.array([one.mass for one in scenario.species])[species],
            radius=np.array([one.radius for one in scenario.species])[species],
            position=np.concatenate([places, random.random((len(drawn), 2)) * self.geometry.size]),
            velocity=np.concatenate([speeds, random.normal(size=(len(drawn), 2)) * 0.1]),
        )
        self.dynamics = SimpleNamespace(tallies=Tallies.zero(len(counts), len(self.geometry.wall_names)))
        if self.geometry.moves:
            self.state.wall_displacement = np.zeros(len(self.geometry.wall_names))
            self.state.wall_velocity = np.zeros(len(self.geometry.wall_names))

    @property
    def time(self) -> float:
        return self.state.time

    def advance(self, *, until: float) -> None:
        step = until - self.time
        self.calls.append(step)
        self.state.position = (self.state.position + self.state.velocity * step) % self.geometry.size
        self.state.time = until
        if self._clock is not None:
            self._clock.now += step * self._cost + self._overhead

    def apply(self, change: Change) -> None:
        """Gravity is shown but not felt, nor is heat; walls jump to where they are moved."""
        self.geometry = changed(self.geometry, change)
        if isinstance(change, MoveWall):
            if not self.state.wall_displacement.size:
                self.state.wall_displacement = np.zeros(len(self.geometry.wall_names))
            self.state.wall_displacement[self.geometry.wall_names.index(change.wall)] = change.displacement
        self.changes.append((self.time, change))

    def snapshot(self) -> Scenario:
        return self.scenario


def changed(geometry: Geometry, change: Change) -> Geometry:
    if isinstance(change, Control):
        return geometry
    if isinstance(geometry, Rectangle):
        geometry = Enclosure(geometry, walls=tuple(Wall(name) for name in geometry.wall_names))
    match change:
        case SetGravity(gravity=gravity):
            return replace(geometry, gravity=gravity)
        case SetWall(wall=name):
            if name not in geometry.wall_names:
                raise UsageError(f"there is no wall {name}")
            said = {"present": change.present, "temperature": change.temperature}
            wanted = {key: value for key, value in said.items() if value is not None}
            return geometry.with_wall(geometry.wall_names.index(name), **wanted)
        case _:
            return geometry


def _listed(scenario: Scenario, names: list[str]) -> tuple[Any, Any, Any]:
    if scenario.particles is None:
        return np.zeros(0, np.int32), np.zeros((0, 2)), np.zeros((0, 2))
    return scenario.particles.arrays(names)


def gas(counts: tuple[int, ...] = (30, 20), **settings: Any) -> Scenario:
    """A small periodic scenario with species of these counts."""
    colors = ("#ff0000", "#00a000", "#0000ff")
    species = [
        {"name": f"kind {k}", "radius": 0.5 * (k + 1), "color": colors[k % 3], "count": n, "temperature": 1}
        for k, n in enumerate(counts)
    ]
    return parse(
        {
            "format": "gasbox-scenario/1",
            "title": "A gas for tests",
            "container": {"shape": "rectangle", "width": 60, "height": 40, "periodic": ["x", "y"]},
            "species": species,
            "dynamics": {"kind": "event-driven"},
            "frame_interval": 0.5,
            **settings,
        }
    )
