"""From a scenario to the gas at its start."""

from __future__ import annotations

import numpy as np

from gasbox.initial.placing import place
from gasbox.initial.velocities import draw_velocities
from gasbox.scenario import Scenario
from gasbox.state import State

__all__ = ["populate"]


def populate(scenario: Scenario) -> State:
    """The gas at its start: listed particles first, then those counted in each species, without overlap among these.

    Of a snapshot, the particles as they were saved, at the time at which they were.

    Raises
    ------
    ScenarioError
        So many discs cannot be placed.
    """
    names = [entry.name for entry in scenario.species]
    species, position, velocity = np.zeros(0, np.int32), np.zeros((0, 2)), np.zeros((0, 2))
    if scenario.particles is not None:
        species, position, velocity = scenario.particles.arrays(names)
    if scenario.snapshot is not None:
        state = _state(scenario, scenario.snapshot.time, species, position, velocity)
        if scenario.snapshot.ids is not None:
            state.id = np.array(scenario.snapshot.ids, np.int64)
        return state
    position = scenario.geometry().wrap(position)
    counts = [entry.count for entry in scenario.species]
    counted = np.repeat(np.arange(len(counts), dtype=np.int32), counts)
    placed = place(scenario, position, species, counted)
    drawn = draw_velocities(scenario, counted)
    return _state(
        scenario,
        0.0,
        np.concatenate([species, counted]),
        np.concatenate([position, placed]),
        np.concatenate([velocity, drawn]),
    )


def _state(
    scenario: Scenario, time: float, species: np.ndarray, position: np.ndarray, velocity: np.ndarray
) -> State:
    mass = np.array([entry.mass for entry in scenario.species])
    radius = np.array([entry.radius for entry in scenario.species])
    ids = np.arange(species.shape[0], dtype=np.int64)
    return State(time, ids, species.astype(np.int32), mass[species], radius[species], position, velocity)
