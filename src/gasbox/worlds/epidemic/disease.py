"""How the disease runs in a person, and from one to the next."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels import epidemic as kernels
from gasbox.kernels.walk import files, ground
from gasbox.rng import Stream, halves
from gasbox.scenario import Epidemic, Places, Scenario
from gasbox.state import ContactKind, Contacts, Memory, State
from gasbox.worlds.epidemic.dials import Dials
from gasbox.worlds.epidemic.people import (
    ASYMPTOMATIC,
    DEAD,
    EXPOSED,
    INFECTIOUS,
    RECOVERED,
    Fate,
    People,
    drawn,
)

__all__ = ["Disease"]

Rows = NDArray[np.int64]
_LAWS = ("fixed", "exponential", "gamma")


class Disease:
    """Infections, onsets and ends of the time between two turns of the world.

    Parameters
    ----------
    scenario : with an epidemic
    places : where people walk
    dials : the settings
    interval : time between two turns [time]
    """

    def __init__(self, scenario: Scenario, places: Places, dials: Dials, interval: float) -> None:
        assert isinstance(scenario.world, Epidemic)
        self._world = scenario.world
        self._dials, self._interval = dials, interval
        self._exposes = any(entry.name == "exposed" for entry in scenario.species)
        self.seed = halves(scenario.seed)
        geometry = scenario.geometry()
        self._ground = ground(places.table, geometry.size, geometry.periodic)
        self._radius = -1.0
        self._scratch: tuple[Rows, NDArray[np.float64], Rows] | None = None
        self._waiting: list[tuple[Rows, Rows, NDArray[np.float64]]] = []
        self.cases = 0
        """People with symptoms at the last look."""

    def begin(self, people: People, id: Rows, rows: Rows, since: NDArray[np.float64]) -> None:
        """Let the disease of `rows` begin at the times `since` [time]: exposed, or infectious at once."""
        people.infected_at[rows] = since
        if self._exposes:
            people.stage[rows] = EXPOSED
            people.until[rows] = since + self._times("exposed", id[rows])
        else:
            self.onset(people, id, rows, since)

    def onset(
        self,
        people: People,
        id: Rows,
        rows: Rows,
        since: NDArray[np.float64],
        stage: int | None = None,
    ) -> None:
        """Let the infectious time of `rows` begin at the times `since` [time]; in this stage, or by chance."""
        dials, day = self._dials, self._world.day
        fate = drawn(id[rows], Stream.FATE, 0, self.seed)
        symptoms = fate[:, Fate.SYMPTOMS] < dials["symptomatic"]
        if stage is not None:
            symptoms[:] = stage == INFECTIOUS
        people.stage[rows] = np.where(symptoms, INFECTIOUS, ASYMPTOMATIC)
        people.onset[rows] = people.counted[rows] = since
        people.until[rows] = since + self._times("infectious", id[rows])
        found = symptoms & (fate[:, Fate.FOUND] < dials.get("quarantine_probability"))
        people.found_at[rows[found]] = since[found] + dials.get("quarantine_delay") * day

    def _times(self, name: str, id: Rows) -> NDArray[np.float64]:
        section = self._world.exposed if name == "exposed" else self._world.infectious
        stream = Stream.EXPOSED_TIME if name == "exposed" else Stream.INFECTIOUS_TIME
        out = np.empty(id.size)
        mean = self._dials[f"{name}_days"] * self._world.day
        kernels.durations(id, _LAWS.index(section.law), mean, section.shape, int(stream), self.seed, out)
        return out

    def ripen(self, people: People, state: State) -> Rows:
        """Let the exposed whose time has come become infectious; their rows."""
        rows = np.flatnonzero((people.stage == EXPOSED) & (people.until <= state.time))
        self.onset(people, state.id, rows, people.until[rows])
        return rows

    def spread(self, people: People, state: State, turn: int) -> tuple[Rows, Rows]:
        """Infect, then end what is over; rows of those who were infected, and of those for whom it is over."""
        n = state.count
        if self._scratch is None:
            self._scratch = np.zeros(n, np.int64), np.zeros(n), np.zeros(n, np.int64)
        who, weight, over = self._scratch
        count = np.zeros(3, np.int64)
        weaker = self._dials["asymptomatic_infectiousness"]
        kernels.look(
            people.stage,
            people.until,
            people.free_until,
            people.counted,
            state.time,
            weaker,
            who,
            weight,
            over,
            count,
        )
        who, weight, over, self.cases = who[: count[0]], weight[: count[0]], over[: count[1]], int(count[2])
        if self._world.transmission.by == "contact":
            row, by, when = self._those_hit()
        else:
            row, by, when = self._those_near(people, state, who, weight, turn)
        np.add.at(people.passed_on, by, 1)
        self.begin(people, state.id, row, when)
        self._end(people, state, over)
        return row, over

    def _those_near(
        self, people: People, state: State, who: Rows, weight: NDArray[np.float64], turn: int
    ) -> tuple[Rows, Rows, NDArray[np.float64]]:
        dials, day, n = self._dials, self._world.day, state.count
        rate = dials["probability_per_day"] * dials["hygiene"] / day
        if not who.size or rate == 0.0:
            return np.empty(0, np.int64), np.empty(0, np.int64), np.empty(0)
        if dials["radius"] != self._radius:
            self._radius = dials["radius"]
            self._files = files(self._ground.size, self._radius, n)
            self._near = np.zeros(int(self._files.cells.prod()), np.uint8)
            self._burden = np.zeros(n)
            self._found = kernels.Found(np.zeros(n, np.int64), np.zeros(n, np.int64), np.zeros(n))
        self._burden[who] = weight
        crowd = kernels.Crowd(state.id, state.position, people.stage, people.zone, self._burden)
        count = kernels.infect(
            crowd,
            who,
            self._files,
            self._near,
            self._ground,
            self._radius,
            rate,
            turn,
            self.seed,
            self._found,
        )
        row, by = self._found.row[:count].copy(), self._found.by[:count].copy()
        return row, by, state.time - (1.0 - self._found.part[:count]) * self._interval

    def read(self, contacts: Contacts, people: People) -> None:
        """Infect in collisions; they show at the next turn."""
        pairs = np.flatnonzero(contacts.kind[: contacts.count] == ContactKind.PAIR)
        first, second, time = contacts.first[pairs], contacts.second[pairs], contacts.time[pairs]
        hit = np.zeros(people.stage.size, np.bool_)
        for rows, _, _ in self._waiting:
            hit[rows] = True
        row, by, when = np.empty(first.size, np.int64), np.empty(first.size, np.int64), np.empty(first.size)
        count = kernels.contacts(
            first,
            second,
            time,
            people.stage,
            people.until,
            hit,
            self._dials["probability"] * self._dials["hygiene"],
            self._dials["asymptomatic_infectiousness"],
            self.seed,
            row,
            by,
            when,
        )
        if count:
            self._waiting.append((row[:count], by[:count], when[:count]))

    def _those_hit(self) -> tuple[Rows, Rows, NDArray[np.float64]]:
        waiting, self._waiting = self._waiting, []
        if not waiting:
            return np.empty(0, np.int64), np.empty(0, np.int64), np.empty(0)
        row, by, when = (np.concatenate(column) for column in zip(*waiting, strict=True))
        return row, by, when

    def _end(self, people: People, state: State, rows: Rows) -> None:
        """Recovery, or death."""
        fate = drawn(state.id[rows], Stream.FATE, 0, self.seed)
        dies = (people.stage[rows] == INFECTIOUS) & (fate[:, Fate.DIES] < self._dials["fatality"])
        people.ended_at[rows] = people.until[rows]
        people.stage[rows] = np.where(dies, DEAD, RECOVERED)

    def memory(self) -> Memory:
        """Infections that do not show yet, and what the last look has found."""
        row, by, when = self._those_hit()
        if row.size:
            self._waiting.append((row, by, when))
        return {"hit": row, "hit_by": by, "hit_at": when, "cases": self.cases}

    def recall(self, memory: Memory) -> None:
        """Go on from what `memory` gave."""
        row, by = (np.asarray(memory[name], np.int64).ravel() for name in ("hit", "hit_by"))
        self._waiting = [(row, by, np.asarray(memory["hit_at"], np.float64).ravel())] if row.size else []
        self.cases = int(memory["cases"])
