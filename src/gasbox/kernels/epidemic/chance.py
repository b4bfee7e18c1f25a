"""Random numbers of people: keyed by seed, use, person and turn, so that no order matters. Symbols: i k rows."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel
from gasbox.kernels.forced.noise import gamma
from gasbox.kernels.hall.random import uniform
from gasbox.kernels.walk.chance import words

__all__ = ["EXPONENTIAL", "FIXED", "GAMMA", "draws", "durations", "pick"]

FIXED, EXPONENTIAL, GAMMA = 0, 1, 2
_SHARE = 1.0 / 4294967296.0


@bare_kernel
def draws(
    id: NDArray[np.int64], stream: int, turn: int, seed: NDArray[np.int64], out: NDArray[np.float64]
) -> None:
    """Write four independent numbers in (0, 1) for each person into `out` (k, 4)."""
    for k in range(id.shape[0]):
        drawn = words(id[k], turn, stream, seed)
        out[k, 0] = (drawn[0] + 0.5) * _SHARE
        out[k, 1] = (drawn[1] + 0.5) * _SHARE
        out[k, 2] = (drawn[2] + 0.5) * _SHARE
        out[k, 3] = (drawn[3] + 0.5) * _SHARE


@bare_kernel
def durations(
    id: NDArray[np.int64],
    law: int,
    mean: float,
    shape: float,
    stream: int,
    seed: NDArray[np.int64],
    out: NDArray[np.float64],
) -> None:
    """Write into `out` (k,) a time of this law and mean [time] for each person; one to a person and stream."""
    for k in range(id.shape[0]):
        if law == FIXED:
            out[k] = mean
        elif law == EXPONENTIAL:
            drawn = words(id[k], 0, stream, seed)
            out[k] = -mean * math.log(uniform(drawn[0], drawn[1]))
        else:
            out[k] = mean / shape * gamma(seed, stream, shape, id[k])


@bare_kernel
def pick(
    id: NDArray[np.int64],
    may: NDArray[np.bool_],
    probability: float,
    stream: int,
    turn: int,
    seed: NDArray[np.int64],
    out: NDArray[np.int64],
) -> int:
    """Write into `out` (n,) the rows of those who `may` (n,) and whom this probability picks; return how many.

    Four people whose ids differ in the last two bits alone share one draw, each a word of it.
    """
    found, group = 0, -1
    w0, w1, w2, w3 = 0, 0, 0, 0
    least = probability * 4294967296.0
    for i in range(id.shape[0]):
        if not may[i]:
            continue
        if id[i] >> 2 != group:
            group = id[i] >> 2
            w0, w1, w2, w3 = words(group, turn, stream, seed)
        last = id[i] & 3
        word = w0 if last == 0 else w1 if last == 1 else w2 if last == 2 else w3
        if word < least:
            out[found] = i
            found += 1
    return found
