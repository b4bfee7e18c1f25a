"""From the laws of force of a scenario to the table that kernels work with."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels.forced import Terms
from gasbox.kernels.forced.laws import law_at
from gasbox.kernels.forced.tables import CUT, CUT2, F_CUT, INVERSE_POWERS, SCREENED, U_CUT, WELL
from gasbox.scenario import Charges, PairLaw

__all__ = ["pair_terms"]

_STEEPNESS = 40.0
"""Of the edge of a square well, which rises within some sigma/40."""

_Parameters = tuple[float, float, float, float]


def _kernel_law(law: PairLaw) -> tuple[int, _Parameters]:
    """Number of the kernel's law, and its parameters (`gasbox.kernels.forced.laws`)."""
    epsilon, sigma = law.epsilon, law.sigma
    match law.law:
        case "lennard-jones" | "wca":
            return INVERSE_POWERS, (sigma**2, 4.0 * epsilon, 4.0 * epsilon, 0.0)
        case "soft-sphere":
            return INVERSE_POWERS, (sigma**2, epsilon, 0.0, 0.0)
        case "yukawa":
            length = law.screening_length
            return SCREENED, (epsilon * sigma, 1.0 / length, sigma, 0.0)
        case "square-well":
            return WELL, (sigma**2, epsilon, _STEEPNESS, _STEEPNESS * law.reach)
    raise ValueError(law.law)  # pragma: no cover


def pair_terms(
    laws: Mapping[tuple[int, int], PairLaw],
    species: int,
    charges: Charges | None = None,
    charge: Sequence[float] = (),
) -> Terms:
    """The table of all laws between so many species.

    Parameters
    ----------
    laws : of each pair (a, b), a <= b
    charges, charge : how charges act, and the charge of each species
    """
    tables: dict[tuple[int, bool], NDArray[np.float64]] = {}

    def enter(a: int, b: int, kind: int, parameters: _Parameters, cutoff: float, shifted: bool) -> None:
        table = tables.setdefault((kind, shifted), np.zeros((8, species, species)))
        u, f = law_at(kind, cutoff, *parameters)
        column = np.zeros(8)
        column[:4] = parameters
        column[[CUT2, CUT, U_CUT, F_CUT]] = cutoff**2, cutoff, u, f
        table[:, a, b] = table[:, b, a] = column

    for (a, b), law in laws.items():
        if law.law != "none" and law.epsilon > 0.0:
            enter(a, b, *_kernel_law(law), law.cutoff, law.truncation == "force-shifted")
    found = list(tables.items())
    if charges is not None and any(charge):
        tables.clear()
        rate = 1.0 / charges.screening_length
        for a, b in laws:
            strength = charges.strength * charge[a] * charge[b]
            if strength:
                enter(a, b, SCREENED, (strength, rate, 0.0, 0.0), charges.cutoff, True)
        found += list(tables.items())
    value = np.array([table.reshape(8, -1) for _, table in found]).reshape(len(found), 8, species**2)
    return Terms(
        np.array([kind for (kind, _), _ in found], np.int64),
        np.array([shifted for (_, shifted), _ in found], np.bool_),
        value,
        species,
        float(value[:, CUT].max()) if found else 0.0,
    )
