"""What an epidemic knows of each person."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels import epidemic as kernels
from gasbox.kernels.epidemic.stages import (
    ASYMPTOMATIC,
    DEAD,
    EXPOSED,
    INFECTIOUS,
    RECOVERED,
    SUSCEPTIBLE,
    VACCINATED,
)
from gasbox.rng import Stream
from gasbox.state import Memory

__all__ = [
    "ASYMPTOMATIC",
    "DEAD",
    "EXPOSED",
    "INFECTIOUS",
    "NEVER",
    "RECOVERED",
    "SUSCEPTIBLE",
    "VACCINATED",
    "Errand",
    "Fate",
    "People",
    "drawn",
]

NEVER: Final = 1e300
"""A time that does not come [time]; finite, so that it can be saved."""


class Errand:
    """What somebody is about: nothing, a journey, a visit, quarantine."""

    NONE, TRAVEL, VISIT, QUARANTINE = range(4)


class Fate:
    """Columns of the four numbers that every person is born with."""

    SYMPTOMS, FOUND, DIES, KEEN = range(4)


@dataclass
class People:
    """One row for each person, in the order of the state.

    Attributes
    ----------
    stage : (n,) int8, as in `gasbox.kernels.epidemic.stages`
    infected_at : (n,) float64 [time]; -1 of those who never were
    onset : (n,) float64 [time], when they became infectious; -1 before
    until : (n,) float64 [time], end of the present stage, of those who are infected
    ended_at : (n,) float64 [time], when the infectious time was over; -1 before
    free_until : (n,) float64 [time], from when on they are kept apart
    found_at : (n,) float64 [time], when they will be found
    counted : (n,) float64 [time], up to which their infectious time was counted
    passed_on : (n,) int64, how many they have infected
    room : (n,) int64, in which they live
    zone : (n,) int64, the room in which they can meet others; -1 on a journey or in quarantine
    errand : (n,) int8
    errand_until : (n,) float64 [time]
    asked : (n,) bool, whether they have been vaccinated, with or without success
    """

    stage: NDArray[np.int8]
    infected_at: NDArray[np.float64]
    onset: NDArray[np.float64]
    until: NDArray[np.float64]
    ended_at: NDArray[np.float64]
    free_until: NDArray[np.float64]
    found_at: NDArray[np.float64]
    counted: NDArray[np.float64]
    passed_on: NDArray[np.int64]
    room: NDArray[np.int64]
    zone: NDArray[np.int64]
    errand: NDArray[np.int8]
    errand_until: NDArray[np.float64]
    asked: NDArray[np.bool_]

    @classmethod
    def healthy(cls, count: int) -> People:
        """All susceptible, in the first room."""
        return cls(
            stage=np.zeros(count, np.int8),
            infected_at=np.full(count, -1.0),
            onset=np.full(count, -1.0),
            until=np.full(count, NEVER),
            ended_at=np.full(count, -1.0),
            free_until=np.full(count, NEVER),
            found_at=np.full(count, NEVER),
            counted=np.zeros(count),
            passed_on=np.zeros(count, np.int64),
            room=np.zeros(count, np.int64),
            zone=np.zeros(count, np.int64),
            errand=np.zeros(count, np.int8),
            errand_until=np.full(count, NEVER),
            asked=np.zeros(count, np.bool_),
        )

    def memory(self) -> Memory:
        """All of it, by name."""
        return {
            entry.name: value.astype(np.int8) if value.dtype == np.bool_ else value.copy()
            for entry in fields(self)
            for value in [getattr(self, entry.name)]
        }

    @classmethod
    def recalled(cls, memory: Mapping[str, Any]) -> People:
        """From what `memory` gave."""
        count = np.asarray(memory["stage"]).size
        like = cls.healthy(count)
        return cls(
            *(
                np.array(memory[entry.name]).astype(getattr(like, entry.name).dtype).reshape(count)
                for entry in fields(cls)
            )
        )

    def counts(self) -> NDArray[np.int64]:
        """(7,) int64: how many are in each stage."""
        return np.bincount(self.stage, minlength=VACCINATED + 1)


def drawn(id: NDArray[np.int64], stream: Stream, turn: int, seed: NDArray[np.int64]) -> NDArray[np.float64]:
    """(k, 4) float64 in (0, 1): numbers of these people (k,) in a turn."""
    out = np.empty((id.size, 4))
    kernels.draws(id, int(stream), turn, seed, out)
    return out
