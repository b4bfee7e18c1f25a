"""A gas of points that fly between walls and never meet: stands in for the engine where only the page is tested."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np

from gasbox.scenario import Scenario, parse
from gasbox.state import Contacts, State, Tallies


class FreeFlight:
    def __init__(self, scenario: Scenario) -> None:
        self.scenario = scenario
        self.geometry = scenario.container.geometry()
        self.frame_interval = scenario.frame_interval or 1.0
        self.frame = 0
        self.warnings: tuple[str, ...] = ()
        self.state = _start(scenario)
        walls = len(self.geometry.WALLS)
        self.dynamics = SimpleNamespace(
            tallies=Tallies.zero(len(scenario.species), walls), contacts=Contacts.empty(0)
        )

    @property
    def time(self) -> float:
        return self.state.time

    def advance(self, frames: int | None = None, until: float | None = None) -> None:
        until = self.time + self.frame_interval * (frames or 1) if until is None else until
        state, size = self.state, self.geometry.size
        state.position += state.velocity * (until - state.time)
        for axis in (0, 1):
            out = (state.position[:, axis] < 0) | (state.position[:, axis] > size[axis])
            hits = np.flatnonzero(out)
            wall = 2 * axis + (state.position[hits, axis] > 0)
            impulse = 2 * state.mass[hits] * np.abs(state.velocity[hits, axis])
            np.add.at(self.dynamics.tallies.wall_impulse, (wall, state.species[hits]), impulse)
            np.add.at(self.dynamics.tallies.wall_collisions, (wall, state.species[hits]), 1)
            state.velocity[hits, axis] *= -1
            state.position[:, axis] = np.clip(state.position[:, axis], 0, size[axis])
        state.time = until
        self.frame = round(until / self.frame_interval)

    def snapshot(self) -> Scenario:
        state = self.state
        names = [species.name for species in self.scenario.species]
        data = self.scenario.to_dict()
        data["particles"] = {
            "species": [names[index] for index in state.species],
            "position": state.position.tolist(),
            "velocity": state.velocity.tolist(),
        }
        data["snapshot"] = {"version": "0", "time": state.time, "memory": {}, "tallies": {}}
        return parse(data)


def _start(scenario: Scenario) -> State:
    draw = np.random.default_rng(scenario.seed)
    species = np.repeat(np.arange(len(scenario.species)), [one.count for one in scenario.species]).astype(np.int32)
    mass = np.array([one.mass for one in scenario.species])[species]
    radius = np.array([one.radius for one in scenario.species])[species]
    warmth = np.array([one.temperature or 0.1 for one in scenario.species])[species]
    count = species.size
    size = np.array([scenario.container.width, scenario.container.height])
    position = draw.random((count, 2)) * size
    velocity = draw.normal(size=(count, 2)) * np.sqrt(warmth / mass)[:, None]
    if scenario.snapshot is not None and scenario.particles is not None:
        species, position, velocity = scenario.particles.arrays([one.name for one in scenario.species])
        mass = np.array([one.mass for one in scenario.species])[species]
        radius = np.array([one.radius for one in scenario.species])[species]
    time = scenario.snapshot.time if scenario.snapshot else 0.0
    return State(time, np.arange(len(species)), species, mass, radius, position.copy(), velocity.copy())
