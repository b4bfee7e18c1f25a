"""The course of an epidemic so far, as numbers and curves. Without any page."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.scenario import ScheduledChange
from gasbox.state import Change, SetWorld
from gasbox.theory.epidemic import final_size

__all__ = ["INFECTED", "STAGES", "Course", "Mark", "chosen", "marks"]

STAGES: Final = ("infectious", "asymptomatic", "exposed", "susceptible", "vaccinated", "recovered", "dead")
"""Names of species that are stages of the disease, in the order in which they are stacked, from below."""
INFECTED: Final = ("infectious", "asymptomatic", "exposed")
_CLOSE: Final = 1.0
"""Days within which changes of one setting count as one: a slider that is drawn makes many."""


@dataclass(frozen=True)
class Course:
    """What is known of a run at one moment.

    Attributes
    ----------
    day : since the start
    r : reproduction number now; None where it cannot be told
    peak, peak_day : most people infected at a time, and when [day]
    total : people who were ever infected, those of the start included
    dead : None if nobody can die
    attack : part of those susceptible at the start who were infected; None if nobody was
    r0 : of a well-mixed population with the present settings; None where it cannot be told
    days : (k,) float64 [day]
    share : (k,) float64, infected people over all people
    spread : (k,) float64, reproduction number; nan where it could not be told
    over : whether nobody is infected any more
    expected : part of those susceptible at the start who are infected in the end, were the people well mixed and the
        settings as they are now (`theory.epidemic.final_size`); None where it cannot be told
    """

    day: float
    people: int
    infected: int
    r: float | None
    peak: int
    peak_day: float
    total: int
    dead: int | None
    attack: float | None
    r0: float | None
    days: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    share: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    spread: NDArray[np.float64] = field(default_factory=lambda: np.zeros(0))
    over: bool = False
    expected: float | None = None

    @classmethod
    def of(cls, view: Mapping[str, Any], series: Mapping[str, NDArray[np.float64]]) -> Course:
        """From what the world shows, and what it has counted over time."""
        people, total = int(view["people"]), int(view["total_infected"])
        days = np.asarray(series.get("day", np.zeros(0)))
        infected = np.zeros(days.size)
        for name in INFECTED:
            infected = infected + series.get(name, 0.0)
        attack = expected = None
        if days.size and series["susceptible"][0] > 0:
            seeds, susceptible = float(infected[0]), float(series["susceptible"][0])
            attack = (total - seeds) / susceptible
            if view["r0"] is not None:
                share = susceptible / people
                expected = final_size(view["r0"], share, seeds / people) / share
        peak = view["peak"]
        return cls(
            day=float(view["day"]),
            people=people,
            infected=int(view["infected"]),
            r=view["r"],
            peak=int(peak["infected"]),
            peak_day=float(peak["day"]),
            total=total,
            dead=view["counts"].get("dead"),
            attack=attack,
            r0=view["r0"],
            days=days,
            share=infected / max(people, 1),
            spread=np.asarray(series.get("r", np.zeros(0))),
            over=bool(view["over"]),
            expected=expected,
        )


@dataclass(frozen=True)
class Mark:
    """A measure was changed, on this day."""

    day: float
    name: str
    value: float | str | bool


def marks(changes: Sequence[tuple[float, Change]], day: float) -> list[Mark]:
    """What was changed so far, live and by the schedule.

    Parameters
    ----------
    changes : when [time], and what
    day : length of one [time]
    """
    found: list[Mark] = []
    for time, change in changes:
        if not isinstance(change, SetWorld):
            continue
        mark = Mark(time / day, change.name, change.value)
        before = next((one for one in reversed(found) if one.name == mark.name), None)
        if before is not None and mark.day - before.day < _CLOSE:
            found.remove(before)
        found.append(mark)
    return found


def chosen(changes: Sequence[tuple[float, Change]], schedule: Sequence[ScheduledChange]) -> dict[str, float]:
    """Name -> value of the settings that were changed live, by no schedule; `changes` are (time, change)."""
    scheduled = [(entry.at, entry.change()) for entry in schedule]
    return {
        change.name: float(change.value)
        for time, change in changes
        if isinstance(change, SetWorld) and (time, change) not in scheduled
    }
