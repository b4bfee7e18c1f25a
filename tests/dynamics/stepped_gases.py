"""The stepped rule in enclosures, as its tests want it."""

from __future__ import annotations

import hashlib

import numpy as np
from gases import separation

from gasbox.dynamics import Stepped
from gasbox.geometry import Enclosure
from gasbox.state import Contacts, State, Tallies


def stepped(
    state: State, place: Enclosure, contacts: int = 0, memory=None, time_step: float = 0.02, threads: int = 1
) -> Stepped:
    tallies = Tallies.zero(2, len(place.walls))
    return Stepped(state, place, time_step, tallies, Contacts.empty(contacts), memory, threads, seed=5)


def bits(state: State, dynamics: Stepped) -> str:
    digest = hashlib.sha256()
    arrays = [state.id, state.position, state.velocity, state.wall_displacement, state.wall_velocity]
    arrays += [*vars(dynamics.tallies).values()]
    for _, value in sorted(dynamics.memory().items()):
        arrays.append(np.asarray(value))
    for array in arrays:
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


def wall_depth(state: State, place: Enclosure) -> float:
    """How deep any disc overlaps a side or the rim of a container at rest, over its radius."""
    worst = -np.inf
    for element in place.elements:
        away = state.position - np.array(element.place)
        if element.kind == 0:
            height = element.faces * (away @ np.array(element.normal))
        elif element.kind == 2:
            height = element.radius - np.hypot(*away.T)
        else:
            continue
        worst = max(worst, float(((state.radius - height) / state.radius).max()))
    return worst


def pair_depth(state: State, place: Enclosure) -> float:
    """How deep any two discs overlap, over the smaller radius; by all pairs."""
    worst = 0.0
    for i in range(state.count - 1):
        away = separation(state.position[i + 1 :] - state.position[i], place)
        depth = state.radius[i] + state.radius[i + 1 :] - np.hypot(*away.T)
        worst = max(worst, float((depth / np.minimum(state.radius[i], state.radius[i + 1 :])).max()))
    return worst
