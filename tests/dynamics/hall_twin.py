"""A slow twin of the event-driven engine in an enclosure: every pair, image and element before each event."""

from __future__ import annotations

import math

import numpy as np

from gasbox.geometry import Path
from gasbox.kernels.event_driven.flight import meeting_time
from gasbox.kernels.hall import hall, set_motion
from gasbox.kernels.hall.approach import PASS, touch
from gasbox.kernels.hall.motion import next_turn
from gasbox.kernels.hall.rebound import normal_at, rebound
from gasbox.kernels.hall.tables import KIND, OPEN, RHO, RIM, SIDE, UNTIL, WALL


class HallTwin:
    """No cells, no queue. One epoch only; walls may move along a path, swing, or be free.

    events : (time, 1 for a pair, 2 for an element, lower id, other id or element)
    """

    def __init__(self, state, place, seed):
        self.state, self.place = state, place
        self.hall = hall(place, 2, seed)
        for number, wall in enumerate(place.walls):
            if wall.motion is not None:
                push = self.hall.wall[number, 3]
                set_motion(self.hall.wall[number], self.hall.rule[number], wall.motion, 0.0, 0.0)
                self.hall.wall[number, 3] = push
        self.x, self.v = state.position.copy(), state.velocity.copy()
        self.t = np.zeros(state.count)
        self.g = np.array(place.gravity)
        self.events = []

    def at(self, i, time):
        """Position and velocity."""
        elapsed = time - self.t[i]
        half = 0.5 * elapsed * elapsed
        return self.x[i] + self.v[i] * elapsed + self.g * half, self.v[i] + self.g * elapsed

    def refer(self, i, time):
        x, v = self.at(i, time)
        for axis in range(2):
            if self.place.periodic[axis]:
                x[axis] -= math.floor(x[axis] / self.place.size[axis]) * self.place.size[axis]
        self.x[i], self.v[i], self.t[i] = x, v, time

    def images(self):
        wide = range(-2, 3) if self.place.periodic_x else [0]
        high = range(-2, 3) if self.place.periodic_y else [0]
        return [np.array([i, j]) * self.place.size for i in wide for j in high]

    def pair(self, i, j):
        start = max(self.t[i], self.t[j])
        (xi, vi), (xj, vj) = self.at(i, start), self.at(j, start)
        sigma = self.state.radius[i] + self.state.radius[j]
        dx, dv = xi - xj, vi - vj
        return min(meeting_time(*(dx - shift), *dv, sigma, start) for shift in self.images())

    def element(self, i, e, until):
        disc = (*self.x[i], *self.v[i], self.t[i], self.state.radius[i])
        found = [touch(self.hall, e, disc, self.state.species[i], *shift, until) for shift in self.images()]
        return min(found)

    def run(self, until, horizon):
        """Execute all events up to `until`; `horizon`: the end of the epoch, which searches know."""
        while True:
            best = (math.inf, 9, 0, 0, 0)
            for i in range(self.state.count):
                for j in range(i + 1, self.state.count):
                    best = min(best, (self.pair(i, j), 1, i, j, 0))
                for e in range(len(self.hall.kind)):
                    time, what = self.element(i, e, horizon)
                    best = min(best, (time, 2, i, 2 * e + what, 0))
            turn = next_turn(self.hall)
            if turn < best[0] and turn <= until:
                self.turn(turn)
                continue
            if best[0] > until:
                return
            self.execute(*best[:4])

    def turn(self, now):
        for number, wall in enumerate(self.place.walls):
            row = self.hall.wall[number]
            if isinstance(wall.motion, Path) and row[UNTIL] <= now:
                set_motion(row, self.hall.rule[number], wall.motion, row[UNTIL], 0.0)

    def execute(self, time, kind, i, other):
        self.events.append((time, kind, i, other))
        self.refer(i, time)
        if kind == 1:
            self.refer(other, time)
            self.collide(i, other)
            return
        e, what = other // 2, other % 2
        _, shift = min(
            ((self.off(i, e, what, time, s), tuple(s)) for s in self.images()), key=lambda one: one[0]
        )
        nx, ny, away = normal_at(self.hall, e, *self.x[i], *shift, time)
        reach = self.reach(i, e, what)
        way = away - reach if self.hall.kind[e, KIND] == RIM else reach - away
        self.x[i] += (way * nx, way * ny)
        if what == PASS:
            assert not self.hall.rule[self.hall.kind[e, WALL], OPEN]
            return
        result = np.zeros(6)
        args = (nx, ny, *self.v[i], self.state.mass[i], self.state.radius[i], i, time, 0.0, result)
        if rebound(self.hall, e, *args):
            self.v[i] = result[:2]

    def reach(self, i, e, what):
        r = self.state.radius[i]
        if what == PASS:
            return 0.0
        return self.hall.shape[e, RHO] - r if self.hall.kind[e, KIND] == RIM else r + self.hall.shape[e, RHO]

    def off(self, i, e, what, time, shift):
        away = normal_at(self.hall, e, *self.x[i], *shift, time)[2]
        if self.hall.kind[e, KIND] != SIDE:
            return abs(away - self.reach(i, e, what))
        px, py, tx, ty, _, _, low, high, _ = self.hall.shape[e]
        foot = (self.x[i, 0] - px - shift[0]) * tx + (self.x[i, 1] - py - shift[1]) * ty
        return abs(away - self.reach(i, e, what)) + max(low - foot, foot - high, 0.0)

    def collide(self, i, j):
        d = self.x[i] - self.x[j]
        for axis in range(2):
            if self.place.periodic[axis]:
                d[axis] -= self.place.size[axis] * np.rint(d[axis] / self.place.size[axis])
        w, m, n = self.v[i] - self.v[j], self.state.mass[i], self.state.mass[j]
        if w[0] * d[0] + w[1] * d[1] >= 0.0:
            return
        along = (w[0] * d[0] + w[1] * d[1]) / (d[0] * d[0] + d[1] * d[1])
        self.v[i] -= 2.0 * n / (m + n) * along * d
        self.v[j] += 2.0 * m / (m + n) * along * d
