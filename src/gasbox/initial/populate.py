"""From a scenario to the gas at its start."""

from __future__ import annotations

import numpy as np

from gasbox.initial.molecules import place_all
from gasbox.initial.velocities import draw_rotation, draw_velocities
from gasbox.scenario import Scenario, sites_of
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
    names = [kind.name for kind in scenario.kinds]
    species, position, velocity = np.zeros(0, np.int32), np.zeros((0, 2)), np.zeros((0, 2))
    angle, turning = np.zeros(0), np.zeros(0)
    if scenario.particles is not None:
        species, position, velocity = scenario.particles.arrays(names)
        angle, turning = scenario.particles.rotation()
    if scenario.snapshot is not None:
        state = _state(scenario, scenario.snapshot.time, species, position, velocity, angle, turning)
        if scenario.snapshot.ids is not None:
            state.id = np.array(scenario.snapshot.ids, np.int64)
        return state
    position = scenario.geometry().wrap(position)
    counts = [kind.count for kind in scenario.kinds]
    counted = np.repeat(np.arange(len(counts), dtype=np.int32), counts)
    placed, turned = place_all(scenario, position, species, angle, counted)
    drawn = draw_velocities(scenario, counted)
    spun = draw_rotation(scenario, counted)
    return _state(
        scenario,
        0.0,
        np.concatenate([species, counted]),
        np.concatenate([position, placed]),
        np.concatenate([velocity, drawn]),
        np.concatenate([angle, turned]),
        np.concatenate([turning, spun]),
    )


def _state(
    scenario: Scenario,
    time: float,
    species: np.ndarray,
    position: np.ndarray,
    velocity: np.ndarray,
    angle: np.ndarray,
    turning: np.ndarray,
) -> State:
    mass = np.array([kind.mass for kind in scenario.kinds])
    radius = np.array([kind.radius for kind in scenario.kinds])
    ids = np.arange(species.shape[0], dtype=np.int64)
    species = species.astype(np.int32)
    state = State(time, ids, species, mass[species], radius[species], position, velocity)
    if scenario.molecules:
        inertia = np.array([kind.inertia for kind in scenario.kinds])
        state.inertia = inertia[species]
        state.angle = np.where(state.inertia > 0.0, angle, 0.0)
        state.angular_velocity = np.where(state.inertia > 0.0, turning, 0.0)
        state.sites = sites_of(scenario, species)
        state.sites.follow(state.position, state.velocity, state.angle, state.angular_velocity, True)
    return state
