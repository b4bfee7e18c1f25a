"""Which discs belong to a solid, a liquid or a gas, judged by their neighbourhood alone.

Two numbers tell: how many neighbours a disc has, and how well their directions make one hexagon (psi_6). Of one disc
both fluctuate much, so both are averaged over the disc and its neighbours, and the averages over theirs once more;
psi_6 as a complex number, so that it stays large only where neighbouring hexagons are turned alike, as in a crystal.
Then

- solid: at least 5 neighbours, and |psi_6| at least 0.65;
- gas: fewer than 3 neighbours;
- liquid: all others.

Of Lennard-Jones discs with neighbours up to 1.5 sigma, crystals just below melting are then solid to 98 %, the liquid
just above it to 5 to 20 %, since it does hold small crystalline patches, and the gas at its densest (0.1 per sigma²)
is gas to 94 %. The outermost row of a crystal or drop may count as the next looser phase.

Source: W. Lechner and C. Dellago, J. Chem. Phys. 129, 114707 (2008), doi:10.1063/1.2977970, for averages over
neighbours, there in three dimensions.
"""

from __future__ import annotations

from enum import IntEnum
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.observe.neighbours import Neighbours, bond_order, neighbours, sum_over
from gasbox.state import State

__all__ = ["Phase", "phase_shares", "phases"]


class Phase(IntEnum):
    """What a disc belongs to."""

    GAS = 0
    LIQUID = 1
    SOLID = 2


SOLID_ORDER: Final = 0.65
"""Least averaged |psi_6| in a solid: between the 0.5 of the liquid at freezing and the 0.85 of the solid at melting."""
SOLID_COORDINATION: Final = 5.0
"""Least averaged number of neighbours in a solid; a few discs alone in a gas may make a perfect hexagon by chance."""
GAS_COORDINATION: Final = 3.0
"""Averaged number of neighbours below which a disc is in a gas: between the 2 of a dense gas and the 5 of a liquid."""
_ROUNDS: Final = 2


def phases(state: State, geometry: Geometry, distance: float = 1.5) -> NDArray[np.int8]:
    """(n,) int8: the `Phase` of each disc, 0 gas, 1 liquid, 2 solid, as this module defines them.

    Parameters
    ----------
    distance : within which others are neighbours [length]; best the first minimum of g(r), some 1.5 sigma
    """
    found = neighbours(state, geometry, distance)
    order, coordination = bond_order(found), found.counts.astype(np.complex128)
    for _ in range(_ROUNDS):
        order, coordination = _averaged(found, order), _averaged(found, coordination)
    result = np.full(state.count, Phase.LIQUID, np.int8)
    result[coordination.real < GAS_COORDINATION] = Phase.GAS
    result[(coordination.real >= SOLID_COORDINATION) & (np.abs(order) >= SOLID_ORDER)] = Phase.SOLID
    return result


def phase_shares(found: NDArray[np.int8]) -> NDArray[np.float64]:
    """(3,) float64: share of discs in the gas, the liquid and the solid; not-a-number without discs."""
    counts = np.bincount(found, minlength=len(Phase))
    return counts / found.size if found.size else np.full(len(Phase), np.nan)


def _averaged(found: Neighbours, values: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Mean over each disc and its neighbours."""
    return (values + sum_over(found, values[found.other])) / (found.counts + 1)
