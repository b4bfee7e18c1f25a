"""The discs that forces act between, and the molecules that they make up."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gasbox.dynamics.inner_tables import inner_tables
from gasbox.kernels import arguments, forced
from gasbox.scenario import Kind
from gasbox.state import State

__all__ = ["bodies_of", "discs_of", "gas_of", "has_molecules", "held", "kinetic_energy", "of_particles"]


def has_molecules(state: State) -> bool:
    """Whether any particle has more than one disc."""
    return state.sites is not None and state.sites.count > state.count


def discs_of(state: State) -> State:
    """All discs, each a row of its own, with what each is for forces as `species`; no copies."""
    sites = state.sites
    if sites is None:
        return state
    if not has_molecules(state):
        return State(
            state.time, state.id, sites.species, state.mass, state.radius, state.position, state.velocity
        )
    ids = state.id[sites.owner]
    return State(state.time, ids, sites.species, sites.mass, sites.radius, sites.position, sites.velocity)


def gas_of(state: State) -> arguments.Gas:
    """The discs as walls and thermostats see them: with number and kind of the particle that each belongs to."""
    gas = arguments.gas(discs_of(state))
    if state.sites is None or not has_molecules(state):
        return gas._replace(species=state.species)
    return gas._replace(species=state.species[state.sites.owner])


def held(state: State) -> NDArray[np.bool_]:
    """(m,) bool: which discs are parts of a rigid body."""
    sites = state.sites
    if sites is None:
        return np.zeros(state.count, np.bool_)
    rigid: NDArray[np.bool_] = ((np.diff(sites.first) > 1) & ~sites.flexible)[sites.owner]
    return rigid


def bodies_of(state: State, kinds: Sequence[Kind]) -> forced.Bodies | None:
    """The molecules of a state; None if each particle is a disc. kinds : all kinds of particle of the scenario"""
    return forced.bodies(state, inner_tables(state, kinds)) if has_molecules(state) else None


def of_particles(state: State, force: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Force (n, 2) [mass·length/time²] on each particle, and torque (n,) [energy], from those on its discs (m, 2)."""
    sites = state.sites
    if sites is None or not has_molecules(state):
        return force, np.zeros(state.count)
    arm = sites.position - state.position[sites.owner]
    moment = arm[:, 0] * force[:, 1] - arm[:, 1] * force[:, 0]
    columns = [np.add.reduceat(column, sites.first[:-1]) for column in (*force.T, moment)]
    return np.stack(columns[:2], axis=1), columns[2]


def kinetic_energy(state: State, common: NDArray[np.float64]) -> float:
    """Of all motion, relative to a common velocity (2,) [energy]."""
    energy = 0.5 * float(np.sum(state.mass @ (state.velocity - common) ** 2))
    if state.sites is None:
        return energy
    turning = np.where(state.sites.flexible, 0.0, state.inertia * state.angular_velocity**2)
    owner = state.sites.owner
    within = np.where(state.sites.flexible[owner, None], state.sites.velocity - state.velocity[owner], 0.0)
    return energy + 0.5 * float(turning.sum() + np.sum(state.sites.mass @ within**2))
