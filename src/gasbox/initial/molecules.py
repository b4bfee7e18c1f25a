"""Places of molecules at the start, and the discs that they are made of."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.initial.molecule_places import place_turned
from gasbox.initial.placing import place
from gasbox.scenario import Scenario
from gasbox.state import Sites

__all__ = ["place_all", "sites_of"]


def sites_of(scenario: Scenario, species: NDArray[np.int32]) -> Sites:
    """The discs of particles of these kinds (n,), all still at their places in the molecule."""
    kinds, discs = scenario.kinds, scenario.site_kinds
    lengths = np.array([len(kind.sites) for kind in kinds], np.int64)[species]
    first = np.concatenate([[0], np.cumsum(lengths)]).astype(np.int64)
    members = [np.array(kind.sites, np.int32) for kind in kinds]
    which = np.concatenate([np.zeros(0, np.int32), *(members[k] for k in species)])
    place = np.concatenate([np.zeros((0, 2)), *(kinds[k].place for k in species)])
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
    turning = [number for number, kind in enumerate(scenario.kinds) if kind.inertia > 0.0]
    if not np.isin(np.concatenate([listed_species, species]), turning).any():
        return place(scenario, listed, listed_species, species), np.zeros(species.shape[0])
    return place_turned(scenario, listed, listed_species, listed_angle, species)
