"""What the discs of one point are: told from how they stand, never from the temperature or the density.

Three numbers are enough. The shares of discs in gas, liquid and solid come from the neighbourhood of each
(`gasbox.observe.phases`). They alone do not tell a gas beside its liquid from an even fluid of half the density, in
which discs have few neighbours here and many there by chance. So the third number is the unevenness: how strong the
longest wave of the density is that fits into the box, |sum over discs of exp(2 pi i x/L)|/N, the larger one of both
directions. Of N discs of an even fluid it is some sqrt(S/N), with S the structure factor at long waves, about 1 in a
gas and 0.1 in a liquid; of two phases that have parted it does not shrink with N. Near the critical point S grows, and
a small box cannot tell both cases apart: there the border is blurred by the size of the box.
"""

from __future__ import annotations

from typing import Final, Literal

import numpy as np
from numpy.typing import NDArray

__all__ = ["MATTERS", "Matter", "unevenness", "verdict"]

Matter = Literal[
    "gas",
    "fluid",
    "liquid",
    "solid",
    "gas and liquid",
    "gas and solid",
    "gas, liquid, solid",
    "liquid and solid",
]
MATTERS: Final[tuple[Matter, ...]] = (
    "gas",
    "fluid",
    "liquid",
    "solid",
    "gas and liquid",
    "gas and solid",
    "gas, liquid, solid",
    "liquid and solid",
)
"""All there are. A fluid is dense gas or thin liquid: above the critical point nothing divides the two."""

_EVEN: Final = 12.0
"""Largest structure factor at long waves of what counts as even: 1 in a thin gas, and some 10 in a fluid a tenth above
its critical temperature."""
_PURE: Final = 0.8
"""Share from which a phase counts as alone."""
_CRYSTAL: Final = 0.6
"""The same of the solid in what has a surface: discs there have too few neighbours to count as solid."""
_PATCHES: Final = 0.25
"""Share of discs in crystalline patches that a liquid may hold."""
_PATCHES_OF_DROPS: Final = 0.35
"""The same of drops: as long as they are small, more of them is in one patch."""


def unevenness(position: NDArray[np.float64], size: NDArray[np.float64]) -> float:
    """Strength of the longest wave of the density, 0 to 1, the larger one of both directions.

    Parameters
    ----------
    position : (n, 2) float64 [length]
    size : (2,) float64, of the periodic box [length]
    """
    waves = np.exp(2j * np.pi * position / size)
    return float(np.max(np.abs(np.mean(waves, axis=0))))


def verdict(gas: float, solid: float, uneven: float, particles: int) -> Matter:
    """What it is.

    Parameters
    ----------
    gas, solid : shares of discs in the gas and the solid; the others are liquid
    uneven : the unevenness
    particles : how many discs these are shares of
    """
    if particles * uneven**2 < _EVEN:
        return _even(gas, solid)
    crystal = solid / (1.0 - gas) if gas < 1.0 else 0.0
    if crystal >= _CRYSTAL:
        return "gas and solid"
    return "gas, liquid, solid" if crystal > _PATCHES_OF_DROPS else "gas and liquid"


def _even(gas: float, solid: float) -> Matter:
    if solid >= _PURE:
        return "solid"
    if solid > _PATCHES:
        return "liquid and solid"
    if gas >= _PURE:
        return "gas"
    return "liquid" if gas <= 1.0 - _PURE else "fluid"
