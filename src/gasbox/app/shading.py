"""What the colour of each disc says, as one byte; what takes long is found anew only as often as there is time."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Final

import numpy as np
from numpy.typing import NDArray

from gasbox import observe
from gasbox.app.look import REACH, Coloring, mean_size, sizes_of
from gasbox.state import State

if TYPE_CHECKING:
    from gasbox.simulation import Simulation

__all__ = ["MOST_NEIGHBOURS", "Shading", "of_speed"]

MOST_NEIGHBOURS: Final = 7
"""As many or more have the same colour."""
_SHARE: Final = 0.15
"""Of the time of the session's thread, at most."""
_LONGEST: Final = 0.2
"""Seconds that are counted of one computation: the first of all may have to load its kernels."""

Shades = NDArray[np.uint8]


class Shading:
    """Shades of a gas, from one frame to the next.

    Parameters
    ----------
    clock : in seconds
    """

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._reference = 0.0
        self.forget()

    def begin(self, simulation: Simulation) -> None:
        """Another gas; speeds are compared with those that it has now."""
        self._reference = observe.rms_speed(simulation.state) or 0.0
        self.forget()

    def forget(self) -> None:
        """Find everything anew."""
        self._kept: Shades | None = None
        self._key: tuple[Coloring, int] | None = None
        self._moment = float("nan")
        self._due = 0.0

    def of(self, simulation: Simulation, coloring: Coloring, *, exact: bool) -> Shades | None:
        """(n,) uint8, or None where discs have the colours of their species.

        Parameters
        ----------
        exact : whether shades of an earlier moment will not do, since no later frame will put them right
        """
        if coloring == "species":
            return None
        state = simulation.state
        key = (coloring, state.count)
        if key == self._key:
            waits = not exact and self._clock() < self._due
            if waits or state.time == self._moment:
                return self._kept
        begun = self._clock()
        self._kept = self._found_or_none(simulation, coloring)
        self._key, self._moment = key, state.time
        end = self._clock()
        self._due = end + min(end - begun, _LONGEST) / _SHARE
        return self._kept

    def _found_or_none(self, simulation: Simulation, coloring: Coloring) -> Shades | None:
        try:
            return self._found(simulation, coloring)
        except Exception as error:  # the gas goes on all the same, in the colours of its species
            logging.getLogger("gasbox").error("discs cannot be coloured by %s", coloring, exc_info=error)
            return None

    def _found(self, simulation: Simulation, coloring: Coloring) -> Shades:
        state = simulation.state
        if coloring == "speed":
            return of_speed(state, self._reference or observe.rms_speed(state) or 1.0)
        sizes = sizes_of(simulation.scenario)
        counts = np.bincount(state.species, minlength=len(sizes)).tolist()
        reach = REACH * mean_size(sizes, counts)
        geometry = simulation.geometry
        if coloring == "phase":
            return observe.phases(state, geometry, reach).astype(np.uint8)
        number = observe.coordination(state, geometry, reach)
        return np.minimum(number, MOST_NEIGHBOURS).astype(np.uint8)


def of_speed(state: State, reference: float) -> Shades:
    """(n,) uint8: from 0 at rest over 128 at the `reference` [length/time] to 255 for the very fastest."""
    square = np.einsum("ij,ij->i", state.velocity, state.velocity)
    shares: NDArray[np.float64] = square / (square + reference**2)
    return (255.0 * shares + 0.5).astype(np.uint8)
