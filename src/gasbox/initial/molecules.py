"""Places of molecules at the start, and the discs that they are made of."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.initial.placing import place
from gasbox.rng import Stream, generator
from gasbox.scenario import Scenario, Species
from gasbox.state import Sites

__all__ = ["place_all", "sites_of"]


def sites_of(scenario: Scenario, species: NDArray[np.int32]) -> Sites:
    """The discs of particles of these kinds (n,), all still at their places in the molecule."""
    kinds, discs = scenario.kinds, scenario.site_kinds
    lengths = np.array([len(kind.sites) for kind in kinds], np.int64)[species]
    first = np.concatenate([[0], np.cumsum(lengths)]).astype(np.int64)
    members = [np.array(kind.sites, np.int32) for kind in kinds]
    which = np.concatenate([members[k] for k in species]) if species.size else np.zeros(0, np.int32)
    place = np.concatenate([kinds[k].place for k in species]) if species.size else np.zeros((0, 2))
    mass = np.array([disc.mass for disc in discs])
    radius = np.array([disc.radius for disc in discs])
    flexible = np.array([kind.flexible for kind in kinds])[species]
    return Sites(
        first, which, mass[which], radius[which], place, place.copy(), np.zeros_like(place), flexible
    )


def place_all(
    scenario: Scenario,
    listed: NDArray[np.float64],
    listed_species: NDArray[np.int32],
    listed_angle: NDArray[np.float64],
    species: NDArray[np.int32],
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positions (n, 2) [length] and angles (n,) [rad] of the counted particles of kinds `species` (n,).

    Raises
    ------
    ScenarioError
        No places were found within a bounded amount of work.
    """
    if not scenario.molecules:
        return place(scenario, listed, listed_species, species), np.zeros(species.shape[0])
    angle = np.zeros(species.shape[0])
    for number, kind in enumerate(scenario.kinds):
        members = np.flatnonzero(species == number)
        if kind.inertia > 0.0 and members.size:
            random = generator(scenario.seed, Stream.ORIENTATIONS, number)
            angle[members] = random.uniform(0.0, 2.0 * math.pi, members.size)
    return place(_as_discs(scenario), listed, listed_species, species), angle


def _as_discs(scenario: Scenario) -> Scenario:
    """The same gas, each molecule a disc that holds it however it turns."""
    discs = tuple(
        Species(
            name=kind.name,
            radius=kind.radius,
            count=kind.count,
            temperature=kind.temperature,
            speed=kind.speed,
            region=kind.region,
        )
        for kind in scenario.kinds[len(scenario.species) :]
    )
    return scenario.model_copy(update={"species": (*scenario.species, *discs), "molecules": ()})
