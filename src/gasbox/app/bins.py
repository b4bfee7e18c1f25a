"""The bins of the page's histograms: as chosen live, or automatic; and what theory puts into them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gasbox.app.sample import Quantity, Sample
from gasbox.observe import automatic_maximum, bin_edges
from gasbox.scenario import Scenario
from gasbox.theory import maxwell
from gasbox.theory.ranges import rounded_up

__all__ = ["BinChoice", "automatic_ends", "curve", "edges_of", "expected"]


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


def automatic_ends(sample: Sample, quantity: Quantity, species: int) -> list[float]:
    """Where the axis of each of the first so many species would end by itself."""
    return [automatic_maximum(sample.state, sample.geometry, one, quantity) for one in range(species)]


def edges_of(choice: BinChoice, ends: list[float]) -> list[NDArray[np.float64]]:
    """The edges (bins+1,) of each species' histogram; `ends` are the automatic ones."""
    if not choice.own:
        ends = [max(ends, default=1.0)] * len(ends)
    return [bin_edges(choice.count, choice.minimum, _upper(choice, end)) for end in ends]


def _upper(choice: BinChoice, automatic: float) -> float:
    if choice.maximum is not None and choice.maximum > choice.minimum:
        return choice.maximum
    return automatic if automatic > choice.minimum else rounded_up(2 * choice.minimum + 1)


def expected(
    edges: NDArray[np.float64], quantity: Quantity, count: float, mass: float, temperature: float
) -> NDArray[np.float64]:
    """How many particles theory puts into each bin, (bins,)."""
    if quantity == "energy":
        return maxwell.expected_energy_counts(edges, count, temperature)
    return maxwell.expected_speed_counts(edges, count, mass, temperature)


def curve(
    edges: NDArray[np.float64],
    quantity: Quantity,
    count: float,
    mass: float,
    temperature: float,
    points: int = 121,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The theory as a smooth curve: what a bin of the same width would hold, were its middle at each point.

    In the middle of a bin it is that bin's expected count exactly.
    """
    width = edges[1] - edges[0]
    middles = np.linspace(edges[0], edges[-1], points)
    ends = np.stack([middles - width / 2, middles + width / 2])
    below = (
        maxwell.energy_cdf(ends, temperature)
        if quantity == "energy"
        else maxwell.speed_cdf(ends, mass, temperature)
    )
    return middles, count * (below[1] - below[0])
