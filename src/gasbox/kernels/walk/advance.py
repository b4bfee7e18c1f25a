"""Steps of people who walk. Symbols: i person, x y position, v speed, dx dy way to the target."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel, inlined_kernel
from gasbox.kernels.walk.chance import words
from gasbox.kernels.walk.filing import file_people
from gasbox.kernels.walk.keep_apart import keep_apart
from gasbox.kernels.walk.tables import Files, Ground, Manner, Walkers
from gasbox.rng import Stream

__all__ = ["advance"]

_STREAM = int(Stream.WALK_TURNS)
_FASTEST = 2.0
"""Times the speed: nobody is pushed faster than that."""


@bare_kernel
def advance(
    people: Walkers,
    ground: Ground,
    files: Files,
    everyone: NDArray[np.int64],
    manner: Manner,
    apart: bool,
    start: int,
    stop: int,
) -> None:
    """Take the steps from number `start` to `stop`.

    everyone : (n,) int64, all rows in order; apart : whether anybody keeps a distance
    """
    for step in range(start, stop):
        if apart:
            file_people(people.position, everyone, files, ground)
            keep_apart(people, ground, files, manner.reach)
        _walk(people, ground, manner, apart, step)


@bare_kernel
def _walk(people: Walkers, ground: Ground, manner: Manner, apart: bool, step: int) -> None:
    """One step of all; each draws a word of its own of the random numbers of a group of four."""
    group = -1
    w0, w1, w2, w3 = 0, 0, 0, 0
    for i in range(people.id.shape[0]):
        if people.going[i] == 1:
            _go(people, manner, i)
            continue
        number = people.id[i]
        if number >> 2 != group:
            group = number >> 2
            w0, w1, w2, w3 = words(group, step, _STREAM, manner.seed)
        word = w0 if number & 3 == 0 else w1 if number & 3 == 1 else w2 if number & 3 == 2 else w3
        # A turn by twice the angle whose tangent this is: exact, without a sine.
        half = manner.swerve * ((word + 0.5) * (2.0 / 4294967296.0) - 1.0)
        scale = 1.0 / (1.0 + half * half)
        cosine, sine = (1.0 - half * half) * scale, 2.0 * half * scale
        x, y = people.heading[i, 0], people.heading[i, 1]
        people.heading[i, 0] = cosine * x - sine * y
        people.heading[i, 1] = sine * x + cosine * y
        _stride(people, ground, manner, apart, i)


@inlined_kernel
def _stride(people: Walkers, ground: Ground, manner: Manner, apart: bool, i: int) -> None:
    """Walk on, pushed away from those nearby, and turn round at the walls of the place."""
    v = manner.speed * people.pace[i]
    vx, vy = v * people.heading[i, 0], v * people.heading[i, 1]
    people.velocity[i, 0], people.velocity[i, 1] = vx, vy
    if apart and people.distancing[i] > 0.0:
        firm = v * people.distancing[i]
        vx += firm * people.push[i, 0]
        vy += firm * people.push[i, 1]
        fast = math.sqrt(vx * vx + vy * vy)
        if fast > _FASTEST * v:
            vx *= _FASTEST * v / fast
            vy *= _FASTEST * v / fast
    c = people.place[i]
    people.position[i, 0] = _inside(
        people,
        i,
        0,
        people.position[i, 0] + vx * manner.step,
        ground.places[c, 0],
        ground.places[c, 2],
        ground.period_x,
    )
    people.position[i, 1] = _inside(
        people,
        i,
        1,
        people.position[i, 1] + vy * manner.step,
        ground.places[c, 1],
        ground.places[c, 3],
        ground.period_y,
    )


@inlined_kernel
def _inside(people: Walkers, i: int, axis: int, x: float, low: float, high: float, period: float) -> float:
    """A coordinate after reflection at the ends of a place, or brought back by a period."""
    if period < math.inf:
        if x < 0.0:
            x += period
        if x >= period:
            x -= period
        return x if 0.0 <= x < period else 0.0
    if x < low:
        x = 2.0 * low - x
        people.heading[i, axis] = abs(people.heading[i, axis])
    elif x > high:
        x = 2.0 * high - x
        people.heading[i, axis] = -abs(people.heading[i, axis])
    return min(max(x, low), high)


@inlined_kernel
def _go(people: Walkers, manner: Manner, i: int) -> None:
    """Walk straight to the target, through whatever walls there are."""
    dx = people.target[i, 0] - people.position[i, 0]
    dy = people.target[i, 1] - people.position[i, 1]
    far = math.sqrt(dx * dx + dy * dy)
    fast = manner.speed * manner.hurry * people.pace[i]
    if far <= fast * manner.step:
        people.position[i, 0], people.position[i, 1] = people.target[i, 0], people.target[i, 1]
        people.going[i] = 0
        fast = manner.speed * people.pace[i]
    else:
        people.position[i, 0] += dx / far * fast * manner.step
        people.position[i, 1] += dy / far * fast * manner.step
    if far > 0.0:
        people.heading[i, 0], people.heading[i, 1] = dx / far, dy / far
    people.velocity[i, 0] = fast * people.heading[i, 0]
    people.velocity[i, 1] = fast * people.heading[i, 1]
