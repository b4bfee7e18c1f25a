"""What the browser has to know of molecules once: where their discs stand, and which of these sticks join."""

from __future__ import annotations

from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.scenario import Kind, Scenario

__all__ = ["bodies", "sticks"]

_ALIKE: Final = 1.01
"""Atoms as near as this, times the longest stick that is needed, are joined as well: it closes rings ..."""
_EVEN: Final = 1.2
"""... but only where the sticks that are needed have the same length, up to this factor."""

Pair = tuple[int, int]


def bodies(scenario: Scenario) -> dict[str, Any]:
    """For the table: all kinds of disc, and of each kind of particle its discs; nothing for a gas without molecules."""
    if not scenario.molecules:
        return {}
    return {
        "discs": [{"radius": float(one.radius), "color": str(one.color)} for one in scenario.site_kinds],
        "bodies": [
            {
                "discs": list(kind.sites),
                "place": kind.place.tolist(),
                "sticks": sticks(kind),
                "flexible": kind.flexible,
                "turns": kind.inertia > 0.0,
            }
            for kind in scenario.kinds
        ],
    }


def sticks(kind: Kind) -> list[Pair]:
    """Pairs of atoms to be joined: the bonds, or where it lists none, neighbours."""
    if kind.bonds:
        return [bond.atoms for bond in kind.bonds]
    if len(kind.place) < 2 or kind.inertia == 0.0:
        return []
    apart = np.hypot(*(kind.place[:, None] - kind.place[None]).T)
    tree = _tree(apart)
    lengths = [apart[pair] for pair in tree]
    if max(lengths) > _EVEN * min(lengths):
        return sorted(tree)
    reach = _ALIKE * max(lengths)
    return [(a, b) for a in range(len(apart)) for b in range(a + 1, len(apart)) if apart[a, b] <= reach]


def _tree(apart: NDArray[np.float64]) -> list[Pair]:
    """The shortest sticks that hold all together (Prim), from the distances (n, n)."""
    near = apart[0].copy()
    inside = np.zeros(len(apart), bool)
    inside[0] = True
    partner = np.zeros(len(apart), np.int64)
    found: list[Pair] = []
    for _ in range(len(apart) - 1):
        new = int(np.argmin(np.where(inside, np.inf, near)))
        old = int(partner[new])
        found.append((min(old, new), max(old, new)))
        inside[new] = True
        closer = apart[new] < near
        near[closer], partner[closer] = apart[new][closer], new
    return found
