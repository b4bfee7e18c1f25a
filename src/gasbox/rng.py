"""Random numbers: counter-based generators, one named stream for each use.

All streams are keyed by (seed, stream), so that a new use of random numbers never disturbs an old one.
"""

from __future__ import annotations

from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

__all__ = ["Stream", "generator", "halves"]


class Stream(IntEnum):
    """Every use of random numbers, with a number that never changes."""

    POSITIONS = 1
    """Where discs are placed at the start."""
    VELOCITIES = 2
    """The velocities drawn at the start."""
    THERMAL_WALLS = 3
    """Velocities with which discs leave a thermal wall; drawn in `gasbox.kernels.hall.rebound`."""
    LANGEVIN = 4
    """Kicks of the Langevin thermostat; this and the next two are drawn in `gasbox.kernels.forced.bath`."""
    RESCALING = 5
    """Factors of stochastic velocity rescaling."""
    BAROSTAT = 6
    """Changes of the area by stochastic cell rescaling."""
    ROTATION = 7
    """The angular velocities drawn at the start."""
    ORIENTATIONS = 8
    """How molecules are turned at the start."""
    LANGEVIN_SPIN = 9
    """Kicks of the Langevin thermostat on rotation."""
    WALK_TURNS = 15
    """By how much walkers turn in a step; drawn in `gasbox.kernels.walk.advance`."""
    WALK_START = 16
    """Where walkers start who stand in no room, and in which direction."""
    PONG = 20
    """How balls are served, and how the computer errs."""
    INFECTION = 21
    """Who is infected in a step, and by whom; this and those up to 25 are drawn in `gasbox.kernels.epidemic`."""
    CONTACT = 22
    """Whether a collision infects."""
    EXPOSED_TIME = 23
    """How long one is exposed."""
    INFECTIOUS_TIME = 24
    """How long one is infectious."""
    FATE = 25
    """Who gets symptoms, is found, dies, keeps a distance."""
    TRAVEL = 26
    """Who travels, and where to."""
    VISIT = 27
    """Who visits a central place, and where one stands there."""
    VACCINATION = 28
    """Who is vaccinated, and with success."""
    QUARANTINE = 29
    """Where one stands in quarantine, and after it."""


def generator(seed: int, stream: Stream, index: int = 0) -> np.random.Generator:
    """The generator of one stream.

    Parameters
    ----------
    seed : the scenario's seed, 0 <= seed < 2**63
    stream : which use
    index : a sub-stream, for example the number of the species
    """
    key = np.array([seed, (int(stream) << 32) | index], dtype=np.uint64)
    return np.random.Generator(np.random.Philox(key=key))


def halves(seed: int) -> NDArray[np.int64]:
    """(2,) int64: the lower and the upper 32 bits of the scenario's seed, as kernels take it for a key."""
    return np.array([seed & 0xFFFFFFFF, seed >> 32], np.int64)
