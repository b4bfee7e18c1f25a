"""Which frames of a recording are read for a figure, and how observers get to see them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

import numpy as np

from gasbox import observe
from gasbox.protocols import Observer
from gasbox.recording import Recording

__all__ = ["MOST_FRAMES", "MOST_FRAMES_OF_PAIRS", "show", "spread"]

MOST_FRAMES: Final = 1000
"""Of a longer recording every so many frames are read."""
MOST_FRAMES_OF_PAIRS: Final = 60
"""Pairs take longer to count, and frames close together tell nothing new."""


def spread(first: int, frames: int, most: int) -> list[int]:
    """Numbers of at most so many frames from `first` on, evenly spread, with the last."""
    places = np.linspace(first, frames - 1, min(frames - first, most))
    return [int(number) for number in np.unique(places.round())]


def show(recording: Recording, observers: list[Observer], numbers: Iterable[int]) -> None:
    """Show frames to all observers, and tell them when the geometry changes."""
    changing = bool(recording.changes or recording.scenario.schedule)
    geometry = recording.geometry_at(0)
    for place, number in enumerate(numbers):
        frame = recording.read(number)
        here = recording.geometry_at(number) if changing else geometry
        for observer in observers:
            if place == 0:
                observer.start(frame.state, frame.tallies)
            if here != geometry and isinstance(observer, observe.FollowsChanges):
                observer.changed(frame.state, here)
            observer.observe(frame.state, frame.tallies)
        geometry = here
