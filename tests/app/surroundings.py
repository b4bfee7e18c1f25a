"""Scenarios with surroundings of every kind, and samples of them."""

from __future__ import annotations

from typing import Any

import numpy as np
from free_flight import FreeFlight, gas

from gasbox.app.sample import Sample
from gasbox.scenario import Scenario

BOX = {"shape": "rectangle", "width": 60, "height": 40}
DIVIDER = {"shape": "segment", "start": [30, 0], "end": [30, 40], "name": "divider"}


def walled(counts: tuple[int, ...] = (30, 20), **settings: Any) -> Scenario:
    """A gas in a box of 60 x 40 with walls."""
    return gas(counts, **{"container": BOX, **settings})


def matter(**settings: Any) -> Scenario:
    """Discs with forces in a periodic box of 60 x 40."""
    return gas((200,), **{"dynamics": {"kind": "forced", "time_step": 0.005}, **settings})


def sample(simulation: FreeFlight, version: int = 1) -> Sample:
    """As a session would copy it."""
    return Sample(
        version=version,
        scenario=simulation.scenario,
        geometry=simulation.geometry,
        time=simulation.time,
        frame=0,
        state=simulation.state.copy(),
        tallies=simulation.dynamics.tallies.copy(),
        playing=True,
        shown_fps=0.0,
        keeping_up=True,
        speed_reached=None,
        changes=tuple(simulation.changes),
        frame_interval=simulation.frame_interval,
    )


def placed(simulation: FreeFlight, positions: list[tuple[float, float]]) -> FreeFlight:
    """The same gas with its discs put to these places."""
    simulation.state.position = np.array(positions, np.float64)
    return simulation
