"""Infection of those whom one collides with. Symbols: k contact, i j people, t time."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gasbox.jit import bare_kernel
from gasbox.kernels.epidemic.stages import ASYMPTOMATIC, INFECTIOUS, SUSCEPTIBLE
from gasbox.kernels.hall.random import philox, time_words, uniform
from gasbox.rng import Stream

__all__ = ["contacts"]

_STREAM = int(Stream.CONTACT)
_WORD = 0xFFFFFFFF


@bare_kernel
def contacts(
    first: NDArray[np.int64],
    second: NDArray[np.int64],
    time: NDArray[np.float64],
    stage: NDArray[np.int8],
    until: NDArray[np.float64],
    hit: NDArray[np.bool_],
    probability: float,
    weaker: float,
    seed: NDArray[np.int64],
    row: NDArray[np.int64],
    by: NDArray[np.int64],
    when: NDArray[np.float64],
) -> int:
    """Infect in collisions between rows `first` and `second` (k,) at `time` (k,) [time], in their order.

    Parameters
    ----------
    stage, until : of all people (n,); the infectious infect until then [time]
    hit : (n,) bool, who was infected since the last look; written
    probability : of infection in a contact; `weaker` times as much by those without symptoms
    row, by, when : (k,) each, written: who was infected, by whom, and when [time]

    Returns
    -------
    How many.
    """
    count = 0
    for k in range(first.shape[0]):
        for turn in range(2):
            i = first[k] if turn == 0 else second[k]
            j = second[k] if turn == 0 else first[k]
            if stage[i] != SUSCEPTIBLE or hit[i] or (stage[j] != INFECTIOUS and stage[j] != ASYMPTOMATIC):
                continue
            if time[k] > until[j]:
                continue
            low, high = time_words(time[k])
            words = philox(i & _WORD, j & _WORD, low, high, seed[0] ^ _STREAM, seed[1])
            if uniform(words[0], words[1]) < probability * (weaker if stage[j] == ASYMPTOMATIC else 1.0):
                hit[i] = True
                row[count], by[count], when[count] = i, j, time[k]
                count += 1
    return count
