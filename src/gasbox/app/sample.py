"""What the page gets to see of a session: consistent copies, never the worker's own arrays."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from gasbox.app.molecule_numbers import Energies
from gasbox.geometry import Geometry
from gasbox.scenario import Scenario
from gasbox.state import Change, State, Tallies

__all__ = ["Bin", "Followed", "Quantity", "Sample"]

Quantity = Literal["speed", "energy", "angular-velocity", "rotational-energy"]
"""What a histogram's axis shows; speed and energy are those of the flight of a molecule."""


@dataclass(frozen=True)
class Sample:
    """One moment of the gas, copied between two advances, for charts and readouts.

    Attributes
    ----------
    version : increases with each load and reset; numbers of different versions must not be mixed
    scenario, geometry : what the gas was made from
    time : [time]
    frame : whole frames of simulated time since time 0
    state, tallies : independent copies; do not change them
    playing : whether the gas was running
    shown_fps : frames that the browser drew per second, lately; 0 if nothing was drawn
    keeping_up : whether the engine reaches the speed that was asked for
    speed_reached : frames of simulated time per second, lately, in units of 60; None before it was measured
    changes : what was changed so far, and when [time]
    frame_interval : of one frame [time]
    world : what there is to show of the world, as `protocols.World.view`; empty without one
    series : what it has counted over time, as `protocols.World.series`
    """

    version: int
    scenario: Scenario
    geometry: Geometry
    time: float
    frame: int
    state: State
    tallies: Tallies
    playing: bool
    shown_fps: float
    keeping_up: bool
    speed_reached: float | None
    warnings: tuple[str, ...] = ()
    changes: tuple[tuple[float, Change], ...] = ()
    frame_interval: float = 1.0
    world: dict[str, Any] = field(default_factory=dict)
    series: dict[str, NDArray[np.float64]] = field(default_factory=dict)


@dataclass(frozen=True)
class Bin:
    """The particles of one kind with ``low <= quantity < high``: the ones that light up."""

    species: int
    low: float
    high: float
    quantity: Quantity = "speed"


@dataclass(frozen=True)
class Followed:
    """The particle that is being followed, or pointed at.

    Attributes
    ----------
    species : index into the scenario's kinds
    position, velocity : of its centre of mass [length], [length/time]
    energies : what it has; None where they were not asked for
    """

    id: int
    species: int
    position: tuple[float, float]
    velocity: tuple[float, float]
    energies: Energies | None = None

    @property
    def speed(self) -> float:
        """Speed [length/time]."""
        return float((self.velocity[0] ** 2 + self.velocity[1] ** 2) ** 0.5)
