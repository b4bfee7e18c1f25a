"""An epidemic: a world on top of people who walk, or of hard discs that collide."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Geometry
from gasbox.scenario import STAGES, Epidemic, Scenario, places_of
from gasbox.state import Contacts, Memory, Reply, SetParticles, SetWorld, State
from gasbox.theory.epidemic import well_mixed_reproduction
from gasbox.worlds.epidemic.dials import Dials
from gasbox.worlds.epidemic.diary import Diary, infected
from gasbox.worlds.epidemic.disease import Disease
from gasbox.worlds.epidemic.measures import Measures
from gasbox.worlds.epidemic.people import ASYMPTOMATIC, DEAD, EXPOSED, INFECTIOUS, SUSCEPTIBLE, People

__all__ = ["Outbreak"]

Rows = NDArray[np.int64]
_LOOKS_A_DAY: Final = 100
"""Where neither the world nor its dynamics says."""
_ROWS_A_DAY: Final = 4
_RINGS: Final = 300
"""Most infections that the page shows."""
_MAJOR: Final = 0.1
"""Of the susceptible must be infected for a major outbreak."""


class Outbreak:
    """Who is infected by whom, and what people do about it.

    A turn: journeys and visits end; the exposed become infectious; who is found is kept apart; infections since the
    last turn; recovery and death; vaccination; new journeys and visits. What happened between two turns has its exact
    time: an infectious time counts in full, however long a turn is.

    Parameters
    ----------
    scenario : with an epidemic
    """

    def __init__(self, scenario: Scenario) -> None:
        assert isinstance(scenario.world, Epidemic)
        self._world = world = scenario.world
        step = getattr(scenario.dynamics, "time_step", world.day / _LOOKS_A_DAY)
        self.interval: float = world.interval or step
        self.reads_contacts = world.transmission.by == "contact"
        self._places = places_of(scenario)
        self._dials = Dials(scenario)
        self._disease = Disease(scenario, self._places, self._dials, self.interval)
        self._measures = Measures(scenario, self._places, self._dials, self._disease.seed, self.interval)
        self._diary = Diary(world.day, max(self.interval, world.day / _ROWS_A_DAY))
        names = [kind.name for kind in scenario.kinds]
        self._stages = tuple(name for name in STAGES if name in names)
        self._kind_of = np.array([names.index(name) if name in names else 0 for name in STAGES], np.int32)
        self._stage_of = np.array([STAGES.index(name) for name in names], np.int8)
        self._people = People.healthy(0)
        self._state: State | None = None
        self._turn = 0
        self._time = 0.0
        self._susceptible = 0
        """At the start, after vaccination."""

    def start(self, state: State, geometry: Geometry) -> Sequence[Reply]:
        """Called once: who is ill falls ill now; who is to be vaccinated has been."""
        people = self._people = People.healthy(state.count)
        people.stage[:] = self._stage_of[state.species]
        self._find_rooms(state)
        for stage in (EXPOSED, INFECTIOUS, ASYMPTOMATIC):
            self._seed(state, stage)
        before = self._world.vaccination.before
        immune = self._measures.vaccinate(people, state, 0, before) if before else np.empty(0, np.int64)
        self._susceptible = int((people.stage == SUSCEPTIBLE).sum())
        self._measures.watch(int((people.stage == INFECTIOUS).sum()))
        replies: list[Reply] = [*self._measures.keep_apart(state)]
        self._look(state)
        return [*self._changed(state, immune), *replies]

    def _find_rooms(self, state: State) -> None:
        for number, (left, lower, right, upper) in enumerate(self._places.rooms):
            x, y = state.position.T
            inside = (x >= left) & (x <= right) & (y >= lower) & (y <= upper)
            self._people.room[inside] = self._people.zone[inside] = number

    def _seed(self, state: State, stage: int) -> None:
        """Let the disease of those begin who start in this stage; they stay with or without symptoms, as they are."""
        people = self._people
        rows = np.flatnonzero((people.stage == stage) & (people.infected_at < 0.0))
        since = np.full(rows.size, state.time)
        if stage == EXPOSED:
            self._disease.begin(people, state.id, rows, since)
            return
        people.infected_at[rows] = since
        self._disease.onset(people, state.id, rows, since, stage)

    def read(self, contacts: Contacts) -> None:
        """Infect in collisions."""
        self._disease.read(contacts, self._people)

    def act(self, state: State, geometry: Geometry) -> Sequence[Reply]:
        """What follows now."""
        self._turn += 1
        people, disease, measures, turn = self._people, self._disease, self._measures, self._turn
        replies: list[Reply] = [*measures.come_back(people, state, turn)]
        ripe = disease.ripen(people, state)
        replies += measures.isolate(people, state, turn)
        fresh, over = disease.spread(people, state, turn)
        replies += measures.release(people, state, over, turn)
        immune = measures.vaccinate(people, state, turn)
        replies += measures.travel(people, state, turn)
        replies += measures.visit(people, state, turn)
        measures.watch(disease.cases)
        replies += measures.keep_apart(state)
        replies += self._changed(state, ripe, fresh, over, immune)
        self._look(state)
        return replies

    def _changed(self, state: State, *rows: Rows) -> Iterator[SetParticles]:
        """Another species for all whose stage has changed."""
        changed = np.unique(np.concatenate(rows))
        if changed.size:
            yield SetParticles(state.id[changed], species=self._kind_of[self._people.stage[changed]])

    def _look(self, state: State) -> None:
        self._state, self._time = state, state.time
        window = max(self._dials["infectious_days"], 1.0) * self._world.day
        self._diary.see(self._people, state.time, window)

    @property
    def done(self) -> bool:
        """Whether nothing more will happen: nobody is infected, and nobody is vaccinated any more."""
        return infected(self._people.counts()) == 0 and not self._dials.get("vaccination_per_day")

    def take(self, change: SetWorld) -> None:
        """Give a setting another value.

        Raises
        ------
        UsageError
            There is no such setting, or it cannot have this value.
        """
        self._dials.take(change)
        self._measures.rearm(change.name)

    def memory(self) -> Memory:
        """All that must be kept to go on with the same bits."""
        return {
            "turns": self._turn,
            "time": self._time,
            "susceptible": self._susceptible,
            **self._people.memory(),
            **self._dials.memory(),
            **self._disease.memory(),
            **self._measures.memory(),
            **self._diary.memory(),
        }

    def recall(self, memory: Memory) -> None:
        """Go on from what `memory` gave."""
        self._turn, self._time = int(memory["turns"]), float(memory["time"])
        self._susceptible = int(memory["susceptible"])
        self._people = People.recalled(memory)
        for part in (self._dials, self._disease, self._measures, self._diary):
            part.recall(memory)

    def _r0(self) -> float | None:
        """Of a well-mixed crowd, with the settings as they are."""
        if self.reads_contacts:
            return None
        dials, rooms = self._dials, self._places.rooms
        area = float(((rooms[:, 2] - rooms[:, 0]) * (rooms[:, 3] - rooms[:, 1])).sum())
        alive = self._people.stage.size - int((self._people.stage == DEAD).sum())
        mild = 1.0 - dials["symptomatic"]
        strength = dials["symptomatic"] + mild * dials["asymptomatic_infectiousness"]
        rate = dials["probability_per_day"] * dials["hygiene"] * strength
        return well_mixed_reproduction(rate, alive / area, dials["radius"], dials["infectious_days"])

    def summary(self) -> dict[str, Any]:
        """What it came to so far."""
        people, counts = self._people, self._people.counts()
        n, ever = people.stage.size, int((people.infected_at >= 0.0).sum())
        at_start = int((people.infected_at == 0.0).sum())
        attacked = (ever - at_start) / self._susceptible if self._susceptible else 0.0
        growth = self._diary.growth(n)
        ended = people.ended_at >= 0.0
        return {
            "days": self._time / self._world.day,
            "people": n,
            "counts": self._named(counts),
            "total": int(counts.sum()),
            "final_size": ever,
            "attack_rate": attacked,
            "peak_infected": self._diary.peak[0],
            "peak_fraction": self._diary.peak[0] / n if n else 0.0,
            "peak_day": self._diary.peak[1] / self._world.day,
            "over": infected(counts) == 0,
            "major": attacked > _MAJOR,
            "mean_passed_on": float(people.passed_on[ended].mean()) if ended.any() else None,
            "r0_estimate": self._r0_estimate(),
            "r0_well_mixed": self._r0(),
            "growth_per_day": growth,
            "doubling_days": math.log(2.0) / growth if growth is not None and growth > 0 else None,
        }

    def _r0_estimate(self) -> float | None:
        """Mean number infected by those who were infected while nine tenths of the susceptible still were so."""
        people = self._people
        since = np.sort(people.infected_at[people.infected_at >= 0.0])
        early = int(_MAJOR * self._susceptible)
        if not since.size:
            return None
        last = since[min(early, since.size - 1)]
        rows = (people.infected_at >= 0.0) & (people.infected_at <= last) & (people.ended_at >= 0.0)
        return float(people.passed_on[rows].mean()) if rows.any() else None

    def _named(self, counts: NDArray[np.int64]) -> dict[str, int]:
        return {name: int(counts[STAGES.index(name)]) for name in self._stages}

    def series(self) -> dict[str, NDArray[np.float64]]:
        """Time, day, the number in each stage, new infections a day, and two estimates of the reproduction number."""
        return self._diary.series(self._stages)

    def view(self) -> dict[str, Any]:
        """What a page shows beside the people."""
        counts, diary, day = self._people.counts(), self._diary, self._world.day
        n = self._people.stage.size
        visited = self._dials.get("central_visits") > 0.0
        return {
            "day": round(self._time / day, 4),
            "people": n,
            "counts": self._named(counts),
            "infected": infected(counts),
            "cases": int(counts[2]),
            "total_infected": int((self._people.infected_at >= 0.0).sum()),
            "new_per_day": _short(diary.latest("new_infections")),
            "r": _short(diary.latest("r")),
            "r_cohort": _short(diary.latest("r_cohort")),
            "r0": _short(self._r0()),
            "peak": {
                "infected": diary.peak[0],
                "fraction": _short(diary.peak[0] / n if n else 0.0),
                "day": _short(diary.peak[1] / day),
            },
            "over": infected(counts) == 0,
            "rooms": self._places.rooms.tolist(),
            "quarantine": None if self._places.quarantine is None else self._places.quarantine.tolist(),
            "central": self._places.central.tolist() if visited else [],
            "radius": None if self.reads_contacts else self._dials["radius"],
            "rings": self._rings(),
            "active": dict(self._measures.active),
            "settings": dict(self._dials.value),
        }

    def _rings(self) -> list[list[float]]:
        """Place [length] and age [day] of the latest infections of the last day, the latest first."""
        if self._state is None:
            return []
        born = self._people.infected_at
        rows = np.flatnonzero((born >= 0.0) & (born > self._time - self._world.day))
        rows = rows[np.argsort(-born[rows], kind="stable")][:_RINGS]
        age = (self._time - born[rows]) / self._world.day
        table = np.column_stack([self._state.position[rows], age])
        return [[float(f"{value:.4g}") for value in row] for row in table.tolist()]


def _short(value: float | None) -> float | None:
    return None if value is None else float(f"{value:.4g}")
