"""From the kinds of a scenario to the discs of its particles."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.scenario.scenario import Scenario
from gasbox.state import Sites

__all__ = ["sites_of"]


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
