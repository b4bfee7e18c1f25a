"""Cells, classes of sizes, buckets, order in memory and looking: how events are found changes no bit of a run."""

from __future__ import annotations

import importlib

import numpy as np
import pytest
from gases import collisions, event_driven
from odd_gases import odd_gas
from test_every_dynamics import bits
from test_narrow_boxes import narrow_gas

from gasbox.kernels import event_driven as kernels

# The package exports the function of that name.
columns = importlib.import_module("gasbox.kernels.event_driven.tables")
TUNINGS = {
    "as it is": {},
    "wide cells": {"spacings": 3.0},
    "narrow cells": {"spacings": 0.1},
    "a grid for each size": {"ratio": 1.0},
    "one grid for all": {"ratio": 100.0},
    "wide buckets": {"rate": 1e-3},
    "narrow buckets": {"rate": 30.0},
    "one bucket": {"rate": 1e-30},
    "sorted all the time": {"sort_after": 0},
    "never sorted": {"sort_after": 10**9},
    "looked at and resumed": {"looks": 5},
}


def tune(patch: pytest.MonkeyPatch, ratio: float = 2.0, rate: float = 1.0, spacings: float = 0.7) -> None:
    """Make engines with other classes of sizes, buckets and cells from now on."""
    tables, rebuild = kernels.tables, kernels.rebuild
    patch.setattr(columns, "_SPACINGS", spacings)
    patch.setattr(kernels, "tables", lambda *arguments: tables(*arguments, ratio=ratio))
    patch.setattr(kernels, "rebuild", lambda *arguments: rebuild(*arguments[:-1], rate * arguments[-1]))


def run(state, geometry, sort_after: int = 32, looks: int = 0) -> tuple[str, int]:
    """The bits at the end, and how many collisions there were."""
    speed = np.sqrt((state.velocity**2).sum(axis=1).mean())
    begin, span = state.time, 3.0 * np.sqrt(geometry.area / state.count) / speed
    dynamics = event_driven(state, geometry)
    dynamics.sort_after = sort_after
    dynamics.resync(state)
    for part in np.sort(np.random.default_rng(1).uniform(0, span, looks)):
        dynamics.advance(state, begin + part)
        other = event_driven(state, geometry, memory=dynamics.memory())
        other.tallies, dynamics = dynamics.tallies, other
    dynamics.advance(state, begin + span)
    return bits(state, dynamics), collisions(dynamics)


@pytest.mark.parametrize(("make", "wanted"), [(odd_gas, 1000), (narrow_gas, 500)])
def test_no_tuning_changes_a_bit(make, wanted, monkeypatch):
    total = 0
    for seed in range(100, 130):
        found = {}
        for name, tuning in TUNINGS.items():
            own = {key: tuning[key] for key in tuning if key in ("sort_after", "looks")}
            with monkeypatch.context() as patch:
                tune(patch, **{key: tuning[key] for key in tuning if key not in own})
                found[name], executed = run(*make(seed), **own)
        assert {name for name in found if found[name] != found["as it is"]} == set()
        total += executed
    assert total > wanted
