"""People who walk about, step by step."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from gasbox.errors import UsageError
from gasbox.geometry import Geometry
from gasbox.kernels import walk as kernels
from gasbox.protocols import Status
from gasbox.rng import Stream, generator, halves
from gasbox.scenario import Scenario, places_of
from gasbox.scenario import Walk as WalkSection
from gasbox.state import Contacts, Memory, SetWalkers, State, Tallies

__all__ = ["Walk", "WalkSettings", "walk_settings"]

_PREFIX: Final = "walk_"
"""Before the names of what is remembered."""
_KEPT: Final = ("heading", "place", "going", "target", "distancing", "pace")
_HALVINGS: Final = 60


@dataclass(frozen=True)
class WalkSettings:
    """How people walk.

    Attributes
    ----------
    time_step : [time]
    speed : [length/time]
    turning : rate at which the direction is forgotten [1/time]
    hurry : so many times faster on the way to a target
    reach : within which others are avoided [length]
    places : (m, 4) float64 [length], boxes in which one can walk: left, lower, right and upper end
    rooms : so many of them, from the first on, are where people start
    """

    time_step: float
    speed: float
    turning: float
    hurry: float
    reach: float
    places: NDArray[np.float64]
    rooms: int


def walk_settings(scenario: Scenario) -> WalkSettings:
    """What a scenario with people who walk says of that."""
    walk, places = scenario.dynamics, places_of(scenario)
    assert isinstance(walk, WalkSection)
    return WalkSettings(
        walk.time_step,
        walk.speed,
        walk.turning,
        walk.hurry,
        walk.reach,
        places.table,
        places.rooms.shape[0],
    )


class Walk:
    """Points that walk at a steady speed, turn by chance, and turn round at the walls of their place.

    The mean of the cosine of the angle between directions a time t apart is exp(-turning t). Who keeps a distance is
    pushed away from those nearby; who has a target goes there straight. Time exists in whole steps only, as under the
    stepped rule.

    Parameters
    ----------
    state : the people; its arrays are changed in place
    geometry : a rectangle
    settings : how they walk
    tallies, contacts : stay as they are, for nobody collides
    memory : what `memory` gave, for going on from a snapshot
    seed : of the random numbers
    """

    def __init__(
        self,
        state: State,
        geometry: Geometry,
        settings: WalkSettings,
        tallies: Tallies,
        contacts: Contacts,
        memory: Memory | None = None,
        seed: int = 0,
    ) -> None:
        self.tallies = tallies
        self.contacts = contacts
        self.settings = settings
        self._ground = kernels.ground(settings.places, geometry.size, geometry.periodic)
        self._manner = kernels.Manner(
            settings.speed,
            settings.hurry,
            settings.reach,
            _swerve(settings.turning * settings.time_step),
            settings.time_step,
            halves(seed),
        )
        self._step = round(state.time / settings.time_step)
        self._id = state.id
        if memory is None:
            self._kept = self._begin(state, seed)
        else:
            self._step = int(memory[f"{_PREFIX}step"])
            self._kept = _recalled(memory)
            # Where the container has changed since, there may be fewer places.
            self._kept["place"] = np.clip(self._kept["place"], 0, settings.places.shape[0] - 1)
        self._take(state)

    def _begin(self, state: State, seed: int) -> dict[str, NDArray[Any]]:
        """Everybody in the room in which they stand, or in one by chance; who does not move yet looks anywhere."""
        n, random = state.count, generator(seed, Stream.WALK_START)
        angle, chosen, spot = (
            random.uniform(0, 2 * math.pi, n),
            random.uniform(size=n),
            random.uniform(size=(n, 2)),
        )
        low, high = (
            self.settings.places[: self.settings.rooms, :2],
            self.settings.places[: self.settings.rooms, 2:],
        )
        place = (chosen * self.settings.rooms).astype(np.int64)
        outside = np.ones(n, np.bool_)
        for room in range(self.settings.rooms):
            inside = ((state.position >= low[room]) & (state.position <= high[room])).all(axis=1)
            place[inside], outside = room, outside & ~inside
        put = low[place] + spot * (high - low)[place]
        state.position[outside] = put[outside]
        speed = np.hypot(*state.velocity.T)[:, None]
        heading = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        np.divide(state.velocity, speed, out=heading, where=speed > 0.0)
        state.velocity[:] = self.settings.speed * heading
        return {
            "heading": heading,
            "place": place,
            "going": np.zeros(n, np.int64),
            "target": np.zeros((n, 2)),
            "distancing": np.zeros(n),
            "pace": np.ones(n),
        }

    def _take(self, state: State) -> None:
        """Let the kernels work on the arrays of the state."""
        kept, n = self._kept, state.count
        self._id = state.id
        self._people = kernels.Walkers(
            state.id,
            state.position,
            state.velocity,
            kept["heading"],
            kept["place"],
            kept["going"],
            kept["target"],
            kept["distancing"],
            kept["pace"],
            np.zeros((n, 2)),
        )
        self._everyone = np.arange(n)
        self._files = kernels.files(self._ground.size, self.settings.reach, n)
        self._apart = bool(kept["distancing"].any())
        state.time = self._time

    @property
    def _time(self) -> float:
        return self._step * self.settings.time_step

    def resync(self, state: State) -> None:
        """Take over the people of `state`; of these, some may have left."""
        people = self._people
        if state.position is people.position and state.velocity is people.velocity and state.id is people.id:
            return
        if state.id is not self._id:
            rows = np.searchsorted(self._id, state.id)
            self._kept = {name: values[rows] for name, values in self._kept.items()}
        self._take(state)

    def alter(self, state: State, geometry: Geometry) -> None:
        """Refused: people walk between walls at rest.

        Raises
        ------
        UsageError
            Always.
        """
        raise UsageError("people who walk feel no gravity, and their walls stay as they are")

    def lead(self, state: State, change: SetWalkers) -> None:
        """Let some walk otherwise, from the time of the state on."""
        rows = np.searchsorted(state.id, change.ids)
        kept = self._kept
        if change.place is not None:
            kept["place"][rows] = change.place
        if change.target is not None:
            kept["target"][rows] = change.target
            kept["going"][rows] = 1
        if change.pace is not None:
            kept["pace"][rows] = change.pace
        if change.distancing is not None:
            kept["distancing"][rows] = change.distancing
            self._apart = bool(kept["distancing"].any())

    def advance(self, state: State, until: float) -> Status:
        """Take whole steps up to the last one at or before `until` [time]."""
        self.resync(state)
        target = max(math.floor(until / self.settings.time_step + 1e-9), self._step)
        kernels.advance(
            self._people,
            self._ground,
            self._files,
            self._everyone,
            self._manner,
            self._apart,
            self._step,
            target,
        )
        self._step = target
        state.time = self._time
        return Status.DONE

    def memory(self) -> Memory:
        """``walk_step``, and what is kept of each person: heading, place, going, target, distancing, pace."""
        return {
            f"{_PREFIX}step": self._step,
            **{f"{_PREFIX}{name}": self._kept[name].copy() for name in _KEPT},
        }


def _recalled(memory: Mapping[str, Any]) -> dict[str, NDArray[Any]]:
    whole = ("place", "going")
    return {
        name: np.array(memory[f"{_PREFIX}{name}"], np.int64 if name in whole else np.float64)
        for name in _KEPT
    }


def _swerve(forgotten: float) -> float:
    """Greatest tangent q of half the turn in a step, so that the mean cosine is exp(-forgotten).

    With the tangent spread evenly over [-q, q] the mean of (1 - tan²)/(1 + tan²) is 2 arctan(q)/q - 1.
    """
    low, high = 0.0, 2.4
    wanted = math.exp(-forgotten)
    if forgotten == 0.0:
        return 0.0
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if 2.0 * math.atan(middle) / middle - 1.0 > wanted else (low, middle)
    return 0.5 * (low + high)
