"""Slow, readable twins of the two hard-disc engines: every pair, every time, no cells, no queue."""

from __future__ import annotations

import itertools
import math

import numpy as np

from gasbox.geometry import Rectangle
from gasbox.state import State


class SteppedTwin:
    """Drift; then all touching, approaching pairs in the order of ids; then the walls."""

    def __init__(self, state: State, geometry: Rectangle, time_step: float) -> None:
        self.state, self.geometry, self.time_step = state, geometry, time_step
        self.lingering = 0  # touching pairs that did not approach

    def step(self) -> None:
        s, g = self.state, self.geometry
        s.position = g.wrap(s.position + s.velocity * self.time_step)
        for i, j in itertools.combinations(range(s.count), 2):
            d = self._difference(i, j)
            reach = s.radius[i] + s.radius[j]
            if d @ d <= reach * reach:
                self._collide(i, j, d)
        for i in range(s.count):
            for axis in range(2):
                if g.periodic[axis]:
                    continue
                at_low = s.position[i, axis] <= s.radius[i] and s.velocity[i, axis] < 0
                at_high = s.position[i, axis] + s.radius[i] >= g.size[axis] and s.velocity[i, axis] > 0
                if at_low or at_high:
                    s.velocity[i, axis] *= -1

    def _difference(self, i: int, j: int):
        d = self.state.position[i] - self.state.position[j]
        for axis in range(2):
            if self.geometry.periodic[axis]:
                length = self.geometry.size[axis]
                if d[axis] > length / 2:
                    d[axis] -= length
                elif d[axis] < -length / 2:
                    d[axis] += length
        return d

    def _collide(self, i: int, j: int, d) -> None:
        s = self.state
        v = s.velocity[i] - s.velocity[j]
        approach = v[0] * d[0] + v[1] * d[1]
        if approach >= 0:
            self.lingering += 1
            return
        along = approach / (d[0] * d[0] + d[1] * d[1])
        total = s.mass[i] + s.mass[j]
        s.velocity[i] -= 2.0 * s.mass[j] / total * along * d
        s.velocity[j] += 2.0 * s.mass[i] / total * along * d


class EventDrivenTwin:
    """Before each event, look at every pair (every image) and every wall for the earliest; references as documented."""

    def __init__(self, state: State, geometry: Rectangle) -> None:
        self.geometry = geometry
        self.mass, self.radius = state.mass, state.radius
        self.x, self.v = state.position.copy(), state.velocity.copy()
        self.t = np.full(state.count, state.time)
        self.events: list[tuple[float, int, int, int]] = []

    def run(self, until: float) -> None:
        while True:
            event = min(self._candidates(), default=None)
            if event is None or event[0] > until:
                return
            self.events.append(event)
            time, kind, first, second = event
            if kind == 1:
                self._collide(first, second, time)
            else:
                self._bounce(first, second, time)

    def position(self, time: float):
        return self.geometry.wrap(self.x + self.v * (time - self.t)[:, None])

    def _candidates(self):
        n = self.mass.size
        for i, j in itertools.combinations(range(n), 2):
            time = self._pair_time(i, j)
            if time < math.inf:
                yield time, 1, i, j
        for i in range(n):
            for wall in range(4):
                axis, low = wall // 2, wall % 2 == 0
                v, r = self.v[i, axis], self.radius[i]
                if self.geometry.periodic[axis] or (v >= 0 if low else v <= 0):
                    continue
                goal = r if low else self.geometry.size[axis] - r
                yield float(self.t[i] + (goal - self.x[i, axis]) / v), 2, i, wall

    def _pair_time(self, i: int, j: int) -> float:
        start = max(self.t[i], self.t[j])
        d = (self.x[i] + self.v[i] * (start - self.t[i])) - (self.x[j] + self.v[j] * (start - self.t[j]))
        v = self.v[i] - self.v[j]
        sigma2 = (self.radius[i] + self.radius[j]) ** 2
        far = 4 if self.mass.size > 3 else 40  # two discs may fly round many times before they meet
        images = [range(-far, far + 1) if p else range(1) for p in self.geometry.periodic]
        best = math.inf
        for kx, ky in itertools.product(*images):
            dx, dy = d[0] + kx * self.geometry.width, d[1] + ky * self.geometry.height
            b = dx * v[0] + dy * v[1]
            if b >= 0:
                continue
            speed2 = v[0] * v[0] + v[1] * v[1]
            c = dx * dx + dy * dy - sigma2
            cross = dx * v[1] - dy * v[0]
            inside = b * b if c <= 0 else sigma2 * speed2 - cross * cross
            if inside <= 1e-24 * speed2 * sigma2:
                continue
            best = min(best, float(start if c <= 0 else start + c / (math.sqrt(inside) - b)))
        return best

    def _refer(self, i: int, time: float) -> None:
        self.x[i] = self.geometry.wrap((self.x[i] + self.v[i] * (time - self.t[i]))[None])[0]
        self.t[i] = time

    def _collide(self, i: int, j: int, time: float) -> None:
        self._refer(i, time)
        self._refer(j, time)
        d = self.x[i] - self.x[j]
        for axis in range(2):
            if self.geometry.periodic[axis]:
                length = self.geometry.size[axis]
                d[axis] -= length * np.rint(d[axis] / length)
        v = self.v[i] - self.v[j]
        approach = v[0] * d[0] + v[1] * d[1]
        if approach >= 0:
            return
        along = approach / (d[0] * d[0] + d[1] * d[1])
        total = self.mass[i] + self.mass[j]
        self.v[i] -= 2.0 * self.mass[j] / total * along * d
        self.v[j] += 2.0 * self.mass[i] / total * along * d

    def _bounce(self, i: int, wall: int, time: float) -> None:
        self._refer(i, time)
        axis, low = wall // 2, wall % 2 == 0
        self.x[i, axis] = self.radius[i] if low else self.geometry.size[axis] - self.radius[i]
        self.v[i, axis] = -self.v[i, axis]
