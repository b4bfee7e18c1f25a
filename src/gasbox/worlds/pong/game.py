"""The rules of pong: contacts in; where bats go and what becomes of the ball out."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gasbox.geometry import Enclosure, Geometry
from gasbox.rng import Stream, generator
from gasbox.state import ContactKind, Contacts, Memory, RemoveParticles, Reply, SetParticles, SetWorld, State
from gasbox.worlds.pong import notes, wishes
from gasbox.worlds.pong.player import SKILLS, choice
from gasbox.worlds.pong.score import NOBODY, OVER, PLAY, SERVE, Score
from gasbox.worlds.pong.spot import free_spot
from gasbox.worlds.pong.standing import Standing
from gasbox.worlds.pong.table import LEFT, RIGHT

__all__ = ["PongGame"]

_FLIGHTS = 10
"""From end to end, after which a ball that nobody hits is served again."""
_SLOWEST = 0.6
"""Of the speed of a serve: slower than that, the ball is driven on."""
_WIDEST = 0.6
"""Angle of a serve to the horizontal, at most [radian]."""
_ASTRAY = 0.5
"""Of its radius: a ball that was pushed so far from where it is held is put back there."""
_FIRM = 0.05
"""Of half the height of its bat: the computer does not mind less than that."""


class PongGame(Standing):
    """A game of pong.

    Parameters
    ----------
    scenario : whose world is a `Pong`
    """

    reads_contacts = True

    # -- the turns -------------------------------------------------------------------------------------

    def start(self, state: State, geometry: Geometry) -> Sequence[Reply]:
        """The ball is held, to be served."""
        self.met.ball = int(state.id[state.species == self.table.species][0])
        self.bricks = self.first_bricks = int((state.species == self.table.bricks).sum())
        self.score.enter(SERVE, state.time)
        return self._hold(state, self._row(state))

    def read(self, contacts: Contacts) -> None:
        """Keep in mind what the ball has met."""
        self.met.read(contacts)

    def act(self, state: State, geometry: Geometry) -> Sequence[Reply]:
        """Count what has happened, serve, and move the bats."""
        row = self._row(state)
        if row < 0:
            self.met.take()
            return []
        replies = self._bats(state, geometry, row)
        if self.asked["restart"] or (self.asked["serve"] and self.score.phase == OVER):
            self._restart(state.time)
        gone, hit, lost = self._count(state, row)
        if gone:
            replies.append(RemoveParticles(np.array(gone)))
        if self.score.phase == PLAY:
            replies += self._play(state, row, hit, lost)
        elif self.score.phase == SERVE and (
            self.asked["serve"] or state.time - self.score.since >= self.game.serve_delay
        ):
            replies += self._serve(state)
        else:
            replies += self._hold(state, row)
        self.asked = dict.fromkeys(self.asked, False)
        return replies

    def _row(self, state: State) -> int:
        """Where the ball stands in the state; -1 if it is there no longer."""
        row = int(np.searchsorted(state.id, self.met.ball))
        return row if row < state.count and state.id[row] == self.met.ball else -1

    def _count(self, state: State, row: int) -> tuple[list[int], bool, int]:
        """Bricks that are hit, whether a bat hit the ball last, and who has let it pass (NOBODY: none)."""
        score, walls = self.score, {side.wall: number for number, side in enumerate(self.table.sides)}
        goals = {side.goal: number for number, side in enumerate(self.table.sides)}
        playing = score.phase == PLAY
        gone: list[int] = []
        hit, lost = False, NOBODY
        for kind, other in self.met.take():
            if not playing or lost != NOBODY:
                break
            if kind == ContactKind.CROSSING:
                lost = goals.get(other, NOBODY)
            elif kind == ContactKind.WALL and other in walls:
                hit = True
                score.last = walls[other]
                score.touches, score.since = score.touches + 1, state.time
                score.hear("paddle")
            elif kind == ContactKind.WALL:
                score.hear("wall")
            elif self._is_brick(state, other) and other not in gone:
                gone.append(other)
                self._brick()
        if playing and lost == NOBODY:
            lost = self._beyond(float(state.position[row, 0]))
        return gone, hit, lost

    def _beyond(self, x: float) -> int:
        """Whose line the ball has passed, by its place."""
        for number, side in enumerate(self.table.sides):
            if (x < side.line) if number == LEFT else (x > side.line):
                return number
        return NOBODY

    def _is_brick(self, state: State, other: int) -> bool:
        row = int(np.searchsorted(state.id, other))
        found = row < state.count and state.id[row] == other
        return found and int(state.species[row]) == self.table.bricks

    def _brick(self) -> None:
        score = self.score
        score.hear("brick")
        self.bricks -= 1
        to = LEFT if len(self.bats) == 1 else score.last
        if to != NOBODY:
            score.points[to] += 1

    def _play(self, state: State, row: int, hit: bool, lost: int) -> list[Reply]:
        """Points, the end, and a ball that has become slow or that nobody hits."""
        score, time = self.score, state.time
        if lost != NOBODY:
            score.hear("goal")
            score.points[1 - lost] += 1
            score.to = lost
        if self.game.bricks is not None and self.first_bricks and self.bricks == 0:
            left, right = score.points
            alone = len(self.bats) == 1
            score.end(time, LEFT if alone or left > right else RIGHT if right > left else NOBODY)
        elif max(score.points[RIGHT:] if len(self.bats) == 1 else score.points) >= self.points:
            alone = len(self.bats) == 1
            score.end(time, RIGHT if alone or score.points[RIGHT] > score.points[LEFT] else LEFT)
        elif lost != NOBODY or time - score.since > self._patience():
            score.to = lost if lost != NOBODY else score.to
            score.enter(SERVE, time)
        if score.phase != PLAY:
            return self._hold(state, row)
        speed, least = math.hypot(*state.velocity[row]), self._least_speed(hit)
        if 0.0 < speed < least:
            return [self._set(velocity=state.velocity[row] * (least / speed))]
        return []

    def _least_speed(self, hit: bool) -> float:
        """Of the ball, just after a bat has hit it and otherwise."""
        if hit and self.game.keep_speed:
            return self.ball_speed
        least = self.game.least_speed
        return _SLOWEST * self.ball_speed if least is None else least

    def _patience(self) -> float:
        return self.game.patience or _FLIGHTS * self.table.width / self.ball_speed

    def _serve(self, state: State) -> list[Reply]:
        """Off it goes, towards the one who lost the point, at an angle that the lot decides."""
        score = self.score
        source = generator(self.seed, Stream.PONG, 4 * score.serves)
        angle, toss = float(source.uniform(-_WIDEST, _WIDEST)), float(source.random())
        to = score.to if score.to != NOBODY else LEFT if toss < 0.5 else RIGHT
        sign = -1.0 if to == LEFT or len(self.bats) == 1 else 1.0
        score.serves += 1
        score.touches += 1
        score.last = NOBODY
        score.enter(PLAY, state.time)
        way = self.ball_speed * np.array([sign * math.cos(angle), math.sin(angle)])
        return [self._set(velocity=way)]

    def _hold(self, state: State, row: int) -> list[Reply]:
        """The ball stays where it was put, in the middle, however the gas pushes it."""
        if np.hypot(*(state.position[row] - self.spot)) > _ASTRAY * self.table.radius:
            self.spot = free_spot(self.table, state, row)
            return [self._set(self.spot, np.zeros(2))]
        return [self._set(velocity=np.zeros(2))] if state.velocity[row].any() else []

    def _set(
        self, position: NDArray[np.float64] | None = None, velocity: NDArray[np.float64] | None = None
    ) -> SetParticles:
        place, way = (None if one is None else one.reshape(1, 2) for one in (position, velocity))
        return SetParticles(np.array([self.met.ball]), place, way)

    def _restart(self, time: float) -> None:
        self.score = Score(
            phase=SERVE,
            since=time,
            serves=self.score.serves,
            touches=self.score.touches,
            sounds=self.score.sounds,
        )
        self.first_bricks = self.bricks

    def _bats(self, state: State, geometry: Geometry, row: int) -> list[Reply]:
        """What each bat is to do now."""
        replies: list[Reply] = []
        moved = state.wall_displacement
        for number, bat in enumerate(self.bats):
            fastest = self.paddle_speed
            skill = SKILLS.get(self.players[number])
            if skill is not None:
                fastest *= skill.pace
                self._look(number, state, geometry, row)
            now = bat.side.start + (float(moved[bat.side.wall]) if moved.size else 0.0)
            order = bat.order(now, self.frame, fastest)
            if order is not None:
                replies.append(order)
        return replies

    def _look(self, number: int, state: State, geometry: Geometry, row: int) -> None:
        """The computer looks at the ball, if it is time to."""
        bat, skill = self.bats[number], SKILLS[self.players[number]]
        if state.time < self.looks[number]:
            return
        self.looks[number] = state.time + skill.pause * self.table.width / self.ball_speed
        (x, y), (vx, vy) = state.position[row].tolist(), state.velocity[row].tolist()
        pull = geometry.gravity[1] if isinstance(geometry, Enclosure) else 0.0
        draw = (self.seed, 4 * self.score.touches + 1 + number)
        found = choice(self.table, bat.side, skill, (x, y), (vx, vy), pull, draw)
        if found is not None:
            found = min(max(found, bat.side.low), bat.side.high)
            if math.isnan(bat.target) or abs(found - bat.target) > _FIRM * bat.side.half:
                bat.target = found

    # -- settings, what is remembered, and what is shown ------------------------------------------------

    def take(self, change: SetWorld) -> None:
        """Give a setting another value.

        Raises
        ------
        UsageError
            There is no such setting, or it cannot have this value.
        """
        wishes.take(self, change)

    def memory(self) -> Memory:
        """All that must be kept to go on with the same bits."""
        return notes.memory(self)

    def recall(self, memory: Memory) -> None:
        """Go on from what `memory` gave."""
        notes.recall(self, memory)

    def summary(self) -> dict[str, Any]:
        """What it came to so far."""
        return notes.summary(self)

    def series(self) -> dict[str, NDArray[np.float64]]:
        """Nothing is counted over time."""
        return {}

    def view(self) -> dict[str, Any]:
        """What a page shows."""
        return notes.view(self)
