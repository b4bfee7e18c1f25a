"""What people do about it, and where they go."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from gasbox.kernels import epidemic as kernels
from gasbox.rng import Stream
from gasbox.scenario import Epidemic, Places, Scenario, Walk
from gasbox.state import Memory, SetWalkers, State
from gasbox.worlds.epidemic.dials import Dials
from gasbox.worlds.epidemic.people import (
    DEAD,
    INFECTIOUS,
    NEVER,
    SUSCEPTIBLE,
    VACCINATED,
    Errand,
    Fate,
    People,
    drawn,
)

__all__ = ["Measures"]

Rows = NDArray[np.int64]
_TRIGGERED = ("distancing", "quarantine", "travel")


class Measures:
    """Distancing, quarantine, journeys, visits and vaccination, from one turn of the world to the next.

    Parameters
    ----------
    scenario : with an epidemic
    places : where people walk
    dials : the settings
    seed : (2,) int64, halves of the seed
    interval : time between two turns [time]
    """

    def __init__(
        self,
        scenario: Scenario,
        places: Places,
        dials: Dials,
        seed: NDArray[np.int64],
        interval: float,
    ) -> None:
        assert isinstance(scenario.world, Epidemic)
        self._day, self._interval = scenario.world.day, interval
        self._places, self._table, self._dials, self._seed = places, places.table, dials, seed
        walk = scenario.dynamics
        self._fast = walk.speed * walk.hurry if isinstance(walk, Walk) else math.inf
        self.active = dict.fromkeys(_TRIGGERED, False)
        """Whether each of them acts now; of travel, whether it is restricted."""
        self._kept = 0.0, 0.0
        self._keen: NDArray[np.float64] | None = None

    @property
    def _rooms(self) -> int:
        return int(self._places.rooms.shape[0])

    def rearm(self, name: str) -> None:
        """After a new value of a setting: what it triggers waits for its cases again."""
        for measure in _TRIGGERED:
            if name == f"{measure}_trigger":
                self.active[measure] = False

    def watch(self, cases: int) -> None:
        """Let begin what so many people with symptoms trigger."""
        for measure in _TRIGGERED:
            trigger = self._dials.get(f"{measure}_trigger")
            # Without a number of cases travel is never restricted, but the others act from the start.
            self.active[measure] |= cases >= trigger and (measure != "travel" or trigger > 0)

    def keep_apart(self, state: State) -> Iterator[SetWalkers]:
        """Let people keep their distance, or no longer; says something only when that changes."""
        strength = self._dials.get("distancing") if self.active["distancing"] else 0.0
        wanted = strength, self._dials.get("distancing_fraction") if strength else 0.0
        if wanted == self._kept:
            return
        self._kept = wanted
        if self._keen is None:
            self._keen = drawn(state.id, Stream.FATE, 0, self._seed)[:, Fate.KEEN]
        yield SetWalkers(state.id, distancing=np.where(self._keen < wanted[1], strength, 0.0))

    def come_back(self, people: People, state: State, turn: int) -> Iterator[SetWalkers]:
        """End journeys and visits whose time is over."""
        rows = np.flatnonzero(people.errand_until <= state.time)
        if not rows.size:
            return
        visiting = rows[people.errand[rows] == Errand.VISIT]
        people.zone[rows] = people.room[rows]
        people.errand[rows], people.errand_until[rows] = Errand.NONE, NEVER
        yield from self._send(state, visiting, people.room[visiting], Stream.VISIT, 2 * turn + 1)

    def isolate(self, people: People, state: State, turn: int) -> Iterator[SetWalkers]:
        """Keep those apart who are found."""
        rows = (
            np.flatnonzero(people.found_at <= state.time) if self.active["quarantine"] else np.empty(0, int)
        )
        if not rows.size:
            return
        people.found_at[rows] = NEVER
        rows = rows[people.stage[rows] == INFECTIOUS]
        people.free_until[rows] = state.time
        people.zone[rows] = -1
        people.errand[rows], people.errand_until[rows] = Errand.QUARANTINE, NEVER
        if self._places.quarantine is None:
            yield SetWalkers(state.id[rows], pace=np.zeros(rows.size))
        else:
            box = np.full(rows.size, self._table.shape[0] - 1)
            yield from self._send(state, rows, box, Stream.QUARANTINE, 2 * turn)

    def release(self, people: People, state: State, over: Rows, turn: int) -> Iterator[SetWalkers]:
        """Let those go home who have recovered in quarantine; let the dead lie."""
        dead = people.stage[over] == DEAD
        if dead.any():
            yield SetWalkers(state.id[over[dead]], pace=np.zeros(int(dead.sum())))
        rows = over[~dead & (people.errand[over] == Errand.QUARANTINE)]
        if not rows.size:
            return
        people.zone[rows], people.errand[rows] = people.room[rows], Errand.NONE
        if self._places.quarantine is None:
            yield SetWalkers(state.id[rows], pace=np.ones(rows.size))
        else:
            yield from self._send(state, rows, people.room[rows], Stream.QUARANTINE, 2 * turn + 1)

    def travel(self, people: People, state: State, turn: int) -> Iterator[SetWalkers]:
        """Send people to other rooms."""
        rate = self._dials.get("travel_restricted_to" if self.active["travel"] else "travel_rate")
        if rate == 0.0 or self._rooms == 1:
            return
        rows = self._chosen(people, state, rate, Stream.TRAVEL, 3 * turn)
        if not rows.size:
            return
        other = drawn(state.id[rows], Stream.TRAVEL, 3 * turn + 1, self._seed)[:, 0]
        people.room[rows] += 1 + (other * (self._rooms - 1)).astype(np.int64)
        people.room[rows] %= self._rooms
        people.zone[rows] = -1
        people.errand[rows] = Errand.TRAVEL
        for change in self._send(state, rows, people.room[rows], Stream.TRAVEL, 3 * turn + 2):
            people.errand_until[rows] = state.time + self._way(state, rows, change)
            yield change

    def visit(self, people: People, state: State, turn: int) -> Iterator[SetWalkers]:
        """Send people to the central place of their room."""
        rate = self._dials.get("central_visits")
        if rate == 0.0:
            return
        rows = self._chosen(people, state, rate, Stream.VISIT, -2 * turn - 1)
        if not rows.size:
            return
        people.errand[rows] = Errand.VISIT
        stay = self._dials["central_stay"] * self._day
        for change in self._send(state, rows, self._rooms + people.room[rows], Stream.VISIT, 2 * turn):
            people.errand_until[rows] = state.time + self._way(state, rows, change) + stay
            yield change

    def vaccinate(self, people: People, state: State, turn: int, share: float | None = None) -> Rows:
        """Vaccinate susceptible people, at the rate of the setting or a `share` of them; rows of the immune."""
        rate = self._dials.get("vaccination_per_day") * self._interval / self._day
        probability = -math.expm1(-rate) if share is None else share
        if probability == 0.0:
            return np.empty(0, np.int64)
        rows = self._picked(
            state.id, (people.stage == SUSCEPTIBLE) & ~people.asked, probability, Stream.VACCINATION, 2 * turn
        )
        people.asked[rows] = True
        success = drawn(state.id[rows], Stream.VACCINATION, 2 * turn + 1, self._seed)[:, 0]
        rows = rows[success < self._dials["vaccination_efficacy"]]
        people.stage[rows] = VACCINATED
        return rows

    def _chosen(self, people: People, state: State, rate: float, stream: Stream, turn: int) -> Rows:
        """Who sets out, of those who are about nothing, at this rate [1/day]."""
        may = (people.errand == Errand.NONE) & (people.stage != DEAD)
        return self._picked(state.id, may, -math.expm1(-rate * self._interval / self._day), stream, turn)

    def _picked(
        self, id: Rows, may: NDArray[np.bool_], probability: float, stream: Stream, turn: int
    ) -> Rows:
        out = np.empty(id.size, np.int64)
        return out[: kernels.pick(id, may, probability, int(stream), turn, self._seed, out)]

    def _send(self, state: State, rows: Rows, place: Rows, stream: Stream, turn: int) -> Iterator[SetWalkers]:
        """Send people to a point by chance in their new place (k,), a row of the table."""
        if rows.size:
            chance = drawn(state.id[rows], stream, turn, self._seed)[:, 2:]
            low, high = self._table[place, :2], self._table[place, 2:]
            yield SetWalkers(state.id[rows], place=place, target=low + chance * (high - low))

    def _way(self, state: State, rows: Rows, change: SetWalkers) -> NDArray[np.float64]:
        """How long it takes to the target [time]."""
        assert change.target is not None
        way = change.target - state.position[rows]
        return np.sqrt(way[:, 0] ** 2 + way[:, 1] ** 2) / self._fast

    def memory(self) -> Memory:
        """What is going on."""
        return {
            **{f"active_{name}": int(is_on) for name, is_on in self.active.items()},
            "kept_strength": self._kept[0],
            "kept_fraction": self._kept[1],
        }

    def recall(self, memory: Memory) -> None:
        """Go on from what `memory` gave."""
        self.active = {name: bool(memory[f"active_{name}"]) for name in _TRIGGERED}
        self._kept = float(memory["kept_strength"]), float(memory["kept_fraction"])
