"""How discs are shown: what their colour says, and whether neighbours are joined by lines."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, Literal

from gasbox.scenario import Kind, Scenario, Species

__all__ = ["COLORINGS", "REACH", "Coloring", "Look", "after", "mean_size", "size_of", "sizes_of"]

Coloring = Literal["species", "phase", "neighbours", "speed"]
"""What the colour of a disc says."""
COLORINGS: Final[tuple[Coloring, ...]] = ("species", "phase", "neighbours", "speed")
"""In the order of their numbers on the wire, of the menu, and of the key that goes through them."""
REACH: Final = 1.5
"""Discs are neighbours up to this distance, in units of `size_of`: beyond the first ring, before the second."""


@dataclass(frozen=True)
class Look:
    """What is asked for.

    Attributes
    ----------
    bonds : whether neighbours are joined by lines, and discs drawn smaller so that these are seen
    """

    coloring: Coloring = "species"
    bonds: bool = False


def after(coloring: Coloring) -> Coloring:
    """The next one."""
    return COLORINGS[(COLORINGS.index(coloring) + 1) % len(COLORINGS)]


def size_of(species: Species) -> float:
    """Distance at which discs of a species begin to push each other away [length]: sigma, or the diameter."""
    sigma: float | None = getattr(species, "sigma", None)
    return float(2.0 * species.radius if sigma is None else sigma)


def sizes_of(scenario: Scenario) -> list[float]:
    """`size_of` of each kind of particle [length]; of a molecule the mean over all directions."""
    return [_size_of_kind(scenario, kind) for kind in scenario.kinds]


def _size_of_kind(scenario: Scenario, kind: Kind) -> float:
    discs = [scenario.site_kinds[site] for site in kind.sites]
    if not kind.is_molecule:
        return size_of(discs[0])
    # The discs of a molecule push at sigma, not at their rims.
    beyond = [size_of(disc) - 2.0 * float(disc.radius) for disc in discs]
    return 2.0 * kind.half_width + sum(beyond) / len(beyond)


def mean_size(sizes: Sequence[float], counts: Sequence[int]) -> float:
    """Mean over all particles [length], of kinds with these sizes; over the kinds where there are no particles."""
    total = sum(counts)
    if total == 0:
        return sum(sizes) / len(sizes)
    return sum(size * count for size, count in zip(sizes, counts, strict=True)) / total
