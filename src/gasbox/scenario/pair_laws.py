"""The law of force of each pair of species of a scenario."""

from __future__ import annotations

from gasbox.scenario.forces import Forces
from gasbox.scenario.mixing import PairLaw, laws_of
from gasbox.scenario.scenario import Scenario

__all__ = ["PairLaw", "pair_laws"]


def pair_laws(scenario: Scenario) -> dict[tuple[int, int], PairLaw]:
    """The law of each pair (a, b) of kinds of disc (`Scenario.site_kinds`), a <= b."""
    return laws_of(scenario.site_kinds, scenario.forces or Forces())
