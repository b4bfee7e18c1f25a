"""An epidemic that needs no engine: people fly freely, and every so often some of them fall ill or recover."""

from __future__ import annotations

from typing import Any

import numpy as np
from free_flight import FreeFlight
from numpy.typing import NDArray

from gasbox.errors import UsageError
from gasbox.scenario import Scenario, parse
from gasbox.scenario.setting import Setting
from gasbox.state import Change, SetWorld

FRAME = 0.02
"""Days."""
STAGES = ("susceptible", "infectious", "recovered", "dead")
SETTINGS = {
    "probability_per_day": Setting("rate of infection within the radius", 0.0, 100.0, "1/day"),
    "radius": Setting("radius of infection", 1e-6, 1e6, "length"),
    "infectious_days": Setting("mean infectious time", 0.01, 1000.0, "day"),
    "hygiene": Setting("factor on the probability of infection", 0.0, 1.0),
    "distancing": Setting("how firmly people keep away from each other", 0.0, 20.0),
    "quarantine_probability": Setting("probability that one with symptoms is found", 0.0, 1.0),
    "travel_rate": Setting("journeys of one person", 0.0, 100.0, "1/day"),
}
"""As the page is to show them."""
AT_START = {
    "probability_per_day": 0.2,
    "radius": 3.0,
    "infectious_days": 5.0,
    "hygiene": 1.0,
    "distancing": 0.0,
    "quarantine_probability": 0.0,
    "travel_rate": 0.02,
}


class FakeEpidemic:
    """What a page reads of an epidemic: the same numbers whenever it is asked at the same time."""

    def __init__(self, simulation: People) -> None:
        self._simulation = simulation
        self.settings = dict(AT_START)
        self._rows: list[list[float]] = []
        self.move()

    def take(self, change: SetWorld) -> None:
        if change.name not in self.settings:
            raise UsageError(f"there is no setting {change.name}")
        self.settings[change.name] = float(change.value)

    def counts(self, day: float) -> dict[str, int]:
        people = self._simulation.state.count
        ill = 0.4 * self.settings["hygiene"] * np.exp(-(((day - 20.0) / 8.0) ** 2)) + (
            0.01 if day < 60 else 0.0
        )
        gone = 0.8 * self.settings["hygiene"] / (1.0 + np.exp(-(day - 24.0) / 5.0))
        infectious, dead = int(people * ill), int(0.02 * people * gone)
        recovered = max(min(int(people * gone) - dead, people - infectious - dead), 0)
        return {
            "susceptible": people - infectious - recovered - dead,
            "infectious": infectious,
            "recovered": recovered,
            "dead": dead,
        }

    def move(self) -> None:
        state, day = self._simulation.state, self._simulation.time
        counts = self.counts(day)
        order = np.random.default_rng(1).permutation(state.count)
        state.species[order] = np.repeat(np.arange(4), list(counts.values()))
        while 0.25 * len(self._rows) <= day:
            at = 0.25 * len(self._rows)
            self._rows.append([at, at, *self.counts(at).values(), 1.0, 2.5 * np.exp(-at / 30.0), 1.2])

    def series(self) -> dict[str, NDArray[np.float64]]:
        names = ("time", "day", *STAGES, "new_infections", "r", "r_cohort")
        columns = np.array(self._rows).T
        return dict(zip(names, columns, strict=True))

    def view(self) -> dict[str, Any]:
        state, day = self._simulation.state, self._simulation.time
        width, height = self._simulation.geometry.size.tolist()
        counts, rows = self.counts(day), np.array(self._rows)
        highest = int(np.argmax(rows[:, 3]))
        half = (width - 0.2 * width - 2.0) / 2.0
        rooms = [
            [x, y, x + half, y + height / 2.0 - 1.0]
            for y in (0.0, height / 2.0 + 1.0)
            for x in (0.0, half + 2.0)
        ]
        fresh = np.random.default_rng(int(20 * day)).random((12, 3))
        return {
            "day": day,
            "people": state.count,
            "counts": counts,
            "infected": counts["infectious"],
            "cases": counts["infectious"],
            "total_infected": state.count - counts["susceptible"],
            "new_per_day": 1.0,
            "r": 2.5 * float(np.exp(-day / 30.0)),
            "r_cohort": None,
            "r0": 2.5,
            "peak": {
                "infected": int(rows[highest, 3]),
                "fraction": float(rows[highest, 3]) / state.count,
                "day": float(rows[highest, 1]),
            },
            "over": counts["infectious"] == 0,
            "rooms": rooms,
            "quarantine": [0.82 * width, 0.6 * height, width, height],
            "central": [[10.0, 10.0, 20.0, 20.0]],
            "radius": self.settings["radius"],
            "rings": (fresh * [0.8 * width, height, 1.0]).tolist(),
            "active": {"distancing": False, "quarantine": day > 10.0, "travel": False},
            "settings": dict(self.settings),
        }


class People(FreeFlight):
    """A gas of people, with a fake epidemic among them."""

    def __init__(self, scenario: Scenario) -> None:
        super().__init__(scenario)
        self.world: Any = FakeEpidemic(self)

    def advance(self, *, until: float) -> None:
        super().advance(until=until)
        self.world.move()

    def apply(self, change: Change) -> None:
        if isinstance(change, SetWorld):
            self.world.take(change)
        super().apply(change)


def epidemic(people: int = 200, radius: float = 0.8, **settings: Any) -> Scenario:
    """A scenario with an epidemic."""
    colors = ("#3d8fd1", "#d1495b", "#8a8f98", "#5b4a72")
    return parse(
        {
            "format": "gasbox-scenario/1",
            "title": "An epidemic for tests",
            "watch_for": "The curve rises and falls.",
            "container": {"shape": "rectangle", "width": 200, "height": 120, "periodic": ["x", "y"]},
            "species": [
                {
                    "name": name,
                    "radius": radius,
                    "color": color,
                    "temperature": 1,
                    "count": people if name == "susceptible" else 0,
                }
                for name, color in zip(STAGES, colors, strict=True)
            ],
            "world": {"kind": "epidemic"},
            "dynamics": {"kind": "event-driven"},
            "frame_interval": FRAME,
            **settings,
        }
    )
