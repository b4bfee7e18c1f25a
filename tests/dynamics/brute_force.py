"""The slow twin of `twins.py`, compiled: every pair, every image, every wall before each event; for long runs."""

from __future__ import annotations

import math

import numba
import numpy as np

from gasbox.geometry import Rectangle
from gasbox.state import State

_compiled = numba.njit(cache=True, error_model="numpy")


class BruteForce:
    """No cells, no queue, nothing remembered from one event to the next but the references; epochs as documented.

    events : executed collisions as (time, 1 for a pair or 2 for a wall, lower id, other id or wall)
    """

    def __init__(self, state: State, geometry: Rectangle, epoch_length: float) -> None:
        self._size, self._periodic = geometry.size, geometry.periodic
        self._radius, self._mass = state.radius.copy(), state.mass.copy()
        self._length = epoch_length
        self._epoch = math.floor(state.time / epoch_length)
        self.x, self.v = state.position.copy(), state.velocity.copy()
        self._t = np.full(state.count, state.time - self._epoch * epoch_length)
        self.events: list[tuple[float, int, int, int]] = []

    def run(self, until: float) -> None:
        while True:
            start = self._epoch * self._length
            local = min(until - start, self._length)
            while True:
                time, kind, i, j = _step(
                    self.x, self.v, self._t, self._radius, self._mass, self._size, self._periodic, local
                )
                if kind == 0:
                    break
                if kind > 0:
                    self.events.append((start + time, kind, i, j))
            if until - start < self._length:
                return
            for i in range(self._t.size):
                _refer(self.x, self.v, self._t, self._size, self._periodic, i, self._length)
            self._t[:] = 0.0
            self._epoch += 1

    def position(self, time: float):
        x, t = self.x.copy(), self._t.copy()
        for i in range(t.size):
            _refer(x, self.v, t, self._size, self._periodic, i, time - self._epoch * self._length)
        return x


@_compiled
def _step(x, v, t, radius, mass, size, periodic, until):
    """Execute the earliest event, if it is not after `until`; kind 0 for none, -1 for a pair that rounding parts."""
    time, kind, i, j = _earliest(x, v, t, radius, size, periodic, until)
    if kind == 1 and not _collide(x, v, t, mass, size, periodic, i, j, time):
        kind = -1
    if kind == 2:
        _refer(x, v, t, size, periodic, i, time)
        axis = j // 2
        x[i, axis] = radius[i] if j % 2 == 0 else size[axis] - radius[i]
        v[i, axis] = -v[i, axis]
    return time, kind, i, j


@_compiled
def _earliest(x, v, t, radius, size, periodic, until):
    best, kind, first, second = until, 0, -1, -1
    n = radius.size
    # In the order of ids, so that of simultaneous events the first stays.
    for i in range(n):
        for j in range(i + 1, n):
            time = _meeting(x, v, t, radius, size, periodic, i, j, best)
            if time < best or (time == best and kind == 0):
                best, kind, first, second = time, 1, i, j
    for i in range(n):
        for wall in range(4):
            axis, low = wall // 2, wall % 2 == 0
            speed = v[i, axis]
            if periodic[axis] or (speed >= 0 if low else speed <= 0):
                continue
            goal = radius[i] if low else size[axis] - radius[i]
            time = t[i] + (goal - x[i, axis]) / speed
            if time < best or (time == best and kind == 0):
                best, kind, first, second = time, 2, i, wall
    return best, kind, first, second


@_compiled
def _images(d, v, size, periodic, sigma, begin, end):
    """First and last image that come within `sigma` in one direction, from time `begin` to time `end`."""
    if not periodic:
        return 0, 0
    low, high = min(d + v * begin, d + v * end), max(d + v * begin, d + v * end)
    return math.ceil((-sigma - high) / size - 1e-6), math.floor((sigma - low) / size + 1e-6)


@_compiled
def _near(d, v, sigma, duration):
    """Between which times, at the most, a difference is within `sigma` in one direction."""
    if v == 0.0:
        return 0.0, duration
    middle, half = -d / v, (sigma + 1e-6 * (sigma + abs(d))) / abs(v)
    return min(max(middle - half, 0.0), duration), min(max(middle + half, 0.0), duration)


@_compiled
def _meeting(x, v, t, radius, size, periodic, i, j, until):
    start = max(t[i], t[j])
    duration = max(until - start, 0.0)
    sigma = radius[i] + radius[j]
    sigma2 = sigma * sigma
    d_x = (x[i, 0] + v[i, 0] * (start - t[i])) - (x[j, 0] + v[j, 0] * (start - t[j]))
    d_y = (x[i, 1] + v[i, 1] * (start - t[i])) - (x[j, 1] + v[j, 1] * (start - t[j]))
    v_x, v_y = v[i, 0] - v[j, 0], v[i, 1] - v[j, 1]
    speed2 = v_x * v_x + v_y * v_y
    left, right = _images(d_x, v_x, size[0], periodic[0], sigma, 0.0, duration)
    best = math.inf
    for column in range(left, right + 1):
        dx = d_x + column * size[0]
        begin, end = _near(dx, v_x, sigma, duration)
        below, above = _images(d_y, v_y, size[1], periodic[1], sigma, begin, end)
        for row in range(below, above + 1):
            dy = d_y + row * size[1]
            b = dx * v_x + dy * v_y
            if b >= 0:
                continue
            c = dx * dx + dy * dy - sigma2
            cross = dx * v_y - dy * v_x
            inside = b * b if c <= 0 else sigma2 * speed2 - cross * cross
            if inside <= 1e-24 * speed2 * sigma2:
                continue
            best = min(best, start if c <= 0 else start + c / (math.sqrt(inside) - b))
    return best


@_compiled
def _refer(x, v, t, size, periodic, i, time):
    for axis in range(2):
        x[i, axis] += v[i, axis] * (time - t[i])
        if periodic[axis]:
            x[i, axis] -= math.floor(x[i, axis] / size[axis]) * size[axis]
    t[i] = time


@_compiled
def _collide(x, v, t, mass, size, periodic, i, j, time):
    _refer(x, v, t, size, periodic, i, time)
    _refer(x, v, t, size, periodic, j, time)
    dx, dy = x[i, 0] - x[j, 0], x[i, 1] - x[j, 1]
    if periodic[0]:
        dx -= size[0] * np.rint(dx / size[0])
    if periodic[1]:
        dy -= size[1] * np.rint(dy / size[1])
    approach = (v[i, 0] - v[j, 0]) * dx + (v[i, 1] - v[j, 1]) * dy
    if approach >= 0:
        return False
    along = approach / (dx * dx + dy * dy)
    total = mass[i] + mass[j]
    of_i, of_j = 2.0 * mass[j] / total * along, 2.0 * mass[i] / total * along
    v[i, 0] -= of_i * dx
    v[i, 1] -= of_i * dy
    v[j, 0] += of_j * dx
    v[j, 1] += of_j * dy
    return True
