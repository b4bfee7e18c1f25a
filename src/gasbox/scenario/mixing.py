"""The law of force of each pair of species: mixed from what the species say, or as the pair says."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from gasbox.scenario.forces import Forces, PairForces
from gasbox.scenario.species import Species

__all__ = ["PairLaw", "laws_of"]

_CUTOFFS: Final = {
    "lennard-jones": 2.5,
    "wca": 2 ** (1 / 6),
    "soft-sphere": 2.5,
    "square-well": 1.9,
    "yukawa": 6.0,
    "none": 0.0,
}
"""Of each law, in units of sigma, where none is said."""
_OF_THEMSELVES: Final = frozenset({"wca", "none"})
"""These end where they end, whatever cutoff is asked for."""
_REACH: Final = 1.5


@dataclass(frozen=True)
class PairLaw:
    """The force between discs of two species, ready for an engine.

    Attributes
    ----------
    law : "lennard-jones", "wca", "soft-sphere", "square-well", "yukawa" or "none"
    epsilon : strength [energy]
    sigma : range [length]
    cutoff : distance beyond which there is no force [length]; 0 for "none"
    truncation : what is taken off at the cutoff: "shifted", the energy there; "force-shifted", also the force
    reach : width of a square well, in units of sigma
    screening_length : decay length of a Yukawa force [length]
    """

    law: str
    epsilon: float
    sigma: float
    cutoff: float
    truncation: str
    reach: float
    screening_length: float


def laws_of(species: Sequence[Species], forces: Forces) -> dict[tuple[int, int], PairLaw]:
    """The law of each pair (a, b) of species, a <= b.

    Where a pair says nothing, epsilon is the geometric mean of those of the two species (D. Berthelot, C. R. Acad. Sci.
    126, 1703, 1898) and sigma the arithmetic mean (H. A. Lorentz, Ann. Phys. 248, 127, 1881,
    doi:10.1002/andp.18812480110).
    """
    names = [entry.name for entry in species]
    said = {frozenset(pair.between): pair for pair in forces.pairs}
    return {
        (a, b): _law(species[a], species[b], forces, said.get(frozenset((names[a], names[b]))))
        for b in range(len(species))
        for a in range(b + 1)
    }


def _law(one: Species, other: Species, forces: Forces, pair: PairForces | None) -> PairLaw:
    pair = pair or PairForces(between=(one.name, other.name))
    law = pair.law or forces.law
    sigma = pair.sigma or (_sigma(one) + _sigma(other)) / 2
    epsilon = pair.epsilon
    if epsilon is None:
        epsilon = _epsilon(one) if one is other else math.sqrt(_epsilon(one) * _epsilon(other))
    cutoff = _CUTOFFS[law]
    if law not in _OF_THEMSELVES:
        cutoff = pair.cutoff or (forces.cutoff if law == forces.law else None) or cutoff
    return PairLaw(
        law,
        epsilon,
        sigma,
        cutoff * sigma,
        "shifted" if law == "wca" else pair.truncation or forces.truncation,
        pair.reach or forces.reach or _REACH,
        pair.screening_length or forces.screening_length or sigma,
    )


def _epsilon(species: Species) -> float:
    return 1.0 if species.epsilon is None else species.epsilon


def _sigma(species: Species) -> float:
    return 2 * species.radius if species.sigma is None else species.sigma
