"""The bins of the page's histograms: as chosen live, or automatic; and what theory puts into them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from gasbox.app.sample import Quantity, Sample
from gasbox.observe import (
    automatic_maximum,
    bin_edges,
    rotational_temperature,
    species_temperature,
    temperature,
)
from gasbox.observe.histograms import values
from gasbox.observe.rotation import spins
from gasbox.scenario import Scenario
from gasbox.theory import maxwell, rotors
from gasbox.theory.ranges import rounded_up

__all__ = ["ROTATION", "BinChoice", "Law", "automatic_ends", "curve", "edges_of", "expected", "law_of"]

ROTATION: Final[tuple[Quantity, ...]] = ("angular-velocity", "rotational-energy")
"""What only molecules have."""
_MOST: Final = 3.29
"""Standard deviations of a normal law within which 99.9 % lie."""


@dataclass(frozen=True)
class BinChoice:
    """How the histograms are cut.

    Attributes
    ----------
    quantity : what the axis shows
    count : number of bins
    minimum : lower end [the quantity's unit]
    maximum : upper end, or None: automatic
    own : automatic ends for each species by itself, instead of one for all
    """

    quantity: Quantity = "speed"
    count: int = 30
    minimum: float = 0.0
    maximum: float | None = None
    own: bool = False

    @classmethod
    def of(cls, scenario: Scenario) -> BinChoice:
        """As the scenario asks for."""
        wish = scenario.histograms
        return cls(wish.quantity, wish.bins, wish.minimum, wish.maximum)


@dataclass(frozen=True)
class Law:
    """Of one kind: temperature [energy], and mass [mass] or, for rotation, moment of inertia [mass·length²]."""

    temperature: float
    weight: float


def law_of(sample: Sample, quantity: Quantity, kind: int, whole: float | None) -> Law | None:
    """The law that one kind should follow, at the temperature `whole` of the gas [energy]; None where there is none.

    In a gas with molecules it is at the kind's own temperature, of its flight or of its rotation: these differ until
    they have levelled out.
    """
    state, geometry, one = sample.state, sample.geometry, sample.scenario.kinds[kind]
    if quantity in ROTATION:
        warmth, weight = rotational_temperature(state, geometry, kind), _inertia(sample, kind)
    else:
        warmth = species_temperature(state, geometry, kind) if sample.scenario.molecules else whole
        weight = one.mass
    return Law(warmth, weight) if warmth and weight else None


def _inertia(sample: Sample, kind: int) -> float:
    """Of one kind; in the mean, where it bends."""
    one = sample.scenario.kinds[kind]
    mine = sample.state.species == kind
    if not one.flexible or not mine.any():
        return one.inertia
    return float(spins(sample.state)[0][mine].mean())


def automatic_ends(sample: Sample, quantity: Quantity, kinds: int) -> list[float]:
    """Where the axis of each of the first so many kinds of particle would end by itself."""
    state, geometry = sample.state, sample.geometry
    if quantity == "speed" or quantity == "energy":
        return [automatic_maximum(state, geometry, one, quantity) for one in range(kinds)]
    warmth = temperature(state, geometry) or 0.0
    return [_end_of_rotation(sample, quantity, one, warmth) for one in range(kinds)]


def _end_of_rotation(sample: Sample, quantity: Quantity, kind: int, warmth: float) -> float:
    """It holds 99.9 % of what theory expects; of a gas at rest, the fastest; 0 for what does not turn."""
    state, inertia = sample.state, _inertia(sample, kind)
    hottest = max(warmth, rotational_temperature(state, sample.geometry, kind) or 0.0)
    if inertia == 0.0:
        return 0.0
    if hottest > 0.0:
        angular = quantity == "angular-velocity"
        return rounded_up(_MOST * math.sqrt(hottest / inertia) if angular else 0.5 * _MOST**2 * hottest)
    return rounded_up(float(np.max(np.abs(values(state, kind, quantity)), initial=0.0)) or 1.0)


def edges_of(choice: BinChoice, ends: list[float]) -> list[NDArray[np.float64]]:
    """The edges (bins+1,) of each species' histogram; `ends` are the automatic ones."""
    if not choice.own:
        ends = [max(ends, default=1.0)] * len(ends)
    uppers = [_upper(choice, end) for end in ends]
    return [bin_edges(choice.count, _lower(choice, upper), upper) for upper in uppers]


def _lower(choice: BinChoice, upper: float) -> float:
    both_ways = choice.quantity == "angular-velocity" and choice.maximum is None
    return -upper if both_ways else choice.minimum


def _upper(choice: BinChoice, automatic: float) -> float:
    if choice.maximum is not None and choice.maximum > choice.minimum:
        return choice.maximum
    return automatic if automatic > choice.minimum else rounded_up(2 * choice.minimum + 1)


def expected(edges: NDArray[np.float64], quantity: Quantity, count: float, law: Law) -> NDArray[np.float64]:
    """How many particles theory puts into each bin, (bins,)."""
    counts: NDArray[np.float64] = count * np.diff(_below(edges, quantity, law))
    return counts


def _below(values: NDArray[np.float64], quantity: Quantity, law: Law) -> NDArray[np.float64]:
    """Share of the particles that have less."""
    match quantity:
        case "speed":
            return maxwell.speed_cdf(values, law.weight, law.temperature)
        case "energy":
            return maxwell.energy_cdf(values, law.temperature)
        case "angular-velocity":
            return rotors.angular_velocity_cdf(values, law.weight, law.temperature)
        case "rotational-energy":
            return rotors.energy_cdf(values, law.temperature, 1)


def curve(
    edges: NDArray[np.float64],
    quantity: Quantity,
    count: float,
    law: Law,
    points: int = 121,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The theory as a smooth curve: what a bin of the same width would hold, were its middle at each point.

    In the middle of a bin it is that bin's expected count exactly.
    """
    width = edges[1] - edges[0]
    middles = np.linspace(edges[0], edges[-1], points)
    below = _below(np.stack([middles - width / 2, middles + width / 2]), quantity, law)
    return middles, count * (below[1] - below[0])
