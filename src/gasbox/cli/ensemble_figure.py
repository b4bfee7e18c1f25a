"""Which numbers of an ensemble are drawn."""

from __future__ import annotations

from typing import Final

import numpy as np
from matplotlib.figure import Figure

from gasbox.cli.ensemble_epidemic import epidemic_figure
from gasbox.cli.ensemble_report import WORLD, headline, is_main
from gasbox.cli.ensemble_run import Outcome
from gasbox.cli.report import meaning
from gasbox.plots import Fan, Pile, ensemble_figure
from gasbox.scenario import Epidemic
from gasbox.sweep import Gathered, Plan

__all__ = ["figure_of"]

_COLORS: Final = ("#0b6bcb", "#c2410c", "#2e8b57", "#8a63d2")
_OF_GAS: Final[tuple[str, ...]] = (
    "temperature",
    "pressure",
    "pressure_virial",
    "collisions",
    "wall_collisions",
    "mean_free_path",
    "potential_energy",
    "energy",
    "particles",
)
"""What is drawn of a gas, in this order, if it differs from run to run."""
_MOST_PILES: Final = 6


def figure_of(plan: Plan, outcome: Outcome) -> Figure:
    """Of a world its series over time and its numbers; of a gas alone its temperature, pressure, collisions."""
    if isinstance(plan.scenario.world, Epidemic):
        return epidemic_figure(plan, outcome)
    found = outcome.found
    fans = [
        (name.replace("_", " "), [Fan(name.replace("_", " "), color, found.series[name])])
        for name, color in zip(found.series, _COLORS, strict=False)
    ]
    piles = [_pile(found, name) for name in _names(found)]
    return ensemble_figure(found.times, fans, piles, headline(plan, outcome))


def _names(found: Gathered) -> list[str]:
    """The most telling numbers: those of the world, if it has any that differ, otherwise those of the gas."""
    of_world = [name for name in found.values if name.startswith(WORLD) and _differs(found, name)]
    of_gas = [name for name in _OF_GAS if name in found.values and _differs(found, name)]
    others = [name for name in found.values if is_main(name)]
    return (of_world or of_gas or others[:1])[:_MOST_PILES]


def _differs(found: Gathered, name: str) -> bool:
    """Whether it has values that are not all the same, up to rounding."""
    known = found.values[name][np.isfinite(found.values[name])]
    return known.size > 1 and float(np.ptp(known)) > 1e-9 * float(np.max(np.abs(known)))


def _pile(found: Gathered, name: str) -> Pile:
    words, unit = meaning(name.removeprefix(WORLD))
    return Pile(words, unit, found.values[name])
